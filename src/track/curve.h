// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks compiled for evaluation: columns of times and numbers, many tracks in one set of arrays. Colours are linear
// light here, angles radians, orientations four numbers with signs chosen so that neighbours take the short way (R-T8).
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
  double handle_in = -1, handle_out = -1;  // flicks; the tangents are then differences; below 0: none
  std::array<double, 4> before{}, tangent_in{}, tangent_out{};
};

// The events of some curves. Sets may share them: an edited document's with the one before it.
struct CurveColumns {
  std::vector<std::int64_t> times;
  std::vector<double> values;
  std::vector<std::uint8_t> twerpers;  // of the segment that begins at the event
  std::vector<CurveDetail> details;    // sorted by event
};

struct Curve {
  const CurveColumns* columns = nullptr;
  std::uint32_t first = 0, count = 0;  // events, into the columns
  std::uint32_t values = 0;            // the first one's numbers
  std::uint8_t channels = 1;
  bool orientation = false;
  bool srgb = false;      // the numbers are as written and become light when evaluated
  bool seamless = false;  // it repeats, and comes to where it began: its neighbours are known across the seam
  Extrapolation before = Extrapolation::hold, after = Extrapolation::hold;
};

// Where the events of a curve lie: all there is to know of a plain one, which has no details and no orientations.
struct CurveEvents {
  CurveEvents() = default;
  explicit CurveEvents(const Curve&);
  // Asks the memory in time for what cubic() will read.
  void fetch(std::int64_t t, const CubicSegment& was) const;
  // As CurveSet::cubic(), of a plain curve.
  bool cubic(std::int64_t t, CubicSegment& out) const;
  // The last event at or before t, which is neither before the first one nor at the last. `here`: where to look first.
  static std::uint32_t before(const std::int64_t* times, std::uint32_t count, std::int64_t t, std::uint32_t here);

  const std::int64_t* times = nullptr;
  const double* values = nullptr;
  const std::uint8_t* twerpers = nullptr;
  std::int64_t first = 0, last = 0;
  std::uint32_t count = 0;
  std::uint8_t channels = 0;
  bool plain = false;
};

// Hears, on this thread and while it stands, which twerpers of the author's give no number: the place of each among
// CurveSet::own, and why.
class TwerperFailures {
 public:
  TwerperFailures();
  ~TwerperFailures();
  TwerperFailures(const TwerperFailures&) = delete;
  TwerperFailures& operator=(const TwerperFailures&) = delete;
  static void say(std::size_t twerper, const std::string& why);
  std::map<std::size_t, std::string> all;

 private:
  TwerperFailures* const outer_;
};

class CurveSet {
 public:
  // A track of numbers (not text, names, shapes, points, nor aims at objects) with at least one event that has a value.
  // A rotation track whose values are all Angles is three numbers; otherwise orientations. `component`: the track of
  // one component of the type, numbers as the author writes them.
  Curve add(const Track& track, Type type, bool component = false);
  CurveSet() = default;
  CurveSet(const CurveSet&) = delete;  // curves of both would be added to the same columns
  CurveSet& operator=(const CurveSet&) = delete;
  // The columns of what was added since the last time, where anything was: what comes next lies in others.
  std::shared_ptr<const CurveColumns> end_columns();
  // Curves of another set are of this one too.
  void share(std::shared_ptr<const CurveColumns>);
  // out[0 … channels): the value at t.
  void evaluate(const Curve& curve, Time t, double* out) const;
  // The segment that a time is in; none where there is more to it than a cubic. Its values are those of evaluate().
  bool cubic(const Curve& curve, std::int64_t t, CubicSegment& out) const;
  // Its right-hand rate of change there, per second, of the numbers evaluate() gives; an orientation's is its angular
  // velocity (three numbers, in the axes it is turned in). Exact for polynomials up to the fourth degree. `coming`: the
  // left-hand one.
  void derivative(const Curve& curve, Time t, double* out, bool coming = false) const;
  // When it changes, in the order of time.
  void activities(const Curve& curve, std::vector<Activity>& out) const;
  std::size_t bytes() const;
  std::pair<Time, Time> span(const Curve& c) const {  // of its events
    return {{c.columns->times[c.first]}, {c.columns->times[c.first + c.count - 1]}};
  }
  // The integral of the numbers, in seconds, from one event to a point at or before the next (u = 0 … 1).
  void integrate(const Curve& curve, std::uint32_t k, double u, double* out) const;
  std::int64_t event_time(const Curve& c, std::uint32_t k) const { return c.columns->times[c.first + k]; }
  const double* event_numbers(const Curve& c, std::uint32_t k) const {
    return &c.columns->values[c.values + k * c.channels];
  }

  // How far between its ends a segment's blend is, for a twerper that looks at no more: s is the time with eases in it.
  double factor(Twerper t, double s, const CurveDetail* from) const;

  std::vector<std::shared_ptr<const Routine>> own;  // the document's procedures, for twerpers among them

 private:
  static const CurveDetail* detail(const Curve& c, std::uint32_t k);  // of event k
  bool still(const Curve& c, std::uint32_t k) const;
  Blend blend(const Curve& c, std::uint32_t k) const;
  void segment(const Curve& c, std::uint32_t k, double since, double* out) const;
  void beyond(const Curve& c, bool after, double past, double* out) const;
  void find(const Curve& c, std::int64_t t, double* out) const;

  std::shared_ptr<CurveColumns> open_;
  std::vector<std::shared_ptr<const CurveColumns>> columns_;
};

// What blends from this event on: its twerper or the track's, or what stands for that with orientations or numbers.
Twerper resolve(const Track&, const Event&, Type type, bool orientation);
// The time u of a segment of `h` flicks, 0 to 1, with the eases of its two events in it.
double eased(double u, const CurveDetail* from, const CurveDetail* to, double h);
// A twerper's blending factor: where along [0, 1] the motion is at u, given the eases as fractions of the segment.
// (R-T7)
double ease(double u, double ease_out, double ease_in);
// Where a time outside first..last falls when a track repeats, or goes there and back (bounce).
std::int64_t fold(std::int64_t t, std::int64_t first, std::int64_t last, bool bounce);

// For values that are not numbers: between which two values of a track a time falls, and how far the blend is.
struct Between {
  std::size_t a = 0, b = 0;  // into StepTrack::values()
  double s = 0;
  double eased = 0;      // how far in time, eases in it
  std::size_t key = 0;   // where the segment begins, of the track's
  bool splines = false;  // the blend looks at the neighbours too, where they are alike
};
// What each of four values counts: the one before, a, b, the one after.
struct Weights {
  std::array<std::size_t, 4> values{};
  std::array<double, 4> weights{};
};
class StepTrack {
 public:
  StepTrack(const Track& track, Type type);
  Between at(Time t, const CurveSet& set) const;
  // Of a blend that looks at its neighbours: not at those that are not alike, whatever that means of such values.
  Weights weigh(const Between&, const std::function<bool(const Value&, const Value&)>& alike) const;
  std::span<const Value> values() const { return values_; }
  // As Program::next_change.
  std::optional<Time> next_change(Time t) const;
  void activities(std::vector<Activity>& out) const;  // as a curve's
  std::size_t bytes() const;                          // of what it holds, but for what values hold elsewhere

 private:
  struct Key {
    Time time;
    std::size_t comes_to = 0, goes_on = 0;  // values: the same, but at a cut
    std::uint8_t twerper = 0;
    DetailBox detail;
  };
  std::vector<Key> keys_;
  std::vector<Value> values_;
  Extrapolation before_ = Extrapolation::hold, after_ = Extrapolation::hold;
};

}  // namespace betwixt
