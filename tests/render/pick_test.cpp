// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/pick.h"

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

Item named(std::uint32_t index, std::shared_ptr<const Shape> shape, const Mat4& world) {
  Item i = item(std::move(shape), world, {1, 1, 1});
  i.id = {index};
  return i;
}
// At a distance d the picture is d metres wide.
Camera perspective(double z) {
  Camera c = frame(z).camera;
  c.orthographic = false;
  c.fov = 2 * std::atan(0.5);
  return c;
}
void expect_near(Vec3 a, Vec3 b, double tolerance) {
  EXPECT_LT(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Pick, AnOrthographicPictureIsWhereItMustBe) {
  const Projection p(frame().camera, 2);  // 20 m by 10 m
  const auto spot = p.spot({5, 2, 3});
  ASSERT_TRUE(spot);
  EXPECT_NEAR(spot->x, 0.75, 1e-12);
  EXPECT_NEAR(spot->y, 0.3, 1e-12);
  EXPECT_NEAR(spot->depth, 7, 1e-12);
  expect_near(p.place(0.75, 0.3, 7), {5, 2, 3}, 1e-12);
  expect_near(p.ray(0.75, 0.3).from, {5, 2, 10}, 1e-12);
  EXPECT_NEAR(p.height(3), 10, 1e-12);
  EXPECT_FALSE(p.spot({0, 0, 11}));
}

TEST(Pick, APerspectiveOneToo) {
  const Projection p(perspective(10), 2);  // at 10 m it is 10 m by 5 m
  const auto spot = p.spot({2, 1, 0});
  ASSERT_TRUE(spot);
  EXPECT_NEAR(spot->x, 0.7, 1e-12);
  EXPECT_NEAR(spot->y, 0.3, 1e-12);
  EXPECT_NEAR(spot->depth, 10, 1e-12);
  EXPECT_NEAR(p.height(10), 5, 1e-12);
  expect_near(p.place(0.7, 0.3, 10), {2, 1, 0}, 1e-12);
  expect_near(p.ray(0.7, 0.3).along, normalize(Vec3{2, 1, -10}), 1e-12);
  EXPECT_FALSE(p.spot({0, 0, 10.5}));
}

TEST(Pick, AShiftedLensMovesAllByHalvesOfThePicture) {
  Camera c = perspective(10);
  c.shift_x = 0.5, c.shift_y = -0.25;
  const Projection p(c, 1);
  const auto spot = p.spot({0, 0, 0});
  EXPECT_NEAR(spot->x, 0.75, 1e-12);
  EXPECT_NEAR(spot->y, 0.625, 1e-12);
  expect_near(p.place(0.75, 0.625, 10), {0, 0, 0}, 1e-12);
}

TEST(Pick, WhatIsDrawnAndWhatIsPickedIsOnePlace) {
  Frame f = frame();
  f.camera = perspective(8);
  f.camera.world = look_at({4, 3, 8}, {1, 0, 0});
  f.items.push_back(named(0, square(), translation({1, 0.5, 0}) * scaling({0.5, 0.3, 1})));
  const auto [x, y] = middle(draw(f, {400, 200, 1, "shaded"}));
  const auto spot = Projection(f.camera, 2).spot({1, 0.5, 0});
  EXPECT_NEAR(spot->x * 400, x, 0.6);
  EXPECT_NEAR(spot->y * 200, y, 0.6);
}

TEST(Pick, ABallIsRound) {
  Frame f = frame();
  f.items.push_back(named(7, sphere(2), translation({1, 0, 0})));
  const Projection p(f.camera, 1);
  const auto hit = pick(f, p, 0.6 + 0.1, 0.5);  // 1 m beside its middle
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->id.index, 7u);
  expect_near(hit->place, {2, 0, std::sqrt(3.0)}, 1e-9);
  EXPECT_NEAR(hit->depth, 10 - std::sqrt(3.0), 1e-9);
  EXPECT_TRUE(pick(f, p, 0.6 + 0.19999, 0.5));
  EXPECT_FALSE(pick(f, p, 0.6 + 0.20001, 0.5));
}

TEST(Pick, WhatIsDrawnFinerIsRounder) {
  const Drawn coarse = drawn(named(0, sphere(2), translation({1, 0, 0}))), fine = drawn(named(0, sphere(2), {}), 400);
  EXPECT_GT(fine.corners.size(), 4 * coarse.corners.size());
  for (const Vec3& corner : fine.corners) EXPECT_NEAR(length(corner), 2, 1e-6);
}

