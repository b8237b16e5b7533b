// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests reach HAND to GOAL: where hands are, from when to when, and together with other commands.
#include <algorithm>
#include <cstring>
#include <random>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

// An arm of two bones of 1 m from the origin along x, its elbow a little up; a ball.
const std::string arm =
    "create arm group rotation=euler(0 0 10deg)\ncreate arm/fore group position=(1 0 0) rotation=euler(0 0 -20deg)\n"
    "create arm/fore/palm sphere radius=0.1 position=(1 0 0)\ncreate ball sphere radius=0.1 position=(1 1 0)\n";

TEST(Reach, TwoBonesComeThere) {
  const LoadedFilm s(arm + "reach arm/fore/palm to ball\nball.position\n  1f (1 1 0) linear\n  25f (0.5 -1 1)\n");
  for (const char* t : {"1f", "7.5f", "13f", "25f", "40f"}) {
    const Vec3 ball = place(s, "ball", t), elbow = place(s, "arm/fore", t);
    expect_place(s, "arm/fore/palm", t, ball, 1e-12);
    EXPECT_NEAR(length(elbow), 1, 1e-12);
    EXPECT_NEAR(length(elbow - ball), 1, 1e-12);
  }
  // In the plane it was in, on its side: of a square, the corner that is up and to the left.
  expect_place(s, "arm/fore", "1f", {0, 1, 0}, 1e-12);
  // Too far: straight towards it. The palm cannot be nearer to the shoulder than bones of one length let it: it can be
  // there.
  const LoadedFilm far(arm + "set ball.position (0 5 0)\nreach arm/fore/palm to ball\n");
  expect_place(far, "arm/fore/palm", "1f", {0, 2, 0}, 1e-12);
  const LoadedFilm near(arm + "set arm/fore/palm.position (0.5 0 0)\nreach arm/fore/palm to (0 0.1 0)\n");
  expect_place(near, "arm/fore/palm", "1f", {0, 0.5, 0}, 1e-12);
}

TEST(Reach, IsBlendedInAndOut) {
  const LoadedFilm s(arm + "reach arm/fore/palm to ball from 13f until 49f blend-in=8f blend-out=4f\n"), bare(arm);
  const Vec3 was = place(bare, "arm/fore/palm", "1f"), ball{1, 1, 0};
  const std::pair<double, double> shares[] = {{1, 0},    {12, 0}, {13, 0}, {15, (1 - std::cos(pi / 4)) / 2},
                                              {17, 0.5}, {21, 1}, {40, 1}, {45, 1},
                                              {47, 0.5}, {49, 0}, {60, 0}};
  for (const auto& [f, share] : shares)
    expect_place(s, "arm/fore/palm", fmt::format("{}f", f), was + share * (ball - was), 1e-9);
  // A quarter of a second unless something is said; at once; until for good; the time before it.
  const LoadedFilm usual(arm + "reach arm/fore/palm to ball from 13f until 49f\n");
  expect_place(usual, "arm/fore/palm", "16f", was + 0.5 * (ball - was), 1e-9);
  const LoadedFilm at_once(arm + "at 13f reach arm/fore/palm to ball until 49f blend=0f\n");
  expect_place(at_once, "arm/fore/palm", "12.9f", was, 1e-9);
  expect_place(at_once, "arm/fore/palm", "13f", ball, 1e-9);
  expect_place(at_once, "arm/fore/palm", "48.9f", ball, 1e-9);
  expect_place(at_once, "arm/fore/palm", "49f", was, 1e-9);
  const LoadedFilm good(arm + "reach arm/fore/palm to ball from 13f\n");
  expect_place(good, "arm/fore/palm", "500f", ball, 1e-9);
  // One after the other; places of a sheet blend as those of look-at do.
  const LoadedFilm two(
      arm + "reach arm/fore/palm to ball from 13f until 25f\nreach arm/fore/palm to (1 -1 0) from 25f until 49f\n");
  expect_place(two, "arm/fore/palm", "20f", ball, 1e-9);
  expect_place(two, "arm/fore/palm", "25f", was, 1e-9);
  expect_place(two, "arm/fore/palm", "37f", {1, -1, 0}, 1e-9);
  const LoadedFilm sheet(arm + "arm/fore/palm.reach\n  1f (1 1 0) linear\n  25f (1 -1 0)\n");
  expect_place(sheet, "arm/fore/palm", "7f", {1, 0.5, 0}, 1e-9);
}

