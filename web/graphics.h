// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace betwixt {

// The browser has taken the context away: the next renderer makes another. What was drawn with it is to be forgotten.
void forget_graphics();
unsigned graphics_generation();  // the number of the context, 0: there is none

}  // namespace betwixt
