// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The list of polygons of vtkPEMPolygonLayout: adding, editing, reading. The rest of the class is
 * in vtkPEMPolygonLayout.cxx.
 */
#include "vtkPEMPolygonLayout.h"

#include "LayoutPolygon.h"
#include "LayoutValidity.h"
#include "NumberText.h"
#include "PolygonFile.h"
#include "PolygonPlacement.h"
#include "PolygonScatter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace
{

constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();

} // namespace

int vtkPEMPolygonLayout::AddPolygon(const std::string& family, double centerX, double centerY)
{
  const pemesh::PolygonFamily* found = pemesh::FindPolygonFamily(family);
  if (found && found->IsFixed())
  {
    vtkErrorMacro(<< "Polygons of the family \"" << family
                  << "\" are added by AddPolygonFromFile or AddPolygonFromPoints.");
    return -1;
  }
  if (!found)
  {
    std::vector<std::string> names;
    for (const pemesh::PolygonFamily& candidate : pemesh::PolygonFamilies())
    {
      names.emplace_back(candidate.Name);
    }
    vtkErrorMacro(<< "There is no polygon family \"" << family << "\"; did you mean \""
                  << pemesh::NearestWord(family, names) << "\"?");
    return -1;
  }
  return this->Append({ *found, { centerX, centerY } });
}

int vtkPEMPolygonLayout::AddPolygon(
  const std::string& family, double centerX, double centerY, double scale, double rotation)
{
  const int index = this->AddPolygon(family, centerX, centerY);
  if (index >= 0)
  {
    this->SetPolygonScale(index, scale);
    this->SetPolygonRotation(index, rotation);
  }
  return index;
}

int vtkPEMPolygonLayout::Append(pemesh::LayoutPolygon polygon)
{
  this->Polygons.push_back(std::move(polygon));
  this->Modified();
  return this->GetNumberOfPolygons() - 1;
}

int vtkPEMPolygonLayout::AppendFixed(
  const char* family, const std::string& source, std::vector<pemesh::Point2> points)
{
  const std::string why = pemesh::MakeFixedPolygon(points);
  if (!why.empty())
  {
    vtkErrorMacro(<< source << " " << why << ".");
    return -1;
  }
  const pemesh::PolygonPlace place = pemesh::PlaceOf(points);
  pemesh::LayoutPolygon polygon(*pemesh::FindPolygonFamily(family), place.Center);
  polygon.Scale = place.Scale;
  polygon.Points = std::move(points);
  return this->Append(std::move(polygon));
}

int vtkPEMPolygonLayout::AddPolygonFromFile(const std::string& file, double centerX, double centerY)
{
  std::vector<pemesh::Point2> points;
  try
  {
    points = pemesh::ReadPolygonFile(file).front();
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return -1;
  }
  const int index = this->AppendFixed(
    pemesh::FileFamilyName, "The first polygon of \"" + file + "\"", std::move(points));
  if (index >= 0)
  {
    this->Polygons[index].File = file;
    this->Polygons[index].Center = { centerX, centerY };
    this->Polygons[index].Scale = 1.0;
  }
  return index;
}

int vtkPEMPolygonLayout::AddPolygonFromPoints(const std::vector<double>& points)
{
  if (points.size() % 2 != 0)
  {
    vtkErrorMacro(<< "The points of a polygon are " << points.size()
                  << " numbers, expected pairs of x and y.");
    return -1;
  }
  std::vector<pemesh::Point2> pairs;
  for (std::size_t i = 0; i < points.size(); i += 2)
  {
    pairs.push_back({ points[i], points[i + 1] });
  }
  return this->AppendFixed(pemesh::PointsFamilyName, "The polygon to add", std::move(pairs));
}

int vtkPEMPolygonLayout::AddPolygonFromPoints(
  const std::vector<double>& points, double centerX, double centerY)
{
  const int index = this->AddPolygonFromPoints(points);
  if (index >= 0)
  {
    this->Polygons[index].Center = { centerX, centerY };
    this->Polygons[index].Scale = 1.0;
  }
  return index;
}

int vtkPEMPolygonLayout::ScatterPolygons(int count, double seed,
  const std::vector<std::string>& families, double smallestScale, double largestScale, double gap)
{
  if (!(seed >= 0.0 && seed <= 0x1p53) || seed != std::trunc(seed))
  {
    vtkErrorMacro(<< "The seed is " << seed << ", expected an integer of 0 to 2^53.");
    return -1;
  }
  pemesh::ScatterOptions options;
  options.Count = count;
  options.Seed = static_cast<std::uint64_t>(seed);
  options.Families = families;
  options.SmallestScale = smallestScale;
  options.LargestScale = largestScale;
  options.Gap = gap;
  return this->ScatterPolygons(options);
}

int vtkPEMPolygonLayout::ScatterPolygons(const pemesh::ScatterOptions& options)
{
  std::vector<pemesh::PolygonPlace> occupied;
  for (const pemesh::LayoutPolygon& polygon : this->Polygons)
  {
    occupied.push_back({ polygon.Center, polygon.Scale });
  }
  pemesh::Domain domain;
  std::string fault = this->UpdateDomain(domain);
  std::vector<pemesh::ScatteredPolygon> scattered;
  if (fault.empty())
  {
    fault = pemesh::ScatterPolygons(options, domain, occupied, scattered);
  }
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault);
    return -1;
  }
  const int first = this->GetNumberOfPolygons();
  for (const pemesh::ScatteredPolygon& added : scattered)
  {
    pemesh::LayoutPolygon polygon(*added.Family, added.Place.Center);
    polygon.Scale = added.Place.Scale;
    polygon.Rotation = added.Rotation;
    if (pemesh::FindParameter(added.Family->Parameters, "seed"))
    {
      polygon.Parameters.Set("seed", static_cast<double>(added.Seed));
    }
    this->Append(std::move(polygon));
  }
  return first;
}

