// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of docs/algebra.md must be those of the operation counter. BETWIXT_WRITE_TABLES=1 writes them into the
// page.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>

#include "betwixt/algebra.h"

namespace betwixt {
namespace {

constexpr const char* page = SOURCE_DIR "/docs/algebra.md";
constexpr std::size_t points = 1000;
constexpr std::int64_t steps = 50;

struct Row {
  std::string name;
  Motion motion;  // its scalings by the exponential law
};

Motion linear(Motion m) {
  for (Factor& f : m.factors)
    if (f.kind == Factor::Kind::scale) f.law = Factor::Law::linear;
  return m;
}

// The source's rows, with nothing in a special place.
std::vector<Row> rows() {
  const Factor t = translate_by({5, 3, 0}), r = rotate_by(1, {1, 4, 0}), s = scale_by({2, 3, 1}, {5, 2, 0});
  std::vector<Row> all = {{"T", {{t}}},     {"S", {{s}}},     {"R", {{r}}},     {"TS", {{t, s}}}, {"ST", {{s, t}}},
                          {"TR", {{t, r}}}, {"RT", {{r, t}}}, {"RS", {{r, s}}}, {"SR", {{s, r}}}, {"TRS", {{t, r, s}}}};
  for (const int n : {2, 3, 16}) {
    Motion arms;
    for (int i = 0; i < n; ++i) arms.factors.push_back(rotate_by(1 + i, {i * i + 1.0, i + 0.5, 0}));
    all.push_back({fmt::format("R…R, n = {}", n), arms});
  }
  return all;
}

// Nothing where the method refuses the string.
std::optional<Count> counted(const Motion& motion, Method method) {
  auto count = count_operations(motion, steps, method, points);
  if (count) return *std::move(count);
  EXPECT_EQ(method, Method::differences) << count.error().message;
  return std::nullopt;
}
std::string step(const Motion& motion, Method method) {
  const auto count = counted(motion, method);
  return count ? to_string(count->step) : "none";
}
std::string before(const Motion& motion, Method method) {
  const Cost cost = counted(motion, method)->before;
  return cost.functions > 0 ? fmt::format("{}, {} f", to_string(cost), cost.functions) : to_string(cost);
}

template <class F>
std::string table_of(std::string head, F row_of) {
  for (const Row& row : rows()) head += row_of(row, *printed_costs(row.motion));
  return head;
}

std::string per_step() {
  return table_of(
      "| string | matrix, source | matrix | differences | geometric, source | geometric | best | best, linear law |\n"
      "|---|---|---|---|---|---|---|---|\n",
      [](const Row& row, const Printed& printed) {
        const Motion even = linear(row.motion);
        return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.name, to_string(printed.matrix),
                           step(row.motion, Method::matrix), step(row.motion, Method::differences),
                           to_string(printed.geometric), step(even, Method::geometric), step(row.motion, Method::best),
                           even == row.motion ? "the same" : step(even, Method::best));
      });
}

std::string besides() {
  return table_of(
      "| string | matrix, source | matrix | geometric, source | geometric | best | afterwards, source |\n"
      "|---|---|---|---|---|---|---|\n",
      [](const Row& row, const Printed& printed) {
        return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", row.name, to_string(printed.matrix_before),
                           before(row.motion, Method::matrix), to_string(printed.geometric_before),
                           before(linear(row.motion), Method::geometric), before(row.motion, Method::best),
                           to_string(printed.geometric_after));
      });
}

// All that the source counts per step is reached or beaten by a method that goes exactly where the motion is.
TEST(Page, NoRowOfTheSourceIsCheaper) {
  for (const Row& row : rows()) {
    const Printed printed = *printed_costs(row.motion);
    const auto all = [](const Cost& c) { return c.per_point * static_cast<long long>(points) + c.besides; };
    EXPECT_LE(all(counted(row.motion, Method::best)->step), all(printed.matrix)) << row.name;
    const Motion even = linear(row.motion);
    EXPECT_LE(all(counted(even, Method::geometric)->step), all(printed.geometric)) << row.name;
    if (row.name == "ST") continue;  // the source's scheme for it takes another way to the same end
    EXPECT_LE(all(counted(even, Method::best)->step), all(printed.geometric)) << row.name;
  }
}

// What stands between the marks of this name.
struct Place {
  std::size_t from, length;
};
Place place(const std::string& text, const std::string& name) {
  const std::string begin = "<!-- counted: " + name + " -->\n\n", end = "\n<!-- counted -->";
  const std::size_t from = text.find(begin);
  const std::size_t to = from == std::string::npos ? from : text.find(end, from);
  if (to == std::string::npos) return {std::string::npos, 0};
  return {from + begin.size(), to - from - begin.size()};
}

TEST(Page, HasTheTablesOfTheCounter) {
  std::ifstream in(page);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  in.close();
  const bool writing = std::getenv("BETWIXT_WRITE_TABLES") != nullptr;
  const std::pair<const char*, std::string> tables[] = {{"operations per step", per_step()},
                                                        {"operations before the first step", besides()}};
  for (const auto& [name, table] : tables) {
    const Place p = place(text, name);
    ASSERT_NE(p.from, std::string::npos) << "docs/algebra.md has no place for " << name;
    EXPECT_TRUE(writing || text.substr(p.from, p.length) == table)
        << name << " in docs/algebra.md are not those counted, which are:\n"
        << table << "BETWIXT_WRITE_TABLES=1 writes them there";
    text.replace(p.from, p.length, table);
  }
  if (writing) std::ofstream(page) << text;
}

}  // namespace
}  // namespace betwixt
