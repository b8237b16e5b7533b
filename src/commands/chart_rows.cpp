// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The pieces of charts and tables.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/names.h"
#include "base/utf8.h"
#include "commands/furniture_rows.h"
#include "language/formula.h"
#include "language/values.h"
#include "program/on_axes.h"
#include "scene/axes.h"
#include "scene/letter_widths.h"

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
  double value = 0, at = 0;
};
bool entries(Furnishing& f, const LetList& values, std::vector<Entry>& out) {
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

bool entries(Furnishing& f, std::vector<Entry>& out) { return entries(f, f.said.rows[0], out); }

// The entries of a series: numbers, which are at 1, 2, 3 …, or pairs of numbers.
bool series(Furnishing& f, std::vector<Entry>& out) {
  LetList ats, values = f.said.nested ? LetList() : f.said.rows[0];
  if (f.said.nested)
    for (const LetList& row : f.said.rows) {
      if (row.size() != 2)
        return f.problem = "the values of a line chart are numbers, or pairs of numbers",
               f.hint = "as in of=((0 3) (1 4))", false;
      ats.push_back(row[0]), values.push_back(row[1]);
    }
  if (!entries(f, values, out)) return false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto* q = f.said.nested ? std::get_if<Quantity>(&ats[i]) : nullptr;
    if (f.said.nested && (!q || !std::isfinite(q->value)))
      return f.problem = "the values of a line chart are numbers, or pairs of numbers",
             f.hint = "as in of=((0 3) (1 4))", false;
    out[i].at = q ? q->value : static_cast<double>(i + 1);
  }
  return true;
}

void say_parts(Furnishing& f, const std::vector<Entry>& all) {
  std::string parts;
  for (const Entry& e : all) parts += (parts.empty() ? "" : " ") + e.name;
  f.line("set {}.parts ({})", f.name, parts);
  f.line("set {0}.readings = \"chart.readings('{0}')\"", f.name);
}

// Returns the width of the widest label in em.
double widest_label(const std::vector<Entry>& all) {
  double widest = 0;
  for (const Entry& e : all) widest = std::max(widest, letters_width(e.label));
  return widest;
}

// How the texts of a chart fit into the room of one part, which nothing leaves.
struct Lettering {
  double label = 0.32, number = 0.32;              // their em
  double label_room = 1e300, number_room = 1e300;  // the widest, in em
  std::size_t every = 1;                           // only one label in so many is shown
  bool shown = true;
};
// `axis`: the labels are along an axis, without numbers.
Lettering lettering(const std::vector<Entry>& all, double room, bool up, bool sorted, bool axis = false) {
  constexpr double largest = 0.32, smallest = 0.16;
  Lettering out;
  if (!up) {  // they are one above the other
    out.label = out.number = std::min(0.42 * room, largest);
    out.shown = out.label > 0.02;
    return out;
  }
  const double width = 0.94 * room, widest = widest_label(all);
  out.label = std::clamp(width / std::max(widest, 1e-9), smallest, largest);
  out.number = std::clamp(width / 2.5, 0.12, largest);
  out.label_room = width / out.label, out.number_room = width / out.number;
  // Fewer labels say more than three letters of each. (Those of bars that overtake each other have no order, and below
  // other bars there may be numbers.)
  const bool down = std::any_of(all.begin(), all.end(), [](const Entry& e) { return e.value < 0; });
  if (const double wanted = std::min(widest, 4.5); out.label_room < wanted && !sorted && (axis || !down))
    out.every = static_cast<std::size_t>(std::ceil(wanted / out.label_room));
  out.label_room *= static_cast<double>(out.every);
  return out;
}

// Sets the size of a text of part number i, from 0: it is smaller while the part comes or goes.
void size_text(Furnishing& f, const std::string& text, const Entry& e, std::size_t i, double em, std::size_t every) {
  if (every > 1)
    f.line("set {}.size = \"{} * chart.fit('{}', {}, {})\"", text, write_number(em), f.name, i + 1, every);
  else
    f.line("set {}.size = \"{} * value('{}.room')\"", text, write_number(em), e.name);
}

