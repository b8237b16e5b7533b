// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The input and output of betwixt algebra, for all methods.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "app/algebra.h"
#include "app/command.h"
#include "base/utf8.h"
#include "language/json.h"
#include "language/values.h"

namespace betwixt::algebra_command {
namespace {

std::vector<std::string_view> parts(std::string_view text, std::string_view between) {
  std::vector<std::string_view> all;
  for (std::size_t from = text.find_first_not_of(between); from != std::string_view::npos;) {
    const std::size_t to = std::min(text.find_first_of(between, from), text.size());
    all.push_back(text.substr(from, to - from));
    from = text.find_first_not_of(between, to);
  }
  return all;
}

std::string point_text(const Point& p, const char* between) {
  if (std::isnan(p.at.x)) return "behind the eye";
  std::string out = write_number(p.at.x) + between + write_number(p.at.y);
  return p.numbers == 3 ? out + between + write_number(p.at.z) : out;
}

std::string frame_json(double k, const Shown& shown) {
  std::string out = fmt::format("{{\"k\":{},\"points\":[", json_number(k));
  for (std::size_t i = 0; i < shown.points.size(); ++i) {
    if (std::isnan(shown.points[i].at.x)) {
      out += i ? ",null" : "null";
      continue;
    }
    out += i ? ",[" : "[";
    for (int c = 0; c < shown.points[i].numbers; ++c) out += (c ? "," : "") + json_number(shown.points[i].at[c]);
    out += "]";
  }
  out += "]";
  if (!shown.matrix) return out + "}";
  for (std::size_t i = 0; i < 16; ++i) out += (i ? "," : ",\"matrix\":[") + json_number(shown.matrix->m[i]);
  return out + "]}";
}

}  // namespace

Result<double> read_number(std::string_view text, std::string_view what) {
  double x = 0;
  const auto [end, bad] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (bad != std::errc() || end != text.data() + text.size() || !std::isfinite(x))
    return fail(ErrorCode::syntax, fmt::format("{}: '{}' is not a number", what, text.substr(0, 60)));
  return x;
}

Result<std::vector<Point>> read_points(const std::string& text) {
  std::vector<Point> points;
  for (const std::string_view word : parts(text, " ;")) {
    const auto numbers = parts(word, ",");
    const bool gaps = word.find(",,") != std::string_view::npos || word.front() == ',' || word.back() == ',';
    if (gaps || (numbers.size() != 2 && numbers.size() != 3))
      return fail(ErrorCode::syntax, fmt::format("--points: '{}' is not a point", word.substr(0, 60)),
                  "as in --points \"1,0 -0.5,2\"");
    Point p{{}, static_cast<int>(numbers.size())};
    for (int c = 0; c < p.numbers; ++c) {
      const auto x = read_number(numbers[static_cast<std::size_t>(c)], "--points");
      if (!x) return x.error();
      p.at[c] = *x;
    }
    points.push_back(p);
  }
  if (points.empty()) return fail(ErrorCode::syntax, "--points: a point is missing", "as in --points \"1,0 -0.5,2\"");
  return points;
}

// Prints an error of the motion below its text.
int complain_about(const std::string& text, const Error& e, const char* name) {
  constexpr int width = 100;  // of a long text only the part around the error is shown
  const int from = std::max(0, e.place.column - 1 - width / 2);
  const std::string_view rest =
      std::string_view(text).substr(first_characters(text, static_cast<std::size_t>(from)).size());
  Diagnostic d{Severity::error, e, std::string(first_characters(rest, width)), e.place.column - 1 - from};
  d.what.place.file = name;
  tell_user(d);
  return wrong_input;
}

int show_frames(const Call& call, const Asked& asked, const std::string& head, const std::string& tail,
                const std::function<Status(double k, Shown&)>& show) {
  const std::size_t count = asked.frames.empty() ? static_cast<std::size_t>(call.steps) + 1 : asked.frames.size();
  Shown shown{asked.points, std::nullopt};
  // Collect the whole object first: after an error, no half of it may be printed.
  std::string object = fmt::format("{{\"steps\":{},{}\"frames\":[", call.steps, head);
  for (std::size_t i = 0; i < count; ++i) {
    const double k = asked.frames.empty() ? static_cast<double>(i) : asked.frames[i];
    if (const Status s = show(k, shown); !s) return complain(s.error(), wrong_input);
    if (call.json) {
      object += (i ? "," : "") + frame_json(k, shown);
      continue;
    }
    fmt::print("{:<6}", write_number(k));
    for (const Point& p : shown.points) fmt::print("  {}", point_text(p, " "));
    fmt::print("\n");
  }
  if (call.json) fmt::print("{}]{}}}\n", object, tail);
  return all_done;
}

}  // namespace betwixt::algebra_command
