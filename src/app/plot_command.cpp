// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/command.h"
#include "app/plot_svg.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/files.h"
#include "base/names.h"
#include "base/tell_user.h"
#include "betwixt/program.h"
#include "scene/document.h"

namespace betwixt {
namespace {

struct PlotCall {
  std::string file, out, frames;
  std::vector<std::string> targets;
};

constexpr int samples_per_frame = 4;
constexpr int most_samples = 200'000;  // of a curve; more than any paper can show
constexpr double degrees = 180 / pi;

// A number of a target, as a function of time.
struct Number {
  const Program* program;
  Target target;
  std::size_t index = 0;  // among the numbers of the value
  double unit = 1;        // angles are drawn in degrees
  double at(Time t) const {
    const std::vector<double> all = numbers(program->read(target, t));
    return index < all.size() ? unit * all[index] : 0;
  }
};

// Returns whether the value jumps between two nearby times, and moves them to both sides of the jump. A steep slope is
// no jump: at some scale its two halves both change.
bool find_jump(const Number& n, Time& a, Time& b, double least) {
  double from = n.at(a), to = n.at(b);
  if (std::abs(to - from) < least) return false;
  while (b.flicks - a.flicks > 1) {
    const Time middle{a.flicks + (b.flicks - a.flicks) / 2};
    const double v = n.at(middle);
    const bool first_half = std::abs(v - from) > std::abs(to - v);
    (first_half ? b : a) = middle;
    (first_half ? to : from) = v;
    if (std::abs(to - from) < least / 2) return false;
  }
  return true;
}

std::vector<Stroke> strokes(const Number& n, const FrameList& frames, Time last) {
  const int per_frame = std::clamp(most_samples / frames.count, 1, samples_per_frame);
  const int count = std::max(1, (frames.count - 1) * per_frame);
  const auto time = [&](int k) {
    return k >= count ? last : frames.first + frames.rate.span(static_cast<double>(k) / per_frame);
  };
  std::vector<double> values;
  for (int k = 0; k <= count; ++k) values.push_back(n.at(time(k)));
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double least = 0.02 * (*high - *low);

  std::vector<Stroke> all(1);
  const auto put = [&](Time t, double v) { all.back().emplace_back(frames.rate.frame_number(t), v); };
  for (int k = 0; k <= count; ++k) {
    const std::size_t i = static_cast<std::size_t>(k);
    Time a = time(std::max(0, k - 1)), b = time(k);
    if (k > 0 && *high > *low && std::abs(values[i] - values[i - 1]) >= least && find_jump(n, a, b, least)) {
      put(a, n.at(a));
      all.emplace_back();
      put(b, n.at(b));
    }
    put(time(k), values[i]);
  }
  return all;
}

Stroke events(const Number& n, const Document& document, const Target& target, const FrameList& frames, Time last) {
  Stroke all;
  for (const Track* track : tracks_of(document.scene(), target))
    track->events.each([&](const Event& e) {
      if (e.time >= frames.first && e.time <= last) all.emplace_back(frames.rate.frame_number(e.time), n.at(e.time));
    });
  return all;
}

// Returns the curves of a target, or none if it has no numbers.
std::vector<DrawnCurve> curves(const Program& program, const Target& target, const FrameList& frames, Time last) {
  const bool asked = target.query().has_value();
  if (asked && target.component < 0) return {};  // a matrix
  const Document& document = program.document();
  const Type type = asked ? Type::scalar : spec_of(document.scene(), target.function).type;
  const std::size_t count = numbers(program.read(target, frames.first)).size();
  if (count > 4) return {};
  const bool angles = row_of(type).angles && count < 4;
  const double unit = angles ? degrees : 1;
  std::vector<DrawnCurve> all;
  for (std::size_t i = 0; i < count; ++i) {
    const Number n{&program, target, i, unit};
    const std::string_view part = count == 4  ? std::string_view("wxyz").substr(i, 1)
                                  : count > 1 ? component_name(type, static_cast<int>(i))
                                              : "";
    Target own = target;  // the component's events, if components have tracks of their own
    if (count > 1 && static_cast<int>(count) == component_count(type)) own.component = static_cast<int>(i);
    all.push_back(
        {document.name(target) + (part.empty() ? "" : fmt::format(".{}", part)) + (angles ? " (degrees)" : ""),
         strokes(n, frames, last), asked ? Stroke{} : events(n, document, own, frames, last)});
  }
  return all;
}

int plot(PlotCall& call) {
  call.out = output_or(call.out, call.file, "svg");
  const Result<Outgoing> outgoing = Outgoing::begin(call.out, "svg");
  if (!outgoing) return complain(outgoing.error(), wrong_call);
  if (!call.out.ends_with(".svg"))
    return complain(fail(ErrorCode::range, fmt::format("a plot must be a .svg file, not \"{}\"", call.out)),
                    wrong_call);
  if (Status s = check_place(call.out, true); !s) return complain(s.error(), wrong_call);
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  const Status drawn = plot_document(*document, call.targets, call.frames, call.out);
  const Status sent = drawn ? outgoing->send() : Status(Nothing{});
  if (!sent) return complain(sent.error(), machine_failed);
  if (drawn) return all_done;
  const ErrorCode code = drawn.error().code;
  return complain(drawn.error(), code == ErrorCode::name || code == ErrorCode::syntax ? wrong_input : wrong_call);
}

}  // namespace

Status plot_document(const Document& document, const std::vector<std::string>& words, const std::string& segment,
                     const std::string& out) {
  if (!out.ends_with(".svg")) return fail(ErrorCode::range, fmt::format("a plot must be a .svg file, not \"{}\"", out));
  const Result<FrameList> frames = read_frames(segment, document);
  if (!frames) return fail(ErrorCode::range, frames.error().message, frames.error().hint);

  const Program program = Program::compile(document);
  const Time last = frames->time(frames->count - 1);
  Plot drawing{fmt::format("{}", fmt::join(words, "  ")),
               frames->rate.frame_number(frames->first),
               frames->rate.frame_number(last),
               frames->rate,
               {}};
  for (const std::string& word : words) {
    const Result<std::vector<Target>> targets = find_targets(word, document);
    if (!targets) return fail(ErrorCode::name, targets.error().message, targets.error().hint);
    if (targets->empty()) tell_user(fmt::format("betwixt: notice: {}\n", nothing_named(word).message));
    const std::size_t before = drawing.curves.size();
    for (const Target& t : *targets)
      for (DrawnCurve& c : curves(program, t, *frames, last)) drawing.curves.push_back(std::move(c));
    if (drawing.curves.size() == before && !targets->empty())
      return fail(ErrorCode::type, fmt::format("\"{}\" has no numbers to plot", word));
  }
  if (drawing.curves.empty()) return fail(ErrorCode::name, "there is nothing to plot");
  if (const int reason = put_file(out, to_svg(drawing))) return system_error(reason, "write", out);
  return Nothing{};
}

namespace {

const Enlisted enlisted_plot(plot, [](PlotCall& call) -> Subcommand {
  return {.rank = 50,
          .name = "plot",
          .sentence = "draws values against time, an SVG",
          .takes = {script_parameter(call.file),
                    targets_parameter(call.targets, "the targets: ball.position.y, 'wheel*.rotation'", true),
                    output_parameter(call.out, "PLOT.svg", "the drawing", "svg"), frames_parameter(call.frames)},
          .example = "betwixt plot examples/bounce.bx ball.position.y reflection.position.y -o bounce.svg"};
});

}  // namespace
}  // namespace betwixt
