// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests animated properties of shapes, set by any kind of source.
#include <gtest/gtest.h>

#include <algorithm>

#include "betwixt/program.h"
#include "scene/document.h"
#include "scene/outline.h"

namespace betwixt {
namespace {

constexpr std::int64_t second = flicks_per_second;

std::pair<Value, Value> two_values(const FunctionSpec& f) {
  switch (f.type) {
    case Type::pair:
      if (f.high <= 1) return {Vec3{0, 0.5, 0}, Vec3{0.25, 1, 0}};
      return {Vec3{1, 2, 0}, Vec3{2, 1, 0}};
    case Type::vector:
      return {Vec3{1, 2, 3}, Vec3{2, 1, 5}};
    case Type::points:
      return {Points(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
              Points(std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}})};
    case Type::text:
      if (!f.words.empty())
        return {Text(f.words.substr(0, f.words.find('|'))), Text(f.words.substr(f.words.rfind('|') + 1))};
      return {Text(std::string("one")), Text(std::string("two"))};
    case Type::boolean:
      return {false, true};
    default:
      return {std::max(1.0, f.low), std::max(1.0, f.low) + 1};
  }
}

// A scene of one object, whose function goes from one value to another.
struct WideVideo final : Video {
  explicit WideVideo(double wide) { aspect = wide, begins = {0}, end = 1; }
  Result<std::shared_ptr<const Picture>> picture(std::size_t) const override {
    return std::make_shared<const Picture>();
  }
};

Scene scene_of(Kind kind, FunctionId f, const Value& first, const Value& last) {
  Scene s;
  s.meshes.edit()["one"] = std::make_shared<const Mesh>();
  Mesh mesh;
  mesh.positions.push_back({1, 2, 3});
  s.meshes.edit()["two"] = std::make_shared<const Mesh>(mesh);
  s.videos.edit()["one"] = std::make_shared<const WideVideo>(2),
  s.videos.edit()["two"] = std::make_shared<const WideVideo>(3);
  for (const char* formula : {"one", "two"}) s.formulas.edit()[formula] = std::make_shared<const Outline>();
  Object o;
  o.name = "thing";
  o.kind = kind;
  const ObjectId id = add_object(s, o);
  for (const auto& [at, value] : {std::pair{Time{0}, first}, {Time{second}, last}}) {
    Event e;
    e.time = at;
    e.value = value;
    put_event(s, {id, f}, e);
  }
  return s;
}

Program compiled(Scene s) { return Program::compile(Document(std::make_shared<const Scene>(std::move(s)))); }

TEST(Shapes, FollowEveryFunctionThatIsPartOfOne) {
  const auto all = built_in_functions();
  int tried = 0;
  for (const KindRow& row : kinds())
    for (FunctionId f = 0; f < all.size(); ++f) {
      if (!all[f].shape || !(all[f].kinds & bit(row.kind))) continue;
      const auto [first, last] = two_values(all[f]);
      const Program p = compiled(scene_of(row.kind, f, first, last));
      const Frame before = p.frame({0}), after = p.frame({second});
      ASSERT_EQ(before.items.size(), 1U) << row.name;
      EXPECT_EQ(before.items[0].shape->kind, row.kind == Kind::code ? Kind::text : row.kind);
      EXPECT_FALSE(*before.items[0].shape == *after.items[0].shape) << row.name << '.' << all[f].name;
      EXPECT_TRUE(*p.frame({0}).items[0].shape == *before.items[0].shape) << row.name << '.' << all[f].name;
      ++tried;
    }
  EXPECT_GE(tried, 20);
}

TEST(Shapes, StandStillWhereOnlyTheRestMoves) {
  for (const FunctionId f : {fn::position, fn::scale}) {
    const Program p = compiled(scene_of(Kind::sphere, f, Vec3{1, 1, 1}, Vec3{2, 2, 2}));
    EXPECT_EQ(p.frame({0}).items[0].shape, p.frame({second}).items[0].shape);  // one and the same
  }
}

// A function behind all others, as a new row would be: nothing knows of it but what it says of itself.
TEST(Shapes, FollowAFunctionThatIsAppended) {
  FunctionSpec swell{.name = "swell", .type = Type::scalar, .rest = 0.5, .kinds = bit(Kind::sphere)};
  swell.shape = [](Shape& s, const Value& v, const Scene&) { s.radius += std::get<double>(v); };
  const auto id = static_cast<FunctionId>(built_in_functions().size());
  Scene s = scene_of(Kind::sphere, fn::position, Vec3{}, Vec3{1, 0, 0});
  s.defined.edit().push_back(swell);
  EXPECT_EQ(compiled(s).frame({0}).items[0].shape->radius, 1.5) << "its value at rest";
  for (const auto& [at, value] : {std::pair{Time{0}, 0.0}, {Time{2 * second}, 4.0}}) {
    Event e;
    e.time = at;
    e.value = value;
    e.twerper = Twerper::linear;
    put_event(s, {ObjectId{0}, id}, e);
  }
  const Program p = compiled(s);
  EXPECT_EQ(p.frame({0}).items[0].shape->radius, 1);
  EXPECT_EQ(p.frame({second}).items[0].shape->radius, 3);
  // What touches what knows it too.
  const Contacts c = p.contacts({2 * second});
  ASSERT_EQ(c.boxes.size(), 1U);
  EXPECT_NEAR(c.boxes[0].high.y - c.boxes[0].low.y, 10, 1e-9);
}

}  // namespace
}  // namespace betwixt
