// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FontFiles.h"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace pemesh
{

namespace
{

/** What fontconfig, and therefore Cairo, takes for a family. */
struct FontMatch
{
  std::string File;
  std::vector<std::string> Families; // the names of the font
};

FontMatch LookUp(const std::string& family, bool bold)
{
  FcPattern* pattern = FcPatternCreate();
  FcPatternAddString(pattern, FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  FcPatternAddInteger(pattern, FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_NORMAL);
  FcPatternAddBool(pattern, FC_OUTLINE, FcTrue);
  FcConfigSubstitute(nullptr, pattern, FcMatchPattern);
  FcDefaultSubstitute(pattern);
  FcResult result = FcResultNoMatch;
  FontMatch match;
  if (FcPattern* found = FcFontMatch(nullptr, pattern, &result))
  {
    FcChar8* text = nullptr;
    if (FcPatternGetString(found, FC_FILE, 0, &text) == FcResultMatch)
    {
      match.File = reinterpret_cast<const char*>(text);
    }
    for (int i = 0; FcPatternGetString(found, FC_FAMILY, i, &text) == FcResultMatch; ++i)
    {
      match.Families.emplace_back(reinterpret_cast<const char*>(text));
    }
    FcPatternDestroy(found);
  }
  FcPatternDestroy(pattern);
  return match;
}

/** Looked up once for every family. */
const FontMatch& Find(const std::string& family, bool bold)
{
  static std::mutex mutex;
  static std::map<std::pair<std::string, bool>, FontMatch> known;
  const std::scoped_lock lock(mutex);
  const auto [place, isNew] = known.emplace(std::pair(family, bold), FontMatch());
  if (isNew)
  {
    place->second = LookUp(family, bold);
  }
  return place->second;
}

bool IsSameName(const std::string& a, const std::string& b)
{
  return FcStrCmpIgnoreCase(reinterpret_cast<const FcChar8*>(a.c_str()),
           reinterpret_cast<const FcChar8*>(b.c_str())) == 0;
}

} // namespace

std::string FindFontFile(const std::string& family, bool bold)
{
  return Find(family, bold).File;
}

std::string WhyOtherFont(const std::string& family)
{
  constexpr std::array generic{ "sans", "sans-serif", "serif", "monospace", "mono", "cursive",
    "fantasy", "system-ui" };
  const std::vector<std::string>& families = Find(family, false).Families;
  const auto isFamily = [&family](const std::string& name) { return IsSameName(name, family); };
  if (std::any_of(families.begin(), families.end(), isFamily) ||
    std::any_of(generic.begin(), generic.end(), isFamily))
  {
    return {};
  }
  return "The font \"" + family + "\" is not installed" +
    (families.empty() ? ": no text can be drawn"
                      : ", so that text is drawn in \"" + families.front() + "\"") +
    ": install it, or choose another font-family.";
}

} // namespace pemesh
