// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What Cairo writes as SVG, made smaller and the same every time. Private to this module.
 */
#ifndef pemesh_SvgText_h
#define pemesh_SvgText_h

#include <string>
#include <string_view>

namespace pemesh
{

/** Cairo numbers its ids through the life of the process: this numbers them through the file. */
std::string RenumberIds(std::string_view svg);

/**
 * The same picture in a third of the bytes: properties that have their initial values are left out,
 * colours are `#rrggbb`, transformations of strokes are said once, and coordinates have the digits
 * that Cairo computes with (1/256 of a point). Tags that are not understood stay as they are.
 */
std::string CompactSvg(std::string_view svg);

} // namespace pemesh

#endif
