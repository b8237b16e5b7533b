// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <complex>

#include "scene/document.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

using Complex = std::complex<long double>;

constexpr long double pi_l = std::numbers::pi_v<long double>;
Complex turned_by(long double turns) { return std::polar(1.0L, 2 * pi_l * turns); }

void expect_place_in(std::string_view film, std::string_view object, std::string_view time, Vec3 wanted) {
  expect_place(LoadedFilm(film), object, time, wanted);
}

TEST(Motions, RollAWheelWhoseNailDrawsACycloid) {
  const LoadedFilm s(
      "create nail sphere position=(0 0 0)\nnail.motion\n  1f..49f T(6.283185307179586 0) R(-1turn @ 0 1)\n");
  for (int f = 1; f <= 49; ++f) {
    const double phi = 2 * pi * (f - 1) / 48;
    expect_place(s, "nail", std::to_string(f) + "f", {phi - std::sin(phi), 1 - std::cos(phi), 0});
  }
}

TEST(Motions, AreNothingBeforeAndStayWhenDone) {
  const LoadedFilm s(
      "create a sphere position=(1 2 0)\na.motion\n  10f..20f T(4 0)\n  30f..40f R(90deg)\n"
      "  40f..50f S(2 @ 5 0)\n");
  expect_places(s, "a",
                {{"1f", {1, 2, 0}}, {"10f", {1, 2, 0}}, {"15f", {3, 2, 0}}, {"20f", {5, 2, 0}}, {"25f", {5, 2, 0}}});
  // What comes next is applied to what is: (5, 2) turned about the origin by 45 and 90 degrees.
  expect_places(s, "a",
                {{"35f", {3 / std::sqrt(2.0), 7 / std::sqrt(2.0), 0}},
                 {"40f", {-2, 5, 0}},
                 {"45f", {5 + std::sqrt(2.0) * -7, 5 * std::sqrt(2.0), 0}},
                 {"900f", {-9, 10, 0}}});
}

// R-H7: the tracks, then the motion, then what it hangs on, then the environments.
TEST(Motions, StackWithTracksAttachmentsAndEnvironments) {
  const LoadedFilm s(
      "create base group position=(10 0 0) rotation=euler(0 0 90deg)\n"
      "create arm group position=(1 0 0) rotation=euler(0 0 30deg)\ncouple arm to base\n"
      "create tip sphere position=(2 0 0)\ncouple tip to arm\n"
      "arm.motion\n  1f..11f T(0 3) R(90deg)\n"
      "animate drift every 1t by translate(0 0 5)\nset base.environments drift\n");
  // At frame 6 the arm has turned by 45 degrees about its parent's origin and moved up by 1.5.
  const Complex up = turned_by(0.25L);
  const auto in_world = [&](Complex in_base) { return Complex(10, 0) + up * in_base; };
  const Complex arm = Complex(0, 1.5L) + turned_by(0.125L) * Complex(1, 0);
  const Complex tip = arm + turned_by(0.125L) * turned_by(30 / 360.0L) * Complex(2, 0);
  const auto at = [&](Complex c, double z) { return Vec3{double(in_world(c).real()), double(in_world(c).imag()), z}; };
  // Frame 6 at 24 a second is 0.2083 s: tick 6 of 30 a second, so seven updates.
  expect_place(s, "arm", "6f", at(arm, 35));
  expect_place(s, "tip", "6f", at(tip, 35));
}

