// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Powers of one matrix, each in one step. The number of updates of an environment may be thousands of millions;
// M * M * ... would be too slow, and its rounding errors too large.
//
// Column vectors as everywhere: M^2 p = M (M p).
//
// A similarity (rotation about an axis, uniform scale, translation along the axis, perhaps a reflection) has closed
// forms: its angle is a fraction of a turn in 64 bits, so the angle of any power is an exact integer product. Every
// other matrix has a ladder M, M^2, M^4, ...
//
// Source: Animation Imaging Model 2.2.4 (A = M^(n+1)).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "betwixt/math.h"

namespace betwixt {

class Power {
 public:
  enum class Kind : std::uint8_t { identity, translation, similarity, general };

  // Its linear part is scale * (rotation about the axis)(mirrored: * reflection along the axis). It rotates and scales
  // about the point `centre` of the plane through the origin perpendicular to the axis; it moves `advance` along the
  // axis.
  struct Similarity {
    Vec3 axis{0, 0, 1};       // of length 1
    std::uint64_t turns = 0;  // the angle, in 2^-64 of a turn
    double scale = 1;
    double log_scale = 0;
    bool mirrored = false;
    bool centred = false;  // false: it neither rotates nor scales across the axis; `slide` is its translation there
    Vec3 centre, side;     // side = axis x centre
    Vec3 slide;
    double advance = 0;
  };

  // The limit of elements of a power and of the scale of a similarity (of the scale also 1 / bound).
  static constexpr double bound = 1e18;

  Power() = default;  // the identity
  // M must be finite. A matrix with a reflection is a similarity that reflects along the axis for odd n. A matrix whose
  // last row is not (0 0 0 1) is `general`.
  explicit Power(const Mat4& m);

  // Returns M^n, n >= 0. If the angle is a whole fraction of a turn (7deg, 1/7 turn; down to 1/360000), it is exact to
  // 2^-65 of a turn; any other is as exact as the rounding of M allows, about 5e-16 radians. Both errors times n.
  Mat4 operator()(std::int64_t n) const;
  // Returns M^n for any n, for motion that is smoother than its steps; the rotation takes the short way. Returns
  // nullopt for reflections and general matrices.
  std::optional<Mat4> real(double n) const;

  Kind kind() const { return kind_; }
  // Returns whether M^n is limited by `bound`.
  bool clamped(std::int64_t n) const;
  // Valid for the identity and translations too, but not for general matrices.
  const Similarity& similarity() const { return similarity_; }

 private:
  bool classify(const Mat4& m);
  Mat4 closed(double n, std::uint64_t turns, bool odd) const;
  Mat4 climb(std::int64_t n, bool& clamped) const;

  Kind kind_ = Kind::identity;
  Similarity similarity_;
  std::shared_ptr<const std::vector<Mat4>>
      ladder_;  // M^(2^k); a last rung that is its own square stands for all later ones
};

// For a matrix given as numbers, perhaps in f32: the rigid motion (a rotation, reflection or translation), or with a
// uniform scale the similarity, that it was before rounding, since in M^n the small error would grow. nullopt if M is
// as exact as f64, or if an element is off by 1e-7 or more: then it is intended.
struct Unrounded {
  Mat4 matrix;
  bool noticeable = false;  // off by more than products in f64 are
};
std::optional<Unrounded> unrounded(const Mat4& m);

// Returns m with all elements limited to +-Power::bound; sets `clamped` if an element reaches it.
Mat4 bounded(const Mat4& m, bool& clamped);

}  // namespace betwixt
