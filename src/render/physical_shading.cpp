// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/physical_shading.h"

namespace betwixt {

const char* const physical_inputs = R"(
#if defined(GROUND)
in vec2 at;
uniform vec4 floor_color;  // and 1, or 0 where there is none
uniform float floor_height;
uniform vec3 ray, ray_x, ray_y, from_x, from_y;
uniform vec3 top, bottom;  // of the background
uniform vec2 shape;        // 1: the background bends; 1: the sky is seen
uniform float empty;
uniform sampler2D seen;    // the sky as it is seen (equirectangular)
uniform vec4 disc;         // towards the sun; the radius of its disc one metre away
uniform vec3 disc_color;
#else
in vec3 at, facing, local, local_facing;
#if defined(PICTURES)
in vec2 place;
#endif
flat in vec4 paint;
flat in vec2 gloss;
#endif
uniform vec4 toward_eye;
uniform vec4 part_color;
uniform vec3 fog_color;
uniform vec2 fog_range;
uniform int lights;
uniform vec4 light_place[16];
uniform vec4 light_color[16];
uniform vec4 light_aim[16];     // where a lamp shines to; the cosine of half its cone, -2 without
uniform vec4 light_across[16];  // the direction of its width; half of that
uniform vec4 light_form[16];    // half its height; 0 a point, 1 a disc, 2 a rectangle; 1 / the cone's edge
uniform vec4 sky_turn;          // cosine and sine of its turn; factor of its light; 1: there is fog before it
uniform vec3 irradiance[9];
uniform samplerCube around;     // blurred for each roughness
uniform float blurs;            // the number of its levels, or 0 if it is not blurred
#if defined(PROJECTS)
uniform sampler2D slide;        // what one lamp with a cone projects
uniform vec2 slide_of;          // that lamp; 1 / the width of the cone one metre away
#endif
#if defined(RECEIVES)
uniform float receives;
#endif
uniform float encodes;
#if defined(SHADOWED)
uniform sampler2DArrayShadow shadows;
uniform float shadow_step;
uniform mat4 shadow_clip[MAPS];
uniform vec4 shadow_shape[MAPS];
uniform int shadow_end[CASTERS];
uniform int casting;
uniform sampler2DArray depths;
uniform vec3 seeds[SEEDS];
#endif
#if !defined(GROUND)
uniform float has_finish;  // 0: the instance's own shininess and material
uniform vec4 base_finish;  // metalness, roughness, specular factor, normal strength
uniform vec3 emission;
#if defined(PICTURES)
uniform sampler2D picture, normals, roughness_map, metalness_map, occlusion_map, emission_map;
uniform vec4 tile;  // how often pictures repeat, and how far they are moved
uniform vec2 turned;  // cosine and sine
#endif
#if defined(PATTERN)
uniform int pattern_kind, pattern_points;  // 3 points, or 1 for a pattern without bumps
uniform vec3 second;
uniform float bumps;
uniform vec4 pattern_tile;
uniform vec2 pattern_move;
#endif
#if defined(COATED)
uniform vec2 coat;
uniform vec4 sheen;
#endif
#if defined(THROUGH)
uniform vec4 through;  // transmission, index of refraction, thickness, width of `behind_it` over 1024
uniform sampler2D behind_it;
uniform highp sampler2D behind_depth;
uniform mat4 clip_again;
#endif
#if defined(BALL)
uniform float ball_radius;  // in object space
in vec3 disc;
flat in vec4 e;
flat in vec3 move, turn;
#endif
#endif
uniform vec4 depth_row, w_row;
out vec4 color;
)";

}  // namespace betwixt
