// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of a picture as columns, one place for each drawable: those of an evaluation, or the items of a frame.
#pragma once

#include <functional>
#include <optional>

#include "betwixt/evaluation.h"

namespace betwixt {

struct Columns {
  std::span<const Mat4> worlds;
  std::span<const Evaluation::Look> looks;
  std::function<const std::shared_ptr<const Shape>&(std::uint32_t)> shape;  // the shape of a number
  std::function<std::shared_ptr<const Picture>(std::uint32_t)> texture;     // may be null
  std::function<const std::shared_ptr<const Finish>&(std::uint32_t)> finish;
  std::function<const std::shared_ptr<const Gradients>&(std::uint32_t)> gradients;
  // The places that differ from the previous picture; nullopt: unknown.
  std::optional<std::span<const std::uint32_t>> changed;
  const std::vector<Light>& lights;
  const Camera& camera;
  std::optional<Vec3> background;
  Surroundings surroundings;
};

Columns columns_of(const Evaluation&);

// Returns the result of `find` for a number, or null for `none`.
template <class Find>
auto found(std::uint32_t number, const Find& find) {
  return number == Evaluation::Look::none ? std::decay_t<decltype(find(number))>() : find(number);
}

// The content of a place of the columns, with shape and texture in place of their numbers.
struct Content {
  Mat4 world;
  Evaluation::Look look;
  std::shared_ptr<const Shape> shape, toward;
  std::shared_ptr<const Picture> texture;
  std::shared_ptr<const Finish> finish;
  std::shared_ptr<const Gradients> gradients;
  friend bool operator==(const Content&, const Content&) = default;
};
Content content_of(const Columns&, std::uint32_t);

bool same_light(const Light&, const Light&);

// The content of a picture besides objects and camera.
struct Scenery {
  std::vector<Light> lights;
  std::optional<Vec3> background;
  Surroundings surroundings;
  bool plain() const { return surroundings.clear || (background && !surroundings.below); }
  bool take(const Columns&);  // returns false if nothing differs from the previous picture
};

// Columns of a frame. Owns the data that the columns point to.
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
  std::vector<std::shared_ptr<const Finish>> finishes_;
  std::vector<std::shared_ptr<const Gradients>> gradients_;
};

}  // namespace betwixt
