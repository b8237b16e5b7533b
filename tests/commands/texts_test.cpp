// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests texts: their alignment, typed letters, and texts that are split into parts.
#include <fmt/format.h>

#include <algorithm>

#include "exchange/geometry.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// The box of all that is drawn, by its triangles.
Box box_of(const Frame& frame) {
  Box all;
  for (const Item& item : frame.items) {
    const Geometry g = realise(*item.shape);
    for (const auto& p : g.mesh->positions) all.add(transform_point(item.world * g.local, {p[0], p[1], p[2]}));
  }
  return all;
}
void expect_box(const Frame& is, const Frame& wanted, double within = 1e-6) {
  const Box a = box_of(is), b = box_of(wanted);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.low[i], b.low[i], within) << i;
    EXPECT_NEAR(a.high[i], b.high[i], within) << i;
  }
}
std::size_t triangles(const Frame& frame) {
  std::size_t n = 0;
  for (const Item& item : frame.items) n += realise(*item.shape).mesh->triangles.size();
  return n;
}

constexpr const char* title =
    "create title text text=\"AVATAR\\nTo day\" size=0.7 weight=bold depth=0.1 color=gold align=right\n"
    "set title.position (1 2 3)\nset title.rotation euler(20deg 30deg 40deg)\n";

TEST(Texts, PartsAreDrawnWhereTheWholeWas) {
  const LoadedFilm whole(title);
  for (const auto& [into, parts] : {std::pair("letters", 11U), {"words", 3U}, {"lines", 2U}}) {
    const LoadedFilm split(std::string(title) + "split title into " + into + "\n");
    const Frame frame = split.frame("1f");
    EXPECT_EQ(frame.items.size(), parts) << into;
    expect_box(frame, whole.frame("1f"));
    EXPECT_EQ(triangles(frame), triangles(whole.frame("1f")));
    for (const Item& item : frame.items) EXPECT_EQ(item.color.x, whole.frame("1f").items[0].color.x);
  }
}

TEST(Texts, PartsAreTextsOfTheirOwnThatHangOnTheWhole) {
  const LoadedFilm s(
      "create t text text=\"To be\"\nsplit t into words\nt/*.position\n  1f (0 5 0)\n  25f (0 0 0) \n"
      "stagger t/*.position by 4f\nt.position\n  1f (0 0 0)\n  90f (0 0 7)\nset t/2.text \"die\"\n");
  EXPECT_EQ(s.text("t/1.text", "1f"), "To");
  EXPECT_EQ(s.text("t/2.text", "1f"), "die");
  expect_numbers(
      s, {{"t/1.position", "1f", {0, 5, 0}}, {"t/1.position", "25f", {0, 0, 0}}, {"t/2.position", "29f", {0, 0, 0}}});
  EXPECT_NEAR(place(s, "t/1", "90f").z, 7, 1e-12);
  EXPECT_LT(place(s, "t/1", "90f").x, 0);
  EXPECT_GT(place(s, "t/2", "90f").x, 0);
}

TEST(Texts, LooksThatChangeGoAlongAndPlacesDoNot) {
  const LoadedFilm s(
      "create t text text=\"ab\"\nt.color\n  1f red\n  24f blue\nat 10f hide t\nat 20f show t\n"
      "at 1f t.position (1 0 0)\nat 24f t.position (2 0 0)\nsplit t into letters\n");
  expect_numbers(s,
                 {{"t/2.color", "1f", {1, 0, 0}}, {"t/2.color", "24f", {0, 0, 1}}, {"t/1.position", "24f", {0, 0, 0}}});
  EXPECT_EQ(s.frame("1f").items.size(), 2U);
  EXPECT_EQ(s.frame("12f").items.size(), 0U);
  EXPECT_EQ(s.frame("24f").items.size(), 2U);
  // The same film once more, read from what is written.
  const Loaded again = load_text(write(s.loaded.document), "again.bx");
  EXPECT_TRUE(again.document == s.loaded.document) << write(s.loaded.document);
}

TEST(Texts, PartsAreSplitOnAndCopiedWithTheWhole) {
  const LoadedFilm whole("create t text text=\"AV To\"\n"),
      s("create t text text=\"AV To\"\nsplit t into words\nsplit t/{1,2} into letters\ncreate u like t\nremove t\n");
  EXPECT_EQ(s.loaded.document.names(),
            (std::vector<std::string>{"u", "u/1", "u/2", "u/1/1", "u/1/2", "u/2/1", "u/2/2"}));
  expect_box(s.frame("1f"), whole.frame("1f"));
}

TEST(Texts, TypedLettersComeOneByOne) {
  const LoadedFilm s("create t text text=\"To day\" typed=0\nat 1f t.typed 0 linear\nat 13f t.typed 6\n"),
      whole("create t text text=\"To day\"\n");
  EXPECT_EQ(triangles(s.frame("2f")), 0U);  // half a letter is none
  const Box all = box_of(whole.frame("1f"));
  double right = -INFINITY;
  for (const char* time : {"3f", "5f", "9f", "11f", "13f"}) {
    const Box some = box_of(s.frame(time));
    EXPECT_NEAR(some.low.x, all.low.x, 1e-9) << time;
    EXPECT_GT(some.high.x, right) << time;
    right = some.high.x;
  }
  EXPECT_EQ(triangles(s.frame("5f")), triangles(s.frame("7f"))) << "a blank is typed, too";
  expect_box(s.frame("13f"), whole.frame("1f"), 0);
  EXPECT_EQ(triangles(s.frame("90f")), triangles(whole.frame("1f")));
}

