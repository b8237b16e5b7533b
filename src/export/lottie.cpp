// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A flat film as Lottie: a layer with its shape for each object, below layers without one where it takes several to
// say what moves it. Each number has curves of its own.
#include <cmath>
#include <map>

#include "export/formats.h"
#include "export/json.h"
#include "export/planar.h"
#include "track/track.h"

namespace betwixt {
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
    const auto view = planar_view(program_, options_);
    if (!view) return view.error();
    pixels_ = height_ / view->height;
    const auto motions = planar_motions(program_, options_, *view);
    if (!motions) return motions.error();
    std::vector<std::pair<double, std::vector<Json>>> all;
    for (const PlanarMotion& m : *motions) {
      const auto look = planar_look(program_, options_, m.id);
      if (!look) return look.error();
      all.emplace_back(look->z, layers(m, *look));
    }
    made_.objects = motions->size();
    // The first layer is in front.
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    auto in_order = Json::array();
    for (auto one = all.rbegin(); one != all.rend(); ++one)
      for (Json& layer : one->second) in_order.push_back(std::move(layer));
    if (const auto background = planar_background(program_, options_)) in_order.push_back(backdrop(*background));
    const Json file{{"v", "5.7.4"}, {"fr", rate_},  {"ip", 0},  {"op", frames_},           {"w", width_},
                    {"h", height_}, {"nm", "film"}, {"ddd", 0}, {"assets", Json::array()}, {"layers", in_order}};
    return file.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  double frame(Time t) const { return (t - options_.from).seconds() * rate_; }

  static Json still(Json v) { return {{"a", 0}, {"k", std::move(v)}}; }
  static Json key(double at, Json value, const PlanarCurve* c) {
    Json k{{"t", at}, {"s", std::move(value)}};
    if (!c) return k;
    if (c->shape == PlanarCurve::held) {
      k["h"] = 1;
      return k;
    }
    const auto handle = [](double x, double y) { return Json{{"x", {x}}, {"y", {y}}}; };
    k["o"] = handle(c->x1, c->shape == PlanarCurve::cubic ? c->y1 : 1.0 / 3);
    k["i"] = handle(c->x2, c->shape == PlanarCurve::cubic ? c->y2 : 2.0 / 3);
    return k;
  }
  // rlottie knows a curve by two digits of its handles, and takes what it has seen before for what looks the same so.
  // Where that would be seen, a curve is two. `unit`: how many pixels, degrees or hundredths the number's 1 is.
  void tell_apart(const PlanarCurve& c, double unit, int depth, PlanarCurves& out) {
    const bool even = std::abs(c.x1 - 1.0 / 3) < 1e-9 && std::abs(c.x2 - 2.0 / 3) < 1e-9;
    if (c.shape != PlanarCurve::cubic || !even) return out.push_back(c);
    const auto two_digits = [](double y) { return std::lround(100 * y); };
    const auto [known, fresh] = handles_.try_emplace({two_digits(c.y1), two_digits(c.y2)}, std::pair(c.y1, c.y2));
    const double off = std::max(std::abs(known->second.first - c.y1), std::abs(known->second.second - c.y2));
    if (fresh || depth == 0 || 0.45 * off * unit * std::abs(c.end - c.begin) < 0.01) return out.push_back(c);
    for (const PlanarCurve& half : halves(c)) tell_apart(half, unit, depth - 1, out);
  }

