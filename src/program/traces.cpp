// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Traces: the line that a point of an object has drawn by a time. Its positions are sampled once, at each frame and, on
// curves, in between. A query takes part of them and adds the present position. The sample times depend on the document
// alone, so earlier queries do not change a picture's bits.
#include "program/traces.h"

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "betwixt/document.h"
#include "program/placing.h"

namespace betwixt {
namespace {

constexpr int deepest = 7;               // halvings between two frames
constexpr int rough_looks = 64;          // samples for the size of the whole path
constexpr double fineness = 1.0 / 8000;  // of that size: a quarter of a pixel if the path fills a picture 1920 wide
constexpr std::int64_t most_frames = 200'000;  // after these, the line is straight
constexpr std::size_t most_looks = 1'000'000;

}  // namespace

class Tracer {
 public:
  Tracer(const Program::Compiled& compiled, std::uint32_t object) : c_(compiled) {
    Asking asking;
    const auto said = [&](FunctionId f) { return c_.value(c_.find(object, f), {}, asking); };
    const auto number = [&](FunctionId f) {
      double n[4] = {};
      c_.evaluate(c_.find(object, f), {}, asking, n);
      return vec3(n);
    };
    const Binding& of = c_.find(object, fn::trace_of);
    if (of.live >= 0) of_ = &of;
    node_ = node(said(fn::trace_of)), within_ = node(said(fn::trace_within));
    point_ = number(fn::trace_point);
    from_ = from_seconds(number(fn::trace_from).x), until_ = from_seconds(number(fn::trace_until).x);
    last_ = from_seconds(number(fn::trace_last).x);
    const Rate rate = c_.document.scene().rate;
    step_ = std::max<std::int64_t>(1, flicks_per_second * rate.den / rate.num);
  }

  // Returns the points drawn by a time, in world space or in the space of `within`.
  std::vector<Vec3> by(Time t) {
    t = std::min(t, until_);
    const Time first = last_ > Time{} && t - last_ > from_ ? t - last_ : from_;
    if (!draws() || t < first || busy_) return {};
    const Busy busy(busy_);
    extend(t);
    std::vector<Vec3> out;
    auto at = std::upper_bound(looks_.begin(), looks_.end(), first, behind);
    if (at == looks_.begin() || std::prev(at)->time != first)
      out.push_back(place(first));
    else
      out.push_back(std::prev(at)->place);
    for (; at != looks_.end() && at->time <= t; ++at) out.push_back(at->place);
    if (t > first && (looks_.empty() || std::prev(at)->time != t)) out.push_back(place(t));
    return out;
  }
  // Returns true if the line changes just after this time.
  bool goes_on(Time t) const { return draws() && (t < until_ || (last_ > Time{} && t < until_ + last_)); }
  std::int32_t within() const { return within_; }

 private:
  struct Look {
    Time time;
    Vec3 place;
  };

  static bool behind(Time t, const Look& l) { return t < l.time; }

  struct Busy {  // resets the flag on every exit
    bool& on;
    explicit Busy(bool& flag) : on(flag) { on = true; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
    ~Busy() { on = false; }
  };

  std::int32_t node(const Value& v) const {
    const auto* id = std::get_if<ObjectId>(&v);
    if (!id || !find_object(c_.document.scene(), *id) || c_.node_of[id->index] == ObjectId::nothing) return -1;
    return static_cast<std::int32_t>(c_.node_of[id->index]);
  }

  // While code names no object, the line stays where it is.
  Vec3 place(Time t) const {
    Asking asking;
    const std::int32_t drawer = of_ ? node(c_.value(*of_, t, asking)) : node_;
    if (drawer < 0) {
      const auto later = std::upper_bound(looks_.begin(), looks_.end(), t, behind);
      return later == looks_.begin() ? Vec3{} : std::prev(later)->place;
    }
    const Vec3 at = transform_point(placement(c_, static_cast<std::uint32_t>(drawer), t, asking).in_world(), point_);
    if (within_ < 0) return at;
    const auto back = inverse(placement(c_, static_cast<std::uint32_t>(within_), t, asking).in_world());
    return back ? transform_point(*back, at) : Vec3{};
  }

