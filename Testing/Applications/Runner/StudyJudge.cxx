// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StudyJudge.h"

#include "DomainShapes.h"
#include "MeshInvariants.h"
#include "PolygonFamilies.h"
#include "PolygonFile.h"
#include "vtkPEMMeshCheck.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

namespace
{

using pemesh::Point2;
using Rational = CGAL::Exact_rational;

/** How the copies of a mesh fill the box of the domain. */
struct Repetition
{
  explicit Repetition(const pemesh::StudyMesh& mesh)
    : Columns(mesh.Tile[0])
    , Rows(mesh.Tile[1])
    , Mirrored(std::exp2(mesh.Mirror))
    , Divisor(std::max(mesh.Tile[0], mesh.Tile[1]))
  {
  }
  double Copies() const { return this->Columns * this->Rows * this->Mirrored * this->Mirrored; }
  double Scale() const { return 1.0 / (this->Divisor * this->Mirrored); }

  double Columns;
  double Rows;
  double Mirrored; ///< copies side by side
  double Divisor;
};

pemesh::Domain DomainOf(const pemesh::Study& study)
{
  const pemesh::DomainShape* shape = pemesh::FindDomainShape(study.Domain.Shape);
  if (!shape)
  {
    const auto loops = pemesh::ReadPolygonFile(study.Folder / study.Domain.File);
    return { loops[0], { loops.begin() + 1, loops.end() } };
  }
  pemesh::ParameterValues values(shape->Parameters);
  for (const auto& [name, value] : study.Domain.Parameters)
  {
    values.Set(name, value);
  }
  return shape->Make(values);
}

struct Box
{
  explicit Box(const PolygonVertices& points)
    : Low(points[0])
    , High(points[0])
  {
    for (const Point2& point : points)
    {
      this->Low = { std::min(this->Low.x, point.x), std::min(this->Low.y, point.y) };
      this->High = { std::max(this->High.x, point.x), std::max(this->High.y, point.y) };
    }
  }
  double Diagonal() const
  {
    return std::hypot(this->High.x - this->Low.x, this->High.y - this->Low.y);
  }
  /** The largest coordinate. */
  double Size() const
  {
    return std::max({ std::abs(this->Low.x), std::abs(this->High.x), std::abs(this->Low.y),
      std::abs(this->High.y) });
  }

  Point2 Low;
  Point2 High;
};

double Perimeter(const PolygonVertices& loop)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point2& next = loop[(i + 1) % loop.size()];
    sum += std::hypot(next.x - loop[i].x, next.y - loop[i].y);
  }
  return sum;
}

PolygonVertices PointsOf(vtkPolyData* mesh)
{
  PolygonVertices points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points.push_back({ mesh->GetPoint(i)[0], mesh->GetPoint(i)[1] });
  }
  return points;
}

Rational TwiceTheArea(const PolygonVertices& vertices)
{
  Rational twice = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const Point2& a = vertices[i];
    const Point2& b = vertices[(i + 1) % vertices.size()];
    twice += Rational(a.x) * Rational(b.y) - Rational(b.x) * Rational(a.y);
  }
  return twice;
}

double ExactArea(const PolygonVertices& vertices)
{
  return 0.5 * CGAL::to_double(TwiceTheArea(vertices));
}

double ExactArea(vtkPolyData* mesh)
{
  Rational twice = 0;
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    twice += TwiceTheArea(VerticesOf(mesh, cell));
  }
  return 0.5 * CGAL::to_double(twice);
}

/** How far half a unit in the last place, in every step, moves a point at most. */
double RoundingOf(const pemesh::Domain& domain, const Repetition& repetition)
{
  return (2.0 + std::log2(repetition.Mirrored)) * 0x1p-52 * Box(domain.Outer).Size();
}

/** The rectangle that copies of one fill; its corners are those of the mesh, which are judged. */
std::string WhyNotRectangle(
  vtkPolyData* mesh, const pemesh::Domain& domain, const Repetition& repetition)
{
  const Box whole(domain.Outer);
  const Box found(PointsOf(mesh));
  const double east =
    whole.Low.x + (whole.High.x - whole.Low.x) * repetition.Columns / repetition.Divisor;
  const double north =
    whole.Low.y + (whole.High.y - whole.Low.y) * repetition.Rows / repetition.Divisor;
  const double rounding = RoundingOf(domain, repetition);
  if (!(found.Low == whole.Low) || std::abs(found.High.x - east) > rounding ||
    std::abs(found.High.y - north) > rounding)
  {
    return "the copies do not fill their part of the box of the domain";
  }
  return WhyNotACover(mesh,
    { { found.Low, { found.High.x, found.Low.y }, found.High, { found.Low.x, found.High.y } },
      {} });
}