  // As `value` has it of the number.
  template <class F>
  Json moving(const PlanarCurves& exact, double unit, F value) {
    if (constant(exact)) return still(value(exact[0].begin));
    PlanarCurves curves;
    for (const PlanarCurve& c : exact) tell_apart(c, unit, 6, curves);
    constexpr double apart = 1e-4;  // frames: a jump takes that long, as no two keys have one time
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
  static Json listed(Json v) { return v.is_array() ? v : Json::array({std::move(v)}); }

  // What one layer can say: a way, then a turn, then a growth.
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

  // From the inside out; each but the last one has the next one as its parent.
  std::vector<Json> layers(const PlanarMotion& m, const PlanarLook& look) {
    std::vector<Link> links(1);
    for (const PlanarStep& s : m.steps) {
      Link& last = links.back();
      bool free = true;
      for (int i = s.what; i < 5; ++i) free = free && !last.steps[i];
      // Two growths that vary take two layers, as each has times of its own.
      if (s.what == PlanarStep::grow_y && last.steps[PlanarStep::grow_x])
        free = free && (constant(s.curves) || constant(last.steps[PlanarStep::grow_x]->curves));
      if (!free) links.emplace_back();
      links.back().steps[s.what] = &s;
    }
    std::vector<Json> out;
    const std::string name = program_.document().name(m.id);
    for (std::size_t i = links.size(); i-- > 0;) {
      Json layer = plain(out.empty() ? name : name + " moves", out.empty() ? 4 : 3);
      if (i > 0) layer["parent"] = number_ + 1;
      layer["ks"] = transform(links[i], i == 0);
      if (out.empty()) {
        layer["ks"]["o"] = moving(planar_curves(planar_opacity(program_, options_, m.id), 0), 100,
                                  [](double v) { return Json(100 * v); });
        layer["shapes"] = shapes(m.id, look);
      }
      out.push_back(std::move(layer));
    }
    return out;
  }
  Json plain(const std::string& name, int type) {
    return {{"ddd", 0}, {"ind", ++number_}, {"ty", type}, {"nm", name}, {"sr", 1},
            {"ip", 0},  {"op", frames_},    {"st", 0},    {"bm", 0}};
  }

  Json path(const std::vector<Vec3>& points, bool closed) const {
    auto v = Json::array(), zero = Json::array();
    for (const Vec3 p : points) v.push_back({p.x * pixels_, -p.y * pixels_}), zero.push_back({0, 0});
    return {{"ty", "sh"}, {"ks", still({{"c", closed}, {"v", v}, {"i", zero}, {"o", zero}})}};
  }
  static Json group(Json items) {
    items.push_back({{"ty", "tr"},
                     {"p", still({0, 0})},
                     {"a", still({0, 0})},
                     {"s", still({100, 100})},
                     {"r", still(0)},
                     {"o", still(100)}});
    return {{"ty", "gr"}, {"it", std::move(items)}};
  }
  static Json color(Vec3 light) {
    const Color c = to_srgb(light);
    return {c.r, c.g, c.b, 1};
  }

  // What is in front stands first: strokes.
  Json shapes(ObjectId id, const PlanarLook& look) {
    auto out = Json::array();
    Json own = still(color(look.color));
    if (const Channel varies = planar_color(program_, options_, id); !varies.constant()) own = colors(varies);
    if (!look.stroked.empty()) {
      auto items = Json::array();
      for (const DrawnPart& part : look.stroked) items.push_back(path(part.points, part.closed));
      items.push_back({{"ty", "st"},
                       {"c", look.stroke == look.color ? own : still(color(look.stroke))},
                       {"o", still(100)},
                       {"w", still(look.width * pixels_)},
                       {"lc", look.round ? 2 : 1},
                       {"lj", look.round ? 2 : 1},
                       {"ml", 4}});
      out.push_back(group(std::move(items)));
    }
    if (!look.filled.empty()) {
      auto items = Json::array();
      for (const auto& contour : look.filled) items.push_back(path(contour, true));
      items.push_back({{"ty", "fl"}, {"c", own}, {"o", still(100)}, {"r", 1}});
      out.push_back(group(std::move(items)));
    }
    return out;
  }
  Json colors(const Channel& c) {
    auto keys = Json::array();
    for (const KeyPiece& p : c.pieces) {
      PlanarCurve way{p.shape == KeyPiece::held ? PlanarCurve::held : PlanarCurve::straight, p.from, p.until};
      keys.push_back(key(frame(p.from), {p.begin[0], p.begin[1], p.begin[2], 1}, &way));
    }
    const KeyPiece& last = c.pieces.back();
    keys.push_back(key(frame(last.until), {last.end[0], last.end[1], last.end[2], 1}, nullptr));
    ++made_.channels;
    made_.keys += keys.size(), made_.baked += static_cast<std::size_t>(frames_);
    return {{"a", 1}, {"k", std::move(keys)}};
  }

  Json backdrop(Vec3 light) {
    Json layer = plain("background", 1);
    layer["sw"] = width_, layer["sh"] = height_;
    const Color c = to_srgb(light);
    char hex[8];
    std::snprintf(hex, sizeof hex, "#%02x%02x%02x", static_cast<unsigned>(std::lround(255 * c.r)) & 255,
                  static_cast<unsigned>(std::lround(255 * c.g)) & 255,
                  static_cast<unsigned>(std::lround(255 * c.b)) & 255);
    layer["sc"] = hex;
    layer["ks"] = {
        {"o", still(100)}, {"r", still(0)}, {"p", still({0, 0})}, {"a", still({0, 0})}, {"s", still({100, 100})}};
    return layer;
  }

  const Program& program_;
  const ExportOptions& options_;
  Exported& made_;
  const double rate_;
  int width_ = 0, height_ = 0, number_ = 0;
  double frames_ = 1, pixels_ = 1;
  std::map<std::pair<long, long>, std::pair<double, double>> handles_{
      {{33, 67}, {1.0 / 3, 2.0 / 3}}};  // by two digits: those of the first curve
};

}  // namespace

Result<std::string> make_lottie(const Program& program, const ExportOptions& options, Exported& made) {
  return LottieMaker(program, options, made).make();
}

}  // namespace betwixt
