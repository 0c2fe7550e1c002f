// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReportFigures.h"

#include "TextFile.h"
#include "vtkPEMFigure.h"
#include "vtkPEMPanel.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <vtkNew.h>

namespace pemesh
{

namespace fs = std::filesystem;

namespace
{

constexpr std::size_t LargestVector = 200000; // bytes; beyond, a PNG is smaller
constexpr double PixelsAnInch = 160.0;

} // namespace

FigureFolder::FigureFolder(const ChartStyle& style)
  : Style(style)
{
  std::string pattern = (fs::temp_directory_path() / "pemesh-report-XXXXXX").string();
  if (!mkdtemp(pattern.data()))
  {
    throw std::runtime_error("No folder for temporary files can be made in \"" +
      fs::temp_directory_path().string() + "\".");
  }
  this->Path = pattern;
}

FigureFolder::~FigureFolder()
{
  std::error_code ignored; // what is left behind is in the folder for what may be
  fs::remove_all(this->Path, ignored);
}

Html EmbedPanel(const FigureFolder& folder, vtkPEMPanel* panel, const std::string& description,
  const std::string& caption, const FigureSize& size)
{
  const std::string reason = panel->WhyNotDrawable();
  if (!reason.empty())
  {
    return HtmlElement("figure", {}, HtmlElement("figcaption", caption + ": not drawn, " + reason));
  }
  vtkNew<vtkPEMFigure> figure;
  figure->AddPanel(panel);
  figure->SetStyle(folder.GetStyle());
  figure->SetSizeInCentimeters(size.Width, size.Height);
  figure->SetDPI(PixelsAnInch);
  const fs::path vector = folder.GetPath() / "figure.svg";
  if (!figure->Write(vector.string()))
  {
    throw std::runtime_error(figure->GetErrorMessage());
  }
  std::string address;
  if (fs::file_size(vector) <= LargestVector)
  {
    address = TextAddress("image/svg+xml", ReadTextFile(vector));
  }
  else
  {
    const fs::path pixels = folder.GetPath() / "figure.png";
    if (!figure->Write(pixels.string()))
    {
      throw std::runtime_error(figure->GetErrorMessage());
    }
    address = DataAddress("image/png", ReadTextFile(pixels));
  }
  return HtmlElement("figure", {},
    HtmlElement("img",
      { { "src", address }, { "alt", description },
        { "width", std::to_string(std::lround(100.0 * size.Width)) },
        { "height", std::to_string(std::lround(100.0 * size.Height)) } }) +
      HtmlElement("figcaption", caption));
}

} // namespace pemesh
