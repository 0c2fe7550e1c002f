// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What a person should read of the text of a VTK error.
 */
#ifndef pemesh_ErrorText_h
#define pemesh_ErrorText_h

#include "pemeshFiltersCoreModule.h" // For export macro

#include <string>

class vtkAlgorithm;

namespace pemesh
{

/**
 * The sentence in the text of vtkErrorMacro, which is "ERROR: In <file>, line <n>" and, on the
 * next line, "<class> (<address>): <sentence>". Another text is kept; line ends become blanks.
 */
PEMESHFILTERSCORE_EXPORT std::string SentenceOfError(const char* text);

/** Updates the algorithm, printing nothing: the sentence of its first error, or "". */
PEMESHFILTERSCORE_EXPORT std::string UpdateExplaining(vtkAlgorithm* algorithm);

} // namespace pemesh

#endif
