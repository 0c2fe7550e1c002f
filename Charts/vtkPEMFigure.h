// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMFigure
 * @brief   A grid of panels, written as PNG, SVG or PDF without a display.
 *
 * The layout is made in typographic points and does not depend on the resolution: the three kinds
 * of file show the same marks, and a larger resolution only makes a PNG sharper. The same panels
 * give the same bytes (no dates, no random names). Figures may be written by several threads at
 * once, each with a figure, panels and data of its own.
 *
 * @sa vtkPEMPanel vtkPEMCairoContextDevice2D
 */
#ifndef vtkPEMFigure_h
#define vtkPEMFigure_h

#include "pemeshChartsModule.h" // For export macro

#include <vtkObject.h>
#include <vtkSmartPointer.h> // For the panels

#include <memory> // For the style
#include <string> // For titles
#include <vector> // For the panels

class vtkPEMCairoContextDevice2D;
class vtkPEMPanel;

namespace pemesh
{
struct ChartStyle;
}

class PEMESHCHARTS_EXPORT vtkPEMFigure : public vtkObject
{
public:
  static vtkPEMFigure* New();
  vtkTypeMacro(vtkPEMFigure, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Panels fill the grid row by row. A panel must not be in two figures at once. */
  void AddPanel(vtkPEMPanel* panel);
  void RemoveAllPanels();
  int GetNumberOfPanels() const;
  vtkPEMPanel* GetPanel(int index) const;
  ///@}

  ///@{
  /** Columns of the grid, 0 to 100. Default 0: as near to a square as the number of panels allows.
   */
  vtkSetClampMacro(Columns, int, 0, 100);
  vtkGetMacro(Columns, int);
  ///@}

  ///@{
  /** Title above all panels, UTF-8; also the title of a PDF. Empty by default. */
  void SetTitle(const std::string& title);
  std::string GetTitle() const;
  ///@}

  ///@{
  /**
   * Size of the figure. 0 (default): 10 cm for every column, and the height that suits the panels.
   * Pixels are those of a PNG at the current resolution, so set that first.
   */
  void SetSizeInCentimeters(double width, double height);
  void SetSizeInPixels(int width, int height);
  int GetWidthInPixels() const;
  int GetHeightInPixels() const;
  vtkGetVector2Macro(Size, double); // centimetres
  ///@}

  ///@{
  /** Pixels an inch of a PNG, 36 to 2400. Default 300. */
  vtkSetClampMacro(DPI, double, 36.0, 2400.0);
  vtkGetMacro(DPI, double);
  ///@}

  ///@{
  /** Size of the text in points, 3 to 72. Default 8. */
  vtkSetClampMacro(FontSize, double, 3.0, 72.0);
  vtkGetMacro(FontSize, double);
  ///@}

  ///@{
  /**
   * How the figure and all its panels look; sets the size, the resolution and the size of the text
   * too. Until then every panel has its own style.
   */
  void SetStyle(const pemesh::ChartStyle& style);
  ///@}

  /**
   * Writes the whole file or nothing; the ending .png, .svg or .pdf says which kind. On failure
   * returns false, reports an error, and GetErrorMessage has one sentence that says what to do.
   */
  bool Write(const std::string& path);
  std::string GetErrorMessage() const;

  /** Paints on a device that has begun. */
  void Paint(vtkPEMCairoContextDevice2D* device);

protected:
  vtkPEMFigure();
  ~vtkPEMFigure() override;

private:
  vtkPEMFigure(const vtkPEMFigure&) = delete;
  void operator=(const vtkPEMFigure&) = delete;

  void WarnOfFonts();
  int GridColumns() const;
  int GridRows() const;
  double WidthInCentimeters() const;
  double HeightInCentimeters() const;

  std::vector<vtkSmartPointer<vtkPEMPanel>> Panels;
  int Columns = 0;
  std::string Title;
  double Size[2] = { 0.0, 0.0 };
  double DPI = 300.0;
  double FontSize = 8.0;
  std::unique_ptr<pemesh::ChartStyle> Style; // null: that of the panels
  std::string ErrorMessage;
};

#endif
