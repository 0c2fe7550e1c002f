// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A study: everything needed to make (or read) a family of meshes, measure them, solve on them and
 * plot the result. Plain data; StudyFile.h reads it from JSON and writes it back. The defaults here
 * are the defaults of the document, and the ranges are those of the tables in StudyFile.cxx.
 */
#ifndef pemesh_Study_h
#define pemesh_Study_h

#include "pemeshIOStudyModule.h" // For export macro

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pemesh
{

/** A value whose type is known only to whom it is meant for: a solver's option, a swept value. */
using StudyScalar = std::variant<bool, std::int64_t, double, std::string>;

/** As text, for SetOption and for messages: "true", "2", "0.5", "franke". */
PEMESHIOSTUDY_EXPORT std::string FormatScalar(const StudyScalar& value);

/** NaN for a text or a truth value. */
PEMESHIOSTUDY_EXPORT double ScalarToNumber(const StudyScalar& value);

/** Parameters of an entry of a table by name; all of them after reading. */
using StudyParameters = std::vector<std::pair<std::string, double>>;

/** One placed polygon. */
struct StudyPolygon
{
  std::string Family;
  std::string Name; // "" = named after its place in the list and its family
  std::string File; // of the family file: relative to the study
  std::vector<std::array<double, 2>> Points; // of the family points: where they are to lie
  std::array<double, 2> Center{ 0.5, 0.5 };
  double Scale = 1.0;
  double Rotation = 0.0;      // degrees
  StudyParameters Parameters; // all of its family, in its order
  double From = 0.0;          // its own deformation is From + t (To - From)
  double To = 1.0;
  bool operator==(const StudyPolygon&) const = default;
};

/** Polygons at random places, besides those that are placed. The defaults of ScatterOptions. */
struct StudyScatter
{
  int Count = 10;
  double Seed = 0.0;                 // an integer up to 2^53
  std::vector<std::string> Families; // none = all parametric ones and random
  std::string Order = "cycle";       // cycle | random
  double SmallestScale = 0.2;
  double LargestScale = 0.2;
  double LargestRotation = 360.0; // degrees
  double Gap = 0.01;
  double From = 0.0; // the deformation of each is From + t (To - From)
  double To = 1.0;
  bool operator==(const StudyScatter&) const = default;
};

/** One swept parameter: `Values` if there are any, else `Count` equidistant ones. */
struct StudySweep
{
  std::string Parameter = "t"; // t, or the path of a value of the document: "mesh.min-angle"
  std::string Name;            // of its column; never empty after reading, unique
  double From = 0.0;
  double To = 0.9;
  int Count = 20;
  std::string Spacing = "linear"; // linear | geometric
  std::vector<StudyScalar> Values;
  bool Zip = false; // advances with the sweep before it
  bool operator==(const StudySweep&) const = default;
};

/** Bound on the area of the triangles around the polygons. */
struct StudyMaximumArea
{
  std::string Rule = "diagonal"; // none | shortest-edge | diagonal | constant
  double Value = 0.0;            // of the rule constant only
  bool operator==(const StudyMaximumArea&) const = default;
};

/** The region that is meshed. */
struct StudyDomain
{
  std::string Shape = "rectangle"; // a name of the table of shapes, or file
  StudyParameters Parameters;      // of the shape
  std::string File;                // of the shape file: its loops
  bool operator==(const StudyDomain&) const = default;
};

/** A number that every mesh of the study is to have, whatever is swept. */
struct StudyTarget
{
  std::string Quantity = "none"; // none | elements | vertices | dofs
  int Value = 0;
  int Order = 1; // of the method whose degrees of freedom are counted
  bool operator==(const StudyTarget&) const = default;
};

/** How elements are merged. */
struct StudyAgglomeration
{
  std::string Rule = "none";  // none, or a name of the table of rules
  StudyParameters Parameters; // of the rule
  std::string Metric;
  int Elements = 0;        // where to stop; 0 = see Percentage
  double Percentage = 0.0; // of the elements; 0 = the rule's own
  bool KeepPolygons = true;
  std::string StraightVertices = "keep"; // keep | remove-exact | remove-rounded
  bool operator==(const StudyAgglomeration&) const = default;
};

/** How the domain is meshed. */
struct StudyMesh
{
  std::string Source =
    "triangulation";          // around the polygons, or a name of the table of tessellations
  StudyParameters Parameters; // of the tessellation
  StudyMaximumArea MaximumArea;
  double MinimumAngle = 20.0; // degrees
  bool PreservePolygons = false;
  bool PreserveDomain = false;
  double Gradation = 0.0;      // growth of the edges away from the polygons; 0 = none
  double SizeAtPolygons = 0.0; // 0 = that of the polygon's edges
  StudyTarget Target;
  int MaximumElements = 20'000'000; // more are refused before they fill the memory
  int Mirror = 0;                   // times
  std::array<int, 2> Tile{ 1, 1 };  // copies along x and y
  StudyAgglomeration Agglomeration;
  bool operator==(const StudyMesh&) const = default;
};

/** True for a mesh made by triangulating the domain around placed polygons. */
inline bool IsTriangulated(const StudyMesh& mesh)
{
  return mesh.Source == "triangulation";
}

/** One run of a solver on every mesh. */
struct StudySolver
{
  std::string Solver; // name of a description, or path of a .json file (relative to the study)
  std::string Name;   // of the run: unique in the study, leads its columns
  std::vector<std::pair<std::string, StudyScalar>> Options;
  ///@{
  /** See SolverDescription.h; unset = the description's. */
  std::optional<double> TimeLimit;
  std::optional<double> ProcessorLimit;
  std::optional<double> MemoryLimit;
  std::optional<double> DiskLimit;
  ///@}
  std::string Version; // what the solver said of itself, recorded in the results
  bool operator==(const StudySolver&) const = default;
};

/** How the results are correlated: the options of vtkPEMCorrelation. */
struct StudyStatistics
{
  std::string Coefficient = "spearman"; // a name of the table of coefficients
  std::vector<std::string> Given;       // columns that are held fixed
  std::string Family;                   // the column that tells families apart
  bool IndependentRows = false;
  int Permutations = 999;
  int Bootstrap = 0; // samples; 0 = no intervals
  double Level = 0.95;
  int Seed = 1;
  bool operator==(const StudyStatistics&) const = default;
};

/** How figures look: what differs from the style beneath. */
struct StudyStyle
{
  std::string File;                            // of a style, relative to the study; may be empty
  std::map<std::string, std::string> Settings; // on top of the file: of ChartStyle, as text
  bool operator==(const StudyStyle&) const = default;
};

/** One figure. */
struct StudyPlot
{
  std::string Kind;           // mesh | overview | one of ChartKinds()
  std::string X;              // a column
  std::vector<std::string> Y; // empty: all, where the kind allows it
  std::string Log;            // "" | x | y | xy
  std::string ColorBy;
  std::string Highlight = "none"; // none | min | max | both (mesh): the extreme elements of ColorBy
  int Case = -1;                  // which mesh (mesh, overview); negative counts from the last one
  std::vector<int> Cases;         // whose elements (kinds of elements); empty: Case
  std::map<std::string, std::string> Options; // of ChartOptions, by name, as text
  StudyStyle Style;                           // on top of that of the study
  bool Data = false;                          // also the numbers behind it, as CSV
  std::string Title;
  std::string File; // with extension png, svg or pdf; never empty after reading, unique
  bool operator==(const StudyPlot&) const = default;
};

/**
 * What is measured, and what the results tell of it. The names and their meaning are those of
 * vtkPEMMetrics and vtkPEMMetricSummary, and so are the defaults.
 */
struct StudyMetrics
{
  std::vector<std::string> Names{ "all" };
  std::vector<std::string> Mesh{ "usual" }; // numbers of whole meshes
  std::vector<std::string> Statistics{ "min", "max", "mean" };
  std::vector<std::string> Groups{ "all" };
  std::vector<double> Quantiles; // fractions in [0, 1]
  int HistogramBins = 0;         // 0: no histogram
  std::string Selection;         // of the group selected: "MinAngle:0.1:0.5", or a cell array
  bool operator==(const StudyMetrics&) const = default;
};

struct StudyOutput
{
  std::vector<std::string> Formats{ "vtp" };
  bool operator==(const StudyOutput&) const = default;
};

struct Study
{
  int Version = 1;       // of the document
  std::string WrittenBy; // program and version, recorded in the results
  std::string Name;
  std::vector<StudyPolygon> Polygons;
  std::optional<StudyScatter> Scatter;
  std::vector<std::string> Meshes; // files and globs, relative to Folder; not empty = no Polygons
  std::vector<StudySweep> Sweep;
  StudyDomain Domain;
  StudyMesh Mesh;
  StudyMetrics Metrics;
  std::vector<StudySolver> Solvers;
  StudyStatistics Statistics;
  StudyStyle Style; // of all plots
  std::vector<StudyPlot> Plots;
  StudyOutput Output;
  std::filesystem::path Folder; // of the document: what relative paths are relative to; not written
  bool operator==(const Study&) const = default;
};

/** True for a study of mesh files, false for one that makes its meshes. */
inline bool HasMeshFiles(const Study& study)
{
  return !study.Meshes.empty();
}

/**
 * The mesh files of a study in the order of its patterns, those of one pattern sorted by name
 * with numbers by value (mesh2 before mesh10), each file once. Throws std::runtime_error naming a
 * pattern that matches nothing.
 */
PEMESHIOSTUDY_EXPORT std::vector<std::filesystem::path> FindStudyMeshes(const Study& study);

} // namespace pemesh

#endif
