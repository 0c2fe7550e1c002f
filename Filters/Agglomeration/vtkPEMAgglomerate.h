// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkPEMAgglomerate
 * @brief   Merges neighbouring elements of a mesh by one of several rules.
 *
 * Input port 0 : vtkPolyData, a conforming mesh of simple, counter-clockwise polygons (z is
 * ignored); the cell arrays "ElementFamily" and "PolygonId" are used where they are there.
 * Output port 0: vtkPolyData, the coarser mesh: simple, counter-clockwise polygons without holes,
 * with shared vertices, none unused, in the order of the first old element of each; cell arrays
 *   "ElementFamily", "PolygonId" (vtkIntArray) as of the input, -1 for a merged element,
 * the field data of the input, and the field numbers
 *   "ElementsBefore", "VerticesBefore": of the input (its vertices that elements use), because
 *     far fewer elements are not far fewer unknowns |
 *   "MovedArea" [length^2] that StraightVertices REMOVE_ROUNDED passed between elements, else 0.
 * Other cell and point arrays do not fit the new mesh and are dropped.
 *
 * Two elements are merged only if their common boundary is one chain of sides and they have no
 * vertex in common off it, which is decided exactly; so the area of each element is that of its
 * parts, to the bit. See AgglomerationRules.h for the rules and their references.
 *
 * Failures of one case (see CaseStatus.h): "not-agglomerable" if the mesh is not a conforming one
 * of simple elements (the message names the culprit) or has no placed polygon where the rule needs
 * one. A mesh that has failed already is passed on as it is.
 * Time: pass-through. Threads: any number of filters at once; the same bits on every run.
 * Cost: about linear in the number of elements.
 *
 * @sa vtkPEMDomainMesher
 */
#ifndef vtkPEMAgglomerate_h
#define vtkPEMAgglomerate_h

#include "pemeshFiltersAgglomerationModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the options
#include <string> // For names
#include <vector> // For names

class PEMESHFILTERSAGGLOMERATION_EXPORT vtkPEMAgglomerate : public vtkPolyDataAlgorithm
{
public:
  static vtkPEMAgglomerate* New();
  vtkTypeMacro(vtkPEMAgglomerate, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Which elements are merged: diameter, random, quality, metis or regular. Any other name is an
   * error and changes nothing. Another rule has its own parameters, at first the defaults. Default
   * diameter.
   */
  void SetRuleByName(const std::string& name);
  std::string GetRuleName() const;
  static std::vector<std::string> GetAvailableRules();
  ///@}

  ///@{
  /**
   * A number of the rule itself, such as "seed" or "max-diameter". A name that the rule does not
   * know, and a value out of its range, are errors and change nothing. NaN if there is none.
   */
  void SetParameter(const std::string& name, double value);
  double GetParameter(const std::string& name) const;
  std::vector<std::string> GetParameterNames() const;
  ///@}

  ///@{
  /**
   * The metric (see MetricRegistry.h) of which rule quality merges the worst element first, and of
   * which rule metis gives each new element the same sum. Empty: that of the rule, which is
   * ShapeRegularity for quality and none for metis. An unknown name is an error and changes
   * nothing. Default empty.
   */
  void SetMetric(const std::string& name);
  std::string GetMetric() const;
  ///@}

  ///@{
  /** Stop at this number of elements, kept ones included; 0: no such target. Default 0. */
  vtkSetClampMacro(TargetNumberOfElements, int, 0, VTK_INT_MAX);
  vtkGetMacro(TargetNumberOfElements, int);
  ///@}

  ///@{
  /**
   * Stop at this percentage of the elements of the input; 0: no such target. Without any target,
   * diameter merges as far as it may, regular in blocks of "elements-per-block", and the other
   * rules stop at 20 percent. Valid range [0, 100]. Default 0.
   */
  vtkSetClampMacro(TargetPercentage, double, 0.0, 100.0);
  vtkGetMacro(TargetPercentage, double);
  ///@}

  ///@{
  /** Whether placed polygons, those of a PolygonId of 0 or more, are never merged. Default true. */
  vtkSetMacro(KeepPolygons, bool);
  vtkGetMacro(KeepPolygons, bool);
  vtkBooleanMacro(KeepPolygons, bool);
  ///@}

  /** What becomes of straight vertices between the same two elements, or on the border. */
  enum StraightVerticesModes
  {
    KEEP = 0,          ///< they stay: elements have more vertices than corners
    REMOVE_EXACT = 1,  ///< those exactly on a line are removed; areas stay exactly as they are
    REMOVE_ROUNDED = 2 ///< those that only rounding keeps off it, too: see StraightVertices.h
  };

  ///@{
  /** Default KEEP. */
  vtkSetClampMacro(StraightVertices, int, KEEP, REMOVE_ROUNDED);
  vtkGetMacro(StraightVertices, int);
  ///@}

protected:
  vtkPEMAgglomerate();
  ~vtkPEMAgglomerate() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  struct Internals;

  std::unique_ptr<Internals> Internal; ///< rule, parameters, metric
  int TargetNumberOfElements = 0;
  double TargetPercentage = 0.0;
  bool KeepPolygons = true;
  int StraightVertices = KEEP;

  vtkPEMAgglomerate(const vtkPEMAgglomerate&) = delete;
  void operator=(const vtkPEMAgglomerate&) = delete;
};

#endif
