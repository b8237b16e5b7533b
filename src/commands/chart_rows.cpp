// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The pieces of charts and tables.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/utf8.h"
#include "commands/furniture_rows.h"
#include "language/formula.h"
#include "language/values.h"

namespace betwixt {
namespace {

std::string cell_text(const LetItem& item) {
  if (const auto* q = std::get_if<Quantity>(&item)) return write_number(q->value);
  if (const auto* t = std::get_if<Text>(&item)) return **t;
  return write_let(item);
}

// The values of a chart with the names of its parts.
struct Entry {
  std::string name, label;
  double value = 0;
};
bool entries(Furnishing& f, std::vector<Entry>& out) {
  const LetList& values = f.said.rows[0];
  const LetList& keys = f.said.keys;
  if (!keys.empty() && keys.size() != values.size())
    return f.problem = fmt::format("there are {} values and {} keys", values.size(), keys.size()), false;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto* q = std::get_if<Quantity>(&values[i]);
    if (!q || !std::isfinite(q->value))
      return f.problem = "the values of a chart are numbers", f.hint = "as in of=(3 1 4)", false;
    Entry e;
    e.value = q->value;
    if (!keys.empty()) e.label = *std::get<Text>(keys[i]);
    e.name = key_word(e.label);
    if (e.name.empty() || !taken.insert(e.name).second) taken.insert(e.name = std::to_string(i + 1));
    e.name = f.name + "/" + e.name;
    out.push_back(std::move(e));
  }
  return true;
}

void say_parts(Furnishing& f, const std::vector<Entry>& all) {
  std::string parts;
  for (const Entry& e : all) parts += (parts.empty() ? "" : " ") + e.name;
  f.line("set {}.parts ({})", f.name, parts);
}

void make_chart(Furnishing& f, bool up) {
  std::vector<Entry> all;
  if (!entries(f, all)) return;
  const Vec3 size = f.vector("size");
  const double room = (up ? size.x : size.y) / static_cast<double>(all.size());
  const double em = std::clamp(0.42 * room, 0.05, 0.32);
  const bool sorted = std::get<bool>(f.value("sorted"));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Entry& e = all[i];
    f.line("create {} bar value={} color={} upwards={} corner={}", e.name, write_number(e.value),
           f.said.keys.empty() ? palette(0) : palette(i), up ? "on" : "off", write_number(std::min(0.06, 0.1 * room)));
    if (!e.label.empty())
      f.line("create {}/label text text={} size={} color={} position=({}) align={}", e.name, write_text(e.label),
             write_number(em), label_color,
             up ? fmt::format("0 {}", write_number(-1.3 * em)) : fmt::format("-0.15 {}", write_number(-0.36 * em)),
             up ? "centre" : "right");
    f.line("create {}/number text size={} color={} align={}", e.name, write_number(em), label_color,
           up ? "centre" : "left");
  }
  say_parts(f, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    f.line("set {}.extent = \"chart.extent('{}', {})\"", name, f.name, i + 1);
    f.line("set {}.position = \"chart.place('{}', {})\"", name, f.name, i + 1);
    if (sorted) f.line("filter {}.position smooth width=0.6s", name);
    f.line("set {0}/number.text = \"chart.number('{0}')\"", name);
    if (up)
      f.line("set {0}/number.position = \"vec(0, value('{0}.extent').y + {1})\"", name, write_number(0.35 * em));
    else
      f.line("set {0}/number.position = \"vec(value('{0}.extent').x + 0.15, {1})\"", name, write_number(-0.36 * em));
  }
}

// Returns the letters of the widest cell.
double widest_of(const std::vector<LetList>& rows) {
  double widest = 1;
  for (const LetList& row : rows)
    for (const LetItem& cell : row) {
      const std::string text = cell_text(cell);
      widest = std::max(widest, static_cast<double>(std::count_if(text.begin(), text.end(), begins_character)));
    }
  return widest;
}

// Returns the rows, which all have as many values; otherwise none, and the problem.
std::vector<LetList> cells(Furnishing& f) {
  std::vector<LetList> rows = f.said.rows;
  const std::size_t columns = rows[0].size();
  for (const LetList& row : rows)
    if (row.size() != columns) {
      f.problem = fmt::format("all rows must have as many values: the first has {}, another {}", columns, row.size());
      return {};
    }
  return rows;
}

