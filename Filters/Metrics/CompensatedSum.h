// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * A sum of many numbers that is as exact as one rounding: the compensation of A. Neumaier, Z.
 * Angew. Math. Mech. 54 (1974) 39-51.
 */
#ifndef pemesh_CompensatedSum_h
#define pemesh_CompensatedSum_h

#include <cmath>

namespace pemesh
{

class CompensatedSum
{
public:
  void Add(double value)
  {
    const double next = this->Sum + value;
    this->Error += std::abs(this->Sum) >= std::abs(value) ? (this->Sum - next) + value
                                                          : (value - next) + this->Sum;
    this->Sum = next;
  }

  double Get() const { return this->Sum + this->Error; }

private:
  double Sum = 0.0;
  double Error = 0.0;
};

} // namespace pemesh

#endif