std::string WhyNotTheArea(
  vtkPolyData* mesh, const pemesh::Domain& domain, const Repetition& repetition)
{
  double border = Perimeter(domain.Outer);
  for (const PolygonVertices& hole : domain.Holes)
  {
    border += Perimeter(hole);
  }
  border *= repetition.Copies() * repetition.Scale();
  const double expected =
    pemesh::DomainArea(domain) * repetition.Copies() * repetition.Scale() * repetition.Scale();
  const double difference = std::abs(ExactArea(mesh) - expected);
  return difference <= border * RoundingOf(domain, repetition) ? ""
                                                               : "the area is off by " +
      std::to_string(difference / expected) + " of " + std::to_string(expected);
}

std::string WhyNotCovered(vtkPolyData* mesh, const pemesh::Study& study)
{
  const pemesh::Domain domain = DomainOf(study);
  const Repetition repetition(study.Mesh);
  if (repetition.Copies() == 1.0)
  {
    const bool isAsMeshed = IsTriangulated(study.Mesh) && study.Mesh.Agglomeration.Rule == "none";
    return isAsMeshed ? WhyNotAMesh(mesh, domain) : WhyNotACover(mesh, domain);
  }
  if (pemesh::IsRectangle(domain))
  {
    return WhyNotRectangle(mesh, domain, repetition);
  }
  const std::string why = WhyNotPolygons(mesh);
  return why.empty() ? WhyNotTheArea(mesh, domain, repetition) : why;
}

/** Holes and thin elements it may be asked for; an unused point is never right. */
std::string WhyRefusedByTheCheck(vtkPolyData* mesh)
{
  vtkNew<vtkPEMMeshCheck> check;
  check->SetInputData(0, mesh);
  check->Update();
  auto* table = vtkTable::SafeDownCast(check->GetOutputDataObject(2));
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetValueByName(row, "Severity").ToString() == "error" ||
      table->GetValueByName(row, "Check").ToString() == "unused-points")
    {
      return table->GetValueByName(row, "Message").ToString();
    }
  }
  return {};
}

// --- placed polygons -----------------------------------------------------------------------------

PolygonVertices VerticesOf(
  const pemesh::Study& study, const pemesh::StudyPolygon& polygon, double t)
{
  const pemesh::PolygonFamily* family = pemesh::FindPolygonFamily(polygon.Family);
  if (!family->IsFixed())
  {
    pemesh::ParameterValues values(family->Parameters);
    for (const auto& [name, value] : polygon.Parameters)
    {
      values.Set(name, value);
    }
    return family->Vertices(polygon.From + t * (polygon.To - polygon.From), values);
  }
  PolygonVertices points;
  for (const auto& [x, y] : polygon.Points)
  {
    points.push_back({ x, y });
  }
  return points.empty() ? pemesh::ReadPolygonFile(study.Folder / polygon.File)[0] : points;
}

/** Of a copy: at scale 1 the diagonal of the box of a polygon is 0.5. */
double AreaOf(const PolygonVertices& own, double scale)
{
  const double factor = 0.5 * scale / Box(own).Diagonal();
  return std::abs(ExactArea(own)) * factor * factor;
}

