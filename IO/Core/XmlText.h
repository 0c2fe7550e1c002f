// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * Text inside XML.
 */
#ifndef pemesh_XmlText_h
#define pemesh_XmlText_h

#include "pemeshIOCoreModule.h" // For export macro

#include <string>

namespace pemesh
{

/** `text` as it stands in an attribute or an element; control characters become blanks. */
PEMESHIOCORE_EXPORT std::string EscapeXml(const std::string& text);

} // namespace pemesh

#endif