TEST(Motions, HaveCentresThatAreObjects) {
  const std::string scene =
      "create sun sphere position=(1 2 0)\ncreate earth sphere position=(6 2 0)\ncreate moon sphere position=(7 2 0)\n";
  const LoadedFilm named(
      scene + "earth.motion\n  1f..366f R(1turn @ sun)\nmoon.motion\n  1f..366f R(1turn @ sun) R(12turn @ earth)\n");
  const LoadedFilm placed(
      scene + "earth.motion\n  1f..366f R(1turn @ 1 2)\nmoon.motion\n  1f..366f R(1turn @ 1 2) R(12turn @ 6 2)\n");
  for (const int day : {0, 1, 91, 182, 365, 400}) {
    const std::string f = std::to_string(day + 1) + "f";
    const long double t = std::min(day, 365) / 365.0L;
    const Complex earth = Complex(1, 2) + turned_by(t) * Complex(5, 0),
                  moon = earth + turned_by(t) * turned_by(12 * t) * Complex(1, 0);
    for (const LoadedFilm* s : {&named, &placed}) {
      expect_place(*s, "earth", f, {double(earth.real()), double(earth.imag()), 0});
      expect_place(*s, "moon", f, {double(moon.real()), double(moon.imag()), 0});
    }
  }
  // Where it is as the motion begins, seen from what the moved one hangs on.
  const LoadedFilm hung(
      "create base group position=(3 0 0)\ncreate pin group\npin.position\n  1f (5 1 0)\n  10f (9 1 0) linear\n  21f "
      "(9 1 0)\n"
      "create a sphere position=(4 1 0)\ncouple a to base\npin.motion\n  1f..9f T(100 0)\na.motion\n  10f..20f "
      "R(180deg @ pin)\n");
  // The pin has been moved by its own motion: half a turn from (7, 1) in the world about (109, 1).
  expect_place(hung, "a", "20f", {211, 1, 0});
  const LoadedFilm own("create a box position=(4 1 0)\na.motion\n  1f..11f R(90deg @ a)\n");
  expect_place(own, "a", "11f", {4, 1, 0});
  EXPECT_NEAR((*std::get<Matrix>(own.read("a.world", "11f")))(0, 1), -1, 1e-12);
}

TEST(Motions, NestThirtyDeep) {
  std::string chain, centres;
  for (int n = 0; n < 30; ++n) {
    chain += fmt::format(" R({}turn @ {} {})", 0.1 * (n + 1), n, 0.5 * n);
    centres += fmt::format("create g{} group\n{}at 1f..101f g{}.motion R({}turn @ {} {})\n", n,
                           n > 0 ? fmt::format("couple g{} to g{}\n", n, n - 1) : "", n, 0.1 * (n + 1), n, 0.5 * n);
  }
  const LoadedFilm s("create a sphere position=(31 2 0)\nat 1f..101f a.motion" + chain + "\n" + centres +
                     "create b sphere position=(31 2 0)\ncouple b to g29\n");
  for (const int f : {1, 2, 50, 77, 101}) {
    const long double t = (f - 1) / 100.0L;
    Complex p(31, 2);
    for (int n = 29; n >= 0; --n) {
      const Complex c(n, 0.5L * n);
      p = c + turned_by(static_cast<long double>(0.1 * (n + 1)) * t) * (p - c);
    }
    for (const char* name : {"a", "b"})
      expect_place(s, name, std::to_string(f) + "f", {double(p.real()), double(p.imag()), 0}, 1e-10);
  }
}

TEST(Motions, GoByTwerpersAndEases) {
  const LoadedFilm s(
      "create a group\ncreate b group\ncreate c group\ncreate d group\n"
      "at 1f..11f a.motion T(10 0)\nat 1f..11f b.motion T(10 0) ease-in=5f ease-out=5f\n"
      "at 1f..11f c.motion T(10 0) hold\nat 1f..11f d.motion T(10 0)\nextend d.motion linear\n");
  const LoadedFilm track("create t group\nt.position\n  1f (0 0 0) linear ease-out=5f\n  11f (10 0 0) ease-in=5f\n");
  expect_place(s, "a", "4f", {3, 0, 0});
  EXPECT_LT(place(s, "b", "2f").x, 0.5);
  EXPECT_NEAR(place(s, "b", "6f").x, 5, 1e-9);
  expect_places(s, "c", {{"10f", {0, 0, 0}}, {"11f", {10, 0, 0}}});
  expect_place(s, "d", "31f", {30, 0, 0});
  expect_place(s, "a", "31f", {10, 0, 0});
}