std::string WhyNotPlaced(vtkPolyData* mesh, const pemesh::Study& study, double t)
{
  vtkDataArray* ids = mesh->GetCellData()->GetArray("PolygonId");
  if (!ids || !mesh->GetCellData()->GetArray("ElementFamily"))
  {
    return "PolygonId or ElementFamily is missing";
  }
  const Repetition repetition(study.Mesh);
  const double rounding = RoundingOf(DomainOf(study), repetition);
  std::map<int, double> found;
  for (int cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int id = static_cast<int>(ids->GetTuple1(cell));
    if (id < 0)
    {
      continue;
    }
    found[id] += 1.0;
    const auto index = static_cast<std::size_t>(id);
    if (index >= study.Polygons.size())
    {
      continue; // scattered: where it is and how large is not said
    }
    const PolygonVertices vertices = VerticesOf(mesh, cell);
    const double scale = study.Polygons[index].Scale * repetition.Scale();
    const double expected = AreaOf(VerticesOf(study, study.Polygons[index], t), scale);
    if (std::abs(ExactArea(vertices) - expected) >
      2.0 * Perimeter(vertices) * rounding + 1e-12 * expected)
    {
      return "placed polygon " + std::to_string(id) + " has another area than its family says";
    }
  }
  const std::size_t count =
    study.Polygons.size() + (study.Scatter ? static_cast<std::size_t>(study.Scatter->Count) : 0U);
  const bool isEachThere = std::all_of(found.begin(), found.end(),
    [&](const auto& polygon) { return polygon.second == repetition.Copies(); });
  return isEachThere && found.size() == count ? "" : "placed polygons are missing";
}

// --- target --------------------------------------------------------------------------------------

/** Of a virtual element method of order k for a problem with values given on the border: vertices
 * and k - 1 points of each edge inside, k (k - 1) / 2 moments of each element. */
double DegreesOfFreedom(vtkPolyData* mesh, double order)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> uses;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ++uses[std::minmax({ ids->GetId(i), ids->GetId((i + 1) % ids->GetNumberOfIds()) })];
    }
  }
  std::set<vtkIdType> border;
  double inside = 0.0;
  for (const auto& [edge, count] : uses)
  {
    inside += count == 2 ? 1.0 : 0.0;
    if (count == 1)
    {
      border.insert({ edge.first, edge.second });
    }
  }
  return static_cast<double>(mesh->GetNumberOfPoints()) - static_cast<double>(border.size()) +
    (order - 1.0) * inside +
    order * (order - 1.0) / 2.0 * static_cast<double>(mesh->GetNumberOfCells());
}

std::string WhyNotOnTarget(vtkPolyData* mesh, const pemesh::StudyTarget& target)
{
  if (target.Quantity == "none")
  {
    return {};
  }
  const double count = target.Quantity == "elements" ? static_cast<double>(mesh->GetNumberOfCells())
    : target.Quantity == "vertices" ? static_cast<double>(mesh->GetNumberOfPoints())
                                    : DegreesOfFreedom(mesh, target.Order);
  return std::abs(count - target.Value) <= 0.02 * target.Value
    ? ""
    : "the mesh has " + std::to_string(count) + " " + target.Quantity;
}

/** The words of which a sentence must have one. */
const std::map<std::string, std::vector<std::string>> Culprits{
  { "invalid-layout", { "piece-", "polygon ", "polygons found a place" } },
  { "target-not-reached", { "mesh.target.value" } },
  { "not-tileable", { "side of its bounding box", "Element " } },
  { "not-mirrorable", { "side of its bounding box", "Element " } },
  { "not-agglomerable", { "rule \"", "lement " } },
  { "tessellation-failed", { "Tessellation \"" } },
  { "meshing-failed", { "piece-", "polygon ", "the border of the domain", "maximum area" } },
};

} // namespace

std::string WhyBad(vtkPolyData* mesh, const pemesh::Study& studyOfCase, double t)
{
  const pemesh::StudyAgglomeration& merging = studyOfCase.Mesh.Agglomeration;
  const bool arePolygonsKept =
    IsTriangulated(studyOfCase.Mesh) && (merging.Rule == "none" || merging.KeepPolygons);
  std::string why = WhyNotCovered(mesh, studyOfCase);
  if (why.empty() && arePolygonsKept)
  {
    why = WhyNotPlaced(mesh, studyOfCase, t);
  }
  if (why.empty())
  {
    why = WhyNotOnTarget(mesh, studyOfCase.Mesh.Target);
  }
  return why.empty() ? WhyRefusedByTheCheck(mesh) : why;
}

std::string WhyBadRefusal(const std::string& status, const std::string& sentence)
{
  const auto known = Culprits.find(status);
  if (known == Culprits.end())
  {
    return "status \"" + status + "\": " + sentence;
  }
  const bool names = std::any_of(known->second.begin(), known->second.end(),
    [&](const std::string& word) { return sentence.find(word) != std::string::npos; });
  return names && sentence.back() == '.' ? "" : status + " names no culprit: " + sentence;
}
