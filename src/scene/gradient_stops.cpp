// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/gradient_stops.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "base/names.h"
#include "scene/colors.h"
#include "track/track.h"

namespace betwixt {
namespace {

constexpr const char* stops_look_like = "stops look like \"#f60, gold 40%, first/50%, transparent\"";
constexpr double no_place = -1;

std::string_view trimmed(std::string_view s) {
  const std::size_t first = s.find_first_not_of(' ');
  return first == std::string_view::npos ? s.substr(0, 0) : s.substr(first, s.find_last_not_of(' ') - first + 1);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

// Reads a number from 0 to 1: 40%, or 0.4. Digits only, so that it is the same in every language of the machine.
std::optional<double> share_in(std::string_view s) {
  const bool percent = s.ends_with('%');
  if (percent) s.remove_suffix(1);
  double value = 0, unit = 1;
  bool point = false, any = false;
  for (const char c : s) {
    if (c == '.' && !point) {
      point = true;
    } else if (c >= '0' && c <= '9' && s.size() < 30) {
      any = true, value = 10 * value + (c - '0');
      if (point) unit *= 10;
    } else {
      return std::nullopt;
    }
  }
  if (!any) return std::nullopt;
  value /= percent ? 100 * unit : unit;
  return value <= 1 ? std::optional(value) : std::nullopt;
}

Status read_hex(std::string_view digits, WrittenStop& to) {
  std::uint32_t v = 0;
  bool good = digits.size() == 3 || digits.size() == 4 || digits.size() == 6 || digits.size() == 8;
  for (const char c : digits) {
    good = good && hex_digit(c) >= 0;
    if (good) v = v * 16 + static_cast<std::uint32_t>(hex_digit(c));
  }
  if (!good)
    return fail(ErrorCode::syntax, "a hexadecimal colour of a stop must have 3, 4, 6 or 8 digits", stops_look_like);
  if (digits.size() < 6) {  // each digit twice
    std::uint32_t wide = 0;
    for (std::size_t i = 0; i < digits.size(); ++i) wide |= (v >> (4 * i) & 15) * 0x11U << (8 * i);
    v = wide;
  }
  const bool opacity = digits.size() % 4 == 0;
  to.color = from_bytes(opacity ? v >> 8 : v), to.opacity = opacity ? (v & 255) / 255.0 : 1;
  return Nothing{};
}

Status read_color(std::string_view word, WrittenStop& to) {
  if (const std::size_t slash = word.find('/'); slash != std::string_view::npos) {
    const auto opacity = share_in(word.substr(slash + 1));
    if (!opacity)
      return fail(ErrorCode::range, "the opacity of a stop must be from 0 to 1, or 0% to 100%", stops_look_like);
    if (Status s = read_color(word.substr(0, slash), to); !s) return s;
    return to.opacity *= *opacity, Nothing{};
  }
  if (word.starts_with('#')) return read_hex(word.substr(1), to);
  if (word == "first") return to.of = WrittenStop::Of::first, Nothing{};
  if (word == "second") return to.of = WrittenStop::Of::second, Nothing{};
  if (word == "transparent") return to.opacity = 0, to.color = {0, 0, 0}, Nothing{};
  if (const auto named = named_color(word)) return to.color = from_bytes(*named), Nothing{};
  std::vector<std::string_view> words = color_names();
  words.insert(words.end(), {"first", "second", "transparent"});
  const Hint near = did_you_mean(word, words);
  return unknown_name("colour", word, near.empty() ? Hint(stops_look_like) : near);
}

Status read_stop(std::string_view text, WrittenStop& to) {
  const std::size_t blank = text.find(' ');
  to.at = no_place;
  if (text.empty()) return fail(ErrorCode::syntax, "a colour is missing between the commas", stops_look_like);
  if (Status s = read_color(text.substr(0, blank), to); !s) return s;
  if (blank == std::string_view::npos) return Nothing{};
  const auto place = share_in(trimmed(text.substr(blank)));
  if (!place) return fail(ErrorCode::range, "the place of a stop must be from 0% to 100%", stops_look_like);
  return to.at = *place, Nothing{};
}

// Puts those without a place evenly between their neighbours.
void place_all(std::vector<WrittenStop>& stops) {
  if (stops.front().at == no_place) stops.front().at = 0;
  if (stops.back().at == no_place) stops.back().at = 1;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (stops[i].at != no_place) continue;
    std::size_t next = i;
    while (stops[next].at == no_place) ++next;
    const double from = stops[i - 1].at, step = (stops[next].at - from) / static_cast<double>(next - i + 1);
    for (std::size_t k = i; k < next; ++k) stops[k].at = from + step * static_cast<double>(k - i + 1);
  }
}

}  // namespace

Result<std::vector<WrittenStop>> read_stops(std::string_view text, std::string_view* wrong) {
  std::string_view part;
  std::string_view& about = wrong ? *wrong : part;
  std::vector<WrittenStop> stops;
  double last = 0;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    about = trimmed(text.substr(from, end - from));
    if (stops.size() == most_stops)
      return fail(ErrorCode::range, fmt::format("a gradient can have at most {} stops", most_stops));
    stops.emplace_back();
    if (Status s = read_stop(about, stops.back()); !s) return s.error();
    if (const double at = stops.back().at; at != no_place) {
      if (at < last) return fail(ErrorCode::range, "the places of stops must not go back");
      last = at;
    }
    from = end + 1;
  }
  about = text;
  if (stops.size() < 2) return fail(ErrorCode::range, "a gradient needs two stops or more", stops_look_like);
  place_all(stops);
  return stops;
}

std::vector<Gradient::Stop> stops_of(std::string_view written, Vec3 first, Vec3 second) {
  const std::vector<Gradient::Stop> two{{0, first, 1}, {1, second, 1}};
  if (written.empty()) return two;
  const auto read = read_stops(written);
  if (!read) return two;
  std::vector<Gradient::Stop> out;
  for (const WrittenStop& s : *read) {
    const bool own = s.of == WrittenStop::Of::color;
    out.push_back({s.at, own ? to_linear(s.color) : s.of == WrittenStop::Of::first ? first : second, s.opacity});
  }
  return out;
}

}  // namespace betwixt
