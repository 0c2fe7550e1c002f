// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * One thread for the dense kernels below CHOLMOD and UMFPACK while any object of this class lives;
 * then as many as there were. With more their rounding would depend on the number of threads.
 * Private to the module.
 */
#ifndef pemesh_SingleThreadedBlas_h
#define pemesh_SingleThreadedBlas_h

namespace pemesh
{

class SingleThreadedBlas
{
public:
  SingleThreadedBlas();
  ~SingleThreadedBlas();
  SingleThreadedBlas(const SingleThreadedBlas&) = delete;
  SingleThreadedBlas& operator=(const SingleThreadedBlas&) = delete;
};

} // namespace pemesh

#endif
