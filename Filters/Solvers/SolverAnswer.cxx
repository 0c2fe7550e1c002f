// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SolverAnswer.h"

#include "NumberText.h"
#include "SolverDescription.h"
#include "TextFile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace pemesh
{

namespace
{

constexpr const char* SolutionSuffix = "-solution.txt";
constexpr const char* GroundTruthSuffix = "-ground-truth.txt";

std::filesystem::path AnswerFile(
  const std::filesystem::path& folder, const std::string& stem, const std::string& suffix)
{
  return folder / (stem + suffix);
}

/** A word of a file as it may stand in a message, whatever the file holds. */
std::string Printable(std::string_view word)
{
  constexpr std::size_t longest = 30;
  std::string text;
  for (const char c : word.substr(0, longest))
  {
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text + (word.size() > longest ? "…" : "");
}

/** What the numbers of a file belong to. */
struct Expected
{
  vtkIdType Count;
  const char* Each;           ///< "vertex"
  bool MayBeUndefined = true; ///< "nan" is allowed
};

/** All numbers of a file. */
vtkSmartPointer<vtkDoubleArray> ReadNumbers(
  const std::filesystem::path& path, const Expected& wanted)
{
  const vtkIdType expected = wanted.Count;
  const std::string text = ReadTextFile(path);
  auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
  numbers->SetNumberOfTuples(expected);
  const std::string_view all = text;
  constexpr std::string_view blanks = " \t\r\n";
  vtkIdType count = 0;
  std::size_t line = 1;
  std::size_t counted = 0;
  for (std::size_t begin = all.find_first_not_of(blanks); begin != std::string_view::npos;)
  {
    const std::size_t end = std::min(all.find_first_of(blanks, begin), all.size());
    const std::string_view word = all.substr(begin, end - begin);
    line += static_cast<std::size_t>(std::count(all.begin() + static_cast<std::ptrdiff_t>(counted),
      all.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    counted = begin;
    const std::optional<double> number = ParseNumber(word);
    if (!number || !(std::isfinite(*number) || (wanted.MayBeUndefined && std::isnan(*number))))
    {
      throw std::runtime_error("The file \"" + path.filename().string() +
        "\" of the solver has \"" + Printable(word) + "\" in line " + std::to_string(line) +
        ", where a finite number is expected.");
    }
    if (count < expected)
    {
      numbers->SetValue(count, *number);
    }
    ++count;
    begin = all.find_first_not_of(blanks, end);
  }
  if (count != expected)
  {
    throw std::runtime_error("The file \"" + path.filename().string() + "\" of the solver has " +
      std::to_string(count) + (count == 1 ? " number" : " numbers") + " and should have " +
      std::to_string(expected) +
      (expected == 1 ? "." : std::string(", one for each ") + wanted.Each + " of the mesh."));
  }
  return numbers;
}

/**
 * A pipe would be waited for without end, a link may lead anywhere, and a file of many gigabytes
 * would be read into memory only to be refused.
 */
void CheckFile(const std::filesystem::path& path, const Expected& expected)
{
  const std::string name = "The file \"" + path.filename().string() + "\" of the solver ";
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, error);
  if (!std::filesystem::exists(status))
  {
    throw std::runtime_error(
      "The solver has not written the file \"" + path.filename().string() + "\".");
  }
  if (!std::filesystem::is_regular_file(status))
  {
    const bool isFolder = std::filesystem::is_directory(status);
    const bool isLink = std::filesystem::is_symlink(status);
    throw std::runtime_error(name + "is a " +
      (isFolder    ? "folder"
          : isLink ? "link"
                   : "special file") +
      ", not a file.");
  }
  constexpr std::uintmax_t longestNumber = 64;
  constexpr std::uintmax_t room = 1 << 20; // for comments on one's own digits
  const std::uintmax_t most = room + longestNumber * static_cast<std::uintmax_t>(expected.Count);
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > most)
  {
    throw std::runtime_error(name + "has " + std::to_string(size) + " bytes, too many for " +
      std::to_string(expected.Count) + (expected.Count == 1 ? " number." : " numbers."));
  }
}

/** Null, with the fault told, where the file is no good. */
vtkSmartPointer<vtkDoubleArray> TakeNumbers(
  const std::filesystem::path& path, const Expected& expected, std::vector<std::string>& faults)
{
  try
  {
    CheckFile(path, expected);
    return ReadNumbers(path, expected);
  }
  catch (const std::exception& fault)
  {
    faults.emplace_back(fault.what());
    return nullptr;
  }
}

} // namespace

std::vector<std::filesystem::path> SolverAnswerFiles(const SolverDescription& description,
  const std::filesystem::path& folder, const std::string& stem)
{
  std::vector<std::filesystem::path> files{ AnswerFile(folder, stem, SolutionSuffix),
    AnswerFile(folder, stem, GroundTruthSuffix) };
  for (const SolverPerformance& performance : description.Performances)
  {
    files.push_back(AnswerFile(folder, stem, '-' + performance.Name + ".txt"));
  }
  for (const SolverElementArray& array : description.Elements)
  {
    files.push_back(AnswerFile(folder, stem, '-' + array.Name + ".txt"));
  }
  return files;
}

SolverAnswer ReadSolverAnswer(const SolverDescription& description,
  const std::filesystem::path& folder, const std::string& stem, vtkIdType vertices,
  vtkIdType elements)
{
  SolverAnswer answer;
  const Expected atVertices{ vertices, "vertex", false };
  answer.Solution =
    TakeNumbers(AnswerFile(folder, stem, SolutionSuffix), atVertices, answer.Faults);
  const std::filesystem::path truth = AnswerFile(folder, stem, GroundTruthSuffix);
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(truth, error)))
  {
    answer.GroundTruth = TakeNumbers(truth, atVertices, answer.Faults);
  }
  for (const SolverPerformance& performance : description.Performances)
  {
    const auto number = TakeNumbers(AnswerFile(folder, stem, '-' + performance.Name + ".txt"),
      { 1, "mesh", performance.MayBeUndefined }, answer.Faults);
    answer.Performances.push_back(
      number ? number->GetValue(0) : std::numeric_limits<double>::quiet_NaN());
  }
  for (const SolverElementArray& array : description.Elements)
  {
    const std::filesystem::path file = AnswerFile(folder, stem, '-' + array.Name + ".txt");
    answer.Elements.push_back(std::filesystem::exists(std::filesystem::symlink_status(file, error))
        ? TakeNumbers(file, { elements, "element" }, answer.Faults)
        : nullptr);
  }
  return answer;
}

} // namespace pemesh
