// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares lists of CSS transforms with css_platform.txt, values on which all browsers have agreed.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "betwixt/css.h"

namespace betwixt {
namespace {

// One row of css_platform.txt.
struct Agreed {
  std::string line, under, from, to, near;
  double t = 0;
  Mat4 matrix;
};

std::vector<Agreed> agreed() {
  std::ifstream in(SOURCE_DIR "/tests/algebra/css_platform.txt");
  std::vector<Agreed> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    Agreed a;
    a.line = line;
    std::istringstream row(line);
    std::string t, matrix;
    for (std::string* cell : {&a.under, &a.from, &a.to, &t, &a.near, &matrix}) std::getline(row, *cell, '\t');
    a.t = std::stod(t);
    std::istringstream numbers(matrix);
    for (double& x : a.matrix.m) EXPECT_TRUE(numbers >> x) << line;
    rows.push_back(std::move(a));
  }
  return rows;
}

const CssPage agreed_page{100, 100, 16, 16};

Result<CssList> composed(const std::string& under, const std::string& text) {
  const bool replaces = text[0] != '+' && text[0] != '&';
  auto list = parse_css(replaces ? text : text.substr(1), agreed_page);
  if (!list || replaces) return list;
  auto below = parse_css(under, agreed_page);
  if (!below) return below;
  if (text[0] == '&') return css_accumulated(*below, *list);
  below->insert(below->end(), list->begin(), list->end());
  return below;
}

void expect_agreed(const Agreed& a) {
  const auto from = composed(a.under, a.from), to = composed(a.under, a.to);
  ASSERT_TRUE(from && to) << a.line << ": " << (from ? to : from).error().message;
  const Mat4 m = css_between(*from, *to, a.t).matrix;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) {
      // What is divided by is small where the eye is far.
      const double size = std::max(std::abs(a.matrix(r, c)), r == 3 ? 0.01 : 1.0);
      EXPECT_NEAR(m(r, c), a.matrix(r, c), std::stod(a.near) * size) << a.line << ", " << r << " " << c;
    }
}

TEST(CssOfThePlatform, IsWhereAllBrowsersPutIt) {
  const std::vector<Agreed> all = agreed();
  ASSERT_EQ(all.size(), 1197u);
  for (const Agreed& a : all) expect_agreed(a);
}

}  // namespace
}  // namespace betwixt
