// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A flat film as a picture that moves (SVG): a group for each object, with its steps as animations that are added to
// each other, and paths in it whose outlines, colours and dashes are animated.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "export/fit.h"
#include "export/formats.h"
#include "export/seen.h"
#include "export/svg_paint.h"
#include "track/track.h"

namespace betwixt {
namespace {

constexpr double hairline = 1.4;  // pixels, as in the film

class SvgMaker {
 public:
  SvgMaker(const Program& program, const ExportOptions& options, Exported& made)
      : program_(program),
        options_(options),
        made_(made),
        clock_{options.from, options.until},
        seconds_(clock_.seconds()),
        frames_(static_cast<std::size_t>(std::max(1.0, seconds_ * program.document().rate().per_second()))) {}

  Result<std::string> make() {
    const auto film = planar_film(program_, options_, made_, true);
    if (!film) return film.error();
    const auto [width, height] = picture_size(program_.document());
    pixels_ = height / film->view.height;
    std::string out =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">\n",
                    width, height, short_number(-width / 2.0), short_number(-height / 2.0), width, height);
    add_background(width, height, out);
    const bool seen_by = !film->view.steps.empty();
    if (seen_by) {
      out += fmt::format("  <g{}>\n", rest(film->view.steps));
      add_steps(film->view.steps, "    ", out);
    }
    page_ = {static_cast<double>(width), static_cast<double>(height), pixels_};
    layers_ = planar_layers(program_, options_);
    if (!layers_.all.empty()) say_layers();
    std::vector<ObjectId> ids;
    for (const PlanarThing& thing : film->things) ids.push_back(thing.motion.id);
    for (const PlanarLayer& l : layers_.all) ids.push_back(l.object);
    names_ = plain_names(program_.document(), ids);
    copies_.assign(names_.size(), 0);
    add_layer(*film, -1, 0, out);
    if (seen_by) out += "  </g>\n";
    return out + "</svg>\n";
  }

 private:
  std::string id_of(std::size_t name) {
    const std::size_t copy = copies_[name]++;
    return copy == 0 ? names_[name] : fmt::format("{}.{}", names_[name], copy + 1);
  }
  // Groups are written now; what remains is what changes in steps.
  void say_layers() {
    std::erase_if(made_.left_out, [](const std::string& s) { return s.ends_with("shadow of groups are left out"); });
    if (layers_.changes) leave_out(made_, "changes of the blend and the mask of groups are left out");
  }
  // Adds the objects of a layer, or of the picture (-1), and then the layers within.
  void add_layer(const PlanarFilm& film, std::int32_t layer, std::size_t depth, std::string& out) {
    for (const PlanarPlace& place : film.order) {
      const auto found = layers_.of.find(film.things[place.thing].motion.id.index);
      if ((found == layers_.of.end() ? -1 : found->second) == layer)
        add_thing(film.things[place.thing], place.shown, id_of(place.thing), out);
    }
    for (std::size_t k = 0; k < layers_.all.size(); ++k)
      if (layers_.all[k].within == layer && !layers_.all[k].is_mask) add_group(film, k, depth + 1, out);
  }
  void add_group(const PlanarFilm& film, std::size_t k, std::size_t depth, std::string& out) {
    constexpr std::size_t deepest = 64, most_groups = 2000;  // masks may have masks
    constexpr std::string_view blends[] = {"", "screen", "multiply", "plus-lighter", "overlay"};
    if (depth > deepest || ++groups_ > most_groups) return;
    const PlanarLayer& l = layers_.all[k];
    const std::string id = id_of(film.things.size() + k);
    std::string attributes = add_effects(l, "." + id + ".effects", clock_, page_, out);
    if (!l.masks.empty()) {
      out += fmt::format(
          "  <mask id=\".{}.mask\" style=\"mask-type:alpha\" maskUnits=\"userSpaceOnUse\" x=\"{}\" y=\"{}\" "
          "width=\"{}\" height=\"{}\">\n",
          id, short_number(-page_.width), short_number(-page_.height), short_number(2 * page_.width),
          short_number(2 * page_.height));
      writing_.insert(static_cast<std::int32_t>(k));
      for (const std::int32_t m : l.masks)  // one that needs itself does not count
        if (!writing_.contains(m)) add_group(film, static_cast<std::size_t>(m), depth + 1, out);
      writing_.erase(static_cast<std::int32_t>(k));
      out += "  </mask>\n";
      attributes += fmt::format(" mask=\"url(#.{}.mask)\"", id);
    }
    if (l.blend != LayerBlend::normal)
      attributes += fmt::format(" style=\"mix-blend-mode:{}\"", blends[static_cast<std::size_t>(l.blend)]);
    out +=
        fmt::format("  <g id=\"{}\" opacity=\"{}\"{}>\n", id, short_number(l.opacity.pieces[0].begin[0]), attributes);
    animate(l.opacity, "opacity", "    ", out, [](const KeyValue& v) { return short_number(v[0]); });
    add_layer(film, static_cast<std::int32_t>(k), depth, out);
    out += "  </g>\n";
  }

