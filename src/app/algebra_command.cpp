// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt algebra: the frames of a string of translations, rotations and scalings, and what they cost.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "app/command.h"
#include "app/lesson.h"
#include "app/subcommand.h"
#include "base/utf8.h"
#include "betwixt/algebra.h"
#include "language/json.h"
#include "language/values.h"

namespace betwixt {
namespace {

struct AlgebraCall {
  std::string motion, method, origin, steps_text;
  std::optional<std::string> points, lesson;
  std::vector<std::string> at;
  std::int64_t steps = 24;
  bool count = false, json = false, inverse = false, css = false, to_css = false;
};

constexpr Method methods[] = {Method::matrix, Method::geometric, Method::differences, Method::best};
constexpr std::int64_t most_stepped = 1'000'000;  // what is farther is sought

struct Point {
  Vec3 at;
  int numbers = 2;
};

struct AskedFrames {
  Motion motion;
  std::vector<Point> points;
  std::vector<double> frames;  // empty: all
  std::optional<Method> method;
};

Result<double> number(std::string_view text, std::string_view what) {
  double x = 0;
  const auto [end, bad] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (bad != std::errc() || end != text.data() + text.size() || !std::isfinite(x))
    return fail(ErrorCode::syntax, fmt::format("{}: '{}' is no number", what, text.substr(0, 60)));
  return x;
}

std::vector<std::string_view> parts(std::string_view text, std::string_view between) {
  std::vector<std::string_view> all;
  for (std::size_t from = text.find_first_not_of(between); from != std::string_view::npos;) {
    const std::size_t to = std::min(text.find_first_of(between, from), text.size());
    all.push_back(text.substr(from, to - from));
    from = text.find_first_not_of(between, to);
  }
  return all;
}

Result<std::vector<Point>> read_points(const std::string& text) {
  std::vector<Point> points;
  for (const std::string_view word : parts(text, " ;")) {
    const auto numbers = parts(word, ",");
    const bool gaps = word.find(",,") != std::string_view::npos || word.front() == ',' || word.back() == ',';
    if (gaps || (numbers.size() != 2 && numbers.size() != 3))
      return fail(ErrorCode::syntax, fmt::format("--points: '{}' is no point", word.substr(0, 60)),
                  "as in --points \"1,0 -0.5,2\"");
    Point p{{}, static_cast<int>(numbers.size())};
    for (int c = 0; c < p.numbers; ++c) {
      const auto x = number(numbers[static_cast<std::size_t>(c)], "--points");
      if (!x) return x.error();
      p.at[c] = *x;
    }
    points.push_back(p);
  }
  if (points.empty()) return fail(ErrorCode::syntax, "--points: there is no point", "as in --points \"1,0 -0.5,2\"");
  return points;
}

// What is wrong with the motion, under its text.
int complain_about(const std::string& text, const Error& e) {
  constexpr int width = 100;  // of a long text what is around the place
  const int from = std::max(0, e.place.column - 1 - width / 2);
  const std::string_view rest =
      std::string_view(text).substr(first_characters(text, static_cast<std::size_t>(from)).size());
  Diagnostic d{Severity::error, e, std::string(first_characters(rest, width)), e.place.column - 1 - from};
  d.what.place.file = "motion";
  fmt::print(stderr, "{}", to_string(d));
  return wrong_input;
}

std::string point_text(const Point& p, const char* between) {
  std::string out = write_number(p.at.x) + between + write_number(p.at.y);
  return p.numbers == 3 ? out + between + write_number(p.at.z) : out;
}

// The frames one after the other, each with its points moved.
template <class Show>
Status go(const AlgebraCall& call, const AskedFrames& asked, const Show& show) {
  const std::size_t count = asked.frames.empty() ? static_cast<std::size_t>(call.steps) + 1 : asked.frames.size();
  const auto k_of = [&](std::size_t i) { return asked.frames.empty() ? static_cast<double>(i) : asked.frames[i]; };
  std::vector<Point> moved = asked.points;
  if (!asked.method) {
    for (std::size_t i = 0; i < count; ++i) {
      const double k = k_of(i);
      const Mat4 m = k == std::floor(k) && std::abs(k) < 9e15
                         ? *frame(asked.motion, static_cast<std::int64_t>(k), call.steps)
                         : at(asked.motion, k / static_cast<double>(call.steps));
      for (std::size_t p = 0; p < moved.size(); ++p) moved[p].at = transform_point(m, asked.points[p].at);
      show(k, moved);
    }
    return Nothing{};
  }
  std::vector<double> x, y;
  for (const Point& p : asked.points) x.push_back(p.at.x), y.push_back(p.at.y);
  auto steps = Steps<double>::make(asked.motion, call.steps, *asked.method, x, y);
  if (!steps) return steps.error();
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<std::int64_t>(k_of(i));
    if (k < steps->frame() || k - steps->frame() > most_stepped) steps->seek(k);
    while (steps->frame() < k) steps->step();
    for (std::size_t p = 0; p < moved.size(); ++p) moved[p].at.x = steps->x()[p], moved[p].at.y = steps->y()[p];
    show(k_of(i), moved);
  }
  return Nothing{};
}

// Where a scheme of the source meets the motion at its end only, it says so.
bool end_only(const Motion& motion) {
  const auto row = printed_costs(motion);
  return row && (row->row == "ST" || row->row == "SR");
}

// ---- Counts

std::string json(const Cost& c) {
  return fmt::format("{{\"per_point\":{},\"besides\":{},\"functions\":{}}}", c.per_point, c.besides, c.functions);
}

// The source's geometric method scales by the linear law: of that its count is.
Motion counted(const Motion& motion, Method m) {
  Motion as = motion;
  if (m == Method::geometric)
    for (Factor& f : as.factors) f.law = Factor::Law::linear;
  return as;
}

std::string count_json(const AlgebraCall& call, const AskedFrames& asked) {
  std::string out = "{";
  if (const auto paper = printed_costs(asked.motion))
    out += fmt::format("\"row\":{},\"paper\":{{\"matrix\":{},\"geometric\":{}}},", json_text(paper->row),
                       json(paper->matrix), json(paper->geometric));
  out += "\"methods\":{";
  for (const Method m : methods) {
    const auto c = count_operations(counted(asked.motion, m), call.steps, m, asked.points.size());
    out += fmt::format("{}{}:", m == Method::matrix ? "" : ",", json_text(name_of(m)));
    const bool end = m == Method::geometric && end_only(asked.motion);
    out +=
        c ? fmt::format("{{\"kernel\":{},\"ours\":{},\"measured\":{},\"before\":{}{}}}", json_text(c->kernel),
                        json(c->planned), json(c->step), json(c->before), end ? ",\"right_at\":\"the end only\"" : "")
          : fmt::format("{{\"error\":{}}}", json_text(c.error().message));
  }
  return out + "}}";
}

void print_counts(const AlgebraCall& call, const AskedFrames& asked) {
  const auto paper = printed_costs(asked.motion);
  fmt::print("Operations per step for Np points{}\n\n", paper ? ", row " + paper->row + " of the source's table" : "");
  fmt::print("  {:<12} {:<16} {:<12} {:<12} {:<18} {}\n", "", "paper", "ours", "measured", "before the first",
             "kernel");
  std::string notes;
  for (const Method m : methods) {
    const auto c = count_operations(counted(asked.motion, m), call.steps, m, asked.points.size());
    std::string printed = "-";
    if (paper && m == Method::matrix) printed = to_string(paper->matrix);
    if (paper && m == Method::geometric) printed = to_string(paper->geometric);
    if (c) {
      fmt::print("  {:<12} {:<16} {:<12} {:<12} {:<18} {}\n", name_of(m), printed, to_string(c->planned),
                 to_string(c->step), to_string(c->before), c->kernel);
    } else {
      fmt::print("  {:<12} {:<16} -\n", name_of(m), printed);
      notes += fmt::format("  {}: {}\n", name_of(m), c.error().message);
    }
  }
  if (counted(asked.motion, Method::geometric) != asked.motion)
    notes += "  geometric: with the scalings by the linear law\n";
  if (end_only(asked.motion)) notes += "  geometric: right at the end only\n";
  fmt::print("{}{}", notes.empty() ? "" : "\n", notes);
}

// ---- The call

Result<AskedFrames> read(const AlgebraCall& call) {
  AskedFrames asked;
  auto points = read_points(call.points.value_or("1,0"));
  if (!points) return points.error();
  asked.points = *std::move(points);
  if (call.steps < 1) return frame({}, 0, call.steps).error();
  for (const Method m : methods)
    if (call.method == name_of(m)) asked.method = m;
  for (const std::string& text : call.at) {
    const auto k = number(text, "--at");
    if (!k) return k.error();
    if (asked.method && (*k != std::floor(*k) || std::abs(*k) > 9e15))
      return fail(ErrorCode::range, fmt::format("--at: a method goes from step to step, and {} is none", text));
    asked.frames.push_back(*k);
  }
  return asked;
}

Status read_steps(AlgebraCall& call) {
  if (call.steps_text.empty()) return Nothing{};
  const char* end = call.steps_text.data() + call.steps_text.size();
  const auto [at, bad] = std::from_chars(call.steps_text.data(), end, call.steps);
  if (bad == std::errc() && at == end) return Nothing{};
  return fail(ErrorCode::syntax,
              fmt::format("--steps: '{}' is no whole number of steps", call.steps_text.substr(0, 60)));
}

// What the motion is, in `asked`; the exit code where it is none.
int read_motion(const AlgebraCall& call, AskedFrames& asked) {
  Vec3 origin;
  if (!call.origin.empty()) {
    const auto place = read_points(call.origin);
    if (!place || place->size() != 1)
      return complain(fail(ErrorCode::syntax, fmt::format("--origin: '{}' is no point", call.origin.substr(0, 60)),
                           "as in --origin 50,50"),
                      wrong_call);
    origin = (*place)[0].at;
  }
  auto motion = call.css ? from_css(call.motion, origin) : parse_motion(call.motion);
  if (!motion) return complain_about(call.motion, motion.error());
  for (const Factor& f : motion->factors)
    if (!f.about.empty())
      return complain(
          fail(ErrorCode::name, fmt::format("there is no object '{}' here", f.about), "a centre is a place: @ 0 1"),
          wrong_input);
  if (call.inverse) motion = inverse(*motion);
  if (!motion) return complain(motion.error(), wrong_input);
  asked.motion = *std::move(motion);
  const Status fine = check(asked.motion);
  return fine ? static_cast<int>(all_done) : complain(fine.error(), wrong_input);
}

int teach(const AlgebraCall& call, const AskedFrames& asked) {
  LessonOptions options{call.steps, {}};
  if (call.points)
    for (const Point& p : asked.points) options.points.push_back(p.at);
  const Status done = write_lesson(*call.lesson, asked.motion, options);
  return done ? static_cast<int>(all_done) : complain(done.error(), wrong_input);
}

int print_css(const AskedFrames& asked) {
  const auto lists = to_css(asked.motion);
  if (!lists) return complain(lists.error(), wrong_input);
  fmt::print("from {}\nto {}\n", lists->from, lists->to);
  return all_done;
}

// Says what cannot be before frames are written; the exit code where there is such.
int look_ahead(const AskedFrames& asked, std::int64_t count) {
  if (!asked.method) return all_done;
  const double none = 0;
  const auto steps = Steps<double>::make(asked.motion, count, *asked.method, {&none, 1}, {&none, 1});
  if (!steps) return complain(steps.error(), wrong_input);
  for (const Point& p : asked.points)
    if (p.numbers == 3) return complain(fail(ErrorCode::type, "the methods move points of the plane"), wrong_call);
  if (asked.method == Method::geometric && end_only(asked.motion))
    fmt::print(stderr, "betwixt: notice: this scheme meets the motion at its end, and leaves it in between\n");
  return all_done;
}

int print_json(const AlgebraCall& call, const AskedFrames& asked) {
  const bool made = call.css || call.inverse;  // what was not given as it is
  fmt::print("{{\"steps\":{},{}\"frames\":[", call.steps,
             made ? fmt::format("\"motion\":{},", json_text(to_string(asked.motion))) : "");
  const char* between = "";
  const Status done = go(call, asked, [&](double k, const std::vector<Point>& points) {
    std::string frame = fmt::format("{}{{\"k\":{},\"points\":[", std::exchange(between, ","), json_number(k));
    for (std::size_t i = 0; i < points.size(); ++i) {
      frame += i ? ",[" : "[";
      for (int c = 0; c < points[i].numbers; ++c) frame += (c ? "," : "") + json_number(points[i].at[c]);
      frame += "]";
    }
    fmt::print("{}]}}", frame);
  });
  if (!done) return complain(done.error(), wrong_input);
  fmt::print("]{}}}\n", call.count ? ",\"count\":" + count_json(call, asked) : "");
  return all_done;
}

int print_text(const AlgebraCall& call, const AskedFrames& asked) {
  if (call.count) {
    print_counts(call, asked);
    if (call.at.empty() && call.method.empty()) return all_done;
    fmt::print("\n");
  }
  const Status done = go(call, asked, [&](double k, const std::vector<Point>& points) {
    fmt::print("{:<6}", write_number(k));
    for (const Point& p : points) fmt::print("  {}", point_text(p, " "));
    fmt::print("\n");
  });
  return done ? static_cast<int>(all_done) : complain(done.error(), wrong_input);
}

int algebra(AlgebraCall& call) {
  if (const Status s = read_steps(call); !s) return complain(s.error(), wrong_call);
  auto asked = read(call);
  if (!asked) return complain(asked.error(), wrong_call);
  if (const int code = read_motion(call, *asked); code != all_done) return code;
  if (call.lesson) return teach(call, *asked);
  const bool planar = is_planar(asked->motion);
  if (!planar)
    for (Point& p : asked->points) p.numbers = 3;
  if (call.to_css) return print_css(*asked);
  if (call.count && !planar)
    return complain(fail(ErrorCode::type, "this motion leaves the plane", "operations are counted in the plane only"),
                    wrong_input);
  if ((call.inverse || call.css) && !call.json) fmt::print("{}\n", to_string(asked->motion));
  if (const int code = look_ahead(*asked, call.steps); code != all_done) return code;
  return call.json ? print_json(call, *asked) : print_text(call, *asked);
}

Status known_method(const std::string& name, std::string& to) {
  for (const Method known : methods)
    if (name == name_of(known)) return to = name, Nothing{};
  return fail(ErrorCode::name, fmt::format("'{}' is no method: matrix, geometric, differences or best", name));
}

std::vector<Parameter> algebra_parameters(AlgebraCall& call) {
  return {
      {.name = "MOTION", .sentence = "the string, the leftmost applied last", .into = &call.motion, .required = true},
      option("--steps", "N", "how many steps lead to the end (24)", &call.steps_text),
      {.name = "--at",
       .value = "K[,K…]",
       .sentence = "these frames only: 0 is rest, N the end",
       .into = &call.at,
       .separated = true},
      option("--points", "\"X,Y …\"", "what is moved (\"1,0\")", &call.points),
      {.name = "--method",
       .value = "NAME",
       .sentence = "matrix, geometric, differences or best; without it each frame is worked out by itself",
       .into = ReadValue([&call](const std::string& name) { return known_method(name, call.method); }),
       .words = {"matrix", "geometric", "differences", "best"}},
      flag("--count", "operations per step, as the source prints them and as they are", call.count),
      flag("--css", "MOTION is a list of CSS transforms, in pixels: \"translate(10px, 0) rotate(90deg)\"", call.css),
      {.name = "--origin",
       .value = "X,Y",
       .sentence = "of --css: what transform-origin is, in pixels (0,0)",
       .into = &call.origin,
       .needs = "--css"},
      flag("--to-css", "the motion as two lists of CSS transforms, to animate from one to the other", call.to_css),
      flag("--inverse", "the motion that undoes this one", call.inverse),
      flag("--json", "one JSON object", call.json),
      file_option("--lesson", "OUT.html", "writes a page that teaches the string", &call.lesson, "--json")};
}

const Enlisted enlisted_algebra(algebra, [](AlgebraCall& call) -> Subcommand {
  return {.rank = 80,
          .name = "algebra",
          .sentence = "the frames of a string of T(…), R(…) and S(…), and what they cost",
          .takes = algebra_parameters(call),
          .example = "betwixt algebra \"T(6.28 0) R(-1turn @ 0 1)\" --steps 12 --points \"0,0 0,2\" --count",
          .manual = "The string is one of translations, rotations and scalings, the leftmost applied last."};
});

}  // namespace
}  // namespace betwixt
