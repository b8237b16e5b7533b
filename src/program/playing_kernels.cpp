// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>

#include "program/playing.h"

// This file is compiled once for each instruction set, without SSSE3-only machines (until 2008), and without scalable
// vectors, which cannot be array elements.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_RVV | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "program/playing_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace betwixt::playing {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Four numbers: a curve's channels or a matrix column. Narrow machines take two at a time.
using Four = hn::CappedTag<double, 4>;
using VFour = hn::Vec<Four>;
// The same number of several objects.
constexpr std::size_t widest = 8;
using Many = hn::CappedTag<double, widest>;
using V = hn::Vec<Many>;

HWY_INLINE VFour of_four(double x) { return hn::Set(Four(), x); }

// A mask of the lanes below a count.
alignas(64) constexpr double below[5][4] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 0}, {1, 1, 1, 1}};

// Writes the first `count` of four numbers. Returns true if any bit changed.
HWY_INLINE bool put(VFour now, std::size_t lane, std::size_t count, double* at) {
  const Four d;
  const hn::RebindToUnsigned<Four> u;
  const auto mine = hn::Gt(hn::Load(d, below[count] + lane), hn::Zero(d));
  const VFour was = hn::LoadU(d, at + lane), is = hn::IfThenElse(mine, now, was);
  hn::StoreU(is, d, at + lane);
  return !hn::AllTrue(u, hn::Eq(hn::BitCast(u, was), hn::BitCast(u, is)));
}

std::size_t play_here(const Segment* all, std::span<const std::uint32_t> which, std::int64_t t, double* numbers,
                      Marks& marks, std::uint32_t* left) {
  const Four d;
  std::size_t lefts = 0;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const Segment& s = all[which[i]];
    if (!s.has(t) || s.bounded) {
      left[lefts++] = static_cast<std::uint32_t>(i);
      continue;
    }
    const VFour x = of_four(s.share(t));
    bool other = false;
    for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(d)) {
      const auto c = [&](std::size_t power) HWY_ATTR { return hn::LoadU(d, s.c[power] + lane); };
      const VFour at = hn::Add(hn::Mul(hn::Add(hn::Mul(hn::Add(hn::Mul(c(3), x), c(2)), x), c(1)), x), c(0));
      other |= put(at, lane, s.channels, numbers + s.offset);
    }
    if (other) marks.add(s.node, s.affects);
  }
  return lefts;
}

HWY_INLINE V number(double x) { return hn::Set(Many(), x); }
HWY_INLINE V half(V x) { return hn::Mul(x, number(0.5)); }

struct Turned {
  V sine, cosine;
};

// Equals sine_cosine() for angles within a million, operation by operation.
HWY_INLINE Turned sine_cosine_of(V angle) {
  const Many d;
  const hn::RebindToSigned<Many> i;
  constexpr double quarters = 0.63661977236758134308, first = 1.57079632673412561417e+00,
                   second = 6.07710050630396597660e-11, third = 2.02226624879595063154e-21, shift = 0x1.8p52;
  const auto step = [](V z, V sum, double c) HWY_ATTR { return hn::Add(number(c), hn::Mul(z, sum)); };
  const V shifted = hn::Add(hn::Mul(angle, number(quarters)), number(shift)), n = hn::Sub(shifted, number(shift));
  const V x = hn::Sub(hn::Sub(hn::Sub(angle, hn::Mul(n, number(first))), hn::Mul(n, number(second))),
                      hn::Mul(n, number(third)));
  const V z = hn::Mul(x, x);
  V s = hn::Add(number(-2.50507602534068634195e-08), hn::Mul(z, number(1.58969099521155010221e-10)));
  s = step(z, s, 2.75573137070700676789e-06);
  s = step(z, s, -1.98412698298579493134e-04);
  s = step(z, s, 8.33333333332248946124e-03);
  s = step(z, s, -1.66666666666666324348e-01);
  const V sine = hn::Add(x, hn::Mul(hn::Mul(x, z), s));
  V c = hn::Sub(number(2.08757232129817482790e-09), hn::Mul(z, number(1.13596475577881948265e-11)));
  c = step(z, c, -2.75573143513906633035e-07);
  c = step(z, c, 2.48015872894767294178e-05);
  c = step(z, c, -1.38888888888741095749e-03);
  c = step(z, c, 4.16666666666666019037e-02);
  const V cosine = hn::Sub(number(1), hn::Sub(hn::Mul(number(0.5), z), hn::Mul(hn::Mul(z, z), c)));
  // The quarter is in the low bits of the shifted number.
  const auto quarter = hn::BitCast(i, shifted), one = hn::Set(i, 1), two = hn::Set(i, 2);
  const auto si = hn::BitCast(i, sine), ci = hn::BitCast(i, cosine);
  const auto swapped = hn::And(hn::Xor(si, ci), hn::Neg(hn::And(quarter, one)));
  const auto sine_sign = hn::ShiftLeft<62>(hn::And(quarter, two)),
             cosine_sign = hn::ShiftLeft<62>(hn::And(hn::Add(quarter, one), two));
  return {hn::BitCast(d, hn::Xor(hn::Xor(si, swapped), sine_sign)),
          hn::BitCast(d, hn::Xor(hn::Xor(ci, swapped), cosine_sign))};
}

