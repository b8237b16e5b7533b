// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how long it takes to find the contacts of 10,000 balls, compared with a test of every pair of bounding
// boxes. Checks that both find the same pairs.
#include "betwixt/contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "timing.h"

using namespace betwixt;

namespace {

constexpr std::uint32_t count = 10'000;
constexpr int rounds = 50;

struct Spread {
  std::vector<double> all;
  double least() const { return *std::min_element(all.begin(), all.end()); }
  double median() const {
    auto sorted = all;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

Frame scattered(std::mt19937_64& r, double room) {
  const auto within = [&](double most) { return std::uniform_real_distribution(-most, most)(r); };
  Shape ball;
  ball.kind = Kind::sphere, ball.radius = 0.5;
  const auto shape = std::make_shared<const Shape>(ball);
  Frame f;
  f.camera.world = translation({0, 0, 2 * room});
  for (std::uint32_t i = 0; i < count; ++i) {
    Item item;
    item.id = {i}, item.shape = shape;
    item.world = translation({within(room), within(room), within(room)});
    f.items.push_back(item);
  }
  return f;
}

std::vector<Contact> each_with_each(const std::vector<ContactBox>& boxes) {
  std::vector<Contact> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = i + 1; k < boxes.size(); ++k) {
      const ContactBox &a = boxes[i], &b = boxes[k];
      if (a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
          a.low.z <= b.high.z && b.low.z <= a.high.z)
        found.push_back({a.id, b.id, {}});
    }
  return found;
}

bool same(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Contact& x, const Contact& y) { return x.a == y.a && x.b == y.b; });
}

void measure(const char* what, double room) {
  std::mt19937_64 r(2026);
  Spread tree, brute, sweep;
  std::size_t pairs = 0;
  for (int round = 0; round < rounds; ++round) {
    const Frame f = scattered(r, room);
    Frame next = f;
    for (Item& item : next.items) item.world(0, 3) += 0.2;
    Contacts found, between;
    std::vector<Contact> compared;
    tree.all.push_back(milliseconds([&] { found = contacts(f); }));
    sweep.all.push_back(milliseconds([&] { between = swept(f, next); }));
    brute.all.push_back(milliseconds([&] { compared = each_with_each(found.boxes); }));
    if (!same(found.pairs, compared) || between.pairs.size() < found.pairs.size()) {
      std::fprintf(stderr, "wrong: other pairs than by comparing each with each\n");
      std::exit(1);
    }
    pairs += found.pairs.size();
  }
  fmt::print("{:26} {:7.3f}  {:7.3f}   {} pairs on average\n", what, tree.least(), tree.median(), pairs / rounds);
  fmt::print("{:26} {:7.3f}  {:7.3f}\n", "  swept", sweep.least(), sweep.median());
  fmt::print("{:26} {:7.3f}  {:7.3f}\n", "  pairs, each with each", brute.least(), brute.median());
  fmt::print("{:26} {:7.1f}  {:7.1f}\n", "  times as long", brute.least() / tree.least(),
             brute.median() / tree.median());
}

}  // namespace

int main() {
  fmt::print("{} boxes: their places, pairs, groups and sights; {} rounds, pairs compared\n{:26} {:>7}  {:>7}  ms\n",
             count, rounds, "", "least", "median");
  measure("sparse", 50);
  measure("dense", 12);
}
