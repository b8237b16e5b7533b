// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A number that counts the operations on it. In place of double it tells the cost of the very code that draws.
#pragma once

#include <cmath>

#include "algebra/turns.h"

namespace betwixt::algebra {

struct Tally {
  long long times = 0, plus = 0;  // products and quotients; sums, differences and changes of sign
  long long functions = 0;        // sine, cosine, tangent, exponential, logarithm
  long long operations() const { return times + plus; }
  friend Tally operator-(Tally a, Tally b) { return {a.times - b.times, a.plus - b.plus, a.functions - b.functions}; }
  friend bool operator==(const Tally&, const Tally&) = default;
};

class Counted {
 public:
  static inline thread_local Tally tally;

  Counted(double value = 0) : value_(value) {}
  explicit operator double() const { return value_; }

  friend Counted operator*(Counted a, Counted b) { return ++tally.times, Counted(a.value_ * b.value_); }
  friend Counted operator/(Counted a, Counted b) { return ++tally.times, Counted(a.value_ / b.value_); }
  friend Counted operator+(Counted a, Counted b) { return ++tally.plus, Counted(a.value_ + b.value_); }
  friend Counted operator-(Counted a, Counted b) { return ++tally.plus, Counted(a.value_ - b.value_); }
  friend Counted operator-(Counted a) { return ++tally.plus, Counted(-a.value_); }
  // Comparisons are not counted.
  friend bool operator==(Counted a, Counted b) { return a.value_ == b.value_; }

 private:
  double value_;
};

inline double exponential(double x) { return std::exp(x); }
inline double logarithm(double x) { return std::log(x); }
inline double tangent(double x) { return std::tan(x); }
inline double value(double x) { return x; }

inline Counted exponential(Counted x) { return ++Counted::tally.functions, Counted(std::exp(double(x))); }
inline Counted logarithm(Counted x) { return ++Counted::tally.functions, Counted(std::log(double(x))); }
inline Counted tangent(Counted x) { return ++Counted::tally.functions, Counted(std::tan(double(x))); }
inline double value(Counted x) { return double(x); }

// Returns sine and cosine of the k-th of n parts of these turns.
template <class Number>
struct SineCosine {
  Number sine, cosine;
};
template <class Number>
SineCosine<Number> circle(Turns turns, std::int64_t k, std::int64_t n) {
  const Turn at = turn(phase(turns, k, n));
  return {at.sine, at.cosine};
}
template <>
inline SineCosine<Counted> circle<Counted>(Turns turns, std::int64_t k, std::int64_t n) {
  Counted::tally.functions += 2;
  const Turn at = turn(phase(turns, k, n));
  return {at.sine, at.cosine};
}

}  // namespace betwixt::algebra