TEST(Pick, TheNearestWinsAndTheLaterOneOfTwoAtOnePlace) {
  Frame f = frame();
  f.items = {named(0, square(), {}), named(1, square(), translation({0, 0, 1})),
             named(2, square(), translation({0, 0, -1}))};
  const Projection p(f.camera, 1);
  EXPECT_EQ(pick(f, p, 0.52, 0.49)->id.index, 1u);
  f.items.push_back(named(3, square(), translation({0, 0, 1})));
  EXPECT_EQ(pick(f, p, 0.52, 0.49)->id.index, 3u);
  std::vector<std::uint32_t> through;
  for (const Hit& h : pick_through(f, p, 0.52, 0.49)) through.push_back(h.id.index);
  EXPECT_EQ(through, (std::vector<std::uint32_t>{3, 1, 0, 2}));
  f.items.back().transparency = 1;  // nothing is seen of it
  EXPECT_EQ(pick(f, p, 0.52, 0.49)->id.index, 1u);
}

TEST(Pick, WhatIsFlatIsFoundFromTheSideToo) {
  Frame f = frame();
  f.items.push_back(named(0, square(), rotation(axis_angle({0, 1, 0}, pi / 3))));
  const Projection p(f.camera, 1);
  const auto hit = pick(f, p, 0.51, 0.5);  // x = 0.1; the square goes back by tan 60° of that
  ASSERT_TRUE(hit);
  expect_near(hit->place, {0.1, 0, -0.1 * std::sqrt(3.0)}, 1e-9);
  EXPECT_FALSE(pick(f, p, 0.53, 0.5));    // it is 0.5 m wide from here
  f.items[0].world = scaling({1, 1, 0});  // a thing that is squashed to nothing is still seen
  EXPECT_TRUE(pick(f, p, 0.51, 0.5));
}

TEST(Pick, WithSlackWhatIsBesideIsFound) {
  Frame f = frame();
  f.items.push_back(named(0, square(), {}));
  const Projection p(f.camera, 1);
  EXPECT_FALSE(pick(f, p, 0.56, 0.5));
  EXPECT_FALSE(pick(f, p, 0.56, 0.5, 0.009));  // 0.1 m of 10
  const auto hit = pick(f, p, 0.56, 0.5, 0.011);
  ASSERT_TRUE(hit);
  expect_near(hit->place, {0.5, 0, 0}, 1e-9);
}

TEST(Pick, TheRectangleAroundAndWhatIsInOne) {
  Frame f = frame();
  f.items = {named(0, square(), {}), named(1, square(), translation({3, 0, 0})),
             named(2, square(), scaling({9, 9, 9}))};
  const Projection p(f.camera, 1);
  const auto r = rectangle_around(drawn(f.items[1]), p);
  ASSERT_TRUE(r);
  EXPECT_NEAR(r->left, 0.75, 1e-12);
  EXPECT_NEAR(r->right, 0.85, 1e-12);
  EXPECT_NEAR(r->top, 0.45, 1e-12);
  EXPECT_NEAR(r->bottom, 0.55, 1e-12);
  const auto in = [&](Projection::Rectangle box) {
    std::vector<std::uint32_t> out;
    for (const ObjectId id : pick_within(f, p, box)) out.push_back(id.index);
    return out;
  };
  EXPECT_EQ(in({0.4, 0.4, 0.86, 0.6}), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(in({0.4, 0.4, 0.8, 0.6}), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(in({0, 0, 1, 1}), (std::vector<std::uint32_t>{0, 1, 2}));
  f.camera.world = translation({0, 0, -5});
  EXPECT_FALSE(rectangle_around(drawn(f.items[1]), Projection(f.camera, 1)));
}

// Whatever the kind: what is drawn in the middle of a bright place is picked there.
TEST(Pick, ThingsOfAllKindsAreFoundWhereTheyAreSeen) {
  const Loaded l = load_text(R"(
film flat
create a text text="H" size=4
create b curve points=((0 0) (2 1) (3 0)) width=0.3
create c star radius=2
create d points points=((0 0) (1 1)) size=0.5
create e line to=(3 2 0) width=0.2
create f ring radius=2 inner=1.4
create g torus radius=1.5 tube=0.5
create h cone radius=1 height=2
create i disc radius=1.5
create k gear
set *.color white
background black
)",
                             "kinds");
  ASSERT_TRUE(std::none_of(l.diagnostics.begin(), l.diagnostics.end(),
                           [](const Diagnostic& d) { return d.severity == Severity::error; }));
  const Frame all = Program::compile(l.document).frame({});
  ASSERT_EQ(all.items.size(), 10u);
  for (const Item& one : all.items) {
    Frame f = all;
    f.items = {one}, f.background = Vec3{0, 0, 0};
    const Picture picture = draw(f, {80, 45, 1, "shaded"});
    const Projection p(f.camera, 16.0 / 9);
    int lit = 0, wrong = 0;
    for (int y = 0; y < 45; ++y)
      for (int x = 0; x < 80; ++x) {
        const bool drawn = pixel(picture, x, y).r > 128;
        lit += drawn;
        wrong += drawn != pick(f, p, (x + 0.5) / 80, (y + 0.5) / 45).has_value();
      }
    EXPECT_GT(lit, 8) << l.document.name(one.id);
    EXPECT_LE(wrong, 8 + lit / 20) << l.document.name(one.id);  // along its outline, as meshes are finer or coarser
  }
}

}  // namespace
}  // namespace betwixt