// A row is right whatever stands in other rows: what swings over the end does not swing into the next motion.
TEST(Motions, KeepToTheirSegments) {
  const std::string one = "create b group\nat 1f..11f b.motion T(10 0) bezier(0.3 1.5 0.7 1.5)\n";
  const LoadedFilm alone(one), followed(one + "at 100f..111f b.motion T(0 50)\n");
  for (const char* f : {"1f", "4f", "6f", "9f", "11f", "50f"}) expect_place(followed, "b", f, place(alone, "b", f));
  EXPECT_GT(place(alone, "b", "6f").x, 10.1);
  const LoadedFilm smooth(
      "create a group\nat 1f..11f a.motion T(10 0)\nat 31f..41f a.motion T(0 10)\ntwerper a.motion smooth\n");
  for (const char* f : {"11f", "12f", "20f", "31f"}) expect_place(smooth, "a", f, {10, 0, 0});
}

TEST(Motions, GoOnAsTheirTrackIsExtended) {
  const std::string rows = "create a group\nat 11f..21f a.motion T(10 0)\nat 21f..31f a.motion T(0 10)\n";
  const LoadedFilm cycle(rows + "extend a.motion cycle\n"), bounce(rows + "extend a.motion bounce\n"),
      linear(rows + "extend a.motion linear\n");
  expect_places(cycle, "a", {{"36f", {5, 0, 0}}, {"46f", {10, 5, 0}}, {"6f", {10, 5, 0}}});
  expect_places(bounce, "a", {{"36f", {10, 5, 0}}, {"6f", {5, 0, 0}}});
  expect_places(linear, "a", {{"36f", {10, 15, 0}}, {"6f", {-5, 0, 0}}});
  EXPECT_EQ(linear.program.next_change(Time{}), Time{});
}

TEST(Motions, TurnAboutEachOtherAndAboutWhatIsHeld) {
  // Both see the other where it was before.
  const LoadedFilm both(
      "create a group position=(1 0 0)\ncreate b group position=(3 0 0)\nat 1f..11f a.motion R(180deg @ b)\n"
      "at 1f..11f b.motion R(180deg @ a)\n");
  expect_place(both, "a", "11f", {5, 0, 0});
  expect_place(both, "b", "11f", {-1, 0, 0});
  // One after the other: the second sees what the first has done.
  expect_place_in(
      "create a group position=(1 0 0)\ncreate b group position=(3 0 0)\nat 1f..11f a.motion R(180deg @ b)\n"
      "at 11f..21f b.motion R(180deg @ a)\n",
      "b", "21f", {7, 0, 0});
  // A camera that looks at something and is held where it was.
  const LoadedFilm held(
      "create p group position=(5 0 0)\np.position\n  1f (5 0 0) linear\n  21f (25 0 0)\n"
      "create cam camera position=(0 0 9) look-at=(0 0 -50)\ncreate a sphere position=(1 0 0)\n"
      "at 6f couple cam to p keep-world\nat 11f..21f a.motion R(180deg @ cam)\n");
  const Vec3 cam = place(held, "cam", "11f");
  EXPECT_NEAR(cam.x, 5, 1e-9);
  expect_place(held, "a", "21f", {9, 0, 0});
  // What is held where it was turns about a place in the world.
  expect_place_in(
      "create hand group position=(5 0 0)\ncreate a group position=(1 0 0)\ncreate c group position=(1 3 0)\n"
      "at 5f couple a to hand keep-world\nat 10f..20f a.motion R(90deg @ c)\n",
      "a", "20f", {4, 3, 0});
  // What repeats before its first row is left out where a centre is looked up: b is where its tracks put it.
  expect_place_in(
      "create a group position=(1 0 0)\ncreate b group position=(2 0 0)\ncreate c group position=(5 0 0)\n"
      "at 1f..11f a.motion R(180deg @ b)\nat 46f..56f b.motion R(180deg @ c)\nextend b.motion cycle before\n",
      "a", "11f", {3, 0, 0});
}

TEST(Motions, GoThroughSpace) {
  const LoadedFilm s(
      "create a group position=(1 0 0)\n"
      "at 1f..11f a.motion T(0 0 4) R(90deg @ 0 0 0 axis 0 1 0) S(3 1 1)\n");
  expect_place(s, "a", "11f", {0, 0, 4 - 3});
  const double g = std::sqrt(3.0), c = std::sqrt(0.5);
  expect_place(s, "a", "6f", {g * c, 0, 2 - g * c});
}

