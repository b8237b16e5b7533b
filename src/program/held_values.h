// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts between values and the numbers in the array. In the array, colours are linear light, and angles are
// quaternions if `orientation`.
#pragma once

#include <optional>

#include "scene/document.h"

namespace betwixt {

int held_numbers(const Value&, bool orientation, double* out);
Value written_value(Type, const double* numbers, bool orientation);
// Returns a + w b, or the blend from a to b if `mix`; orientations turn. Returns nullopt for incompatible types.
std::optional<Value> laid_over(const Value& a, const Value& b, double w, bool mix);
// Converts a procedure's result to the type. Returns an error if it does not fit.
Result<Value> fit(const Value&, Type, const Scene&);
Vec3 to_angles(Quat);
inline Vec3 vec3(const double* n) { return {n[0], n[1], n[2]}; }

}  // namespace betwixt
