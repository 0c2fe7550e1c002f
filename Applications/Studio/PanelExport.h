// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Panels to files.
 */
#ifndef pemesh_PanelExport_h
#define pemesh_PanelExport_h

#include "PanelScene.h"

#include <QString>

namespace pemesh
{

/**
 * Writes panels as a figure (.png, .svg, .pdf) or as the numbers that they show (.csv, a row a
 * mark; of meshes a row an element or vertex). Answers with a fault or "".
 */
QString WritePanels(
  const PanelList& panels, int columns, const ChartStyle& style, const QString& file);

} // namespace pemesh

#endif