void put_cells(Furnishing& f, const std::vector<LetList>& rows, Vec3 cell, double em, bool header) {
  const double columns = static_cast<double>(rows[0].size()), height = static_cast<double>(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c)
      f.line("create {}/{}-{} text text={} size={} color={} position=({} {}){}", f.name, r + 1, c + 1,
             write_text(cell_text(rows[r][c])), write_number(em), header && r == 0 ? palette(0) : "#eef1f6",
             write_number((static_cast<double>(c) - (columns - 1) / 2) * cell.x),
             write_number(((height - 1) / 2 - static_cast<double>(r)) * cell.y - 0.36 * em),
             header && r == 0 ? " weight=bold" : "");
}

}  // namespace

void make_bars(Furnishing& f) { make_chart(f, false); }
void make_columns(Furnishing& f) { make_chart(f, true); }

void make_pie(Furnishing& f) {
  std::vector<Entry> all;
  if (!entries(f, all)) return;
  for (const Entry& e : all)
    if (e.value < 0) {
      f.problem = "the values of a pie must not be below 0";
      return;
    }
  for (std::size_t i = 0; i < all.size(); ++i) {
    f.line("create {} arc value={} color={}", all[i].name, write_number(all[i].value), palette(i));
    if (!all[i].label.empty())
      f.line("create {}/label text text={} size=0.28 color={}", all[i].name, write_text(all[i].label), label_color);
  }
  say_parts(f, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    f.line("set {}.from = \"chart.slice('{}', {}, 0)\"", name, f.name, i + 1);
    f.line("set {}.to = \"chart.slice('{}', {}, 1)\"", name, f.name, i + 1);
    f.line("set {0}.radius = \"(value('{1}.radius') + value('{1}.hole')) / 2\"", name, f.name);
    f.line("set {0}.width = \"value('{1}.radius') - value('{1}.hole')\"", name, f.name);
    if (all[i].label.empty()) continue;
    f.line(
        "set {0}/label.position = \"local a = chart.slice('{1}', {2}, 0.5) local r = value('{1}.radius') + 0.45 return "
        "vec(r * cos(a), r * sin(a) - 0.1)\"",
        name, f.name, i + 1);
  }
}

void make_table(Furnishing& f) {
  const std::vector<LetList> rows = cells(f);
  if (rows.empty()) return;
  Vec3 cell = f.vector("cell");
  const double em = std::min(0.5 * cell.y, 0.36);
  if (!f.says("cell")) cell.x = std::max(cell.x, 0.62 * em * widest_of(rows) + 0.5);
  put_cells(f, rows, cell, em, rows.size() > 1);
  const double w = cell.x * static_cast<double>(rows[0].size()) / 2, h = cell.y * static_cast<double>(rows.size()) / 2;
  for (std::size_t r = 0; r <= rows.size(); ++r) {
    const double y = h - cell.y * static_cast<double>(r);
    const bool strong = r == 1 && rows.size() > 1;
    f.line("create {}/line{} line position=({} {}) to=({} 0 0) width={} color={}", f.name, r + 1, write_number(-w),
           write_number(y), write_number(2 * w), strong ? "0.035" : "0.015", strong ? line_color : grid_color);
  }
}

void make_matrix(Furnishing& f) {
  const std::vector<LetList> rows = cells(f);
  if (rows.empty()) return;
  const Vec3 cell = f.vector("cell");
  const double em = std::min(0.6 * cell.y, 0.42);
  put_cells(f, rows, cell, em, false);
  const double w = cell.x * static_cast<double>(rows[0].size()) / 2, h = cell.y * static_cast<double>(rows.size()) / 2;
  for (const auto& [name, side] : {std::pair{"left", -1.0}, {"right", 1.0}})
    f.line("create {0}/{1} polyline width=0.045 color=#eef1f6 points=(({2} {4}) ({3} {4}) ({3} {5}) ({2} {5}))", f.name,
           name, write_number(side * (w - 0.02)), write_number(side * (w + 0.12)), write_number(h), write_number(-h));
}

}  // namespace betwixt
