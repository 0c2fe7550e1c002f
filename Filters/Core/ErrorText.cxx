// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ErrorText.h"

#include <algorithm>

namespace pemesh
{

std::string SentenceOfError(const char* text)
{
  std::string sentence = text ? text : "";
  if (const std::size_t start = sentence.find("): "); start != std::string::npos)
  {
    sentence.erase(0, start + 3);
  }
  sentence.erase(sentence.find_last_not_of(" \n") + 1);
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  return sentence;
}

} // namespace pemesh
