// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how fast a million environments step from tick to tick and seek to any tick, compared with the animation
// process of the source: doubly linked lists in 30 slots, and A <- M A in f32. Checks the values.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "copying.h"
#include "program/environment_set.h"
#include "timing.h"

using namespace betwixt;

namespace {

using Random = std::mt19937_64;

constexpr std::size_t count = 1'000'000;
constexpr std::int64_t begun = 120;  // the tick by which all environments have begun
constexpr int rounds = 10, ticks_a_round = 60, seeks = 200;

struct Spread {
  double least, median;
};
Spread spread(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return {all.front(), all[all.size() / 2]};
}

std::size_t allocated() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

// Bytes read and written for an update, as the mean of all forms.
double bytes_an_update() {
  using environments::Form;
  double sum = 0;
  for (Form f : {Form::translation, Form::spin, Form::screw, Form::similarity})
    sum += static_cast<double>(8 * (environments::rows(f) + environments::matrix_rows(f)) + sizeof(std::uint16_t));
  return sum / 4;
}

// ---- A million environments

struct Animation {
  std::int64_t tick, interval;
  Mat4 motion;
};

double between(Random& r, double least, double most) { return std::uniform_real_distribution(least, most)(r); }
Vec3 vector(Random& r, double most) {
  return {between(r, -most, most), between(r, -most, most), between(r, -most, most)};
}

// A quarter each are translations, rotations about an axis through the origin, screws, and rotations with a scaling.
// The scales stay within Power::bound for 100,000 ticks.
Mat4 motion(Random& r) {
  const auto turn = [&] { return rotation(axis_angle(vector(r, 1), between(r, -pi, pi))); };
  switch (r() % 4) {
    case 0:
      return translation(vector(r, 0.1));
    case 1:
      return turn();
    case 2:
      return translation(vector(r, 0.1)) * turn();
    default: {
      const double s = std::exp(between(r, -2e-4, 2e-4));
      return translation(vector(r, 0.1)) * turn() * scaling({s, s, s});
    }
  }
}

std::vector<Animation> animations() {
  Random r(2026);
  std::vector<Animation> all;
  while (all.size() < count)
    all.push_back({static_cast<std::int64_t>(r() % begun), static_cast<std::int64_t>(r() % 30 + 1), motion(r)});
  return all;
}

std::vector<EnvironmentSet::Member> members(const std::vector<Animation>& all) {
  std::vector<EnvironmentSet::Member> made;
  made.reserve(all.size());
  for (const Animation& a : all) {
    EnvironmentEvent::Animate animate;
    animate.motion = a.motion;
    animate.timing.interval = a.interval;
    made.push_back({std::make_shared<const Environment>(Environment::compile({{a.tick, 1, animate}})), 0});
  }
  return made;
}

// Returns the number of updates in a tick after all have begun.
class Updates {
 public:
  explicit Updates(const std::vector<Animation>& all) {
    for (const Animation& a : all) ++at_[index(a.interval, a.tick)];
  }
  std::size_t in(std::int64_t tick) const {
    std::size_t sum = 0;
    for (std::int64_t interval = 1; interval <= 30; ++interval) sum += at_[index(interval, tick)];
    return sum;
  }

 private:
  static std::size_t index(std::int64_t interval, std::int64_t tick) {
    return static_cast<std::size_t>(interval * 30 + tick % interval);
  }
  std::array<std::size_t, 31 * 30> at_{};
};

void check(const EnvironmentSet& set, const std::vector<EnvironmentSet::Member>& all) {
  for (std::size_t i = 0; i < count; i += 997) {
    const Mat4 is = set.matrix(i), want = all[i].environment->at(0, set.tick());
    double size = 1;
    for (double e : want.m) size = std::max(size, std::abs(e));
    for (std::size_t k = 0; k < 16; ++k) insist(std::abs(is.m[k] - want.m[k]) < 1e-12 * size, "a matrix");
  }
}

// ---- The animation process of the source

class Lists {
 public:
  explicit Lists(const std::vector<Animation>& all) {
    for (const Animation& a : all) {
      auto* e = new Entry;
      for (std::size_t i = 0; i < 16; ++i) e->a[i] = e->m[i] = static_cast<float>(a.motion.m[i]);
      e->interval = static_cast<int>(a.interval);
      starting_[static_cast<std::size_t>(a.tick)].push_back(e);
      entries_.push_back(e);
    }
  }
  ~Lists() {
    for (Entry* e : entries_) delete e;
  }
  Lists(const Lists&) = delete;
  Lists& operator=(const Lists&) = delete;

  std::int64_t tick() const { return tick_; }
  void step() {
    ++tick_;
    // Takes the list out of its slot first: with an interval of 30 slots the loop would never end.
    for (Entry* e = std::exchange(slots_[slot(tick_)], nullptr); e;) {
      Entry* const next = e->next;
      multiply(*e);
      put(e);
      e = next;
    }
    if (tick_ >= begun) return;
    for (Entry* e : starting_[static_cast<std::size_t>(tick_)]) put(e);
  }
  float element(std::size_t i, std::size_t k) const { return entries_[i]->a[k]; }
  static constexpr std::size_t bytes() { return sizeof(Entry); }

