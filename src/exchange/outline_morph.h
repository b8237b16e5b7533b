// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Filled outlines between two others.
#pragma once

#include "betwixt/frame.h"
#include "scene/outline.h"

namespace betwixt {

inline double lerp(double a, double b, double s) { return (1 - s) * a + s * b; }  // exact at both ends
inline Vec3 lerp(Vec3 a, Vec3 b, double s) { return (1 - s) * a + s * b; }

bool has_outline(const Shape&);
// Return the outline between two shapes that have outlines, at s from 0 to 1. The numbers of contours and of points are
// the same at each s.
Outline contours_between(const Shape& a, const Shape& b, double s);
Mesh outline_between(const Shape& a, const Shape& b, double s);

}  // namespace betwixt
