// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the marked parts of formulas, and texts that turn into others sign by sign.
#include "exchange/formulas.h"
#include "exchange/geometry.h"
#include "exchange/shapes.h"
#include "exchange/typefaces.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

Frame frame_of(const Document& d, std::string_view time) { return Program::compile(d).frame(*parse_time(time, d)); }

const Item* item_of(const Frame& f, const Document& d, std::string_view name) {
  for (const Item& item : f.items)
    if (item.id == d.find(name)) return &item;
  return nullptr;
}

Box drawn_box(const Item& item) {
  Box all;
  const Geometry g = geometry_of(item, 16);
  for (const auto& p : g.mesh->positions) all.add(transform_point(item.world, {p[0], p[1], p[2]}));
  return all;
}

void expect_near(const Box& a, const Box& b, double within) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.low[i], b.low[i], within) << i;
    EXPECT_NEAR(a.high[i], b.high[i], within) << i;
  }
}

class FormulaParts : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_font(std::string(formula_font_name))) GTEST_SKIP() << "no font for formulas";
  }
  static Document load(const std::string& text) {
    const Loaded l = load_text(text, "test.bx");
    EXPECT_EQ(said(l.diagnostics), "") << text;
    return l.document;
  }
  // What a script says of its only error.
  static std::string wrong(const std::string& text) {
    const Loaded l = load_text(text, "test.bx");
    return l.diagnostics.size() == 1 ? told(l) : said(l.diagnostics);
  }
  static constexpr const char* pythagoras = "create f text tex=\"{{a}}^2 + {{b}}^2 = {{c}}^2\" color=white\n";
};

TEST_F(FormulaParts, HaveNumbersAndNames) {
  const Document d =
      load(std::string(pythagoras) +
           "set f/a.color red\nat 9f f/2.color gold\nset f/c.position (0 1 0)\nset f/3.transparency 0.5\n");
  const Frame f = frame_of(d, "9f");
  ASSERT_EQ(f.items.size(), 4U);
  const auto color = [&](const char* name) { return item_of(f, d, name)->color; };
  EXPECT_EQ(color("f"), (Vec3{1, 1, 1}));
  EXPECT_EQ(color("f/1"), (Vec3{1, 0, 0}));
  EXPECT_GT(color("f/2").x, 0.9);
  EXPECT_LT(color("f/2").z, 0.1);
  EXPECT_EQ(color("f/3"), (Vec3{1, 1, 1}));
  EXPECT_EQ(item_of(f, d, "f/3")->transparency, 0.5);
  const Document plain = load(pythagoras);
  const Frame still = frame_of(plain, "9f");
  EXPECT_NEAR(drawn_box(*item_of(f, d, "f/3")).low.y - drawn_box(*item_of(still, plain, "f/3")).low.y, 1, 1e-6);
}

TEST_F(FormulaParts, AreOneFormula) {
  const Document d = load(
      std::string(pythagoras) +
      "at 1f f.color white linear\nat 11f f.color red\nat 1f f.position (0 0 0) linear\nat 11f f.position (2 0 0)\n"
      "set f.size 2\nset f.transparency 0.5\nset f/a.color blue\n");
  const Frame f = frame_of(d, "11f");
  EXPECT_EQ(item_of(f, d, "f/b")->color, (Vec3{1, 0, 0}));
  EXPECT_EQ(item_of(f, d, "f/1")->color, (Vec3{0, 0, 1}));
  EXPECT_EQ(item_of(f, d, "f/1")->transparency, 0.5);
  Box all;
  for (const Item& item : f.items) {
    const Box b = drawn_box(item);
    all.add(b.low), all.add(b.high);
  }
  const Document whole = load("create f text tex=\"a^2 + b^2 = c^2\" size=2 position=(2 0 0)\n");
  expect_near(all, drawn_box(frame_of(whole, "1f").items.at(0)), 1e-5);
  EXPECT_TRUE(frame_of(load(std::string(pythagoras) + "hide f\n"), "1f").items.empty());
  const Document typed = load(std::string(pythagoras) + "at 1f f.typed 0 linear\nat 9f f.typed 8\n");
  EXPECT_TRUE(geometry_of(*item_of(frame_of(typed, "4f"), typed, "f/c"), 16).mesh->positions.empty());
  EXPECT_FALSE(geometry_of(*item_of(frame_of(typed, "9f"), typed, "f/c"), 16).mesh->positions.empty());
}

// The evaluator keeps its state; a new one must agree.
TEST_F(FormulaParts, AreTheSameInPlayAndBySeeking) {
  const Document d = load(
      std::string(pythagoras) +
      "at 1f f.color white linear\nat 24f f.color red\nat 8f f.tex \"{{c}}^2 - {{b}}^2 = {{a}}^2\" match for 8f\n");
  const Program p = Program::compile(d);
  for (const int n : {1, 5, 9, 12, 15, 16, 20, 12, 9, 1}) {
    const Time t = *parse_time(std::to_string(n) + "f", d);
    const Frame one = p.frame(t), other = Program::compile(d).frame(t);
    ASSERT_EQ(one.items.size(), other.items.size());
    for (std::size_t i = 0; i < one.items.size(); ++i) {
      EXPECT_EQ(*one.items[i].shape, *other.items[i].shape) << n;
      EXPECT_EQ(one.items[i].color, other.items[i].color) << n;
      EXPECT_EQ(one.items[i].blend, other.items[i].blend) << n;
      EXPECT_EQ(one.items[i].toward != nullptr, other.items[i].toward != nullptr) << n;
    }
  }
}

