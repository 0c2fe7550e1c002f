// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Every metric against values known from elsewhere: closed forms, and numbers of the literature.
 */
#include "CornerMeasures.h"
#include "ElementGeometry.h"
#include "MeshConversion.h"
#include "MeshSurroundings.h"
#include "MetricMeshes.h"
#include "MetricRegistry.h"
#include "StiffnessMeasures.h"
#include "VirtualElementMethodElement.h"
#include "vtkPEMMetrics.h"

#include "../Geometry/BruteForce.h"
#include "../Geometry/PolygonSamples.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <map>

#include <vtkIdList.h>

using namespace pemesh;
using namespace pemesh::test;

namespace
{

constexpr double Pi = std::numbers::pi;
const double Root2 = std::sqrt(2.0);
const double Root3 = std::sqrt(3.0);

struct KnownValue
{
  const char* Metric;
  const char* Shape;
  double Value;
  double Tolerance = 1e-14;
};

const std::map<std::string, Polygon>& Shapes()
{
  static const std::map<std::string, Polygon> shapes = { { "square", pemesh::test::UnitSquare() },
    { "triangle", RegularPolygon(3) }, { "hexagon", RegularPolygon(6) },
    { "dart", ConvexityFamily(0.7) }, // numbers of the specification, to four digits
    { "L", { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } } },
    // A rectangle 2 x 1 of which one side is split 1 : 3.
    { "split", { { 0, 0 }, { .5, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } } },
    // The pentagon of the hitchhiker's guide to the virtual element method.
    { "pentagon", { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 1.5, 4 }, { 0, 4 } } } };
  return shapes;
}

const std::vector<KnownValue>& KnownOfElements()
{
  static const std::vector<KnownValue> known = {
    { "NumberOfEdges", "square", 4 },
    { "NumberOfEdges", "split", 5 },
    { "InscribedRadius", "square", 0.5 },
    { "InscribedRadius", "triangle", 0.5 },
    { "InscribedRadius", "L", 2.0 - Root2 },
    { "CircumscribedRadius", "square", Root2 / 2.0 },
    { "CircumscribedRadius", "triangle", 1.0 },
    { "CircumscribedRadius", "hexagon", 1.0 },
    { "CircleRatio", "square", Root2 / 2.0 },
    { "CircleRatio", "triangle", 0.5 },
    { "Area", "square", 1.0 },
    { "Area", "dart", 0.3 },
    { "Area", "pentagon", 10.5 },
    { "KernelArea", "square", 1.0 },
    { "KernelArea", "L", 1.0 },
    { "KernelAreaRatio", "L", 1.0 / 3.0 },
    { "KernelAreaRatio", "dart", 0.4286, 5e-5 },
    { "AreaPerimeterRatio", "square", Pi / 4.0 },
    { "AreaPerimeterRatio", "triangle", Pi * Root3 / 9.0 }, // .60460
    { "MinAngle", "square", Pi / 2.0 },
    { "MinAngle", "triangle", Pi / 3.0 },
    { "MaxAngle", "L", 1.5 * Pi },
    { "MaxAngle", "split", Pi },
    { "AngleRatio", "L", 1.0 / 3.0 },
    { "AngleRatio", "dart", 0.1037, 5e-5 },
    { "ShortestEdge", "split", 0.5 },
    { "EdgeRatio", "split", 0.25 },
    { "MinPointDistance", "L", 1.0 },
    { "MinPointDistance", "split", 0.5 },
    { "NormalizedPointDistance", "triangle", 1.0 },
    { "NormalizedPointDistance", "square", Root2 / 2.0 },
    { "ShapeRegularity", "triangle", 0.5 },
    { "ShapeRegularity", "L", 0.5 / Root2 },
    { "ShapeRegularity", "dart", 0.2408, 5e-5 },
    { "Diameter", "pentagon", 5.0 },
    { "Diameter", "hexagon", 2.0 },
    { "InradiusRatio", "hexagon", Root3 / 2.0 }, // .86603
    { "InradiusRatio", "dart", 0.2485, 5e-5 },
    { "OutradiusRatio", "triangle", Root3 / 2.0 },
    { "OutradiusRatio", "square", 1.0 },
    { "MinAngleFraction", "square", 0.25 },
    { "MinAngleFraction", "triangle", 1.0 / 6.0 },
    { "MaxAngleFraction", "triangle", 5.0 / 6.0 },
    { "MaxAngleFraction", "L", 0.25 },
    { "ScaledJacobian", "square", 1.0 },
    { "ScaledJacobian", "triangle", Root3 / 2.0 }, // .86603
    { "ScaledJacobian", "dart", 0.0 },
    { "ScaledJacobian", "split", 0.0 },
    { "FrobeniusRatio", "square", 1.0 },
    { "FrobeniusRatio", "dart", 0.6 / 1.58 }, // .3797
    { "FrobeniusRatio", "split", 0.0 },
    { "VEMRho1", "L", 1.0 / 3.0 },
    { "VEMRho2", "square", Root2 / 2.0 },
    { "VEMRho2", "pentagon", 0.3 },
    { "VEMRho3", "hexagon", 0.5 },
    { "VEMRho4", "square", 1.0 },
    { "VEMRho4", "split", 1.0 / 3.0 },
    { "VEMIndicator", "square", std::sqrt((Root2 / 2.0 + 1.75) / 3.0) },
    { "VEMIndicator", "triangle", std::sqrt((std::pow(3.0, 0.25) / 2.0 + 2.0) / 3.0) }, // .9413
    { "VEMIndicator", "hexagon", std::sqrt(2.0 / 3.0) },                                // .81650
    { "VEMIndicator", "dart", 0.5526, 5e-5 },
    { "VEMRatio", "square", Root2 },
    { "VEMRatio", "pentagon", 10.0 / 3.0 },
    { "MinSideRadiusRatio", "square", 2.0 },
    { "MinSideRadiusRatio", "triangle", 2.0 * Root3 },
    { "BoxRatio", "square", 1.0 },
    { "BoxRatio", "L", 0.75 },
    { "BoxRatio", "pentagon", 10.5 / 12.0 },
    // Eigenvalues 0 .5866 .8785 1.0610 1.6797.
    { "StabilityRatio", "pentagon", 0.5866 / 1.6797, 5e-5 },
    // The two gradients and what is left, a function of alternating signs, have the energy 1.
    { "StabilityRatio", "square", 1.0 },
    // The rows of the projection are orthogonal, of lengths 1/2, sqrt 2 and sqrt 2.
    { "ProjectionCondition", "square", 2.0 * Root2 },
  };
  return known;
}

