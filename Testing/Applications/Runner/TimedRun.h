// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A run of a study that may not hang.
 */
#ifndef pemesh_TimedRun_h
#define pemesh_TimedRun_h

#include <string>

class vtkPEMRunner;

/**
 * Runs it, and asks it to stop after far more seconds than any study of a test takes: false then.
 * A run that does not even stop ends the program, with `name` in its last words.
 */
bool RunInTime(vtkPEMRunner* runner, const std::string& name);

#endif
