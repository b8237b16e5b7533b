// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The stages that shade a point, in GLSL. Variants: TEXTURED; BALL (balls.h); GROUND: the endless floor, and what is
// behind everything, with a triangle that fills the picture; RICH: several lights cast shadows, or soft ones, or metal
// mirrors a floor or the sky.
#pragma once

namespace betwixt {

extern const char* const surface_vertex;
extern const char* const surface_fragment;

}  // namespace betwixt
