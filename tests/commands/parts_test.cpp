// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests parts: that an object of a part is what its lines make when they are written out by hand.
#include "commands/parts.h"

#include <fmt/format.h>

#include "commands/reader.h"
#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr const char* lamp =
    "part lamp height=1 color=gold\n  # a street lamp\n  create pole box size=(0.1 height 0.1)\n\n"
    "  create bulb{1..2} sphere radius=0.2 position=(0 height 0) color=color\n  bulb*.radius\n    1f 0.2 linear\n"
    "    25f 0.4\n  at 12f hide self\n  couple bulb1 to pole\n  set pole.color = \"rgb(value('self/bulb1.radius'), 0, "
    "0)\"\n";

std::string by_hand(const std::string& name, const std::string& height, const std::string& color) {
  return fmt::format(
      "create {0} group\ncreate {0}/pole box size=(0.1 {1} 0.1)\n"
      "create {0}/bulb{{1..2}} sphere radius=0.2 position=(0 {1} 0) color={2}\n{0}/bulb*.radius\n  1f 0.2 linear\n"
      "  25f 0.4\nat 12f hide {0}\ncouple {0}/bulb1 to {0}/pole\n"
      "set {0}/pole.color = \"rgb(value('{0}/bulb1.radius'), 0, 0)\"\n",
      name, height, color);
}

// The parts and lets of the one are not of the other.
std::string written_objects(const Loaded& loaded) {
  const std::string text = write(loaded.document);
  return text.substr(text.find("create "), text.npos);
}

TEST(PartsOfFilms, AreWhatTheirLinesMakeByHand) {
  const LoadedFilm part(std::string(lamp) + "create a lamp\ncreate b lamp height=3 color=rgb(0.2 0.4 0.6)\n");
  ASSERT_TRUE(part.loaded.diagnostics.empty()) << said(part.loaded.diagnostics);
  const LoadedFilm hand(by_hand("a", "1", "gold") + by_hand("b", "3", "rgb(0.2 0.4 0.6)"));
  ASSERT_TRUE(hand.loaded.diagnostics.empty()) << said(hand.loaded.diagnostics);
  const std::string text = written_objects(part.loaded), other = written_objects(hand.loaded);
  EXPECT_EQ(text.substr(text.rfind("create a")), other.substr(other.rfind("create a")));
  EXPECT_EQ(part.loaded.document.names(), hand.loaded.document.names());
}

