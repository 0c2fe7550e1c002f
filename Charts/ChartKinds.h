// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * The table of kinds of charts: to add a kind is to add an entry, with the function that makes its
 * marks from the columns. Study documents, the command line and windows read the table.
 */
#ifndef pemesh_ChartKinds_h
#define pemesh_ChartKinds_h

#include "pemeshChartsModule.h" // For export macro

#include <span>
#include <string>
#include <vector>

namespace pemesh
{

struct ChartPicture;
struct ChartRequest;

struct ChartKind
{
  const char* Name;        // kebab-case
  const char* Label;       // for menus
  const char* Description; // one sentence
  const char* Columns;     // what they mean, for references
  bool UsesX;              // whether the abscissae are a column
  bool UsesColor;
  bool UsesLog;
  int LeastY;                       // columns of ordinates
  double Aspect;                    // height over width
  bool JoinsPoints;                 // a metric stands for its band of min, mean and max
  std::vector<std::string> Options; // of ChartOptions
  ChartPicture (*Make)(const ChartRequest& request);
};

PEMESHCHARTS_EXPORT std::span<const ChartKind> ChartKinds();

/** Null for an unknown name. */
PEMESHCHARTS_EXPORT const ChartKind* FindChartKind(const std::string& name);

PEMESHCHARTS_EXPORT std::vector<std::string> ChartKindNames();

/** Whether a kind knows an option: the limits of axes belong to all that have numbers on them. */
PEMESHCHARTS_EXPORT bool HasOption(const ChartKind& kind, const std::string& option);

} // namespace pemesh

#endif
