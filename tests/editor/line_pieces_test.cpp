// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what the words of a line are, and which lines name which objects.
#include "editor/line_pieces.h"

#include <gtest/gtest.h>

#include "betwixt/language.h"
#include "commands/line_head.h"
#include "editor/named_objects.h"

namespace betwixt {
namespace {

Document film() {
  return load_text(
             "rate 24\ncreate ball sphere\ncreate wheel{1..3} cylinder\ncreate car group\n"
             "define wobble number\nalias round = ball wheel2\n",
             "film.bx")
      .document;
}

// "verb:create name:ball kind:sphere"
std::string pieces(std::string_view line, LineState state = {}) {
  static constexpr const char* words[] = {"comment", "text", "verb",   "kind",  "function", "twerper",
                                          "option",  "time", "number", "color", "name"};
  std::string out;
  for (const LinePiece& p : line_pieces(line, state, film()))
    out += (out.empty() ? "" : " ") + std::string(words[static_cast<int>(p.meaning)]) + ":" +
           std::string(line.substr(p.at, p.length));
  return out;
}

TEST(LinePieces, WordsAreWhatTheTablesSay) {
  EXPECT_EQ(pieces("create ball sphere radius=2 color=gold  # round"),
            "verb:create name:ball kind:sphere function:radius number:2 function:color color:gold comment:# round");
  EXPECT_EQ(pieces("at 24f ball.position.x 3cm linear"),
            "verb:at time:24f name:ball function:position.x number:3cm twerper:linear");
  EXPECT_EQ(pieces("  1f (0 -10.5 0) ease-in=4f"), "time:1f number:0 number:-10.5 number:0 option:ease-in time:4f");
  EXPECT_EQ(pieces("move ball.position 1f..24f by 0.5s"),
            "verb:move name:ball function:position time:1f..24f option:by time:0.5s");
  EXPECT_EQ(pieces("  20f  attach to car keep-world"), "time:20f verb:attach option:to name:car option:keep-world");
  EXPECT_EQ(pieces("set {ball,car}.wobble = \"sin(t) # no comment\""),
            "verb:set name:{ball,car} function:wobble text:\"sin(t) # no comment\"");
  EXPECT_EQ(pieces("at 1:30 note \"say \\\"so\\\"\""), "verb:at time:1:30 verb:note text:\"say \\\"so\\\"\"");
  EXPECT_EQ(pieces("background #ffcc00"), "verb:background color:#ffcc00");
}

TEST(LinePieces, TextsAndBracketsGoOn) {
  LineState s;
  pass_line("set ball.wobble = \"\"\"", s);
  EXPECT_TRUE(s.text);
  EXPECT_EQ(pieces("create x = 3", s), "text:create x = 3");
  pass_line("return 3 \"\"\"  # (", s);
  EXPECT_EQ(s, LineState{});
  pass_line("create p polygon points=((0 0) (1 0)", s);
  EXPECT_EQ(s.brackets, 1);
  EXPECT_TRUE(s.goes_on());
  EXPECT_EQ(pieces("(1 1)) color=red", s), "number:1 number:1 function:color color:red");
  pass_line("(1 1)) color=red", s);
  EXPECT_FALSE(s.goes_on());
  pass_line("note \"(\" # (", s);
  EXPECT_FALSE(s.goes_on());
}

TEST(LinePieces, NumbersUnderTheCursor) {
  const auto under = [](std::string_view line, std::size_t place) {
    const auto n = number_at(line, place);
    return n ? std::string(line.substr(n->at, n->length)) : std::string("none");
  };
  const std::string_view line = "  24f (1 -0.50deg 3)";
  EXPECT_EQ(under(line, 2), "24");
  EXPECT_EQ(under(line, 4), "24");
  EXPECT_EQ(under(line, 8), "1");
  EXPECT_EQ(under(line, 9), "-0.50");
  EXPECT_EQ(under(line, 12), "-0.50");
  EXPECT_EQ(under(line, 15), "-0.50");
  EXPECT_EQ(under(line, 19), "3");
  EXPECT_EQ(under("move a 1f..24f by 2f", 8), "1");
  EXPECT_EQ(under("move a 1f..24f by 2f", 11), "24");
  EXPECT_EQ(under("create wheel12 box", 13), "none");  // of a name
  EXPECT_EQ(under("set a.color #ff8800", 14), "none");
  EXPECT_EQ(under("2-3", 2), "3");  // it is taken away
  EXPECT_EQ(under("no number", 3), "none");
  EXPECT_EQ(under("", 0), "none");
}

TEST(LinePieces, NumbersGoByTheirLastDigit) {
  EXPECT_EQ(stepped("24", 1), "25");
  EXPECT_EQ(stepped("0.50", 3), "0.53");
  EXPECT_EQ(stepped("-0.02", 2), "0.00");
  EXPECT_EQ(stepped("1", -2), "-1");
  EXPECT_EQ(stepped("2", 1, true), "2.1");
  EXPECT_EQ(stepped("9.9", 1), "10.0");
}

TEST(LinePieces, TimesUnderTheCursor) {
  const Document d = film();
  const auto at = [&](std::string_view line, std::size_t place) {
    const auto t = time_at(line, place, d);
    return t ? format_time(*t, d) : std::string("none");
  };
  EXPECT_EQ(at("  24f (0 0 0)", 3), "24f");
  EXPECT_EQ(at("move a.position 1f..24f by 2f", 17), "1f");
  EXPECT_EQ(at("move a.position 1f..24f by 2f", 21), "24f");
  EXPECT_EQ(at("at 0.5s note \"24f\"", 5), "13f");
  EXPECT_EQ(at("at 0.5s note \"24f\"", 15), "none");
  EXPECT_EQ(at("  +12f 3", 4), "none");  // counts from the row above
  EXPECT_EQ(at("set ball.radius 24", 17), "none");
}

std::string spoken(std::string_view line, std::string_view opener = {}) {
  const Document d = film();
  std::string out;
  for (const ObjectId id : objects_named_in(line, opener, d)) out += (out.empty() ? "" : " ") + d.name(id);
  return out;
}

TEST(Speaking, OfWhatALineNames) {
  EXPECT_EQ(spoken("create ball sphere color=gold"), "ball");
  EXPECT_EQ(spoken("at 24f ball.position (0 0 0)"), "ball");
  EXPECT_EQ(spoken("attach wheel* to car"), "wheel1 wheel2 wheel3 car");
  EXPECT_EQ(spoken("hide {wheel3,ball}"), "wheel3 ball");
  EXPECT_EQ(spoken("set round.color red"), "ball wheel2");  // an alias
  EXPECT_EQ(spoken("# ball"), "");
  EXPECT_EQ(spoken("note \"ball\""), "");
  EXPECT_EQ(spoken("  24f attach to car", "ball.attachment"), "ball car");
  EXPECT_EQ(spoken("  24f (0 1 0)", "wheel[12].position"), "wheel1 wheel2");
}

TEST(Speaking, OfWhatIsSelected) {
  const Document d = film();
  const std::vector<ObjectId> car{d.find("car")}, wheel{d.find("wheel2")};
  EXPECT_TRUE(names_any("couple ball to car", {}, d, car));
  EXPECT_FALSE(names_any("couple ball to car", {}, d, wheel));
  EXPECT_TRUE(names_any("set wheel*.color red", {}, d, wheel));
  EXPECT_TRUE(names_any("set round.color red", {}, d, wheel));
  EXPECT_TRUE(names_any("  1f red", "wheel?.color", d, wheel));
  EXPECT_FALSE(names_any("set wheel*.color red", {}, d, car));
  EXPECT_FALSE(names_any("set wheel*.color red", {}, d, {}));
}

TEST(Speaking, SheetsAreOpened) {
  EXPECT_TRUE(opens_sheet("ball.position"));
  EXPECT_TRUE(opens_sheet("on sway ball.position  # softly"));
  EXPECT_TRUE(opens_sheet("at 24f edit house"));
  EXPECT_TRUE(opens_sheet("make house"));
  EXPECT_FALSE(opens_sheet("  1f 2"));
  EXPECT_FALSE(opens_sheet("hide ball"));
  EXPECT_FALSE(opens_sheet("undo"));
  EXPECT_FALSE(opens_sheet(""));
  EXPECT_TRUE(below_opener("  1f 2"));
  EXPECT_TRUE(below_opener(""));
  EXPECT_TRUE(below_opener("# remark"));
  EXPECT_FALSE(below_opener("hide ball"));
}

}  // namespace
}  // namespace betwixt