/** A square whose right side is split by two rectangles 2 x 1/2. */
vtkSmartPointer<vtkPolyData> MeshOfThree()
{
  const Coordinates points = { { 0, 0 }, { 1, 0 }, { 1, .5 }, { 1, 1 }, { 0, 1 }, { 3, 0 },
    { 3, .5 }, { 3, 1 } };
  return MakeSharedMesh(points, { { 0, 1, 2, 3, 4 }, { 1, 5, 6, 2 }, { 2, 6, 7, 3 } });
}

struct KnownInMesh
{
  const char* Metric;
  std::array<double, 3> Values;
};

const std::vector<KnownInMesh>& KnownInMeshes()
{
  const double jump = std::sqrt(4.25 / 2.0);
  static const std::vector<KnownInMesh> known = {
    { "UniformityFactor", { 1.0 / jump, 1.0, 1.0 } },
    { "NumberOfNeighbours", { 2, 2, 2 } },
    { "HangingVertices", { 1, 0, 0 } },
    { "LargestSharedFraction", { 0.125, 0.4, 0.4 } },
    { "SmallestSharedFraction", { 0.125, 0.1, 0.1 } },
    { "BoundaryFraction", { 0.75, 0.5, 0.5 } },
    { "DiameterJump", { jump, jump, jump } },
    { "NumberOfEdgesJump", { 1, 1, 1 } },
    { "MaxAngleJump", { Pi / 2.0, Pi / 2.0, Pi / 2.0 } },
    { "AreaJump", { 1, 1, 1 } },
  };
  return known;
}

double MeasureAlone(const Metric& metric, const Polygon& polygon)
{
  ElementGeometry element;
  EXPECT_TRUE(element.SetVertices(polygon));
  return metric.Function(element);
}

