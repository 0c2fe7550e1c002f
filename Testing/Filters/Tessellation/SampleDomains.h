// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Domains that are easy and hard to cut meshes off at.
 */
#ifndef pemesh_SampleDomains_h
#define pemesh_SampleDomains_h

#include "Domain.h"

#include <string>
#include <vector>

struct SampleDomain
{
  std::string Name;
  pemesh::Domain Region;
};

pemesh::Domain RectangleDomain(double west, double south, double east, double north);
pemesh::Domain RegularDomain(double x, double y, double radius, int vertices, double turn = 0.0);

/** Rectangles, an L, a triangle, a disc, combs, rings, holes of all sizes and places. */
std::vector<SampleDomain> SampleDomains();

#endif