  double share(Time t) const { return clock_.share(t); }

  void add_background(int width, int height, std::string& out) const {
    const std::vector<Vec3> stops = planar_background(program_, options_);
    if (stops.empty()) return;
    std::string fill = svg_color(to_srgb(stops[0]));
    if (stops.size() > 1) {
      out += "  <defs><linearGradient id=\".background\" x2=\"0\" y2=\"1\">";
      for (std::size_t i = 0; i < stops.size(); ++i)
        out += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>",
                           short_number(static_cast<double>(i) / static_cast<double>(stops.size() - 1)),
                           svg_color(to_srgb(stops[i])));
      out += "</linearGradient></defs>\n";
      fill = "url(#.background)";
    }
    out += fmt::format("  <rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                       short_number(-width / 2.0), short_number(-height / 2.0), width, height, fill);
  }

  void add_thing(const PlanarThing& thing, const Channel& shown, const std::string& id, std::string& out) {
    const PlanarLook& look = thing.look;
    const bool some = !shown.pieces.empty();
    if (some) {
      out += fmt::format("  <g opacity=\"{}\">\n", shown.pieces[0].begin[0]);
      animate(shown, "opacity", "    ", out, [](const KeyValue& v) { return short_number(v[0]); });
    }
    out += fmt::format("  <g id=\"{}\" opacity=\"{}\"{}>\n", id, short_number(look.opacity.pieces[0].begin[0]),
                       rest(thing.motion.steps));
    add_steps(thing.motion.steps, "    ", out);
    animate(look.opacity, "opacity", "    ", out, [](const KeyValue& v) { return short_number(v[0]); });
    fill_paint_ = stroke_paint_ = "";
    if (look.fill_gradient) fill_paint_ = add_gradient(*look.fill_gradient, "." + id + ".fill", clock_, pixels_, out);
    if (look.stroke_gradient)
      stroke_paint_ = add_gradient(*look.stroke_gradient, "." + id + ".stroke", clock_, pixels_, out);
    add_filled(look.filled, look.color, fill_paint_, out);
    add_filled(look.bordered, look.stroke, stroke_paint_, out);
    add_stroked(look, out);
    out += "  </g>\n";
    if (some) out += "  </g>\n";
  }

  void add_filled(const PlanarForms& forms, const Channel& color, const std::string& paint, std::string& out) {
    if (forms.empty()) return;
    out += fmt::format("    <path d=\"{}\" fill=\"{}\">\n", path_of(forms[0].parts),
                       paint.empty() ? svg_color(color.pieces[0].begin) : paint);
    animate_forms(forms, out, [&](const PlanarForm& f) { return path_of(f.parts); });
    if (paint.empty()) animate(color, "fill", "      ", out, [](const KeyValue& v) { return svg_color(v); });
    out += "    </path>\n";
  }

  // Each trimmed line is a path of its own, since the dashes of a path continue from one line to the next.
  void add_stroked(const PlanarLook& look, std::string& out) {
    if (look.stroked.empty()) return;
    if (!look.trim)
      return add_lines(
          look, "", "", [&](const PlanarForm& f) { return path_of(f.parts); }, out);
    std::size_t lines = 0;
    for (const PlanarForm& f : look.stroked) lines = std::max(lines, f.parts.size());
    const PlanarCurves length = length_of(*look.trim);
    std::string inside = displayed(length, false);
    if (!constant(length))
      inside += animation("stroke-dasharray", length, [](double v) { return short_number(std::max(0.0, v)) + " 2"; });
    if (!constant(look.trim->from))
      inside += animation("stroke-dashoffset", look.trim->from, [](double v) { return short_number(-v); });
    const std::string cut =
        fmt::format(" pathLength=\"1\" stroke-dasharray=\"{} 2\" stroke-dashoffset=\"{}\"",
                    short_number(std::max(0.0, length[0].begin)), short_number(-look.trim->from[0].begin));
    const auto is_whole = [](const PlanarCurve& c) { return c.shape == PlanarCurve::held && c.begin >= 1 - 1e-9; };
    const bool whole = std::any_of(length.begin(), length.end(), is_whole);
    for (std::size_t line = 0; line < lines; ++line) {
      const auto written = [&](const PlanarForm& f) {
        return line < f.parts.size() ? path_of({f.parts[line]}) : std::string();
      };
      add_lines(look, cut, inside, written, out);
      // A dash has ends, and a closed line has none.
      const auto& parts = look.stroked[0].parts;
      if (whole && line < parts.size() && parts[line].closed)
        add_lines(look, "", displayed(length, true), written, out);
    }
  }
  template <class F>
  void add_lines(const PlanarLook& look, const std::string& attributes, const std::string& inside, F written,
                 std::string& out) {
    out += fmt::format("    <path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}{}{}>\n",
                       written(look.stroked[0]),
                       stroke_paint_.empty() ? svg_color(look.stroke.pieces[0].begin) : stroke_paint_,
                       look.hairline ? short_number(hairline) : short_number(look.width.pieces[0].begin[0] * pixels_),
                       look.round ? " stroke-linecap=\"round\" stroke-linejoin=\"round\"" : "",
                       look.hairline ? " vector-effect=\"non-scaling-stroke\"" : "", attributes);
    animate_forms(look.stroked, out, written);
    if (stroke_paint_.empty())
      animate(look.stroke, "stroke", "      ", out, [](const KeyValue& v) { return svg_color(v); });
    if (!look.hairline)
      animate(look.width, "stroke-width", "      ", out,
              [this](const KeyValue& v) { return short_number(v[0] * pixels_); });
    out += inside + "    </path>\n";
  }

