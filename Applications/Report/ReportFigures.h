// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Charts and meshes as pictures inside the page.
 */
#ifndef pemesh_ReportFigures_h
#define pemesh_ReportFigures_h

#include "ChartStyle.h"
#include "HtmlText.h"

#include <filesystem>
#include <string>

class vtkPEMPanel;

namespace pemesh
{

/** A folder for files on their way into the page; goes with the object. */
class FigureFolder
{
public:
  explicit FigureFolder(const ChartStyle& style);
  ~FigureFolder();
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;

  const std::filesystem::path& GetPath() const { return this->Path; }
  const ChartStyle& GetStyle() const { return this->Style; }

private:
  std::filesystem::path Path;
  ChartStyle Style; // of all figures
};

/** Of a figure, in centimetres of a printed page. */
struct FigureSize
{
  double Width = 9.0;
  double Height = 7.0;
};

/**
 * The panel as an SVG inside the page, or, where that would be large (a mesh of many elements), as
 * a PNG. `description` is what a reader who cannot see it is told, `caption` stands below. A panel
 * that cannot be drawn is a sentence that says why.
 */
Html EmbedPanel(const FigureFolder& folder, vtkPEMPanel* panel, const std::string& description,
  const std::string& caption, const FigureSize& size = {});

} // namespace pemesh

#endif
