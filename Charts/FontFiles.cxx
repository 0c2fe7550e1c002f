// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FontFiles.h"

#include <fontconfig/fontconfig.h>

#include <map>
#include <mutex>
#include <utility>

namespace pemesh
{

namespace
{

std::string LookUp(const std::string& family, bool bold)
{
  FcPattern* pattern = FcPatternCreate();
  FcPatternAddString(pattern, FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  FcPatternAddInteger(pattern, FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_NORMAL);
  FcPatternAddBool(pattern, FC_OUTLINE, FcTrue);
  FcConfigSubstitute(nullptr, pattern, FcMatchPattern);
  FcDefaultSubstitute(pattern);
  FcResult result = FcResultNoMatch;
  FcPattern* match = FcFontMatch(nullptr, pattern, &result);
  FcChar8* file = nullptr;
  std::string path;
  if (match && FcPatternGetString(match, FC_FILE, 0, &file) == FcResultMatch)
  {
    path = reinterpret_cast<const char*>(file);
  }
  if (match)
  {
    FcPatternDestroy(match);
  }
  FcPatternDestroy(pattern);
  return path;
}

} // namespace

std::string FindFontFile(const std::string& family, bool bold)
{
  static std::mutex mutex;
  static std::map<std::pair<std::string, bool>, std::string> known;
  const std::scoped_lock lock(mutex);
  const auto [place, isNew] = known.emplace(std::pair(family, bold), std::string());
  if (isNew)
  {
    place->second = LookUp(family, bold);
  }
  return place->second;
}

} // namespace pemesh
