// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Numbers as text: they round-trip and never depend on the locale.
 */
#ifndef pemesh_NumberText_h
#define pemesh_NumberText_h

#include "pemeshIOCoreModule.h" // For export macro

#include <optional>
#include <string>
#include <string_view>

namespace pemesh
{

/** The shortest text that reads back as the same double; "nan", "inf" and "-inf" as they are. */
PEMESHIOCORE_EXPORT std::string FormatNumber(double value);

/** Appends the same to `text`: for long files. */
PEMESHIOCORE_EXPORT void AppendNumber(std::string& text, double value);
PEMESHIOCORE_EXPORT void AppendNumber(std::string& text, long long value);

///@{
/** The whole of `text` (blanks around it aside) as a number, or nothing. "nan" and "inf" are
 * numbers. */
PEMESHIOCORE_EXPORT std::optional<double> ParseNumber(std::string_view text);
PEMESHIOCORE_EXPORT std::optional<long long> ParseInteger(std::string_view text);
///@}

/** "1 mesh", "2 meshes". */
PEMESHIOCORE_EXPORT std::string FormatCount(long long count, const char* one, const char* many);

/** For error messages: the candidate with the smallest edit distance to `word`, or "" if none. */
template <typename Range>
std::string NearestWord(std::string_view word, const Range& candidates);

/** Levenshtein distance. */
PEMESHIOCORE_EXPORT int EditDistance(std::string_view a, std::string_view b);

template <typename Range>
std::string NearestWord(std::string_view word, const Range& candidates)
{
  std::string nearest;
  int best = 1 << 30;
  for (const auto& candidate : candidates)
  {
    const int distance = EditDistance(word, candidate);
    if (distance < best)
    {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

} // namespace pemesh

#endif