TEST(Texts, AlignedOnesBeginOrEndAtTheirPlace) {
  const LoadedFilm s(
      "create a text text=\"Hm\\nHmmm\" align=left\ncreate b text text=\"Hm\\nHmmm\" align=right\nset b.position (20 0 "
      "0)\n");
  const Frame both = s.frame("1f");
  Frame one = both, other = both;
  one.items.pop_back(), other.items.erase(other.items.begin());
  EXPECT_GT(box_of(one).low.x, 0);
  EXPECT_LT(box_of(one).low.x, 0.2);
  EXPECT_LT(box_of(other).high.x, 20);
  EXPECT_GT(box_of(other).high.x, 19.8);
}

TEST(Texts, WhatCannotBeSaysWhy) {
  const std::string t = "create t text text=\"ab\"\n";
  EXPECT_EQ(told(t + "split t"), "syntax 2:8");
  EXPECT_EQ(told(t + "split t into"), "syntax 2:13");
  EXPECT_EQ(told(t + "split t into leters"), "type 2:14 leters");
  EXPECT_EQ(told(t + "split t into letters now"), "syntax 2:22 now");
  EXPECT_EQ(told(t + "split u into letters"), "name 2:7 u");
  EXPECT_EQ(told("create b box\nsplit b into letters"), "type 2:7 b");
  EXPECT_EQ(told("create t text text=\" \\n\"\nsplit t into lines"), "range 2:7 t");
  EXPECT_EQ(told(t + "create t/2 box\nsplit t into letters"), "name 3:7 t");
  EXPECT_TRUE(mentions(t + "create t/2 box\nsplit t into letters", "'t/2'"));
  EXPECT_EQ(told(t + "split t into letters\nsplit t into letters"), "name 3:7 t");
  EXPECT_TRUE(mentions(t + "split t into letters\nsplit t into letters", "'t/1'"));
  for (const auto& [change, what] :
       std::vector<std::pair<std::string, const char*>>{{"at 9f t.text \"c\"", "'t.text'"},
                                                        {"set t.text = \"'c'\"", "'t.text'"},
                                                        {"at 9f t.size 2", "'t.size'"},
                                                        {"at 9f t.align left", "'t.align'"},
                                                        {"at 9f t.typed 1", "'t.typed'"},
                                                        {"filter t.size wobble", "'t.size'"},
                                                        {"layer l add\non l set t.size 1", "'t.size'"},
                                                        {"at 1f t.size.velocity 1", "'t.size'"}}) {
    const std::string text = t + change + "\nsplit t into letters";
    EXPECT_EQ(told(text), fmt::format("type {}:7 t", 1 + std::count(text.begin(), text.end(), '\n'))) << change;
    EXPECT_TRUE(mentions(text, what)) << change;
  }
  // All or none.
  const std::string two = t + "create u text text=\" \"\n";
  EXPECT_EQ(read(two + "split {t,u} into letters").document, read(two).document);
  EXPECT_EQ(told("create t text align=middle"), "type 1:21 middle");
  EXPECT_EQ(told("create t text weight=0.5"), "type 1:22 0.5");
  EXPECT_FALSE(told(t + "set t.slant oblique").empty());
  EXPECT_FALSE(told(t + "set t.typed -1").empty());
  EXPECT_FALSE(told(t + "set t.typed 20001").empty());
  EXPECT_FALSE(told(t + "set t.typed (1 2)").empty());
}

TEST(Texts, AsManyLettersAsATextMayHaveAreSplit) {
  EXPECT_EQ(told("create t text text=\"" + std::string(1'000'000, 'i') + "\""), "range 1:20 \"");
  EXPECT_TRUE(
      mentions("create t text text=\"" + std::string(20'001, 'i') + "\"", "a text can have at most 20000 letters"));
  const Loaded all = read("create t text text=\"" + std::string(20'000, 'i') + "\"\nsplit t into letters\n");
  EXPECT_EQ(all_told(all), std::vector<std::string>{});
  EXPECT_EQ(all.document.names().size(), 20'001U);
  EXPECT_EQ(all.document.names().back(), "t/20000");
}

TEST(Texts, FontsThatLackAWeightSayWhichTheyHave) {
  const auto notices = [](const std::string& text) {
    std::vector<std::string> all;
    for (const Diagnostic& d : read(text).diagnostics) all.push_back(d.what.message);
    return all;
  };
  const std::vector<std::string> missing{"the font \"DejaVu Sans\" has no style \"black\" on this machine"};
  EXPECT_EQ(notices("create t text weight=black font=\"DejaVu Sans\""), missing);
  EXPECT_EQ(notices("create t text\nset t.weight black"), missing);
  EXPECT_EQ(notices("create t text\nat 9f t.weight black"), missing);
  EXPECT_EQ(notices("create t text weight=bold"), std::vector<std::string>{});
  EXPECT_EQ(notices("layer l add weight=0.5\nset l.weight 1"), std::vector<std::string>{});
}

// DejaVu Sans has no Chinese letters.
TEST(Texts, LettersThatTheFontLacksAreWarnedOf) {
  const auto warned = [](const std::string& script) {
    std::string all;
    for (const Diagnostic& d : read(script).diagnostics)
      all += fmt::format("{}:{} {}\n", d.what.place.line, d.what.place.column, d.what.message);
    return all;
  };
  EXPECT_EQ(warned("create t text text=\"Tokio 東京\"\n"),
            "1:15 the font \"DejaVu Sans\" has no letter '東'; a box is shown\n");
  EXPECT_EQ(warned("create t text text=\"a\"\nset t.text \"京\"\n").substr(0, 2), "2:");
  EXPECT_EQ(warned("create t text text=\"a\"\nt.text\n  1f \"b\"\n  9f \"京\"\n").substr(0, 2), "4:");
  EXPECT_EQ(warned("create t text text=\"naïve — Ω “x” \\n\\t→\"\n"), "");
}

}  // namespace
}  // namespace betwixt
