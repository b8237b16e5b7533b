// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/contacts.h"

#include <gtest/gtest.h>

#include <set>

#include "program/contact_scenes.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

Item thing(std::uint32_t id, Kind kind, Vec3 at, Vec3 size = {1, 1, 1}) {
  Shape s;
  s.kind = kind, s.size = size, s.radius = size.x;
  Item item;
  item.id = {id};
  item.world = translation(at);
  item.shape = std::make_shared<const Shape>(s);
  return item;
}
std::vector<std::uint32_t> ids(const std::vector<ObjectId>& all) {
  std::vector<std::uint32_t> out;
  for (const ObjectId id : all) out.push_back(id.index);
  return out;
}

// What a thing reaches, from its corners or from points all over it.
Extent around(const Item& item) {
  const Extent e = extent(*item.shape);
  Extent out{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = transform_point(item.world, {corner & 1 ? e.high.x : e.low.x, corner & 2 ? e.high.y : e.low.y,
                                                corner & 4 ? e.high.z : e.low.z});
    for (int i = 0; i < 3; ++i) out.low[i] = std::min(out.low[i], p[i]), out.high[i] = std::max(out.high[i], p[i]);
  }
  return out;
}
bool overlap(Vec3 al, Vec3 ah, Vec3 bl, Vec3 bh) {
  for (int i = 0; i < 3; ++i)
    if (ah[i] < bl[i] || bh[i] < al[i]) return false;
  return true;
}

Frame random_frame(Random& r, std::size_t count) {
  std::vector<Item> items;
  // Few sizes, on a grid now and then: much that only just touches.
  const bool grid = r() % 2, far = r() % 8 == 0;
  const double room = between(r, 0.5, 20);
  for (std::uint32_t i = 0; i < count; ++i) {
    Vec3 at = vector(r, room), size{between(r, 0, 3), between(r, 0, 3), between(r, 0, 3)};
    if (grid) at = {std::round(at.x), std::round(at.y), std::round(at.z)}, size = {1, 1, 1};
    if (far) at = at + Vec3{1e9, -1e9, 3e8};
    Item item = thing(i, Kind::box, at, size);
    if (r() % 3 == 0) item.world = item.world * rotation(axis_angle(vector(r, 1), between(r, 0, 6)));
    if (r() % 40 == 0) item.world(0, 3) = 1e30;
    if (r() % 4 == 0) item.body = {static_cast<std::uint32_t>(r() % count)};
    items.push_back(item);
  }
  return frame(std::move(items));
}