// Two rows that are the same roll twice: the second begins where the first has left the wheel.
TEST(Motions, TurnAboutWhereThingsAre) {
  const LoadedFilm s(
      "create w torus position=(0 1 0)\ncreate nail sphere position=(0 -1 0)\ncouple nail to w\nw.motion\n"
      "  1f..25f T(6.283185307179586 0) R(-1turn @ w)\n  25f..49f T(6.283185307179586 0) R(-1turn @ w)\n");
  for (int f = 1; f <= 49; ++f) {
    const double phi = 2 * pi * (f - 1) / 24;
    expect_place(s, "nail", std::to_string(f) + "f", {phi - std::sin(phi), 1 - std::cos(phi), 0});
  }
  // Both in one environment: it moves the whole, and changes nothing between them.
  const LoadedFilm in(
      "animate drift every 1t by translate(1 0 0)\ncreate a sphere position=(1 0 0)\ncreate c group position=(3 0 0)\n"
      "set a.environments drift\nset c.environments drift\nat 1f..25f a.motion R(180deg @ c)\n");
  EXPECT_NEAR(place(in, "a", "25f").x - place(in, "c", "25f").x, 2, 1e-9);
  // What is let go is seen from where it was let go.
  expect_place_in(
      "create hand group position=(5 0 0)\ncreate a sphere position=(1 0 0)\ncouple a to hand\n"
      "create c group position=(8 0 0)\nat 5f letgo a\nat 10f..20f a.motion R(90deg @ c)\n",
      "a", "20f", {8, -2, 0});
}

TEST(Motions, KeepTheirCentres) {
  const std::string film =
      "create hub group position=(1 1 0)\ncreate a sphere position=(2 1 0)\nat 1f..25f a.motion R(90deg @ hub)\n";
  const Loaded gone = read(film + "remove hub\n");
  EXPECT_NE(said(gone.diagnostics).find("notice: 'a.motion' now turns about the place of the removed object"),
            std::string::npos);
  EXPECT_NE(write(gone.document).find("R(90deg @ 1 1)"), std::string::npos) << write(gone.document);
  // Of one that is still open, too.
  expect_place_in(
      "create hub group position=(1 1 0)\ncreate a sphere position=(2 1 0)\na.motion\n  1f R(90deg @ hub)\nremove hub\n"
      "at 25f a.motion \"\"\n",
      "a", "25f", {1, 2, 0});
  // A copy that turned about itself turns about its own place.
  const LoadedFilm s(
      "create a box position=(2 0 0)\nat 1f..25f a.motion R(90deg @ a)\ncreate b like a\nset b.position (5 0 0)\n"
      "create c box position=(9 0 0)\ncopy a.motion 1f..25f to 1f on c.motion\n");
  for (const auto& [name, x] : {std::pair{"a", 2.0}, {"b", 5.0}, {"c", 9.0}}) expect_place(s, name, "25f", {x, 0, 0});
  // A list's drawing can go without a word of the language.
  const Loaded drawn = read(
      "make star\n  point (0 0)\nmake sky\n  call star\nstart sky\ncreate a sphere position=(1 0 0)\n"
      "at 1f..25f a.motion R(90deg @ sky/star-1)\ndelete star\n");
  const std::string text = write(drawn.document);
  EXPECT_FALSE(has_errors(read(text).diagnostics)) << text << said(read(text).diagnostics);
}

TEST(Motions, SayWhatOperationsMakeOfThem) {
  const auto notices = [](const std::string& command) {
    return said(read("create a box\na.motion\n  1f..25f T(1 0)\n  30f..40f T(0 1)\n" + command).diagnostics);
  };
  EXPECT_NE(notices("move a.motion 1f..25f by 10f\n")
                .find("'a.motion' have changed: T(1 0) lasts from 11f to 30f, T(0 1) lasts from 30f to 35f\n"),
            std::string::npos)
      << notices("move a.motion 1f..25f by 10f\n");
  EXPECT_NE(notices("clear a.motion 25f\n").find("'a.motion' have changed: T(1 0) lasts from 1f to 30f"),
            std::string::npos);
  EXPECT_NE(notices("clear a.motion 40f\n").find("'a.motion' has lost its end, so the motion from 30f has no effect"),
            std::string::npos);
  EXPECT_EQ(notices("move a.motion 1f..40f by 10f\n"), "");
  EXPECT_EQ(notices("copy a.motion 1f..25f to 50f\n"), "");
}

