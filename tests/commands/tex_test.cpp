// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests texts that are TeX formulas.
#include "exchange/geometry.h"
#include "exchange/shapes.h"
#include "support/fake_programs.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

class TexTexts : public testing::Test {
 protected:
  // A square of 1 em that stands on the baseline half an em to the right, and one of half an em below it at its right.
  TexTexts() {
    const double em = 10 * 72 / 72.27;
    fake.draw(drawing_of(
        fmt::format("<rect x='{}' y='{}' width='{}' height='{}'/><rect x='{}' y='72' width='{}' height='{}'/>",
                    72 + em / 2, 72 - em, em, em, 72 + 1.5 * em, em / 2, em / 2)));
  }
  static Loaded load(std::string_view text, bool tex = true) { return load_text(text, "test.bx", {.tex = tex}); }
  // What is drawn of f, by its triangles.
  static Box drawn(const Loaded& l, std::string_view time = "1f") {
    EXPECT_EQ(said(l.diagnostics), "");
    const Frame frame = Program::compile(l.document).frame(*parse_time(time, l.document));
    Box all;
    for (const Item& item : frame.items) {
      const Geometry g = realise(*item.shape);
      for (const auto& p : g.mesh->positions) all.add(Vec3{p[0], p[1], p[2]});
    }
    return all;
  }
  static void expect_box(const Box& b, Vec3 low, Vec3 high) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(b.low[i], low[i], 1e-5) << i;
      EXPECT_NEAR(b.high[i], high[i], 1e-5) << i;
    }
  }
  const FakePrograms fake;
};

TEST_F(TexTexts, AreAsLargeAsTheySayAndStandWhereTheySay) {
  expect_box(drawn(load("create f text tex=\"x\"\n")), {-0.75, -0.5, 0}, {0.75, 1, 0});
  expect_box(drawn(load("create f text tex=\"x\" size=2 align=left\n")), {0, -1, 0}, {3, 2, 0});
  expect_box(drawn(load("create f text tex=\"x\" align=right depth=0.2\n")), {-1.5, -0.5, -0.1}, {0, 1, 0.1});
  expect_box(drawn(load("create f text tex=\"x\" fill=off stroke=red stroke-width=0.1\n")), {-0.8, -0.55, 0},
             {0.8, 1.05, 0});
  expect_box(drawn(load("create f text tex=\"x\" text=\"in its place\"\n")), {-0.75, -0.5, 0}, {0.75, 1, 0});
  expect_box(drawn(load("create f text tex=\"x\" typed=1\n")), {-0.75, 0, 0}, {0.25, 1, 0});
  EXPECT_TRUE(fake.tidied());
}

TEST_F(TexTexts, TheirExtentIsExact) {
  const Loaded l = load("create f text tex=\"x\" size=2\n");
  const Frame frame = Program::compile(l.document).frame(Time{});
  ASSERT_EQ(frame.items.size(), 1U);
  expect_box(extent(*frame.items[0].shape), {-1.5, -1, 0}, {1.5, 2, 0});
}

TEST_F(TexTexts, WhatIsInQuotesGoesToTeX) {
  load("create f text tex=\"\\\\frac{a}{b} \\\"\"\n");
  EXPECT_NE(fake.formula().find("$\\displaystyle\n\\frac{a}{b} \"\n$"), std::string::npos) << fake.formula();
}

TEST_F(TexTexts, OneFormulaIsSetOnce) {
  const Loaded l =
      load("create f{1..20} text tex=\"x\"\ncreate g text tex=\"x\"\nset g.tex \"y\"\nat 9f g.tex \"x\"\n");
  EXPECT_EQ(said(l.diagnostics), "");
  EXPECT_EQ(fake.latex_calls(), 2U);
}

TEST_F(TexTexts, ChangeAtTheirTimes) {
  const Loaded l = load(
      "create f text tex=\"x\" color=gold\nat 1f f.tex \"\"\nat 9f f.tex \"x\"\nat 1f f.size 1 linear\nat 9f f.size "
      "3\n");
  EXPECT_TRUE(drawn(l, "8f").empty());
  expect_box(drawn(l, "9f"), {-2.25, -1.5, 0}, {2.25, 3, 0});
}

TEST_F(TexTexts, FramesAreTheSameTwiceAndWhatIsWrittenIsTheSame) {
  const char* text = "create f text tex=\"\\\\frac{a}{\\\"b\\\"}\" size=2 color=gold\nat 9f f.tex \"y\"\n";
  const Loaded a = load(text), b = load(text), again = load(write(a.document));
  EXPECT_EQ(said(again.diagnostics), "");
  EXPECT_EQ(write(again.document), write(a.document));
  EXPECT_NE(write(a.document).find("tex=\"\\\\frac{a}{\\\"b\\\"}\""), std::string::npos) << write(a.document);
  const auto meshes = [](const Loaded& l, const char* time) {
    const Frame frame = Program::compile(l.document).frame(*parse_time(time, l.document));
    EXPECT_EQ(frame.items.size(), 1U);
    return realise(*frame.items.at(0).shape).mesh->positions;
  };
  for (const char* time : {"1f", "9f"}) {
    EXPECT_EQ(meshes(a, time), meshes(b, time));
    EXPECT_EQ(meshes(a, time), meshes(again, time));
  }
}

TEST_F(TexTexts, NoScriptRunsProgramsByItself) {
  const Loaded l = load("create f text tex=\"x\"\ncreate g text tex=\"\"\n", false);
  EXPECT_EQ(said(l.diagnostics), "");
  EXPECT_FALSE(drawn(l).empty());
  EXPECT_EQ(fake.latex_calls(), 0U);
}

TEST_F(TexTexts, WhatIsWrongIsSaidWhereItIs) {
  fake.put("latex", "echo '! Missing $ inserted.' >formula.log; exit 1");
  const Loaded l = load("create a sphere\ncreate f text size=2 tex=\"a$\"\n");
  ASSERT_EQ(l.diagnostics.size(), 1U);
  EXPECT_EQ(told(l), "syntax 2:26 \"a$\"");
  EXPECT_TRUE(mentions(l, "Missing $ inserted"));
}

TEST_F(TexTexts, AreReadOnceAndStayWhole) {
  const auto wrong = [&](const std::string& line) {
    const Loaded l = load("create f text tex=\"x\"\n" + line + "\n");
    return l.diagnostics.size() == 1 ? told(l) : said(l.diagnostics);
  };
  EXPECT_EQ(wrong("set f.tex = \"'x'\""), "type 2:13 \"'x'\"");
  EXPECT_EQ(wrong("split f into letters"), "type 2:7 f");
  EXPECT_TRUE(
      mentions(load("create f text tex=\"x\"\nsplit f into letters\n"), "'f' is a formula; formulas cannot be split"));
}

}  // namespace
}  // namespace betwixt
