// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The icons, drawn as lines of one width in the colour of the text, sharp at any size.
 */
#ifndef pemesh_Icons_h
#define pemesh_Icons_h

#include <QIcon>

namespace pemesh
{

/** The icon of that name in the table of Icons.cxx; an empty one for another name. */
QIcon MakeIcon(const char* name);

/** A picture of a polygon family at a deformation, in the colour of its class. */
QIcon MakeFamilyIcon(int family, double t, int size);

} // namespace pemesh

#endif
