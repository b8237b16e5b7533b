// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A flat film as Lottie: a layer with its shape for each object, below layers without shapes if one is not enough for
// its motion. Each number has curves of its own.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "export/fit.h"
#include "export/formats.h"
#include "export/lottie_values.h"
#include "export/planar_look.h"
#include "export/seen.h"
#include "track/track.h"

namespace betwixt {
namespace lottie {
namespace {

class LottieMaker {
 public:
  LottieMaker(const Program& program, const ExportOptions& options, Exported& made)
      : program_(program), options_(options), made_(made), rate_(program.document().rate().per_second()) {
    const auto [width, height] = picture_size(program.document());
    width_ = width, height_ = height;
    frames_ = std::max(1.0, std::round((options.until - options.from).seconds() * rate_) + 1);
  }

  Result<std::string> make() {
    const auto film = planar_film(program_, options_, made_);
    if (!film) return film.error();
    pixels_ = height_ / film->view.height;
    std::vector<Json> back_to_front;
    std::vector<Json> seen_by;
    if (!film->view.steps.empty()) {
      seen_by = layers(film->view.steps, "camera", 0, true);
      camera_ = number_;
    }
    for (const PlanarPlace& place : film->order) {
      const PlanarThing& thing = film->things[place.thing];
      if (place.first && !thing.look.stroked.empty() && stretched(thing.motion.steps))
        leave_out(
            made_,
            fmt::format("the stroke of '{}' is stretched: lottie-web shows that, rlottie draws it with an even width",
                        program_.document().name(thing.motion.id)));
      for (Json& layer : layers_of(thing, place.shown)) back_to_front.push_back(std::move(layer));
    }
    // The first layer is in front.
    auto in_order = Json::array();
    for (auto one = back_to_front.rbegin(); one != back_to_front.rend(); ++one) in_order.push_back(std::move(*one));
    for (Json& layer : seen_by) in_order.push_back(std::move(layer));
    if (const auto stops = planar_background(program_, options_); !stops.empty()) in_order.push_back(backdrop(stops));
    const Json file{{"v", "5.7.4"}, {"fr", rate_},  {"ip", 0},  {"op", frames_},           {"w", width_},
                    {"h", height_}, {"nm", "film"}, {"ddd", 0}, {"assets", Json::array()}, {"layers", in_order}};
    return file.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  static constexpr double apart = 1e-4;    // frames: the duration of a jump, since no two keys have one time
  static constexpr double hairline = 1.4;  // pixels, as in the film

  double frame(Time t) const { return (t - options_.from).seconds() * rate_; }

  // rlottie distinguishes curves by two digits of their handles only, and reuses earlier curves that look equal. If
  // that would be visible, the curve is split. `unit`: pixels, degrees or percent for 1 of the number.
  void tell_apart(const PlanarCurve& c, double unit, int depth, PlanarCurves& out) {
    const bool even = std::abs(c.x1 - 1.0 / 3) < 1e-9 && std::abs(c.x2 - 2.0 / 3) < 1e-9;
    if (c.shape != PlanarCurve::cubic || !even) return out.push_back(c);
    const auto two_digits = [](double y) { return std::lround(100 * y); };
    const auto [known, fresh] = handles_.try_emplace({two_digits(c.y1), two_digits(c.y2)}, std::pair(c.y1, c.y2));
    const double off = std::max(std::abs(known->second.first - c.y1), std::abs(known->second.second - c.y2));
    if (fresh || depth == 0 || 0.45 * off * unit * std::abs(c.end - c.begin) < 0.01) return out.push_back(c);
    for (const PlanarCurve& half : halves(c)) tell_apart(half, unit, depth - 1, out);
  }

  // Converts the curves of a number with `value`.
  template <class F>
  Json moving(const PlanarCurves& exact, double unit, F value) {
    if (constant(exact)) return still(value(exact[0].begin));
    PlanarCurves curves;
    for (const PlanarCurve& c : exact) tell_apart(c, unit, 6, curves);
    auto keys = Json::array();
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const PlanarCurve& c = curves[i];
      keys.push_back(key(frame(c.from), listed(value(c.begin)), &c));
      const bool last = i + 1 == curves.size(), jumps = !last && curves[i + 1].begin != c.end;
      PlanarCurve wait;
      if (jumps && c.shape != PlanarCurve::held)
        keys.push_back(key(frame(c.until) - apart, listed(value(c.end)), &wait));
      if (last) keys.push_back(key(frame(c.until), listed(value(c.end)), nullptr));
    }
    ++made_.channels;
    made_.keys += keys.size(), made_.baked += static_cast<std::size_t>(frames_);
    return {{"a", 1}, {"k", std::move(keys)}};
  }

