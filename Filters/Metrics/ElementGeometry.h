// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the metrics of one element share: each kernel is computed when first asked for, and once.
 *
 * Make one for a thread and give it element after element: its buffers are reused. A convex
 * element is its own kernel, and a triangle has closed forms for everything.
 */
#ifndef pemesh_ElementGeometry_h
#define pemesh_ElementGeometry_h

#include "CornerMeasures.h"
#include "InscribedCircle.h"
#include "MetricRegistry.h"
#include "PointDistances.h"
#include "PolygonKernel.h"
#include "PolygonMeasures.h"
#include "StiffnessMeasures.h"
#include "pemeshFiltersMetricsModule.h" // For export macro

#include <vector>

namespace pemesh
{

class PEMESHFILTERSMETRICS_EXPORT ElementGeometry
{
public:
  /**
   * The element to be measured, in either orientation. Repeats of a vertex in a row are ignored.
   * False if it cannot be measured: fewer than three distinct vertices, no area, edges that
   * cross, or coordinates that are not finite.
   */
  bool SetVertices(PolygonView vertices);

  /** Whether repeats of a vertex were ignored. */
  bool HasRepeatedVertices() const { return this->Repeated; }

  /** Counter-clockwise, without repeats. Valid until the next SetVertices. */
  PolygonView GetVertices() const { return this->Vertices; }

  /** The kernels computed so far for this element, a sum of MetricNeeds: for tests. */
  unsigned int GetComputed() const { return this->Computed; }

  bool IsConvex() const { return this->Convex; }
  double GetArea() { return this->Get(NeedsArea, this->Area, &ElementGeometry::ComputeArea); }
  const EdgeLengths& GetEdges()
  {
    return this->Get(NeedsEdges, this->Edges, &ElementGeometry::ComputeEdges);
  }
  const AngleRange& GetAngles()
  {
    return this->Get(NeedsAngles, this->Angles, &ElementGeometry::ComputeAngles);
  }
  /** Largest and least distance of two vertices. */
  double GetDiameter()
  {
    return this->Get(NeedsDistances, this->Farthest.Distance, &ElementGeometry::ComputeDistances);
  }
  double GetClosestPairDistance()
  {
    return this->Get(NeedsDistances, this->ClosestPairDistance, &ElementGeometry::ComputeDistances);
  }
  double GetEnclosingRadius()
  {
    return this->Get(
      NeedsEnclosingCircle, this->EnclosingRadius, &ElementGeometry::ComputeEnclosingRadius);
  }
  double GetInscribedRadius()
  {
    return this->Get(
      NeedsInscribedCircle, this->InscribedRadius, &ElementGeometry::ComputeInscribedRadius);
  }
  /** 0 where the element is not star-shaped. */
  double GetKernelArea()
  {
    return this->Get(NeedsKernelArea, this->KernelArea, &ElementGeometry::ComputeKernelArea);
  }
  double GetKernelRadius()
  {
    return this->Get(NeedsKernelRadius, this->KernelRadius, &ElementGeometry::ComputeKernelRadius);
  }
  const CornerShapes& GetCorners()
  {
    return this->Get(NeedsCorners, this->Corners, &ElementGeometry::ComputeCorners);
  }
  /** See SmallestSideRatio. */
  double GetSideRatio()
  {
    return this->Get(NeedsSides, this->SideRatio, &ElementGeometry::ComputeSideRatio);
  }
  /** Area of the axis-parallel bounding box. */
  double GetBoxArea()
  {
    return this->Get(NeedsBox, this->BoxArea, &ElementGeometry::ComputeBoxArea);
  }
  const StiffnessMeasures& GetStiffness()
  {
    return this->Get(NeedsStiffness, this->Stiffness, &ElementGeometry::ComputeStiffness);
  }

private:
  struct TriangleSides // side i is opposite to vertex i, and sides[Order[0]] the shortest
  {
    Point2 Vector[3];
    double Square[3];
    double Length[3];
    int Order[3];
  };

  bool IsTriangle() const { return this->Vertices.size() == 3; }

  /** A value, computed the first time. */
  template <typename Value>
  const Value& Get(unsigned int need, const Value& value, void (ElementGeometry::*compute)())
  {
    if ((this->Computed & need) == 0)
    {
      this->Computed |= need;
      (this->*compute)();
    }
    return value;
  }

  const TriangleSides& GetSides();
  bool SetTriangle(PolygonView vertices);
  bool SetPolygon(PolygonView vertices);

  void ComputeArea();
  void ComputeEdges();
  void ComputeAngles();
  void ComputeDistances();
  void ComputeEnclosingRadius();
  void ComputeInscribedRadius();
  const std::vector<PolygonKernelFinder::Side>& GetKernel();
  void ComputeKernelArea();
  void ComputeKernelRadius();
  void ComputeCorners();
  void ComputeSideRatio();
  void ComputeBoxArea();
  void ComputeStiffness();

  std::vector<Point2> Vertices;
  bool Repeated = false;
  bool Convex = false;
  unsigned int Computed = 0;
  bool HasSides = false;
  const std::vector<PolygonKernelFinder::Side>* Kernel = nullptr;
  TriangleSides Sides;

  double Area = 0.0;
  EdgeLengths Edges;
  AngleRange Angles;
  PointPair Farthest;
  double ClosestPairDistance = 0.0;
  double EnclosingRadius = 0.0;
  double InscribedRadius = 0.0;
  double KernelArea = 0.0;
  double KernelRadius = 0.0;
  CornerShapes Corners;
  double SideRatio = 0.0;
  double BoxArea = 0.0;
  StiffnessMeasures Stiffness;

  PolygonKernelFinder KernelFinder;
  InscribedCircleFinder CircleFinder;
};

} // namespace pemesh

#endif
