// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks compiled for evaluation: columns of times and numbers, many tracks in one set of arrays. Here colours are
// linear light, angles radians, and orientations four numbers with signs chosen so that neighbours take the short way.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "track/activity.h"
#include "track/cubic.h"
#include "track/procedure.h"
#include "track/track.h"
#include "track/twerpers.h"

namespace betwixt {

struct CurveDetail {
  std::uint32_t event = 0;           // index into the columns
  double ease_in = 0, ease_out = 0;  // flicks
  TwerperArguments arguments;
  bool cut = false, has_in = false, has_out = false;
  double handle_in = -1, handle_out = -1;  // flicks; the tangents are then differences; below 0: no handles
  std::array<double, 4> before{}, tangent_in{}, tangent_out{};
};

// Returns the ease of a twerper with arguments, or null.
std::shared_ptr<const Ease> ease_with(Twerper, const Ease::Arguments&);

// The events of some curves. Sets can share them: that of an edited document with the one before.
struct CurveColumns {
  std::vector<std::int64_t> times;
  std::vector<double> values;
  std::vector<std::uint8_t> twerpers;  // of the segment that begins at the event
  std::vector<CurveDetail> details;    // sorted by event; none if only the twerper has arguments, as of bezier
  std::vector<std::uint32_t> eases;    // by event, empty if no twerper has arguments: into `curves`
  std::vector<std::shared_ptr<const Ease>> curves;
  const Ease* ease(std::uint32_t event) const;  // of the segment that begins there; null if it has none
};

struct Curve {
  const CurveColumns* columns = nullptr;
  std::uint32_t first = 0, count = 0;  // events, into the columns
  std::uint32_t values = 0;            // of the first event
  std::uint8_t channels = 1;
  bool orientation = false;
  bool srgb = false;      // the numbers are sRGB, and are converted to light at evaluation
  bool detailed = false;  // it has details
  bool seamless = false;  // it repeats and its ends are equal, so it has neighbours across the seam
  Extrapolation before = Extrapolation::hold, after = Extrapolation::hold;
};

// The events of a curve: all data of a plain curve, which has no details and no orientations.
struct CurveEvents {
  CurveEvents() = default;
  explicit CurveEvents(const Curve&);
  // Finds the segment at a time in three steps, so that many curves can wait for memory at once: each step prefetches
  // what the next one reads. For plain curves, at times that has() says.
  bool has(std::int64_t t) const { return plain && t >= first && t < last; }
  std::uint32_t guess(std::int64_t t, const CubicSegment& was) const;
  std::uint32_t find(std::int64_t t, std::uint32_t guess) const;
  // Like CurveSet::cubic(), for the segment from event k.
  bool cubic(std::uint32_t k, CubicSegment& out) const;
  // Returns the last event at or before t; t is between the first and the last. `here`: where to look first.
  static std::uint32_t before(const std::int64_t* times, std::uint32_t count, std::int64_t t, std::uint32_t here);

  const std::int64_t* times = nullptr;
  const double* values = nullptr;
  const std::uint8_t* twerpers = nullptr;
  const CurveColumns* columns = nullptr;
  std::uint32_t first_event = 0;  // into the columns
  std::int64_t first = 0, last = 0;
  std::uint32_t count = 0;
  std::uint8_t channels = 0;
  bool plain = false;
};

// Receives, on this thread and during its lifetime, which twerpers of the author's return no number: the place of each
// in CurveSet::own, and the reason.
class TwerperFailures {
 public:
  TwerperFailures();
  ~TwerperFailures();
  TwerperFailures(const TwerperFailures&) = delete;
  TwerperFailures& operator=(const TwerperFailures&) = delete;
  static void say(std::size_t twerper, const Error& why);
  std::map<std::size_t, Error> all;

 private:
  TwerperFailures* const outer_;
};

// During its lifetime, the author's twerpers count as linear on this thread, and none of their code runs.
class LinearTwerpers {
 public:
  LinearTwerpers();
  ~LinearTwerpers();
  LinearTwerpers(const LinearTwerpers&) = delete;
  LinearTwerpers& operator=(const LinearTwerpers&) = delete;