vtkSmartPointer<vtkPolyData> MeasureMesh(vtkPolyData* mesh, const std::vector<std::string>& names)
{
  vtkNew<vtkPEMMetrics> filter;
  filter->SetMetrics(names);
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

class KnownValues : public testing::TestWithParam<const Metric*>
{
};

std::vector<const Metric*> AllMetrics()
{
  std::vector<const Metric*> all;
  for (const Metric& metric : Metrics())
  {
    all.push_back(&metric);
  }
  return all;
}

/** Number of comparisons. */
int CompareAlone(const Metric& metric)
{
  int count = 0;
  for (const KnownValue& known : KnownOfElements())
  {
    if (metric.Function && std::string(metric.Name) == known.Metric)
    {
      EXPECT_NEAR(MeasureAlone(metric, Shapes().at(known.Shape)), known.Value, known.Tolerance)
        << known.Shape;
      ++count;
    }
  }
  return count;
}

int CompareInMesh(const Metric& metric)
{
  int count = 0;
  for (const KnownInMesh& known : KnownInMeshes())
  {
    if (std::string(metric.Name) == known.Metric)
    {
      const auto measured = MeasureMesh(MeshOfThree(), { metric.Name });
      for (std::size_t i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(
          CellValue(measured, metric.Name, static_cast<vtkIdType>(i)), known.Values[i], 1e-14)
          << i;
      }
      ++count;
    }
  }
  return count;
}

/** Jumps of what is known of a single element: a triangle on a square. */
int CompareJump(const Metric& metric)
{
  if (metric.Set != MetricSet::Jump)
  {
    return 0;
  }
  const Coordinates points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { .3, 1.5 } };
  const auto measured =
    MeasureMesh(MakeSharedMesh(points, { { 0, 1, 2, 3 }, { 3, 2, 4 } }), { metric.Name });
  const Metric& base = *FindMetric(metric.Base);
  const double square = MeasureAlone(base, pemesh::test::UnitSquare());
  const double triangle = MeasureAlone(base, { { 0, 1 }, { 1, 1 }, { .3, 1.5 } });
  const double expected = base.ScaleInvariant
    ? std::abs(square - triangle)
    : std::max(square, triangle) / std::min(square, triangle);
  EXPECT_NEAR(CellValue(measured, metric.Name, 0), expected, 1e-14);
  EXPECT_NEAR(CellValue(measured, metric.Name, 1), expected, 1e-14);
  return 1;
}

} // namespace

TEST_P(KnownValues, Agree)
{
  const Metric& metric = *GetParam();
  EXPECT_GT(CompareAlone(metric) + CompareInMesh(metric) + CompareJump(metric), 0)
    << "nothing is known of " << metric.Name;
}

INSTANTIATE_TEST_SUITE_P(Metrics, KnownValues, testing::ValuesIn(AllMetrics()),
  [](const testing::TestParamInfo<const Metric*>& known)
  { return std::string(known.param->Name); });

TEST(CornerMeasures, AgreeWithTheAngles)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const Polygon polygon = RandomPolygon(seed, 3, 30);
    const std::vector<double> angles = InteriorAngles(polygon);
    double sine = 1.0;
    double ratio = 1.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point2& before = polygon[i == 0 ? polygon.size() - 1 : i - 1];
      const Point2& after = polygon[(i + 1) % polygon.size()];
      const double a = std::hypot(before.x - polygon[i].x, before.y - polygon[i].y);
      const double b = std::hypot(after.x - polygon[i].x, after.y - polygon[i].y);
      sine = std::min(sine, std::sin(angles[i]));
      ratio = std::min(ratio, 2.0 * a * b * std::abs(std::sin(angles[i])) / (a * a + b * b));
    }
    EXPECT_NEAR(MeasureCorners(polygon).SmallestSine, sine, 1e-13) << seed;
    EXPECT_NEAR(MeasureCorners(polygon).SmallestFrobeniusRatio, ratio, 1e-13) << seed;
  }
}

