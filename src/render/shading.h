// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The shader stages, in GLSL. Variants: TEXTURED; BALL (balls.h); GROUND: the infinite floor and the background, with a
// triangle over the picture; RICH: several shadows, or soft ones, or metal that reflects a floor or the sky.
#pragma once

namespace betwixt {

extern const char* const surface_vertex;
// The fragment stage is these five, one behind the other. `shadow_lookup` needs the uniforms of the shadow maps, and
// light_place. `surface_end` makes the colour of the light `sum` with its `opacity`, or of what `glows`, and ends
// main().
extern const char* const surface_inputs;
extern const char* const shadow_lookup;
extern const char* const surface_functions;
extern const char* const surface_fragment;
extern const char* const surface_end;

}  // namespace betwixt
