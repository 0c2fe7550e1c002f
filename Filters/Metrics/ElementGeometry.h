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
  double GetArea();
  const EdgeLengths& GetEdges();
  const AngleRange& GetAngles();
  /** Largest and least distance of two vertices. */
  double GetDiameter();
  double GetClosestPairDistance();
  double GetEnclosingRadius();
  double GetInscribedRadius();
  /** 0 where the element is not star-shaped. */
  double GetKernelArea();
  double GetKernelRadius();
  const CornerShapes& GetCorners();
  /** See SmallestSideRatio. */
  double GetSideRatio();
  /** Area of the axis-parallel bounding box. */
  double GetBoxArea();
  const StiffnessMeasures& GetStiffness();

private:
  bool IsTriangle() const { return this->Vertices.size() == 3; }
  bool Want(unsigned int need);
  void ComputeDistances();
  double ComputeTriangleEnclosingRadius();

  std::vector<Point2> Vertices;
  bool Repeated = false;
  bool Convex = false;
  unsigned int Computed = 0;

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

  PolygonKernelClipper KernelClipper;
  InscribedCircleFinder CircleFinder;
};

} // namespace pemesh

#endif
