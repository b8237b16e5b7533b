// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands about the whole document.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "base/names.h"
#include "language/reader.h"

namespace betwixt {

bool Reader::rate_of(Cursor& c, Rate& rate, bool used, const char* what) {
  c.space();
  const char* start = c.at;
  double num = 0, den = 1;
  if (!c.number(num)) return false;
  if (c.peek() == '/') {
    ++c.at;
    if (!c.number(den)) return false;
  }
  const std::string_view about(start, static_cast<std::size_t>(c.at - start));
  // 23.976 means 23976/1000: whole numbers stay whole.
  while ((num != std::floor(num) || den != std::floor(den)) && den < 1e6) num *= 10, den *= 10;
  if (!(num >= 1 && den >= 1 && num <= 1e9 && den <= 1e7 && num / den <= 1e5 && num / den >= 1e-4) ||
      num != std::floor(num) || den != std::floor(den))
    return c.fail(Code::range, fmt::format("{} per second are from 0.0001 to 100000", what), about);
  auto n = static_cast<std::int64_t>(num), d = static_cast<std::int64_t>(den);
  const auto common = std::gcd(n, d);
  const Rate fresh{n / common, d / common};
  const bool smooth = &rate == &s.ticks && c.accept_word("smooth");
  if (!finish(c)) return false;
  if (&rate == &s.ticks) s.smooth_ticks = smooth;
  if (used && !(fresh == rate))
    note(Severity::warning,
         fmt::format("times in {} above this line were read at {} per second and stay where they are", what,
                     rate.den == 1 ? std::to_string(rate.num) : fmt::format("{}/{}", rate.num, rate.den)),
         about, "say the rate first");
  rate = fresh;
  return true;
}

bool Reader::range(Cursor& c) {
  Time from, to;
  c.space();
  const char* start = c.at;
  if (!c.time(from)) return false;
  if (c.peek() == '.' && c.end - c.at > 1 && c.at[1] == '.') c.at += 2;  // range 1f..72f is a segment too
  if (!c.time(to)) return false;
  if (to < from) return c.fail(Code::range, "the range ends before it begins", c.since(start));
  if (!finish(c)) return false;
  s.range = {from, to};
  return true;
}

bool Reader::background(Cursor& c) {
  if (c.accept_word("none")) {
    if (!finish(c)) return false;
    s.background.reset();
    return true;
  }
  Color color;
  if (!values(c).color(color) || !finish(c)) return false;
  s.background = color;
  return true;
}

bool Reader::policy(Cursor& c) {
  c.space();
  const std::string_view w = c.word();
  const auto at = std::find(policy_names.begin(), policy_names.end(), w);
  if (at == policy_names.end())
    return c.fail(Code::syntax, "the policy is translate, ignore or ask", w.empty() ? std::string_view(c.at, 0) : w,
                  did_you_mean(w, {policy_names.begin(), policy_names.end()}));
  if (!finish(c)) return false;
  s.policy = static_cast<Policy>(at - policy_names.begin());
  return true;
}

}  // namespace betwixt
