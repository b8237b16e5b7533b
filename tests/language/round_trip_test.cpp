// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests properties of random scripts: writing and tidying lose nothing, the order of rows does not matter, and no text
// crashes the program.
#include <rapidcheck.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <sstream>

#include "support/dice.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// A script without errors, of every kind of value; the seed decides.
class Author : Dice {
 public:
  using Dice::Dice;

  std::string script() {
    if (chance(3)) say(fmt::format("rate {}", pick({"24", "25", "30000/1001", "12.5"})));
    if (chance(4)) say("ticks 60");
    if (chance(3)) say(fmt::format("range {} {}s", "1f", 1 + below(5)));
    if (chance(3)) say("background " + color() + (chance(3) ? " to " + color() : ""));
    if (chance(6))
      say(pick(
          {"size 320x180", "samples 9", "film flat", "sky on", "ground on", "ambient off", "background transparent"}));
    if (chance(6)) say(pick({"ground ", "ambient "}) + color());
    if (chance(6)) say(fmt::format("fog {} from {}m to {}m", color(), below(10), 10 + below(10)));
    if (chance(6)) say(fmt::format("exposure {}", below(100) / 8.0 - 5));
    if (chance(4)) say("notes off");
    say("define heat number " + number());
    say("define wind vector");
    for (int i = 0; i < 4; ++i) {
      static const char* kinds[] = {"sphere", "box", "camera", "light", "text", "polygon"};
      std::string line = fmt::format("create {}{} {}", i == 3 && chance(2) ? "o0/" : "o", i, kinds[below(6)]);
      if (chance(2)) line += " position=" + vector();
      if (chance(3)) line += " color=" + color();
      if (chance(3)) line += " rotation=" + rotation();
      if (chance(3)) line += " heat=" + number();
      say(line);
    }
    if (chance(3))
      say(fmt::format("create card {} fill={} stroke={} stroke-width=0.{} stroke-round={} dash=(0.{} {}) trim=(0.{} 1)",
                      pick({"rectangle", "circle", "arc", "text"}), pick({"on", "off"}), chance(3) ? "none" : color(),
                      below(100), pick({"on", "off"}), below(100), below(3), below(100)));
    if (chance(4))
      say("create frame polygon points=((0 0) (4 0) (4 4)) holes=" +
          pick({"((1 1) (2 1) (2 2))", "(((1 1) (2 1) (2 2)) ((3 1) (3.5 1) (3 2 0.5)))", "()",
                "((1 1) (2 1) (1 1) (3 3))"}));
    say("alias some = o0 o[12] later*");
    if (chance(2)) say("couple o1 to o0");
    const int commands = 1 + below(8);
    for (int i = 0; i < commands; ++i) command();
    return out_;
  }

