// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The powers of one matrix, each in one step: how often an environment's matrix has been applied is a number that may
// be in the thousands of millions, and M * M * ... is too slow and, rounded each time, too wrong.
//
// Column vectors as everywhere: M^2 p = M (M p).
//
// What moves by a similarity (turns about an axis, scales evenly, advances along the axis, perhaps mirrors) has closed
// forms: the angle is kept as a fraction of a turn in 64 bits, so the angle of any power is an exact integer product.
// Every other matrix has a ladder M, M^2, M^4, ...
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

  // Linear part  scale * (turn about the axis)(mirrored: * reflection along the axis). The similarity turns and scales
  // about the point `centre` of the plane through the origin across the axis; it moves `advance` along the axis.
  struct Similarity {
    Vec3 axis{0, 0, 1};       // of length 1
    std::uint64_t turns = 0;  // about it, in 2^-64 of a turn
    double scale = 1;
    double log_scale = 0;
    bool mirrored = false;
    bool centred = false;  // false: neither turns nor scales across the axis, `slide` is its motion there
    Vec3 centre, side;     // side = axis x centre
    Vec3 slide;
    double advance = 0;
  };

  // No power has an element, and no similarity a scale, above this or (a scale) below its inverse.
  static constexpr double bound = 1e18;

  Power() = default;  // of the identity
  // M is finite. A mirror is a similarity, its reflection along the axis done for odd n. Any M with a last row other
  // than (0 0 0 1) is `general`.
  explicit Power(const Mat4& m);

  // M^n, n >= 0. A turn by a whole fraction of a circle (7deg, 1/7 turn; down to 1/360000) is that fraction to 2^-65 of
  // a turn; any other is what the rounding of M leaves of it, to about 5e-16 radians: both times n.
  Mat4 operator()(std::int64_t n) const;
  // M^n between the whole numbers, for motion that is smoother than its steps; the turn takes the short way. Nothing
  // for mirrors and for general matrices.
  std::optional<Mat4> real(double n) const;

  Kind kind() const { return kind_; }
  // M^n is held at `bound`.
  bool clamped(std::int64_t n) const;
  // Of identities and translations, too; means nothing for general matrices.
  const Similarity& similarity() const { return similarity_; }

 private:
  bool classify(const Mat4& m);
  Mat4 closed(double n, std::uint64_t turns, bool odd) const;
  Mat4 climb(std::int64_t n, bool& clamped) const;

  Kind kind_ = Kind::identity;
  Similarity similarity_;
  std::shared_ptr<const std::vector<Mat4>> ladder_;  // M^(2^k); a last rung that is its own square stands for the rest
};

// For a matrix that came as numbers, perhaps from a machine with f32: the rigid motion (a turn, a mirror, a way) or,
// with an even scale, the similarity that it was before it was rounded; in M^n the small error would become a large
// one. None where M is as good as its f64, or where an element is off by 1e-7 or more: that is somebody's wish and
// stays.
struct Unrounded {
  Mat4 matrix;
  bool noticeable = false;  // off by more than products of f64 are
};
std::optional<Unrounded> unrounded(const Mat4& m);

// m with no element beyond +-Power::bound; sets `clamped` where an element has come to it.
Mat4 bounded(const Mat4& m, bool& clamped);

}  // namespace betwixt
