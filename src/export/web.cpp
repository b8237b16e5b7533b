// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion for web pages: as keyframes of CSS, and as those of the Web Animations interface. An object's steps are
// animations of one property that are added to each other, in their order. So each number has curves of its own, which
// are exact.
#include <fmt/format.h>

#include <cmath>

#include "export/formats.h"
#include "export/json.h"
#include "export/planar.h"
#include "export/seen.h"

namespace betwixt {
namespace {

std::string css_function(PlanarStep::What what, double v, double pixels) {
  constexpr std::string_view names[] = {"translateX({}px)", "translateY({}px)", "rotate({}deg)", "scaleX({})",
                                        "scaleY({})"};
  return fmt::format(fmt::runtime(names[what]), short_number(on_page(what, v, pixels)));
}
std::string css_easing(const PlanarCurve& c) {
  if (c.shape == PlanarCurve::held) return "step-end";
  if (c.shape == PlanarCurve::straight) return "linear";
  return fmt::format("cubic-bezier({}, {}, {}, {})", short_number(c.x1), short_number(c.y1), short_number(c.x2),
                     short_number(c.y2));
}

// A value at a time, 0 to 1 of the film, and how it continues.
struct WebKey {
  double at;
  double value;
  std::string easing;
};
// At a jump two keys have one time; `apart` moves the first of them to that much before.
std::vector<WebKey> web_keys(const PlanarCurves& curves, const ExportOptions& options, double apart) {
  const double whole = (options.until - options.from).seconds();
  const auto share = [&](Time t) { return whole > 0 ? std::clamp((t - options.from).seconds() / whole, 0.0, 1.0) : 0; };
  std::vector<WebKey> out;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const PlanarCurve& c = curves[i];
    out.push_back({share(c.from), c.begin, css_easing(c)});
    const bool last = i + 1 == curves.size(), jumps = !last && curves[i + 1].begin != c.end;
    if (last || (jumps && c.shape != PlanarCurve::held))
      out.push_back(
          {std::max(out.back().at, share(c.until) - (last ? 0 : apart)), c.end, last ? "linear" : "step-end"});
  }
  out.back().at = 1;
  return out;
}

// Shared by both: the motion in pixels of the film's picture.
struct WebFilm {
  std::vector<PlanarMotion> motions;
  std::vector<std::string> names;
  double pixels = 1;  // of a metre
  double seconds = 0;
};
Result<WebFilm> web_film(const Program& program, const ExportOptions& options, Exported& made) {
  WebFilm film;
  const auto view = planar_view(program, options);
  if (!view) return view.error();
  auto motions = planar_motions(program, options);
  if (!motions) return motions.error();
  film.motions = *std::move(motions);
  for (PlanarMotion& m : film.motions) m.steps.insert(m.steps.begin(), view->steps.begin(), view->steps.end());
  if (film.motions.empty())
    return fail(ErrorCode::range, "the film has no visible objects",
                "name the objects, as in betwixt export film.bx ball -o ball.css");
  std::vector<ObjectId> ids;
  for (const PlanarMotion& m : film.motions) ids.push_back(m.id);
  film.names = plain_names(program.document(), ids);
  film.pixels = picture_size(program.document()).second / view->height;
  film.seconds = (options.until - options.from).seconds();
  made.objects = film.motions.size();
  const auto frames = static_cast<std::size_t>(std::max(1.0, film.seconds * program.document().rate().per_second()));
  for (const PlanarMotion& m : film.motions)
    for (const PlanarStep& s : m.steps)
      if (!constant(s.curves)) ++made.channels, made.keys += s.curves.size() + 1, made.baked += frames;
  return film;
}

// Lists everything but motion, which keyframes do not hold.

void say_motion_only(const Program& program, const ExportOptions& options, const WebFilm& film, Exported& made) {
  for (const PlanarMotion& m : film.motions)
    if (!planar_color(program, options, m.id).constant() || !planar_opacity(program, options, m.id).constant())
      leave_out(made, fmt::format(
                          "changes of the colour or opacity of {} are left out; the keyframes contain only its motion",
                          program.document().name(m.id)));
}

}  // namespace

Result<std::string> make_css(const Program& program, const ExportOptions& options, Exported& made) {
  const auto film = web_film(program, options, made);
  if (!film) return film.error();
  say_motion_only(program, options, *film, made);
  std::string out = fmt::format(
      "/* Made by Betwixt. An element of class \"{}\" moves as the object does, from the middle of a picture {} px "
      "high. */\n",
      film->names[0], picture_size(program.document()).second);
  for (std::size_t i = 0; i < film->motions.size(); ++i) {
    const std::string& name = film->names[i];
    std::string list, frames;
    int number = 0;
    for (const PlanarStep& step : film->motions[i].steps) {
      const std::string own = fmt::format("{}-{}", name, ++number);
      list += fmt::format("{}{} {}s both linear", list.empty() ? "" : ", ", own, short_number(film->seconds));
      frames += fmt::format("@keyframes {} {{\n", own);
      for (const WebKey& k : web_keys(step.curves, options, 1e-9))
        frames += fmt::format("  {:.9g}% {{ transform: {}; animation-timing-function: {} }}\n", 100 * k.at,
                              css_function(step.what, k.value, film->pixels), k.easing);
      frames += "}\n";
    }
    out += fmt::format("\n.{} {{\n  animation: {};\n  animation-composition: add;\n}}\n{}", name,
                       list.empty() ? "none" : list, frames);
  }
  return out;
}

Result<std::string> make_waapi(const Program& program, const ExportOptions& options, Exported& made) {
  const auto film = web_film(program, options, made);
  if (!film) return film.error();
  say_motion_only(program, options, *film, made);
  Json objects = Json::object();
  for (std::size_t i = 0; i < film->motions.size(); ++i) {
    auto steps = Json::array();
    for (const PlanarStep& step : film->motions[i].steps) {
      auto frames = Json::array();
      for (const WebKey& k : web_keys(step.curves, options, 0))
        frames.push_back(
            {{"offset", k.at}, {"transform", css_function(step.what, k.value, film->pixels)}, {"easing", k.easing}});
      steps.push_back(std::move(frames));
    }
    objects[std::string(program.document().name(film->motions[i].id))] = std::move(steps);
  }
  return fmt::format(
      "// Made by Betwixt. play(element, \"{}\") moves an element as the object does, from the middle of a picture {} "
      "px high.\n"
      "export const duration = {};  // milliseconds\n"
      "export const objects = {};\n"
      "export function play(element, name, options = {{}}) {{\n"
      "  return objects[name].map((frames) =>\n"
      "    element.animate(frames, {{ duration, fill: \"both\", composite: \"add\", ...options }}));\n"
      "}}\n",
      program.document().name(film->motions[0].id), picture_size(program.document()).second,
      short_number(1000 * film->seconds), objects.dump(1));
}

}  // namespace betwixt
