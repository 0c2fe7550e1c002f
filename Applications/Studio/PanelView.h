// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   PanelView
 * @brief   Shows charts and mesh views of the Charts module, painted in a worker.
 *
 * What is seen is what is exported: one device paints both. The panels are made anew for every
 * painting, by a function that runs in the worker and may use only what does not change; painted
 * panels are kept to find what is under the mouse.
 */
#ifndef pemesh_PanelView_h
#define pemesh_PanelView_h

#include <QImage>
#include <QWidget>

#include <functional>
#include <memory>
#include <vector>

#include <vtkSmartPointer.h>

class vtkPEMPanel;

namespace pemesh
{

class LatestJob;

/** Panels and where they are in the view, in its pixels, y downwards. */
struct PaintedPanels
{
  std::vector<vtkSmartPointer<vtkPEMPanel>> Panels;
  std::vector<QRectF> Boxes;
  QImage Image;
  QString Fault;
};

class PanelView : public QWidget
{
  Q_OBJECT
public:
  using Maker = std::function<std::vector<vtkSmartPointer<vtkPEMPanel>>()>;

  explicit PanelView(QWidget* parent = nullptr);
  ~PanelView() override;

  /** Empty for none: the hint is shown. `columns` 0: as square as possible. */
  void SetMaker(Maker maker, int columns = 0);
  void SetHint(const QString& hint);
  /** Size of the text in pixels. */
  void SetFontSize(double size);

  const PaintedPanels& GetPainted() const { return this->Painted; }
  /** The panel at a place, or -1. */
  int FindPanel(const QPointF& position) const;

  ///@{
  /** Writes what is seen as PNG, SVG or PDF: all panels, or one. Answers with a fault or "". */
  QString Export(const QString& file, int panel = -1) const;
  /** Asks for a file first. */
  void ExportAs(int panel = -1);
  ///@}

  QSize minimumSizeHint() const override { return { 160, 120 }; }

signals:
  void Repainted();
  void Clicked(int panel, const QPointF& position);
  void DoubleClicked(int panel);

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  void Request();

  Maker MakePanels;
  int Columns = 0;
  double FontSize = 12.0;
  QString Hint;
  PaintedPanels Painted;
  LatestJob* PaintJob;
};

} // namespace pemesh

#endif
