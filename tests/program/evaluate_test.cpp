// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "program/compiled.h"
#include "program/programs.h"

namespace betwixt {
namespace {

void expect_same(const Frame& a, const Frame& b) {  // bit for bit
  ASSERT_EQ(a.items.size(), b.items.size());
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    EXPECT_EQ(a.items[i].world, b.items[i].world);
    EXPECT_EQ(a.items[i].color, b.items[i].color);
    EXPECT_EQ(*a.items[i].shape, *b.items[i].shape);
    EXPECT_EQ(a.items[i].blend, b.items[i].blend);
  }
  EXPECT_EQ(a.camera.world, b.camera.world);
  EXPECT_EQ(a.camera.fov, b.camera.fov);
}

// shows: G47 G89
TEST(Frame, IsTheSameInAnyOrderAndOnAnyThread) {
  Scene s;
  std::mt19937 random(3);
  const auto pick = [&] { return static_cast<double>(random() % 1000) / 100 - 5; };
  ObjectId last;
  for (int i = 0; i < 40; ++i) {
    const ObjectId id = add(s, "b" + std::to_string(i), i % 5 ? Kind::sphere : Kind::box, i % 3 ? last : ObjectId{});
    last = id;
    for (int k = 0; k < 6; ++k) {
      put_event(s, {id, fn::position}, event(k, Vec3{pick(), pick(), pick()}));
      put_event(s, {id, fn::rotation}, event(k, axis_angle({pick(), pick(), 1}, pick())));
      put_event(s, {id, fn::color}, event(k, Color{0.1 * k, 0.5, 1}));
      if (i % 5) put_event(s, {id, fn::radius}, event(k, 6 + pick()));
    }
  }
  const Program p = compile(s);
  std::vector<Frame> in_order;
  for (int k = 0; k < 120; ++k) in_order.push_back(p.frame(s.rate.frame(k + 1)));
  const auto shuffled = [&](unsigned seed) {
    std::vector<int> order;
    for (int k = 0; k < 120; ++k) order.push_back(k);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    for (int k : order) expect_same(p.frame(s.rate.frame(k + 1)), in_order[static_cast<std::size_t>(k)]);
  };
  std::thread other([&] { shuffled(1); });
  shuffled(2);
  other.join();
  const Program fresh = compile(s);  // nobody has asked it for its camera yet: both threads do
  Frame a, b;
  std::thread one([&] { a = fresh.frame({}); });
  b = fresh.frame({});
  one.join();
  expect_same(a, b);
  expect_same(a, in_order[0]);
}

// shows: G28
TEST(Frame, HiddenObjectsStillCarryOthers) {
  Scene s;
  const ObjectId car = add(s, "car", Kind::box), wheel = add(s, "wheel", Kind::sphere, car);
  put_event(s, {car, fn::display}, event(0, true));
  put_event(s, {car, fn::display}, event(1, false));
  set_value(s, {car, fn::position}, Vec3{5, 0, 0});
  const Program p = compile(s);
  EXPECT_EQ(p.frame({}).items.size(), 2U);
  const Frame f = p.frame(from_seconds(1));
  ASSERT_EQ(f.items.size(), 1U);
  EXPECT_EQ(f.items[0].id, wheel);
  EXPECT_EQ(translation_of(f.items[0].world).x, 5);
  EXPECT_EQ(std::get<bool>(p.read({car, fn::display}, from_seconds(0.99))), true);
}

TEST(Frame, WhoCastsShadowsIsInIt) {
  Scene s;
  const ObjectId ball = add(s, "ball"), lamp = add(s, "lamp", Kind::light), other = add(s, "other", Kind::light);
  for (const auto& [second, word] : {std::pair{0, "off"}, {1, "on"}, {2, "soft"}, {3, "auto"}})
    put_event(s, {lamp, fn::casting}, event(second, Text(std::string(word))));
  set_value(s, {other, fn::casting}, Text(std::string("soft")));
  put_event(s, {ball, fn::casts}, event(0, true));
  put_event(s, {ball, fn::casts}, event(2, false));
  const Program p = compile(s);
  const Casting wanted[] = {Casting::off, Casting::on, Casting::soft, Casting::strongest};
  for (int second = 0; second < 4; ++second) {
    const Frame f = p.frame(from_seconds(second));
    EXPECT_EQ(f.items[0].casts, second < 2);
    EXPECT_EQ(f.lights[0].casting, wanted[second]);
    EXPECT_EQ(f.lights[1].casting, Casting::soft);
  }
  Scene plain;
  add(plain, "ball"), add(plain, "lamp", Kind::light);
  EXPECT_TRUE(compile(plain).frame({}).items[0].casts);
  EXPECT_EQ(compile(plain).frame({}).lights[0].casting, Casting::strongest);
}

// shows: G28 G47
TEST(Frame, LooksComeFromTheTracks) {
  Scene s;
  const ObjectId ball = add(s, "ball"), box = add(s, "box", Kind::box);
  set_value(s, {box, fn::box_size}, Vec3{1, 2, 3});
  set_value(s, {ball, fn::transparency}, 7.0);
  set_value(s, {ball, fn::material}, Text(std::string("metal")));
  put_event(s, {ball, fn::radius}, event(0, 1.0, Twerper::linear));
  put_event(s, {ball, fn::radius}, event(2, 3.0));
  put_event(s, {ball, fn::color}, event(0, Color{0, 0, 0}));
  put_event(s, {ball, fn::color}, event(2, Color{1, 1, 1}));
  put_event(s, {ball, fn::geometry}, event(1, box, Twerper::linear));
  put_event(s, {ball, fn::geometry}, event(2, ObjectId{}));
  s.background = Color{1, 0, 0.5};
  s.notes.edit() = {{from_seconds(1), {from_seconds(1), "half way", {}}}};
  const Program p = compile(s);
  const Frame f = p.frame(from_seconds(1));
  const Item& item = f.items[0];
  EXPECT_EQ(item.shape->kind, Kind::box);
  EXPECT_EQ(item.shape->size, (Vec3{1, 2, 3}));
  EXPECT_EQ(item.toward, nullptr);
  EXPECT_EQ(item.transparency, 1);
  EXPECT_EQ(item.material, Material::metal);
  expect_near(item.color, {0.5, 0.5, 0.5});
  EXPECT_NEAR(std::get<Color>(p.read({ball, fn::color}, from_seconds(1))).g, 0.735356983052449, 1e-12);
  expect_near(*f.background, {1, 0, 0.21404114048223255});
  EXPECT_EQ(f.notes, std::vector<std::string>{"half way"});
  const Frame later = p.frame(from_seconds(1.5));
  EXPECT_EQ(later.items[0].shape->kind, Kind::box);
  ASSERT_TRUE(later.items[0].toward);
  EXPECT_EQ(later.items[0].toward->kind, Kind::sphere);
  EXPECT_EQ(later.items[0].toward->radius, 2.5);
  EXPECT_EQ(later.items[0].blend, 0.5);
  EXPECT_EQ(later.notes.size(), 0U);
}

TEST(Lights, ReachTimesTheirOwnScale) {
  Scene s;
  const ObjectId arm = add(s, "arm", Kind::group), lamp = add(s, "lamp", Kind::light, arm);
  set_value(s, {arm, fn::scale}, Vec3{10, 10, 10});
  set_value(s, {lamp, fn::scale}, Vec3{2, 2, 2});
  set_value(s, {lamp, fn::position}, Vec3{0, 1, 0});
  set_value(s, {lamp, fn::range}, 7.0);
  set_value(s, {lamp, fn::intensity}, 3.0);
  set_value(s, {lamp, fn::color}, Color{1, 0.5, 0});
  set_value(s, {lamp, fn::shines}, Text(std::string("sun")));
  const Frame f = compile(s).frame({});
  ASSERT_EQ(f.lights.size(), 1U);
  EXPECT_EQ(f.lights[0].range, 14);
  expect_near(f.lights[0].position, {0, 10, 0});  // scale is inherited by what is coupled
  expect_near(f.lights[0].color, {3, 3 * 0.21404114048223255, 0});
  EXPECT_TRUE(f.lights[0].sun);
  expect_near(f.lights[0].direction, {0, -1, 0});
}

// shows: G62
TEST(Cameras, LookAtPointsAndObjects) {
  Scene s;
  const ObjectId eye = add(s, "eye", Kind::camera), ball = add(s, "ball"), lamp = add(s, "lamp", Kind::light, eye);
  set_value(s, {eye, fn::position}, Vec3{1, 2, 3});
  set_value(s, {eye, fn::look_at}, ball);
  set_value(s, {lamp, fn::position}, Vec3{0, 0, -2});
  put_event(s, {ball, fn::position}, event(0, Vec3{4, 2, 7}, Twerper::linear));
  put_event(s, {ball, fn::position}, event(1, Vec3{1, 9, 3}));  // straight above the camera
  const Program p = compile(s);
  for (double t : {0.0, 0.5, 0.9, 1.0}) {
    const Camera c = p.frame(from_seconds(t)).camera;
    const Vec3 target = translation_of(world(p, ball, t)), way = normalize(target - Vec3{1, 2, 3});
    expect_near(translation_of(c.world), {1, 2, 3});
    expect_near(transform_vector(c.world, {0, 0, -1}), way);
    Mat4 transposed;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) transposed(i, k) = c.world(k, i);
    Mat4 turn = c.world;
    turn(0, 3) = turn(1, 3) = turn(2, 3) = 0;
    expect_near(turn * transposed, Mat4{});
    EXPECT_GT(transform_vector(c.world, {0, 1, 0}).y, t < 1 ? 0 : -1e-9);     // y up as far as may be
    expect_near(translation_of(world(p, lamp, t)), Vec3{1, 2, 3} + 2 * way);  // turns with the camera
  }
  expect_near(look_at({0, 0, 5}, {0, 0, 0}), translation({0, 0, 5}));
}

