// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "RankChannel.h"

namespace pemesh
{

RankChannel::~RankChannel() = default;

} // namespace pemesh
