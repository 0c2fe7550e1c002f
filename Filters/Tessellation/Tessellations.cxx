// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tessellations.h"

#include "BoxTilings.h"
#include "ParallelLoop.h"
#include "PolygonMeasures.h"
#include "PolygonValidity.h"
#include "Predicates.h"
#include "TilingLattice.h"
#include "VoronoiMesh.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>

namespace pemesh
{

namespace
{

constexpr Parameter Cells = { "cells", "number of points", 100, 1, 1e9, true };
constexpr Parameter CellsOnSide = { "cells", "hexagons along the lower side", 10, 1, 1e6, true };
constexpr Parameter Squares = { "squares", "squares along the lower side", 10, 1, 1e6, true };
constexpr Parameter Seed = { "seed", "of the random numbers", 1, 0, 9007199254740992.0, true };
constexpr Parameter Spacing = { "spacing",
  "least distance of two points, as a share of that in the densest arrangement", 0, 0, 0.7 };
constexpr Parameter Iterations = { "iterations", "steps of Lloyd's method", 50, 0, 1e6, true };
constexpr Parameter Levels = { "levels", "how often a square may be quartered", 2, 0, 16, true };
constexpr Parameter Share = { "share", "part of the squares of a level that is quartered", 0.4, 0,
  1 };
constexpr Parameter Distortion = { "distortion",
  "how far corners move at most, in sides; convex up to 0.25", 0.25, 0, 0.499 };
constexpr Parameter Waviness = { "waviness", "1 would fold the mesh", 0.6, 0, 0.95 };
constexpr Parameter Amplitude = { "amplitude", "0 is harmless, 1 would be degenerate", 0.7, 0,
  0.99 };
constexpr Parameter Teeth = { "teeth", "teeth on a side", 2, 1, 1000, true };
constexpr Parameter Depth = { "depth", "how often edges are refined", 3, 0, 8, true };
constexpr Parameter KochAmplitude = { "amplitude",
  "height of the peaks; 1 is Koch's curve, 0 a straight line", 1, 0, 1 };
constexpr Parameter Slant = { "slant", "1 would make triangles", 0.5, 0, 0.99 };
constexpr Parameter Offset = { "offset", "how far joints are apart, in sides", 0.5, 0, 0.5 };

constexpr Parameter Agglomerates = { "cells", "number of elements", 100, 1, 1e8, true };
constexpr Parameter Fineness = { "fineness", "Voronoi cells merged to one element on average", 8, 1,
  1000, true };

constexpr Parameter VoronoiParameters[] = { Cells, Spacing, Seed };
constexpr Parameter CentroidalParameters[] = { Cells, Iterations, Seed };
constexpr Parameter HexagonParameters[] = { CellsOnSide };
constexpr Parameter SquareParameters[] = { Squares };
constexpr Parameter HangingParameters[] = { Squares, Levels, Share, Seed };
constexpr Parameter DistortedParameters[] = { Squares, Distortion, Seed };
constexpr Parameter WavyParameters[] = { Squares, Waviness };
constexpr Parameter DartParameters[] = { Squares, Amplitude };
constexpr Parameter ZigzagParameters[] = { Squares, Teeth, Amplitude };
constexpr Parameter KochParameters[] = { Squares, Depth, KochAmplitude };
constexpr Parameter TrapezoidParameters[] = { Squares, Slant };
constexpr Parameter BrickParameters[] = { Squares, Offset };
constexpr Parameter AgglomerateParameters[] = { Agglomerates, Fineness, Seed };

constexpr const char* HitchhikersGuide =
  "L. Beirao da Veiga, F. Brezzi, L. D. Marini, A. Russo, The hitchhiker's guide to the virtual "
  "element method, Mathematical Models and Methods in Applied Sciences 24 (2014) 1541-1573, "
  "doi:10.1142/S021820251440003X";
constexpr const char* PolyMesher =
  "C. Talischi, G. H. Paulino, A. Pereira, I. F. M. Menezes, PolyMesher: a general-purpose mesh "
  "generator for polygonal elements written in Matlab, Structural and Multidisciplinary "
  "Optimization 45 (2012) 309-328, doi:10.1007/s00158-011-0706-z";
constexpr const char* EscherElements =
  "G. H. Paulino, A. L. Gain, Bridging art and engineering using Escher-based virtual elements, "
  "Structural and Multidisciplinary Optimization 51 (2015) 867-883, "
  "doi:10.1007/s00158-014-1179-7";
constexpr const char* QuadrilateralElements =
  "D. N. Arnold, D. Boffi, R. S. Falk, Approximation by quadrilateral finite elements, Mathematics "
  "of Computation 71 (2002) 909-922, doi:10.1090/S0025-5718-02-01439-4";
constexpr const char* MimeticFamily =
  "F. Brezzi, K. Lipnikov, V. Simoncini, A family of mimetic finite difference methods on "
  "polygonal "
  "and polyhedral meshes, Mathematical Models and Methods in Applied Sciences 15 (2005) 1533-1551, "
  "doi:10.1142/S0218202505000832";
constexpr const char* SmallEdges =
  "S. C. Brenner, L.-Y. Sung, Virtual element methods on meshes with small edges or faces, "
  "Mathematical Models and Methods in Applied Sciences 28 (2018) 1291-1336, "
  "doi:10.1142/S0218202518500355";

constexpr const char* ArbitraryElements =
  "A. Cangiani, Z. Dong, E. H. Georgoulis, hp-Version discontinuous Galerkin methods on "
  "essentially "
  "arbitrarily-shaped elements, 2019, doi:10.48550/arXiv.1906.01715";
constexpr const char* AgglomeratedElements =
  "F. Bassi, L. Botti, A. Colombo, D. A. Di Pietro, P. Tesini, On the flexibility of agglomeration "
  "based physical space discontinuous Galerkin discretizations, Journal of Computational Physics "
  "231 (2012) 45-65, doi:10.1016/j.jcp.2011.08.018";

constexpr Tessellation Table[] = {
  { "voronoi", "Voronoi cells of random points",
    "the cells of uniform random points, at least a spacing apart", HitchhikersGuide,
    VoronoiParameters, &MakeVoronoi },
  { "centroidal-voronoi", "Centroidal Voronoi cells",
    "the cells of random points, each moved to the centroid of its cell again and again",
    PolyMesher, CentroidalParameters, &MakeCentroidalVoronoi },
  { "hexagons", "Regular hexagons", "regular hexagons, cut off at the boundary", HitchhikersGuide,
    HexagonParameters, &MakeHexagons },
  { "squares", "Squares", "equal squares, or rectangles as square as can be", HitchhikersGuide,
    SquareParameters, &MakeSquares },
  { "triangles", "Structured triangles", "squares halved by parallel diagonals", HitchhikersGuide,
    SquareParameters, &MakeTriangles },
  { "octagons", "Octagons and squares",
    "regular octagons, with squares between them: the truncated square tiling", EscherElements,
    SquareParameters, &MakeOctagons },
  { "bricks", "Bricks", "rectangles with hanging nodes: every second row is moved by the offset",
    SmallEdges, BrickParameters, &MakeBricks },
  { "hanging-squares", "Squares with hanging nodes",
    "squares, of which a random share is quartered, and of these again", SmallEdges,
    HangingParameters, &MakeHangingSquares },
  { "trapezoids", "Trapezoids", "squares with every second horizontal line bent up and down",
    QuadrilateralElements, TrapezoidParameters, &MakeTrapezoids },
  { "distorted-quadrilaterals", "Randomly distorted quadrilaterals",
    "squares whose corners are moved at random; convex up to a distortion of 0.25, simple below "
    "0.5",
    MimeticFamily, DistortedParameters, &MakeDistortedQuadrilaterals },
  { "wavy-quadrilaterals", "Smoothly distorted quadrilaterals",
    "squares under the map x + a sin(2 pi x) sin(2 pi y), y + the same, with 2 pi a the waviness",
    MimeticFamily, WavyParameters, &MakeWavyQuadrilaterals },
  { "darts", "Darts",
    "squares with every second corner moved along the diagonal; non-convex beyond 0.5",
    EscherElements, DartParameters, &MakeDarts },
  { "zigzag", "Zigzag", "squares whose horizontal edges are saws", EscherElements, ZigzagParameters,
    &MakeZigzag },
  { "koch", "Koch's curves", "squares whose inner edges are curves of Koch, of a finite depth",
    ArbitraryElements, KochParameters, &MakeKoch },
  { "random-agglomerates", "Random agglomerates",
    "the Voronoi cells of random points, merged with neighbours at random", AgglomeratedElements,
    AgglomerateParameters, &MakeRandomAgglomerates },
};

/** Strictly convex: a left turn at each vertex, and one turn around in all. Fast, and exact. */
bool IsRound(const std::vector<Point2>& polygon)
{
  int reversals = 0;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % n];
    const Point2& c = polygon[(i + 2) % n];
    if (Orientation(a, b, c) <= 0)
    {
      return false;
    }
    // Lexicographic, so that vertical edges have a direction.
    const bool before = a.x < b.x || (a.x == b.x && a.y < b.y);
    const bool after = b.x < c.x || (b.x == c.x && b.y < c.y);
    reversals += before != after ? 1 : 0;
  }
  return n >= 3 && reversals == 2;
}

