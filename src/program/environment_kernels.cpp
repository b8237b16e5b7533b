// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/environment_kernels.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <numbers>

// This file is compiled once for each kind of machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "program/environment_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace betwixt::environments {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, lanes>;
using I = hn::RebindToSigned<D>;
using U = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<I>;
using VU = hn::Vec<U>;

constexpr double log_bound = 18 * std::numbers::ln10;  // of Power::bound

HWY_INLINE V number(double x) { return hn::Set(D(), x); }

// The first terms of a series, the last one first: c[0] + x c[1] + x^2 c[2] ...
template <std::size_t n>
HWY_INLINE V series(V x, const double (&c)[n]) {
  V sum = number(c[n - 1]);
  for (std::size_t i = n - 1; i-- > 0;) sum = hn::Add(hn::Mul(sum, x), number(c[i]));
  return sum;
}

constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

struct Circle {
  V sine, cosine, versine;  // versine: 1 - cosine, exact for small angles, too
};

// The whole quarters go by integers; Taylor's series for the rest, at most an eighth of a turn, end below 1e-16.
HWY_INLINE Circle circle(VU turns) {
  const D d;
  const I i;
  const U u;
  constexpr std::uint64_t eighth = std::uint64_t{1} << 61, quarter = 2 * eighth;
  const VU shifted = hn::Add(turns, hn::Set(u, eighth));  // its upper two bits count the quarters
  const VU rest = hn::Sub(hn::And(shifted, hn::Set(u, quarter - 1)), hn::Set(u, eighth));
  const V x = hn::Mul(hn::ConvertTo(d, hn::BitCast(i, rest)), number(0x1p-63 * std::numbers::pi));
  const V z = hn::Mul(x, x);

  constexpr double of_sine[] = {-1 / factorial(3),  1 / factorial(5),  -1 / factorial(7), 1 / factorial(9),
                                -1 / factorial(11), 1 / factorial(13), -1 / factorial(15)};
  constexpr double of_versine[] = {1 / factorial(2),  -1 / factorial(4),  1 / factorial(6),  -1 / factorial(8),
                                   1 / factorial(10), -1 / factorial(12), 1 / factorial(14), -1 / factorial(16)};
  const V sine = hn::Add(x, hn::Mul(hn::Mul(x, z), series(z, of_sine)));
  const V versine = hn::Mul(z, series(z, of_versine)), one = number(1), cosine = hn::Sub(one, versine);

  const VU doubled = hn::ShiftLeft<1>(shifted);
  const V sign = number(-0.0), odd = hn::BitCast(d, doubled), upper = hn::BitCast(d, shifted);
  const auto swapped = hn::RebindMask(d, hn::Lt(hn::BitCast(i, doubled), hn::Zero(i)));
  const V s = hn::Xor(hn::IfThenElse(swapped, cosine, sine), hn::And(sign, upper));
  const V c = hn::Xor(hn::IfThenElse(swapped, sine, cosine), hn::And(sign, hn::Xor(upper, odd)));
  const auto near_0 = hn::RebindMask(d, hn::Lt(shifted, hn::Set(u, quarter)));
  return {s, c, hn::IfThenElse(near_0, versine, hn::Sub(one, c))};
}

struct Growth {
  V scale, growth;  // growth: scale - 1, exact for scales near 1, too
};

// e^x = 2^k e^r, r within ln 2 / 2 of 0.
HWY_INLINE Growth exponential(V x) {
  const D d;
  const U u;
  // ln 2 in two parts; the first has so few digits that k times it is exact.
  constexpr double ln2 = 0x1.62e42fefa38p-1, ln2_rest = 0x1.ef35793c7673p-45;
  constexpr double whole = 0x1.8p52;  // added, it leaves nothing behind the point
  const V shifted = hn::Add(hn::Mul(x, number(std::numbers::log2e)), number(whole)),
          k = hn::Sub(shifted, number(whole));
  const V r = hn::Sub(hn::Sub(x, hn::Mul(k, number(ln2))), hn::Mul(k, number(ln2_rest)));
  constexpr double coefficients[] = {1 / factorial(2),  1 / factorial(3),  1 / factorial(4),  1 / factorial(5),
                                     1 / factorial(6),  1 / factorial(7),  1 / factorial(8),  1 / factorial(9),
                                     1 / factorial(10), 1 / factorial(11), 1 / factorial(12), 1 / factorial(13)};
  const V p = hn::Add(r, hn::Mul(hn::Mul(r, r), series(r, coefficients)));
  const VU exponent = hn::Add(hn::BitCast(u, shifted), hn::Set(u, 1023));
  const V power = hn::BitCast(d, hn::ShiftLeft<52>(exponent)), growth = hn::Mul(power, p);
  return {hn::Add(power, growth), hn::Add(growth, hn::Sub(power, number(1)))};
}

struct Vector {
  V x, y, z;
};

// Some lanes of a block.
struct Input {
  const Row* rows;
  std::size_t lane;
  HWY_INLINE V operator[](std::size_t row) const { return hn::Load(D(), rows[row].of.data() + lane); }
  HWY_INLINE Vector vector(std::size_t row) const { return {(*this)[row], (*this)[row + 1], (*this)[row + 2]}; }
  // How often the motion has been applied.
  HWY_INLINE VI exponent(std::int64_t step) const {
    const I i;
    return hn::Max(hn::Sub(hn::Set(i, step), hn::BitCast(i, (*this)[0])), hn::Zero(i));
  }
};
// Going through to memory is for whole lines of the cache only.
constexpr bool whole_lines = hn::MaxLanes(D()) == lanes;
template <bool through>
struct Output {
  Block* block;
  std::size_t lane;
  HWY_INLINE void put(std::size_t element, V v) const {
    double* const at = block->m[element].data() + lane;
    if constexpr (through && whole_lines)
      hn::Stream(v, D(), at);
    else
      hn::Store(v, D(), at);
  }
};