TEST(CornerMeasures, SidesOfMoreThanOneEdge)
{
  const Polygon square = { { 0, 0 }, { .25, 0 }, { .5, 0 }, { 1, 0 }, { 1, .9 }, { 1, 1 },
    { 0, 1 } };
  for (std::size_t shift = 0; shift < square.size(); ++shift)
  {
    Polygon shifted = square;
    std::rotate(
      shifted.begin(), shifted.begin() + static_cast<std::ptrdiff_t>(shift), shifted.end());
    EXPECT_NEAR(SmallestSideRatio(shifted, 1e-10), 1.0 / 9.0, 1e-15) << "begins at " << shift;
  }
  const auto Bent = [](double height) {
    return Polygon{ { 0, 0 }, { .25, -height }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  };
  EXPECT_NEAR(SmallestSideRatio(Bent(0.9e-10), 1e-10), 1.0 / 3.0, 1e-9);
  EXPECT_EQ(SmallestSideRatio(Bent(1.1e-10), 1e-10), 1.0);
  EXPECT_NEAR(SmallestSideRatio(Bent(-0.9e-10), 1e-10), 1.0 / 3.0, 1e-9);
  EXPECT_FALSE(IsStraight({ 0, 0 }, { 1, 0 }, { .5, 0 }, 1e-10)) << "back again";
}

TEST(StiffnessMeasures, AgreeWithTheWholeMatrices)
{
  for (std::uint64_t seed = 0; seed < 120; ++seed)
  {
    const Polygon polygon =
      seed < 12 ? RegularPolygon(static_cast<int>(seed) + 3) : RandomPolygon(seed, 3, 25);
    VirtualElement element;
    element.Set(polygon, ProjectionConstant::VertexMean);
    const auto n = static_cast<Eigen::Index>(polygon.size());
    std::vector<double> packed(polygon.size() * (polygon.size() + 1) / 2);
    element.GetStiffness(packed);
    Eigen::MatrixXd stiffness(n, n);
    Eigen::MatrixXd projection(3, n);
    for (Eigen::Index i = 0; i < n; ++i)
    {
      for (Eigen::Index j = 0; j <= i; ++j)
      {
        stiffness(i, j) = packed[static_cast<std::size_t>(i * (i + 1) / 2 + j)];
      }
      projection.col(i) << element.Constant()[i], element.GradientX()[i], element.GradientY()[i];
    }
    const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness).eigenvalues();
    const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(projection).singularValues();
    const StiffnessMeasures measures = MeasureStiffness(polygon);
    EXPECT_NEAR(measures.StabilityRatio, values(1) / values(n - 1), 1e-12) << seed;
    EXPECT_NEAR(measures.ProjectionCondition * singular(2) / singular(0), 1.0, 1e-11) << seed;
  }
}

TEST(NeighbourMetrics, AloneInTheMesh)
{
  const auto measured =
    MeasureMesh(MakeMesh({ SquareCoordinates() }), { "neighbourhood", "AreaJump" });
  EXPECT_EQ(CellValue(measured, "NumberOfNeighbours", 0), 0.0);
  EXPECT_EQ(CellValue(measured, "BoundaryFraction", 0), 1.0);
  EXPECT_EQ(CellValue(measured, "HangingVertices", 0), 0.0);
  EXPECT_TRUE(std::isnan(CellValue(measured, "LargestSharedFraction", 0)));
  EXPECT_TRUE(std::isnan(CellValue(measured, "SmallestSharedFraction", 0)));
  EXPECT_TRUE(std::isnan(CellValue(measured, "AreaJump", 0)));
}

