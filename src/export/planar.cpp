// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/planar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "betwixt/object.h"
#include "betwixt/track.h"
#include "export/fit.h"
#include "scene/functions.h"

namespace betwixt {
namespace {

// A cubic by its values and derivatives per second at both ends.
struct Hermite {
  Time from, until;
  double begin, end, leaving, arriving;

  double seconds() const { return (until - from).seconds(); }
  double at(double u) const {
    const double a = leaving * seconds(), b = arriving * seconds(), d = end - begin;
    return begin + u * (a + u * (3 * d - 2 * a - b + u * (a + b - 2 * d)));
  }
  double rate(double u) const {
    const double a = leaving * seconds(), b = arriving * seconds(), d = end - begin;
    return (a + u * (2 * (3 * d - 2 * a - b) + u * 3 * (a + b - 2 * d))) / seconds();
  }
  // Returns the turning points between its ends.
  std::vector<double> turning() const {
    const double a = leaving * seconds(), b = arriving * seconds(), d = end - begin;
    const double q2 = 3 * (a + b - 2 * d), q1 = 2 * (3 * d - 2 * a - b), root = q1 * q1 - 4 * q2 * a;
    std::vector<double> out;
    const auto add = [&out](double u) {
      if (u > 1e-6 && u < 1 - 1e-6) out.push_back(u);
    };
    if (std::abs(q2) < 1e-12 * std::abs(q1))
      add(-a / q1);
    else if (root > 0)
      add((-q1 - std::sqrt(root)) / (2 * q2)), add((-q1 + std::sqrt(root)) / (2 * q2));
    std::sort(out.begin(), out.end());
    return out;
  }
};

// A Bezier curve with equal ends is constant, and one with nearly equal ends is steep, which players with few
// digits show badly. Such a cubic is cut at its turning points.
constexpr double steep = 0.25;  // of the range of its values
void add_cubic(const Hermite& h, bool in_unit, int depth, PlanarCurves& out) {
  const double seconds = h.seconds(), d = h.end - h.begin;
  double low = std::min(h.begin, h.end), high = std::max(h.begin, h.end);
  const std::vector<double> turning = h.turning();
  for (const double u : turning) low = std::min(low, h.at(u)), high = std::max(high, h.at(u));
  if (high - low < 1e-12 * (1 + std::abs(high))) {
    out.push_back({PlanarCurve::held, h.from, h.until, h.begin, h.begin});
    return;
  }
  const double y1 = h.leaving * seconds / (3 * d), y2 = 1 - h.arriving * seconds / (3 * d);
  const auto small = [](double y) { return y >= -1e-9 && y <= 1 + 1e-9; };
  const bool goes = std::abs(d) > steep * (high - low) && (!in_unit || (small(y1) && small(y2)));
  if (goes || depth == 0) {
    if (std::abs(d) > steep * (high - low))
      out.push_back({PlanarCurve::cubic, h.from, h.until, h.begin, h.end, in_unit ? std::clamp(y1, 0.0, 1.0) : y1,
                     in_unit ? std::clamp(y2, 0.0, 1.0) : y2});
    else
      out.push_back({PlanarCurve::straight, h.from, h.until, h.begin, h.end});
    return;
  }
  const double u = turning.empty() ? 0.5 : turning[turning.size() / 2];
  const Time middle{h.from.flicks + std::llround(u * static_cast<double>((h.until - h.from).flicks))};
  if (middle <= h.from || middle >= h.until) return add_cubic(h, in_unit, 0, out);
  add_cubic({h.from, middle, h.begin, h.at(u), h.leaving, h.rate(u)}, in_unit, depth - 1, out);
  add_cubic({middle, h.until, h.at(u), h.end, h.rate(u), h.arriving}, in_unit, depth - 1, out);
}

// Evaluates a Bezier curve from 0 to 1.
double bezier_at(double u, double a, double b) {
  const double v = 1 - u;
  return 3 * v * v * u * a + 3 * v * u * u * b + u * u * u;
}

double curve_at(const PlanarCurve& c, Time t) {
  if (c.shape == PlanarCurve::held || c.until <= c.from) return c.begin;
  const double s = std::clamp((t - c.from).seconds() / (c.until - c.from).seconds(), 0.0, 1.0);
  if (c.shape == PlanarCurve::straight) return c.begin + s * (c.end - c.begin);
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (bezier_at(middle, c.x1, c.x2) < s ? low : high) = middle;
  }
  return c.begin + bezier_at(low, c.y1, c.y2) * (c.end - c.begin);
}

// Returns the curve of CSS that a row of the script names.
std::optional<std::array<double, 4>> css_curve(const EventView& e) {
  if (e.twerper == "bezier") return e.arguments;
  if (e.twerper == "ease") return {{0.25, 0.1, 0.25, 1}};
  if (e.twerper == "ease-in") return {{0.42, 0, 1, 1}};
  if (e.twerper == "ease-out") return {{0, 0, 0.58, 1}};
  if (e.twerper == "ease-in-out") return {{0.42, 0, 0.58, 1}};
  return std::nullopt;
}

double angle_of(const KeyValue& q) { return 2 * std::atan2(q[2], q[3]); }

bool in_plane(const Channel& c) {
  const auto flat = [](const KeyValue& q) { return std::hypot(q[0], q[1]) < 1e-3; };
  return std::all_of(c.pieces.begin(), c.pieces.end(), [&](const KeyPiece& p) { return flat(p.begin) && flat(p.end); });
}

// Follows the angle of rotations in the plane through whole turns: no piece turns by half of one.
class Turning {
 public:
  explicit Turning(const Channel& c) : turns_(c) {
    double angle = 0;
    for (const KeyPiece& p : c.pieces) {
      const double begin = angle_of(p.begin);
      angle = begin + 2 * pi * std::round((angle - begin) / (2 * pi));
      from_.push_back(angle);
      angle += to_half(angle_of(p.end) - begin);
    }
  }
  double at(Time t) const {
    std::size_t i = 0;
    while (i + 1 < turns_.pieces.size() && turns_.pieces[i + 1].from <= t) ++i;
    return from_[i] + to_half(angle_of(betwixt::value_at(turns_, t)) - angle_of(turns_.pieces[i].begin));
  }