TEST(Cameras, LensesAndCuts) {
  Scene s;
  const ObjectId a = add(s, "a", Kind::camera), b = add(s, "b", Kind::camera), c = add(s, "c", Kind::camera);
  set_value(s, {a, fn::lens}, 18.0);
  set_value(s, {b, fn::fov}, 1.25);
  set_value(s, {c, fn::camera_height}, 6.0);
  set_value(s, {c, fn::scale}, Vec3{2, 0, 5});
  s.cuts.edit() = {{from_seconds(1), b}, {from_seconds(2), c}};
  const Program p = compile(s);
  EXPECT_NEAR(p.frame({}).camera.fov, pi / 2, 1e-15);  // 18 mm to each side of an 18 mm lens
  EXPECT_EQ(p.frame(from_seconds(1)).camera.fov, 1.25);
  EXPECT_FALSE(p.frame(from_seconds(1.99)).camera.orthographic);
  const Camera last = p.frame(from_seconds(2)).camera;
  EXPECT_TRUE(last.orthographic);
  EXPECT_EQ(last.height, 6);
  expect_near(last.world, Mat4{});  // rigid, whatever the scale
}

TEST(Cameras, TheDefaultOneSeesAll) {
  std::mt19937 random(11);
  const auto pick = [&](double most) { return most * (static_cast<double>(random() % 1000) / 500 - 1); };
  for (int round = 0; round < 60; ++round) {
    Scene s;
    const Vec3 spread{std::pow(10, pick(2)), std::pow(10, pick(2)), std::pow(10, pick(2))};
    for (int i = 0; i < 6; ++i) {
      const ObjectId id = add(s, "b" + std::to_string(i), Kind::box);
      set_value(s, {id, fn::box_size}, Vec3{0.01, 0.01, 0.01});
      set_value(s, {id, fn::position}, spread * Vec3{pick(1), pick(1), pick(1)} + Vec3{5, -7, 100});
    }
    const Frame f = compile(s).frame({});
    const double across = std::tan(f.camera.fov / 2), up = across * 9 / 16;
    for (const Item& item : f.items) {
      const Vec3 from = translation_of(item.world) - translation_of(f.camera.world);
      const auto along = [&](Vec3 axis) { return dot(from, transform_vector(f.camera.world, axis)); };
      const double depth = -along({0, 0, 1});
      ASSERT_GT(depth, 0);
      EXPECT_LT(std::abs(along({1, 0, 0})), across * depth);
      EXPECT_LT(std::abs(along({0, 1, 0})), up * depth);
    }
  }
  EXPECT_NEAR(compile(Scene{}).frame({}).camera.fov, 2 * std::atan(36.0 / 70), 1e-15);
}

