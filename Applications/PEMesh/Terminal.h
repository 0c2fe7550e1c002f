// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What the command line says, and where: results on standard output, sentences and the progress
 * bar on standard error, the bar only on a terminal.
 */
#ifndef pemesh_Terminal_h
#define pemesh_Terminal_h

#include <string>

class vtkObject;

namespace pemesh
{

/** Exit codes of every command. */
enum ExitCode
{
  AllDone = 0,
  PartFailed = 1,
  WrongUsage = 2
};

/** "pemesh: message" on standard error. */
void Complain(const std::string& message);

/** Routes VTK's warnings and errors to standard error, one line each. */
void InstallMessageHandler();

/**
 * Draws the ProgressEvents of an object as a bar until it goes out of scope, where standard error
 * is a terminal; elsewhere, if it is the log of a long run, as a line every ten percent.
 */
class ProgressBar
{
public:
  ProgressBar(vtkObject* source, const std::string& label, bool inLog = false);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

private:
  void Draw(double fraction);

  vtkObject* Source;
  std::string Label;
  bool InLog;
  unsigned long Observer = 0;
  int Drawn = -1;
};

} // namespace pemesh

#endif
