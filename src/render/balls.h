// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Balls without triangles. A sphere, however it is scaled, is drawn as the flat disc that its outline encloses; the
// point on the sphere is computed for each sample. Outlines and highlights are exact at any size, and the cost is that
// of the covered pixels.
//
// Seen from e, the outline of the unit sphere is the circle of the points p with p·e = 1 and |p| = 1 (from far away,
// along e: p·e = 0). A matrix that scales the sphere scales its outline too.
#pragma once

namespace betwixt {

// For vertex stages with instances: outline(corner, eye, e) returns the point of the outline, in mesh space, for a
// corner on the unit circle. `eye` is in eye space: a position and 1, or a direction and 0; `e` is the same in mesh
// space.
inline const char* const ball_outline = R"(
vec3 outline(vec2 corner, vec4 eye, out vec4 e) {
  vec3 column = vec3(row_x.x, row_y.x, row_z.x);
  vec3 from = eye.xyz - eye.w * vec3(row_x.w, row_y.w, row_z.w);
  e.xyz = vec3(dot(normal_x, from), dot(normal_y, from), dot(normal_z, from)) / dot(column, normal_x);
  e.w = eye.w;
  float far = max(dot(e.xyz, e.xyz), 1e-30);
  vec3 axis = e.xyz * inversesqrt(far);
  vec3 across = normalize(abs(axis.y) < 0.7 ? vec3(axis.z, 0.0, -axis.x) : vec3(0.0, axis.z, -axis.y));
  float radius = sqrt(max(1.0 - e.w / far, 0.0));
  return e.w / far * e.xyz + radius * (corner.x * across + corner.y * cross(axis, across));
}
)";

}  // namespace betwixt