 private:
  std::string pick(std::vector<const char*> words) {
    return words[static_cast<std::size_t>(below(static_cast<int>(words.size())))];
  }
  void say(const std::string& line) {
    out_ += line;
    if (chance(4)) out_ += "  # " + pick({"why", "é €", "(an open bracket", "\"quoted\""});
    out_ += "\n";
    if (chance(5)) out_ += pick({"\n", "# a remark\n", "\n\n", "#\n"});
  }
  std::string number() {
    switch (below(5)) {
      case 0:
        return std::to_string(below(100) - 50);
      case 1:
        return fmt::format("{:.3f}", below(10000) / 1000.0);
      case 2:
        return fmt::format("{}", std::ldexp(static_cast<double>(random_() >> 11), below(40) - 60));
      case 3:
        return fmt::format("-{}e-3", below(1000));
      default:
        return "+0.50";
    }
  }
  std::string vector() { return fmt::format("({} {}{} {})", number(), number(), chance(4) ? "," : "", number()); }
  std::string color() {
    switch (below(4)) {
      case 0:
        return pick({"gold", "red", "cornflowerblue"});
      case 1:
        return fmt::format("#{:06x}", below(0x1000000));
      case 2:
        return fmt::format("rgb(0.{} {} 1)", below(1000), below(2));
      default:
        return fmt::format("hsv({}deg 0.{} 1)", below(360), below(100));
    }
  }
  std::string angle() { return fmt::format("{}{}", below(1000) / 7.0, pick({"deg", "rad", "turn"})); }
  std::string euler() { return fmt::format("euler({} {} 0)", angle(), angle()); }
  std::string rotation() {
    return chance(2)   ? euler()
           : chance(2) ? fmt::format("axis({} 1 0, {}deg)", below(9), below(180))
                       : fmt::format("quat({} 1 0.5 0)", below(9));
  }
  std::string time() {
    switch (below(7)) {
      case 0:
        return fmt::format("{}.5f", 1 + below(60));
      case 1:
        return fmt::format("{}s", below(3000) / 1000.0);
      case 2:
        return fmt::format("{}ms", below(3000));
      case 3:
        return fmt::format("{}t", below(90));
      case 4:
        return fmt::format("00:00:0{}", below(3));
      case 5:
        return fmt::format("-{}f", below(9));
      default:
        return fmt::format("{}f", 1 + below(72));
    }
  }
  std::string length() { return pick({"4f", "250ms", "0.3s", "7t"}); }
  std::string options(bool numbers) {
    std::string out;
    if (chance(2))
      out += " " + (numbers ? pick({"linear", "hold", "smooth", "bspline", "hermite", "bezier(0.25 0.1 0.25 1)"})
                            : pick({"hold"}));
    if (chance(4)) out += " ease-in=" + length();
    if (chance(4)) out += " ease-out=" + length();
    return out;
  }
  std::string object() { return "o" + std::to_string(below(3)); }
  void sheet(const std::string& target, const std::function<std::string()>& value, bool numbers) {
    say(target);
    for (int i = below(6); i >= 0; --i) {
      std::string row = std::string(static_cast<std::size_t>(1 + below(4)), ' ') + time() + " ";
      if (numbers && chance(8))
        row += "keep linear";
      else
        row += value() + (numbers && chance(6) ? " cut " + value() : "") + options(numbers);
      say(row);
    }
  }
  void command() {
    const std::string o = object();
    const auto vectors = [this] { return vector(); };
    const auto numbers = [this] { return number(); };
    const auto colors = [this] { return color(); };
    const auto turns = [this] { return euler(); };
    const auto switches = [this] { return pick({"on", "off"}); };
    switch (below(16)) {
      case 0:
        return sheet(o + ".position", vectors, true);
      case 1:
        return sheet(o + ".color", colors, true);
      case 2:
        return sheet(o + ".scale." + pick({"x", "y", "z"}), numbers, true);
      case 3:
        return sheet(o + ".pivot.{x,z}", numbers, true);
      case 4:
        return sheet(o + ".rotation", turns, true);
      case 5:
        return sheet(o + ".display", switches, false);
      case 6:
        return sheet("some.wind", vectors, true);
      case 7:
        return say(fmt::format("at {} note \"{}\"", time(), pick({"a", "é\\n\\\"x\\\"", "# no comment"})));
      case 8:
        return say(fmt::format("twerper {}.position {}", o, pick({"linear", "none", "bezier(0 0 1 0.5)"})));
      case 9:
        return say(fmt::format("extend {}.position {} {}", o, pick({"cycle", "linear", "hold", "bounce"}),
                               pick({"before", "after", ""})));
      case 10:
        return say(fmt::format("copy {}.position 1f..30f to 31f shift (1 0 0) times 2", o));
      case 11:
        return say(fmt::format("scale {}.position 1f..30f (1 -1 0.5)", o));
      case 12:
        return say(fmt::format("at {} {} {}", time(), pick({"show", "hide"}), o));
      case 13:
        return motions(o);
      case 14:
        return say(fmt::format(fmt::runtime(pick({"move {}.motion 1f..30f by 7f", "stretch {}.motion 1f..30f by 1.5",
                                                  "copy {}.motion 1f..30f to 60f", "clear {}.motion 5f..15f"})),
                               o));
      default:
        return say(fmt::format("stretch {}.position 1f..30f by 1.5", o));
    }
  }