// Puts the texts of a part: the label at the foot of its bar, the number at its end. Both are on the other side of a
// bar that grows downwards, or to the left.
void letter(Furnishing& f, const Entry& e, std::size_t i, const Lettering& fit, bool up) {
  const std::string grown = fmt::format("value('{}.extent').{}", e.name, up ? 'y' : 'x');
  // Returns the code that chooses between two numbers, the first if the bar grows back.
  const auto either = [&](double back, double forth) {
    return fmt::format("({} < 0 and {} or {})", grown, write_number(back), write_number(forth));
  };
  const std::string label = e.name + "/label", number = e.name + "/number";
  if (up) {
    if (!e.label.empty()) f.line("set {}.position = \"vec(0, {})\"", label, either(0.5 * fit.label, -1.3 * fit.label));
    f.line("set {}.position = \"vec(0, {} + {})\"", number, grown, either(-1.1 * fit.number, 0.35 * fit.number));
    f.line("set {}.text = \"chart.number('{}', {})\"", number, e.name, write_number(fit.number_room));
  } else {
    const auto beside = [&](const std::string& text, const std::string& at, double em, double gap) {
      f.line("set {}.position = \"vec({}{}, {})\"", text, at, either(-gap, gap), write_number(-0.36 * em));
      f.line("set {}.align = \"{} < 0 and '{}' or '{}'\"", text, grown, gap < 0 ? "left" : "right",
             gap < 0 ? "right" : "left");
    };
    if (!e.label.empty()) beside(label, "", fit.label, -0.15);
    beside(number, grown + " + ", fit.number, 0.15);
    f.line("set {0}.text = \"chart.number('{1}')\"", number, e.name);
  }
  if (!e.label.empty()) size_text(f, label, e, i, fit.label, fit.every);
  size_text(f, number, e, i, fit.number, 1);
}

void make_chart(Furnishing& f, bool up) {
  std::vector<Entry> all;
  if (!entries(f, all)) return;
  const Vec3 size = f.vector("size");
  const double room = (up ? size.x : size.y) / static_cast<double>(all.size());
  const bool sorted = std::get<bool>(f.value("sorted"));
  const Lettering fit = lettering(all, room, up, sorted);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Entry& e = all[i];
    f.line("create {} bar value={} color={} upwards={} corner={}", e.name, write_number(e.value),
           f.said.keys.empty() ? f.tint(0) : f.tint(i), up ? "on" : "off", write_number(std::min(0.06, 0.1 * room)));
    if (!fit.shown) continue;
    e.label = i % fit.every == 0 ? shortened(e.label, fit.label_room) : "";
    if (!e.label.empty())
      f.line("create {}/label text text={} size={} color={} align={}", e.name, write_text(e.label),
             write_number(fit.label), f.label(), up ? "centre" : "right");
    f.line("create {}/number text size={} color={} align={}", e.name, write_number(fit.number), f.label(),
           up ? "centre" : "left");
  }
  say_parts(f, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    f.line("set {}.extent = \"chart.extent('{}', {})\"", name, f.name, i + 1);
    f.line("set {}.position = \"chart.place('{}', {})\"", name, f.name, i + 1);
    if (sorted) f.line("filter {}.position smooth width=0.6s", name);
    if (fit.shown) letter(f, all[i], i, fit, up);
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
             write_text(cell_text(rows[r][c])), write_number(em), header && r == 0 ? f.tint(0) : f.ink(),
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
  const double em = std::min(0.28, 0.2 * f.number("radius"));
  for (std::size_t i = 0; i < all.size(); ++i) {
    f.line("create {} arc value={} color={}", all[i].name, write_number(all[i].value), f.tint(i));
    if (!all[i].label.empty())
      f.line("create {}/label text text={} size={} color={}", all[i].name, write_text(all[i].label), write_number(em),
             f.label());
  }
  say_parts(f, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    f.line("set {}.from = \"chart.slice('{}', {}, 0)\"", name, f.name, i + 1);
    f.line("set {}.to = \"chart.slice('{}', {}, 1)\"", name, f.name, i + 1);
    f.line("set {0}.radius = \"(value('{1}.radius') + value('{1}.hole')) / 2\"", name, f.name);
    f.line("set {0}.width = \"value('{1}.radius') - value('{1}.hole')\"", name, f.name);
    if (all[i].label.empty()) continue;
    const std::string label = fmt::format("chart.label('{}', {}, {})", f.name, i + 1, write_number(em));
    f.line("set {}/label.position = \"{}\"", name, label);
    f.line("set {}/label.align = \"local place, side = {} return side\"", name, label);
    f.line("set {}/label.display = \"local place, side, room = {} return room\"", name, label);
  }
}

