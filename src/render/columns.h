// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a picture is of, as columns, one place a drawable: those of an evaluation, or a frame's items laid out alike.
#pragma once

#include <functional>
#include <optional>

#include "betwixt/evaluation.h"

namespace betwixt {

struct Columns {
  std::span<const Mat4> worlds;
  std::span<const Evaluation::Look> looks;
  std::function<const std::shared_ptr<const Shape>&(std::uint32_t)> shape;  // what numbers stand for
  std::function<const std::shared_ptr<const Picture>&(std::uint32_t)> texture;
  // The places that differ from the picture before; none: nobody knows.
  std::optional<std::span<const std::uint32_t>> changed;
  const std::vector<Light>& lights;
  const Camera& camera;
  std::optional<Vec3> background;
  Surroundings surroundings;
  int part = 0, parts = 1;  // which one it is of how many that are added up
};

Columns columns_of(const Evaluation&);

// What `find` has for a number; null for none.
template <class Find>
auto found(std::uint32_t number, const Find& find) {
  return number == Evaluation::Look::none ? std::decay_t<decltype(find(number))>() : find(number);
}

// What a place of the columns holds, by itself: with what the numbers stand for in place of these.
struct Content {
  Mat4 world;
  Evaluation::Look look;
  std::shared_ptr<const Shape> shape, toward;
  std::shared_ptr<const Picture> texture;
  friend bool operator==(const Content&, const Content&) = default;
};
Content content_of(const Columns&, std::uint32_t);

// What a picture has beside things, and the camera.
struct Scenery {
  std::vector<Light> lights;
  std::optional<Vec3> background;
  Surroundings surroundings;
  bool plain() const { return surroundings.clear || (background && !surroundings.below); }
  bool take(const Columns&);  // false: nothing differs from the picture before
};

// Keeps what the columns point to.
class FrameColumns {
 public:
  explicit FrameColumns(const Frame&);
  Columns columns() const;

 private:
  const Frame& frame_;
  std::vector<Mat4> worlds_;
  std::vector<Evaluation::Look> looks_;
  std::vector<std::shared_ptr<const Shape>> shapes_;
  std::vector<std::shared_ptr<const Picture>> textures_;
};

}  // namespace betwixt
