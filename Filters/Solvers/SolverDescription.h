// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What PEMesh knows about an external solver: how to call it, what it can be asked and what it
 * tells. Plain data; descriptions are read from JSON in IO/Study.
 *
 * The contract: called on the mesh file M.off, the solver leaves in its output folder
 * M-solution.txt and, if it knows, M-ground-truth.txt (one finite number a vertex, in the order of
 * the vertices of the mesh), `M-<performance>.txt` with one number for each performance, "nan"
 * only if it may be undefined, and, if it likes, `M-<array>.txt` for each array of elements, one
 * number an element, "nan" where undefined. It ends with exit status 0.
 */
#ifndef pemesh_SolverDescription_h
#define pemesh_SolverDescription_h

#include <filesystem>
#include <string>
#include <vector>

namespace pemesh
{

/** Something that a run may choose: the placeholder {Name} in the command. */
struct SolverOption
{
  std::string Name;
  std::string Type = "string"; // string | integer | number
  std::string Default;
  std::string Description;
  std::vector<std::string> Choices = {}; // the values of a string; none: any
  bool operator==(const SolverOption&) const = default;
};

/** A number that the solver writes for each mesh. */
struct SolverPerformance
{
  std::string Name;
  std::string Label;
  std::string Scale = "linear"; // linear | log
  bool Measured = false;        // depends on the machine: seconds, bytes
  bool MayBeUndefined = false;  // "nan" is an answer, and no fault
  bool operator==(const SolverPerformance&) const = default;
};

/** Numbers that the solver may write for each mesh, one an element. */
struct SolverElementArray
{
  std::string Name;
  std::string Label;
  bool operator==(const SolverElementArray&) const = default;
};

struct SolverDescription
{
  std::string Name;
  std::string Label;
  /**
   * The argument list, program first; no shell sees it. Placeholders: {mesh} the mesh file, {node}
   * and {ele} the two files of the format node, {output} the output folder, {stem} the name that
   * the files written must begin with, {threads}, {folder} that of the description, and every
   * option by its name ({order}, {problem}, …). "{{" and "}}" are braces.
   *
   * A solver that takes a list has {list} in place of {mesh}, {node}, {ele}, {output} and {stem}: a
   * file with the name of one mesh file a line, relative to its current folder. For the mesh
   * D/M.off it leaves its files in D: D/M-solution.txt and so on.
   */
  std::vector<std::string> Command;
  int MeshesPerCall = 1;          // at the most, of a solver that takes a list
  std::string MeshFormat = "off"; // a name of pemesh::MeshFormats()
  std::vector<SolverOption> Options;
  std::vector<SolverPerformance> Performances;
  std::vector<SolverElementArray> Elements;
  ///@{
  /** For one mesh; 0 = none. A list has the times of all its meshes. */
  double TimeLimit = 0.0;      // seconds
  double ProcessorLimit = 0.0; // seconds of processors, of all its processes
  double MemoryLimit = 0.0;    // MiB resident, of all its processes together
  double DiskLimit = 4096.0;   // MiB, of each file and of all files in the folder of the run
  ///@}
  std::vector<std::string> VersionCommand;
  std::filesystem::path Folder; // of the description: programs named by a relative path begin here
  bool operator==(const SolverDescription&) const = default;
};

} // namespace pemesh

#endif
