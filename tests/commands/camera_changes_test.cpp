// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests changes of the camera that take time, and the functions of groups, as words.
#include <gtest/gtest.h>

#include <algorithm>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "scene/document.h"

namespace betwixt {
namespace {

const std::string cameras = "create a camera\ncreate b camera position=(0 0 9)\n";

std::string said_of(const std::string& line) {
  const Loaded loaded = load_text(cameras + "create g group\ncreate ball sphere\n" + line + "\n", "");
  return loaded.diagnostics.empty() ? "" : to_string(loaded.diagnostics[0]);
}

TEST(CameraChanges, AreWrittenAsTheyAreRead) {
  for (const char* const line : {"at 48f look through b for 12f", "at 48f look through b for 12f wipe=left",
                                 "at 48f look through b for 0.31s wipe=iris", "at 48f look through b"}) {
    const Loaded loaded = load_text(cameras + line + "\n", "");
    ASSERT_TRUE(loaded.diagnostics.empty()) << line;
    const std::string written = write(loaded.document);
    EXPECT_NE(written.find(std::string(line) + "\n"), std::string::npos) << written;
    EXPECT_TRUE(load_text(written, "").document == loaded.document);
  }
}

TEST(CameraChanges, TheLastWordCounts) {
  const Loaded loaded = load_text(cameras + "at 48f look through b for 12f\nat 48f look through b\n", "");
  EXPECT_TRUE(loaded.document.scene().cut_ways->empty());
  // A film lasts until the end of its last change.
  const Loaded longer = load_text(cameras + "at 48f look through b for 12f\n", "");
  EXPECT_EQ(longer.document.range().second, longer.document.rate().frame(60));
  // Whoever removes the camera removes the change.
  EXPECT_TRUE(load_text(cameras + "at 48f look through b for 12f\nremove b\n", "").document.scene().cut_ways->empty());
}

TEST(CameraChanges, FramesWithinDifferFromTheirNeighbours) {
  const Loaded loaded = load_text(cameras + "at 48f look through b for 12f\n", "");
  const Program program = Program::compile(loaded.document);
  const Rate rate = loaded.document.rate();
  EXPECT_EQ(program.next_change(rate.frame(50)), rate.frame(50));
  EXPECT_EQ(program.next_change(rate.frame(61)), std::nullopt);
  EXPECT_EQ(program.next_change(rate.frame(10)), rate.frame(48));
}

TEST(CameraChanges, ErrorsSayWhatIsMissing) {
  EXPECT_NE(said_of("look through b for 12f").find("needs a beginning"), std::string::npos);
  EXPECT_NE(said_of("at 4f look through b for 0f").find("longer than 0"), std::string::npos);
  EXPECT_NE(said_of("at 4f look through b for 2f wipe=lft").find("left, right, up, down or iris"), std::string::npos);
  EXPECT_NE(said_of("at 4f look through b for 2f soft").find("wipe="), std::string::npos);
  EXPECT_NE(said_of("at 4f look through b for"), "");
}

TEST(LayerWords, AreThoseOfGroups) {
  EXPECT_EQ(said_of("set g.opacity 0.5"), "");
  EXPECT_EQ(said_of("set g.mask ball"), "");
  EXPECT_EQ(said_of("set g.mask (ball a)"), "");
  EXPECT_EQ(said_of("set g.drop-shadow (0.1 -0.1 0.2)"), "");
  EXPECT_NE(said_of("set g.opacity 2"), "");
  EXPECT_NE(said_of("set g.blend dodge").find("screen"), std::string::npos);
  EXPECT_NE(said_of("set ball.opacity 0.5"), "");
}

TEST(LayerWords, MasksThatCannotBeArePointedOut) {
  const auto warned = [](const std::string& lines) {
    const Loaded loaded = load_text("create g group\ncreate h group\n" + lines, "");
    return std::count_if(loaded.diagnostics.begin(), loaded.diagnostics.end(),
                         [](const Diagnostic& d) { return d.severity != Severity::error; });
  };
  EXPECT_EQ(warned("set g.mask h\n"), 0);
  EXPECT_EQ(warned("set g.mask hole\n"), 1);
  EXPECT_EQ(warned("set g.mask h\nset h.mask g\n"), 2);
  EXPECT_EQ(warned("set g.mask g\n"), 1);
}

TEST(LayerWords, AGroupAtRestIsNoLayer) {
  const Loaded loaded =
      load_text("create g group\ncreate ball sphere\ncouple ball to g\ng.opacity\n  1f 1\n  24f 0\n", "");
  const Program program = Program::compile(loaded.document);
  const Rate rate = loaded.document.rate();
  EXPECT_TRUE(program.frame(rate.frame(1)).layers.empty());
  const Frame half = program.frame(rate.frame(12.5));
  ASSERT_EQ(half.layers.size(), 1U);
  EXPECT_GT(half.layers[0].opacity, 0.3);
  EXPECT_LT(half.layers[0].opacity, 0.7);
  ASSERT_EQ(half.items.size(), 1U);
  EXPECT_EQ(half.items[0].layer, 0);
}

}  // namespace
}  // namespace betwixt
