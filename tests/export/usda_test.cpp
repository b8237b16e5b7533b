// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the content of .usda files: constant and changing values, joints and lights. tests/peers checks the files with
// readers of USD.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "export/formats.h"

namespace betwixt {
namespace usda_test {

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Usda, WhatSeveralHaveIsWrittenOnce) {
  const Loaded loaded = load_text(
      "create ball{1..50} sphere\ncreate glass box transparency=0.5\ncreate sun light shines=sun intensity=0.5 "
      "position=(0 9 0)\n",
      "test.bx");
  const Program program = Program::compile(loaded.document);
  ExportOptions options;
  std::tie(options.from, options.until) = loaded.document.range();
  Exported made;
  const auto text = make_usda(program, options, made);
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(count(*text, "point3f[] points"), 2U);  // one sphere, one box
  EXPECT_EQ(count(*text, "instanceable = true"), 50U);
  EXPECT_EQ(count(*text, "prepend references = </film/shapes/shape_1>"), 50U);
  EXPECT_EQ(count(*text, "def Material"), 2U);
  // Whatever has a material says that it may.
  EXPECT_EQ(count(*text, "rel material:binding"), 51U);
  EXPECT_EQ(count(*text, "\"MaterialBindingAPI\"]"), 51U);
  EXPECT_EQ(count(*text, "float3[] extent"), 2U);
  EXPECT_EQ(count(*text, "def DistantLight \"sun_rays\""), 1U);
  EXPECT_NE(text->find("float inputs:intensity = 1.57079633"), std::string::npos);
  for (const std::string& sentence : made.left_out) EXPECT_EQ(sentence.find("sun"), std::string::npos) << sentence;
}

TEST(Usda, JointsAreASkeleton) {
  const Loaded loaded = load_file(SOURCE_DIR "/examples/figure.bx");
  ASSERT_FALSE(has_errors(loaded.diagnostics)) << to_string(loaded.diagnostics.front());
  const Program program = Program::compile(loaded.document);
  ExportOptions options;
  std::tie(options.from, options.until) = loaded.document.range();
  options.keys = usual_keys("figure.usda");
  Exported made;
  const auto text = make_usda(program, options, made);
  ASSERT_TRUE(text) << text.error().message;
  EXPECT_EQ(count(*text, "def SkelRoot"), 2U);
  EXPECT_EQ(count(*text, "def SkelAnimation"), 2U);
  EXPECT_EQ(count(*text, "prepend apiSchemas = [\"SkelBindingAPI\", \"MaterialBindingAPI\"]"), 2U);
  EXPECT_LT(text->size(), 1'000'000U);  // it was 27 million
  for (const std::string& sentence : made.left_out) EXPECT_EQ(sentence.find("meshes"), std::string::npos) << sentence;
}

}  // namespace usda_test
}  // namespace betwixt
