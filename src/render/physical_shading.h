// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The shader stages of surfaces with finishes, in GLSL. Variants: BALL (balls.h); PICTURES, PROJECTED (pictures along
// the axes); PATTERN (patterns.inc); COATED (clear coat and sheen); THROUGH (transmission); AREAS (lamps with areas or
// cones); SHADOWED; GROUND: the floor and the sky, with a triangle over the picture.
#pragma once

namespace betwixt {

// The vertex stage is surface_vertex (shading.h). The fragment stage is: physical_inputs, shadow_lookup if SHADOWED,
// pattern_shader if PATTERN, surface_functions, physical_fragment, surface_end.
extern const char* const physical_inputs;
extern const char* const physical_fragment;

}  // namespace betwixt
