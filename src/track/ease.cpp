// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/ease.h"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>

#include "betwixt/math.h"
#include "track/twerpers.h"

namespace betwixt {
namespace {

constexpr std::uint32_t often = 16;    // after so many questions a table is worth its time
constexpr int most_tables = 4096;      // 4 kB each; an ease without a table makes the part that it needs
constexpr double near_enough = 2e-13;  // for values of about 1
std::atomic<int> tables{0};

// The points at which a polynomial of the seventh degree meets the function (Chebyshev), and the cosines of the sums
// that give its coefficients.
struct Nodes {
  std::array<double, 8> at{}, between{};
  std::array<std::array<double, 8>, 8> cosine{};
  Nodes() {
    const auto cosine_of = [](double sixteenths) { return sine_cosine(sixteenths * (pi / 16)).cosine; };
    for (int j = 0; j < 8; ++j) {
      const auto n = static_cast<std::size_t>(j);
      at[n] = cosine_of(2 * j + 1), between[n] = j == 7 ? 1 : cosine_of(2 * j);
      for (int k = 0; k < 8; ++k) cosine[static_cast<std::size_t>(k)][n] = cosine_of((2 * j + 1) * k % 32);
    }
  }
};

}  // namespace

Ease::~Ease() {
  const Table* const table = table_.load();
  if (!table) return;
  --tables;
  delete table;
}

Ease::Part Ease::part_of(std::uint32_t part) const {
  static const Nodes nodes;
  const auto exact = [&](double x) { return function_((part + (x + 1) / 2) / part_count, arguments_); };
  std::array<double, 8> f{}, a{};
  double size = 1;
  for (std::size_t j = 0; j < 8; ++j) f[j] = exact(nodes.at[j]), size = std::max(size, std::abs(f[j]));
  for (std::size_t k = 0; k < 8; ++k) {
    for (std::size_t j = 0; j < 8; ++j) a[k] += f[j] * nodes.cosine[k][j];
    a[k] /= k == 0 ? 8 : 4;
  }
  // From the polynomials of Chebyshev to powers.
  Part out{{a[0] - a[2] + a[4] - a[6], a[1] - 3 * a[3] + 5 * a[5] - 7 * a[7], 2 * a[2] - 8 * a[4] + 18 * a[6],
            4 * a[3] - 20 * a[5] + 56 * a[7], 8 * a[4] - 48 * a[6], 16 * a[5] - 112 * a[7], 32 * a[6], 64 * a[7]}};
  for (const double x : nodes.between)
    if (!(std::abs(value(out, x) - exact(x)) <= near_enough * size) ||
        !(std::abs(value(out, -x) - exact(-x)) <= near_enough * size)) {
      out.c.fill(std::numeric_limits<double>::quiet_NaN());
      break;
    }
  return out;
}

// Values are the same with and without a table.
double Ease::without_table(std::uint32_t part, double place) const {
  if (asked_.fetch_add(1, std::memory_order_relaxed) == often) {
    if (tables.fetch_add(1) < most_tables) {
      auto made = std::make_unique<Table>();
      for (std::uint32_t i = 0; i < part_count; ++i) made->parts[i] = part_of(i);
      table_.store(made.release(), std::memory_order_release);
    } else {
      --tables;
    }
  }
  return value(part_of(part), 2 * (place - part) - 1);
}

std::shared_ptr<const Ease> bezier_ease(const Ease::Arguments& arguments) {
  static std::mutex mutex;
  static std::map<Ease::Arguments, std::weak_ptr<const Ease>> all;
  static std::size_t most = 1024;
  const std::lock_guard lock(mutex);
  std::weak_ptr<const Ease>& known = all[arguments];
  if (auto ease = known.lock()) return ease;
  auto ease = std::make_shared<const Ease>(bezier_factor, arguments, true);
  known = ease;
  if (all.size() > most) {
    std::erase_if(all, [](const auto& one) { return one.second.expired(); });
    most = std::max<std::size_t>(1024, 2 * all.size());
  }
  return ease;
}

}  // namespace betwixt
