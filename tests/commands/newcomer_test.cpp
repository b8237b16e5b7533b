// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a newcomer is told who has environments and display lists by the wrong end: what, where, and what to write.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr std::string_view film = "animate spin every 1t by rotate(3deg, z)\ncreate ball sphere\n";

struct Slip {
  std::string line, told, hint;
};

TEST(Newcomer, Is_told_what_is_wrong_where_and_what_to_write) {
  const std::string lists = "display lists are made by make NAME; objects are there without being started";
  const std::string rows = "rows are indented, below make NAME or edit NAME";
  const std::string narrow = "a camera sees less than 180deg";
  const Slip table[] = {
      {"couple ball to spin", "3:16: 'spin' is an environment: nothing is held by it",
       "it moves what is in it: set ball.environments (spin)"},
      {"start ball", "3:7: 'ball' is a sphere, not a display list", lists},
      {"edit spin", "3:6: 'spin' is an environment, not a display list", lists},
      {"create spin box", "3:8: there is an environment 'spin' already",
       "objects, environments and layers have names of their own"},
      {"set ball.transform rotate 90deg z", "3:27: an opening bracket '(' is missing here, behind 'rotate'",
       "as in rotate(90deg, z)"},
      {"set ball.transform translate 1 0 0", "3:30: an opening bracket '(' is missing here, behind 'translate'",
       "as in translate(1 0 0)"},
      {"halt spni", "3:6: there is no environment 'spni'", "did you mean 'spin'?"},
      {"set ball.count 3", "3:10: 'ball', a sphere, has no function 'count'", ""},
      {"set spin.radius 3", "3:10: 'spin', an environment, has no function 'radius'", ""},
      {"point (0 0)", "3:1: 'point' is a row of a display list, not a command", rows},
      {"call star", "3:1: 'call' is a row of a display list, not a command", rows},
      {"make a\n  circle (0 0) 2", "4:3: display lists have no 'circle'",
       "rows that draw are point, vector, polygon, text and call; for the others: help make"},
      {"make a\nmake b\n  a", "5:3: display lists have no 'a'", "call a draws that list"},
      {"make a\n  polygn (0 0)", "4:3: display lists have no 'polygn'", "did you mean 'polygon'?"},
      {"make a\n  perspective 200deg", "4:15: perspective is at most 177.6deg", narrow},
      {"create eye camera fov=200deg", "3:23: fov is at most 177.6deg", narrow},
  };
  for (const auto& [line, told, hint] : table) {
    const Loaded loaded = read(std::string(film) + line + "\n");
    EXPECT_EQ(errors(loaded), std::vector<std::string>{told}) << line;
    ASSERT_FALSE(loaded.diagnostics.empty());
    EXPECT_EQ(loaded.diagnostics[0].what.hint, hint) << line;
  }
}

TEST(Newcomer, A_scale_of_nothing_is_pointed_out) {
  for (const char* line :
       {"animate e every 1t by translate(1 0 0) scale(0)", "make a\n  multiply translate(1 0 0) scale(0)",
        "set ball.transform translate(1 0 0) scale(0 0 0)"}) {
    const Loaded loaded = read(std::string(film) + line + "\n");
    ASSERT_EQ(loaded.diagnostics.size(), 1u) << line;
    const Diagnostic& d = loaded.diagnostics[0];
    EXPECT_EQ(d.severity, Severity::warning);
    EXPECT_EQ(d.what.message, "a scale of 0 shrinks all to a point: nothing is seen");
    EXPECT_EQ(d.line.substr(static_cast<std::size_t>(d.what.place.column) - 1, 7), "scale(0");
  }
  EXPECT_TRUE(read(std::string(film) + "set ball.transform scale(1 0 1)\n").diagnostics.empty());  // a shadow
}

TEST(Newcomer, What_can_be_asked_for_has_no_parts) {
  const Loaded loaded = read(film);
  const std::tuple<const char*, const char*, const char*> table[] = {
      {"spin.world.w", "'spin.world' has no part 'w'", "spin.world.x, .y and .z say where it is"},
      {"ball.world.w", "'ball.world' has no part 'w'", "ball.world.x, .y and .z say where it is"},
      {"spin.by.x", "'spin.by' has no part 'x'", "spin.by is a matrix, row by row"},
      {"spin.count.x", "'spin.count' has no part 'x'", "ask for spin.count"},
  };
  for (const auto& [target, message, hint] : table) {
    const auto found = find_targets(target, loaded.document);
    ASSERT_FALSE(found) << target;
    EXPECT_EQ(found.error().message, message);
    EXPECT_EQ(found.error().hint, hint);
  }
}

TEST(Newcomer, Touching_nobody_is_said_with_who_may_be_meant) {
  const LoadedFilm s(std::string(film) + "create eye disc\nset eye.radius = \"#touching('bal')\"\n");
  const std::vector<std::string> problems = s.frame("1f").problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "eye.radius: the procedure \"#touching('bal')\" gives no value: touching('bal'): there is no object 'bal'; "
            "did you mean 'ball'?");
}

}  // namespace
}  // namespace betwixt
