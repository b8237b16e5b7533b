// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The view of a drawing.
#include <algorithm>
#include <cmath>

#include "betwixt/evaluation.h"
#include "export/fit.h"
#include "export/planar.h"
#include "export/seen.h"

namespace betwixt {
namespace {

double roll_of(const Camera& c) { return std::atan2(c.world(1, 0), c.world(0, 0)); }

}  // namespace

bool PlanarView::moves() const {
  return std::any_of(steps.begin(), steps.end(), [](const PlanarStep& s) { return !constant(s.curves); });
}

Result<PlanarView> planar_view(const Program& program, const ExportOptions& options, bool in_unit) {
  Evaluation e(program);
  const auto camera = [&](Time t) {
    e.to(t);
    return e.camera();
  };
  const std::string hint = "use film flat, or a camera with height=…, position=(0 0 10) and no look-at";
  const Camera first = camera(options.from);
  bool moves = false;
  const auto knots = knots_between(program.discontinuities(options.from, options.until), options.from, options.until);
  const std::vector<Time> looks = looks_of(program, options.from, options.until);
  std::vector<double> rolls;  // at these times, followed through whole turns
  for (const Time t : looks) {
    const Camera c = camera(t);
    const double angle = roll_of(c), before = rolls.empty() ? angle : rolls.back();
    rolls.push_back(angle + 2 * pi * std::round((before - angle) / (2 * pi)));
    if (!c.orthographic) return fail(ErrorCode::range, "the camera has perspective, but a drawing is flat", hint);
    if (length(column(c.world, 2) - Vec3{0, 0, 1}) > 1e-6)
      return fail(ErrorCode::range, "the camera does not look along -z, but a drawing is in the plane of x and y",
                  hint);
    moves = moves || !(c == first);
  }
  PlanarView view{first.height * first.aspect, first.height, {}};
  const auto roll = [&](const Camera& c) {
    const auto next = std::upper_bound(looks.begin() + 1, looks.end(), e.time());
    const double near = rolls[static_cast<std::size_t>(next - looks.begin()) - 1], angle = roll_of(c);
    return angle + 2 * pi * std::round((near - angle) / (2 * pi));
  };
  const auto add = [&](PlanarStep::What what, const std::function<double(const Camera&)>& number) {
    const double begin = number(camera(options.from));
    PlanarStep step{what, {{PlanarCurve::held, options.from, options.until, begin, begin}}};
    if (moves) {
      const Followed f = followed(program.document(), 1, options.keys.metres, [&](Time t) {
        return KeyValue{number(camera(t)), 0, 0, 0};
      });
      step.curves = planar_curves(follow(f, knots, options.keys), 0, in_unit);
    }
    if (!step.nothing()) view.steps.push_back(std::move(step));
  };
  const auto growth = [&](const Camera& c) { return first.height / c.height; };
  add(PlanarStep::move_x, [&](const Camera& c) { return first.height * first.aspect * c.shift_x / 2; });
  add(PlanarStep::move_y, [&](const Camera& c) { return first.height * c.shift_y / 2; });
  add(PlanarStep::grow_x, growth), add(PlanarStep::grow_y, growth);
  add(PlanarStep::turn, [&](const Camera& c) { return -roll(c); });
  add(PlanarStep::move_x, [](const Camera& c) { return -translation_of(c.world).x; });
  add(PlanarStep::move_y, [](const Camera& c) { return -translation_of(c.world).y; });
  return view;
}

}  // namespace betwixt
