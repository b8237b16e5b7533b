// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The background and surroundings of a document.
#pragma once

#include "betwixt/frame.h"
#include "scene/document.h"

namespace betwixt {

std::optional<Vec3> background_of(const Scene&);
Surroundings surroundings_of(const Scene&);

}  // namespace betwixt