int vtkPEMPolygonLayout::DuplicatePolygon(int index)
{
  const pemesh::LayoutPolygon* polygon = this->FindPolygon(index);
  return polygon ? this->Append(*polygon) : -1;
}

void vtkPEMPolygonLayout::RemovePolygon(int index)
{
  if (this->FindPolygon(index))
  {
    this->Polygons.erase(this->Polygons.begin() + index);
    this->Modified();
  }
}

void vtkPEMPolygonLayout::RemoveAllPolygons()
{
  if (!this->Polygons.empty())
  {
    this->Polygons.clear();
    this->Modified();
  }
}

void vtkPEMPolygonLayout::MovePolygon(int from, int to)
{
  if (!this->FindPolygon(from) || !this->FindPolygon(to) || from == to)
  {
    return;
  }
  const auto begin = this->Polygons.begin();
  if (from < to)
  {
    std::rotate(begin + from, begin + from + 1, begin + to + 1);
  }
  else
  {
    std::rotate(begin + to, begin + from, begin + from + 1);
  }
  this->Modified();
}

int vtkPEMPolygonLayout::GetNumberOfPolygons() const
{
  return static_cast<int>(this->Polygons.size());
}

void vtkPEMPolygonLayout::CopyPolygons(vtkPEMPolygonLayout* other)
{
  if (this->Polygons != other->Polygons)
  {
    this->Polygons = other->Polygons;
    this->Modified();
  }
}

const pemesh::LayoutPolygon* vtkPEMPolygonLayout::PeekPolygon(int index) const
{
  return index >= 0 && index < this->GetNumberOfPolygons() ? &this->Polygons[index] : nullptr;
}

pemesh::LayoutPolygon* vtkPEMPolygonLayout::FindPolygon(int index)
{
  if (!this->PeekPolygon(index))
  {
    vtkErrorMacro(<< "There is no polygon of index " << index << ": the layout has "
                  << this->GetNumberOfPolygons() << ", counted from 0.");
    return nullptr;
  }
  return &this->Polygons[index];
}

void vtkPEMPolygonLayout::SetPolygonCenter(int index, double centerX, double centerY)
{
  pemesh::LayoutPolygon* polygon = this->FindPolygon(index);
  if (polygon && (polygon->Center.x != centerX || polygon->Center.y != centerY))
  {
    polygon->Center = { centerX, centerY };
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonCenterX(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->Center.x : Undefined;
}

double vtkPEMPolygonLayout::GetPolygonCenterY(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->Center.y : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonScale(int index, double scale)
{
  pemesh::LayoutPolygon* polygon = this->FindPolygon(index);
  if (polygon && polygon->Scale != scale)
  {
    polygon->Scale = scale;
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonScale(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->Scale : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonRotation(int index, double degrees)
{
  pemesh::LayoutPolygon* polygon = this->FindPolygon(index);
  if (polygon && polygon->Rotation != degrees)
  {
    polygon->Rotation = degrees;
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonRotation(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->Rotation : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonParameter(int index, const std::string& name, double value)
{
  pemesh::LayoutPolygon* polygon = this->FindPolygon(index);
  if (!polygon)
  {
    return;
  }
  const double old = polygon->Parameters.Get(name);
  const std::string why = polygon->Parameters.Set(name, value);
  if (!why.empty())
  {
    vtkErrorMacro(<< "In " << polygon->NameAt(index) << ": " << why);
  }
  else if (old != value)
  {
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonParameter(int index, const std::string& name) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->Parameters.Get(name) : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonRange(int index, double from, double to)
{
  pemesh::LayoutPolygon* polygon = this->FindPolygon(index);
  if (polygon && (polygon->From != from || polygon->To != to))
  {
    polygon->From = from;
    polygon->To = to;
    this->Modified();
  }
}

double vtkPEMPolygonLayout::GetPolygonFrom(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->From : Undefined;
}

double vtkPEMPolygonLayout::GetPolygonTo(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->To : Undefined;
}

void vtkPEMPolygonLayout::SetPolygonName(int index, const std::string& name)
{
  pemesh::LayoutPolygon* polygon = this->FindPolygon(index);
  if (polygon && polygon->Name != name)
  {
    polygon->Name = name;
    this->Modified();
  }
}

std::string vtkPEMPolygonLayout::GetPolygonName(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->NameAt(index) : std::string();
}

std::string vtkPEMPolygonLayout::GetPolygonFamily(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->Family->Name : std::string();
}

std::string vtkPEMPolygonLayout::GetPolygonFile(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  return polygon ? polygon->File : std::string();
}

std::vector<double> vtkPEMPolygonLayout::GetPolygonPoints(int index) const
{
  const pemesh::LayoutPolygon* polygon = this->PeekPolygon(index);
  std::vector<double> points;
  if (polygon)
  {
    for (const pemesh::Point2& point : polygon->Points)
    {
      points.insert(points.end(), { point.x, point.y });
    }
  }
  return points;
}
