// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Looking through objects.
#pragma once

#include "betwixt/program.h"

namespace betwixt::studio {

// Returns what an object sees along its -z axis. A camera has its own lens. A sun looks along its rays, without
// perspective, and sees what is in the frame.
Camera eye_of(const Program&, ObjectId, Time, const Frame&);

}  // namespace betwixt::studio
