// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "SingleThreadedBlas.h"

#include <mutex>

// There when the BLAS is OpenBLAS, null when it is another (the reference BLAS has no threads).
extern "C"
{
  void openblas_set_num_threads(int) __attribute__((weak));
  int openblas_get_num_threads(void) __attribute__((weak));
}

namespace pemesh
{

namespace
{

std::mutex Mutex;
int Users = 0;
int Threads = 1;

} // namespace

SingleThreadedBlas::SingleThreadedBlas()
{
  const std::scoped_lock lock(Mutex);
  if (Users++ == 0 && openblas_get_num_threads && openblas_set_num_threads)
  {
    Threads = openblas_get_num_threads();
    openblas_set_num_threads(1);
  }
}

SingleThreadedBlas::~SingleThreadedBlas()
{
  const std::scoped_lock lock(Mutex);
  if (--Users == 0 && openblas_get_num_threads && openblas_set_num_threads)
  {
    openblas_set_num_threads(Threads);
  }
}

} // namespace pemesh