TEST(Motions, CanBeAskedWhereTheyHaveTakenThings) {
  const LoadedFilm s("create a{1..6} group position=(1 2 3)\nat 1f..11f a*.motion T(10 20 30)\n");
  EXPECT_EQ(s.numbers("a1.world.x", "11f"), (std::vector<double>{11}));
  EXPECT_EQ(s.numbers("a1.world.z", "6f"), (std::vector<double>{18}));
  const auto all = find_targets("a*.world.y", s.loaded.document);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 6u);
  for (const Value& r : s.program.read(*all, *parse_time("11f", s.loaded.document)))
    EXPECT_EQ(numbers(r), (std::vector<double>{22}));
  EXPECT_EQ(s.loaded.document.name((*all)[0]), "a1.world.y");
}

// What falls after a motion goes on as fast as that was, and down, however it has been turned.
TEST(Motions, MayEndInAFall) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere position=(0 5 0)\nat 1f..25f a.motion T(6 0) R(90deg @ a)\nat 25f fall a ground=0\n");
  expect_place(s, "a", "25f", {6, 5, 0});
  const Vec3 later = place(s, "a", "37f");
  EXPECT_NEAR(later.x, 9, 1e-6);
  EXPECT_NEAR(later.y, 5 - 0.5 * 9.81 * 0.25, 1e-6);
  EXPECT_NEAR(later.z, 0, 1e-9);
}

TEST(Motions, AreReadAndWrittenAndKeepTheirNames) {
  const Loaded first = read(
      "rate 24\ncreate sun sphere\ncreate a sphere\na.motion\n  1f..24f T(6.28 0) R(-1turn @ 0 1) ease-in=4f\n"
      "  24f..48f S(2 0.5 @ sun linear) bezier(0.25 0.1 0.25 1) ease-out=3f ease-in=2f\n  60f..72f R(35deg @ 1 2 3 "
      "axis 0 1 0)\n");
  ASSERT_EQ(said(first.diagnostics), "");
  const std::string text = write(first.document);
  EXPECT_NE(text.find("  1f..24f T(6.28 0) R(-1turn @ 0 1) ease-in=4f\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  60f..72f R(35deg @ 1 2 3 axis 0 1 0)\n"), std::string::npos) << text;
  const Loaded again = read(text);
  EXPECT_EQ(said(again.diagnostics), "");
  EXPECT_EQ(again.document, first.document) << text;
  const Loaded renamed = read(text + "rename sun star\n");
  EXPECT_NE(write(renamed.document).find("S(2 0.5 @ star linear)"), std::string::npos);
  // The string that holds then.
  const LoadedFilm s(text);
  EXPECT_EQ(to_string(*std::get<Moves>(s.read("a.motion", "30f"))), "S(2 0.5 @ sun linear)");
  EXPECT_EQ(to_string(*std::get<Moves>(s.read("a.motion", "50f"))), "");
}

TEST(Motions, AreTidiedAsOneValue) {
  EXPECT_EQ(tidy("create a box\na.motion\n 24f..148f T(1   0) linear\n  1f..24f T(6.280 0)   R(-1turn @ 0 1) S(2) "
                 "ease-in=4f # hi\n"),
            "create a box\na.motion\n  1f..24f    T(6.28 0) R(-1turn @ 0 1) S(2)  ease-in=4f  # hi\n"
            "  24f..148f  T(1 0)                          linear\n");
}

