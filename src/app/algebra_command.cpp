// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt algebra: the frames of a product of translations, rotations and scalings, and their cost in operations.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "app/algebra.h"
#include "app/command.h"
#include "app/lesson.h"
#include "app/subcommand.h"
#include "base/utf8.h"
#include "language/json.h"
#include "language/values.h"

namespace betwixt {
namespace {

using algebra_command::Asked, algebra_command::Call, algebra_command::Point, algebra_command::Shown;

constexpr Method methods[] = {Method::matrix, Method::geometric, Method::differences, Method::best};
constexpr std::int64_t most_stepped = 1'000'000;  // steps; a frame farther away is found by seek()

Status placed(double k, std::vector<Point>& points, const std::function<Vec3(std::size_t)>& place) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    points[p].at = place(p);
    if (!finite(points[p].at))
      return fail(ErrorCode::range, fmt::format("frame {}: a position is not finite", write_number(k)));
  }
  return Nothing{};
}

// Computes one frame by itself.
Status one_frame(const Call& call, const Asked& asked, double k, Shown& shown) {
  const Mat4 m = k == std::floor(k) && std::abs(k) < 9e15
                     ? *frame(asked.motion, static_cast<std::int64_t>(k), call.steps)
                     : at(asked.motion, k / static_cast<double>(call.steps));
  return placed(k, shown.points, [&](std::size_t p) { return transform_point(m, asked.points[p].at); });
}

Result<Steps<double>> made_steps(const Call& call, const Asked& asked) {
  std::vector<double> x, y;
  for (const Point& p : asked.points) x.push_back(p.at.x), y.push_back(p.at.y);
  return Steps<double>::make(asked.motion, call.steps, *asked.method, x, y);
}
// Computes a frame by the method, from the frame before.
Status next_frame(Steps<double>& steps, double at, Shown& shown) {
  const auto k = static_cast<std::int64_t>(at);
  if (k < steps.frame() || k - steps.frame() > most_stepped) steps.seek(k);
  while (steps.frame() < k) steps.step();
  return placed(at, shown.points, [&](std::size_t p) { return Vec3{steps.x()[p], steps.y()[p], 0}; });
}

// ---- The call

Result<Asked> read(const Call& call) {
  Asked asked;
  auto points = algebra_command::read_points(call.points.value_or("1,0"));
  if (!points) return points.error();
  asked.points = *std::move(points);
  if (call.steps < 1) return frame({}, 0, call.steps).error();
  for (const Method m : methods)
    if (call.method == name_of(m)) asked.method = m;
  for (const std::string& text : call.at) {
    const auto k = algebra_command::read_number(text, "--at");
    if (!k) return k.error();
    if (asked.method && (*k != std::floor(*k) || std::abs(*k) > 9e15))
      return fail(ErrorCode::range, fmt::format("--at: methods need whole steps, not {}", text));
    asked.frames.push_back(*k);
  }
  return asked;
}

Status read_steps(Call& call) {
  if (call.steps_text.empty()) return Nothing{};
  const char* end = call.steps_text.data() + call.steps_text.size();
  const auto [at, bad] = std::from_chars(call.steps_text.data(), end, call.steps);
  if (bad == std::errc() && at == end) return Nothing{};
  return fail(ErrorCode::syntax, fmt::format("--steps: '{}' is not a whole number", call.steps_text.substr(0, 60)));
}

// Reads --origin into `asked`.
Status read_origin(const Call& call, Asked& asked) {
  if (call.origin.empty()) return Nothing{};
  const auto place = algebra_command::read_points(call.origin);
  if (!place || place->size() != 1)
    return fail(ErrorCode::syntax, fmt::format("--origin: '{}' is not a point", call.origin.substr(0, 60)),
                "as in --origin 50,50");
  asked.origin = (*place)[0].at;
  return Nothing{};
}

// Reads the motion into `asked`. Returns the exit code.
int read_motion(const Call& call, Asked& asked) {
  const auto page = algebra_command::read_page(call);
  if (!page) return complain(page.error(), wrong_call);
  auto motion = call.css ? from_css(call.motion, asked.origin, *page) : parse_motion(call.motion);
  if (!motion) return algebra_command::complain_about(call.motion, motion.error());
  for (const Factor& f : motion->factors)
    if (!f.about.empty())
      return complain(fail(ErrorCode::name, fmt::format("there is no object '{}' here", f.about),
                           "write the centre as a point: @ 0 1"),
                      wrong_input);
  if (call.inverse) motion = inverse(*motion);
  if (!motion) return complain(motion.error(), wrong_input);
  asked.motion = *std::move(motion);
  const Status fine = check(asked.motion);
  return fine ? static_cast<int>(all_done) : complain(fine.error(), wrong_input);
}

int teach(const Call& call, const Asked& asked) {
  LessonOptions options{call.steps, {}};
  if (call.points)
    for (const Point& p : asked.points) options.points.push_back(p.at);
  const Status done = write_lesson(*call.lesson, asked.motion, options);
  return done ? static_cast<int>(all_done) : complain(done.error(), wrong_input);
}

int print_css(const Asked& asked) {
  const auto lists = to_css(asked.motion);
  if (!lists) return complain(lists.error(), wrong_input);
  fmt::print("from {}\nto {}\n", lists->from, lists->to);
  return all_done;
}

