// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   PanelView
 * @brief   Shows charts and mesh views of the Charts module, painted in a worker.
 *
 * What is seen is what is exported: one device paints both. The panels are made by a function that
 * runs in the worker and may use only what does not change.
 *
 * Under the mouse: what a mark is. Wheel: zoom. Middle button or Shift and the left one: move. Left
 * button: a click picks, a drag selects the rows in a rectangle. Right button or the menu key:
 * export. Keys: + and - zoom, Home shows all.
 */
#ifndef pemesh_PanelView_h
#define pemesh_PanelView_h

#include "PanelScene.h"

#include <QWidget>

#include <memory>

class QRubberBand;

namespace pemesh
{

class LatestJob;

class PanelView : public QWidget
{
  Q_OBJECT
public:
  using Maker = PanelScene::Maker;

  explicit PanelView(QWidget* parent = nullptr);
  ~PanelView() override;

  /** Empty for none: the hint is shown. `columns` 0: as square as possible. */
  void SetMaker(Maker maker, int columns = 0);
  void SetHint(const QString& hint);
  /** Size of the text in pixels. */
  void SetFontSize(double size);
  /** Whether what is zoomed and moved in one panel is so in all. */
  void SetLinked(bool linked) { this->Linked = linked; }
  /** Rows (elements of mesh views) that stand out in every panel. */
  void SetHighlightedRows(const std::vector<vtkIdType>& rows);
  const std::vector<vtkIdType>& GetHighlightedRows() const { return this->Highlighted; }
  void ResetView();
  /** Paints anew, say after the style has changed. */
  void Refresh() { this->Request(); }

  const PaintedPanels& GetPainted() const { return this->Painted; }
  int GetNumberOfPanels() const { return static_cast<int>(this->Painted.Boxes.size()); }
  /** The panel at a place, or -1. */
  int FindPanel(const QPointF& position) const;
  bool IsBusy() const;

  ///@{
  /** Writes all panels, or one, as PNG, SVG, PDF or, their numbers, as CSV. A fault or "". */
  QString Export(const QString& file, int panel = -1) const;
  /** Asks for a file first, and writes it in a worker. */
  void ExportAs(int panel = -1);
  ///@}

  QSize minimumSizeHint() const override { return { 160, 120 }; }

signals:
  void Repainted();
  /** A mark was clicked, or nothing. */
  void Picked(int panel, const pemesh::ChartPick& pick);
  void RowsSelected(int panel, const std::vector<vtkIdType>& rows);
  void DoubleClicked(int panel);
  void EscapePressed();

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  void Request();
  std::function<QString()> MakeExport(const QString& file, int panel) const;
  /** A change of the panel at a place, or of all at the same place in each. */
  void Change(const QPointF& position,
    const std::function<void(vtkPEMPanel* panel, double x, double y)>& change);

  std::shared_ptr<PanelScene> Scene;
  Maker MakePanels;
  int Columns = 0;
  double FontSize = 12.0;
  bool Linked = false;
  std::vector<vtkIdType> Highlighted;
  QString Hint;
  PaintedPanels Painted;
  LatestJob* PaintJob;
  LatestJob* ExportJob;
  QRubberBand* Band;
  QPointF PressedAt;
  QPointF LastAt;
  bool IsMoving = false;
  bool IsPressed = false;
};

} // namespace pemesh

#endif