  // The visible part of a line is a single dash.
  PlanarCurves length_of(const PlanarTrim& trim) const {
    PlanarCurves length;
    if (constant(trim.from)) {
      length = trim.to;
      for (PlanarCurve& c : length) c.begin -= trim.from[0].begin, c.end -= trim.from[0].begin;
      return length;
    }
    if (constant(trim.to)) {
      length = trim.from;
      for (PlanarCurve& c : length) c.begin = trim.to[0].begin - c.begin, c.end = trim.to[0].begin - c.end;
      return length;
    }
    // If both ends move: linear from frame to frame.
    std::vector<Time> knots;
    for (const PlanarCurves* curves : {&trim.from, &trim.to})
      for (const PlanarCurve& c : *curves) knots.push_back(c.from), knots.push_back(c.until);
    const std::int64_t whole = (options_.until - options_.from).flicks, frames = static_cast<std::int64_t>(frames_);
    for (std::int64_t i = 0; i <= frames; ++i) knots.push_back({options_.from.flicks + whole / frames * i});
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    const auto at = [&](Time t) { return value_at(trim.to, t) - value_at(trim.from, t); };
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const double begin = at(knots[i]), end = at({knots[i + 1].flicks - 1});
      length.push_back({begin == end ? PlanarCurve::held : PlanarCurve::straight, knots[i], knots[i + 1], begin, end});
    }
    if (length.empty()) length.push_back({PlanarCurve::held, options_.from, options_.until, at(options_.from), 0});
    return length;
  }

  // When a line is visible: while it has a length, since a dash of length 0 still has round ends; or while it is whole.
  std::string displayed(const PlanarCurves& length, bool whole) const {
    constexpr double nothing = 1e-9, a_moment = 1e-7;
    std::string times, values;
    const auto add = [&](double at, bool seen) {
      const char *word = seen ? "inline" : "none", *between = times.empty() ? "" : ";";
      if (values.ends_with(word)) return;
      times += fmt::format("{}{:.9g}", between, at), values += between, values += word;
    };
    for (const PlanarCurve& c : length) {
      const double from = times.empty() ? 0 : share(c.from);
      if (whole) {
        add(from, c.shape == PlanarCurve::held && c.begin >= 1 - nothing);
        continue;
      }
      add(from, c.begin > nothing);
      if (c.begin <= nothing && c.end > nothing) add(std::min(1.0, from + a_moment), true);
    }
    if (values == "inline") return "";
    return fmt::format(
        "      <animate attributeName=\"display\" dur=\"{}s\" fill=\"freeze\" calcMode=\"discrete\" keyTimes=\"{}\" "
        "values=\"{}\"/>\n",
        short_number(std::max(seconds_, 1e-9)), times, values);
  }

  std::string path_of(const std::vector<DrawnPart>& parts) const {
    std::string d;
    for (const DrawnPart& part : parts) {
      char command = 'M';
      for (const Vec3 p : part.points)
        d += fmt::format("{}{} {}", std::exchange(command, 'L'), coordinate(p.x * pixels_), coordinate(-p.y * pixels_));
      if (part.closed && !part.points.empty()) d += 'Z';
    }
    return d;
  }
  static std::string coordinate(double v) {
    std::string s = fmt::format("{:.4f}", v);
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
    return s == "-0" ? "0" : s;
  }

  void count(std::size_t keys) { ++made_.channels, made_.keys += keys, made_.baked += frames_; }