  // What one layer can hold: a translation, then a rotation, then a scaling.
  struct Link {
    const PlanarStep* steps[5]{};
  };

  Json transform(const Link& link, bool outermost) {
    const auto number = [&](PlanarStep::What what, double scale, double plus) {
      const PlanarStep* s = link.steps[what];
      return s ? moving(s->curves, std::abs(scale), [=](double v) { return Json(scale * v + plus); }) : still(plus);
    };
    Json ks;
    ks["o"] = still(100);
    ks["r"] = number(PlanarStep::turn, -180 / pi, 0);
    ks["p"] = {{"s", true},
               {"x", number(PlanarStep::move_x, pixels_, outermost ? width_ / 2.0 : 0)},
               {"y", number(PlanarStep::move_y, -pixels_, outermost ? height_ / 2.0 : 0)}};
    ks["a"] = still({0, 0});
    const PlanarStep *x = link.steps[PlanarStep::grow_x], *y = link.steps[PlanarStep::grow_y];
    const double other = x && constant(x->curves)   ? x->curves[0].begin
                         : y && constant(y->curves) ? y->curves[0].begin
                                                    : 1;
    if (x && !constant(x->curves))
      ks["s"] = moving(x->curves, 100, [&](double v) { return Json{100 * v, 100 * (y ? other : 1)}; });
    else if (y && !constant(y->curves))
      ks["s"] = moving(y->curves, 100, [&](double v) { return Json{100 * (x ? other : 1), 100 * v}; });
    else
      ks["s"] = still({100 * (x ? x->curves[0].begin : 1), 100 * (y ? y->curves[0].begin : 1)});
    return ks;
  }

  // Returns whether the scale is not uniform at some time.
  bool stretched(const std::vector<PlanarStep>& steps) const {
    for (int i = 0; i <= 64; ++i) {
      const Time t{options_.from.flicks + (options_.until - options_.from).flicks / 64 * i};
      double x = 1, y = 1;
      for (const PlanarStep& s : steps) {
        if (s.what == PlanarStep::grow_x) x *= value_at(s.curves, t);
        if (s.what == PlanarStep::grow_y) y *= value_at(s.curves, t);
      }
      if (std::abs(x - y) > 0.02 * std::max(std::abs(x), std::abs(y))) return true;
    }
    return false;
  }