// Makes the axes of a line chart that is on none. With keys each value has a place of its own, with its key below.
void own_axes(Furnishing& f, const std::vector<Entry>& all) {
  const Vec3 size = f.vector("size");
  const std::string axes = f.name + "/axes";
  const auto [low, high] = std::minmax_element(all.begin(), all.end(), [](auto& a, auto& b) { return a.at < b.at; });
  const bool alone = low->at == high->at, keyed = !f.said.keys.empty();
  const double count = static_cast<double>(all.size());
  // The places of numbers in order are whole: 1, 2, 3 …
  const double step = f.said.nested || alone ? 0 : std::ceil((count - 1) / 10);
  f.line("create {} axes size=({} {}) x=({} {} {})", axes, write_number(size.x), write_number(size.y),
         write_number(alone ? low->at - 1 : low->at), write_number(alone ? low->at + 1 : high->at), write_number(step));
  if (!keyed) return;
  f.line("set {}/x/{{1..{}}}.display off", axes, most_labels(size.x));
  f.line("set {}.x = \"chart.span('{}')\"", axes, f.name);
  const Lettering fit = lettering(all, size.x / count, true, false, true);
  for (std::size_t i = 0; i < all.size(); i += fit.every) {
    const std::string label = axes + "/x/key-" + all[i].name.substr(f.name.size() + 1);
    const std::string text = shortened(all[i].label, fit.label_room);
    if (text.empty()) continue;
    f.line("create {} text text={} size={} color={}", label, write_text(text), write_number(fit.label), f.label());
    f.line("set {}.position = \"axes.place('{}', vec(value('{}.at'), value('{}.y').x)) - vec(0, {})\"", label, axes,
           all[i].name, axes, write_number(0.12 + 1.1 * fit.label));
    size_text(f, label, all[i], i, fit.label, fit.every);
  }
}

void make_line_chart(Furnishing& f) {
  std::vector<Entry> all;
  if (!series(f, all)) return;
  const ObjectId given = axes_of(f.scene, f.object());
  const std::string axes = given ? f.scene.objects[given.index].name : f.name + "/axes";
  const bool keyed = !given && !f.said.keys.empty();
  std::string color(f.tint(0));
  if (f.colored()) {
    const Color c = std::get<Color>(f.value("color"));
    color = fmt::format("rgb({} {} {})", write_number(c.r), write_number(c.g), write_number(c.b));
  }
  if (!given) own_axes(f, all);
  f.line("create {}/line polyline on={} width=0.05 color={}", f.name, axes, color);
  for (const Entry& e : all)
    f.line("create {} dot value={} at={} color={} on={}", e.name, write_number(e.value), write_number(e.at), color,
           axes);
  say_parts(f, all);
  if (!given) f.line("set {}.y = \"chart.range('{}')\"", axes, f.name);
  f.line("set {}/line.points = \"chart.line('{}')\"", f.name, f.name);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    if (keyed) f.line("set {}.at = \"chart.slot('{}', {})\"", name, f.name, i + 1);
    f.line("set {}.position = \"chart.dot('{}', {})\"", name, f.name, i + 1);
    f.line("set {}.radius = \"0.08 * value('{}.room')\"", name, name);
    f.line("set {}.display = \"value('{}.dots')\"", name, f.name);
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
           write_number(y), write_number(2 * w), strong ? "0.035" : "0.015", strong ? f.muted() : f.faint());
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
    f.line("create {0}/{1} polyline width=0.045 color={6} points=(({2} {4}) ({3} {4}) ({3} {5}) ({2} {5}))", f.name,
           name, write_number(side * (w - 0.02)), write_number(side * (w + 0.12)), write_number(h), write_number(-h),
           f.ink());
}

}  // namespace betwixt
