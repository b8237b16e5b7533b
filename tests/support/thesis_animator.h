// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The animation process of the source (the Animation Imaging Model), carried out tick by tick. A tick is a retrace, the
// vertical retrace of a display. Entries on an animation list wait for their retrace. There A <- M A (row vectors), and
// the entry moves on by its interval. Halted entries are on a passive list. Slots are absolute retraces. A slot is
// removed before its entries are processed, and has room for any number of entries. Tests compare the closed forms of
// the program with this model. It shares no code with them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace thesis {

using Matrix = std::array<long double, 16>;  // row vectors, row by row

inline constexpr Matrix unit{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix r{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t k = 0; k < 4; ++k) r[row * 4 + column] += a[row * 4 + k] * b[k * 4 + column];
  return r;
}

struct Order {
  enum Kind { animate, halt, kill, cancel } kind = animate;
  std::int64_t tick = 0;
  std::uint64_t number = 0;
  Matrix motion = unit;
  std::int64_t interval = 1, change = 0, period = 1, ceiling = 30;
  bool keep_phase = false;
  std::optional<std::int64_t> from, until;
};

// The history of one name of an environment: its current entry, and the entries that had the name before.
class Animator {
 public:
  struct Entry {
    bool started = false, active = false;
    Matrix motion = unit, a = unit;
    std::int64_t updates = 0;
    std::int64_t interval = 1, change = 0, period = 1, ceiling = 30;
    std::int64_t growing = 1;                        // the current interval, with its growth
    std::int64_t retraces = 0, recent = 0, due = 0;  // retraces and updates since the Animate; the next update
  };
  struct Life {
    std::pair<std::int64_t, std::uint64_t> at;
    bool birth = false;
  };

  Animator(std::vector<Order> orders, std::int64_t begin) : tick_(begin) {
    for (Order& o : orders) waiting_.insert({{o.tick, o.number}, {std::move(o), false}});
  }

  // Carries out one retrace: first the updates that are due, then the orders.
  void retrace() {
    changed = false;
    for (Entry& e : entries) count_retrace(e);
    std::vector<std::size_t> slot;
    if (const auto found = slots_.find(tick_); found != slots_.end()) {
      slot = std::move(found->second);
      slots_.erase(found);
    }
    for (std::size_t i : slot) update(i);
    while (!waiting_.empty() && waiting_.begin()->first.first <= tick_) {
      const Waiting now = waiting_.begin()->second;
      waiting_.erase(waiting_.begin());
      obey(now);
    }
    ++tick_;
  }
  // Returns the number of the next retrace.
  std::int64_t tick() const { return tick_; }

  std::vector<Entry> entries;  // by generation; only the last may still have the name
  bool known = false;
  bool changed = false;  // whether the last retrace changed a matrix A
  std::vector<Life> lives;
  std::vector<std::uint64_t> refused;
  std::optional<std::uint64_t> starved;  // the first Animate that came before the first update of its predecessor

 private:
  struct Waiting {
    Order order;
    bool scheduled = false;
  };

  void count_retrace(Entry& e) {
    if (!e.active) return;
    ++e.retraces;
    if (e.retraces % e.period == 0) e.growing += e.change;
  }
  void update(std::size_t i) {
    Entry& e = entries[i];
    e.a = product(e.motion, e.a);
    ++e.updates, ++e.recent;
    changed = true;
    e.interval = e.growing < 1 ? 1 : e.growing;
    if (e.change > 0 && e.interval >= e.ceiling) {
      e.interval = e.ceiling;
      e.active = false;
      return;
    }
    put(i, tick_ + e.interval);
  }
  void put(std::size_t i, std::int64_t due) {
    entries[i].due = due;
    slots_[due].push_back(i);
  }
  void take_off(std::size_t i) {
    if (entries[i].active) std::erase(slots_[entries[i].due], i);
    entries[i].active = false;
  }

  void obey(const Waiting& w) {
    const Order& o = w.order;
    if (o.kind == Order::animate) {
      if (w.scheduled)
        begin(o);
      else
        animate(o);
    } else if (!known) {
      refused.push_back(o.number);
    } else if (o.kind == Order::halt) {
      take_off(entries.size() - 1);
    } else {
      std::erase_if(waiting_, [](const auto& entry) { return entry.second.scheduled; });
      if (o.kind == Order::kill) forget(o);
    }
  }
  void forget(const Order& o) {
    take_off(entries.size() - 1);
    known = false;
    lives.push_back({{o.tick, o.number}, false});
  }
  void animate(const Order& o) {
    if (!known) {
      known = true;
      entries.emplace_back();
      entries.back().motion = o.motion, entries.back().interval = o.interval;
      lives.push_back({{o.tick, o.number}, true});
    }
    if (o.from && *o.from > 0) {
      Order later = o;
      later.tick += *o.from;
      waiting_.insert({{later.tick, later.number}, {later, true}});
    } else {
      begin(o);
    }
    if (o.until) {
      Order stop;
      stop.kind = Order::halt, stop.tick = o.tick + *o.until, stop.number = o.number;
      waiting_.insert({{stop.tick, stop.number}, {stop, true}});
    }
  }
  void begin(const Order& o) {
    const std::size_t i = entries.size() - 1;
    Entry& e = entries[i];
    const std::optional<std::int64_t> old = e.active ? std::optional(e.due) : std::nullopt;
    const bool keep = o.keep_phase && old;
    if (old && !keep && e.recent == 0 && e.retraces > 0 && !starved) starved = o.number;
    take_off(i);
    if (!e.started) e.a = o.motion, changed = true;
    e.started = true;
    e.motion = o.motion;
    e.interval = e.growing = o.interval;
    e.change = o.change, e.period = o.period, e.ceiling = o.ceiling;
    e.retraces = e.recent = 0;
    e.active = !(e.change > 0 && e.interval >= e.ceiling);
    if (e.active) put(i, keep ? (*old > tick_ ? *old : tick_ + 1) : tick_ + e.interval);
  }

  std::int64_t tick_;
  std::map<std::int64_t, std::vector<std::size_t>> slots_;
  std::multimap<std::pair<std::int64_t, std::uint64_t>, Waiting> waiting_;
};

}  // namespace thesis
