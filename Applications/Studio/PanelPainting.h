// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Panels of the Charts module painted into a picture for the screen.
 */
#ifndef pemesh_PanelPainting_h
#define pemesh_PanelPainting_h

#include "PanelView.h"

namespace pemesh
{

struct PanelLayout
{
  QSizeF Size;
  double PixelRatio = 1.0;
  double FontSize = 12.0;
  int Columns = 0; ///< 0: as square as possible
};

/** Panels that cannot be drawn are left out, and the first reason told. */
PaintedPanels PaintPanels(
  const std::vector<vtkSmartPointer<vtkPEMPanel>>& panels, const PanelLayout& layout);

} // namespace pemesh

#endif
