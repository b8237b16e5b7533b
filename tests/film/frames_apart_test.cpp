// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Frames that `betwixt diff` calls equal are equal to the byte when they are drawn by another renderer, in another
// order, and the others differ.
#include "film/frames_apart.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "betwixt/evaluation.h"
#include "betwixt/language.h"
#include "betwixt/program.h"
#include "betwixt/render.h"

namespace betwixt {
namespace frames_apart_test {

const char* const things =
    "range 1f 13f\ncreate a sphere position=(-1 0 0)\ncreate b box position=(1 0 0) color=tomato\n"
    "create t text text=\"Aa\" position=(0 1 0)\ncreate g group\ncreate g/c cone position=(0 -1 0)\n"
    "a.position.y\n  1f 0 linear\n  7f 1\n  13f 0\ng.rotation.z\n  1f 0deg smooth\n  13f 90deg\n"
    "create eye camera position=(0 0 6)\n";

// Returns an edit that shows in some frames: some of them last a while, some change nothing that is seen.
std::string edit(std::mt19937& random) {
  const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const int from = 1 + up_to(13), until = from + up_to(5);
  const char* const who = std::array{"a", "b", "t", "g/c"}[static_cast<std::size_t>(up_to(4))];
  switch (up_to(7)) {
    case 0:
      return fmt::format("at {}f {}.color {}\n", from, who, std::array{"red", "lime", "#123456"}[random() % 3]);
    case 1:
      return fmt::format("at {}f hide {}\nat {}f show {}\n", from, who, until + 1, who);
    case 2:
      return fmt::format("{}.position.x\n  {}f {} linear\n  {}f {}\n", who, from, up_to(3) - 1, until + 1,
                         up_to(3) - 1);
    case 3:
      return fmt::format("set {}.position.z {}\n", who, up_to(30));  // perhaps behind the camera
    case 4:
      return fmt::format("at {}f {}.scale ({} 1 1)\n", from, who, 1 + up_to(2));
    case 5:
      return fmt::format("create extra box position=({} 0 -3) color=blue\nat 1f hide extra\nat {}f show extra\n",
                         up_to(9) - 4, from);
    default:
      return fmt::format("at {}f note \"a remark\"\n", from);
  }
}

Program program_of(const std::string& text) {
  const Loaded loaded = load_text(text, "film.bx", LoadOptions());
  EXPECT_FALSE(has_errors(loaded.diagnostics)) << text;
  return Program::compile(loaded.document);
}

TEST(FramesApart, AreThoseWhosePicturesDifferAndNoOthers) {
  RenderOptions options;
  options.width = 64, options.height = 36;
  std::mt19937 random(36);
  const std::string first = things;
  const Program base = program_of(first);
  const auto frames = frames_between(Time{}, base.document().range().second, base.document().rate());
  ASSERT_TRUE(frames);
  const auto renderer = make_renderer(options);
  ASSERT_TRUE(renderer);
  const auto drawn = [&](const Program& program) {  // the last frame first
    std::vector<Picture> all(static_cast<std::size_t>(frames->count));
    for (int k = frames->count; k-- > 0;) {
      Evaluation one(program);
      one.to(frames->time(k));
      EXPECT_TRUE((*renderer)->render(one, all[static_cast<std::size_t>(k)]));
    }
    return all;
  };
  const std::vector<Picture> before = drawn(base);
  std::size_t equal = 0, different = 0;
  for (int pair = 0; pair < 25; ++pair) {
    const std::string mine = edit(random);
    const Program now = program_of(first + mine);
    const auto apart = frames_apart(base, now, *frames, options);
    ASSERT_TRUE(apart) << mine;
    const std::vector<Picture> after = drawn(now);
    auto next = apart->begin();
    for (int k = 0; k < frames->count; ++k) {
      const bool said = next != apart->end() && next->index == k;
      const auto i = static_cast<std::size_t>(k);
      EXPECT_EQ(before[i].rgba != after[i].rgba, said) << mine << "frame " << 1 + k;
      if (said) {
        EXPECT_GT(next->by.most, 0);
        EXPECT_GT(next->by.pixels, 0u);
        ++next;
      }
      ++(said ? different : equal);
    }
  }
  // Otherwise this test shows nothing.
  EXPECT_GT(equal, 80u);
  EXPECT_GT(different, 80u);
}

}  // namespace frames_apart_test
}  // namespace betwixt