  template <class F>
  void animate_forms(const PlanarForms& forms, std::string& out, F written) {
    if (forms.size() < 2) return;
    const bool steps = std::none_of(forms.begin(), forms.end(), [](const PlanarForm& f) { return f.goes_on; });
    std::string times, values;
    const auto add = [&](double at, const std::string& d) {
      if (!times.empty()) times += ';', values += ';';
      // An empty path, which would be an error elsewhere.
      times += fmt::format("{:.9g}", at), values += d.empty() ? "M0 0" : d;
    };
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const std::string d = written(forms[i]);
      add(i == 0 ? 0 : share(forms[i].from), d);
      const bool last = i + 1 == forms.size();
      if (!steps && (last || !forms[i].goes_on)) add(last ? 1 : share(forms[i + 1].from), d);
    }
    count(forms.size());
    out += fmt::format(
        "      <animate attributeName=\"d\" dur=\"{}s\" fill=\"freeze\" calcMode=\"{}\" keyTimes=\"{}\" "
        "values=\"{}\"/>\n",
        short_number(std::max(seconds_, 1e-9)), steps ? "discrete" : "linear", times, values);
  }

  template <class F>
  void animate(const Channel& c, std::string_view attribute, std::string_view indent, std::string& out, F value) {
    clock_.animate(c, attribute, indent, out, value);
  }

  template <class F>
  std::string animation(std::string_view attribute, const PlanarCurves& curves, F value) {
    return fmt::format("      <animate attributeName=\"{}\" {}/>\n", attribute, keys_of(curves, value));
  }
  // A repeated time is a jump; a held piece has a key at its end.
  template <class F>
  std::string keys_of(const PlanarCurves& curves, F value) {
    std::string times, values, splines;
    for (const PlanarCurve& c : curves) {
      const bool first = times.empty();
      for (const auto& [at, v] : {std::pair(c.from, c.begin), std::pair(c.until, c.end)}) {
        if (!times.empty()) times += ';', values += ';';
        times += fmt::format("{:.9g}", share(at)), values += value(v);
      }
      if (!first) splines += "0 0 1 1;";  // from one piece to the next: no time
      splines += c.shape == PlanarCurve::cubic ? fmt::format("{} {} {} {};", short_number(c.x1), short_number(c.y1),
                                                             short_number(c.x2), short_number(c.y2))
                                               : "0 0 1 1;";
    }
    splines.pop_back();
    if (!constant(curves)) count(curves.size() + 1);
    return fmt::format(
        "dur=\"{}s\" fill=\"freeze\" calcMode=\"spline\" keyTimes=\"{}\" values=\"{}\" keySplines=\"{}\"",
        short_number(std::max(seconds_, 1e-9)), times, values, splines);
  }

  // The first animation replaces the transform at rest, the others are added to it.
  void add_steps(const std::vector<PlanarStep>& steps, std::string_view indent, std::string& out) {
    if (std::all_of(steps.begin(), steps.end(), [](const PlanarStep& s) { return constant(s.curves); })) return;
    constexpr std::string_view types[] = {"translate", "translate", "rotate", "scale", "scale"};
    for (const PlanarStep& step : steps)
      out += fmt::format("{}<animateTransform attributeName=\"transform\" type=\"{}\" additive=\"{}\" {}/>\n", indent,
                         types[step.what], &step == steps.data() ? "replace" : "sum",
                         keys_of(step.curves, [&](double v) { return argument(step.what, v); }));
  }
  std::string argument(PlanarStep::What what, double v) const {
    const std::string n = short_number(on_page(what, v, pixels_));
    return what == PlanarStep::move_y   ? "0 " + n
           : what == PlanarStep::grow_x ? n + " 1"
           : what == PlanarStep::grow_y ? "1 " + n
                                        : n;
  }
  // The transform at the beginning, for viewers that do not animate.
  std::string rest(const std::vector<PlanarStep>& steps) const {
    constexpr std::string_view functions[] = {"translate({})", "translate({})", "rotate({})", "scale({})", "scale({})"};
    std::string all;
    for (const PlanarStep& step : steps)
      all += (all.empty() ? "" : " ") +
             fmt::format(fmt::runtime(functions[step.what]), argument(step.what, step.curves.front().begin));
    return all.empty() ? "" : fmt::format(" transform=\"{}\"", all);
  }

  const Program& program_;
  const ExportOptions& options_;
  Exported& made_;
  const SvgClock clock_;
  const double seconds_;
  const std::size_t frames_;
  double pixels_ = 1;
  SvgPage page_;
  PlanarLayers layers_;
  std::vector<std::string> names_;  // of the things, then of the layers
  std::set<std::int32_t> writing_;  // layers whose masks are being written
  std::size_t groups_ = 0;
  std::vector<std::size_t> copies_;        // of each name that are written
  std::string fill_paint_, stroke_paint_;  // of the present thing: "" for its plain colours
};

}  // namespace

Result<std::string> make_svg(const Program& program, const ExportOptions& options, Exported& made) {
  return SvgMaker(program, options, made).make();
}

}  // namespace betwixt
