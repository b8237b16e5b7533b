// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests copies, renaming and removal of an object with all objects below it by name. The film must equal the film in
// which all of it was written by hand.
#include <algorithm>

#include "betwixt/object.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// Whatever can speak of an object, of one inside and of one outside. # stands for the name of the whole.
constexpr std::string_view around =
    "create pole cylinder\ncreate hat cone position=(0 3 0)\nanimate wind every 1t by translate(0.01 0 0)\n"
    "layer breath add\nprocedure far lua \"length(value('pole.position'))\"\n";
constexpr std::string_view body =
    "create # group position=(1 0 0)\ncreate #/arm box size=(1 2 3)\ncreate #/arm/hand sphere radius=0.2\n"
    "create #/eye camera look-at=#/arm/hand\ncreate #/sign text text=\"#/arm\"\nlayer #/sway mix weight=0.5\n"
    "animate #/spin every 1t by rotate(6deg, z)\nat 60t halt #/spin\n"
    "attach #/sign to #/arm/hand\n#/eye.attachment\n  10f couple to pole\n  20f attach to # keep-world\n"
    "#/eye.look-at\n  1f #/arm\n  8f pole\n  9f #/arm/hand\n"
    "#/arm.motion\n  1f..9f R(90deg @ #) T(1 0)\n  9f..20f R(1turn @ pole) R(1turn @ #/arm/hand) S(2 @ #/arm)\n"
    "#/arm/hand.geometry\n  1f shape(#/arm) linear\n  24f shape(pole)\n"
    "set #/arm.environments (wind #/spin)\n#/arm/hand.drive\n  1f (#/spin)\n  12f none\n"
    "set #/arm.color = \"rgb(value('#/arm/hand.position.x'), value('pole.radius'), #value('#'..'.touching'))\"\n"
    "at 24f #/arm/hand.position = \"value('.world') and value(\\\"#.position\\\") + value('#ner.position')\"\n"
    "on #/sway #/arm.position\n  1f (0 0 0)\n  24f (0 1 0)\non breath set #/arm.position (0 1 0)\n"
    "create #/road curve points=((0 0) (1 2) (3 0))\nset #/sign.position along #/road 0.5\n"
    "#/sign.position\n  1f..9f along #/road turned\n"
    "create #/way trace of=#/arm/hand within=#\ncreate #/shadow trace of=pole within=#/arm\n"
    "filter #/arm.position wobble frequency=2\n#/arm.position.x.velocity\n  30f 1\n  40f release\n";

std::string called(std::string_view text, std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    // In Lua it counts what a list has; `#ner` is another object's name.
    const bool counts = text.substr(i).starts_with("#value");
    text[i] == '#' && !counts ? out += name : out += text[i];
  }
  return out;
}

Document film(const std::string& text) {
  const Loaded made = read(text);
  EXPECT_FALSE(has_errors(made.diagnostics)) << said(made.diagnostics);
  return made.document;
}
void expect_same(const std::string& one, const std::string& other) {
  EXPECT_EQ(write(film(one)), write(film(other)));
  EXPECT_TRUE(film(one) == film(other));
}

TEST(Wholes, ACopyIsWhatOneWouldWriteUnderTheOtherName) {
  const std::string man = std::string(around) + called(body, "man");
  std::string hand_written = called(body, "twin");
  // A text says what it says, and what is no name of an object's is none; all else follows.
  for (const auto& [follows, stays] : {std::pair<std::string, std::string>{"text=\"twin/arm\"", "text=\"man/arm\""},
                                       {"value('twinner.position')", "value('manner.position')"}})
    hand_written.replace(hand_written.find(follows), follows.size(), stays);
  expect_same(man + "create twin like man\n", man + hand_written);
}

TEST(Wholes, ARenamedOneIsTheSameUnderTheOtherName) {
  std::string hand_written = called(body, "boss");
  for (const auto& [follows, stays] : {std::pair<std::string, std::string>{"text=\"boss/arm\"", "text=\"man/arm\""},
                                       {"value('bossner.position')", "value('manner.position')"}})
    hand_written.replace(hand_written.find(follows), follows.size(), stays);
  // What is outside and spoke of it goes on too.
  constexpr std::string_view outside =
      "couple hat to #/arm/hand\nset hat.color = \"value('#/arm.color')\"\nset hat.environments (#/spin)\n"
      "alias all = #/arm/hand pole\ndefine heat number = \"value('#/arm.size.x')\"\nat 1f look through #/eye\n"
      "hat.motion\n  1f..2f R(1turn @ #/arm)\nprocedure near lua \"value('#/arm.position.x')\"\n"
      "dial /fader/1 to #/arm.position.x\n";
  const std::string all = std::string(around) + called(body, "man") + called(outside, "man");
  expect_same(all + "rename man boss\n", std::string(around) + hand_written + called(outside, "boss"));
  expect_same(all + "rename man boss\nrename boss man\n", all);
}

TEST(Wholes, PatternsInAliasesKeepWhatIsRenamed) {
  const Document d = film(
      "create m group\ncreate m/{a,b,c} box\ncreate n group\nalias parts = m/* n\nrename m z\n"
      "set parts.color red\n");
  EXPECT_EQ(objects(d, "parts").size(), 4u);
}