template <class Out>
HWY_INLINE void store_turn(const Out& out, Vector a, V sine, V cosine, V versine) {
  const V vx = hn::Mul(versine, a.x), vy = hn::Mul(versine, a.y), vz = hn::Mul(versine, a.z);
  const V xy = hn::Mul(vx, a.y), yz = hn::Mul(vy, a.z), zx = hn::Mul(vz, a.x);
  const V sx = hn::Mul(sine, a.x), sy = hn::Mul(sine, a.y), sz = hn::Mul(sine, a.z);
  out.put(0, hn::Add(hn::Mul(vx, a.x), cosine));
  out.put(1, hn::Sub(xy, sz));
  out.put(2, hn::Add(zx, sy));
  out.put(4, hn::Add(xy, sz));
  out.put(5, hn::Add(hn::Mul(vy, a.y), cosine));
  out.put(6, hn::Sub(yz, sx));
  out.put(8, hn::Sub(zx, sy));
  out.put(9, hn::Add(yz, sx));
  out.put(10, hn::Add(hn::Mul(vz, a.z), cosine));
}

// across * centre - sine * (axis x centre) + along * axis
template <class Out>
HWY_INLINE void store_shift(const Out& out, Vector a, Vector c, V across, V sine, V along) {
  const auto element = [&](V here, V along_axis, V u1, V v1, V u2, V v2) {
    const V side = hn::Sub(hn::Mul(u1, v1), hn::Mul(u2, v2));
    return hn::Add(hn::Sub(hn::Mul(across, here), hn::Mul(sine, side)), hn::Mul(along, along_axis));
  };
  out.put(3, element(c.x, a.x, a.y, c.z, a.z, c.y));
  out.put(7, element(c.y, a.y, a.z, c.x, a.x, c.z));
  out.put(11, element(c.z, a.z, a.x, c.y, a.y, c.x));
}

template <Form form, class Out>
HWY_INLINE void apply(std::int64_t step, const Input& in, const Out& out) {
  const D d;
  const VI exponent = in.exponent(step);
  if constexpr (form == Form::translation) {
    const V n = hn::ConvertTo(d, exponent);
    for (std::size_t row = 0; row < 3; ++row) out.put(4 * row + 3, hn::Mul(n, in[row + 1]));
    return;
  }
  const U u;
  const Circle at = circle(hn::BitCast(u, exponent) * hn::BitCast(u, in[1]));
  const Vector axis = in.vector(2);
  if constexpr (form == Form::spin) {
    store_turn(out, axis, at.sine, at.cosine, at.versine);
  } else if constexpr (form == Form::screw) {
    store_turn(out, axis, at.sine, at.cosine, at.versine);
    store_shift(out, axis, in.vector(5), at.versine, at.sine, hn::Mul(hn::ConvertTo(d, exponent), in[8]));
  } else if constexpr (form == Form::similarity) {
    // The first application is the M that later ones begin with: only those are held.
    const V n = hn::ConvertTo(d, exponent), log_scale = in[9];
    const V later = hn::Max(hn::Mul(hn::Sub(n, number(1)), log_scale), number(-log_bound));
    const Growth size = exponential(hn::IfThenElseZero(hn::Gt(n, number(0)), hn::Add(later, log_scale)));
    const V sine = hn::Mul(size.scale, at.sine), versine = hn::Mul(size.scale, at.versine);
    store_turn(out, axis, sine, hn::Mul(size.scale, at.cosine), versine);
    store_shift(out, axis, in.vector(5), hn::Sub(versine, size.growth), sine, hn::Mul(size.growth, in[8]));
  }
}

// Blocks are small pieces of memory with work between them, which the processor alone does not foresee.
constexpr std::size_t ahead = 4;

template <Form form, bool through>
void apply_all(std::int64_t step, const Row* in, std::size_t blocks, Block* out) {
  for (std::size_t b = 0; b < blocks; ++b) {
    if constexpr (through) {
      const Row* const soon = in + std::min(b + ahead, blocks - 1) * rows(form);
      for (std::size_t row = 0; row < rows(form); ++row) hwy::Prefetch(soon + row);
    }
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(D()))
      apply<form>(step, Input{in + b * rows(form), lane}, Output<through>{out + b, lane});
  }
}

template <bool through>
void evaluate_form(Form form, std::int64_t step, const Row* in, std::size_t blocks, Block* out) {
  switch (form) {
    case Form::translation:
      return apply_all<Form::translation, through>(step, in, blocks, out);
    case Form::spin:
      return apply_all<Form::spin, through>(step, in, blocks, out);
    case Form::screw:
      return apply_all<Form::screw, through>(step, in, blocks, out);
    case Form::similarity:
      return apply_all<Form::similarity, through>(step, in, blocks, out);
  }
}

void evaluate_here(Form form, std::int64_t step, const Row* in, std::size_t blocks, Block* out, bool through) {
  through ? evaluate_form<true>(form, step, in, blocks, out) : evaluate_form<false>(form, step, in, blocks, out);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace betwixt::environments
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace betwixt::environments {

HWY_EXPORT(evaluate_here);

void evaluate(Form form, std::int64_t step, const Row* in, std::size_t blocks, Block* out, bool through) {
  HWY_DYNAMIC_DISPATCH(evaluate_here)(form, step, in, blocks, out, through);
}

void settle() { hwy::FlushStream(); }

}  // namespace betwixt::environments
#endif