  // Makes layers for the steps, the outermost one first. Each is the child of the one before; the parent of the first
  // is `above` (0: the picture). The last one has the shape, unless all of them only move.
  std::vector<Json> layers(const std::vector<PlanarStep>& steps, const std::string& name, int above, bool move_only) {
    std::vector<Link> links(1);
    for (const PlanarStep& s : steps) {
      Link& last = links.back();
      bool free = true;
      for (int i = s.what; i < 5; ++i) free = free && !last.steps[i];
      // Two scalings that vary need two layers, since each has times of its own.
      if (s.what == PlanarStep::grow_y && last.steps[PlanarStep::grow_x])
        free = free && (constant(s.curves) || constant(last.steps[PlanarStep::grow_x]->curves));
      if (!free) links.emplace_back();
      links.back().steps[s.what] = &s;
    }
    std::vector<Json> out;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const bool draws = i + 1 == links.size() && !move_only;
      Json layer = plain(draws ? name : name + " moves", draws ? 4 : 3);
      const int hangs_on = i > 0 ? number_ - 1 : above;
      if (hangs_on > 0) layer["parent"] = hangs_on;
      layer["ks"] = transform(links[i], hangs_on == 0);
      out.push_back(std::move(layer));
    }
    return out;
  }
  std::vector<Json> layers_of(const PlanarThing& thing, const Channel& shown) {
    std::vector<Json> out =
        layers(thing.motion.steps, std::string(program_.document().name(thing.motion.id)), camera_, false);
    out.back()["ks"]["o"] = moving(planar_curves(thing.look.opacity, 0), 100, [](double v) { return Json(100 * v); });
    Json drawn = shapes(thing.look);
    if (!shown.pieces.empty()) {
      Json whole = group(std::move(drawn));
      whole["it"].back()["o"] = moving(planar_curves(shown, 0), 100, [](double v) { return Json(100 * v); });
      drawn = Json::array({std::move(whole)});
    }
    out.back()["shapes"] = std::move(drawn);
    return out;
  }
  Json plain(const std::string& name, int type) {
    return {{"ddd", 0}, {"ind", ++number_}, {"ty", type}, {"nm", name}, {"sr", 1},
            {"ip", 0},  {"op", frames_},    {"st", 0},    {"bm", 0}};
  }

  // Returns a key's outline with as many points as `most`; the last one is repeated.
  Json path(const DrawnPart* part, std::size_t most) const {
    auto v = Json::array(), zero = Json::array();
    for (std::size_t i = 0; i < most; ++i) {
      const bool there = part != nullptr && !part->points.empty();
      const Vec3 p = there ? part->points[std::min(i, part->points.size() - 1)] : Vec3{};
      v.push_back({rounded(p.x * pixels_), rounded(-p.y * pixels_)}), zero.push_back({0, 0});
    }
    return {{"c", part == nullptr || part->closed}, {"v", v}, {"i", zero}, {"o", zero}};
  }

