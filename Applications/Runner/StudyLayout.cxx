// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyLayout.h"

#include "ErrorText.h"
#include "PolygonFamilies.h"
#include "PolygonScatter.h"
#include "Study.h"
#include "vtkPEMPolygonLayout.h"

#include <stdexcept>
#include <string>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

namespace pemesh
{

namespace
{

int AddPolygon(const Study& study, const StudyPolygon& polygon, vtkPEMPolygonLayout* layout)
{
  const auto [x, y] = polygon.Center;
  if (polygon.Family == FileFamilyName)
  {
    return layout->AddPolygonFromFile((study.Folder / polygon.File).string(), x, y);
  }
  if (polygon.Family == PointsFamilyName)
  {
    std::vector<double> points;
    for (const std::array<double, 2>& point : polygon.Points)
    {
      points.insert(points.end(), point.begin(), point.end());
    }
    return layout->AddPolygonFromPoints(points, x, y);
  }
  return layout->AddPolygon(polygon.Family, x, y);
}

void PlacePolygons(const Study& study, vtkPEMPolygonLayout* layout)
{
  for (const StudyPolygon& polygon : study.Polygons)
  {
    const int index = AddPolygon(study, polygon, layout);
    if (index < 0)
    {
      return;
    }
    layout->SetPolygonScale(index, polygon.Scale);
    layout->SetPolygonRotation(index, polygon.Rotation);
    layout->SetPolygonRange(index, polygon.From, polygon.To);
    layout->SetPolygonName(index, polygon.Name);
    for (const auto& [name, value] : polygon.Parameters)
    {
      layout->SetPolygonParameter(index, name, value);
    }
  }
}

void Scatter(const StudyScatter& scatter, vtkPEMPolygonLayout* layout)
{
  ScatterOptions options;
  options.Count = scatter.Count;
  options.Seed = static_cast<std::uint64_t>(scatter.Seed);
  options.Families = scatter.Families;
  options.DrawsFamilies = scatter.Order == "random";
  options.SmallestScale = scatter.SmallestScale;
  options.LargestScale = scatter.LargestScale;
  options.LargestRotation = scatter.LargestRotation;
  options.Gap = scatter.Gap;
  const int first = layout->ScatterPolygons(options);
  for (int i = first; i >= 0 && i < layout->GetNumberOfPolygons(); ++i)
  {
    layout->SetPolygonRange(i, scatter.From, scatter.To);
  }
}

} // namespace

void ConfigureLayout(const Study& study, vtkPEMPolygonLayout* layout)
{
  vtkNew<vtkPEMPolygonLayout> wanted;
  std::string error;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&error);
  observer->SetCallback(
    [](vtkObject*, unsigned long, void* client, void* text)
    {
      auto& first = *static_cast<std::string*>(client); // the cause
      first = first.empty() ? SentenceOfError(static_cast<const char*>(text)) : first;
    });
  wanted->AddObserver(vtkCommand::ErrorEvent, observer);
  if (layout->GetNumberOfInputConnections(0) > 0)
  {
    wanted->SetInputConnection(layout->GetInputConnection(0, 0));
  }
  PlacePolygons(study, wanted);
  if (study.Scatter && error.empty())
  {
    Scatter(*study.Scatter, wanted);
  }
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
  layout->CopyPolygons(wanted);
}

} // namespace pemesh
