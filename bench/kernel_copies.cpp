// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "kernel_copies.h"

#include <thread>
#include <vector>

// This file is compiled once for each kind of machine.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernel_copies.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace betwixt::algebra {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

template <Kernel kernel, bool through, class Number>
void copy_arrays(const Arrays<Number>& a) {
  constexpr Uses use = uses(kernel);
  const hn::ScalableTag<Number> d;
  for (std::size_t i = 0; i + hn::Lanes(d) <= a.count; i += hn::Lanes(d)) {
    const auto x = hn::LoadU(d, a.x + i), y = hn::LoadU(d, a.y + i);
    auto ox = x, oy = y;
    if constexpr (use.second) {
      const auto u = hn::LoadU(d, a.u + i), v = hn::LoadU(d, a.v + i);
      ox = u, oy = v;
      if constexpr (use.gain) ox = hn::Or(u, hn::LoadU(d, a.du + i)), oy = hn::Or(v, hn::LoadU(d, a.dv + i));
      if constexpr (use.written) hn::StoreU(v, d, a.u + i), hn::StoreU(u, d, a.v + i);
    }
    if constexpr (use.state && use.drawn) hn::StoreU(y, d, a.x + i), hn::StoreU(x, d, a.y + i);
    if constexpr (use.state && !use.drawn) hn::StoreU(oy, d, a.x + i), hn::StoreU(ox, d, a.y + i);
    if constexpr (use.drawn && through) hn::Stream(ox, d, a.ox + i), hn::Stream(oy, d, a.oy + i);
    if constexpr (use.drawn && !through) hn::StoreU(ox, d, a.ox + i), hn::StoreU(oy, d, a.oy + i);
  }
}

template <class Number>
void copy_some(Kernel kernel, const Arrays<Number>& a, bool through) {
  switch (kernel) {
#define BETWIXT_CASE(name) \
  case Kernel::name:       \
    return through ? copy_arrays<Kernel::name, true>(a) : copy_arrays<Kernel::name, false>(a);
    BETWIXT_KERNELS(BETWIXT_CASE)
#undef BETWIXT_CASE
  }
}
void copy_floats(Kernel k, const Arrays<float>& a, bool through) { copy_some(k, a, through); }
void copy_doubles(Kernel k, const Arrays<double>& a, bool through) { copy_some(k, a, through); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace betwixt::algebra
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace betwixt::algebra {
namespace {

HWY_EXPORT(copy_floats);
HWY_EXPORT(copy_doubles);

void copy_part(Kernel k, const Arrays<float>& a, bool through) { HWY_DYNAMIC_DISPATCH(copy_floats)(k, a, through); }
void copy_part(Kernel k, const Arrays<double>& a, bool through) { HWY_DYNAMIC_DISPATCH(copy_doubles)(k, a, through); }

template <class Number>
void copy_threaded(Kernel kernel, const Arrays<Number>& a, bool through, unsigned threads) {
  const auto bound = [&](std::size_t i) { return i == threads ? a.count : a.count / threads * i / 64 * 64; };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i)
    others.emplace_back([&, i] { copy_part(kernel, part(a, bound(i), bound(i + 1)), through); });
  copy_part(kernel, part(a, 0, bound(1)), through);
  for (std::thread& t : others) t.join();
}

}  // namespace

void copy_all(Kernel k, const Arrays<float>& a, bool through, unsigned threads) {
  copy_threaded(k, a, through, threads);
}
void copy_all(Kernel k, const Arrays<double>& a, bool through, unsigned threads) {
  copy_threaded(k, a, through, threads);
}

}  // namespace betwixt::algebra
#endif
