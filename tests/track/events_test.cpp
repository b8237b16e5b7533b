// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/events.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <numeric>
#include <random>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

namespace betwixt {
namespace {

Event event(std::int64_t t, double v) {
  Event e;
  e.time = {t};
  e.value = v;
  return e;
}

using Model = std::map<std::int64_t, double>;

Model content(const Events& events) {
  Model m;
  std::int64_t last = INT64_MIN;
  events.each([&](const Event& e) {
    EXPECT_LT(last, e.time.flicks);
    last = e.time.flicks;
    m[e.time.flicks] = std::get<double>(e.value);
  });
  EXPECT_EQ(m.size(), events.size());
  return m;
}

// shows: G33
TEST(Events, AnyOrderMakesTheSameTrack) {
  Events in_order;
  for (int i = 0; i < 700; ++i) in_order.put(event(i, i * 0.5));
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::vector<int> order(700);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    if (seed == 19) std::sort(order.rbegin(), order.rend());
    Events events;
    for (int i : order) events.put(event(i, i * 0.5));
    EXPECT_EQ(events, in_order);
    EXPECT_EQ(content(events), content(in_order));
    EXPECT_EQ(events.front().time.flicks, 0);
    EXPECT_EQ(events.back().time.flicks, 699);
  }
}

// shows: G33 G104
TEST(Events, BehaveAsASortedMap) {
  EXPECT_TRUE(rc::check("events == map", [] {
    Events events;
    Model model;
    std::vector<std::pair<Events, Model>> kept;
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    std::mt19937 random(seed);
    const auto pick = [&](int n) { return static_cast<std::int64_t>(random() % static_cast<unsigned>(n)) - n / 4; };
    for (int step = 0; step < 900; ++step) {
      if (step % 100 == 0) kept.emplace_back(events, model);
      if (random() % 50 == 0) {
        const auto from = pick(1500), to = from + pick(200);
        const auto low = model.lower_bound(from), high = to < from ? low : model.upper_bound(to);
        RC_ASSERT(events.erase({from}, {to}) == static_cast<std::size_t>(std::distance(low, high)));
        model.erase(low, high);
      } else if (random() % 50 == 0) {
        const auto from = pick(1500), to = from + 100;
        std::size_t n = 0;
        for (auto& [t, v] : model)
          if (t >= from && t <= to) v += 1, ++n;
        RC_ASSERT(events.edit_between({from}, {to}, [](Event& e) { e.value = std::get<double>(e.value) + 1; }) == n);
      } else {
        const auto t = pick(1500);
        events.put(event(t, step));
        model[t] = step;
      }
    }
    kept.emplace_back(events, model);
    for (const auto& [e, m] : kept) RC_ASSERT(content(e) == m);  // copies never saw what came later
    for (int i = 0; i < 100; ++i) {
      const auto t = pick(1500), to = t + pick(300);
      const auto found = model.find(t);
      const Event* e = events.find({t});
      RC_ASSERT((e != nullptr) == (found != model.end()));
      if (e) RC_ASSERT(std::get<double>(e->value) == found->second);
      Model part;
      for (const Event& x : events.between({t}, {to})) part[x.time.flicks] = std::get<double>(x.value);
      RC_ASSERT(part == (to < t ? Model{} : Model(model.lower_bound(t), model.upper_bound(to))));
    }
  }));
}

// shows: G98
// Long tracks, most of whose chunks are on shelves.
TEST(Events, BehaveAsASortedMapIfTheyAreMany) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    std::mt19937 random(seed);
    Events events;
    Model model;
    std::vector<std::pair<Events, Model>> kept;
    const auto pick = [&] { return static_cast<std::int64_t>(random() % 300'000); };
    for (int step = 0; step < 90'000; ++step) {
      const auto t = seed % 2 ? pick() : step < 60'000 ? 5 * step : pick();
      if (step % 15'000 == 7'000) kept.emplace_back(events, model);
      if (step > 50'000 && random() % 2000 == 0) {
        const auto from = pick(), to = from + static_cast<std::int64_t>(random() % (seed > 1 ? 90'000 : 900));
        const auto low = model.lower_bound(from), high = model.upper_bound(to);
        ASSERT_EQ(events.erase({from}, {to}), static_cast<std::size_t>(std::distance(low, high)));
        model.erase(low, high);
        if (!model.empty()) {
          ASSERT_EQ(events.back().time.flicks, model.rbegin()->first);
        }
      } else {
        events.put(event(t, step));
        model[t] = step;
      }
    }
    kept.emplace_back(events, model);
    for (const auto& [e, m] : kept) EXPECT_EQ(content(e), m);
    EXPECT_EQ(events.size(), model.size());
    for (int i = 0; i < 2000; ++i) {
      const auto t = pick() - 10;
      const auto from = model.lower_bound(t);
      const Event *at = events.first_from({t}), *before = events.last_before({t});
      ASSERT_EQ(at != nullptr, from != model.end());
      if (at) {
        ASSERT_EQ(at->time.flicks, from->first);
      }
      ASSERT_EQ(before != nullptr, from != model.begin());
      if (before) {
        ASSERT_EQ(before->time.flicks, std::prev(from)->first);
      }
      ASSERT_EQ(events.count({t}, {t + 500}),
                static_cast<std::size_t>(std::distance(from, model.upper_bound(t + 500))));
    }
    Events edited = events;
    EXPECT_EQ(edited.edit_between({100'000}, {100'500}, [](Event& e) { e.value = 7.0; }),
              events.count({100'000}, {100'500}));
    EXPECT_EQ(content(events), model);
    EXPECT_LT(events.bytes_apart(edited), events.bytes() / 20);
    EXPECT_EQ(events.erase({INT64_MIN}, {INT64_MAX}), model.size());
    EXPECT_TRUE(events.empty());
    EXPECT_TRUE(events.put(event(1, 1)) == false && events.front().time.flicks == 1);
  }
}

TEST(Events, AnEmptyDetailIsNoDetail) {
  Event a = event(1, 2), b = a;
  b.detail.edit();
  EXPECT_EQ(a, b);
  b.detail.edit().ease_in = {5};
  EXPECT_NE(a, b);
  const Event c = b;
  b.detail.edit().ease_in = {6};
  EXPECT_EQ(c.detail->ease_in, Time{5});
}

// Versions share the memory of their events, and append to it in place. None may see what another appends.
TEST(Events, VersionsStayAsTheyWere) {
  std::mt19937 random(6);
  for (int round = 0; round < 12; ++round) {
    Events now;
    Model model;
    std::vector<std::pair<Events, Model>> kept;
    for (int k = 0; k < 3000; ++k) {
      const std::int64_t end = model.empty() ? 0 : model.rbegin()->first + 1, place = random() % 5000;
      const auto what = random() % 40;
      if (what < 30) {
        const std::int64_t t = what < 24 ? end : place;
        now.put(event(t, k)), model[t] = k;
      } else if (what == 30) {
        const std::int64_t to = place + random() % 60;
        now.erase({place}, {to});
        model.erase(model.lower_bound(place), model.upper_bound(to));
      } else if (what == 31) {
        now.edit_between({place}, {place + 40}, [](Event& e) { e.value = -1.0; });
        for (auto i = model.lower_bound(place); i != model.upper_bound(place + 40); ++i) i->second = -1;
      } else if (what < 37) {
        kept.emplace_back(now, model);
        if (kept.size() > 25) kept.erase(kept.begin() + random() % 25);
      } else if (!kept.empty()) {  // another branch goes on from an earlier version
        std::tie(now, model) = kept[random() % kept.size()];
      }
      if (k % 97 == 0)
        for (const auto& [events, expected] : kept) ASSERT_EQ(content(events), expected) << round << ' ' << k;
    }
    EXPECT_EQ(content(now), model);
  }
}

TEST(Events, ThreadsAppendToOneVersion) {
  Events first;
  for (int t = 0; t < 70; ++t) first.put(event(t, t));
  std::vector<Events> versions(4, first);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&versions, i] {
      for (int t = 70; t < 400; ++t) versions[static_cast<std::size_t>(i)].put(event(t, 1000 * i + t));
    });
  for (std::thread& t : threads) t.join();
  for (int i = 0; i < 4; ++i) {
    const Model all = content(versions[static_cast<std::size_t>(i)]);
    ASSERT_EQ(all.size(), 400U);
    for (const auto& [t, value] : all) EXPECT_EQ(value, t < 70 ? t : 1000 * i + t);
  }
  EXPECT_EQ(first.size(), 70U);
}

}  // namespace
}  // namespace betwixt
