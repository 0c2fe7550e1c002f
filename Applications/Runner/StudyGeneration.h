// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The part of a pipeline that makes the meshes of a study, or reads them.
 *
 *     domain -> polygon layout -> domain mesher \
 *     domain -> tessellation --------------------> tile -> mirror -> agglomeration
 *     mesh reader ------------------------------/
 */
#ifndef pemesh_StudyGeneration_h
#define pemesh_StudyGeneration_h

#include <string>
#include <vector>

#include <vtkNew.h> // For the filters

class vtkAlgorithm;
class vtkPEMAgglomerate;
class vtkPEMDomain;
class vtkPEMDomainMesher;
class vtkPEMMeshReader;
class vtkPEMMirror;
class vtkPEMPolygonLayout;
class vtkPEMTessellation;
class vtkPEMTile;

namespace pemesh
{

struct Study;
struct StudyAgglomeration;

/** Sets what the study says of the domain. */
void ConfigureDomain(const Study& study, vtkPEMDomain* domain);

class StudyGeneration
{
public:
  StudyGeneration();
  ~StudyGeneration();

  /** All filters that may be part of it. */
  std::vector<vtkAlgorithm*> GetFilters();

  /**
   * Sets what the study says, and connects what it needs; answers with the last filter. What does
   * not change stays up to date.
   */
  vtkAlgorithm* Configure(const Study& study);

  /** Why the polygons of the study cannot be placed, one sentence; empty if they can. */
  const std::string& GetLayoutFault() const { return this->LayoutFault; }

  /** In place of the study's rule, until it is configured again. */
  void SetMaximumArea(double area);

  /** Of the domain; that of the unit square where there is none. */
  double GetDomainArea();

private:
  vtkAlgorithm* ConfigureReader(const Study& study);
  vtkAlgorithm* ConfigureMesher(const Study& study);
  vtkAlgorithm* ConfigureTessellation(const Study& study);
  vtkAlgorithm* ConfigureSource(const Study& study);
  void ConfigureAgglomeration(const StudyAgglomeration& agglomeration);

  std::string LayoutFault;
  vtkNew<vtkPEMMeshReader> Reader;
  vtkNew<vtkPEMDomain> Domain;
  vtkNew<vtkPEMPolygonLayout> Layout;
  vtkNew<vtkPEMDomainMesher> Mesher;
  vtkNew<vtkPEMTessellation> Tessellation;
  vtkNew<vtkPEMTile> Tile;
  vtkNew<vtkPEMMirror> Mirror;
  vtkNew<vtkPEMAgglomerate> Agglomeration;
};

} // namespace pemesh

#endif
