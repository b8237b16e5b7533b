// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Angles as text, exact to the last digit for any number of turns.
#include <algorithm>
#include <charconv>

#include "algebra/text.h"

namespace betwixt::algebra {
namespace {

constexpr Unit turn_unit{"turn", 2 * std::numbers::pi, 1}, degree{"deg", std::numbers::pi, 180};

// Returns how many of the unit are a turn, or 0 for radians, of which no whole number is.
std::int64_t per_turn(const Unit& u) { return u.of == 1 ? 0 : std::llround(2 * std::numbers::pi * u.divisor / u.of); }

// The digits of a number before the point and after it.
struct Decimal {
  bool negative = false;
  std::string before, behind;
};
Decimal decimal(std::string_view number) {
  Decimal d;
  d.negative = number.starts_with('-');
  if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
  long long exponent = 0;
  if (const std::size_t e = number.find_first_of("eE"); e != std::string_view::npos) {
    const std::size_t from = e + 1 + (number.substr(e + 1).starts_with('+') ? 1 : 0);
    std::from_chars(number.data() + from, number.data() + number.size(), exponent);
    number = number.substr(0, e);
  }
  const std::size_t point = std::min(number.find('.'), number.size());
  d.before = number.substr(0, point);
  if (point < number.size()) d.behind = number.substr(point + 1);
  // Numbers with more digits are too large for an angle, or too small to matter.
  constexpr long long most = 400;
  exponent = std::clamp(exponent, -most, most);
  for (; exponent > 0; --exponent) {
    d.before += d.behind.empty() ? '0' : d.behind.front();
    if (!d.behind.empty()) d.behind.erase(0, 1);
  }
  for (; exponent < 0; ++exponent) {
    d.behind.insert(d.behind.begin(), d.before.empty() ? '0' : d.before.back());
    if (!d.before.empty()) d.before.pop_back();
  }
  return d;
}

// Returns the turns of a number in a unit of which `per` are a turn.
std::optional<Turns> turns_in_text(std::string_view number, std::int64_t per) {
  const Decimal d = decimal(number);
  const Wide of = static_cast<Wide>(per), most = static_cast<Wide>(most_turns) * of;
  Wide units = 0;
  for (const char c : d.before)
    if ((units = units * 10 + static_cast<Wide>(c - '0')) >= most) return std::nullopt;
  constexpr int bits = 100;
  Wide part = 0;
  for (std::size_t i = std::min<std::size_t>(d.behind.size(), 40); i-- > 0;)
    part = (part + (static_cast<Wide>(d.behind[i] - '0') << bits)) / 10;
  // In 2^-100 of a turn.
  part = (((units % of) << bits) + part) / of;
  const Wide rounded = (part + (Wide{1} << (bits - 65))) >> (bits - 64);
  const Turns turns = Turns{static_cast<std::int64_t>(units / of), 0} +
                      Turns{static_cast<std::int64_t>(rounded >> 64), static_cast<std::uint64_t>(rounded)};
  return d.negative ? -turns : turns;
}

// Returns the number of units in the turns, with this many digits after the point.
std::string decimal_text(Turns turns, std::int64_t per, int digits) {
  const bool negative = turns < Turns{};
  if (negative) turns = -turns;
  const Wide part = static_cast<Wide>(turns.part) * static_cast<Wide>(per);
  std::string text = std::to_string(turns.whole * per + static_cast<std::int64_t>(part >> 64));
  auto left = static_cast<std::uint64_t>(part);
  for (int i = 0; i < digits; ++i) {
    const Wide next = static_cast<Wide>(left) * 10;
    text += static_cast<char>('0' + static_cast<int>(next >> 64));
    left = static_cast<std::uint64_t>(next);
  }
  if (left >> 63 != 0) {  // up
    std::size_t i = text.size();
    while (i > 0 && text[i - 1] == '9') text[--i] = '0';
    if (i > 0) ++text[i - 1];
    if (i == 0) text.insert(text.begin(), '1');
  }
  if (digits > 0) text.insert(text.size() - static_cast<std::size_t>(digits), ".");
  return (negative ? "-" : "") + text;
}

// Returns the shortest text for a number of radians.
std::string rounded_text(double radians) {
  std::string best = written(radians) + "rad";
  for (const Unit& u : {turn_unit, degree}) {
    const double count = radians * u.divisor / u.of;
    // Try the neighbour too: a number written as 90 may come back one bit off.
    for (const double n : {count, std::round(count * 1e9) / 1e9}) {
      std::string text = written(n) + std::string(u.name);
      if (n * u.of / u.divisor == radians && read_angle(written(n), n, u) == Angle{radians} &&
          text.size() <= best.size())
        best = std::move(text);
    }
  }
  return best;
}

}  // namespace

Angle angle_of(Turns turns) {
  const auto radians_in = [](Turns t) {
    return (static_cast<long double>(t.whole) + std::ldexp(static_cast<long double>(t.part), -64)) * 2 *
           std::numbers::pi_v<long double>;
  };
  Angle a{static_cast<double>(radians_in(turns))};
  const Turns off = turns - exact_turns(a.radians);
  a.rest = static_cast<double>(off < Turns{} ? -radians_in(-off) : radians_in(off));
  if (a.rest == 0 && turns_of(a.radians) != turns) a.rest = 0x1p-500;  // marks it as exact
  return a;
}

std::optional<Angle> read_angle(std::string_view number, double value, const Unit& unit) {
  const Angle plain{value * unit.of / unit.divisor};
  if (!(std::abs(plain.radians) < 2 * std::numbers::pi * most_turns)) return std::nullopt;
  // Up to one turn, radians are exact enough.
  if (unit.of == 1 || std::abs(plain.radians) <= 2 * std::numbers::pi) return plain;
  const auto turns = turns_in_text(number, per_turn(unit));
  if (!turns || *turns == turns_of(plain.radians)) return turns ? std::optional(plain) : std::nullopt;
  return angle_of(*turns);
}

std::string angle_text(Angle a) {
  if (a.rest == 0) return rounded_text(a.radians);
  const Turns turns = turns_of(a.radians, a.rest);
  std::string best;
  for (const Unit& u : {turn_unit, degree})
    for (int digits = 0; digits <= 20; ++digits) {
      const std::string number = decimal_text(turns, per_turn(u), digits);
      const auto read = turns_in_text(number, per_turn(u));
      if (digits < 20 && !(read && angle_of(*read) == a)) continue;
      if (best.empty() || number.size() + u.name.size() < best.size()) best = number + std::string(u.name);
      break;
    }
  return best;
}

}  // namespace betwixt::algebra