struct Turn {
  V w, x, y, z;
};

HWY_INLINE Turn turn_of(const V* angles) {
  const Turned x = sine_cosine_of(half(angles[0])), y = sine_cosine_of(half(angles[1])),
               z = sine_cosine_of(half(angles[2]));
  const Turn xy{hn::Mul(x.cosine, y.cosine), hn::Mul(x.sine, y.cosine), hn::Mul(x.cosine, y.sine),
                hn::Mul(x.sine, y.sine)};
  const auto sum = [](V a, V b, V c, V d) HWY_ATTR { return hn::Add(hn::Mul(a, b), hn::Mul(c, d)); };
  const auto difference = [](V a, V b, V c, V d) HWY_ATTR { return hn::Sub(hn::Mul(a, b), hn::Mul(c, d)); };
  return {difference(xy.w, z.cosine, xy.z, z.sine), sum(xy.x, z.cosine, xy.y, z.sine),
          difference(xy.y, z.cosine, xy.x, z.sine), sum(xy.z, z.cosine, xy.w, z.sine)};
}

// The numbers of an object: position, rotation (three or four), scale, pivot. Then the number of results.
enum Input : std::size_t { position = 0, rotation = 3, scale = 7, pivot = 10, inputs = 13 };
constexpr std::size_t outputs = 16;

HWY_INLINE void matrix_of(const Turn& q, const V* in, V* out) {
  const V one = number(1), two = number(2);
  const auto on = [&](V a, V b, V c, V d)
                      HWY_ATTR { return hn::Sub(one, hn::Mul(two, hn::Add(hn::Mul(a, b), hn::Mul(c, d)))); };
  const auto off = [&](V a, V b, V c, V d, bool minus) HWY_ATTR {
    const V ab = hn::Mul(a, b), cd = hn::Mul(c, d);
    return hn::Mul(two, minus ? hn::Sub(ab, cd) : hn::Add(ab, cd));
  };
  const V r[3][3] = {{on(q.y, q.y, q.z, q.z), off(q.x, q.y, q.w, q.z, true), off(q.x, q.z, q.w, q.y, false)},
                     {off(q.x, q.y, q.w, q.z, false), on(q.x, q.x, q.z, q.z), off(q.y, q.z, q.w, q.x, true)},
                     {off(q.x, q.z, q.w, q.y, true), off(q.y, q.z, q.w, q.x, false), on(q.x, q.x, q.y, q.y)}};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < 3; ++i) out[3 * c + i] = hn::Mul(r[i][c], in[scale + c]);
  for (std::size_t i = 0; i < 3; ++i) {
    const V turned = hn::Add(hn::Add(hn::Mul(out[i], in[pivot]), hn::Mul(out[3 + i], in[pivot + 1])),
                             hn::Mul(out[6 + i], in[pivot + 2]));
    out[9 + i] = hn::Sub(hn::Add(in[position + i], in[pivot + i]), turned);
  }
  out[12] = q.w, out[13] = q.x, out[14] = q.y, out[15] = q.z;
}