// shows: C148 C152 C153
TEST(Contacts, AreTheBoxesThatOverlapByComparingEachWithEach) {
  Random r(1);
  std::size_t found = 0;
  for (int round = 0; round < 1000; ++round) {
    const Frame f = random_frame(r, 2 + r() % 60);
    for (const bool related : {false, true}) {
      const Contacts c = contacts(f, {related, 16.0 / 9});
      ASSERT_EQ(c.boxes.size(), f.items.size());
      Pairs want;
      for (std::size_t i = 0; i < c.boxes.size(); ++i) {
        const Extent e = around(f.items[i]);
        for (int k = 0; k < 3; ++k) {
          const double size = 1e-14 * std::max(1.0, std::abs(e.low[k]));
          EXPECT_NEAR(c.boxes[i].low[k], e.low[k], size);
          EXPECT_NEAR(c.boxes[i].high[k], e.high[k], size);
        }
        for (std::size_t k = i + 1; k < c.boxes.size(); ++k) {
          const auto body = [&](std::size_t n) { return f.items[n].body ? f.items[n].body : f.items[n].id; };
          if (overlap(c.boxes[i].low, c.boxes[i].high, c.boxes[k].low, c.boxes[k].high) &&
              (related || body(i) != body(k)))
            want.emplace_back(c.boxes[i].id.index, c.boxes[k].id.index);
        }
      }
      ASSERT_EQ(pairs(c.pairs), want) << round;
      found += want.size();
      // Groups: whatever is reached from the first by pairs.
      std::vector<std::set<std::uint32_t>> groups;
      std::set<std::uint32_t> seen;
      for (const auto& start : want) {
        if (seen.count(start.first)) continue;
        std::set<std::uint32_t> group{start.first};
        for (std::size_t before = 0; before != group.size();) {
          before = group.size();
          for (const auto& [a, b] : want)
            if (group.count(a) || group.count(b)) group.insert(a), group.insert(b);
        }
        seen.insert(group.begin(), group.end());
        if (group.size() > 2) groups.push_back(group);
      }
      ASSERT_EQ(c.groups.size(), groups.size());
      for (std::size_t g = 0; g < groups.size(); ++g) {
        EXPECT_EQ(ids(c.groups[g].objects), std::vector<std::uint32_t>(groups[g].begin(), groups[g].end()));
        Pairs of_group;
        for (const auto& p : want)
          if (groups[g].count(p.first)) of_group.push_back(p);
        EXPECT_EQ(pairs(c.groups[g].pairs), of_group);
      }
    }
  }
  EXPECT_GT(found, 10'000U);
}

TEST(Contacts, RoundThingsHaveTightBoxesHoweverTheyTurn) {
  Random r(2);
  for (const Kind kind : {Kind::sphere, Kind::disc, Kind::cylinder, Kind::torus, Kind::box, Kind::cone}) {
    for (int round = 0; round < 20; ++round) {
      Item item = thing(0, kind, {}, {0.5, 2, 1});
      Shape s = *item.shape;
      s.height = 2, s.tube = 0.2;
      item.shape = std::make_shared<const Shape>(s);
      item.world =
          translation(vector(r, 5)) * rotation(axis_angle(vector(r, 1), between(r, 0, 6))) * scaling({1, 3, 0.5});
      const Contacts c = contacts(frame({item}));
      Extent points{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
      const auto put = [&](Vec3 own) {
        const Vec3 p = transform_point(item.world, own);
        for (int i = 0; i < 3; ++i)
          points.low[i] = std::min(points.low[i], p[i]), points.high[i] = std::max(points.high[i], p[i]);
      };
      for (double u = 0; u < 2 * pi; u += 0.02)
        for (double v = -pi; v < pi; v += 0.1) {
          if (kind == Kind::sphere) put(0.5 * Vec3{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)});
          if (kind == Kind::disc) put(0.5 * Vec3{std::cos(u), std::sin(u), 0});
          if (kind == Kind::cylinder) put({0.5 * std::cos(u), v < 0 ? -1.0 : 1.0, 0.5 * std::sin(u)});
          if (kind == Kind::torus) {
            const double w = 0.5 + 0.2 * std::cos(v);
            put({w * std::cos(u), 0.2 * std::sin(v), w * std::sin(u)});
          }
        }
      const bool sampled = points.low.x < 1e299;
      if (!sampled) points = around(item);
      for (int i = 0; i < 3; ++i) {
        EXPECT_LE(c.boxes[0].low[i], points.low[i] + 1e-12);
        EXPECT_GE(c.boxes[0].high[i], points.high[i] - 1e-12);
        EXPECT_NEAR(c.boxes[0].low[i], points.low[i], sampled ? 0.01 : 1e-12);
        EXPECT_NEAR(c.boxes[0].high[i], points.high[i], sampled ? 0.01 : 1e-12);
      }
    }
  }
}

TEST(Contacts, OfAShapeOnItsWayToAnother) {
  Item item = thing(0, Kind::box, {10, 0, 0}, {2, 2, 2});
  item.toward = thing(0, Kind::box, {}, {6, 2, 2}).shape;
  const auto high = [&](double blend) {
    item.blend = blend;
    return contacts(frame({item})).boxes.at(0).high.x - 10;
  };
  EXPECT_DOUBLE_EQ(high(0), 1);
  EXPECT_DOUBLE_EQ(high(0.25), 1.5);
  EXPECT_DOUBLE_EQ(high(1), 3);
  // Beyond: a point at 1 may go to -3, and on to -3.4; one at -1 goes to 3 and on to 3.4.
  EXPECT_DOUBLE_EQ(high(1.1), 3.4);
}

TEST(Contacts, NothingFallsOverWhateverComes) {
  EXPECT_TRUE(contacts(frame({})).boxes.empty());
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  std::vector<Item> items{thing(0, Kind::box, {inf, 0, 0}),
                          thing(1, Kind::box, {nan, 0, 0}),
                          thing(2, Kind::box, {1e308, 1e308, -1e308}),
                          thing(3, Kind::box, {-1e308, 0, 0}),
                          thing(4, Kind::sphere, {}, {-1, 1, 1}),
                          thing(5, Kind::text, {}),
                          thing(6, Kind::polygon, {}),
                          thing(7, Kind::mesh, {}),
                          thing(8, Kind::sphere, {}),
                          thing(9, Kind::box, {0, 0, 0}, {1e200, 1, 1})};
  Frame f = frame(items);
  EXPECT_EQ(pairs(contacts(f).pairs), (Pairs{{8, 9}}));
  f.camera.world(0, 0) = nan;
  f.camera.fov = inf;
  EXPECT_EQ(contacts(f).boxes.size(), 4U);
  EXPECT_EQ(contacts(f, {false, nan}).boxes.size(), 4U);
  // All at one place: the tree is balanced, and what is too much is said.
  std::vector<Item> heap;
  for (std::uint32_t i = 0; i < 3000; ++i) heap.push_back(thing(i, Kind::sphere, {}));
  const Contacts all = contacts(frame(heap));
  EXPECT_FALSE(all.complete);
  EXPECT_EQ(all.pairs.size(), Contacts::most_pairs);
  heap.resize(1000);
  const Contacts some = contacts(frame(heap));
  EXPECT_TRUE(some.complete);
  EXPECT_EQ(some.pairs.size(), 1000U * 999 / 2);
  ASSERT_EQ(some.groups.size(), 1U);
  EXPECT_EQ(some.groups[0].objects.size(), 1000U);
}

// ---- Swept

// shows: C148
TEST(Swept, FindsWhatSlipsThroughBetweenTwoTicks) {
  // A ball of radius 0.1 goes from x = -2 to x = 2 in 1/30 s; a wall 0.2 thick stands at 0. It touches from
  // x = -0.2 on, when 1.8 of 4 metres are gone.
  const auto ball = [](double x) { return thing(0, Kind::sphere, {x, 0, 0}, {0.1, 1, 1}); };
  const auto wall = thing(1, Kind::box, {}, {0.2, 4, 4});
  const Frame before = frame({ball(-2), wall}), after = frame({ball(2), wall}, 1.0 / 30);
  EXPECT_TRUE(contacts(before).pairs.empty());
  EXPECT_TRUE(contacts(after).pairs.empty());
  const Contacts c = swept(before, after);
  ASSERT_EQ(pairs(c.pairs), (Pairs{{0, 1}}));
  EXPECT_NEAR(c.pairs[0].time.seconds(), 1.8 / 4 / 30, 1e-9);
  EXPECT_EQ(c.time, after.time);
  // Two that change places beside each other do not meet; their hulls overlap all the same.
  const auto low = [](double x) { return thing(0, Kind::box, {x, -x, 0}); };
  const auto high = [](double x) { return thing(1, Kind::box, {x, -x + 2.5, 0}); };
  EXPECT_TRUE(swept(frame({low(-3), high(-3)}), frame({low(3), high(3)}, 1)).pairs.empty());

  ContactWatch sampled, sweeping({}, true);
  sampled.seek(before), sweeping.seek(before);
  const auto count = [](const std::vector<ContactEvent>& all) {
    return std::count_if(all.begin(), all.end(), [](const auto& e) { return e.what == ContactEvent::What::contact; });
  };
  EXPECT_EQ(count(sampled.step(after)), 0);
  const auto events = sweeping.step(after);
  ASSERT_EQ(count(events), 2);
  EXPECT_TRUE(events[0].begin);
  EXPECT_FALSE(events[1].begin);
  EXPECT_EQ(ids(events[1].objects), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_TRUE(sweeping.now().pairs.empty());
}

TEST(Swept, IsWhatSmallStepsFind) {
  Random r(3);
  int found = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Item> before, after;
    for (std::uint32_t i = 0; i < 12; ++i) {
      const Vec3 size{between(r, 0.2, 1.5), between(r, 0.2, 1.5), between(r, 0.2, 1.5)};
      if (r() % 8) before.push_back(thing(i, Kind::box, vector(r, 4), size));
      if (r() % 8) after.push_back(thing(i, Kind::box, vector(r, 4), size));
    }
    const Frame a = frame(before), b = frame(after, 1);
    const Contacts c = swept(a, b);
    const auto has = [&](std::uint32_t x, std::uint32_t y) { return c.touching({x}, {y}); };
    const Contacts first = contacts(a), last = contacts(b);
    for (const auto& [x, y] : pairs(first.pairs)) EXPECT_TRUE(has(x, y));
    for (const auto& [x, y] : pairs(last.pairs)) EXPECT_TRUE(has(x, y));
    std::set<std::pair<std::uint32_t, std::uint32_t>> stepped;
    for (const auto* f : {&first, &last})
      for (const auto& p : pairs(f->pairs)) stepped.insert(p);
    constexpr int steps = 4000;
    for (const ContactBox& x : first.boxes)
      for (const ContactBox& y : first.boxes) {
        const ContactBox *tx = last.find(x.id), *ty = last.find(y.id);
        if (x.id.index >= y.id.index || !tx || !ty) continue;
        for (int k = 0; k <= steps && !stepped.count({x.id.index, y.id.index}); ++k) {
          const double s = k / double(steps);
          const auto at = [&](Vec3 p, Vec3 q) { return (1 - s) * p + s * q; };
          if (overlap(at(x.low, tx->low), at(x.high, tx->high), at(y.low, ty->low), at(y.high, ty->high)))
            stepped.insert({x.id.index, y.id.index});
        }
      }
    for (const auto& p : stepped) EXPECT_TRUE(has(p.first, p.second)) << round;
    // Steps may miss what touches for less than one of them.
    EXPECT_LE(c.pairs.size(), stepped.size() + 1) << round;
    found += static_cast<int>(c.pairs.size());
  }
  EXPECT_GT(found, 500);
}

// ---- Sight

// shows: C149
TEST(Sight, IsExactByManyPointsOfTheBox) {
  Random r(4);
  int seen[3] = {};
  for (int round = 0; round < 3000; ++round) {
    Frame f;
    f.camera.world = translation(vector(r, 3)) * rotation(axis_angle(vector(r, 1), between(r, 0, 6)));
    f.camera.orthographic = round % 3 == 0;
    f.camera.fov = between(r, 0.1, 2.8), f.camera.height = between(r, 0.5, 8);
    const double aspect = between(r, 0.4, 2.5);
    f.items.push_back(thing(0, Kind::box, vector(r, 5), {between(r, 0, 6), between(r, 0, 2), between(r, 0, 2)}));
    const ContactBox b = contacts(f, {false, aspect}).boxes.at(0);
    ++seen[static_cast<int>(b.sight)];
    bool some = false, all = true;
    constexpr int n = 14;
    for (int i = 0; i <= n; ++i)
      for (int k = 0; k <= n; ++k)
        for (int m = 0; m <= n; ++m) {
          const Vec3 p = b.low + Vec3{i / double(n), k / double(n), m / double(n)} * (b.high - b.low);
          const Mat4 turn = f.camera.world;
          const Vec3 d = p - translation_of(turn);
          const double x = d.x * turn(0, 0) + d.y * turn(1, 0) + d.z * turn(2, 0);
          const double y = d.x * turn(0, 1) + d.y * turn(1, 1) + d.z * turn(2, 1);
          const double depth = -(d.x * turn(0, 2) + d.y * turn(1, 2) + d.z * turn(2, 2));
          const double wide = f.camera.orthographic ? f.camera.height / 2 * aspect : depth * std::tan(f.camera.fov / 2);
          const bool in = depth > 0 && std::abs(x) < wide && std::abs(y) < wide / aspect;
          some = some || in, all = all && in;
        }
    EXPECT_FALSE(b.sight == Sight::out && some) << round;
    EXPECT_FALSE(b.sight == Sight::in && !all) << round;
    if (!some && b.sight == Sight::boundary) {
      // It may touch between the points: then a box larger by a step of them does.
      const Vec3 more = (1.0 / n) * (b.high - b.low);
      bool near = false;
      for (int i = -20; i <= 20 && !near; ++i)
        for (int k = -20; k <= 20 && !near; ++k)
          for (int m = -20; m <= 20 && !near; ++m) {
            const Vec3 p = 0.5 * (b.low + b.high) + Vec3{i / 40.0, k / 40.0, m / 40.0} * (b.high - b.low + 2 * more);
            const Vec3 d = p - translation_of(f.camera.world);
            const Mat4& t = f.camera.world;
            const double x = d.x * t(0, 0) + d.y * t(1, 0) + d.z * t(2, 0);
            const double y = d.x * t(0, 1) + d.y * t(1, 1) + d.z * t(2, 1);
            const double depth = -(d.x * t(0, 2) + d.y * t(1, 2) + d.z * t(2, 2));
            const double wide =
                f.camera.orthographic ? f.camera.height / 2 * aspect : depth * std::tan(f.camera.fov / 2);
            near = depth >= 0 && std::abs(x) <= wide && std::abs(y) <= wide / aspect;
          }
      EXPECT_TRUE(near) << round;
    }
  }
  EXPECT_GT(seen[0], 200);
  EXPECT_GT(seen[1], 200);
  EXPECT_GT(seen[2], 100);
}

TEST(Sight, TouchingTheWindowIsItsBoundary) {
  Frame f;
  f.camera.orthographic = true, f.camera.height = 10;  // x from -10 to 10 at 2:1
  const auto at = [&](Vec3 p) {
    f.items = {thing(0, Kind::box, p)};
    return contacts(f, {false, 2}).boxes.at(0).sight;
  };
  EXPECT_EQ(at({0, 0, -5}), Sight::in);
  EXPECT_EQ(at({9.5, 0, -5}), Sight::boundary);
  EXPECT_EQ(at({9.25, 0, -5}), Sight::in);
  EXPECT_EQ(at({10.5, 0, -5}), Sight::boundary);
  EXPECT_EQ(at({10.75, 0, -5}), Sight::out);
  EXPECT_EQ(at({0, 5.5, -5}), Sight::boundary);
  EXPECT_EQ(at({0, 5.75, -5}), Sight::out);
  EXPECT_EQ(at({0, 0, 0}), Sight::boundary);  // the camera's plane goes through it
  EXPECT_EQ(at({0, 0, 0.75}), Sight::out);    // behind
  EXPECT_EQ(at({0, 0, -1e12}), Sight::in);    // nothing is too far
  f.camera.orthographic = false, f.camera.fov = pi / 2;
  EXPECT_EQ(at({0, 0, 0}), Sight::boundary);  // the eye is in it
  EXPECT_EQ(at({0, 0, 3}), Sight::out);
  EXPECT_EQ(at({0, 0, -5}), Sight::in);
  EXPECT_EQ(at({6.25, 0, -5}), Sight::out);
  EXPECT_EQ(at({5.25, 0, -5}), Sight::boundary);
}

TEST(Contacts, WhatIsOneBodyMayAlwaysTouch) {
  Scene s;
  const ObjectId stage = add(s, "stage", Kind::group);
  const ObjectId a = add(s, "a", Kind::sphere, stage), hat = add(s, "hat", Kind::cone, a);
  const ObjectId b = add(s, "b", Kind::sphere, stage);
  const ObjectId car = add(s, "car", Kind::group, stage);
  const ObjectId body = add(s, "car/body", Kind::box, car), wheel = add(s, "car/wheel", Kind::cylinder, car);
  const Program p = compile(s);
  EXPECT_EQ(pairs(p.contacts({}).pairs), (Pairs{{a.index, b.index},
                                                {a.index, body.index},
                                                {a.index, wheel.index},
                                                {hat.index, b.index},
                                                {hat.index, body.index},
                                                {hat.index, wheel.index},
                                                {b.index, body.index},
                                                {b.index, wheel.index}}));
  EXPECT_EQ(p.contacts({}, {true, 16.0 / 9}).pairs.size(), 10U);
  // The same from the whole frame.
  EXPECT_EQ(pairs(contacts(p.frame({})).pairs), pairs(p.contacts({}).pairs));
}

}  // namespace
}  // namespace betwixt