 private:
  const bool outer_;
};

class CurveSet {
 public:
  // Adds a track of numbers (not text, names, shapes, points, nor aims at objects) with at least one event that has a
  // value. A rotation track with Angles only has three numbers; otherwise it has orientations. `component`: the track
  // of one component of the type, in the author's numbers.
  Curve add(const Track& track, Type type, bool component = false);
  CurveSet() = default;
  CurveSet(const CurveSet&) = delete;  // both copies would add to the same columns
  CurveSet& operator=(const CurveSet&) = delete;
  // Ends the current columns and returns them, or null if nothing was added. Later curves get columns of their own.
  std::shared_ptr<const CurveColumns> end_columns();
  // Makes curves of another set valid in this one too.
  void share(std::shared_ptr<const CurveColumns>);
  // Sets out[0 … channels) to the value at t.
  void evaluate(const Curve& curve, Time t, double* out) const;
  // Sets `out` to the segment at a time, with the values of evaluate(). Returns false if it is not a cubic.
  bool cubic(const Curve& curve, std::int64_t t, CubicSegment& out) const;
  // Sets `out` to the right-hand derivative, per second, of the numbers of evaluate(). For an orientation it is the
  // angular velocity (three numbers, in the parent's axes). Exact for polynomials up to the fourth degree. `coming`:
  // the left-hand derivative.
  void derivative(const Curve& curve, Time t, double* out, bool coming = false) const;
  // Appends the times in which the curve changes, in order.
  void activities(const Curve& curve, std::vector<Activity>& out) const;
  // Returns true if evaluate() runs a twerper of the author's at t.
  static bool runs_code(const Curve& curve, Time t);
  std::size_t bytes() const;
  std::pair<Time, Time> span(const Curve& c) const {  // of its events
    return {{c.columns->times[c.first]}, {c.columns->times[c.first + c.count - 1]}};
  }
  // Sets `out` to the integral of the numbers, in seconds, from event k to the part u (0 … 1) of its segment.
  void integrate(const Curve& curve, std::uint32_t k, double u, double* out) const;
  std::int64_t event_time(const Curve& c, std::uint32_t k) const { return c.columns->times[c.first + k]; }
  const double* event_numbers(const Curve& c, std::uint32_t k) const {
    return &c.columns->values[c.values + k * c.channels];
  }

  // Returns the blending factor of a segment, for a twerper that uses nothing else; eases are applied to s already.
  double factor(Twerper t, double s, const Ease*, const Stops*) const;

  std::vector<std::shared_ptr<const Routine>> own;  // the document's procedures; twerpers are among them

 private:
  static const CurveDetail* detail(const Curve& c, std::uint32_t k);  // of event k; null if it has none
  bool still(const Curve& c, std::uint32_t k) const;
  Blend blend(const Curve& c, std::uint32_t k) const;
  void segment(const Curve& c, std::uint32_t k, double since, double* out) const;
  void beyond(const Curve& c, bool after, double past, double* out) const;
  void find(const Curve& c, std::int64_t t, double* out) const;

  std::shared_ptr<CurveColumns> open_;
  std::vector<std::shared_ptr<const CurveColumns>> columns_;
};

// Returns the twerper from this event on: its own or the track's, or the one that replaces it for orientations or
// numbers.
Twerper resolve(const Track&, const Event&, Type type, bool orientation);
// Applies the eases of its two events to the time u, 0 to 1, in a segment of `h` flicks.
double eased(double u, const CurveDetail* from, const CurveDetail* to, double h);
// Returns where a time outside first..last falls when a track repeats, or runs to and fro (bounce).
std::int64_t fold(std::int64_t t, std::int64_t first, std::int64_t last, bool bounce);

// For values that are not numbers: the two values of a track around a time, and the fraction between them.
struct Between {
  std::size_t a = 0, b = 0;  // into StepTrack::values()
  double s = 0;
  double eased = 0;      // the share of the time, with eases
  std::size_t key = 0;   // the first key of the segment
  bool splines = false;  // whether the blend uses the neighbours too, if they are compatible
};
// The weights of four values: the one before, a, b, the one after.
struct Weights {
  std::array<std::size_t, 4> values{};
  std::array<double, 4> weights{};
};
class StepTrack {
 public:
  StepTrack(const Track& track, Type type);
  Between at(Time t, const CurveSet& set) const;
  // Returns the weights for a blend that uses the neighbours. Leaves out those that are not `alike`.
  Weights weigh(const Between&, const std::function<bool(const Value&, const Value&)>& alike) const;
  std::span<const Value> values() const { return values_; }
  // Returns true if at() runs a twerper of the author's at t.
  bool runs_code(Time t) const;
  // Returns true if some values blend into the next one.
  bool blends() const;
  // Returns true if a result of at() of an earlier version of the track can be used with this one.
  bool fits(const Between&) const;
  // Like Program::next_change.
  std::optional<Time> next_change(Time t) const;
  void activities(std::vector<Activity>& out) const;  // as of a curve
  std::size_t bytes() const;                          // of its own memory, without that of values

 private:
  struct Key {
    Time time;
    std::size_t comes_to = 0, goes_on = 0;  // values: equal, except at a cut
    std::uint8_t twerper = 0;
    DetailBox detail;
    std::shared_ptr<const Ease> ease = {};  // of a twerper with arguments
  };
  std::int64_t folded(std::int64_t t) const;

  std::vector<Key> keys_;
  std::vector<Value> values_;
  Extrapolation before_ = Extrapolation::hold, after_ = Extrapolation::hold;
};

}  // namespace betwixt
