// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gradients on meshes: for shaders, and the same on the processor.
#pragma once

#include <optional>

#include "exchange/gradient_place.h"

namespace betwixt {

// A gradient on a mesh: rows from mesh space to its own plane.
struct PlacedGradient {
  std::array<double, 4> x{}, y{};
};
PlacedGradient placed_gradient(const Gradient&, const Box& of_object, const Mat4& mesh_to_object);

// Rows from pixels (x y 1) to the plane of a gradient, with a divisor.
using PixelRows = std::array<std::array<double, 3>, 3>;
// Returns those of a gradient on the plane of its mesh at this z; nullopt if it is seen from its edge.
std::optional<PixelRows> rows_from_pixels(const PlacedGradient&, const Mat4& mesh_to_clip, int width, int height,
                                          double z);
// Returns whether a gradient goes straight up or down in the picture, to less than can be seen.
bool is_even(const Gradient&, const PixelRows&, int width);

// Light times opacity, and opacity.
struct GradientLight {
  Vec3 light;
  double opacity = 0;
  friend GradientLight operator+(const GradientLight& a, const GradientLight& b) {
    return {a.light + b.light, a.opacity + b.opacity};
  }
  friend GradientLight operator*(double s, const GradientLight& a) { return {s * a.light, s * a.opacity}; }
};

GradientLight light_of(const Gradient::Stop&);

// The colours of a gradient, by the place in its own plane. The bits are the same on every machine.
class GradientColors {
 public:
  explicit GradientColors(const Gradient&);
  GradientLight at(double x, double y) const;
  // The mean across a pixel, given what one pixel to the right and one down add to x and y: no steps where colours do
  // not go over into each other.
  GradientLight around(double x, double y, double right_x, double right_y, double down_x, double down_y) const;
  // Returns whether some of its colours do not go over into each other.
  bool has_edges() const { return edges_; }

 private:
  struct Stop {
    double at;
    GradientLight light, sum;  // sum: of everything from 0 to here
  };
  GradientLight ramp(double t) const;
  GradientLight sum_in(double t) const;
  GradientLight sum(double t) const;
  double place(double x, double y) const;

  GradientKind kind_;
  GradientSpread spread_;
  double size_;
  std::vector<Stop> stops_;
  GradientLight all_;  // the sum from 0 to 1
  bool edges_ = false;
};

// GLSL, for programs with and without GRADIENT. Of the vertex stage: place_gradient(vec4 of_mesh). Of the fragment
// stage, behind its inputs: vec4 own_color(), the colour of a part and its opacity.
extern const char* const gradient_vertex;
extern const char* const gradient_shader;
// The uniforms of a gradient; x and y are the rows of the placed gradient.
struct GradientUniforms {
  std::array<float, 4> x{}, y{}, grading{};
  std::array<std::array<float, 4>, most_stops> stop_light{};
  std::array<float, most_stops> stop_at{};
};
GradientUniforms uniforms_of(const Gradient&, const PlacedGradient&);

}  // namespace betwixt