 private:
  static double to_half(double a) { return a - 2 * pi * std::round(a / (2 * pi)); }
  const Channel& turns_;
  std::vector<double> from_;
};

class Planar {
 public:
  Planar(const Program& program, const ExportOptions& options, bool in_unit)
      : program_(program), options_(options), in_unit_(in_unit) {
    keys_ = motion_keys(program, options.from, options.until, options.keys);
    for (std::size_t i = 0; i < keys_.size(); ++i) place_[keys_[i].id.index] = i;
  }

  Result<std::vector<PlanarMotion>> all(std::vector<ObjectId>* turned) {
    std::vector<PlanarMotion> out;
    for (const ObjectKeys& k : keys_) {
      if (!wanted(k.id)) continue;
      PlanarMotion m{k.id, {}};
      if (const Status s = add(moved_with(k), m.steps, 0); !s) {
        if (turned == nullptr) return s.error();
        turned->push_back(k.id), m.steps.clear();
      }
      std::erase_if(m.steps, [](const PlanarStep& s) { return s.nothing(); });
      out.push_back(std::move(m));
    }
    return out;
  }

 private:
  bool wanted(ObjectId id) const {
    if (!options_.objects.empty())
      return std::find(options_.objects.begin(), options_.objects.end(), id) != options_.objects.end();
    const Kind what = kind(program_.document(), id);
    return what != Kind::camera && what != Kind::light && what != Kind::sound && what != Kind::group;
  }
  // A trace drawn on an object moves with that.
  const ObjectKeys& moved_with(const ObjectKeys& k) const {
    const auto paper = place_.find(drawn_within(program_, k.id, options_.from).index);
    return paper == place_.end() ? k : keys_[paper->second];
  }

  Status add(const ObjectKeys& k, std::vector<PlanarStep>& to, std::size_t depth) {
    const auto above = k.parent ? place_.find(k.parent.index) : place_.end();
    if (above != place_.end() && depth < 1000)
      if (Status s = add(keys_[above->second], to, depth + 1); !s) return s;
    for (const Channel* c : {&k.rotation, &k.inner})
      if (!c->pieces.empty() && !in_plane(*c))
        return fail(ErrorCode::range,
                    fmt::format("'{}' rotates out of the plane of the picture", program_.document().name(k.id)),
                    "drawings can rotate only about z; glTF (.glb) supports all rotations");
    to.push_back({PlanarStep::move_x, said(k.id, fn::position, 0, planar_curves(k.translation, 0, in_unit_))});
    to.push_back({PlanarStep::move_y, said(k.id, fn::position, 1, planar_curves(k.translation, 1, in_unit_))});
    to.push_back({PlanarStep::turn, angles(k.id, k.rotation)});
    to.push_back({PlanarStep::grow_x, said(k.id, fn::scale, 0, planar_curves(k.scale, 0, in_unit_))});
    to.push_back({PlanarStep::grow_y, said(k.id, fn::scale, 1, planar_curves(k.scale, 1, in_unit_))});
    if (k.sheared) to.push_back({PlanarStep::turn, angles({}, k.inner)});
    return Nothing{};
  }