  // Returns the largest permitted deviation of a segment, from the size of the whole path.
  double tolerance() {
    if (tolerance_ >= 0) return tolerance_;
    const Time end = std::clamp(until_, from_, std::max(from_, c_.document.range().second));
    Extent all;
    for (int i = 0; i <= rough_looks; ++i) {
      const Vec3 p = place({from_.flicks + (end.flicks - from_.flicks) / rough_looks * i});
      i == 0 ? void(all = {p, p}) : all.add(p);
    }
    return tolerance_ = std::max(2 * length(all.half()) * fineness, 1e-9);
  }

  // Samples all frames up to a time.
  void extend(Time t) {
    if (looks_.empty()) looks_.push_back({from_, place(from_)});
    while (done_ < most_frames && from_.flicks + (done_ + 1) * step_ <= t.flicks) {
      Cancellation::check();
      const std::size_t known = looks_.size();
      const Time next{from_.flicks + (done_ + 1) * step_};
      try {
        between(looks_.back(), {next, place(next)}, 0);
      } catch (...) {  // cancelled: drops the samples of an unfinished frame, which would differ next time
        looks_.resize(known);
        throw;
      }
      ++done_;
    }
  }
  // Adds the samples between two, and the second. Halves the interval if its middle is off the straight line.
  void between(const Look& a, const Look& b, int depth) {
    const Look middle{{(a.time.flicks + b.time.flicks) / 2}, {}};
    if (depth < deepest && middle.time > a.time && looks_.size() < most_looks) {
      const Vec3 there = place(middle.time), way = b.place - a.place;
      const double along = dot(way, way) > 0 ? std::clamp(dot(there - a.place, way) / dot(way, way), 0.0, 1.0) : 0;
      if (length(there - a.place - along * way) > tolerance()) {
        const Look first = a;  // a copy, because looks_ may reallocate
        between(first, {middle.time, there}, depth + 1);
        return between({middle.time, there}, b, depth + 1);
      }
    }
    looks_.push_back(b);
  }

  const Program::Compiled& c_;
  bool draws() const { return of_ || node_ >= 0; }

  const Binding* of_ = nullptr;  // if code names the object
  std::int32_t node_ = -1, within_ = -1;
  Vec3 point_;
  Time from_, until_, last_;
  std::int64_t step_ = 1, done_ = 0;
  double tolerance_ = -1;
  bool busy_ = false;  // guards against a trace that depends on itself: inside, it has no points
  std::vector<Look> looks_;
};

Tracer& Tracers::of(const Program::Compiled& c, std::uint32_t object) {
  {
    const std::lock_guard lock(in_use);
    if (const auto known = all.find(object); known != all.end()) return *known->second;
  }
  auto made = std::make_shared<Tracer>(c, object);  // the constructor may need another tracer
  const std::lock_guard lock(in_use);
  return *all.emplace(object, std::move(made)).first->second;
}

Points trace(const Program::Compiled& c, std::uint32_t object, Time t, Asking& asking) {
  const std::lock_guard lock(c.caches.tracers.drawing);
  Tracer& all = c.caches.tracers.of(c, object);
  std::vector<Vec3> points = all.by(t);
  asking.work(points.size());
  if (all.within() < 0 || points.empty()) return points;
  const Mat4 paper = placement(c, static_cast<std::uint32_t>(all.within()), t, asking).in_world();
  const auto own = inverse(placement(c, c.node_of[object], t, asking).in_world());
  const Mat4 shown = own ? *own * paper : paper;
  for (Vec3& p : points) p = transform_point(shown, p);
  return points;
}

// Called by the clock: takes no lock that drawing holds.
bool tracing_at(const Program::Compiled& c, Time t) {
  const Scene& scene = c.document.scene();
  return std::any_of(c.drawables.begin(), c.drawables.end(), [&](const Drawable& d) {
    const Node& n = c.nodes[static_cast<std::size_t>(&d - c.drawables.data())];
    return n.kind == Kind::trace && !scene.objects[n.object].removed && c.caches.tracers.of(c, n.object).goes_on(t);
  });
}

}  // namespace betwixt