TEST(Wholes, WhatIsRemovedTakesAllBelowItAlong) {
  const std::string man = std::string(around) + called(body, "man");
  expect_same(man + "remove man\n", std::string(around));
  expect_same(man + "remove man*\n", std::string(around));
  const Loaded loaded = read(man + "create man/a{1..9} box\nremove man\n");
  ASSERT_EQ(loaded.diagnostics.back().severity, Severity::notice);
  EXPECT_EQ(loaded.diagnostics.back().what.message,
            "this also removes 18 objects below 'man': man/arm, man/arm/hand, man/eye, man/sign, man/sway, …");
  const Loaded one = read("create a group\ncreate a/b box\nremove a\n");
  EXPECT_EQ(remarks_told(one), std::vector<std::string>{"notice syntax 3:8 a"});
  EXPECT_TRUE(mentions(one, "a/b"));
  // What has lost its parent by another way is below it still.
  EXPECT_EQ(film("create a group\ncreate a/b box\ndetach a/b\nremove a\n").names().size(), 0u);
}

TEST(Wholes, WhatIsSaidOfACopyIsTakenAsItIsSaid) {
  const LoadedFilm s(
      "create eye camera position=(1 2 3)\ncreate eye/ball sphere\nset eye.look-at eye/ball\n"
      "create one like eye\ncreate two like eye look-at=eye/ball position.x=7\n");
  const auto at = [&](const char* name) { return std::get<ObjectId>(s.read(std::string(name) + ".look-at", "1f")); };
  EXPECT_EQ(at("one"), s.loaded.document.find("one/ball"));
  EXPECT_EQ(at("two"), s.loaded.document.find("eye/ball"));
  expect_numbers(s, "two.position", "1f", {7, 2, 3});
}

TEST(Wholes, CopiesOfCopiesAndInsideTheirOriginals) {
  const LoadedFilm s(
      "create a group position=(1 0 0)\ncreate a/b group position=(0 1 0)\ncreate a/b/c box position=(0 0 1)\n"
      "create a/b/d like a position=(2 0 0)\ncreate {x,y} like a\ncreate a/e like a/b\n");
  EXPECT_EQ(s.loaded.document.names().size(), 3u + 3 + 2 * 6 + 6 - 1);
  expect_place(s, "a/b/d/b/c", "1f", {3, 2, 1});
  expect_place(s, "x/b/d/b/c", "1f", {3, 2, 1});
  expect_place(s, "a/e/d/b/c", "1f", {3, 2, 1});
  const LoadedFilm rows("create a group\ncreate a/b box position=(0 1 0)\ncreate r{1..5} like a position=(i 0 0)\n");
  expect_place(rows, "r4/b", "1f", {4, 1, 0});
}

TEST(Wholes, WhatDisplayListsDrawIsCopiedWholeAndOtherwiseLeftToThem) {
  const std::string list = "make star\n  point (0 0)\n  point (1 0)\nmake sky\n  call star\n  color red\nstart sky\n";
  const Document d = film(list + "create twin like sky/star-1\n");
  for (const char* part : {"sky/star-1/point-1", "sky/star-1/point-2", "twin/point-1", "twin/point-2"})
    EXPECT_TRUE(d.find(part)) << part;
  EXPECT_FALSE(derived(d, d.find("twin/point-1")));
  const Document gone = film(list + "create sky2 group\nremove sky2\n");
  EXPECT_TRUE(gone == film(list));
}

TEST(Wholes, NamesThatAreThereAreRefusedAndNothingIsChanged) {
  const std::string man = "create man group\ncreate man/arm box\nanimate m/arm every 1t by rotate(1deg, z)\n";
  EXPECT_EQ(told(man + "create m like man\n"), "name 4:8 m");
  EXPECT_TRUE(mentions(man + "create m like man\n", "'m/arm'"));
  EXPECT_EQ(told(man + "rename man m\n"), "name 4:12 m");
  EXPECT_TRUE(mentions(man + "rename man m\n", "'m/arm'"));
  EXPECT_EQ(told(man + "create man like man\n"), "name 4:8 man");
  EXPECT_EQ(told(man + "create {x,x} like man\n"), "name 4:8 {x,x}");
  EXPECT_TRUE(mentions(man + "create {x,x} like man\n", "'x'"));
  EXPECT_EQ(told(man + "create man/x/y like man\n"), "name 4:8 man/x/y");
  const std::string longest(997, 'n');
  EXPECT_TRUE(told(man + "create " + longest + " like man\n").starts_with("syntax 4:8 nnnnn"));
  EXPECT_EQ(read(man + "rename man m\n").document, read(man).document);
  EXPECT_EQ(read(man + "create m like man\n").document, read(man).document);
  // A million objects are the most, parts counted.
  EXPECT_EQ(told("create a group\ncreate a/b{1..1000} box\ncreate x{1..1000} like a\n"), "range 3:8 x{1..1000}");
}

}  // namespace
}  // namespace betwixt
