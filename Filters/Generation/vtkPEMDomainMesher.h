// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMDomainMesher
 * @brief   Meshes a domain around placed polygons, each of which is one element.
 *
 * Input port 0: vtkPolyData, simple polygons in the interior of the domain that do not meet, as of
 * vtkPEMPolygonLayout; the cell arrays "ElementFamily", "PolygonId" and "PolygonName" and the
 * field number "t" are used where they are there. No polygons: the bare domain is meshed.
 * Input port 1 (optional): vtkPolyData, the closed loops of the domain's boundary, as of
 * vtkPEMDomain; any simple polygon, with holes, which stay empty. Without it: [0,1]^2.
 * Output port 0: vtkPolyData, a conforming mesh of the domain of counter-clockwise, simple polygons
 * with shared vertices in double precision: first the placed polygons, in the order of the input,
 * then the triangles that fill the rest; cell arrays
 *   "ElementFamily" (vtkIntArray) as of the input, -1 for a filler |
 *   "PolygonId" (vtkIntArray) as of the input, -1 for a filler,
 * the field data of the input, and the field numbers
 *   "AttainedMinimumAngle" [degrees] smallest angle of the fillers |
 *   "MaximumArea" [length^2] the bound that the area rule gave, or the search for the target
 *   number of elements; NaN if there is none.
 *
 * The triangles form a constrained Delaunay triangulation of the domain minus the polygons, refined
 * until no triangle is larger than the area rule (and Gradation) allows or has an angle below the
 * minimum. Edges of polygons and of the domain are split where the refinement asks for it: they
 * gain straight vertices, as straight as doubles can be (exactly straight on upright and level
 * edges). The triangulation then is conforming: no vertex lies in the smallest circle through the
 * ends of an edge of a polygon or the domain that it sees; and every angle reaches the minimum,
 * unless two edges enclose a smaller one between them. With PreservePolygons no polygon edge is
 * split, with PreserveDomain none of the domain's loops: they keep exactly their own vertices, and
 * triangles that touch them, or lie where a long preserved edge leaves too little room, may keep
 * smaller angles. The area bound always holds, but near a preserved edge that is longer than the
 * side of an equilateral triangle of that area: there the side allowed is the length of the edge
 * less 1.5 times the distance to it, because smaller triangles would be flat, layer upon layer; a
 * triangle that touches such an edge may be larger still if no point would improve it.
 *
 * Failures of one case (see CaseStatus.h): "invalid-layout" if polygons cross themselves, overlap,
 * touch, leave or touch the border of the domain, or meet one of its holes (the message names them
 * and t; nothing is meshed); "invalid-domain" if the loops of input port 1 bound no domain, and the
 * failure of that input if it has one; "meshing-failed" if the mesh would be larger than
 * MaximumNumberOfElements. Time: pass-through. Threads: any number of meshers at once; the same
 * bits on every run. Cost: about linear in the number of triangles.
 *
 * References: J. Ruppert, A Delaunay refinement algorithm for quality 2-dimensional mesh
 * generation, Journal of Algorithms 18 (1995) 548-585, doi:10.1006/jagm.1995.1021.
 * J. R. Shewchuk, Delaunay refinement algorithms for triangular mesh generation, Computational
 * Geometry 22 (2002) 21-74, doi:10.1016/S0925-7721(01)00047-5.
 * G. L. Miller, S. E. Pav, N. J. Walkington, When and why Delaunay refinement algorithms work,
 * International Journal of Computational Geometry and Applications 15 (2005) 25-54,
 * doi:10.1142/S0218195905001592. A. Uengoer, Off-centers: a new type of Steiner points for
 * computing size-optimal quality-guaranteed Delaunay triangulations, Computational Geometry 42
 * (2009) 109-118, doi:10.1016/j.comgeo.2008.06.002.
 *
 * @sa vtkPEMPolygonLayout, vtkPEMDomain
 */
#ifndef vtkPEMDomainMesher_h
#define vtkPEMDomainMesher_h

#include "pemeshFiltersGenerationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For names
#include <vector> // For polygons

namespace pemesh
{
struct DomainMeshOptions;
struct Point2;
}