void place_here(const Offsets* offsets, std::span<const std::uint32_t> nodes, const double* numbers, Own* results) {
  const Many d;
  const std::size_t lanes = hn::Lanes(d);
  alignas(64) double gathered[inputs][widest] = {};
  alignas(64) double scattered[outputs][widest];
  for (std::size_t first = 0; first < nodes.size(); first += lanes) {
    const std::size_t count = std::min(lanes, nodes.size() - first);
    const bool orientation = offsets[nodes[first]].orientation;
    for (std::size_t lane = 0; lane < count; ++lane) {
      const Offsets& o = offsets[nodes[first + lane]];
      for (std::size_t i = 0; i < 3; ++i) gathered[position + i][lane] = numbers[o.position + i];
      for (std::size_t i = 0; i < 4; ++i) gathered[rotation + i][lane] = numbers[o.rotation + i];
      for (std::size_t i = 0; i < 3; ++i) gathered[scale + i][lane] = numbers[o.scale + i];
      for (std::size_t i = 0; i < 3; ++i) gathered[pivot + i][lane] = numbers[o.pivot + i];
    }
    V in[inputs], out[outputs];
    for (std::size_t i = 0; i < inputs; ++i) in[i] = hn::Load(d, gathered[i]);
    Turn q{in[rotation], in[rotation + 1], in[rotation + 2], in[rotation + 3]};
    if (!orientation) {
      q = turn_of(in + rotation);
      // The scalar function takes larger angles.
      const auto large = [&](V a) HWY_ATTR { return hn::Not(hn::Lt(hn::Abs(half(a)), number(1e6))); };
      if (!hn::AllFalse(d, hn::Or(hn::Or(large(in[rotation]), large(in[rotation + 1])), large(in[rotation + 2])))) {
        alignas(64) double w[4][widest];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          const Quat one =
              from_angles({gathered[rotation][lane], gathered[rotation + 1][lane], gathered[rotation + 2][lane]});
          w[0][lane] = one.w, w[1][lane] = one.x, w[2][lane] = one.y, w[3][lane] = one.z;
        }
        q = {hn::Load(d, w[0]), hn::Load(d, w[1]), hn::Load(d, w[2]), hn::Load(d, w[3])};
      }
    }
    matrix_of(q, in, out);
    for (std::size_t i = 0; i < outputs; ++i) hn::Store(out[i], d, scattered[i]);
    for (std::size_t lane = 0; lane < count; ++lane) {
      Own& r = results[first + lane];
      for (std::size_t i = 0; i < 12; ++i) r.m[i] = scattered[i][lane];
      r.turn = {scattered[12][lane], scattered[13][lane], scattered[14][lane], scattered[15][lane]};
    }
  }
}

void follow_here(std::span<const Link> links, const double* numbers, const Own* owns, Mat4* worlds, Marks& marks) {
  const Four d;
  constexpr std::size_t ahead = 8;
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (k + ahead < links.size()) {
      const std::uint32_t soon = links[k + ahead].node;
      __builtin_prefetch(&owns[soon]), __builtin_prefetch(owns[soon].m + 8);
      __builtin_prefetch(&worlds[soon], 1), __builtin_prefetch(worlds[soon].m.data() + 8, 1);
    }
    const Link& l = links[k];
    const double *own = owns[l.node].m, *above = worlds[l.parent].m.data(), *attach = numbers + l.attach;
    double* world = worlds[l.node].m.data();
    bool other = false;
    for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(d)) {
      const VFour a = hn::LoadU(d, above + lane), b = hn::LoadU(d, above + 4 + lane),
                  c = hn::LoadU(d, above + 8 + lane);
      const auto sum = [&](double x, double y, double z) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(a, of_four(x)), hn::Mul(b, of_four(y))), hn::Mul(c, of_four(z)));
      };
      for (std::size_t column = 0; column < 3; ++column)
        other |= put(sum(own[3 * column], own[3 * column + 1], own[3 * column + 2]), lane, 3, world + 4 * column);
      const VFour moved = sum(own[9] + attach[0], own[10] + attach[1], own[11] + attach[2]);
      other |= put(hn::Add(moved, hn::LoadU(d, above + 12 + lane)), lane, 3, world + 12);
    }
    if (other) marks.add(l.node, 1);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace betwixt::playing
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace betwixt::playing {

void Marks::in_order(std::uint32_t end, std::vector<std::uint32_t>& out) const {
  out.clear();
  const auto marked = all();
  if (std::is_sorted(marked.begin(), marked.end())) {
    out.assign(marked.begin(), std::lower_bound(marked.begin(), marked.end(), end));
  } else if (marked.size() < end / 64) {
    std::copy_if(marked.begin(), marked.end(), std::back_inserter(out), [&](std::uint32_t one) { return one < end; });
    std::sort(out.begin(), out.end());
  } else {
    for (std::uint32_t one = 0; one < end; ++one)
      if (how_[one] != 0) out.push_back(one);
  }
}

void Marks::take_back(std::uint32_t one) {
  if (how_[one] == 0) return;
  how_[one] = 0;
  std::swap(*std::find(which_.begin(), which_.end(), one), which_[--count_]);
}

HWY_EXPORT(play_here);
HWY_EXPORT(place_here);
HWY_EXPORT(follow_here);

std::size_t play(const Segment* all, std::span<const std::uint32_t> which, std::int64_t t, double* numbers,
                 Marks& marks, std::uint32_t* left) {
  return HWY_DYNAMIC_DISPATCH(play_here)(all, which, t, numbers, marks, left);
}
void place(const Offsets* offsets, std::span<const std::uint32_t> nodes, const double* numbers, Own* out) {
  HWY_DYNAMIC_DISPATCH(place_here)(offsets, nodes, numbers, out);
}
void follow(std::span<const Link> links, const double* numbers, const Own* owns, Mat4* worlds, Marks& marks) {
  HWY_DYNAMIC_DISPATCH(follow_here)(links, numbers, owns, worlds, marks);
}

}  // namespace betwixt::playing
#endif
