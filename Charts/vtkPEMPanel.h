// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMPanel
 * @brief   One rectangle of a figure: what charts and mesh views have in common.
 *
 * A panel is a context item that fills its rectangle and takes every length (line widths, marker
 * sizes, margins) from its font size, so that the same panel reads well at any resolution: in a
 * figure of vtkPEMFigure, or in a window, where the font size is the device's.
 *
 * Interaction, for windows: a panel knows what it drew where. Coordinates of the device are those
 * of its rectangle and of the last painting, so it must have been painted once. Whatever changes
 * what is seen sends ModifiedEvent (and marks the scene, if the panel is in one, as dirty): a
 * window observes that and paints again. Nothing here knows of windows or events.
 *
 * - Linked selection: what SelectRectangle or Pick of one panel gives is set with
 *   SetHighlightedRows on all panels over the same table.
 * - Zoom and pan change only what is seen: neither the limits that were set nor what a figure
 *   file would show after ResetView.
 *
 * @sa vtkPEMChart vtkPEMMeshView vtkPEMFigure
 */
#ifndef vtkPEMPanel_h
#define vtkPEMPanel_h

#include "pemeshChartsModule.h" // For export macro

#include "ChartPick.h"
#include "ChartStyle.h"

#include <vtkContextItem.h>

#include <memory> // For the style
#include <string> // For titles
#include <vector> // For rows

class PEMESHCHARTS_EXPORT vtkPEMPanel : public vtkContextItem
{
public:
  vtkTypeMacro(vtkPEMPanel, vtkContextItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Title above the panel, UTF-8. Empty by default: no title. */
  void SetTitle(const std::string& title);
  std::string GetTitle() const;
  ///@}

  ///@{
  /** Lower left corner and size, in the units of the device, y upwards. Default 0, 0, 400, 300. */
  void SetRectangle(double x, double y, double width, double height);
  vtkGetVector4Macro(Rectangle, double);
  ///@}

  ///@{
  /** Size of the text, in the units of the device, from 1 to 10000. Default 12. */
  void SetFontSize(double size);
  vtkGetMacro(FontSize, double);
  ///@}

  /**
   * Empty if the panel can be drawn, else one sentence that says why not: no data, a column or an
   * array that does not exist (and the nearest one that does).
   */
  virtual std::string WhyNotDrawable() = 0;

  ///@{
  /** How the panel looks. A figure gives its own style to all of its panels. */
  void SetStyle(const pemesh::ChartStyle& style);
  const pemesh::ChartStyle& GetStyle() const;
  /** Sets one member by its name; answers with one sentence if that is not possible, else "". */
  std::string SetStyleByName(const std::string& name, const std::string& value);
  ///@}

  ///@{
  /**
   * Rows of the table (cells of the mesh) that stand out. Kept sorted and without repetition; rows
   * that do not exist do no harm. Default none.
   */
  void SetHighlightedRows(const std::vector<vtkIdType>& rows);
  const std::vector<vtkIdType>& GetHighlightedRows() const;
  ///@}

  /**
   * What is at a point of the device, or else the nearest within `tolerance` font sizes: a point
   * rather than a line, a line rather than an area. Exact also where the drawing is thinned out.
   */
  virtual pemesh::ChartPick Pick(double deviceX, double deviceY, double tolerance = 0.8);

  /** The rows (cells) with a mark in a rectangle between two corners, ascending. */
  virtual std::vector<vtkIdType> SelectRectangle(double x0, double y0, double x1, double y1);

  ///@{
  /**
   * What is seen. Zoom keeps the point under the mouse where it is and shows 1 / factor of the
   * range of each axis (factors > 1 magnify; 1 keeps an axis). Pan moves what is under the mouse at
   * (deviceX, deviceY) by (dx, dy). ZoomToRectangle shows what is between two corners. False, and
   * nothing changed, where there is nothing to zoom, and at the limits of double precision.
   */
  virtual bool Zoom(double deviceX, double deviceY, double factorX, double factorY);
  bool Zoom(double deviceX, double deviceY, double factor)
  {
    return this->Zoom(deviceX, deviceY, factor, factor);
  }
  virtual bool Pan(double deviceX, double deviceY, double dx, double dy);
  virtual bool ZoomToRectangle(double x0, double y0, double x1, double y1);
  /** Shows all again. */
  virtual void ResetView();
  /** Whether something was zoomed or moved since. */
  virtual bool IsZoomed() const { return false; }
  ///@}

  ///@{
  /** Ranges that are seen in the plot at a point of the device: least x, greatest x, least y,
   * greatest y, in the units of the axes. False where there is no plot. */
  virtual bool GetVisibleRange(double deviceX, double deviceY, double range[4]);
  /** The same in words: "t from 0 to 0.9, condition from 10 to 1e6"; "" where there is none. */
  virtual std::string DescribeVisibleRange(double deviceX, double deviceY);
  ///@}

  /** Height over width at which the panel looks best, for a figure that chooses its own size. */
  virtual double GetPreferredAspect() { return 0.7; }

protected:
  vtkPEMPanel();
  ~vtkPEMPanel() override;

  /** As Modified(), for what changes the picture but not the data behind it. */
  void ViewModified();

private:
  vtkPEMPanel(const vtkPEMPanel&) = delete;
  void operator=(const vtkPEMPanel&) = delete;

  std::string Title;
  double Rectangle[4] = { 0.0, 0.0, 400.0, 300.0 };
  double FontSize = 12.0;
  std::unique_ptr<pemesh::ChartStyle> Style;
  std::vector<vtkIdType> HighlightedRows;
};

#endif
