// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how far rounding moves points of the unit circle from their true places. bench/algebra.cpp runs up to 1e7
// steps.
#include <gtest/gtest.h>

#include <cmath>

#include "algebra/precise.h"
#include "betwixt/algebra.h"

namespace betwixt {
namespace stepper_test {

constexpr double theta = 0.01;
constexpr std::int64_t whole = 1 << 20;  // steps of the motion: theta times this is exact

struct Drift {
  double after_1e3 = 0, after_1e5 = 0;
};

// The largest distance up to then. Where the points are is told by products in quadruple precision.
template <class Number>
Drift drift(Method method, int renew) {
  const std::vector<Number> x{1, 0}, y{0, 1};
  auto steps = Steps<Number>::make({{rotate_by(theta * whole)}}, whole, method, x, y);
  EXPECT_TRUE(steps);
  if (renew >= 0) steps->renew_every(renew);
  const precise::Real c = precise::cosine(theta), s = precise::sine(theta);
  precise::Real at_x = 1, at_y = 0;
  Drift most;
  for (int k = 1; k <= 100'000; ++k) {
    steps->step();
    const precise::Real next = c * at_x - s * at_y;
    at_y = s * at_x + c * at_y, at_x = next;
    const auto cosine = static_cast<long double>(at_x), sine = static_cast<long double>(at_y);
    for (const long double d :
         {cosine - steps->x()[0], sine - steps->y()[0], -sine - steps->x()[1], cosine - steps->y()[1]})
      most.after_1e5 = std::max(most.after_1e5, static_cast<double>(std::abs(d)));
    if (k == 1000) most.after_1e3 = most.after_1e5;
  }
  return most;
}

constexpr int never = 0, as_it_comes = -1;

TEST(Drift, InF32) {
  const auto at_most = [](Method method, int renew, double after_1e3, double after_1e5) {
    const Drift d = drift<float>(method, renew);
    EXPECT_LE(d.after_1e3, after_1e3) << name_of(method) << " " << renew;
    EXPECT_LE(d.after_1e5, after_1e5) << name_of(method) << " " << renew;
  };
  at_most(Method::geometric, never, 2e-6, 2e-5);    // three shears
  at_most(Method::differences, never, 1e-5, 9e-4);  // a complex product
  at_most(Method::best, never, 1e-3, 1e-1);         // two-term
  at_most(Method::matrix, never, 1e-3, 1e-1);       // so are its sine and cosine
  at_most(Method::best, 64, 7e-5, 7e-5);
  at_most(Method::best, 32, 4e-5, 4e-5);
  for (const Method method : {Method::best, Method::matrix}) at_most(method, as_it_comes, 7e-5, 7e-5);
  for (const Method method : {Method::geometric, Method::differences}) at_most(method, as_it_comes, 1e-6, 2e-6);
}

TEST(Drift, InF64) {
  const auto at_most = [](Method method, int renew, double after_1e5) {
    const Drift d = drift<double>(method, renew);
    EXPECT_LE(d.after_1e5, after_1e5) << name_of(method) << " " << renew;
  };
  at_most(Method::geometric, never, 1e-13);
  at_most(Method::differences, never, 2e-12);
  at_most(Method::best, never, 2e-10);
  at_most(Method::matrix, never, 2e-10);
  at_most(Method::best, 64, 1.5e-13);
  for (const Method method : {Method::best, Method::matrix}) at_most(method, as_it_comes, 1e-12);
  for (const Method method : {Method::geometric, Method::differences}) at_most(method, as_it_comes, 1e-14);
}

}  // namespace stepper_test
}  // namespace betwixt
