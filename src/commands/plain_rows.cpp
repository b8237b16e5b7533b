// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/plain_rows.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "syntax/characters.h"

namespace betwixt {
namespace {

// Whether an event can go on the sheet's tracks without a look at what is there: numbers that nothing else restricts.
bool takes_plain_numbers(const Scene& s, const Sheet& sheet) {
  const Selected& on = sheet.on;
  if (!sheet.open || sheet.broken || !sheet.list.empty() || !on.spec || on.velocity || sheet.tracks.empty() ||
      !sheet.each_above.empty() || on.spec->type == Type::aim || on.spec->unit >= Unit::moment)
    return false;
  const Type type = on.type();
  if (type == Type::rotation)  // angles do not go beside orientations
    return std::none_of(sheet.tracks.begin(), sheet.tracks.end(), [](const Track* track) {
      return !track->events.empty() && std::holds_alternative<Quat>(track->events.front().value);
    });
  if (type != Type::scalar && type != Type::angle && type != Type::pair && type != Type::vector) return false;
  return on.component < 0 || std::all_of(on.targets.begin(), on.targets.end(), [&](const Target& t) {
           const Slot* const slot = s.objects[t.object.index].find(t.function, t.layer);
           return slot && !slot->components.empty();
         });
}

constexpr auto powers_of_ten = [] {
  std::array<double, 16> all{1};
  for (std::size_t i = 1; i < all.size(); ++i) all[i] = all[i - 1] * 10;
  return all;
}();

const char* behind_blanks(const char* at, const char* end) {
  while (at < end && blank(*at)) ++at;
  return at;
}

// Reads a number without a sign '+' and without a formula. Returns its end, or nullptr.
const char* plain_number(const char* at, const char* end, double& out) {
  const char* const digits = at + (at < end && *at == '-');
  if (digits == end || !is_digit(*digits)) return nullptr;
  // Up to 15 digits are a whole number that a double holds, and so is the power of ten: their quotient is the nearest
  // double, as for any correct reader.
  std::int64_t whole = 0;
  const char *p = digits, *point = nullptr;
  for (; p < end && p - digits < 17; ++p) {
    if (is_digit(*p))
      whole = whole * 10 + (*p - '0');
    else if (*p == '.' && !point)
      point = p;
    else
      break;
  }
  if (p - digits <= 15 && p < end && *p != '.' && *p != 'e' && *p != 'E') {
    const double d = static_cast<double>(whole) / powers_of_ten[static_cast<std::size_t>(point ? p - point - 1 : 0)];
    out = *at == '-' ? -d : d;
    return p;
  }
  const auto read = fast_float::from_chars(at, end, out);
  return read.ec == std::errc{} && std::isfinite(out) ? read.ptr : nullptr;
}

// Reads an angle in degrees, or 0 without a unit.
const char* plain_angle(const char* at, const char* end, double& out) {
  at = plain_number(at, end, out);
  if (!at || !between(at, end).starts_with("deg")) return at && out == 0 ? at : nullptr;
  out *= pi / 180;
  return at + 3;
}

// Reads the value of a row. Returns its end, or nullptr if it is not of the plainest form.
const char* plain_value(const char* at, const char* end, const Selected& on, Value& out) {
  const Type type = on.type();
  const bool rotation = type == Type::rotation, angles = rotation || type == Type::angle;
  const auto read = [&](const char* from, double& d) {
    return angles ? plain_angle(from, end, d) : plain_number(from, end, d);
  };
  const bool any = rotation || (angles && on.component >= 0);  // these have no range
  const auto in_range = [&](double d) { return any || (d >= on.spec->low && d <= on.spec->high); };
  if (type == Type::scalar || type == Type::angle) {
    double d = 0;
    at = read(at, d);
    if (!at || (at < end && !blank(*at) && *at != '\n') || !in_range(d)) return nullptr;
    out = d;
    return at;
  }
  if (rotation && between(at, end).starts_with("euler")) at += 5;
  if (at == end || *at++ != '(') return nullptr;
  Vec3 v;
  const int count = rotation ? 3 : component_count(type);
  for (int i = 0; i < count; ++i) {
    at = read(behind_blanks(at, end), v[i]);
    if (!at || at == end || !(blank(*at) || *at == ')') || !in_range(v[i])) return nullptr;
  }
  at = behind_blanks(at, end);
  if (at == end || *at != ')') return nullptr;
  out = rotation ? Value(Angles{v}) : Value(v);
  return at + 1;
}

// Reads whole frames, as in 12f, and any other time as all rows do.
bool plain_time(Cursor& c, Time& out) {
  std::int64_t n = 0;
  const char* p = c.at;
  while (p < c.end && is_digit(*p) && p - c.at < 9) n = n * 10 + (*p++ - '0');
  if (p == c.at) return false;
  if (p == c.end || *p != 'f' || p + 1 == c.end || p[1] != ' ' || c.rate.per_second() < 1) {
    // A formula may speak of the object's place, so it is not plain.
    const auto of_time = [](char at) {
      return is_digit(at) || std::string_view(".:fsmt").find(at) != std::string_view::npos;
    };
    const char* const behind = std::find_if_not(p, c.end, of_time);
    return behind < c.end && *behind == ' ' && c.time(out) && c.at == behind;
  }
  c.at = p + 1, c.frames_read = true;
  out = c.clock.film_time(c.rate.frame(static_cast<double>(n)));
  return true;
}

// Reads one row, after its indentation. Returns false if it is not plain; the cursor is then anywhere in it.
bool plain_row(Command& k, Event& e) {
  Cursor& c = k.cursor;
  const Selected& on = k.script.sheet.on;
  if (!plain_time(c, e.time)) return false;
  const char* const behind = plain_value(behind_blanks(c.at, c.end), c.end, on, e.value);
  if (!behind) return false;
  c.at = behind;
  if (c.at == c.end || *c.at == '\n') return true;
  // One word, as in linear. Arguments may be formulas.
  const char* const word = behind_blanks(c.at, c.end);
  const char* const rest = std::find_if_not(word, c.end, [](char at) { return is_letter(at) || at == '-'; });
  if (behind_blanks(rest, c.end) != c.end && *behind_blanks(rest, c.end) != '\n') return false;
  return way(k, on, e) && c.at_line_end();
}

}  // namespace

bool plain_rows(Command& k) {
  constexpr int most = 256;
  auto& [s, c, time, layer, script] = k;
  Sheet& sheet = script.sheet;
  if (!takes_plain_numbers(s, sheet)) return false;
  const std::size_t margin = script.margin();
  for (int n = 0; n < most; ++n) {
    const char* const start = c.at;
    c.at = behind_blanks(start, c.end);
    Event e;
    const bool plain = static_cast<std::size_t>(c.at - start) > margin && c.at < c.end && plain_row(k, e);
    const Events& there = sheet.tracks[0]->events;
    // A row that replaces another one of this sheet gets a warning, from the reader.
    if (!plain || (sheet.fresh && !there.empty() && e.time <= there.back().time)) {
      c.at = start, c.depth = 0;
      c.error.reset(), c.where = {};
      return n > 0;
    }
    sheet.above = e.time;
    c.reaches(e.time);
    for (std::size_t i = 1; i < sheet.tracks.size(); ++i) sheet.tracks[i]->events.put(e);
    sheet.tracks[0]->events.put(std::move(e));
    if (c.at < c.end) ++c.at;
  }
  return true;
}

}  // namespace betwixt
