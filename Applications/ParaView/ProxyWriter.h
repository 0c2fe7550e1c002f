// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The XML that tells ParaView of classes: one call a property. All texts are escaped here.
 */
#ifndef pemesh_ProxyWriter_h
#define pemesh_ProxyWriter_h

#include "Parameter.h"

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace pemesh
{

class ProxyWriter
{
public:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  void BeginGroup(const std::string& name);
  void EndGroup();

  /** Sources and filters. The name is kebab-case: "n-sided" and "Polygon" are PEMeshNSidedPolygon.
   */
  void Begin(const std::string& name, const std::string& suffix, const std::string& className,
    const std::string& label, const std::string& description);
  void End(const std::string& menu);

  /** One mesh, or another set of polygons. */
  void Input(const std::string& description);

  /** A text that is set once and not shown. */
  void Fixed(const std::string& name, const std::string& command, const std::string& value);

  /** One property a parameter of a table, set by SetParameter. */
  void Parameters(std::span<const Parameter> parameters);

  /** Several numbers without a range. */
  void Doubles(const std::string& name, const std::string& command, const std::string& defaults,
    const std::string& description);
  void Number(const std::string& name, const std::string& command, double value, double least,
    double greatest, const std::string& description);
  void Integer(const std::string& name, const std::string& command, std::int64_t value,
    std::int64_t least, std::int64_t greatest, const std::string& description);
  void Switch(const std::string& name, const std::string& command, bool value,
    const std::string& description);
  /** A number with a name for each value from 0. */
  void Enumeration(const std::string& name, const std::string& command, int value,
    const std::vector<std::string>& labels, const std::string& description);

  ///@{
  /** Texts. Where an option is given, the command takes it before the value. */
  void Text(const std::string& name, const std::string& command, const std::string& option,
    const std::string& description);
  void Choice(const std::string& name, const std::string& command, const std::string& option,
    const std::string& value, const std::vector<std::string>& choices,
    const std::string& description);
  /** Any number of the choices; `clear` is called before the first. */
  void List(const std::string& name, const std::string& command, const std::string& clear,
    const std::string& value, const std::vector<std::string>& choices,
    const std::string& description);
  ///@}

  /** The times of vtkPEMPolygonLayout, and the time steps that ParaView's slider goes by. */
  void LayoutTimes();

  /** Groups of their own: the reader and the writer of the files with these extensions. */
  void ReaderAndWriter(const std::string& extensions);

  std::string Finish();

private:
  void Property(const std::string& kind, const std::string& name, const std::string& command,
    const std::string& more, const std::string& description, const std::string& domains);

  std::string Xml = "<ServerManagerConfiguration>\n";
};

} // namespace pemesh

#endif
