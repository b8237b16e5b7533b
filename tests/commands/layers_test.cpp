// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares layers with changing weights with closed forms.
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

const double turn = 2 * std::acos(-1.0);

// shows: G58 R-T16
TEST(Layers, AddAndMixByWeightsThatMove) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere color=rgb(0.2 0.4 0.6)\na.position\n  1f (0 0 0) linear\n  49f (4 0 0)\n"
      "layer up add\nlayer over mix\nup.weight\n  1f 0 linear\n  49f 1\nover.weight\n  25f 0 linear\n  49f 1\n"
      "on up at 1f a.position (0 2 0)\non over set a.position (9 9 9)\n"
      "on up set a.color rgb(0.1 0.1 0)\non over set a.color rgb(1 0 0)\n");
  expect_numbers(s, {{"a.position", "13f", {1, 0.5, 0}}, {"a.position", "25f", {2, 1, 0}}});
  // Half way over: from what the layer below has made, in the order they were made.
  expect_numbers(s, {{"a.position", "37f", {(3 + 9) / 2.0, (1.5 + 9) / 2, 4.5}}, {"a.position", "49f", {9, 9, 9}}});
  expect_numbers(s, "a.color", "25f", {0.25, 0.45, 0.6}, 1e-9);
  expect_numbers(s, "a.color", "49f", {1, 0, 0}, 1e-9);
  // The other order: first over, then up.
  const LoadedFilm other(
      "create a sphere\nlayer over mix weight=0.5\nlayer up add weight=0.5\n"
      "on up set a.position (0 2 0)\non over set a.position (8 8 8)\n");
  expect_numbers(other, "a.position", "1f", {4, 5, 4});
  const LoadedFilm none("create a sphere position=(1 2 3)\nlayer up add weight=0\non up set a.position (0 2 0)\n");
  expect_numbers(none, "a.position", "1f", {1, 2, 3});
}

// shows: G58 G70 R-T16
TEST(Layers, TurnOrientations) {
  for (const double w : {0.0, 0.25, 1.0}) {
    const LoadedFilm s(
        fmt::format("create a box rotation=axis(0 0 1, 30deg)\nlayer add-it add weight={0}\n"
                    "on add-it set a.rotation axis(0 0 1, 80deg)\ncreate b box rotation=axis(0 0 1, 30deg)\n"
                    "layer mix-it mix weight={0}\non mix-it set b.rotation axis(0 0 1, 80deg)\n",
                    w));
    const double a = (30 + 80 * w) / 720 * turn, b = (30 + 50 * w) / 720 * turn;
    expect_numbers(s, "a.rotation", "1f", {std::cos(a), 0, 0, std::sin(a)}, 1e-12);
    expect_numbers(s, "b.rotation", "1f", {std::cos(b), 0, 0, std::sin(b)}, 1e-12);
  }
}

// shows: G58
TEST(Layers, ShortFormsGoWhereTheirLongOnesDo) {
  const std::string head = "create b sphere\ncreate eye camera\nlayer over mix\n";
  for (const auto& [brief, whole] : {std::pair("on over hide b", "on over set b.display off"),
                                     {"on over show b", "on over set b.display on"},
                                     {"on over at 5f hide b", "on over at 5f b.display off"},
                                     {"at 5f on over hide b", "on over at 5f b.display off"},
                                     {"at 5f set b.radius 2 linear", "at 5f b.radius 2 linear"},
                                     {"on over at 5f set b.radius 2", "on over at 5f b.radius 2"},
                                     {"at 5f on over set b.radius 2", "on over at 5f b.radius 2"},
                                     {"at 5f set b.position.velocity (1 0 0)", "at 5f b.position.velocity (1 0 0)"},
                                     {"at 1f..5f set b.motion T(1 0)", "at 1f..5f b.motion T(1 0)"},
                                     {"at 5f set b.radius = \"t\"", "at 5f b.radius = \"t\""}}) {
    const LoadedFilm a(head + brief + "\n"), b(head + whole + "\n");
    EXPECT_TRUE(a.loaded.document == b.loaded.document) << brief;
    EXPECT_FALSE(a.loaded.document == read(head).document) << brief;
  }
  const LoadedFilm seen(head + "on over at 5f hide b\n");
  expect_numbers(seen, {{"b.display", "4f", {1}}, {"b.display", "5f", {0}}});
  EXPECT_EQ(all_told(read(head + "on over at 5f look through eye\n")), (std::vector<std::string>{"syntax 4:15 look"}));
}

// shows: G22 G27
TEST(Layers, UnknownNamesAreSaid) {
  const auto message = [](const std::string& line) {
    const auto all = all_told(read("create a sphere\nlayer up add\n" + line + "\n"));
    return all.size() == 1 ? all[0] : fmt::format("{} errors", all.size());
  };
  for (const auto& [line, told] : {std::pair{"on a set a.radius 2", "type 3:4 a"},
                                   {"on upp set a.radius 2", "name 3:4 upp"},
                                   {"on up create b sphere", "syntax 3:7 create"},
                                   {"on up on up set a.radius 2", "syntax 3:7 on"},
                                   {"layer up add", "name 3:7 up"},
                                   {"layer down sum", "type 3:12 sum"},
                                   {"filter a.position smoth", "name 3:19 smoth"},
                                   {"filter a.position smooth with=5f", "name 3:26 with"},
                                   {"filter a.display noise", "type 3:8 a.display"}})
    EXPECT_EQ(message(line), told);
}

}  // namespace
}  // namespace betwixt
