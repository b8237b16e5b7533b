// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/environment_kernels.h"

#include <hwy/cache_control.h>

#include <numbers>

#include "scene/power.h"

// This file is compiled once for each instruction set, without SSSE3-only machines (until 2008).
#define HWY_DISABLED_TARGETS HWY_SSSE3
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

constexpr double log_bound = 18 * std::numbers::ln10;  // logarithm of Power::bound

HWY_INLINE V number(double x) { return hn::Set(D(), x); }

// Returns the series c[0] + x c[1] + x^2 c[2] ...
template <std::size_t n>
HWY_INLINE V series(V x, const double (&c)[n]) {
  V sum = number(c[n - 1]);
  for (std::size_t i = n - 1; i-- > 0;) sum = hn::Add(hn::Mul(sum, x), number(c[i]));
  return sum;
}

constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

struct Circle {
  V sine, cosine, versine;  // versine: 1 - cosine, exact for small angles too
};

// Counts whole quarter turns in integers. Taylor series for the remaining angle, at most an eighth of a turn; their
// error is below 1e-16.
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
  V scale, growth;  // growth: scale - 1, exact for scales near 1 too
};

// Computes e^x = 2^k e^r, with r within ln 2 / 2 of 0.
HWY_INLINE Growth exponential(V x) {
  const D d;
  const U u;
  // ln 2 in two parts. The first has so few digits that k times it is exact.
  constexpr double ln2 = 0x1.62e42fefa38p-1, ln2_rest = 0x1.ef35793c7673p-45;
  constexpr double whole = 0x1.8p52;  // adding it rounds to a whole number
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

// In the coordinates `major`, u and v, which have the same handedness as x, y and z.
struct Vector {
  V x, y, z;
};

// The inputs of some lanes of a block.
struct Input {
  const Delays* delays;
  const Row* rows;
  std::size_t lane;
  HWY_INLINE V operator[](std::size_t row) const { return hn::Load(D(), rows[row].of.data() + lane); }
  // Returns how often the motion has been applied.
  HWY_INLINE VI exponent(std::int64_t step) const {
    const I i;
    const hn::Rebind<std::uint16_t, D> narrow;
    const U u;
    const hn::Rebind<std::uint32_t, D> middle;
    const auto delay = hn::PromoteTo(u, hn::PromoteTo(middle, hn::Load(narrow, delays->of.data() + lane)));
    return hn::Max(hn::Sub(hn::Set(i, step), hn::BitCast(i, delay)), hn::Zero(i));
  }
  HWY_INLINE Vector axis() const {
    const V u = (*this)[1], v = (*this)[2];
    return {hn::Sqrt(hn::Sub(hn::Sub(number(1), hn::Mul(u, u)), hn::Mul(v, v))), u, v};
  }
  HWY_INLINE Vector centre(const Vector& axis) const {
    const V u = (*this)[3], v = (*this)[4];
    return {hn::Neg(hn::Div(hn::Add(hn::Mul(axis.y, u), hn::Mul(axis.z, v)), axis.x)), u, v};
  }
};

// Maps matrix elements in the coordinates `major`, u, v to rows: element (r, c) has number 4 r + c.
struct Places {
  Places(Form form, std::size_t major) {
    const std::size_t last_column = turns(form) ? 9 : 0;
    for (std::size_t r = 0; r < 3; ++r) {
      const std::size_t row = (r + major) % 3;
      for (std::size_t c = 0; c < 3; ++c) of[4 * r + c] = 3 * row + (c + major) % 3;
      of[4 * r + 3] = last_column + row;
    }
  }
  std::array<std::size_t, 12> of;
};

// Streaming stores pay only for whole cache lines.
constexpr bool whole_lines = hn::MaxLanes(D()) == lanes;
template <bool through>
struct Output {
  const Places& places;
  Row* rows;
  std::size_t lane;
  HWY_INLINE void put(std::size_t element, V v) const {
    double* const at = rows[places.of[element]].of.data() + lane;
    if constexpr (through && whole_lines)
      hn::Stream(v, D(), at);
    else
      hn::Store(v, D(), at);
  }
};

// A result kept in registers.
struct Matrix {
  std::array<V, 12>& m;
  HWY_INLINE void put(std::size_t element, V v) const { m[element] = v; }
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

// Stores across * centre - sine * (axis x centre) + along * axis.
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

template <class Out>
HWY_INLINE void store_similarity(const Out& out, const Input& in, const Vector& axis, const Circle& at, Growth size) {
  const V sine = hn::Mul(size.scale, at.sine), versine = hn::Mul(size.scale, at.versine);
  store_turn(out, axis, sine, hn::Mul(size.scale, at.cosine), versine);
  store_shift(out, axis, in.centre(axis), hn::Sub(versine, size.growth), sine, hn::Mul(size.growth, in[5]));
}

template <Form form, class Out>
HWY_INLINE void apply(std::int64_t step, const Input& in, const Out& out) {
  const D d;
  const VI exponent = in.exponent(step);
  if constexpr (form == Form::translation) {
    const V n = hn::ConvertTo(d, exponent);
    for (std::size_t row = 0; row < 3; ++row) out.put(4 * row + 3, hn::Mul(n, in[row]));
    return;
  }
  const U u;
  const Circle at = circle(hn::BitCast(u, exponent) * hn::BitCast(u, in[0]));
  const Vector axis = in.axis();
  if constexpr (form == Form::spin) {
    store_turn(out, axis, at.sine, at.cosine, at.versine);
  } else if constexpr (form == Form::screw) {
    store_turn(out, axis, at.sine, at.cosine, at.versine);
    store_shift(out, axis, in.centre(axis), at.versine, at.sine, hn::Mul(hn::ConvertTo(d, exponent), in[5]));
  } else if constexpr (form == Form::similarity) {
    // The first application is the factor M. Only the later ones are clamped.
    const V n = hn::ConvertTo(d, exponent), log_scale = in[6];
    const V later = hn::Max(hn::Mul(hn::Sub(n, number(1)), log_scale), number(-log_bound));
    store_similarity(out, in, axis, at,
                     exponential(hn::IfThenElseZero(hn::Gt(n, number(0)), hn::Add(later, log_scale))));
  }
}

HWY_INLINE V bounded(V x) { return hn::Min(hn::Max(x, number(-Power::bound)), number(Power::bound)); }

// Computes A = M M^(n-1), with both factors and the product clamped.
HWY_INLINE void apply_held(std::int64_t step, const Input& in, const Output<false>& out) {
  const D d;
  const I i;
  const U u;
  const VI exponent = in.exponent(step);
  const auto begun = hn::RebindMask(d, hn::Gt(exponent, hn::Zero(i)));
  const VI later = hn::Max(hn::Sub(exponent, hn::Set(i, 1)), hn::Zero(i));
  const VU turns = hn::BitCast(u, in[0]);
  const V log_scale = in[6], all = hn::Mul(hn::ConvertTo(d, later), log_scale);
  const Vector axis = in.axis();
  std::array<V, 12> once, power;
  store_similarity(Matrix{once}, in, axis, circle(turns), exponential(log_scale));
  store_similarity(Matrix{power}, in, axis, circle(hn::BitCast(u, later) * turns),
                   exponential(hn::Min(hn::Max(all, number(-log_bound)), number(log_bound))));
  for (V& e : power) e = bounded(e);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 4; ++c) {
      V sum = c == 3 ? once[4 * r + 3] : hn::Zero(d);
      for (std::size_t k = 0; k < 3; ++k) sum = hn::Add(sum, hn::Mul(once[4 * r + k], power[4 * k + c]));
      out.put(4 * r + c, hn::IfThenElse(begun, bounded(sum), number(r == c ? 1 : 0)));
    }
}

// The hardware prefetcher misses these reads between that much writing, and the start of the next run.
constexpr std::size_t ahead = 96;  // rows

template <Form form, bool through>
void apply_all(const Run& run, std::int64_t step, const Row* then) {
  constexpr std::size_t height = rows(form), near = ahead / height;
  const Places places(form, run.major);
  for (std::size_t b = 0; b < run.blocks; ++b) {
    if constexpr (through) {
      // Computed as an address, not as a pointer, because it may be past the end; prefetching that is harmless.
      const std::size_t soon = b + near;
      const auto begin = reinterpret_cast<std::uintptr_t>(soon < run.blocks ? run.in : then);
      const std::uintptr_t from = begin + (soon < run.blocks ? soon : soon - run.blocks) * height * sizeof(Row);
      for (std::size_t row = 0; row < height; ++row)
        // Into the second-level cache.
        __builtin_prefetch(reinterpret_cast<const void*>(from + row * sizeof(Row)), 0, 2);
    }
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(D()))
      apply<form>(step, Input{run.delays + b, run.in + b * height, lane},
                  Output<through>{places, run.out + b * matrix_rows(form), lane});
  }
}