TEST_F(FormulaParts, MatchGoesFromOneFormulaToTheNext) {
  const Document d = load(std::string(pythagoras) +
                          "f.tex\n  9f \"{{a}}^2 + {{b}}^2 = {{c}}^2\" match\n  19f \"{{a}}^2 = {{c}}^2 - {{b}}^2\"\n");
  const auto box = [&](const char* name, const char* time) {
    const Frame f = frame_of(d, time);
    const Item* const item = item_of(f, d, name);
    return item ? drawn_box(*item) : Box{};
  };
  const Box from = box("f/b", "9f"), to = box("f/b", "19f"), half = box("f/b", "14f");
  EXPECT_GT(to.low.x, from.low.x + 1);
  EXPECT_NEAR(half.low.x, (from.low.x + to.low.x) / 2, 1e-5);
  EXPECT_NEAR(half.high.x - half.low.x, from.high.x - from.low.x, 1e-5) << "it glides";
  // It starts and ends at rest: (1 - cos pi u)/2.
  EXPECT_NEAR((box("f/b", "11f").low.x - from.low.x) / (to.low.x - from.low.x), (1 - std::cos(pi * 0.2)) / 2, 1e-5);
  const Document plain = load("create f text tex=\"{{a}}^2 = {{c}}^2 - {{b}}^2\"\n");
  for (const char* name : {"f", "f/a"}) {
    const Frame f = frame_of(plain, "1f");
    expect_near(box(name, "19f"), drawn_box(*item_of(f, plain, name)), 1e-6);
  }
}

TEST_F(FormulaParts, TheShortFormWritesTwoEvents) {
  const Document d =
      load(std::string(pythagoras) + "at 9f f.tex \"{{a}}^2 = {{c}}^2 - {{b}}^2 + {{d}}\" match for 10f\n");
  const std::string written = write(d);
  EXPECT_NE(written.find("9f \"{{a}}^2 + {{b}}^2 = {{c}}^2\" match"), std::string::npos) << written;
  EXPECT_NE(written.find("19f \"{{a}}^2 = {{c}}^2 - {{b}}^2 + {{d}}\""), std::string::npos) << written;
  EXPECT_TRUE(d.find("f/4"));
  const Document words = load("create t text text=\"red and blue\"\nat 9f t.text \"blue and red\" match for 1s\n");
  EXPECT_NE(frame_of(words, "20f").items.at(0).toward, nullptr);
}

TEST_F(FormulaParts, WrittenFilmsAreTheSame) {
  const Document d = load(std::string(pythagoras) +
                          "set f/a.color red\nat 9f f/2.color gold\nat 9f f.tex \"{{a}} = {{d}}\" match for 10f\n");
  const Document again = load(write(d));
  EXPECT_EQ(write(again), write(d));
  const Frame one = frame_of(d, "12f"), other = frame_of(again, "12f");
  ASSERT_EQ(one.items.size(), other.items.size());
  for (std::size_t i = 0; i < one.items.size(); ++i) EXPECT_EQ(one.items[i].color, other.items[i].color);
}

TEST_F(FormulaParts, CopiesHaveTheirOwn) {
  const Document d =
      load(std::string(pythagoras) +
           "set f/a.color red\ncreate g like f position=(0 3 0)\nset g/a.color blue\nrename f h\nset h/b.color gold\n");
  const Frame f = frame_of(d, "1f");
  EXPECT_EQ(f.items.size(), 8U);
  EXPECT_EQ(item_of(f, d, "g/1")->color, (Vec3{0, 0, 1}));
  EXPECT_EQ(item_of(f, d, "h/1")->color, (Vec3{1, 0, 0}));
  EXPECT_GT(drawn_box(*item_of(f, d, "g/1")).low.y, 2);
}

TEST_F(FormulaParts, ErrorsPointIntoTheFormula) {
  EXPECT_EQ(wrong("create f text tex=\"1 + \\\\fracc{a}{b}\"\n"), "name 1:24 \\\\fracc");
  EXPECT_EQ(wrong("create f text tex=\"\"\"1 + \\fracc{a}{b}\"\"\"\n"), "name 1:26 \\fracc");
  EXPECT_EQ(wrong("create f text\nat 9f f.tex \"x^2^3\"\n"), "syntax 2:17 ^");
  EXPECT_EQ(wrong(std::string(pythagoras) + "set f/d.color red\n"), "name 2:5 f/d");
  EXPECT_EQ(wrong(std::string(pythagoras) + "at 9f f.tex \"x\" match for 0f\n"), "range 2:27 0f");
  EXPECT_EQ(wrong("create b sphere\nat 9f b.radius 2 match\n"), "type 2:18 match");
  EXPECT_EQ(wrong("create t text\nat 9f t.font \"DejaVu Serif\" match\n"), "type 2:29 match");
  EXPECT_EQ(wrong(std::string(pythagoras) + "create f/1 sphere\n"), "name 2:8 f/1");
}

}  // namespace
}  // namespace betwixt
