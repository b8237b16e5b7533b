// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "copying.h"

#include <hwy/cache_control.h>

#include "base/large_pages.h"
#include "timing.h"

// This file is compiled once for each kind of machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "copying.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace betwixt {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t line = 8, ahead = 512;

void copy_here(const double* from, double* to, std::size_t count) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<double, line> d;
  for (std::size_t i = 0; i < count; i += line) {
    __builtin_prefetch(from + i + ahead, 0, 2);
    for (std::size_t lane = 0; lane < line; lane += hn::Lanes(d))
      hn::Stream(hn::Load(d, from + i + lane), d, to + i + lane);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace betwixt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace betwixt {

HWY_EXPORT(copy_here);

void copy_past_caches(const double* from, double* to, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(copy_here)(from, to, count);
  hwy::FlushStream();
}

std::vector<double> copy_rates() {
  constexpr std::size_t size = std::size_t{12} << 20;
  std::vector<double, LargePages<double>> from(size, 1), to(size);
  std::vector<double> rate;
  for (int i = 0; i < 40; ++i)
    rate.push_back(2e-6 * sizeof(double) * size /
                   milliseconds([&] { copy_past_caches(from.data(), to.data(), size); }));
  insist(to == from, "a copy");
  return rate;
}

}  // namespace betwixt
#endif