template <bool through>
void evaluate_form(const Run& run, std::int64_t step, const Row* then) {
  switch (run.form) {
    case Form::translation:
      return apply_all<Form::translation, through>(run, step, then);
    case Form::spin:
      return apply_all<Form::spin, through>(run, step, then);
    case Form::screw:
      return apply_all<Form::screw, through>(run, step, then);
    case Form::similarity:
      return apply_all<Form::similarity, through>(run, step, then);
  }
}

void evaluate_here(const Run& run, std::int64_t step, bool through, const Row* then) {
  through ? evaluate_form<true>(run, step, then) : evaluate_form<false>(run, step, then);
}

void evaluate_held_here(const Run& run, std::int64_t step) {
  const Places places(run.form, run.major);
  for (std::size_t b = 0; b < run.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(D()))
      apply_held(step, Input{run.delays + b, run.in + b * rows(Form::similarity), lane},
                 Output<false>{places, run.out + b * matrix_rows(Form::similarity), lane});
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace betwixt::environments
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace betwixt::environments {

HWY_EXPORT(evaluate_here);
HWY_EXPORT(evaluate_held_here);

void evaluate(const Run& run, std::int64_t step, bool through, const Row* then) {
  HWY_DYNAMIC_DISPATCH(evaluate_here)(run, step, through, then);
}

void evaluate_held(const Run& run, std::int64_t step) { HWY_DYNAMIC_DISPATCH(evaluate_held_here)(run, step); }

void settle() { hwy::FlushStream(); }

}  // namespace betwixt::environments
#endif
