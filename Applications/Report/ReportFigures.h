// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Charts and meshes as pictures inside the page.
 */
#ifndef pemesh_ReportFigures_h
#define pemesh_ReportFigures_h

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
  FigureFolder();
  ~FigureFolder();
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;

  const std::filesystem::path& GetPath() const { return this->Path; }

private:
  std::filesystem::path Path;
};

/**
 * The panel as an SVG inside the page, or, where that would be large (a mesh of many elements), as
 * a PNG. `description` is what a reader who cannot see it is told, `caption` stands below. A panel
 * that cannot be drawn is a sentence that says why.
 */
Html EmbedPanel(const FigureFolder& folder, vtkPEMPanel* panel, const std::string& description,
  const std::string& caption);

} // namespace pemesh

#endif
