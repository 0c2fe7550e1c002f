// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The numbers that an entry of a table (a family, a source of meshes, a shape, a rule) is tuned by.
 *
 * Each entry lists its parameters; the filter that offers the table, the study document, the
 * command line and the documentation read their names, defaults and ranges from there.
 */
#ifndef pemesh_Parameter_h
#define pemesh_Parameter_h

#include "pemeshFiltersCoreModule.h" // For export macro

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pemesh
{

struct Parameter
{
  const char* Name;        ///< "cells": the key of studies and of SetParameter
  const char* Description; ///< one phrase, with the unit
  double Default;
  double Least;
  double Greatest; ///< may be infinite
  bool IsInteger = false;

  /** Empty if the value may be used, else one sentence that names the parameter and its range. */
  PEMESHFILTERSCORE_EXPORT std::string WhyInvalid(double value) const;
};

/** The values of the parameters of one entry, at first the defaults. */
class PEMESHFILTERSCORE_EXPORT ParameterValues
{
public:
  ParameterValues() = default;
  explicit ParameterValues(std::span<const Parameter> parameters);

  /** Empty, or one sentence on why the value was refused; nothing is changed then. */
  std::string Set(std::string_view name, double value);

  /** NaN if there is no such parameter. */
  double Get(std::string_view name) const;
  int GetInteger(std::string_view name) const { return static_cast<int>(this->Get(name)); }

  std::span<const Parameter> GetParameters() const { return this->Parameters; }

  friend bool operator==(const ParameterValues& a, const ParameterValues& b)
  {
    return a.Parameters.data() == b.Parameters.data() && a.Values == b.Values;
  }

private:
  std::span<const Parameter> Parameters;
  std::vector<double> Values;
};

/** The parameter of that name, or null. */
PEMESHFILTERSCORE_EXPORT const Parameter* FindParameter(
  std::span<const Parameter> parameters, std::string_view name);

} // namespace pemesh

#endif
