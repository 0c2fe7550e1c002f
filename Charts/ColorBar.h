// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The scale beside a picture that tells its colours. Private to this module.
 */
#ifndef pemesh_ColorBar_h
#define pemesh_ColorBar_h

#include "PanelPainter.h"

namespace pemesh
{

/** Width that DrawColorBar needs for a bar of this height, with a gap on its left. */
double ColorBarWidth(
  PanelPainter& painter, const ColorScale& scale, const std::string& title, double height);

/** Draws into the right part of `box`: the bar, its ticks to the right and its title, upright. */
void DrawColorBar(
  PanelPainter& painter, const ColorScale& scale, const std::string& title, const Box& box);

} // namespace pemesh

#endif
