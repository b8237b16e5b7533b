// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/compiled.h"

namespace betwixt {

// Returns the camera of a film without cameras. It sees everything that ever appears, from in front and a little above.
// In a flat film it looks along -z and is 9 m high.
const Camera& own_camera(const Program::Compiled&);

}  // namespace betwixt
