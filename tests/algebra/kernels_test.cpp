// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "algebra/counted.h"
#include "algebra/stepper.h"
#include "betwixt/algebra.h"

namespace betwixt {
namespace {

TEST(Kernels, GiveTheSameBitsByVectorsAndOneByOne) {
  using namespace algebra;
  std::mt19937 random(8);
  const auto number = [&] { return static_cast<double>(random() % 4001) / 1000.0 - 2; };
  for (int k = 0; k < kernel_count; ++k) {
    std::vector<double> plain[8];
    std::vector<Counted> counted[8];
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 37; ++i) plain[a].push_back(number()), counted[a].push_back(plain[a].back());
    double inputs[most_inputs];
    Counted same[most_inputs];
    for (int i = 0; i < most_inputs; ++i) inputs[i] = number(), same[i] = inputs[i];
    const auto arrays = [](auto(&a)[8]) {
      using N = typename std::remove_reference_t<decltype(a[0])>::value_type;
      return Arrays<N>{a[0].data(), a[1].data(), a[2].data(), a[3].data(), a[4].data(),
                       a[5].data(), a[6].data(), a[7].data(), 37};
    };
    step_all(static_cast<Kernel>(k), arrays(plain), inputs);
    step_plainly(static_cast<Kernel>(k), arrays(counted), same);
    for (int a = 0; a < 8; ++a)
      for (std::size_t i = 0; i < 37; ++i) EXPECT_EQ(plain[a][i], static_cast<double>(counted[a][i])) << k << " " << a;
  }
}

// Whole arrays, past the caches and on two threads, against one point after the other.
template <class Number>
void expect_same_at_size() {
  using namespace algebra;
  constexpr std::size_t count = (std::size_t{1} << 20) + 37;
  std::mt19937 random(9);
  const auto number = [&] { return static_cast<double>(random() % 4001) / 1000.0 - 2; };
  Line<Number> begun[8];
  for (Line<Number>& line : begun) {
    line.resize(count);
    for (Number& x : line) x = static_cast<Number>(number());
  }
  Line<Number> many[8], each[8];
  for (int k = 0; k < kernel_count; ++k) {
    for (int a = 0; a < 8; ++a) many[a] = each[a] = begun[(a + k) % 8];
    Number inputs[most_inputs];
    for (Number& x : inputs) x = static_cast<Number>(number());
    const auto arrays = [&](Line<Number>(&a)[8], std::size_t from, std::size_t to) {
      return part(Arrays<Number>{a[0].data(), a[1].data(), a[2].data(), a[3].data(), a[4].data(), a[5].data(),
                                 a[6].data(), a[7].data(), count},
                  from, to);
    };
    step_all(static_cast<Kernel>(k), arrays(many, 0, count), inputs);
    // In pieces that are no whole vectors, on one thread, through the caches.
    for (std::size_t from = 0; from < count; from += 4999)
      step_all(static_cast<Kernel>(k), arrays(each, from, std::min(count, from + 4999)), inputs, 1);
    for (int a = 0; a < 8; ++a)
      EXPECT_EQ(std::memcmp(many[a].data(), each[a].data(), count * sizeof(Number)), 0) << k << " " << a;
  }
}
TEST(Kernels, GiveTheSameBitsForManyInDouble) { expect_same_at_size<double>(); }
TEST(Kernels, GiveTheSameBitsForManyInFloat) { expect_same_at_size<float>(); }

}  // namespace
}  // namespace betwixt