  // Replaces fitted curves by the curve of CSS that a row names, if both agree (parents and other influences may change
  // the motion).
  PlanarCurves said(ObjectId id, FunctionId f, int component, PlanarCurves curves) const {
    if (constant(curves)) return curves;
    for (const Target& target : {Target{id, f}, Target{id, f, component}}) {
      std::optional<EventView> before;
      each_event(program_.document(), target, options_.from, options_.until, [&](const EventView& e) {
        if (before && before->value && e.value && e.ease_in == Time{} && before->ease_out == Time{})
          if (const auto b = css_curve(*before)) {
            const std::vector<double> from = numbers(*before->value), to = numbers(e.cut_from ? *e.cut_from : *e.value);
            const auto at = static_cast<std::size_t>(from.size() > 1 ? component : 0);
            if (at < from.size() && at < to.size())
              put(curves,
                  {PlanarCurve::cubic, before->time, e.time, from[at], to[at], (*b)[1], (*b)[3], (*b)[0], (*b)[2]});
          }
        before = e;
      });
    }
    return curves;
  }
  void put(PlanarCurves& curves, const PlanarCurve& c) const {
    const auto small = [](double y) { return y >= 0 && y <= 1; };
    if (c.begin == c.end || (in_unit_ && !(small(c.y1) && small(c.y2)))) return;
    for (int i = 0; i < 32; ++i) {
      const Time t{c.from.flicks + (c.until - c.from).flicks / 32 * i};
      if (std::abs(curve_at(c, t) - betwixt::value_at(curves, t)) > 4 * options_.keys.metres) return;
    }
    const auto inside = [&](const PlanarCurve& one) { return one.from >= c.from && one.until <= c.until; };
    const auto first = std::find_if(curves.begin(), curves.end(), inside);
    if (first == curves.end() || first->from != c.from) return;
    auto last = first;
    while (last != curves.end() && inside(*last)) ++last;
    if (std::prev(last)->until != c.until) return;
    *first = c;
    curves.erase(first + 1, last);
  }

  // Returns the angle about z of the author's track, if that is the whole rotation; otherwise the angle of the
  // rotations.
  PlanarCurves angles(ObjectId id, const Channel& turns) {
    const Turning turning(turns);
    if (id && !turns.constant()) {
      const Channel said = value_keys(program_, {id, fn::rotation, 2}, options_.from, options_.until, options_.keys);
      if (!said.pieces.empty() && agree(said, turning))
        return this->said(id, fn::rotation, 2, planar_curves(said, 0, in_unit_));
    }
    std::vector<Time> knots{options_.from, options_.until};
    for (const KeyPiece& p : turns.pieces) knots.push_back(p.from);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    std::erase_if(knots, [&](Time t) { return t < options_.from || t > options_.until; });
    const Followed f = followed(program_.document(), 1, options_.keys.radians, [&](Time t) {
      return KeyValue{turning.at(t), 0, 0, 0};
    });
    return planar_curves(follow(f, knots, options_.keys), 0, in_unit_);
  }
  bool agree(const Channel& said, const Turning& turning) const {
    double apart = 0;
    for (int i = 0; i <= 64; ++i) {
      const Time t{options_.from.flicks + (options_.until - options_.from).flicks / 64 * i};
      const double off = betwixt::value_at(said, t)[0] - turning.at(t);
      apart = std::max(apart, std::abs(off - 2 * pi * std::round(off / (2 * pi))));
    }
    return apart < 4 * options_.keys.radians;
  }

  const Program& program_;
  const ExportOptions& options_;
  const bool in_unit_;
  std::vector<ObjectKeys> keys_;
  std::unordered_map<std::uint32_t, std::size_t> place_;
};

}  // namespace

