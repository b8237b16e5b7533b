// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion for web pages: as keyframes of CSS, as those of the Web Animations interface, and as a picture that moves
// (SVG). An object's steps are animations of one property that are added to each other, in their order; so each number
// has curves of its own, and they are exact.
#include <fmt/format.h>

#include <cmath>

#include "export/formats.h"
#include "export/json.h"
#include "export/planar.h"
#include "export/seen.h"
#include "track/track.h"

namespace betwixt {
namespace {

// Of a step's value, as its function of transforms takes it: pixels downwards, degrees clockwise.
double on_page(PlanarStep::What what, double v, double pixels) {
  switch (what) {
    case PlanarStep::move_x:
      return v * pixels;
    case PlanarStep::move_y:
      return -v * pixels;
    case PlanarStep::turn:
      return -v * 180 / pi;
    default:
      return v;
  }
}
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

// A value from a moment on, 0 to 1 of the film, and how it goes on.
struct WebKey {
  double at;
  double value;
  std::string easing;
};
// Where it jumps, two keys have one moment; `apart` puts the first of them that much before it.
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

// What all three have in common: the motion in pixels of the film's picture.
struct WebFilm {
  PlanarView view;
  std::vector<PlanarMotion> motions;
  std::vector<std::string> names;
  double pixels = 1;  // of a metre
  double seconds = 0;
};
Result<WebFilm> web_film(const Program& program, const ExportOptions& options, Exported& made, bool in_unit = false) {
  WebFilm film;
  const auto view = planar_view(program, options);
  if (!view) return view.error();
  film.view = *view;
  auto motions = planar_motions(program, options, *view, in_unit);
  if (!motions) return motions.error();
  film.motions = *std::move(motions);
  if (film.motions.empty())
    return fail(ErrorCode::range, "nothing is drawn in the film",
                "name what moves, as in betwixt export film.bx ball -o ball.css");
  std::vector<ObjectId> ids;
  for (const PlanarMotion& m : film.motions) ids.push_back(m.id);
  film.names = plain_names(program.document(), ids);
  film.pixels = picture_size(program.document()).second / film.view.height;
  film.seconds = (options.until - options.from).seconds();
  made.objects = film.motions.size();
  const auto frames = static_cast<std::size_t>(std::max(1.0, film.seconds * program.document().rate().per_second()));
  for (const PlanarMotion& m : film.motions)
    for (const PlanarStep& s : m.steps)
      if (!constant(s.curves)) ++made.channels, made.keys += s.curves.size() + 1, made.baked += frames;
  return film;
}

// Keyframes are of motion alone.
void say_motion_only(const Program& program, const ExportOptions& options, const WebFilm& film, Exported& made) {
  for (const PlanarMotion& m : film.motions)
    if (!planar_color(program, options, m.id).constant() || !planar_opacity(program, options, m.id).constant())
      leave_out(made, fmt::format("how {} changes its colour or opacity is left out: keyframes say how it moves",
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

// ---- A picture that moves

namespace {

std::string hex(Vec3 light) {
  const Color c = to_srgb(light);
  const auto byte = [](double v) { return std::lround(255 * std::clamp(v, 0.0, 1.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(c.r), byte(c.g), byte(c.b));
}

// Of what goes straight from value to value.
template <class F>
void animate_plain(std::string& out, std::string_view attribute, const Channel& c, const ExportOptions& options,
                   F value) {
  if (c.constant()) return;
  const double whole = std::max((options.until - options.from).seconds(), 1e-9);
  std::string times, values;
  for (const KeyPiece& p : c.pieces)
    for (const auto& [t, v] : {std::pair(p.from, p.begin), std::pair(p.until, p.end)}) {
      const char* between = times.empty() ? "" : ";";
      times += fmt::format("{}{:.9g}", between, std::clamp((t - options.from).seconds() / whole, 0.0, 1.0));
      values += between + value(v);
    }
  out +=
      fmt::format("      <animate attributeName=\"{}\" dur=\"{}s\" fill=\"freeze\" keyTimes=\"{}\" values=\"{}\"/>\n",
                  attribute, short_number(whole), times, values);
}

std::string path_of(const Contours& contours, double pixels, bool closed = true) {
  std::string d;
  for (const auto& contour : contours) {
    char command = 'M';
    for (const Vec3 p : contour) {
      d += fmt::format("{}{} {}", std::exchange(command, 'L'), short_number(p.x * pixels), short_number(-p.y * pixels));
    }
    if (closed) d += 'Z';
  }
  return d;
}

// `additive`: the first one takes the place of the rest, the others are added to it.
void animate(std::string& out, const PlanarStep& step, const ExportOptions& options, const WebFilm& film,
             std::string_view additive) {
  constexpr std::string_view types[] = {"translate", "translate", "rotate", "scale", "scale"};
  const auto value = [&](double v) {
    const std::string n = short_number(on_page(step.what, v, film.pixels));
    return step.what == PlanarStep::move_y   ? "0 " + n
           : step.what == PlanarStep::grow_x ? n + " 1"
           : step.what == PlanarStep::grow_y ? "1 " + n
                                             : n;
  };
  // A moment that comes twice is a jump; what is held has a key at its end.
  std::string times, values, splines;
  const double whole = std::max(film.seconds, 1e-9);
  for (const PlanarCurve& c : step.curves) {
    const double from = (c.from - options.from).seconds() / whole, until = (c.until - options.from).seconds() / whole;
    const bool first = times.empty();
    for (const auto& [at, v] : {std::pair(from, c.begin), std::pair(until, c.end)}) {
      if (!times.empty()) times += ';', values += ';';
      times += fmt::format("{:.9g}", std::clamp(at, 0.0, 1.0)), values += value(v);
    }
    if (!first) splines += "0 0 1 1;";  // from the end of one to the beginning of the next: no time
    splines += c.shape == PlanarCurve::cubic ? fmt::format("{} {} {} {};", short_number(c.x1), short_number(c.y1),
                                                           short_number(c.x2), short_number(c.y2))
                                             : "0 0 1 1;";
  }
  splines.pop_back();
  out += fmt::format(
      "    <animateTransform attributeName=\"transform\" type=\"{}\" additive=\"{}\" dur=\"{}s\" fill=\"freeze\" "
      "calcMode=\"spline\" keyTimes=\"{}\" values=\"{}\" keySplines=\"{}\"/>\n",
      types[step.what], additive, short_number(film.seconds), times, values, splines);
}

// Where it is at the beginning: for those who show it at rest.
std::string rest(const PlanarMotion& m, const WebFilm& film) {
  std::string all;
  for (const PlanarStep& step : m.steps) {
    const std::string n = short_number(on_page(step.what, step.curves.front().begin, film.pixels));
    all += (all.empty() ? "" : " ");
    all += step.what == PlanarStep::move_x   ? fmt::format("translate({})", n)
           : step.what == PlanarStep::move_y ? fmt::format("translate(0 {})", n)
           : step.what == PlanarStep::turn   ? fmt::format("rotate({})", n)
           : step.what == PlanarStep::grow_x ? fmt::format("scale({} 1)", n)
                                             : fmt::format("scale(1 {})", n);
  }
  return all.empty() ? "" : fmt::format(" transform=\"{}\"", all);
}

}  // namespace

Result<std::string> make_svg(const Program& program, const ExportOptions& options, Exported& made) {
  const auto film = web_film(program, options, made, true);
  if (!film) return film.error();
  const auto [width, height] = picture_size(program.document());
  std::string out =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">\n",
                  width, height, short_number(-width / 2.0), short_number(-height / 2.0), width, height);
  if (const auto background = planar_background(program, options))
    out += fmt::format("  <rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                       short_number(-width / 2.0), short_number(-height / 2.0), width, height, hex(*background));
  std::vector<std::pair<double, std::string>> drawn;  // what is farther away first
  for (std::size_t i = 0; i < film->motions.size(); ++i) {
    const PlanarMotion& m = film->motions[i];
    const auto look = planar_look(program, options, m.id);
    if (!look) return look.error();
    std::string group =
        fmt::format("  <g id=\"{}\" opacity=\"{}\"{}>\n", film->names[i], short_number(look->opacity), rest(m, *film));
    const bool still =
        std::all_of(m.steps.begin(), m.steps.end(), [](const PlanarStep& s) { return constant(s.curves); });
    for (const PlanarStep& step : m.steps)
      if (!still) animate(group, step, options, *film, &step == m.steps.data() ? "replace" : "sum");
    animate_plain(group, "opacity", planar_opacity(program, options, m.id), options,
                  [](const auto& v) { return short_number(v[0]); });
    const Channel color = planar_color(program, options, m.id);
    const auto written = [](const auto& v) { return hex(to_linear(Color{v[0], v[1], v[2]})); };
    if (!look->filled.empty()) {
      group += fmt::format("    <path d=\"{}\" fill=\"{}\">\n", path_of(look->filled, film->pixels), hex(look->color));
      animate_plain(group, "fill", color, options, written);
      group += "    </path>\n";
    }
    for (const DrawnPart& part : look->stroked) {
      group += fmt::format("    <path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}>\n",
                           path_of({part.points}, film->pixels, part.closed), hex(look->stroke),
                           short_number(look->width * film->pixels),
                           look->round ? " stroke-linecap=\"round\" stroke-linejoin=\"round\"" : "");
      if (look->stroke == look->color) animate_plain(group, "stroke", color, options, written);
      group += "    </path>\n";
    }
    drawn.emplace_back(look->z, group + "  </g>\n");
  }
  std::stable_sort(drawn.begin(), drawn.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [z, group] : drawn) out += group;
  return out + "</svg>\n";
}

}  // namespace betwixt