  // Segments one after the other, some touching; an object's motions are written once.
  void motions(const std::string& o) {
    if (o == "some" || !moved_.insert(o).second) return;
    say(o + ".motion");
    int at = 1 + below(5);
    for (int i = 1 + below(3); i > 0; --i) {
      const int end = at + 1 + below(20);
      std::string row = fmt::format("  {}f..{}f", at, end);
      for (int k = 1 + below(3); k > 0; --k)
        row += " " + pick({"T(1 2.5)", "T(0.1 0 -3)", "R(90deg)", "R(-2.5turn @ o1)", "R(1rad @ 1 2 3 axis 0 1 1)",
                           "S(2)", "S(0.3 7 @ 1 -1)", "S(-1 0 1 @ o0 linear)"});
      if (chance(3)) row += " " + pick({"smooth", "hold", "bezier(0.1 0 0.2 1)"});
      if (chance(3)) row += " ease-out=2f";
      if (chance(3)) row += " ease-in=3f";
      say(row);
      at = end + (chance(2) ? 0 : below(5));
    }
  }

  std::set<std::string> moved_;
  std::string out_;
};

std::string random_script() { return Author(*rc::gen::arbitrary<std::uint64_t>()).script(); }

std::vector<std::string> comments(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    for (const char* c : {"# why", "# é €", "# (an open bracket", "# \"quoted\"", "# a remark"})
      if (line.ends_with(c)) out.push_back(c);
  std::sort(out.begin(), out.end());
  return out;
}

// shows: G98 G101
TEST(RoundTrip, WritingAndReadingIsTheIdentity) {
  EXPECT_TRUE(rc::check([] {
    const std::string text = random_script();
    const Loaded l = read(text);
    if (has_errors(l.diagnostics)) RC_FAIL(text + said(l.diagnostics));
    const std::string written = write(l.document);
    const Loaded again = load_text(written, "written.bx");
    if (has_errors(again.diagnostics)) RC_FAIL(text + "\n-- written:\n" + written + said(again.diagnostics));
    if (!(again.document == l.document)) RC_FAIL(text + "\n-- written:\n" + written);
    RC_ASSERT(write(again.document) == written);
  }));
}

TEST(RoundTrip, TidyingKeepsTheDocumentAndTheComments) {
  EXPECT_TRUE(rc::check([] {
    const std::string text = random_script();
    const std::string tidied = tidy(text);
    const Loaded again = read(tidied);
    if (has_errors(again.diagnostics) || !(again.document == read(text).document))
      RC_FAIL(text + "\n-- tidied:\n" + tidied + said(again.diagnostics));
    if (tidy(tidied) != tidied) RC_FAIL(text + "\n-- tidied:\n" + tidied + "\n-- tidied again:\n" + tidy(tidied));
    RC_ASSERT(comments(tidied) == comments(text));
  }));
}

// shows: G33
TEST(RoundTrip, OrderOfRowsDoesNotMatter) {
  EXPECT_TRUE(rc::check([] {
    const int rows = *rc::gen::inRange(1, 400);
    std::vector<std::string> lines;
    for (int i = 0; i < rows; ++i)
      lines.push_back(fmt::format("  {}f ({} {} 0){}\n", i * 3 + 1, i, -i, i % 5 ? "" : " linear ease-in=1f"));
    std::string sorted, shuffled;
    for (const auto& l : lines) sorted += l;
    std::shuffle(lines.begin(), lines.end(), std::mt19937_64(*rc::gen::arbitrary<std::uint64_t>()));
    for (const auto& l : lines) shuffled += l;
    const std::string head = "create b sphere\nb.position\n";
    RC_ASSERT(read(head + sorted).document == read(head + shuffled).document);
    RC_ASSERT(tidy(head + shuffled) == tidy(head + sorted));
  }));
}

