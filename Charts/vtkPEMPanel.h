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
 * @sa vtkPEMChart vtkPEMMeshView vtkPEMFigure
 */
#ifndef vtkPEMPanel_h
#define vtkPEMPanel_h

#include "pemeshChartsModule.h" // For export macro

#include <vtkContextItem.h>

#include <string> // For titles

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
  vtkSetClampMacro(FontSize, double, 1.0, 10000.0);
  vtkGetMacro(FontSize, double);
  ///@}

  /**
   * Empty if the panel can be drawn, else one sentence that says why not: no data, a column or an
   * array that does not exist (and the nearest one that does).
   */
  virtual std::string WhyNotDrawable() = 0;

  /** Height over width at which the panel looks best, for a figure that chooses its own size. */
  virtual double GetPreferredAspect() { return 0.7; }

protected:
  vtkPEMPanel() = default;
  ~vtkPEMPanel() override = default;

private:
  vtkPEMPanel(const vtkPEMPanel&) = delete;
  void operator=(const vtkPEMPanel&) = delete;

  std::string Title;
  double Rectangle[4] = { 0.0, 0.0, 400.0, 300.0 };
  double FontSize = 12.0;
};

#endif