TEST(Motions, MayBeCutOpenAndStillReadBack) {
  for (const char* cut : {"clear a.motion 20f..30f\n", "move a.motion 1f..60f by 5f\n", "clear a.motion 1f..1f\n",
                          "stretch a.motion 1f..60f by 2\n", "copy a.motion 1f..24f to 50f\n"}) {
    const Loaded first =
        read(std::string("create a sphere\ncreate b sphere\na.motion\n  1f..24f T(6 0)\n  30f..40f R(90deg)\n") + cut);
    ASSERT_FALSE(has_errors(first.diagnostics)) << said(first.diagnostics);
    const Loaded again = read(write(first.document));
    EXPECT_FALSE(has_errors(again.diagnostics)) << said(again.diagnostics);
    EXPECT_EQ(again.document, first.document) << write(first.document);
    Program::compile(first.document).frame(Time{flicks_per_second});
  }
}

TEST(Motions, SayWhenSomethingWillNextChange) {
  const LoadedFilm s("create a sphere\nat 24f..48f a.motion T(6 0)\n");
  const auto time = [&](const char* t) { return *parse_time(t, s.loaded.document); };
  EXPECT_EQ(s.program.next_change(time("1f")), time("24f"));
  EXPECT_EQ(s.program.next_change(time("30f")), time("30f"));
  EXPECT_EQ(s.program.next_change(time("49f")), std::nullopt);
}

TEST(Motions, SayWhatIsWrong) {
  const std::string a = "create a sphere\ncreate sun sphere\na.motion\n";
  const auto error = [&](const std::string& rows) {
    const auto all = all_told(read(a + rows));
    return all.empty() ? std::string("fine") : all[0];
  };
  EXPECT_EQ(error("  1f..24f T(6 0) Q(1)\n"), "syntax 4:18 Q");
  EXPECT_EQ(error("  1f..24f R(90)\n"), "type 4:13 90");
  EXPECT_EQ(error("  1f..24f S(2 -1)\n"), "range 4:11 S(2 -1)");
  EXPECT_EQ(error("  1f..24f R(90deg @ son)\n"), "name 4:21 son");
  EXPECT_EQ(error("  1f..24f R(90deg @ sun) R(90deg @ su)\n"), "name 4:36 su");
  EXPECT_EQ(error("  1f..24f R(90deg @ (0 0 0) axis (0 1 0))\n"), "fine");
  EXPECT_EQ(error("  1f..24f\n"), "syntax 4:10");
  EXPECT_EQ(error("  1f..24f 3\n"), "syntax 4:11 3");
  EXPECT_EQ(error("  24f..24f T(1 0)\n"), "range 4:12 T");
  EXPECT_EQ(error("  24f..1f T(1 0)\n"), "range 4:3 24f..1f");
  EXPECT_EQ(error("  1f..24f T(1 0) slerp\n"), "type 4:18 slerp");
  EXPECT_EQ(error("  1f..24f T(1 0)\n  12f..36f T(1 0)\n"), "range 5:12 T(1 0)");
  EXPECT_TRUE(mentions(a + "  1f..24f T(1 0)\n  12f..36f T(1 0)\n", "T(1 0)"));
  EXPECT_EQ(error("  12f..36f T(1 0)\n  1f..24f R(1turn)\n"), "range 5:11 R(1turn)");
  EXPECT_TRUE(mentions(a + "  12f..36f T(1 0)\n  1f..24f R(1turn)\n", "T(1 0)"));
  EXPECT_EQ(error("  1f..24f T(1 0)\n  24f..36f T(1 0)\n"), "fine");
  EXPECT_EQ(error("  1f..24f = 1\n"), "syntax 4:13 1");
  EXPECT_EQ(error("a.position\n  1f..24f (0 0 0)\n"), "syntax 5:3 1f..24f");
  EXPECT_EQ(error("at 1f..4f a.position (0 0 0)\n"), "syntax 4:4 1f..4f");
  EXPECT_EQ(error("set a.motion T(1 0)\n"), "type 4:5 a.motion");
  EXPECT_EQ(error("create b sphere motion=T(1 0)\n"), "type 4:17 motion");
  EXPECT_EQ(error("layer up add\non up a.motion\n  1f..3f T(1 0)\n"), "type 5:7 a.motion");
  EXPECT_EQ(error("filter a.motion smooth\n"), "type 4:8 a.motion");
  EXPECT_EQ(error("  1f..24f T(1 0)\nreverse a.motion 1f..24f\n"), "type 5:9 a.motion");
}

}  // namespace
}  // namespace betwixt