 private:
  struct Entry {
    Entry *next = nullptr, *previous = nullptr;
    std::array<float, 16> a, m;  // columns
    int interval = 1;
  };
  static std::size_t slot(std::int64_t tick) { return static_cast<std::size_t>(tick % 30); }
  // A <- A M in columns: the source's M A in rows.
  static void multiply(Entry& e) {
    std::array<float, 16> r;
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t i = 0; i < 4; ++i)
        r[4 * c + i] = e.a[i] * e.m[4 * c] + e.a[4 + i] * e.m[4 * c + 1] + e.a[8 + i] * e.m[4 * c + 2] +
                       e.a[12 + i] * e.m[4 * c + 3];
    e.a = r;
  }
  void put(Entry* e) {
    Entry*& head = slots_[slot(tick_ + e->interval)];
    e->previous = nullptr;
    e->next = head;
    if (head) head->previous = e;
    head = e;
  }

  std::array<Entry*, 30> slots_{};
  std::array<std::vector<Entry*>, begun> starting_;
  std::vector<Entry*> entries_;
  std::int64_t tick_ = -1;
};

void check(const Lists& lists, const std::vector<EnvironmentSet::Member>& all) {
  for (std::size_t i = 0; i < count; i += 997) {
    const Mat4 want = all[i].environment->at(0, lists.tick());
    double size = 1;
    for (double e : want.m) size = std::max(size, std::abs(e));
    for (std::size_t k = 0; k < 16; ++k)
      insist(std::abs(lists.element(i, k) - want.m[k]) < 1e-2 * size, "a matrix of the lists");
  }
}

// ---- Measuring

struct Times {
  std::vector<double> tick, update;  // milliseconds, nanoseconds
  void add(double ms, std::size_t updates) {
    tick.push_back(ms);
    update.push_back(1e6 * ms / static_cast<double>(updates));
  }
};

void print(const char* name, const Times& t) {
  const Spread tick = spread(t.tick), update = spread(t.update);
  fmt::print("{:34} {:8.3f} {:8.3f}   {:8.2f} {:8.2f}\n", name, tick.least, tick.median, update.least, update.median);
}
void print(const char* name, const std::vector<double>& t) {
  const Spread s = spread(t);
  fmt::print("{:34} {:8.3f} {:8.3f}   {:8.2f} {:8.2f}\n", name, s.least, s.median, s.least * 1e6 / count,
             s.median * 1e6 / count);
}

std::vector<double> seek_times(EnvironmentSet& set, const std::vector<EnvironmentSet::Member>& all,
                               std::int64_t furthest, int repeats) {
  Random r(7);
  std::vector<double> times;
  for (int k = 0; k < repeats; ++k) {
    const auto tick = begun + static_cast<std::int64_t>(r() % static_cast<std::uint64_t>(furthest - begun));
    times.push_back(milliseconds([&] { set.seek(tick); }));
    if (k % 20 == 0) check(set, all);
  }
  return times;
}

}  // namespace

int main() {
  const std::vector<Animation> all = animations();
  const Updates updates(all);
  const auto made = members(all);
  const std::size_t before = allocated();
  std::optional<EnvironmentSet> set;
  const double build = milliseconds([&] { set.emplace(made); });
  const std::size_t bytes = (allocated() - before) / count;

  Lists lists(all);
  while (lists.tick() < begun) lists.step();
  Times ours, theirs;
  std::int64_t tick = begun;
  std::size_t idle = 0;
  for (int round = 0; round < rounds; ++round) {
    set->seek(tick);
    for (int k = 1; k <= ticks_a_round; ++k) {
      std::size_t slots = 0;
      ours.add(milliseconds([&] {
                 for (const auto r : set->advance(tick + k)) slots += r.end - r.begin;
               }),
               updates.in(tick + k));
      insist(slots >= updates.in(tick + k), "slots that changed");
      idle += slots - updates.in(tick + k);
    }
    check(*set, made);
    for (int k = 1; k <= ticks_a_round; ++k) {
      const double ms = milliseconds([&] { lists.step(); });
      theirs.add(ms, updates.in(lists.tick()));
    }
    check(lists, made);
    tick += ticks_a_round;
  }
  const auto near = seek_times(*set, made, 100'000, seeks), far = seek_times(*set, made, 1'000'000'000, seeks / 10);

  std::size_t due = 0;
  for (std::int64_t t = 0; t < 60; ++t) due += updates.in(begun + t);
  fmt::print("{} environments, intervals 1..30, {} updates a tick; {} ticks, {} seeks, values checked\n", count,
             due / 60, rounds * ticks_a_round, seeks);
  fmt::print("{:34} {:>17}   {:>17}\n", "", "ms", "ns an update");
  fmt::print("{:34} {:>8} {:>8}   {:>8} {:>8}\n", "", "least", "median", "least", "median");
  print("a tick", ours);
  print("a tick, linked lists in 30 slots", theirs);
  const Spread a = spread(ours.tick), b = spread(theirs.tick);
  fmt::print("{:34} {:8.1f} {:8.1f}\n", "  times as long", b.least / a.least, b.median / a.median);
  print("seek of all", near);
  print("seek of all, up to 1e9 ticks", far);
  const std::vector<double> copies = copy_rates();
  const double best = *std::max_element(copies.begin(), copies.end());
  fmt::print(
      "one core copies {:.1f} GB/s just now (median {:.1f}); an update reads and writes {:.0f} bytes: {:.2f} ns\n",
      best, spread(copies).median, bytes_an_update(), bytes_an_update() / best);
  fmt::print("{} bytes an environment beside its track (lists: {}); {:.0f} ms to build; {:.1f} % of slots empty\n",
             bytes, Lists::bytes(), build,
             100.0 * static_cast<double>(idle) / static_cast<double>(due * rounds * ticks_a_round / 60));
}
