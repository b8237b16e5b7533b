// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests `bake`: plain events must give the same numbers as formulas, filters and velocities.
#include "betwixt/track.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

const std::string film =
    "rate 24\ncreate a sphere\nset a.position = \"vec(math.sin(3 * t), t * t, 1)\"\ncreate b box\nb.scale\n  1f (1 1 "
    "1) hold\n"
    "  13f (2 3 4) smooth\n  49f (1 1 1)\nfilter b.scale smooth width=0.25s\nat 5f b.rotation.velocity euler(0 90deg "
    "0)\n"
    "at 29f b.rotation.velocity release\ncreate w text text=\"a\"\nset w.text = \"t < 1 and 'one' or 'two'\"\n";

TEST(Bake, IsTheSameAtEveryFrame) {
  const LoadedFilm before(film),
      after(film + "bake a.position 1f..49f\nbake b.{scale,rotation} 1f..49f\nbake w.text 1f..49f\n");
  for (int f = 1; f <= 49; ++f)
    for (const char* target : {"a.position", "b.scale", "b.rotation"})
      expect_numbers(after, target, fmt::format("{}f", f), before.numbers(target, fmt::format("{}f", f)), 1e-12);
  EXPECT_EQ(*std::get<Text>(after.read("w.text", "24f")), "one");
  EXPECT_EQ(*std::get<Text>(after.read("w.text", "26f")), "two");
  const std::string out = write(after.loaded.document);
  for (const char* gone : {"= \"", "filter", "velocity"}) EXPECT_EQ(out.find(gone), std::string::npos) << gone << out;
}

TEST(Bake, WithinATolerance) {
  const LoadedFilm before(film), after(film + "bake a.position 1f..49f every 0.5f within 0.01\n");
  const auto a = (*find_targets("a.position", after.loaded.document))[0];
  const std::size_t kept = events(after.loaded.document, a).size();
  EXPECT_LT(kept, 40u);
  EXPECT_GT(kept, 8u);  // of 97
  for (double f = 1; f <= 49; f += 0.5)
    expect_numbers(after, "a.position", fmt::format("{}f", f), before.numbers("a.position", fmt::format("{}f", f)),
                   0.0101);
  // A straight line needs its ends.
  const LoadedFilm line("rate 24\ncreate a sphere\nset a.radius = \"1 + t\"\nbake a.radius 1f..97f within 1e-9\n");
  EXPECT_EQ(events(line.loaded.document, (*find_targets("a.radius", line.loaded.document))[0]).size(), 2u);
}

TEST(Bake, ErrorsByTheirPlace) {
  const std::string things = "create a sphere\nlayer up add\non up set a.radius 1\n";
  const std::pair<const char*, const char*> table[] = {{"bake", "syntax 4:5"},
                                                       {"bake a.position", "syntax 4:16"},
                                                       {"bake a.position 1f", "syntax 4:17 1f"},
                                                       {"bake a.position 1f..9f every 0f", "range 4:24 every 0f"},
                                                       {"bake a.position 1f..9f within -1", "range 4:24 within -1"},
                                                       {"bake a.position 1f..9f by 2f", "syntax 4:24 by"},
                                                       {"bake a.position 1f..9f every 1e-8s", "range 4:6 a.position"},
                                                       {"bake a.position.x 1f..9f", "type 4:6 a.position.x"},
                                                       {"bake a.radius 1f..9f", "type 4:6 a.radius"},
                                                       {"bake a.attachment 1f..9f", "type 4:6 a.attachment"}};
  for (const auto& [line, words] : table) EXPECT_EQ(told(things + line + "\n"), words) << line;
  EXPECT_TRUE(mentions(things + "bake a.radius 1f..9f\n", "up"));
}

}  // namespace
}  // namespace betwixt