/** Elements one at a time, or all, turned round, and a vertex of theirs repeated. */
TEST(NeighbourMetrics, OrientationAndRepeatsChangeNothing)
{
  const std::vector<std::string> names = { "neighbourhood", "jumps" };
  vtkSmartPointer<vtkPolyData> plain = MeasureMesh(MeshOfThree(), names);
  const vtkSmartPointer<vtkPolyData> three = MeshOfThree();
  for (unsigned int turned = 0; turned < 8; ++turned)
  {
    for (const bool repeated : { false, true })
    {
      vtkNew<vtkCellArray> cells;
      for (vtkIdType element = 0; element < 3; ++element)
      {
        vtkNew<vtkIdList> ids;
        three->GetPolys()->GetCellAtId(element, ids);
        std::vector<vtkIdType> vertices(ids->begin(), ids->end());
        if ((turned >> element & 1U) != 0)
        {
          std::reverse(vertices.begin(), vertices.end());
        }
        if (repeated)
        {
          vertices.insert(vertices.begin() + 1, vertices[1]);
          vertices.push_back(vertices.front());
        }
        cells->InsertNextCell(static_cast<vtkIdType>(vertices.size()), vertices.data());
      }
      vtkNew<vtkPolyData> mesh;
      mesh->SetPoints(three->GetPoints());
      mesh->SetPolys(cells);
      const auto measured = MeasureMesh(mesh, names);
      for (const Metric& metric : Metrics())
      {
        for (vtkIdType i = 0; i < 3 && measured->GetCellData()->HasArray(metric.Name); ++i)
        {
          EXPECT_NEAR(CellValue(measured, metric.Name, i), CellValue(plain, metric.Name, i), 1e-14)
            << metric.Name << ' ' << i << " turned " << turned << " repeated " << repeated;
        }
      }
      MeshNeighbours neighbours(ToPolygonMesh(mesh));
      EXPECT_EQ(neighbours.CountEdges(), 10);
      EXPECT_NEAR(neighbours.GetBoundaryLength(), 8.0, 1e-15);
    }
  }
}

/** The reflex corners of a staircase see each other in one point, turned or not. */
TEST(NeighbourMetrics, ANeighbourThatIsNotStarShapedGivesNoRatio)
{
  const Coordinates stairs = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 3 }, { 1, 3 }, { 1, 2 },
    { 0, 2 }, { -1, 0 }, { -1, 2 } };
  int empty = 0;
  for (int i = 0; i < 200; ++i)
  {
    const double angle = 2.0 * Pi * i / 200.0;
    Coordinates turned;
    for (const auto& [x, y] : stairs)
    {
      turned.push_back(
        { std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y });
    }
    const auto measured = MeasureMesh(
      MakeSharedMesh(turned, { { 0, 1, 2, 3, 4, 5, 6, 7 }, { 8, 0, 7, 9 } }), { "KernelAreaJump" });
    Polygon polygon;
    for (std::size_t k = 0; k < 8; ++k)
    {
      polygon.push_back({ turned[k][0], turned[k][1] });
    }
    if (ExactKernelArea(polygon) == 0.0)
    {
      ++empty;
      EXPECT_TRUE(std::isnan(CellValue(measured, "KernelAreaJump", 0))) << i;
      EXPECT_TRUE(std::isnan(CellValue(measured, "KernelAreaJump", 1))) << i;
    }
  }
  EXPECT_GT(empty, 20);
}

TEST(NeighbourMetrics, ANeighbourThatIsUndefinedGivesNoJump)
{
  // A square beside an element without area.
  const Coordinates points = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 0 }, { 3, 0 } };
  const auto measured = MeasureMesh(
    MakeSharedMesh(points, { { 0, 1, 2, 3 }, { 1, 0, 5, 4 } }), { "AreaJump", "NumberOfEdges" });
  EXPECT_TRUE(std::isnan(CellValue(measured, "AreaJump", 0)));
  EXPECT_TRUE(std::isnan(CellValue(measured, "AreaJump", 1)));
}

TEST(NeighbourMetrics, ANeighbourAcrossTwoEdgesCountsOnce)
{
  // Two rectangles whose common side is split, and a third one below.
  const Coordinates points = { { 0, 0 }, { 1, 0 }, { 1, .25 }, { 1, 1 }, { 0, 1 }, { 2, 0 },
    { 2, 1 } };
  const auto measured = MeasureMesh(
    MakeSharedMesh(points, { { 0, 1, 2, 3, 4 }, { 1, 5, 6, 3, 2 } }), { "neighbourhood" });
  EXPECT_EQ(CellValue(measured, "NumberOfNeighbours", 0), 1.0);
  EXPECT_EQ(CellValue(measured, "HangingVertices", 0), 0.0) << "nothing ends there";
  EXPECT_NEAR(CellValue(measured, "LargestSharedFraction", 0), 0.25, 1e-15);
  EXPECT_NEAR(CellValue(measured, "SmallestSharedFraction", 1), 0.25, 1e-15);
}
