// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "track/turns.h"

namespace betwixt {
namespace {

thread_local TwerperFailures* listening = nullptr;
thread_local bool all_linear = false;

using Numbers = std::array<double, 4>;

bool all_angles(const Track& track) {
  bool all = true;
  track.events.each([&](const Event& e) {
    all = all && (e.keep || std::holds_alternative<Angles>(e.value));
    if (e.detail && e.detail->before) all = all && std::holds_alternative<Angles>(*e.detail->before);
  });
  return all;
}

// Returns whether an event's detail has nothing but a twerper's arguments.
bool only_arguments(const EventDetail& d) {
  EventDetail bare;
  bare.arguments = d.arguments;
  return d == bare;
}

// Returns the numbers of a value in the form of a curve.
Numbers compiled(const Value& v, const Curve& c, Type type) {
  Numbers n{};
  if (c.orientation) {
    if (const auto* a = std::get_if<Angles>(&v)) {
      store(from_angles(a->xyz), n.data());
      return n;
    }
  }
  to_numbers(v, n.data());
  if (row_of(type).light && !c.srgb)
    for (double& x : n) x = to_linear(x);
  return n;
}

// For a track that repeats with equal ends: copies its last event but one before the first, and the second behind
// the last.
void join_ends(CurveColumns& all, Curve& c) {
  const std::size_t n = c.channels;
  all.values.resize(all.values.size() + n);
  double *first = &all.values[c.values], *last = first + (c.count - 1) * n;
  const auto cut = [&](std::uint32_t event) {
    return std::any_of(all.details.begin(), all.details.end(),
                       [&](const CurveDetail& d) { return d.event == event && d.cut; });
  };
  if (c.count < 3 || cut(c.first) || cut(c.first + c.count - 1)) return;
  const bool opposite = c.orientation && dot(quat(first), quat(last)) < 0;
  for (std::size_t i = 0; i < n; ++i)  // a whole turn is not exactly zero in doubles
    if (std::abs(last[i] - (opposite ? -first[i] : first[i])) > (c.orientation ? 1e-12 : 0)) return;
  for (std::size_t i = 0; i < n; ++i) {
    (first - n)[i] = opposite ? -(last - n)[i] : (last - n)[i];
    (last + n)[i] = opposite ? -(first + n)[i] : (first + n)[i];
  }
  c.seamless = true;
}

}  // namespace

Twerper resolve(const Track& track, const Event& e, Type type, bool orientation) {
  Twerper t = track.global != Twerper::unset ? track.global : e.twerper;
  if (t == Twerper::unset) t = orientation ? Twerper::slerp : row_of(type).twerper;
  const bool matches = type == Type::text && !is_own(t) && row_of(t).matches;
  if (row_of(type).changes == Changes::in_steps && !matches) t = Twerper::hold;
  if (is_own(t)) return t;
  const Twerper other = orientation ? row_of(t).for_orientations : row_of(t).for_numbers;
  return other == Twerper::unset ? t : other;
}

double eased(double u, const CurveDetail* from, const CurveDetail* to, double h) {
  const double out = from ? from->ease_out / h : 0, in = to ? to->ease_in / h : 0;
  return out > 0 || in > 0 ? ease(u, out, in) : u;
}

std::int64_t fold(std::int64_t t, std::int64_t first, std::int64_t last, bool bounce) {
  const std::int64_t period = last - first;
  if (period <= 0) return first;
  std::int64_t cycle = (t - first) / period, rest = (t - first) % period;
  if (rest < 0) rest += period, --cycle;
  return bounce && (cycle & 1) ? last - rest : first + rest;
}

TwerperFailures::TwerperFailures() : outer_(std::exchange(listening, this)) {}
TwerperFailures::~TwerperFailures() { listening = outer_; }
void TwerperFailures::say(std::size_t twerper, const Error& why) {
  if (listening) listening->all.emplace(twerper, why);
}

LinearTwerpers::LinearTwerpers() : outer_(std::exchange(all_linear, true)) {}
LinearTwerpers::~LinearTwerpers() { all_linear = outer_; }

std::shared_ptr<const Ease> ease_with(Twerper t, const Ease::Arguments& arguments) {
  if (is_own(t) || row_of(t).arguments.empty()) return nullptr;
  if (t == Twerper::bezier) return bezier_ease(arguments);
  return std::make_shared<const Ease>(row_of(t).factor, arguments, row_of(t).costly);
}

Curve CurveSet::add(const Track& track, Type type, bool component) {
  if (!open_) columns_.push_back(open_ = std::make_shared<CurveColumns>());
  CurveColumns& all = *open_;
  Curve c;
  c.columns = open_.get();
  c.first = static_cast<std::uint32_t>(all.times.size());
  c.values = static_cast<std::uint32_t>(all.values.size());
  c.orientation = type == Type::orientation || (type == Type::rotation && !all_angles(track));
  const int numbers = c.orientation ? 4 : number_count(type);
  c.channels = static_cast<std::uint8_t>(component ? 1 : numbers);
  c.srgb = track.srgb && row_of(type).light;
  c.before = track.before, c.after = track.after;
  const auto first_detail = all.details.size();
  const bool cyclic = c.before == Extrapolation::cycle || c.after == Extrapolation::cycle;
  if (cyclic) {  // reserve a place for the event before the first one, across the seam
    all.values.resize(all.values.size() + c.channels);
    c.values += c.channels;
  }
  std::vector<std::uint32_t> kept;  // events that only change the twerper

  std::shared_ptr<const Ease> last_ease;

  const auto push = [&](const Event& e, const Numbers& n) {
    const auto index = static_cast<std::uint32_t>(all.times.size());
    all.times.push_back(e.time.flicks);
    all.values.insert(all.values.end(), n.begin(), n.begin() + c.channels);
    const Twerper t = resolve(track, e, type, c.orientation);
    all.twerpers.push_back(static_cast<std::uint8_t>(t));
    const bool of_all = track.global != Twerper::unset && track.arguments != TwerperArguments{};
    const TwerperArguments& arguments = track.global != Twerper::unset ? track.arguments : e.detail->arguments;
    if (takes_arguments(t)) {
      if (!last_ease || last_ease->arguments() != static_cast<const Ease::Arguments&>(arguments))
        last_ease = ease_with(t, arguments);
      if (all.curves.empty() || all.curves.back() != last_ease) all.curves.push_back(last_ease);
      all.eases.resize(index + 1);
      all.eases.back() = static_cast<std::uint32_t>(all.curves.size() - 1);
    }
    if (!e.detail && !of_all) return;
    if (t == Twerper::bezier && only_arguments(*e.detail)) return;
    CurveDetail d;
    d.event = index;
    d.ease_in = static_cast<double>(e.detail->ease_in.flicks);
    d.ease_out = static_cast<double>(e.detail->ease_out.flicks);
    d.arguments = arguments;
    if (e.detail->before) d.cut = true, d.before = compiled(*e.detail->before, c, type);
    const auto tangent = [&](const std::optional<Value>& said, bool& has, Numbers& rate) {
      if (!said || (c.orientation && !std::holds_alternative<Quat>(*said))) return;  // skip angles among orientations
      has = true, rate = compiled(*said, c, type);
    };
    tangent(e.detail->tangent_in, d.has_in, d.tangent_in);
    tangent(e.detail->tangent_out, d.has_out, d.tangent_out);
    if (d.has_in && e.detail->handle_in) d.handle_in = static_cast<double>(e.detail->handle_in->flicks);
    if (d.has_out && e.detail->handle_out) d.handle_out = static_cast<double>(e.detail->handle_out->flicks);
    all.details.push_back(d);
  };

  bool any_kept = false;
  track.events.each([&](const Event& e) { any_kept = any_kept || e.keep; });
  if (any_kept) {
    // The curve through the events with values gives the value of those with `keep`.
    Track valued = track;
    std::vector<Time> without;
    track.events.each([&](const Event& e) {
      if (e.keep) without.push_back(e.time);
    });
    for (Time t : without) valued.events.erase(t, t);
    CurveSet set;
    Curve through = valued.events.empty() ? Curve{} : set.add(valued, type, component);
    through.srgb = false;  // columns have sRGB numbers
    track.events.each([&](const Event& e) {
      if (!e.keep) return push(e, compiled(e.value, c, type));
      if (through.count == 0) return;
      Numbers n{};
      set.evaluate(through, e.time, n.data());
      push(e, n);
    });
  } else {
    track.events.each([&](const Event& e) { push(e, compiled(e.value, c, type)); });
  }
  c.count = static_cast<std::uint32_t>(all.times.size()) - c.first;
  if (c.orientation) {  // q and -q are one orientation: each key gets the sign nearer to the one before
    auto d = all.details.begin() + static_cast<std::ptrdiff_t>(first_detail);
    Quat last;
    for (std::uint32_t k = 0; k < c.count; ++k) {
      double* v = &all.values[c.values + 4 * k];
      const auto take_sign = [&](double* key, double* tangent) {
        if (k > 0 && dot(last, quat(key)) < 0) store(-quat(key), key), store(-quat(tangent), tangent);
        last = quat(key);
      };
      CurveDetail none;
      CurveDetail& here = d != all.details.end() && d->event == c.first + k ? *d++ : none;
      // The values before and after the cut.
      if (here.cut) take_sign(here.before.data(), here.tangent_in.data());
      const Quat said = quat(v);
      take_sign(v, here.tangent_out.data());
      if (!here.cut && dot(said, last) < 0) store(-quat(here.tangent_in.data()), here.tangent_in.data());
    }
  }
  if (cyclic) join_ends(all, c);
  c.detailed = all.details.size() > first_detail;
  return c;
}

const Ease* CurveColumns::ease(std::uint32_t event) const {
  const auto t = static_cast<Twerper>(twerpers[event]);
  if (is_own(t)) return nullptr;
  return takes_arguments(t) ? curves[eases[event]].get() : ease_of(t);
}

// A twerper of the author's gets the eased time, like all others. If it fails, it counts as linear.
double CurveSet::factor(Twerper t, double s, const Ease* ease, const Stops* stops) const {
  if (ease) return ease->at(s);
  if (!is_own(t)) return stops ? through(*stops, s) : s;
  const auto i = static_cast<std::size_t>(t) - first_own_twerper;
  if (all_linear || i >= own.size() || !own[i]) return s;
  const auto f = own[i]->blend(s);
  if (f && std::isfinite(*f)) return *f;
  TwerperFailures::say(i, f ? fail(ErrorCode::range, "it returned a number that is not finite") : f.error());
  return s;
}

std::shared_ptr<const CurveColumns> CurveSet::end_columns() { return std::exchange(open_, nullptr); }

void CurveSet::share(std::shared_ptr<const CurveColumns> columns) { columns_.push_back(std::move(columns)); }

const CurveDetail* CurveSet::detail(const Curve& c, std::uint32_t k) {
  if (!c.detailed) return nullptr;
  const auto& details = c.columns->details;
  const auto at = std::lower_bound(details.begin(), details.end(), c.first + k,
                                   [](const CurveDetail& d, std::uint32_t e) { return d.event < e; });
  return at != details.end() && at->event == c.first + k ? &*at : nullptr;
}

// Returns the blend between events k and k + 1, without s.
Blend CurveSet::blend(const Curve& c, std::uint32_t k) const {
  const std::uint32_t n = c.channels;
  const std::int64_t* time = &c.columns->times[c.first];
  const auto twerper_of = [&](std::uint32_t i) { return static_cast<Twerper>(c.columns->twerpers[c.first + i]); };
  const CurveDetail *here = detail(c, k), *next = detail(c, k + 1);
  Blend g;
  g.channels = n;
  g.from = &c.columns->values[c.values + n * k];
  g.to = next && next->cut ? next->before.data() : g.from + n;
  g.length = g.length_before = g.length_after = static_cast<double>(time[k + 1] - time[k]);
  // There are no neighbours across a cut, a hold or the track's end.
  const std::uint32_t last = c.count - 1;
  if (k > 0 && !(here && here->cut) && twerper_of(k - 1) != Twerper::hold) {
    g.before = g.from - n;
    g.length_before = static_cast<double>(time[k] - time[k - 1]);
  } else if (k == 0 && c.seamless && twerper_of(last - 1) != Twerper::hold) {
    g.before = g.from - n;  // the columns have the copy there
    g.length_before = static_cast<double>(time[last] - time[last - 1]);
  }
  if (k + 2 < c.count && !(next && next->cut) && twerper_of(k + 1) != Twerper::hold) {
    const CurveDetail* after = detail(c, k + 2);
    g.after = after && after->cut ? after->before.data() : g.from + 2 * n;
    g.length_after = static_cast<double>(time[k + 2] - time[k + 1]);
  } else if (k + 1 == last && c.seamless && twerper_of(0) != Twerper::hold) {
    g.after = g.to + n;
    g.length_after = static_cast<double>(time[1] - time[0]);
  }
  const bool handle_out = here && here->handle_out >= 0, handle_in = next && next->handle_in >= 0;
  if (here && here->has_out) (handle_out ? g.handle_out : g.tangent_out) = here->tangent_out.data();
  if (next && next->has_in) (handle_in ? g.handle_in : g.tangent_in) = next->tangent_in.data();
  if (handle_out) g.handle_out_length = here->handle_out;
  if (handle_in) g.handle_in_length = next->handle_in;
  return g;
}

// Evaluates `since` flicks after event k.
void CurveSet::segment(const Curve& c, std::uint32_t k, double since, double* out) const {
  const auto twerper = static_cast<Twerper>(c.columns->twerpers[c.first + k]);
  Blend g = blend(c, k);
  if (twerper == Twerper::hold) {
    std::copy_n(g.from, g.channels, out);
    return;
  }
  const CurveDetail* here = detail(c, k);
  g.s = eased(since / g.length, here, detail(c, k + 1), g.length);
  const TwerperRow* row = is_own(twerper) ? nullptr : &row_of(twerper);
  if (row && c.orientation && row->turn) return store(row->turn(g), out);
  if (row && !c.orientation && row->cubics) {
    Cubic cubics[4];
    row->cubics(g, cubics);
    for (std::uint32_t i = 0; i < g.channels; ++i) out[i] = cubics[i].at(g.s);
    return;
  }
  if (row && !c.orientation && row->numbers) return row->numbers(g, out);
  const double s = factor(twerper, g.s, c.columns->ease(c.first + k),
                          here ? here->arguments.stops.get() : nullptr);  // the ends and a factor are enough
  if (c.orientation) return store(slerp(quat(g.from), quat(g.to), s), out);
  for (std::uint32_t i = 0; i < g.channels; ++i) out[i] = g.from[i] + s * (g.to[i] - g.from[i]);
}

// Evaluates in the form of the columns.
void CurveSet::find(const Curve& c, std::int64_t t, double* out) const {
  const std::int64_t *first = &c.columns->times[c.first], *last = first + c.count - 1;
  if (t < *first || t > *last || (t == *last && c.after == Extrapolation::cycle && c.count > 1)) {
    const bool after = t >= *last;
    const Extrapolation how = after ? c.after : c.before;
    if (how == Extrapolation::cycle || how == Extrapolation::bounce) {
      t = fold(t, *first, *last, how == Extrapolation::bounce);
    } else {
      // With a cut at an end, the value outside is constant.
      const CurveDetail* end = detail(c, (after ? c.count - 1 : 0));
      const bool cut = end && end->cut;
      if (how == Extrapolation::linear && c.count > 1 && !cut)
        return beyond(c, after, static_cast<double>(t - (after ? *last : *first)), out);
      const double* value = &c.columns->values[c.values + (after ? c.count - 1 : 0) * c.channels];
      std::copy_n(cut && !after ? end->before.data() : value, c.channels, out);
      return;
    }
  }
  const std::uint32_t k = t == *last ? c.count - 1 : CurveEvents::before(first, c.count, t, 0);
  if (k + 1 == c.count)
    std::copy_n(&c.columns->values[c.values + k * c.channels], c.channels, out);
  else
    segment(c, k, static_cast<double>(t - first[k]), out);
}

bool CurveSet::runs_code(const Curve& c, Time time) {
  const std::int64_t *first = &c.columns->times[c.first], *last = first + c.count - 1;
  std::int64_t t = time.flicks;
  const auto own = [&](std::uint32_t k) { return is_own(static_cast<Twerper>(c.columns->twerpers[c.first + k])); };
  if (t < *first || t >= *last) {
    const Extrapolation how = t < *first ? c.before : c.after;
    if (how == Extrapolation::hold || c.count < 2) return false;
    if (how == Extrapolation::linear) return own(t < *first ? 0 : c.count - 2);
    t = fold(t, *first, *last, how == Extrapolation::bounce);
    if (t >= *last) return false;
  }
  return own(CurveEvents::before(first, c.count, t, 0));
}

void CurveSet::evaluate(const Curve& c, Time time, double* out) const {
  find(c, time.flicks, out);
  if (c.srgb)
    for (int i = 0; i < c.channels; ++i) out[i] = to_linear(out[i]);
}

void add_activity(std::vector<Activity>& out, std::size_t first, Activity run) {
  if (out.size() > first && out.back().until >= run.from)
    out.back().until = std::max(out.back().until, run.until);
  else
    out.push_back(run);
}

// Returns whether a segment is constant from its first moment to just before its last.
bool CurveSet::still(const Curve& c, std::uint32_t k) const {
  const auto twerper = static_cast<Twerper>(c.columns->twerpers[c.first + k]);
  if (twerper == Twerper::hold) return true;
  if (is_own(twerper) || c.orientation || row_of(twerper).cubics || row_of(twerper).numbers) return false;
  const CurveDetail* next = detail(c, k + 1);
  const double* from = &c.columns->values[c.values + k * c.channels];
  return std::equal(from, from + c.channels, next && next->cut ? next->before.data() : from + c.channels);
}

void CurveSet::activities(const Curve& c, std::vector<Activity>& out) const {
  const std::size_t first = out.size();
  const std::int64_t* time = &c.columns->times[c.first];
  const auto cut = [&](std::uint32_t k) {
    const CurveDetail* d = detail(c, k);
    return d && d->cut;
  };
  const bool goes_on = c.count > 1;
  if (goes_on && c.before != Extrapolation::hold) add_activity(out, first, {INT64_MIN, time[0]});
  if (cut(0)) add_activity(out, first, {time[0], time[0]});
  for (std::uint32_t k = 0; k + 1 < c.count; ++k) {
    if (!still(c, k))
      add_activity(out, first, {time[k], time[k + 1]});
    else if (static_cast<Twerper>(c.columns->twerpers[c.first + k]) == Twerper::hold || cut(k + 1))
      add_activity(out, first, {time[k + 1], time[k + 1]});
  }
  if (goes_on && c.after != Extrapolation::hold) add_activity(out, first, {time[c.count - 1], INT64_MAX});
}

std::size_t CurveSet::bytes() const {
  std::size_t sum = 0;
  for (const auto& c : columns_)
    sum += c->times.size() * sizeof(c->times[0]) + c->values.size() * sizeof(double) + c->twerpers.size() +
           c->details.size() * sizeof(CurveDetail) + c->eases.size() * sizeof(c->eases[0]) +
           c->curves.size() * sizeof(c->curves[0]);
  return sum;
}

}  // namespace betwixt