TEST(PartsOfFilms, TakeFormulasOfTheirPlaceAndFunctionsOfTheirGroup) {
  const LoadedFilm s(std::string(lamp) + "create s{1..3} lamp height=i*2 position=(i 0 0)\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(std::get<Vec3>(s.read("s3/pole.size", "1f")), (Vec3{0.1, 6, 0.1}));
  EXPECT_EQ(std::get<Vec3>(s.read("s2.position", "1f")), (Vec3{2, 0, 0}));
}

TEST(PartsOfFilms, AParameterIsAValueWhereAnObjectHasItsName) {
  const LoadedFilm s(
      "part card title=\"T\"\n  create title text text=title\n  set title.size 2\ncreate a card title=\"Hi\"\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(s.text("a/title.text", "1f"), "Hi");
  EXPECT_EQ(std::get<double>(s.read("a/title.size", "1f")), 2);
}

TEST(PartsOfFilms, UseOtherPartsAndLeaveNoNamesBehind) {
  const LoadedFilm s(
      "part knob r=1\n  create c sphere radius=r\npart pair gap=2\n  let half = gap/2\n  create l knob position=(-half "
      "0 0)\n"
      "  create r knob r=half position=(half 0 0)\ncreate a pair\ncreate b pair gap=6\nlet half = 7\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(std::get<double>(s.read("b/r/c.radius", "1f")), 3);
  EXPECT_EQ(std::get<Vec3>(s.read("b/l.position", "1f")), (Vec3{-3, 0, 0}));
}

TEST(PartsOfFilms, ThoseOfTheProgramHaveNoErrors) {
  for (const PartRow& row : part_rows()) {
    const LoadedFilm s(fmt::format("film flat\nrange 1f 97f\ncreate x {}\n", row.name));
    EXPECT_TRUE(s.loaded.diagnostics.empty()) << row.name << said(s.loaded.diagnostics);
    EXPECT_GT(s.loaded.document.names().size(), 1u) << row.name;
  }
}

TEST(PartsOfFilms, AreWrittenAgain) {
  const LoadedFilm s(std::string(lamp) + "create a lamp height=2\n");
  const Loaded again = load_text(write(s.loaded.document), "again.bx");
  ASSERT_TRUE(again.diagnostics.empty()) << said(again.diagnostics);
  EXPECT_TRUE(again.document == s.loaded.document);
}

TEST(PartsOfFilms, CountTheTimesOfTheirSection) {
  const LoadedFilm s(
      "part p w=12f\n  create x circle\n  x.radius\n    1f 1 linear\n    1f+w 2\nsection a for 1s\n  create q p\n"
      "section b for 2s speed=2\n  create r p\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(std::get<double>(s.read("q/x.radius", "13f")), 2);
  EXPECT_EQ(std::get<double>(s.read("r/x.radius", "25f")), 1);
  EXPECT_EQ(std::get<double>(s.read("r/x.radius", "28f")), 1.5);
  EXPECT_EQ(std::get<double>(s.read("r/x.radius", "31f")), 2);
}

TEST(PartsOfFilms, TakeCellsOfRows) {
  const LoadedFilm s(
      "data t of \"\"\"k,v\na,2\nb,5\"\"\" key=k\npart p v=1 name=\"\"\n  create x circle radius=v\n  create n text "
      "text=name\ncreate z{t} p v=row.v name=row.k\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_EQ(std::get<double>(s.read("zb/x.radius", "1f")), 5);
  EXPECT_EQ(s.text("za/n.text", "1f"), "a");
}

struct WrongPart {
  const char *script, *message;
  ErrorCode code;
  int line, column;
};
class WrongParts : public testing::TestWithParam<WrongPart> {};
TEST_P(WrongParts, AreErrorsWithAPlace) {
  const auto& [script, message, code, line, column] = GetParam();
  const Loaded loaded = load_text(script, "film.bx");
  ASSERT_FALSE(loaded.diagnostics.empty()) << script;
  const Diagnostic& d = loaded.diagnostics[0];
  EXPECT_EQ(d.what.message, message);
  EXPECT_EQ(d.what.code, code) << script;
  EXPECT_EQ(d.what.place.line, line) << script;
  EXPECT_EQ(d.what.place.column, column) << script;
}
INSTANTIATE_TEST_SUITE_P(
    All, WrongParts,
    testing::Values(
        WrongPart{"part lamp 1x=3\n  create a box\n", "'1x' cannot be a parameter's name", ErrorCode::syntax, 1, 11},
        WrongPart{"part lamp a=1 a=2\n  create a box\n", "there are two parameters 'a'", ErrorCode::name, 1, 15},
        WrongPart{"part lamp sin=1\n  create a box\n", "'sin' already has a meaning in formulas", ErrorCode::name, 1,
                  11},
        WrongPart{"part lamp a\n  create a box\n", "the parameter 'a' needs a default", ErrorCode::syntax, 1, 12},
        WrongPart{"part box\n  create a box\n", "a kind 'box' already exists", ErrorCode::name, 1, 6},
        WrongPart{"part p\n  create a box\npart p\n  create b box\n", "a part 'p' already exists", ErrorCode::name, 3,
                  6},
        WrongPart{"part p\ncreate x p\n", "the part 'p' has no lines", ErrorCode::syntax, 2, 10},
        WrongPart{"part p size=1\n  create a sphere\n\n  create b sphere radius=sze\ncreate x p\n",
                  "p: film.bx:4: 'sze' is not a number", ErrorCode::syntax, 5, 10},
        WrongPart{"part p size=1\n  create a sphere\ncreate x p sze=2\n", "this part has no 'sze'", ErrorCode::name, 3,
                  12},
        WrongPart{"part p\n  create s p\ncreate x p\n",
                  "the part 'p' contains itself, or parts are more than 32 levels deep", ErrorCode::range, 3, 10}));

TEST(Parts, OfOnesOwnHideThoseOfTheProgramWithAWarning) {
  const Loaded l = read("part lower-third\n  create a box\ncreate x lower-third\n");
  ASSERT_EQ(l.diagnostics.size(), 1u);
  EXPECT_EQ(l.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(l.diagnostics[0].what.place.column, 6);
  EXPECT_TRUE(l.document.scene().names.find("x/a"));
}

}  // namespace
}  // namespace betwixt