/** The first element that is not simple and counter-clockwise, or the number of elements. */
int FindFault(const PolygonMesh& mesh)
{
  std::atomic<int> fault = mesh.NumberOfElements();
  ParallelLoop(0, mesh.NumberOfElements(), 0,
    [&](vtkIdType first, vtkIdType last)
    {
      std::vector<Point2> vertices;
      for (int element = static_cast<int>(first); element < last; ++element)
      {
        mesh.GetVertices(element, vertices);
        if (!IsRound(vertices) && !(IsSimple(vertices) && PolygonOrientation(vertices) > 0))
        {
          int known = fault;
          while (element < known && !fault.compare_exchange_weak(known, element))
          {
          }
          return;
        }
      }
    });
  return fault;
}

TessellationResult Fail(std::string message)
{
  return { TessellationStatus::Failed, std::move(message), {} };
}

TessellationResult MakeAndCheck(const Tessellation& tessellation, const TessellationInput& input)
{
  TessellationResult result = tessellation.Make(input);
  if (result.Status != TessellationStatus::Done)
  {
    return result;
  }
  if (result.Mesh.NumberOfElements() > input.MaximumElements)
  {
    return TooManyElements(result.Mesh.NumberOfElements(), input.MaximumElements);
  }
  const int fault = FindFault(result.Mesh);
  if (fault < result.Mesh.NumberOfElements())
  {
    std::vector<Point2> vertices;
    result.Mesh.GetVertices(fault, vertices);
    const std::string why = WhyNotSimple(vertices);
    return Fail("In double precision, element " + std::to_string(fault) + " of the mesh " +
      (why.empty() ? "is turned round" : why) +
      "; change the parameters a little, or move the domain nearer to the origin.");
  }
  return result;
}

} // namespace

std::span<const Tessellation> Tessellations()
{
  return Table;
}

int FindTessellation(std::string_view name)
{
  const auto found = std::find_if(std::begin(Table), std::end(Table),
    [name](const Tessellation& entry) { return entry.Name == name; });
  return found == std::end(Table) ? -1 : static_cast<int>(found - std::begin(Table));
}

TessellationResult MakeTessellation(
  const Tessellation& tessellation, const TessellationInput& input)
{
  bool isStopped = false;
  TessellationInput watched = input;
  watched.Progress = [&](double done)
  {
    isStopped = isStopped || !input.Progress(done);
    return !isStopped;
  };
  TessellationResult result;
  try
  {
    result = MakeAndCheck(tessellation, watched);
  }
  catch (const std::exception& error) // also of CGAL, and of memory that is not there
  {
    result = Fail(std::string("The mesh could not be made: ") + error.what());
  }
  if (isStopped)
  {
    return { TessellationStatus::Stopped, {}, {} };
  }
  if (result.Status == TessellationStatus::Failed)
  {
    result.Message = "Tessellation \"" + std::string(tessellation.Name) + "\": " + result.Message;
  }
  return result;
}

} // namespace pemesh
