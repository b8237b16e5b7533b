// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace betwixt {

// Drops the context, which the browser has taken away. The next renderer makes another one. First destroy all renderers
// of the old one.
void forget_graphics();

}  // namespace betwixt
