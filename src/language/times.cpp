// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads times and lengths of time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/names.h"
#include "betwixt/math.h"
#include "language/cursor.h"
#include "language/formula.h"
#include "language/moments.h"
#include "scene/document.h"

namespace betwixt {

namespace {

// Returns the hint for voice.ed and proof.strat, or none.
Hint near_edge(std::string_view word) {
  const std::size_t dot = word.rfind('.');
  if (dot == std::string_view::npos || dot == 0 || !is_letter(word[0])) return {};
  const Hint edge = did_you_mean(word.substr(dot + 1), {"start", "end"});
  if (edge.instead.empty()) return {};
  const std::string instead = std::string(word.substr(0, dot + 1)) + edge.instead;
  return {fmt::format("did you mean '{}'?", instead), instead};
}

}  // namespace

bool Cursor::store(Time& out, long double seconds, const char* start) {
  if (!(std::abs(seconds) <= static_cast<long double>(longest_seconds)))
    return fail(ErrorCode::range, "a time must be within 146 years (4.6e9 s)", since(start));
  out = {static_cast<std::int64_t>(std::llroundl(seconds * flicks_per_second))};
  return true;
}

// Reads hours:minutes:seconds or minutes:seconds.
bool Cursor::clock_time(Time& out, const char* start, bool negative) {
  long double seconds = 0;
  for (int part = 0;; ++part) {
    double d = 0;
    if (!literal(d)) return false;
    seconds = seconds * 60 + static_cast<long double>(d);
    if (peek() != ':') break;
    if (part == 2 || d != std::floor(d))
      return fail(ErrorCode::syntax, "a clock time must be hours:minutes:seconds", since(start));
    ++at;
  }
  return store(out, negative ? -seconds : seconds, start);
}

// As a point in time, frames count from frame 1.
bool Cursor::from_formula(const Quantity& q, bool length, Time& out, const char* start) {
  if (q.of != Quantity::Of::time)
    return fail(ErrorCode::type,
                fmt::format("expected a {} here, not {}", length ? "length of time" : "time", to_string(q.of)),
                since(start), q.of == Quantity::Of::number ? "write …*1f for frames, …*1s for seconds" : "");
  if (std::abs(q.frames) > longest_seconds * rate.per_second()) return store(out, 1e18L, start);
  Time seconds;
  if (!store(seconds, static_cast<long double>(q.value), start)) return false;
  const Time frames = q.counts_frames && !length ? rate.frame(q.frames) : rate.span(q.frames);
  out = frames + seconds;
  return std::abs(out.seconds()) <= longest_seconds || store(out, 1e18L, start);
}

bool section_time_begins(const char* at, const char* end) {
  const auto named = [](char c) { return is_letter(c) || is_digit(c) || c == '-' || c == '_' || c == '/'; };
  if (at == end || !is_letter(*at)) return false;
  const char* const dot = std::find_if_not(at, end, named);
  const char* const behind = std::find_if_not(dot < end ? dot + 1 : end, end, is_letter);
  if (dot == end || *dot != '.') return false;
  const std::string_view edge = between(dot + 1, behind);
  return (edge == "start" || edge == "end") && (behind == end || !(named(*behind) && *behind != '-'));
}

// Reads NAME.start or NAME.end, and a length behind it: intro.end+12f. This is a time of the film, in any block.
bool Cursor::section_time(Time& out) {
  const char* const start = at;
  at = std::find(at, end, '.');
  const std::string_view name = since(start);
  const std::string_view edge = (++at, unit());
  const std::string_view about = since(start);
  const Result<Time> there = sections
                                 ? (*sections)(name, edge == "end")
                                 : betwixt::fail(ErrorCode::name, fmt::format("there is no section '{}' here", name));
  if (!there) return fail(there.error(), about);
  out = *there;
  Time later;
  if ((peek() == '+' || peek() == '-') && !length(later)) return false;
  out = out + later;
  return in_reach(out) || store(out, 1e18L, start);
}

bool Cursor::time(Time& out) {
  space();
  const bool name = at < end && is_letter(*at);
  const auto of_object = [&] { return moments && moments->names.find(between(at, std::find(at, end, '.'))); };
  if (name && section_time_begins(at, end) && !of_object()) {
    if (!section_time(out)) return false;
  } else if (name && moment_begins(*this, at)) {  // a time of the film, in any block
    if (!time_or_length(out, false)) return false;
  } else {
    if (!time_or_length(out, false)) return false;
    out = clock.film_time(out);
  }
  last = out;
  return reaches(out), true;
}

bool Cursor::length(Time& out) {
  if (!time_or_length(out, true)) return false;
  out = clock.film_length(out);
  return true;
}

bool Cursor::lasting(Time& out) {
  if (!length(out)) return false;
  return reaches(last.value_or(clock.begin) + out), true;
}

bool Cursor::opening(double& seconds) {
  if (accept_word("off") || accept_word("0")) return seconds = 0, true;
  const std::string_view w = peek_word();
  if (w.ends_with("deg") || w.ends_with("rad") || w.ends_with("turn")) {
    if (!angle(seconds)) return false;
    return seconds *= rate.span(1).seconds() / (2 * pi), true;
  }
  Time t;
  if (!own_length(t)) {
    if (error && !w.empty() && std::isdigit(static_cast<unsigned char>(w.back())))
      error->hint = fmt::format("write {}deg (360deg is a frame), {}f or {}ms", w, w, w);
    return false;
  }
  return seconds = t.seconds(), true;
}

bool Cursor::time_or_length(Time& out, bool length) {
  space();
  const char* start = at;
  const char* p = at;
  if (p < end && (*p == '-' || *p == '+')) ++p;
  const char* digits = p;
  std::int64_t whole = 0;
  while (p < end && is_digit(*p) && p - digits < 9) whole = whole * 10 + (*p++ - '0');
  if (p > digits && p < end && *p == ':') {
    const bool negative = *start == '-';
    at = digits;
    return clock_time(out, start, negative);
  }
  // The fast path for whole frames, the most common case. Does not use a double.
  const auto over = [&](const char* q) { return q == end || ends_word(*q) || *q == '.' || *q == '#'; };
  if (p > digits && p < end && *p == 'f' && over(p + 1)) {
    at = p + 1;
    frames_read = true;
    const double n = static_cast<double>(*start == '-' ? -whole : whole);
    if (std::abs(n) > longest_seconds * rate.per_second()) return store(out, 1e18L, start);
    out = length ? rate.span(n) : rate.frame(n);
    return true;
  }
  double n = 0;
  std::optional<Quantity> q;
  if (!number(n, q)) {
    if (q) return false;
    if (error->code == ErrorCode::syntax)
      error->message = at_line_end()
                           ? "a time is missing here"
                           : fmt::format("{} is not a time",
                                         quoted_word(peek_word().empty() ? std::string_view(at, 1) : peek_word()));
    if (error->hint.empty() && error->code == ErrorCode::syntax) set_hint(*error, near_edge(peek_word()));
    if (error->hint.empty() && error->code == ErrorCode::syntax)
      error->hint = "times look like 24f, 2.5s, 500ms, 90t or 00:01:02.5";
    return false;
  }
  if (q) return from_formula(*q, length, out, start);
  const std::string_view u = unit();
  if (!over(at))
    return fail(ErrorCode::syntax,
                fmt::format("{} is not a time", quoted_word(std::string_view(
                                                    start, static_cast<std::size_t>(at - start) + peek_word().size()))),
                since(start));
  const auto in_rate = [&](Rate r, double units) {
    if (std::abs(units) > longest_seconds * r.per_second()) return store(out, 1e18L, start);
    out = r.span(units);
    return true;
  };
  if (u == "f") {
    frames_read = true;
    return in_rate(rate, length ? n : n - 1);
  }
  if (u == "s") return store(out, static_cast<long double>(n), start);
  if (u == "ms") return store(out, static_cast<long double>(n) / 1000, start);
  if (u == "t") {
    ticks_read = true;
    return in_rate(ticks, n);
  }
  if (u.empty())
    return fail(
        ErrorCode::type, fmt::format("a {} needs a unit", length ? "length of time" : "time"), since(start),
        fmt::format("write {0}f for {1}, or {0}s for seconds", since(start), length ? "frames" : "a frame number"));
  return fail(ErrorCode::type, fmt::format("'{}' is not a unit of time", u), u,
              "units are f (frames), s, ms and t (ticks)");
}

bool Cursor::segment(Time& from, Time& to) {
  space();
  const char* start = at;
  if (!time(from)) return false;
  if (end - at < 2 || at[0] != '.' || at[1] != '.')
    return fail(ErrorCode::syntax, "a segment needs its end", since(start),
                fmt::format("write {}..END, as in 1f..24f", since(start)));
  at += 2;
  if (!time(to)) return false;
  if (to < from) return fail(ErrorCode::range, "this segment ends before it begins", since(start));
  return true;
}

}  // namespace betwixt