// shows: G30
TEST(Components, SplittingATrackKeepsEveryValue) {
  const auto check = [](FunctionId f, std::vector<Event> events, bool srgb, int component) {
    Scene a;
    const ObjectId id = add(a, "ball");
    for (Event& e : events) put_event(a, {id, f}, std::move(e));
    Track* t = edit_track(a, {id, f});
    t->srgb = srgb;
    t->before = Extrapolation::bounce, t->after = Extrapolation::linear;
    Scene b = a;
    ASSERT_TRUE(edit_track(b, {id, f, component}));
    EXPECT_EQ(edit_track(b, {id, f}), nullptr);
    EXPECT_EQ(tracks_of(b, {id, f}).size(), 3U);
    const Document whole(std::make_shared<const Scene>(a)), parts(std::make_shared<const Scene>(b));
    const Program p = Program::compile(whole), q = Program::compile(parts);
    for (double s = -3; s < 6; s += 0.05) {
      const auto x = numbers(p.read({id, f}, from_seconds(s))), y = numbers(q.read({id, f}, from_seconds(s)));
      ASSERT_EQ(x.size(), y.size());
      for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 1e-12) << s;
    }
  };
  Event cut = event(2, Vec3{3, 1, 4});
  cut.detail.edit().before = Value(Vec3{0, 0, 9});
  Event eased = event(1, Vec3{2, 5, -1}, Twerper::hermite);
  eased.detail.edit().ease_in = from_seconds(0.3);
  eased.detail.edit().tangent_out = Value(Vec3{1, 2, 3});
  check(fn::position, {event(0, Vec3{1, 2, 3}), eased, cut, event(4, Vec3{})}, false, 1);
  check(fn::rotation, {event(0, Angles{{0, 1, 9}}), event(1, Angles{{2, 2, 2}}), event(3, Angles{})}, false, 2);
  for (const bool srgb : {false, true})
    check(fn::color,
          {event(0, Color{0, 0.5, 1}), event(1, Color{1, 0.2, 0}, Twerper::smooth), event(3, Color{0, 1, 0})}, srgb, 0);
}

}  // namespace
}  // namespace betwixt