TEST(Reach, ThePoleAndLongerChains) {
  const std::string up = arm + "reach arm/fore/palm to (1 0 0) pole=";
  EXPECT_NEAR(place(LoadedFilm(up + "(0 5 0)\n"), "arm/fore", "1f").y, std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(place(LoadedFilm(up + "(0 -5 0)\n"), "arm/fore", "1f").y, -std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(place(LoadedFilm(up + "(0 0 5)\n"), "arm/fore", "1f").z, std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(place(LoadedFilm(up + "ball\n"), "arm/fore", "1f").y, std::sqrt(0.75), 1e-12);
  // A spine of six, of which the upper four bend; what they hang on stays.
  std::string spine = "create s group position=(1 2 3) rotation=euler(10deg 20deg 30deg)\n", name = "s";
  for (int i = 0; i < 6; ++i)
    spine +=
        fmt::format("create {0}/b group position=(0 {1} 0.1) rotation=euler(0 0 {2}deg)\n", name, 0.5 + 0.1 * i, 7 * i),
        name += "/b";
  const LoadedFilm bare(spine), s(spine + fmt::format("reach {} to (1.5 4 3) chain=4\n", name));
  expect_place(s, name, "1f", {1.5, 4, 3}, 1e-6);
  for (const char* still : {"s", "s/b", "s/b/b"}) expect_place(s, still, "1f", place(bare, still, "1f"), 1e-12);
  for (std::string n = "s/b/b"; n != name; n += "/b")
    EXPECT_NEAR(length(place(s, n + "/b", "1f") - place(s, n, "1f")),
                length(place(bare, n + "/b", "1f") - place(bare, n, "1f")), 1e-9);
}

// Whatever holds the bones, and how: scaled, attached, hung, about pivots, in an environment.
TEST(Reach, HoweverTheyHang) {
  for (const char* more :
       {"set arm.scale (1.3 1.3 1.3)\n", "attach arm/fore to arm\n", "hang arm/fore/palm on arm/fore\n",
        "create body group position=(0.3 0.2 0) rotation=euler(0 20deg 0) scale=(0.9 0.9 0.9)\ncouple arm to body\n",
        "set arm.pivot (0 0.2 0)\nset arm/fore.pivot (0.1 0 0)\nset arm/fore/palm.pivot (0 0.05 0.02)\n",
        "animate wind every 1t by translate(0.01 0 0)\nset arm.environments (wind)\n", "set arm.look-at (0 9 1)\n",
        "create eye camera\nset eye.look-at arm/fore/palm\nhang eye on arm\n"}) {
    const LoadedFilm s(arm + more + "reach arm/fore/palm to ball from 1f until 49f blend=0f\n");
    const auto joint = [&](const char* name) {
      const Vec3 pivot = std::get<Vec3>(s.read(std::string(name) + ".pivot", "13f"));
      return transform_point(*std::get<Matrix>(s.read(std::string(name) + ".world", "13f")), pivot);
    };
    EXPECT_NEAR(length(joint("arm/fore/palm") - Vec3{1, 1, 0}), 0, 1e-9) << more;
  }
}

bool same(const Frame& a, const Frame& b) {
  return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), [](const Item& x, const Item& y) {
    return x.id == y.id && std::memcmp(&x.world, &y.world, sizeof x.world) == 0;
  });
}

TEST(Reach, HasTheSameBitsInAnyOrder) {
  const std::string film = arm +
                           "ball.position\n  1f (1 1 0)\n  25f (0.5 -1 1)\n  49f (2 2 2)\narm.rotation\n  1f euler(0 0 "
                           "10deg)\n  49f euler(90deg 0 0)\n"
                           "create b2 sphere\ncouple b2 to arm/fore\nset b2.position (0 1 0)\n"
                           "create leg1 box\ncreate leg2 box position=(0 -1 0)\ncreate leg3 box position=(0 -1 "
                           "0)\ncreate leg4 box position=(0 -1 0)\n"
                           "couple leg2 to leg1\ncouple leg3 to leg2\ncouple leg4 to leg3\n"
                           "reach arm/fore/palm to ball from 5f until 40f pole=(0 9 0)\nreach leg4 to arm/fore/palm "
                           "from 10f until 30f chain=3\n";
  const LoadedFilm s(film);
  std::mt19937 random(5);
  std::vector<Frame> forth;
  for (int f = 1; f <= 50; ++f) forth.push_back(s.frame(fmt::format("{}f", f)));
  for (int i = 0; i < 60; ++i) {
    const int f = 1 + static_cast<int>(random() % 50);
    EXPECT_TRUE(same(s.frame(fmt::format("{}f", f)), forth[static_cast<std::size_t>(f - 1)])) << f;
    if (i % 6 == 0) {
      EXPECT_TRUE(same(LoadedFilm(film).frame(fmt::format("{}f", f)), forth[static_cast<std::size_t>(f - 1)])) << f;
    }
    const auto found = s.loaded.document.find("b2");
    for (const Item& item : forth[static_cast<std::size_t>(f - 1)].items)
      if (item.id == found) {
        EXPECT_EQ(translation_of(item.world), place(s, "b2", fmt::format("{}f", f)));
      }
  }
}

// Who reaches for what another one holds waits for that one, in whichever order they were made.
TEST(Reach, WaitsForWhatItReachesFor) {
  for (const bool first : {false, true}) {
    const std::string leg =
        "create leg group position=(0 0 1)\ncreate leg/knee group position=(1 0 0.1)\ncreate leg/knee/foot sphere "
        "position=(1 0 0)\n";
    const LoadedFilm s((first ? leg + arm : arm + leg) +
                       "create cup sphere radius=0.1 position=(0.2 0 0)\ncouple cup to arm/fore/palm\n"
                       "reach leg/knee/foot to cup\nreach arm/fore/palm to ball\n");
    expect_place(s, "arm/fore/palm", "1f", {1, 1, 0}, 1e-9);
    expect_place(s, "leg/knee/foot", "1f", place(s, "cup", "1f"), 1e-9);
  }
}

// What it takes goes with it from there: nothing jumps when it is taken, nor when the reach ends.
TEST(Reach, ForWhatItTakesMeanwhileGoesWhereThatWas) {
  const std::string reaching = arm + "ball.position\n  1f (1 1 0) linear\n  25f (0.5 -1 1)\n" +
                               "reach arm/fore/palm to ball from 1f until 61f blend-out=12f\n";
  const LoadedFilm kept(reaching + "at 25f attach ball to arm/fore/palm keep-world\n"), bare(arm);
  const Vec3 was{0.5, -1, 1}, back = place(bare, "arm/fore/palm", "1f");
  for (const char* t : {"24.999999f", "25f", "30f", "49f"}) {
    expect_place(kept, "ball", t, was, 1e-6);
    expect_place(kept, "arm/fore/palm", t, was, 1e-6);
  }
  for (const char* t : {"50f", "55f", "60f", "61f", "90f"}) {
    const Vec3 palm = place(kept, "arm/fore/palm", t);
    expect_place(kept, "ball", t, palm, 1e-7);  // as near as it was a moment before
  }
  expect_place(kept, "arm/fore/palm", "61f", back, 1e-9);
  // By a joint, through another thing, and one frame alone.
  const LoadedFilm through(reaching +
                           "create tray group\nat 10f attach tray to arm/fore keep-world\n"
                           "at 25f attach ball to tray keep-world\n");
  for (const char* t : {"49f", "30f", "25f", "24.999999f"}) expect_place(through, "arm/fore/palm", t, was, 1e-6);
  // Another one takes it out of the hand: there it is reached for again.
  const LoadedFilm handed(reaching +
                          "create other group position=(1 -1 0)\nat 25f attach ball to arm/fore/palm keep-world\n" +
                          "at 37f hang ball on other\n");
  expect_place(handed, "arm/fore/palm", "36f", was, 1e-6);
  expect_place(handed, "ball", "37f", Vec3{1, -1, 0} + was, 1e-9);
  EXPECT_NEAR(length(place(handed, "arm/fore/palm", "37f") - 2 * normalize(Vec3{1, -1, 0} + was)), 0, 1e-9);
}

TEST(Reach, IsWrittenCopiedRenamedAndRemoved) {
  const std::string man =
      "create man group\ncreate man/arm group\ncreate man/arm/fore group position=(1 0.1 0)\n"
      "create man/arm/fore/palm sphere position=(1 0 0)\ncreate man/ball sphere position=(1 1 0)\n"
      "reach man/arm/fore/palm to man/ball from 5f until 40f pole=(0 9 0) chain=2\n";
  const LoadedFilm s(man);
  const LoadedFilm again(write(s.loaded.document));
  EXPECT_EQ(again.loaded.document, s.loaded.document);
  EXPECT_TRUE(same(again.frame("20f"), s.frame("20f")));
  const LoadedFilm copy(man + "create you like man\nset you.position (0 0 5)\nset you/ball.position (1 -1 0)\n");
  expect_place(copy, "you/arm/fore/palm", "20f", {1, -1, 5}, 1e-9);
  expect_place(copy, "man/arm/fore/palm", "20f", {1, 1, 0}, 1e-9);
  const LoadedFilm other(man + "rename man boss\n");
  expect_place(other, "boss/arm/fore/palm", "20f", {1, 1, 0}, 1e-9);
  // What it reached for is gone, or a bone.
  const LoadedFilm gone(man + "remove man/ball\n"),
      bare(man + "set man/arm/fore/palm.reach none\nclear man/arm/fore/palm.reach 1f..99f\n");
  expect_place(gone, "man/arm/fore/palm", "20f", place(bare, "man/arm/fore/palm", "20f"), 1e-9);
  const LoadedFilm let_go(man + "at 20f letgo man/arm/fore\n");
  EXPECT_TRUE(finite(std::span(let_go.frame("30f").items[0].world.m)));
}

TEST(Reach, BecomesPlainEvents) {
  const std::string film =
      arm +
      "ball.position\n  1f (1 1 0)\n  25f (0.5 -1 1)\n  49f (2 2 2)\nreach arm/fore/palm to ball from 5f until 40f\n";
  const LoadedFilm s(film), baked(film + "bake arm/fore/palm.reach 1f..49f\n");
  for (int f = 1; f <= 49; f += 4) {
    const std::string t = fmt::format("{}f", f);
    expect_place(baked, "arm/fore/palm", t, place(s, "arm/fore/palm", t), 1e-9);
    expect_place(baked, "arm/fore", t, place(s, "arm/fore", t), 1e-9);
  }
  EXPECT_EQ(write(baked.loaded.document).find("reach"), std::string::npos);
  const LoadedFilm few(film + "bake arm/fore/palm.reach 1f..49f within 0.02\n");
  EXPECT_LT(write(few.loaded.document).size(), write(baked.loaded.document).size() * 2 / 3);
  expect_place(few, "arm/fore/palm", "30f", place(s, "arm/fore/palm", "30f"), 0.06);
}

TEST(Reach, WhatIsWrongIsSaid) {
  const std::pair<const char*, const char*> cases[] = {
      {"reach", "syntax 10:6"},
      {"reach arm/fore/palm", "syntax 10:20"},
      {"reach arm/fore/palm ball", "syntax 10:21 ball"},
      {"reach nobody to ball", "name 10:7 nobody"},
      {"reach arm/fore/palm to nobody", "name 10:24 nobody"},
      {"reach arm/fore/palm to 5", "name 10:24 5"},
      {"reach arm/fore/palm to arm/fore/palm", "name 10:7 arm/fore/palm"},
      {"reach arm/fore/palm to arm", "name 10:7 arm/fore/palm"},
      {"reach arm/fore/palm to arm/fore", "name 10:7 arm/fore/palm"},
      {"reach arm/fore/palm to ring", "name 10:7 arm/fore/palm"},
      {"reach ball to arm", "type 10:7 ball"},
      {"reach arm/fore to ball", "type 10:7 arm/fore"},
      {"reach arm/fore/palm to ball chain=3", "type 10:7 arm/fore/palm"},
      {"reach arm/fore/palm to ball chain=1", "range 10:35 1"},
      {"reach arm/fore/palm to ball chain=65", "range 10:35 65"},
      {"reach arm/fore/palm to ball chain=x", "syntax 10:35 x"},
      {"reach arm/fore/palm to ball chain 2", "syntax 10:35 2"},
      {"reach arm/fore/palm to ball pole=5", "name 10:34 5"},
      {"reach arm/fore/palm to ball pole", "syntax 10:33"},
      {"reach arm/fore/palm to ball from 5", "type 10:34 5"},
      {"reach arm/fore/palm to ball from 9f until 9f", "range 10:7 arm/fore/palm"},
      {"reach arm/fore/palm to ball from 9f until 5f", "range 10:7 arm/fore/palm"},
      {"at 5f reach arm/fore/palm to ball from 9f", "syntax 10:35 from 9f"},
      {"reach arm/fore/palm to ball blend=5f", "syntax 10:7 arm/fore/palm"},
      {"reach arm/fore/palm to ball from 5f blend=-5f", "range 10:43 -5f"},
      {"reach arm/fore/palm to ball from 5f blend=5", "type 10:43 5"},
      {"reach arm/fore/palm to ball for 5f", "syntax 10:29 for"},
      {"reach leg3 to arm/fore/palm\nreach arm/fore/palm to leg3", "name 11:7 arm/fore/palm"},
      {"set arm/fore/palm.reach-chain 65", "range 10:31 65"},
      {"set arm/fore/palm.reach-share 2", "range 10:31 2"},
  };
  const std::string more =
      "create ring torus\ncouple ring to arm/fore\ncreate leg{1..3} group\ncouple leg2 to leg1\ncouple leg3 to "
      "leg2\n";
  for (const auto& [line, wrong] : cases) {
    EXPECT_EQ(told(arm + more + line + "\n"), wrong) << line;
  }
  // Whom it cannot reach, and how many joints there are.
  for (const auto& [line, what] : std::initializer_list<std::pair<const char*, const char*>>{
           {"reach arm/fore/palm to arm", "'arm'"},
           {"reach arm/fore/palm to arm/fore", "'arm/fore'"},
           {"reach arm/fore/palm to ring", "'ring'"},
           {"reach arm/fore/palm to ball chain=3", " 3 "},
           {"reach leg3 to arm/fore/palm\nreach arm/fore/palm to leg3", "'leg3'"}})
    EXPECT_TRUE(mentions(arm + more + line + "\n", what)) << line;
}

// `set`, sheets and what is coupled later are looked at when all is read: the order of the lines does not matter.
TEST(Reach, ForWhatMovesWithItIsSaidAtTheEnd) {
  const std::string more = "create ring torus\ncreate leg{1..3} group\ncouple leg2 to leg1\ncouple leg3 to leg2\n";
  for (const auto& [lines, wrong] : std::initializer_list<std::pair<const char*, const char*>>{
           {"set arm/fore/palm.reach arm", "'arm'"},
           {"arm/fore/palm.reach\n  9f (1 1 0)\n  20f arm/fore/palm", "'arm/fore/palm' cannot reach itself"},
           {"at 5f arm/fore/palm.reach ring\ncouple ring to arm", "'ring'"},
           {"set leg3.reach arm/fore/palm\nset arm/fore/palm.reach leg3", "'leg3'"}}) {
    const LoadedFilm s(arm + more + lines + "\n");
    ASSERT_FALSE(s.loaded.diagnostics.empty()) << lines;
    EXPECT_EQ(told(s.loaded.diagnostics[0]), "warning name arm/fore/palm") << lines;
    EXPECT_NE(s.loaded.diagnostics[0].what.message.find(wrong), std::string::npos) << said(s.loaded.diagnostics);
    EXPECT_TRUE(finite(std::span(s.frame("20f").items[0].world.m)));
  }
  const LoadedFilm fine(arm + more + "at 9f arm/fore/palm.reach ring\ncouple ring to arm\nat 5f detach ring\n");
  EXPECT_EQ(said(fine.loaded.diagnostics), "");
  EXPECT_EQ(said(read(write(fine.loaded.document)).diagnostics), "");
}

}  // namespace
}  // namespace betwixt