  // Adds a path for each part. If their number varies, surplus ones are single points, which draw nothing.
  void add_paths(const PlanarForms& forms, Json& items) {
    std::vector<std::size_t> most;
    for (const PlanarForm& f : forms)
      for (std::size_t i = 0; i < f.parts.size(); ++i) {
        if (i == most.size()) most.push_back(0);
        most[i] = std::max(most[i], f.parts[i].points.size());
      }
    for (std::size_t i = 0; i < most.size(); ++i) {
      const auto at = [&](const PlanarForm& f) { return path(i < f.parts.size() ? &f.parts[i] : nullptr, most[i]); };
      if (forms.size() == 1) {
        items.push_back({{"ty", "sh"}, {"ks", still(at(forms[0]))}});
        continue;
      }
      auto keys = Json::array();
      double last = -1;
      for (std::size_t k = 0; k < forms.size(); ++k) {
        PlanarCurve way;
        way.shape = forms[k].goes_on ? PlanarCurve::straight : PlanarCurve::held;
        last = std::max(k == 0 ? 0 : frame(forms[k].from), last + apart);
        const bool ends = k + 1 == forms.size();
        keys.push_back(key(last, Json::array({at(forms[k])}), &way));
        if (ends) keys.push_back(key(std::max(frames_, last + apart), Json::array({at(forms[k])}), nullptr));
      }
      items.push_back({{"ty", "sh"}, {"ks", {{"a", 1}, {"k", std::move(keys)}}}});
    }
    if (forms.size() > 1)
      ++made_.channels, made_.keys += forms.size(), made_.baked += static_cast<std::size_t>(frames_);
  }
  // If parts exist at some times only, they are in a group that is visible then, since surplus points would have round
  // ends.
  Channel there(const PlanarForms& forms) const {
    Channel out{1, false, {}};
    for (std::size_t k = 0; k < forms.size(); ++k) {
      const double v = forms[k].parts.empty() ? 0 : 1;
      const Time from = k == 0 ? options_.from : forms[k].from,
                 until = k + 1 < forms.size() ? forms[k + 1].from : options_.until;
      if (!out.pieces.empty() && out.pieces.back().begin[0] == v)
        out.pieces.back().until = until;
      else
        out.pieces.push_back({KeyPiece::held, from, until, {v}, {v}, {}, {}});
    }
    return out;
  }
  // The front comes first: strokes.
  Json shapes(const PlanarLook& look) {
    auto out = Json::array();
    if (!look.stroked.empty()) {
      auto items = Json::array();
      add_paths(look.stroked, items);
      if (look.trim) {
        const auto percent = [](double v) { return Json(100 * v); };
        items.push_back({{"ty", "tm"},
                         {"s", moving(look.trim->from, 100, percent)},
                         {"e", moving(look.trim->to, 100, percent)},
                         {"o", still(0)},
                         {"m", 1}});
      }
      Json stroke = painted(look.stroke_gradient, look.stroke, "st");
      const Json width =
          look.hairline ? still(hairline)
                        : moving(planar_curves(look.width, 0), pixels_, [this](double v) { return Json(v * pixels_); });
      stroke.update(
          {{"o", still(100)}, {"w", width}, {"lc", look.round ? 2 : 1}, {"lj", look.round ? 2 : 1}, {"ml", 4}});
      items.push_back(std::move(stroke));
      Json whole = group(std::move(items));
      if (const Channel seen = there(look.stroked); !seen.constant())
        whole["it"].back()["o"] = moving(planar_curves(seen, 0), 100, [](double v) { return Json(100 * v); });
      out.push_back(std::move(whole));
    }
    for (const auto& [forms, color, gradient] : {std::tuple(&look.bordered, &look.stroke, &look.stroke_gradient),
                                                 std::tuple(&look.filled, &look.color, &look.fill_gradient)}) {
      if (forms->empty()) continue;
      auto items = Json::array();
      add_paths(*forms, items);
      Json fill = painted(*gradient, *color, "fl");
      fill.update({{"o", still(100)}, {"r", 1}});
      items.push_back(std::move(fill));
      out.push_back(group(std::move(items)));
    }
    return out;
  }
  // Returns a fill or a stroke (`plain`: fl or st) with its colour or its gradient.
  Json painted(const std::optional<PlanarGradient>& g, const Channel& color, const std::string& plain) {
    const auto value = [](const KeyValue& v) { return Json{v[0], v[1], v[2], 1}; };
    if (!g) return {{"ty", plain}, {"c", keyed(color, value)}};
    const bool linear = g->kind == GradientKind::linear;
    const auto at = [&](double x, double y) { return Json{rounded(x * pixels_), rounded(-y * pixels_)}; };
    const auto begin = [&](const KeyValue& v) { return at(v[0], v[1]); };
    const auto end = [&](const KeyValue& v) { return linear ? at(v[2], v[3]) : at(v[0] + std::max(v[2], v[3]), v[1]); };
    if (g->spread != GradientSpread::pad)
      leave_out(made_, "gradients that repeat end with their last colour: Lottie has no others");
    if (const KeyValue v = g->place.pieces[0].begin; !linear && std::abs(v[2] - v[3]) > 1e-3 * std::max(v[2], v[3]))
      leave_out(made_, "radial gradients of objects that are not as wide as high are circles: Lottie has no others");
    return {{"ty", plain == "fl" ? "gf" : "gs"},
            {"t", linear ? 1 : 2},
            {"s", keyed(g->place, begin)},
            {"e", keyed(g->place, end)},
            {"g", {{"p", g->stops.size()}, {"k", stops(*g)}}}};
  }
  // All stops are one value: their places and colours, then their places and opacities.
  Json stops(const PlanarGradient& g) {
    std::set<Time> times;
    for (const auto* all : {&g.stops, &g.places})
      for (const Channel& c : *all)
        for (const KeyPiece& p : c.pieces) {
          if (!c.constant()) times.insert(p.from), times.insert({p.until.flicks - 1});
        }
    const auto at = [&](Time t) {
      auto colors = Json::array(), opacities = Json::array();
      for (std::size_t i = 0; i < g.stops.size(); ++i) {
        const KeyValue v = betwixt::value_at(g.stops[i], t);
        const double place = betwixt::value_at(g.places[i], t)[0];
        for (const double number : {place, v[0], v[1], v[2]}) colors.push_back(rounded(number));
        for (const double number : {place, v[3]}) opacities.push_back(rounded(number));
      }
      colors.insert(colors.end(), opacities.begin(), opacities.end());
      return colors;
    };
    if (times.empty()) return still(at(options_.from));
    auto keys = Json::array();
    PlanarCurve way;
    way.shape = PlanarCurve::straight;
    for (const Time t : times) keys.push_back(key(frame(t), at(t), t == *times.rbegin() ? nullptr : &way));
    ++made_.channels;
    made_.keys += keys.size(), made_.baked += static_cast<std::size_t>(frames_);
    return {{"a", 1}, {"k", std::move(keys)}};
  }
  template <class F>
  Json keyed(const Channel& c, F value) {
    if (c.constant()) return still(value(c.pieces[0].begin));
    auto keys = Json::array();
    for (std::size_t i = 0; i < c.pieces.size(); ++i) {
      const KeyPiece& p = c.pieces[i];
      PlanarCurve way{p.shape == KeyPiece::held ? PlanarCurve::held : PlanarCurve::straight, p.from, p.until}, wait;
      keys.push_back(key(frame(p.from), value(p.begin), &way));
      const bool last = i + 1 == c.pieces.size();
      if (last)
        keys.push_back(key(frame(p.until), value(p.end), nullptr));
      else if (p.shape != KeyPiece::held && c.pieces[i + 1].begin != p.end)
        keys.push_back(key(frame(p.until) - apart, value(p.end), &wait));
    }
    ++made_.channels;
    made_.keys += keys.size(), made_.baked += static_cast<std::size_t>(frames_);
    return {{"a", 1}, {"k", std::move(keys)}};
  }

