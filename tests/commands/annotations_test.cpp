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

const std::string three_dots =
    "film flat\ncreate a circle radius=0.1 position=(3 0)\ncreate b circle radius=0.1 position=(1 0)\n"
    "create c circle radius=0.1 position=(2 1)\n";

TEST(Angles, AreArcsBetweenThreeThings) {
  const LoadedFilm s(three_dots + "angle a b c radius=0.5 text=\"x\"\nangle c b a as e radius=1\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto arc = line_of(s, "b-angle", "1f"), other = line_of(s, "e", "1f");
  // From the direction (1 0) to (1 1): 45 degrees about (1 0).
  const double diagonal = std::sqrt(0.5);
  EXPECT_NEAR(length(arc.front() - Vec3{1.5, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(length(arc.back() - Vec3{1 + 0.5 * diagonal, 0.5 * diagonal, 0}), 0, 1e-9);
  for (const Vec3 p : arc) {
    EXPECT_NEAR(length(p - Vec3{1, 0, 0}), 0.5, 1e-9);
    EXPECT_GE(p.y, -1e-9);
    EXPECT_LE(p.y, p.x - 1 + 1e-9);
  }
  EXPECT_NEAR(length(other.front() - Vec3{1 + diagonal, diagonal, 0}), 0, 1e-9);
  EXPECT_NEAR(length(other.back() - Vec3{2, 0, 0}), 0, 1e-9);
}

TEST(Angles, FollowAndBecomeSquares) {
  const LoadedFilm s(three_dots +
                     "angle a b c radius=0.5 decimals=1\nangle a b c anticlockwise radius=1 decimals=0 as e\n"
                     "at 1f c.position (2 1) linear\nat 25f c.position (1 2) hold\nat 49f c.position (1 -3) hold\n"
                     "at 73f c.position (-5 0) hold\nat 97f c.position (1 0) hold\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(load_text(write(s.loaded.document), "w.bx").document, s.loaded.document);
  EXPECT_EQ(s.text("b-angle/label.text", "1f"), "45.0°");
  EXPECT_EQ(s.text("b-angle/label.text", "25f"), "90.0°");
  EXPECT_EQ(s.text("b-angle/label.text", "49f"), "90.0°");
  EXPECT_EQ(s.text("e/label.text", "25f"), "90°");
  EXPECT_EQ(s.text("e/label.text", "49f"), "270°");
  EXPECT_EQ(s.text("e/label.text", "73f"), "180°");
  const auto square = line_of(s, "b-angle", "25f");
  ASSERT_EQ(square.size(), 3U);
  EXPECT_NEAR(length(square[0] - Vec3{1.3, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(length(square[1] - Vec3{1.3, 0.3, 0}), 0, 1e-9);
  EXPECT_NEAR(length(square[2] - Vec3{1, 0.3, 0}), 0, 1e-9);
  const auto most = line_of(s, "e", "49f");  // the long way round, over the left
  EXPECT_NEAR(length(most[most.size() / 3] - Vec3{1, 1, 0}), 0, 0.05);
  EXPECT_NEAR(length(most.back() - Vec3{1, -1, 0}), 0, 1e-9);
  EXPECT_NEAR(length(line_of(s, "b-angle", "73f")[16] - Vec3{1, 0.5, 0}), 0, 1e-9);
  EXPECT_NEAR(length(line_of(s, "b-angle", "97f")[0] - Vec3{1.5, 0, 0}), 0, 1e-9);  // no direction: as if it were a's
}

// The middle of the letters that a label draws, in the world, and half of their size.
std::pair<Vec3, Vec3> letters_at(const LoadedFilm& s, const std::string& name, const std::string& when) {
  for (const Item& item : s.frame(when).items)
    if (item.id == s.loaded.document.find(name)) {
      const Box box = realise(*item.shape).mesh->box();
      const Vec3 low = transform_point(item.world, box.low), high = transform_point(item.world, box.high);
      return {0.5 * (low + high), 0.5 * (high - low)};
    }
  ADD_FAILURE() << name;
  return {};
}

TEST(Angles, HaveUprightLabelsBehindTheArc) {
  const LoadedFilm s(three_dots + "angle a (1 0) c radius=0.5 tex=\"\\\\theta\"\nangle (0 9) b (0 9.001) text=\"w\"\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto [at, half] = letters_at(s, "angle/label", "1f");
  // On the line in the middle, 22.5 degrees, and outside the arc and both legs.
  EXPECT_NEAR(std::atan2(at.y, at.x - 1), pi / 8, 0.01);
  EXPECT_GT(std::hypot(at.x - half.x - 1, at.y - half.y), 0.5);
  EXPECT_GT(at.y - half.y, 0);
  EXPECT_LT(at.y + half.y, at.x - half.x - 1);
  // In a very narrow angle it is three radii away, not at the end of the world.
  EXPECT_NEAR(length(letters_at(s, "b-angle/label", "1f").first - Vec3{1, 0, 0}), 1.5, 0.3);
}

TEST(Dimensions, AreBesideTheirThingsAndFollow) {
  const LoadedFilm s(three_dots +
                     "dimension a to b offset=0.4\ndimension b to c text=\"d\" offset=-1 as e\n"
                     "dimension (0 0) to (0 2) decimals=3\n"
                     "at 1f a.position (3 0) linear\nat 25f a.position (1 4) hold\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(load_text(write(s.loaded.document), "w.bx").document, s.loaded.document);
  EXPECT_EQ(s.text("a-b-dimension/label.text", "1f"), "2.0");
  EXPECT_EQ(s.text("a-b-dimension/label.text", "25f"), "4.0");
  EXPECT_EQ(s.text("a-b-dimension/label.text", "13f"), "2.2");  // from (2 2) to (1 0)
  EXPECT_EQ(s.text("dimension/label.text", "1f"), "2.000");
  EXPECT_EQ(s.text("e/label.text", "1f"), "d");
  // Left of the way from a to b, which goes to the left, is below. The tips are 0.18 long.
  const auto first = line_of(s, "a-b-dimension", "1f"), last = line_of(s, "a-b-dimension", "25f");
  ASSERT_EQ(first.size(), 2U);
  EXPECT_NEAR(length(first[0] - Vec3{3 - 0.18, -0.4, 0}), 0, 1e-9);
  EXPECT_NEAR(length(first[1] - Vec3{1 + 0.18, -0.4, 0}), 0, 1e-9);
  EXPECT_NEAR(length(last[0] - Vec3{1.4, 4 - 0.18, 0}), 0, 1e-9);
  EXPECT_NEAR(length(last[1] - Vec3{1.4, 0.18, 0}), 0, 1e-9);
  EXPECT_NEAR(length(place(s, "a-b-dimension/tip", "1f") - first[1]), 0, 1e-9);
  EXPECT_NEAR(length(place(s, "a-b-dimension/tail", "1f") - first[0]), 0, 1e-9);
  const auto ends = line_of(s, "a-b-dimension/ends", "1f");
  ASSERT_EQ(ends.size(), 5U);
  EXPECT_NEAR(length(ends[0] - Vec3{3, -0.08, 0}), 0, 1e-9);
  EXPECT_NEAR(length(ends[4] - Vec3{1, -0.48, 0}), 0, 1e-9);
  // Its label is upright behind the line, also where the line is upright.
  const auto [below, tall] = letters_at(s, "a-b-dimension/label", "1f");
  EXPECT_NEAR(below.x, 2, 0.05);
  EXPECT_LT(below.y + tall.y, -0.4);
  const auto [beside, wide] = letters_at(s, "a-b-dimension/label", "25f");
  EXPECT_NEAR(beside.y, 2, 0.05);
  EXPECT_GT(beside.x - wide.x, 1.4);
}

TEST(Dimensions, BelowAMovedThingTheyAreWhereTheyWere) {
  const LoadedFilm s(three_dots + "create g group position=(2 1)\nset g.scale (2 2 2)\nangle a b c as g/w\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(length(line_of(s, "g/w", "1f")[0] - Vec3{-0.25, -0.5, 0}), 0, 1e-9);  // (1.5 0) in the space of g
}

Vec3 as_point(const std::vector<double>& n) { return {n[0], n[1], n[2]}; }

// Below the same piece, wherever the object above it is.
TEST(Labels, OfPiecesFollowTheObjectAbove) {
  for (const char* verb : {"label", "callout"}) {
    std::vector<Vec3> away;
    for (const char* place : {"(0 0)", "(4 1)", "(-3 2) scale=(2 2 2)"}) {
      const LoadedFilm s(
          fmt::format("film flat\ncreate g group position={}\ncreate g/c circle radius=0.5\nat 3f {} g/c \"c\" below\n",
                      place, verb));
      ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
      for (const Item& item : s.frame("24f").items)
        if (item.shape->kind == Kind::text)
          away.push_back(translation_of(item.world) - as_point(s.numbers("g.position", "24f")));
    }
    ASSERT_EQ(away.size(), 3u);
    EXPECT_NEAR(length(away[1] - away[0]), 0, 1e-6) << verb;
    EXPECT_LT(away[2].y, -1) << verb;  // outside the larger circle
    EXPECT_NEAR(away[2].x, 0, 0.2) << verb;
  }
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

TEST(Diagrams, GoToTheRight) {
  const LoadedFilm s(
      "film flat\ncreate d diagram of=\"a -> b\" direction=right apart=(3 2)\n"
      "at 25f rearrange d direction=up for 1s\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(load_text(write(s.loaded.document), "w.bx").document, s.loaded.document);
  EXPECT_NEAR(length(pair_of(s, "d/a.position", "1f") - Vec3{-1.5, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(length(pair_of(s, "d/b.position", "1f") - Vec3{1.5, 0, 0}), 0, 1e-9);
  EXPECT_NEAR(length(pair_of(s, "d/a.position", "49f") - Vec3{0, -1, 0}), 0, 1e-9);
}

TEST(Diagrams, HaveLoops) {
  const std::string form = "film flat\ncreate d diagram of=\"a -> a\" nodes=";
  const LoadedFilm box(form + "box\n"), circle(form + "circle\n"),
      small(form + "box\nset d.scale (0.5 0.5 1)\nset d.position (3 1)\n");
  for (const LoadedFilm* s : {&box, &circle, &small})
    EXPECT_TRUE(s->loaded.diagnostics.empty()) << said(s->loaded.diagnostics);
  // A node of one letter is 0.62 * 0.3 + 0.5 wide and 0.7 high. The loop leaves it at the top and comes back from the
  // right, 0.2 from its corner, with a gap of 0.08; the tip is 0.2 long.
  const double w = 0.343, h = 0.35;
  const auto loop = line_of(box, "d/a-a", "1f");
  EXPECT_NEAR(length(loop.front() - Vec3{w - 0.2, h + 0.08, 0}), 0, 1e-9);
  EXPECT_NEAR(length(loop.back() - Vec3{w + 0.08 + 0.2, h - 0.2, 0}), 0, 1e-9);
  EXPECT_NEAR(std::abs(number_of(box, "d/a-a/tip.rotation.z", "1f")), pi, 1e-6);  // to the left, into the node
  for (const Vec3 p : loop) EXPECT_TRUE(p.y > h + 0.079 || p.x > w + 0.079) << p.x << ' ' << p.y;
  const auto around = line_of(circle, "d/a-a", "1f");
  for (const Vec3 p : around) EXPECT_GT(length(p), 0.35 + 0.079);
  EXPECT_NEAR(length(around.front()), 0.35 + 0.08, 1e-9);
  EXPECT_NEAR(length(around.back()), 0.35 + 0.08 + 0.2, 1e-9);
  // In a small diagram it is small too. The gap stays the same in the picture.
  EXPECT_NEAR(length(line_of(small, "d/a-a", "1f").back() - Vec3{w + 0.16 + 0.2, h - 0.2, 0}), 0, 1e-9);
}

// By the pictures: no letter of a label of an edge is on a node, where there is room for it.
TEST(Diagrams, LabelsKeepClearOfNodes) {
  const char* const diagrams[] = {
      "direction=right of=\"idle -> busy: a job; busy -> busy: next; busy -> idle: done; busy -> x: wrong\"",
      "of=\"start -> left part: a very long label; start -> right part: another long label; left part -> end: x\"",
      "layout=tree direction=left of=\"a -> b: one long word; a -> c: two; b -> d: and three; b -> e: four\"",
      "layout=circle nodes=circle of=\"q0 -> q1: a; q1 -> q2: b; q2 -> q0: reset now; q1 -> q1: c; q0 -> q2: jump\"",
      "layout=force of=\"root -> a: a long label; root -> b: two; b -> c: a long label; c -> a: back again\""};
  for (const char* const diagram : diagrams) {
    const LoadedFilm s(std::string("film flat\ncreate d diagram ") + diagram + "\n");
    EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
    std::vector<std::pair<Vec3, Vec3>> nodes, labels;
    for (const Item& item : s.frame("1f").items) {
      const std::string name = s.loaded.document.name(item.id);
      const bool label = name.ends_with("/label");
      if (!label && item.shape->kind != Kind::rectangle && item.shape->kind != Kind::disc) continue;
      const Box box = realise(*item.shape).mesh->box();
      (label ? labels : nodes)
          .emplace_back(transform_point(item.world, box.low), transform_point(item.world, box.high));
    }
    EXPECT_GE(nodes.size(), 3U);
    EXPECT_GE(labels.size(), 3U);
    for (const auto& [low, high] : labels)
      for (const auto& [from, to] : nodes)
        EXPECT_FALSE(low.x < to.x && from.x < high.x && low.y < to.y && from.y < high.y) << diagram;
  }
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
      {"angle b (1 0)", ErrorCode::syntax, 14},
      {"angle b b (1 0)", ErrorCode::name, 7},
      {"angle (1 0) b (0 1) radius=0", ErrorCode::range, 28},
      {"angle (1 0) b (0 1) text=\"x\" decimals=1", ErrorCode::syntax, 30},
      {"angle (1 0) b (0 1) offset=1", ErrorCode::type, 21},
      {"angle (1 0) b (0 1) as b", ErrorCode::name, 13},
      {"dimension b (1 0)", ErrorCode::syntax, 13},
      {"dimension b to b", ErrorCode::name, 16},
      {"dimension b to (1 0) decimals=1.5", ErrorCode::range, 31},
      {"dimension b to nobody", ErrorCode::name, 16},
      {"at 9f rearrange b", ErrorCode::type, 17},
      {"create d diagram of=\"a -> b\" direction=north", ErrorCode::type, 40},
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