// Returns the first lines in which two texts differ.
std::string apart(const std::string& a, const std::string& b) {
  std::istringstream left(a), right(b);
  for (std::string l, r; std::getline(left, l), std::getline(right, r);)
    if (l != r) return l + "\n-- and:\n" + r;
  return a + "\n-- and:\n" + b;
}

// Loads, tidies, compiles and asks; what holds for any text.
void try_text(const std::string& text) {
  const Loaded l = read(text);
  said(l.diagnostics);
  const std::string tidied = tidy(text);
  if (tidy(tidied) != tidied) RC_FAIL(apart(tidied, tidy(tidied)));
  if (!has_errors(l.diagnostics)) {
    const Loaded again = read(tidied);
    if (!(again.document == l.document)) RC_FAIL(text + "\n-- tidied:\n" + tidied + said(again.diagnostics));
  }
  if (!(load_text(write(l.document), "written.bx").document == l.document))
    RC_FAIL(text + "\n-- written:\n" + write(l.document));
  const auto [from, to] = l.document.range();
  const Program p = Program::compile(l.document);
  p.frame(from), p.frame(to);
}

// What was said and holds no more: an object that hung on nothing is let go, and a motion goes about what is not there.
TEST(Documents, AreWrittenWholeWhereNothingIsHeldOrAnythingIsGone) {
  const std::string drawn = "make star\n  point (0 0)\nstart star\ncreate a sphere\n";
  for (const std::string& text : {std::string("create cat sphere\ndetach cat\n"),
                                  std::string("create car group\ncreate cat sphere\ncouple cat to car\ndetach cat\n"),
                                  drawn + "a.motion\n  1f..25f R(90deg @ star/point-1)\ndelete star\n"}) {
    const Loaded loaded = load_text(text, "");
    ASSERT_FALSE(has_errors(loaded.diagnostics)) << text;
    const std::string written = write(loaded.document);
    const Loaded again = load_text(written, "");
    EXPECT_FALSE(has_errors(again.diagnostics)) << written;
    EXPECT_TRUE(again.document == loaded.document) << text << "\n" << written;
  }
}

TEST(AnyText, RandomBytesDoNotCrash) {
  EXPECT_TRUE(rc::check([] { try_text(*rc::gen::arbitrary<std::string>()); }));
}

TEST(AnyText, MutatedScriptsDoNotCrash) {
  std::ifstream in(SOURCE_DIR "/examples/bounce.bx");
  const std::string bounce{std::istreambuf_iterator<char>(in), {}};
  EXPECT_TRUE(rc::check([&] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::string text = random() % 2 ? bounce : Author(random()).script();
    for (auto k = random() % 6 + 1; k > 0; --k) {
      const std::size_t at = random() % text.size(), n = std::min<std::size_t>(random() % 12, text.size() - at);
      static constexpr std::string_view pieces[] = {"(",   ")",    "\"",  "\"\"\"", "\n", " ",  "..", "{1..3}",
                                                    "*",   ".x",   "-1",  "1e400",  "#",  "# ", "=",  "@",
                                                    "cut", "keep", "nan", "f",      "\t", ","};
      switch (random() % 4) {
        case 0:
          text.erase(at, n);
          break;
        case 1:
          text.insert(at, pieces[random() % std::size(pieces)]);
          break;
        case 2:
          text.insert(random() % text.size(), text.substr(at, n));
          break;
        default:
          text[at] = static_cast<char>(32 + random() % 95);
      }
      if (text.empty()) text = "\n";
    }
    try_text(text);
  }));
}

}  // namespace
}  // namespace betwixt