// Reports errors before the first frame is printed. Returns the exit code.
int look_ahead(const Call& call, const Asked& asked) {
  if (!asked.method) return all_done;
  const auto steps = made_steps(call, asked);
  if (!steps) return complain(steps.error(), wrong_input);
  for (const Point& p : asked.points)
    if (p.numbers == 3) return complain(fail(ErrorCode::type, "the methods work only in the plane"), wrong_call);
  if (asked.method == Method::geometric && algebra_command::end_only(asked.motion))
    fmt::print(
        stderr,
        "betwixt: notice: this method is exact only at the end of the motion; in between the error is up to {}\n",
        write_number(algebra_command::off_the_way(call, asked)));
  return all_done;
}

int show_motion(const Call& call, const Asked& asked) {
  const bool made = call.css || call.inverse;  // the motion is computed, not the one given
  if (made && !call.json) fmt::print("{}\n", to_string(asked.motion));
  if (const int code = look_ahead(call, asked); code != all_done) return code;
  if (call.count && !call.json) {
    algebra_command::print_counts(call, asked);
    if (call.at.empty() && call.method.empty()) return all_done;
    fmt::print("\n");
  }
  const std::string head = made ? fmt::format("\"motion\":{},", json_text(to_string(asked.motion))) : "";
  const std::string tail =
      call.count && call.json ? ",\"count\":" + algebra_command::count_json(call, asked) : std::string();
  if (!asked.method)
    return show_frames(call, asked, head, tail,
                       [&](double k, Shown& shown) { return one_frame(call, asked, k, shown); });
  auto steps = made_steps(call, asked);
  return show_frames(call, asked, head, tail, [&](double k, Shown& shown) { return next_frame(*steps, k, shown); });
}

int algebra(Call& call) {
  if (const Status s = read_steps(call); !s) return complain(s.error(), wrong_call);
  auto asked = read(call);
  if (!asked) return complain(asked.error(), wrong_call);
  if (const Status s = read_origin(call, *asked); !s) return complain(s.error(), wrong_call);
  if (call.css && algebra_command::beyond_motions(call)) return algebra_command::show_css(call, *asked);
  if (const int code = read_motion(call, *asked); code != all_done) return code;
  if (call.lesson) return teach(call, *asked);
  if (call.symbols) return algebra_command::show_symbols(call, *asked);
  const bool planar = is_planar(asked->motion);
  if (!planar)
    for (Point& p : asked->points) p.numbers = 3;
  if (call.to_css) return print_css(*asked);
  if (call.count && !planar)
    return complain(
        fail(ErrorCode::type, "this motion leaves the plane", "operations can be counted only in the plane"),
        wrong_input);
  return show_motion(call, *asked);
}

Status known_method(const std::string& name, std::string& to) {
  for (const Method known : methods)
    if (name == name_of(known)) return to = name, Nothing{};
  return fail(ErrorCode::name,
              fmt::format("the method must be matrix, geometric, differences or best, not '{}'", name));
}

std::vector<Parameter> algebra_parameters(Call& call) {
  const auto of_css = [](const char* name, const char* value, const char* sentence, std::string& into) {
    return Parameter{.name = name,
                     .value = value,
                     .sentence = std::string("with --css: ") + sentence,
                     .into = &into,
                     .needs = "--css"};
  };
  return {{.name = "MOTION",
           .sentence = "the string; the leftmost factor is applied last",
           .into = &call.motion,
           .required = true},
          option("--steps", "N", "the number of steps to the end (24)", &call.steps_text),
          {.name = "--at",
           .value = "K[,K…]",
           .sentence = "only these frames: 0 is the start, N the end",
           .into = &call.at,
           .separated = true},
          option("--points", "\"X,Y …\"", "the points to move (\"1,0\")", &call.points),
          {.name = "--method",
           .value = "NAME",
           .sentence = "matrix, geometric, differences or best; by default each frame is computed directly",
           .into = ReadValue([&call](const std::string& name) { return known_method(name, call.method); }),
           .words = {"matrix", "geometric", "differences", "best"}},
          flag("--count", "counts the operations per step, as the paper prints them and as measured", call.count),
          flag("--symbols", "prints the matrix of A(t) in symbols, and the meaning of the symbols", call.symbols),
          flag("--css", "MOTION is a list of CSS transforms: \"translate(10px, 0) rotate(90deg)\"", call.css),
          of_css("--to", "LIST", "the list at the end; MOTION is the list at the beginning", call.css_to),
          of_css("--under", "LIST", "the underlying list, to which the others are added", call.css_under),
          {.name = "--accumulate",
           .sentence = "with --under: accumulates function by function",
           .into = &call.accumulate,
           .needs = "--under"},
          of_css("--size", "W,H", "the size that % refer to, in pixels", call.size),
          of_css("--font-size", "PX", "the font size that em and rem refer to, in pixels", call.font_size),
          of_css("--viewport", "W,H", "the size that vw, vh, vmin and vmax refer to, in pixels", call.viewport),
          of_css("--origin", "X,Y", "the transform-origin, in pixels (0,0)", call.origin),
          flag("--to-css", "prints the motion as two lists of CSS transforms, to animate from one to the other",
               call.to_css),
          flag("--inverse", "prints the motion that undoes this one", call.inverse),
          flag("--json", "one JSON object", call.json),
          file_option("--lesson", "OUT.html", "writes a page that teaches the motion and lets you edit it",
                      &call.lesson, "--json")};
}

const Enlisted enlisted_algebra(algebra, [](Call& call) -> Subcommand {
  return {.rank = 80,
          .name = "algebra",
          .sentence = "prints the frames of a string of T(…), R(…) and S(…), and their cost",
          .takes = algebra_parameters(call),
          .example = "betwixt algebra \"T(6.28 0) R(-1turn @ 0 1)\" --steps 12 --points \"0,0 0,2\" --count",
          .manual = "The string is a product of translations, rotations and scalings. The leftmost is applied last."};
});

}  // namespace
}  // namespace betwixt
