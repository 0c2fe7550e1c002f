// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   PanelScene
 * @brief   The panels of a view, made and painted in a worker, changed and picked from the window.
 *
 * Panels are not safe to use from two threads: changes wait in a list until the worker paints, and
 * who picks while it paints finds nothing.
 */
#ifndef pemesh_PanelScene_h
#define pemesh_PanelScene_h

#include "ChartPick.h"
#include "ChartStyle.h"

#include <QImage>
#include <QRectF>
#include <QString>

#include <functional>
#include <mutex>
#include <vector>

#include <vtkSmartPointer.h>

class vtkPEMPanel;

namespace pemesh
{

using PanelList = std::vector<vtkSmartPointer<vtkPEMPanel>>;

/** How the panels are laid out. */
struct PanelLayout
{
  QSizeF Size;
  double PixelRatio = 1.0;
  double FontSize = 12.0;
  int Columns = 0; ///< 0: as square as possible
  ChartStyle Style;
};

/** Panels as they were painted; boxes in pixels of the view, y downwards. */
struct PaintedPanels
{
  std::vector<QRectF> Boxes;
  QImage Image;
  QString Fault; ///< of the first that could not be drawn
};

class PanelScene
{
public:
  using Maker = std::function<PanelList()>;
  /** A change of the panels: zooming, what stands out. */
  using Change = std::function<void(const PanelList& panels)>;

  explicit PanelScene(Maker maker);
  ~PanelScene();

  /** May be called from any thread. */
  void Add(Change change);

  /** In the worker: makes the panels the first time, applies what changed, paints. */
  PaintedPanels Paint(const PanelLayout& layout);

  /** Under a place of the view; nothing while the worker paints. */
  ChartPick Pick(int panel, const QPointF& position, double tolerance);
  std::vector<vtkIdType> SelectRectangle(int panel, const QRectF& box);

private:
  PaintedPanels PaintAll(const PanelLayout& layout);

  Maker Make;
  std::mutex ChangesMutex;
  std::vector<Change> Changes;
  std::mutex PanelsMutex;
  bool IsMade = false;
  PanelList Panels;
  QString Fault;
  double Height = 0.0; // of the view when it was painted
};

} // namespace pemesh

#endif
