// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Eases: functions from the share of a segment's time to the share of the way. Those that cost much (a root, a sine, a
// power) are cut into 64 parts, each a polynomial of the seventh degree within 1e-12 of the function. Where no such
// polynomial comes near enough, as at a vertical slope, the function itself is called. So an ease has one value at a
// time, by whatever route, and on every machine the same one if the function has.
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>

namespace betwixt {

class Ease {
 public:
  using Arguments = std::array<double, 4>;
  using Function = double (*)(double s, const Arguments&);
  Ease(Function f, const Arguments& arguments, bool costly) : function_(f), arguments_(arguments), costly_(costly) {}
  Ease(const Ease&) = delete;
  Ease& operator=(const Ease&) = delete;
  ~Ease();

  double at(double s) const {
    if (!costly_ || !(s > 0 && s < 1)) return function_(s, arguments_);
    const double place = s * part_count;
    const auto part = static_cast<std::uint32_t>(place);
    const Table* const table = table_.load(std::memory_order_acquire);
    const double y = table ? value(table->parts[part], 2 * (place - part) - 1) : without_table(part, place);
    return y == y ? y : function_(s, arguments_);
  }
  const Arguments& arguments() const { return arguments_; }

 private:
  static constexpr std::uint32_t part_count = 64;
  // The coefficients of a polynomial of -1 to 1; not numbers if the function itself is called.
  struct alignas(64) Part {
    std::array<double, 8> c;
  };
  struct Table {
    std::array<Part, part_count> parts;
  };
  static double value(const Part& part, double x) {
    const auto& c = part.c;
    const double x2 = x * x;
    return ((c[0] + c[1] * x) + x2 * (c[2] + c[3] * x)) + x2 * x2 * ((c[4] + c[5] * x) + x2 * (c[6] + c[7] * x));
  }
  Part part_of(std::uint32_t part) const;
  double without_table(std::uint32_t part, double place) const;

  const Function function_;
  const Arguments arguments_;
  const bool costly_;
  mutable std::atomic<std::uint32_t> asked_{0};
  mutable std::atomic<const Table*> table_{nullptr};
};

// Returns the ease of the CSS curve with these two handles. Equal arguments give one ease.
std::shared_ptr<const Ease> bezier_ease(const Ease::Arguments&);

}  // namespace betwixt
