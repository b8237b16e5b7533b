// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document is compiled to. Every display function in use has a place in one array of numbers; the constants are
// there already, curves write theirs for the time asked. What is not numbers (texts, shapes, names) is looked up when
// wanted.
#pragma once

#include <mutex>

#include "betwixt/program.h"
#include "scene/document.h"
#include "scene/extent.h"
#include "track/curve.h"

namespace betwixt {

// Where the value of one display function of one object comes from.
struct Binding {
  FunctionId function = 0;
  std::uint8_t channels = 0;  // numbers; 0: a value that is not made of numbers
  bool orientation = false;   // a rotation held as a quaternion
  std::uint32_t offset = 0;   // of its numbers
  std::uint32_t first_curve = 0, curves = 0;
  std::int32_t steps = -1;  // events of a value that is not numbers …
  Value constant;           // … or the value for good
  bool varies() const { return curves > 0 || steps >= 0; }
};

struct CurveUse {
  Curve curve;
  std::uint32_t offset = 0;
  bool bounded = false;  // a curve that swings past what the function can be stays at that
  double low = 0, high = 0;
};

// One object, parents before children.
struct Node {
  std::uint32_t object = 0;
  std::int32_t parent = -1;  // a node
  Kind kind = Kind::group;
  bool orientation = false;
  std::uint32_t position = 0, rotation = 0, scale = 0, pivot = 0, attach = 0, display = 0, color = 0;  // offsets
  std::shared_ptr<const Shape> shape;  // where nothing of it varies
};

struct Program::Compiled {
  explicit Compiled(Document d) : document(std::move(d)) {}

  Document document;
  CurveSet set;
  std::vector<double> rest;  // the array of numbers, constants filled in
  std::vector<CurveUse> curves;
  std::vector<Steps> steps;
  std::vector<Binding> bindings;             // by object, then function
  std::vector<std::uint32_t> first_binding;  // per object, and one more
  std::vector<Binding> defaults;             // per function: where no object says otherwise
  std::vector<Node> nodes;
  std::vector<std::uint32_t> node_of;  // per object; its order is that of the objects

  const Binding& find(std::uint32_t object, FunctionId f) const;

  // Evaluation. `numbers` is the array for the time.
  std::vector<double> at(Time t) const;
  void evaluate(const CurveUse& use, Time t, double* out) const;
  void evaluate(const Binding& b, Time t, double* out) const;  // one binding alone: its numbers only
  Mat4 local(const Node& n, const double* numbers) const;
  std::vector<Mat4> worlds(Time t, const double* numbers) const;
  Shape shape(std::uint32_t object, Time t, const double* numbers) const;
  std::optional<Vec3> aim(std::uint32_t camera, Time t, const double* numbers, const std::vector<Mat4>* worlds) const;
  Between between(const Binding& b, Time t) const { return steps[static_cast<std::size_t>(b.steps)].at(t); }
  const Value& value(const Binding& b, Time t) const;  // the one that holds at t

  void add_items(Frame&, const double* numbers, const std::vector<Mat4>& worlds) const;
  void add_lights(Frame&, const double* numbers, const std::vector<Mat4>& worlds) const;
  Camera camera(Time t, const double* numbers, const std::vector<Mat4>& worlds) const;

  Extent stage() const;
  // The camera of documents that have none: sees all that is ever seen, from in front and a little above.
  const Camera& own_camera() const;
  mutable std::once_flag own_camera_once;
  mutable Camera own_camera_made;
};

inline Vec3 vec3(const double* n) { return {n[0], n[1], n[2]}; }

// A rigid motion: at `eye`, the -z axis towards `target`, y up as far as may be.
Mat4 look_at(Vec3 eye, Vec3 target);

}  // namespace betwixt