PlanarCurves planar_curves(const Channel& c, std::size_t component, bool in_unit) {
  PlanarCurves out;
  for (const KeyPiece& p : c.pieces) {
    const double a = p.begin[component], b = p.end[component];
    PlanarCurves here;
    if (p.shape == KeyPiece::cubic)
      add_cubic({p.from, p.until, a, b, p.leaving[component], p.arriving[component]}, in_unit, 24, here);
    else
      here.push_back(
          {p.shape == KeyPiece::held || a == b ? PlanarCurve::held : PlanarCurve::straight, p.from, p.until, a, b});
    for (const PlanarCurve& one : here) {
      const bool goes_on = !out.empty() && one.shape == PlanarCurve::held && out.back().shape == PlanarCurve::held &&
                           out.back().begin == one.begin;
      if (goes_on)
        out.back().until = one.until;
      else
        out.push_back(one);
    }
  }
  return out;
}

PlanarCurves halves(const PlanarCurve& c) {
  const double d = c.end - c.begin, seconds = (c.until - c.from).seconds();
  const Hermite whole{c.from, c.until, c.begin, c.end, 3 * c.y1 * d / seconds, 3 * (1 - c.y2) * d / seconds};
  const Time middle{c.from.flicks + (c.until - c.from).flicks / 2};
  PlanarCurves out;
  add_cubic({c.from, middle, c.begin, whole.at(0.5), whole.leaving, whole.rate(0.5)}, false, 4, out);
  add_cubic({middle, c.until, whole.at(0.5), c.end, whole.rate(0.5), whole.arriving}, false, 4, out);
  return out;
}

double value_at(const PlanarCurves& all, Time t) {
  std::size_t i = 0;
  while (i + 1 < all.size() && all[i + 1].from <= t) ++i;
  return curve_at(all[i], t);
}

bool constant(const PlanarCurves& all) { return all.size() == 1 && all[0].shape == PlanarCurve::held; }

ObjectId drawn_within(const Program& program, ObjectId id, Time t) {
  if (kind(program.document(), id) != Kind::trace) return {};
  const Value v = program.read({id, fn::trace_within}, t);
  const auto* paper = std::get_if<ObjectId>(&v);
  return paper != nullptr ? *paper : ObjectId{};
}

bool PlanarStep::nothing() const {
  return constant(curves) && curves[0].begin == (what == grow_x || what == grow_y ? 1.0 : 0.0);
}

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

Result<std::vector<PlanarMotion>> planar_motions(const Program& program, const ExportOptions& options, bool in_unit,
                                                 std::vector<ObjectId>* out) {
  return Planar(program, options, in_unit).all(out);
}

std::pair<int, int> picture_size(const Document& document) { return document.size().value_or(std::pair(1280, 720)); }

namespace {

Channel straight(const Program& program, const ExportOptions& options, std::size_t width,
                 std::function<KeyValue(Time)> at) {
  KeyOptions keys = options.keys;
  keys.style = KeyStyle::linear;
  const auto knots = knots_between(program.discontinuities(options.from, options.until), options.from, options.until);
  return follow(followed(program.document(), width, 1.0 / 512, std::move(at)), knots, keys);
}

}  // namespace

Channel planar_color(const Program& program, const ExportOptions& options, ObjectId id) {
  return straight(program, options, 3, [&](Time t) {
    const Value v = program.read({id, fn::color}, t);
    const auto* c = std::get_if<Color>(&v);
    return c ? KeyValue{c->r, c->g, c->b, 0} : KeyValue{1, 1, 1, 0};
  });
}

Channel planar_opacity(const Program& program, const ExportOptions& options, ObjectId id) {
  return straight(program, options, 1, [&](Time t) {
    const auto number = [&](FunctionId f) {
      const std::vector<double> n = numbers(program.read({id, f}, t));
      return n.empty() ? 0 : n[0];
    };
    return KeyValue{number(fn::display) != 0 ? 1 - number(fn::transparency) : 0, 0, 0, 0};
  });
}

std::vector<std::string> plain_names(const Document& document, const std::vector<ObjectId>& ids) {
  std::vector<std::string> out;
  std::set<std::string> taken;
  for (const ObjectId id : ids) {
    std::string name(document.name(id));
    std::replace(name.begin(), name.end(), '/', '-');
    std::string one = name;
    for (int n = 2; !taken.insert(one).second; ++n) one = fmt::format("{}-{}", name, n);
    out.push_back(std::move(one));
  }
  return out;
}

std::string short_number(double v) {
  std::string s = fmt::format("{:.7f}", v);
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

}  // namespace betwixt
