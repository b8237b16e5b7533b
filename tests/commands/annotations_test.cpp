// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests annotations, connections, diagrams and blocks of code in films.
#include <cmath>
#include <random>

#include "exchange/geometry.h"
#include "exchange/shapes.h"
#include "scene/outline.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

const std::string two_boxes =
    "film flat\ncreate a rectangle size=(2 1) position=(-3 0)\ncreate b rectangle size=(1 1) "
    "position=(3 0)\n";

Vec3 pair_of(const LoadedFilm& s, const std::string& target, const std::string& when = "1f") {
  return std::get<Vec3>(s.read(target, when));
}
double number_of(const LoadedFilm& s, const std::string& target, const std::string& when) {
  return std::get<double>(s.read(target, when));
}
std::vector<Vec3> line_of(const LoadedFilm& s, const std::string& name, const std::string& when) {
  return *std::get<Points>(s.read(name + ".points", when));
}

TEST(Annotations, FitTheirThings) {
  const LoadedFilm s(two_boxes + "set a.scale (2 2 1)\nat 13f highlight a\nat 13f underline b for 1s\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  // In the space of a, a quarter of the shorter side is the margin.
  EXPECT_NEAR(length(pair_of(s, "a/highlight.size") - Vec3{2.5, 1.5, 0}), 0, 1e-9);
  EXPECT_NEAR(pair_of(s, "b/underline.to").x, 1, 1e-9);
  EXPECT_NEAR(number_of(s, "a/highlight.transparency", "13f"), 1, 1e-9);
  EXPECT_NEAR(number_of(s, "a/highlight.transparency", "25f"), 0.7, 1e-9);
  EXPECT_NEAR(pair_of(s, "b/underline.trim", "25f").y, 0.5, 1e-9);  // half of the second has passed
}

TEST(Annotations, GoByTheWordOff) {
  const LoadedFilm s(two_boxes + "at 13f circle-around a for 12f\nat 49f circle-around a off for 12f\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(std::get<bool>(s.read("a/circle.display", "1f")), false);
  EXPECT_EQ(std::get<bool>(s.read("a/circle.display", "30f")), true);
  EXPECT_EQ(std::get<bool>(s.read("a/circle.display", "70f")), false);
}

TEST(Connections, EndAtTheBordersAndFollow) {
  const LoadedFilm s(two_boxes +
                     "connect a to b arrow=off\nconnect a to b angled as e\n"
                     "at 1f b.position (3 0) linear\nat 25f b.position (-3 4)\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto first = line_of(s, "a-b", "1f"), last = line_of(s, "a-b", "25f");
  ASSERT_EQ(first.size(), 2U);
  EXPECT_NEAR(length(first[0] - Vec3{-3 + 1 + 0.08, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(length(first[1] - Vec3{3 - 0.5 - 0.08, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(length(last[0] - Vec3{-3, 0.5 + 0.08, 0}), 0, 1e-9);
  EXPECT_NEAR(length(last[1] - Vec3{-3, 4 - 0.5 - 0.08, 0}), 0, 1e-9);
  for (const char* when : {"1f", "7f", "13f", "25f"}) {
    const auto way = line_of(s, "e", when);
    ASSERT_EQ(way.size(), 4U);
    for (std::size_t i = 1; i < 4; ++i)
      EXPECT_LT(std::min(std::abs(way[i].x - way[i - 1].x), std::abs(way[i].y - way[i - 1].y)), 1e-9) << when;
  }
}

TEST(Connections, BelowAMovedThingTheyAreWhereTheyWere) {
  const std::string d = "film flat\ncreate d diagram of=\"a -> b\"\n";
  const LoadedFilm still(d), moved(d + "set d.position (2 1)\nset d.scale (2 2 2)\n");
  const auto a = line_of(still, "d/a-b", "1f"), b = line_of(moved, "d/a-b", "1f");
  ASSERT_EQ(a.size(), b.size());
  // The gap to the border stays the same in the picture, so it is half in the space of d.
  EXPECT_NEAR(length(b[0] - (a[0] + Vec3{0, 0.04, 0})), 0, 1e-9);
}

// Labels in crowded pictures: whenever a label has a side of its own, it meets no other thing.
TEST(Labels, KeepOutOfTheWay) {
  std::mt19937 random(5);
  const auto share = [&] { return static_cast<double>(random() % 1000) / 1000; };
  int free = 0;
  for (int round = 0; round < 60; ++round) {
    std::string text = "film flat\n";
    std::vector<Vec3> at;
    for (int i = 0; i < 5; ++i) {
      const Vec3 p{-5 + 10 * share(), -3 + 6 * share(), 0};
      bool clear = true;
      for (const Vec3 q : at) clear = clear && length(p - q) > 1.6;
      if (!clear) continue;
      at.push_back(p);
      text += fmt::format("create c{} circle radius=0.4 position=({} {})\n", at.size(), p.x, p.y);
    }
    for (std::size_t i = 1; i <= at.size(); ++i) text += fmt::format("label c{} \"thing {}\"\n", i, i);
    const LoadedFilm s(text);
    ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics) << text;
    for (const Item& item : s.frame("1f").items) {
      if (item.shape->kind != Kind::text) continue;
      const Box box = realise(*item.shape).mesh->box();
      const Vec3 low = transform_point(item.world, box.low), high = transform_point(item.world, box.high);
      for (const Vec3 p : at) {
        const Vec3 nearest{std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y), 0};
        EXPECT_GT(length(nearest - p), 0.4) << text;
      }
      ++free;
    }
  }
  EXPECT_GT(free, 150);
}

TEST(Diagrams, TurnIntoOthers) {
  const LoadedFilm s(
      "film flat\ncreate d diagram of=\"a -> b -> c\" apart=(3 2)\nat 25f rearrange d of=\"a -> c; x -> a\" for 1s\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(length(pair_of(s, "d/a.position", "25f") - Vec3{0, 2, 0}), 0, 1e-9);
  EXPECT_NEAR(length(pair_of(s, "d/c.position", "25f") - Vec3{0, -2, 0}), 0, 1e-9);
  EXPECT_NEAR(length(pair_of(s, "d/x.position", "49f") - Vec3{0, 2, 0}), 0, 1e-9);
  EXPECT_NEAR(length(pair_of(s, "d/a.position", "49f") - Vec3{0, 0, 0}), 0, 1e-9);
  EXPECT_EQ(std::get<bool>(s.read("d/b.display", "50f")), false);
  EXPECT_EQ(std::get<bool>(s.read("d/x.display", "20f")), false);
  EXPECT_EQ(std::get<bool>(s.read("d/x.display", "50f")), true);
}

// The letters that an object draws.
std::string letters_of(const LoadedFilm& s, const std::string& name, const std::string& when) {
  std::string out;
  const ObjectId id = s.loaded.document.find(name);
  for (const Item& item : s.frame(when).items)
    if (item.id == id)
      for (const Letter& l : outline_of(*item.shape).letters) out += l.text;
  return out;
}

TEST(Code, PartsDrawTheirWords) {
  const LoadedFilm s(
      "film flat\ncreate c code language=python text=\"def f(x):\\n    return x + 1\"\nat 25f c.text \"while x: "
      "f(2)\"\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(letters_of(s, "c/keyword", "1f"), "defreturn");
  EXPECT_EQ(letters_of(s, "c/function", "1f"), "f");
  EXPECT_EQ(letters_of(s, "c", "1f"), "xx");
  EXPECT_EQ(letters_of(s, "c/number", "1f"), "1");
  EXPECT_EQ(letters_of(s, "c/keyword", "30f"), "while");
  EXPECT_EQ(letters_of(s, "c/number", "30f"), "2");
  EXPECT_EQ(*std::get<Text>(s.read("c/numbers.text", "1f")), "1\n2");
}

TEST(Code, ThePanelHoldsTheWordsOfBothTexts) {
  const LoadedFilm s(
      "film flat\ncreate c code size=0.5 numbers=off text=\"a\\nb\\nc\"\nat 25f c.text \"one long line\" match for "
      "24f\n");
  const auto size = [&](const char* when) { return pair_of(s, "c/panel.size", when); };
  EXPECT_NEAR(size("1f").y, 0.5 * (3 * 1.2 + 1.2), 1e-9);
  EXPECT_NEAR(size("60f").y, 0.5 * (1 * 1.2 + 1.2), 1e-9);
  EXPECT_NEAR(size("60f").x, 0.5 * (13 * 0.602 + 2), 1e-9);
  EXPECT_NEAR(size("37f").x, 0.5 * (13 * 0.602 + 2), 1e-9);  // in the middle it has both
  EXPECT_NEAR(size("37f").y, 0.5 * (3 * 1.2 + 1.2), 1e-9);
}

TEST(Code, HighlightGlidesAlongTheLines) {
  const LoadedFilm s(
      "film flat\ncreate c code text=\"a\\nb\\nc\\nd\"\nat 13f highlight c lines 1..2 for 12f\n"
      "at 37f highlight c lines 4 for 12f\nat 61f highlight c off for 12f\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(std::get<bool>(s.read("c/mark.display", "1f")), false);
  EXPECT_EQ(pair_of(s, "c.lines", "30f"), (Vec3{1, 2, 0}));
  EXPECT_EQ(pair_of(s, "c.lines", "43f"), (Vec3{2.5, 3, 0}));
  EXPECT_EQ(pair_of(s, "c.lines", "50f"), (Vec3{4, 4, 0}));
  EXPECT_EQ(std::get<bool>(s.read("c/mark.display", "80f")), false);
}

TEST(RowsWithALength, GoFromWhatIsThere) {
  const LoadedFilm s(
      "create b sphere position=(1 0 0)\nat 25f b.position (3 0 0) linear for 24f\nat 73f b.position (3 2 0) linear "
      "for 1s\n"
      "at 25f b.radius 2 for 24f\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(place(s, "b", "20f"), (Vec3{1, 0, 0}));
  EXPECT_NEAR(length(place(s, "b", "37f") - Vec3{2, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(length(place(s, "b", "60f") - Vec3{3, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(length(place(s, "b", "85f") - Vec3{3, 1, 0}), 0, 1e-12);
  EXPECT_NEAR(number_of(s, "b.radius", "37f"), 1.5, 1e-9);  // ease-in-out is halfway in the middle
}

TEST(RowsWithALength, ErrorsHaveTheirPlaces) {
  const std::tuple<const char*, ErrorCode, int> wrong[] = {
      {"at 9f b.radius 2 for 0f", ErrorCode::range, 22},
      {"at 9f b.radius 2 for", ErrorCode::syntax, 21},
      {"at 9f b.display off for 3f", ErrorCode::type, 17},
      {"at 9f b.position.velocity (1 0 0) for 3f", ErrorCode::syntax, 27},
      {"at 9f connect b to b", ErrorCode::name, 20},
      {"at 9f highlight b lines 2", ErrorCode::type, 17},
      {"at 9f highlight b off", ErrorCode::name, 17},
      {"at 9f label b", ErrorCode::syntax, 14},
      {"at 9f rearrange b", ErrorCode::type, 17},
      {"create c code language=cobol", ErrorCode::type, 24},
      {"create d diagram of=\"a -> \"", ErrorCode::range, 27}};
  for (const auto& [line, code, column] : wrong) {
    const auto loaded = load_text(std::string("create b sphere\n") + line + "\n", "wrong.bx");
    ASSERT_FALSE(loaded.diagnostics.empty()) << line;
    EXPECT_EQ(loaded.diagnostics[0].what.code, code) << line << ": " << said(loaded.diagnostics);
    EXPECT_EQ(loaded.diagnostics[0].what.place.column, column) << line << ": " << said(loaded.diagnostics);
  }
}

TEST(Lists, TakePairsWithSigns) {
  const LoadedFilm s("let p = ((1 -2) (-3 -4) (5 6))\ncreate a{1..3} sphere position=p[i]\n");
  EXPECT_EQ(place(s, "a1", "1f"), (Vec3{1, -2, 0}));
  EXPECT_EQ(place(s, "a2", "1f"), (Vec3{-3, -4, 0}));
  EXPECT_EQ(load_text(write(s.loaded.document), "w.bx").document, s.loaded.document) << write(s.loaded.document);
}

}  // namespace
}  // namespace betwixt
