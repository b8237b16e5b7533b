// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/geometry.h"
namespace betwixt {
Geometry realise_blend(const Shape& a, const Shape& b, double s, int detail) { return realise(s < 1 ? a : b, detail); }
bool can_blend(const Shape&, const Shape&, std::string*) { return false; }
}  // namespace betwixt
