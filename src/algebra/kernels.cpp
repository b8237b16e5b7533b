// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/kernels.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <thread>

#include "algebra/counted.h"
#include "base/in_parallel.h"

// This file is compiled once for each kind of machine (SSSE3 without SSE4 existed until 2008 only, so it is left out).
// Vectors without a fixed size cannot be members of a Lane.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_RVV | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algebra/kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace betwixt::algebra {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

#define BETWIXT_INLINE HWY_INLINE
#include "algebra/kernel_steps.h"
#undef BETWIXT_INLINE

// `through`: bypasses the caches for drawn points, as they are not read soon.
template <Kernel kernel, bool through, class D, class Number>
HWY_INLINE void step_vector(D d, const Arrays<Number>& a, std::size_t i, const hn::Vec<D>* inputs) {
  constexpr Uses use = uses(kernel);
  Lane<hn::Vec<D>> p;
  p.x = hn::LoadU(d, a.x + i), p.y = hn::LoadU(d, a.y + i);
  if constexpr (use.second) p.u = hn::LoadU(d, a.u + i), p.v = hn::LoadU(d, a.v + i);
  if constexpr (use.gain) p.du = hn::LoadU(d, a.du + i), p.dv = hn::LoadU(d, a.dv + i);
  step<kernel>(p, inputs);
  if constexpr (use.state) hn::StoreU(p.x, d, a.x + i), hn::StoreU(p.y, d, a.y + i);
  if constexpr (use.written) hn::StoreU(p.u, d, a.u + i), hn::StoreU(p.v, d, a.v + i);
  if constexpr (use.drawn && through) hn::Stream(p.ox, d, a.ox + i), hn::Stream(p.oy, d, a.oy + i);
  if constexpr (use.drawn && !through) hn::StoreU(p.ox, d, a.ox + i), hn::StoreU(p.oy, d, a.oy + i);
}

template <Kernel k, class Number>
void step_arrays(const Arrays<Number>& a, const Number* inputs, bool through) {
  const hn::ScalableTag<Number> d;
  const std::size_t lanes = hn::Lanes(d);
  hn::Vec<decltype(d)> all[most_inputs];
  for (int i = 0; i < most_inputs; ++i) all[i] = hn::Set(d, inputs[i]);
  std::size_t i = 0;
  if (through)
    for (; i + lanes <= a.count; i += lanes) step_vector<k, true>(d, a, i, all);
  else
    for (; i + lanes <= a.count; i += lanes) step_vector<k, false>(d, a, i, all);
  step_each<k>(part(a, i, a.count), inputs);
  if (through) hwy::FlushStream();  // before another thread learns that it is there
}

template <class Number>
void step_some(Kernel kernel, const Arrays<Number>& a, const Number* inputs, bool through) {
  switch (kernel) {
#define BETWIXT_CASE(name) \
  case Kernel::name:       \
    return step_arrays<Kernel::name>(a, inputs, through);
    BETWIXT_KERNELS(BETWIXT_CASE)
#undef BETWIXT_CASE
  }
}

void step_floats(Kernel k, const Arrays<float>& a, const float* inputs, bool through) {
  step_some(k, a, inputs, through);
}
void step_doubles(Kernel k, const Arrays<double>& a, const double* inputs, bool through) {
  step_some(k, a, inputs, through);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace betwixt::algebra
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace betwixt::algebra {
namespace {

HWY_EXPORT(step_floats);
HWY_EXPORT(step_doubles);

void dispatch(Kernel k, const Arrays<float>& a, const float* inputs, bool through) {
  HWY_DYNAMIC_DISPATCH(step_floats)(k, a, inputs, through);
}
void dispatch(Kernel k, const Arrays<double>& a, const double* inputs, bool through) {
  HWY_DYNAMIC_DISPATCH(step_doubles)(k, a, inputs, through);
}

constexpr std::size_t line = 64;                            // bytes; threads do not share cache lines
constexpr std::size_t thread_share = std::size_t{1} << 19;  // fewer points do not gain from another thread
constexpr std::size_t cache = std::size_t{8} << 20;         // bytes

template <class Number>
bool whole_lines(const Arrays<Number>& a) {
  return (reinterpret_cast<std::uintptr_t>(a.ox) | reinterpret_cast<std::uintptr_t>(a.oy)) % line == 0;
}

template <class Number>
void step_threaded(Kernel kernel, const Arrays<Number>& a, const Number* inputs, unsigned most_threads) {
  const bool through = a.count * 4 * sizeof(Number) > cache && whole_lines(a);
  static const unsigned machine = std::max(1u, std::thread::hardware_concurrency());  // the query takes a microsecond
  const std::size_t most = most_threads > 0 ? std::min(most_threads, machine) : machine;
  const std::size_t threads = std::clamp<std::size_t>(a.count / thread_share, 1, most);
  constexpr std::size_t grain = line / sizeof(Number);
  const auto bound = [&](std::size_t i) { return i == threads ? a.count : a.count / threads * i / grain * grain; };
  in_parallel(threads, [&](std::size_t i) { dispatch(kernel, part(a, bound(i), bound(i + 1)), inputs, through); });
}

}  // namespace

void step_all(Kernel kernel, const Arrays<float>& a, const float* inputs, unsigned most_threads) {
  step_threaded(kernel, a, inputs, most_threads);
}
void step_all(Kernel kernel, const Arrays<double>& a, const double* inputs, unsigned most_threads) {
  step_threaded(kernel, a, inputs, most_threads);
}

namespace counting {
#define BETWIXT_INLINE inline
#include "algebra/kernel_steps.h"
#undef BETWIXT_INLINE
}  // namespace counting

void step_plainly(Kernel kernel, const Arrays<Counted>& a, const Counted* inputs) {
  switch (kernel) {
#define BETWIXT_CASE(name) \
  case Kernel::name:       \
    return counting::step_each<Kernel::name>(a, inputs);
    BETWIXT_KERNELS(BETWIXT_CASE)
#undef BETWIXT_CASE
  }
}

int operations_per_point(Kernel kernel) {
  static const auto counted = [] {
    std::array<int, kernel_count> all{};
    for (int k = 0; k < kernel_count; ++k) {
      Counted x, y, u, v, du, dv, ox, oy;
      const Counted inputs[most_inputs] = {};
      const Tally before = Counted::tally;
      step_plainly(static_cast<Kernel>(k), {&x, &y, &u, &v, &du, &dv, &ox, &oy, 1}, inputs);
      all[static_cast<std::size_t>(k)] = static_cast<int>((Counted::tally - before).operations());
      Counted::tally = before;
    }
    return all;
  }();
  return counted[static_cast<std::size_t>(kernel)];
}

}  // namespace betwixt::algebra
#endif
