// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * What PEMesh (ChildProcess.cxx) and pemesh-supervise (Applications/Supervisor) agree upon; the
 * call and the report are told in the latter's main.cxx. Private to the two.
 */
#ifndef pemesh_SupervisorProtocol_h
#define pemesh_SupervisorProtocol_h

namespace pemesh
{

///@{
/** Descriptors that the supervisor finds open. */
inline constexpr int ControlDescriptor = 3;
inline constexpr int ReportDescriptor = 4;
///@}

///@{
/** The first words of the two lines of a report, the second of which is one of the endings. */
inline constexpr const char* StartedWord = "started";
inline constexpr const char* NotStartedWord = "not-started";
inline constexpr const char* ExitedWord = "exited";
inline constexpr const char* SignalWord = "signal";
inline constexpr const char* TimeWord = "time";
inline constexpr const char* ProcessorWord = "cpu";
inline constexpr const char* MemoryWord = "memory";
inline constexpr const char* AskedWord = "asked";
///@}

} // namespace pemesh

#endif