class PEMESHFILTERSGENERATION_EXPORT vtkPEMDomainMesher : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMDomainMesher* New();
  vtkTypeMacro(vtkPEMDomainMesher, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** How the largest area of a filling triangle follows from the placed polygons. */
  enum AreaRules
  {
    AREA_NONE = 0,          ///< no bound
    AREA_SHORTEST_EDGE = 1, ///< min(e^2 sqrt(3)/4, e^2 sin(MinimumAngle), smallest polygon area)
    AREA_DIAGONAL = 2,      ///< d^2/4, d the mean diagonal of the polygons' bounding boxes
    AREA_CONSTANT = 3       ///< MaximumArea
  };

  ///@{
  /**
   * The area rule. e is the shortest edge of all polygons; its sine term is left out where
   * MinimumAngle is 0. Without polygons, only AREA_CONSTANT bounds anything. Default
   * AREA_DIAGONAL.
   */
  vtkSetClampMacro(AreaRule, int, AREA_NONE, AREA_CONSTANT);
  vtkGetMacro(AreaRule, int);
  /** The same by name: none, shortest-edge, diagonal, constant. Any other name is an error. */
  void SetAreaRuleByName(const std::string& name);
  std::string GetAreaRuleName() const;
  ///@}

  ///@{
  /** The bound of AREA_CONSTANT [length^2]. Valid range (0, inf). Default 0.01. */
  vtkSetMacro(MaximumArea, double);
  vtkGetMacro(MaximumArea, double);
  ///@}

  ///@{
  /**
   * Smallest angle of a filling triangle, in degrees. Valid range [0, 33]: up to 20.7 the
   * refinement is proven to reach it, up to 33 it does in practice; it ends in any case, and
   * AttainedMinimumAngle says what was reached. Default 20.
   */
  vtkSetClampMacro(MinimumAngle, double, 0.0, 33.0);
  vtkGetMacro(MinimumAngle, double);
  ///@}

  ///@{
  /**
   * The number of elements wanted, polygons and triangles, to be met within 2 %; 0: off. The area
   * rule is then not used: the maximum area is searched for, and the field number "MaximumArea"
   * holds the one found. Valid range [0, 700000000]. Default 0.
   */
  vtkSetClampMacro(TargetNumberOfElements, vtkIdType, 0, 700000000);
  vtkGetMacro(TargetNumberOfElements, vtkIdType);
  ///@}

  ///@{
  /**
   * How much the wanted edge length grows per unit of distance from the polygons: triangles are
   * small at their edges and larger farther away, never beyond the area rule. A filler with its
   * centroid at x has no more area than the equilateral triangle of side
   *   min over all edges e of the placed polygons of (h_e + Gradation * distance(x, e)),
   * h_e the length of e as placed, or SizeAtPolygons. 0: no gradation, the area rule alone counts.
   * Sensible values: 0.1 to 1. Valid range [0, inf). Default 0.
   */
  vtkSetMacro(Gradation, double);
  vtkGetMacro(Gradation, double);
  ///@}

  ///@{
  /**
   * With Gradation: the edge length wanted at the polygons; 0: that of the polygon's own edges
   * there. Valid range [0, inf). Default 0.
   */
  vtkSetMacro(SizeAtPolygons, double);
  vtkGetMacro(SizeAtPolygons, double);
  ///@}

  ///@{
  /** Whether edges of placed polygons must not be split. Default false. */
  vtkSetMacro(PreservePolygons, bool);
  vtkGetMacro(PreservePolygons, bool);
  vtkBooleanMacro(PreservePolygons, bool);
  ///@}

  ///@{
  /** Whether edges of the domain's boundary must not be split. Default false. */
  vtkSetMacro(PreserveDomain, bool);
  vtkGetMacro(PreserveDomain, bool);
  vtkBooleanMacro(PreserveDomain, bool);
  ///@}

  ///@{
  /**
   * A case that needs more elements fails instead of filling the memory (about 200 bytes each).
   * Valid range [10, 700000000]: sides of elements are counted in 31 bits. Default 20000000.
   */
  vtkSetClampMacro(MaximumNumberOfElements, vtkIdType, 10, 700000000);
  vtkGetMacro(MaximumNumberOfElements, vtkIdType);
  ///@}

protected:
  vtkPEMDomainMesher();
  ~vtkPEMDomainMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  /** Empty if everything is in its valid range. */
  std::string WhyMisconfigured() const;
  pemesh::DomainMeshOptions MakeOptions(const std::vector<std::vector<pemesh::Point2>>& polygons);

  int AreaRule = AREA_DIAGONAL;
  double MaximumArea = 0.01;
  double MinimumAngle = 20.0;
  vtkIdType TargetNumberOfElements = 0;
  double Gradation = 0.0;
  double SizeAtPolygons = 0.0;
  bool PreservePolygons = false;
  bool PreserveDomain = false;
  vtkIdType MaximumNumberOfElements = 20000000;

  vtkPEMDomainMesher(const vtkPEMDomainMesher&) = delete;
  void operator=(const vtkPEMDomainMesher&) = delete;
};

#endif
