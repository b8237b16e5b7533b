// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What can be told of a film only when the whole of it has been read: what it says and nobody will see.
#pragma once

#include "scene/document.h"

namespace betwixt {

void look_over(const Scene&, Diagnostics& out);

}  // namespace betwixt