  Json backdrop(const std::vector<Vec3>& stops) {
    Json layer = plain("background", 4);
    layer["ks"] = {
        {"o", still(100)}, {"r", still(0)}, {"p", still({0, 0})}, {"a", still({0, 0})}, {"s", still({100, 100})}};
    const double w = width_, h = height_;
    Json fill;
    if (stops.size() == 1) {
      const Color c = to_srgb(stops[0]);
      fill = {{"ty", "fl"}, {"c", still({c.r, c.g, c.b, 1})}, {"o", still(100)}, {"r", 1}};
    } else {
      auto all = Json::array();
      for (std::size_t i = 0; i < stops.size(); ++i) {
        const Color c = to_srgb(stops[i]);
        for (const double v : {static_cast<double>(i) / static_cast<double>(stops.size() - 1), c.r, c.g, c.b})
          all.push_back(v);
      }
      fill = {{"ty", "gf"},
              {"o", still(100)},
              {"r", 1},
              {"t", 1},
              {"s", still({0, 0})},
              {"e", still({0, h})},
              {"g", {{"p", stops.size()}, {"k", still(all)}}}};
    }
    const DrawnPart whole{{{0, 0, 0}, {w / pixels_, 0, 0}, {w / pixels_, -h / pixels_, 0}, {0, -h / pixels_, 0}}, true};
    layer["shapes"] =
        Json::array({group(Json::array({{{"ty", "sh"}, {"ks", still(path(&whole, 4))}}, std::move(fill)}))});
    return layer;
  }

  const Program& program_;
  const ExportOptions& options_;
  Exported& made_;
  const double rate_;
  int width_ = 0, height_ = 0, number_ = 0, camera_ = 0;
  double frames_ = 1, pixels_ = 1;
  std::map<std::pair<long, long>, std::pair<double, double>> handles_{
      {{33, 67}, {1.0 / 3, 2.0 / 3}}};  // to two digits: those of the first curve
};

}  // namespace
}  // namespace lottie

Result<std::string> make_lottie(const Program& program, const ExportOptions& options, Exported& made) {
  return lottie::LottieMaker(program, options, made).make();
}

}  // namespace betwixt
