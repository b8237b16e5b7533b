// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/curve.h"

#include <cmath>
#include <utility>

namespace betwixt {
namespace {

thread_local TwerperFailures* listening = nullptr;

using Numbers = std::array<double, 4>;

Quat quat(const double* v) { return {v[0], v[1], v[2], v[3]}; }
void store(Quat q, double* out) { out[0] = q.w, out[1] = q.x, out[2] = q.y, out[3] = q.z; }

Quat log(Quat q) {  // of a unit quaternion; a pure one comes back
  const double l = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  const double k = l > 1e-12 ? std::atan2(l, q.w) / l : 1;
  return {0, k * q.x, k * q.y, k * q.z};
}
Quat exp(Quat v) {
  const double a = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const double k = a > 1e-12 ? std::sin(a) / a : 1;
  return {std::cos(a), k * v.x, k * v.y, k * v.z};
}
Quat power(Quat q, double s) {
  const Quat l = log(q);
  return exp({0, s * l.x, s * l.y, s * l.z});
}

// What a twerper means for orientations, which have ways of their own.
Twerper for_orientation(Twerper t) {
  switch (t) {
    case Twerper::linear:
      return Twerper::slerp;
    case Twerper::smooth:
      return Twerper::squad;
    default:
      return t;
  }
}

Twerper resolve(const Track& track, const Event& e, Type type, bool orientation) {
  Twerper t = track.global != Twerper::unset ? track.global : e.twerper;
  if (t == Twerper::unset)
    t = orientation ? Twerper::slerp : type == Type::rotation ? Twerper::smooth : default_twerper(type);
  if (type == Type::boolean || type == Type::attachment) t = Twerper::hold;
  if (orientation) return for_orientation(t);
  return t == Twerper::slerp ? Twerper::linear : t == Twerper::squad ? Twerper::smooth : t;
}

bool all_angles(const Track& track) {
  bool all = true;
  track.events.each([&](const Event& e) {
    all = all && (e.keep || std::holds_alternative<Angles>(e.value));
    if (e.detail && e.detail->before) all = all && std::holds_alternative<Angles>(*e.detail->before);
  });
  return all;
}

// The numbers of a value as a curve holds them.
Numbers compiled(const Value& v, const Curve& c, Type type) {
  Numbers n{};
  if (c.orientation) {
    if (const auto* a = std::get_if<Angles>(&v)) {
      store(from_angles(a->xyz), n.data());
      return n;
    }
  }
  to_numbers(v, n.data());
  if (type == Type::color && !c.srgb)
    for (double& x : n) x = to_linear(x);
  return n;
}

// The blending factor at u; a twerper of the author's gets the time with eases in it, like all others. One that errs
// is as good as linear.
double own_factor(const std::vector<std::shared_ptr<const Routine>>& own, Twerper t, double s) {
  const auto i = static_cast<std::size_t>(t) - first_own_twerper;
  if (i >= own.size() || !own[i]) return s;
  const auto f = own[i]->blend(s);
  if (f && std::isfinite(*f)) return *f;
  TwerperFailures::say(i, f ? "it gave a number that is not finite" : f.error().message);
  return s;
}

double segment_factor(Twerper t, double u, const CurveDetail* from, const CurveDetail* to, double h) {
  double s = u;
  const double out = from ? from->ease_out / h : 0, in = to ? to->ease_in / h : 0;
  if (out > 0 || in > 0) s = ease(u, out, in);
  if (t == Twerper::bezier) s = bezier_factor(s, from ? from->bezier : std::array<double, 4>{0.25, 0.1, 0.25, 1});
  return s;
}

}  // namespace

std::int64_t fold(std::int64_t t, std::int64_t first, std::int64_t last, bool bounce) {
  const std::int64_t period = last - first;
  if (period <= 0) return first;
  std::int64_t cycle = (t - first) / period, rest = (t - first) % period;
  if (rest < 0) rest += period, --cycle;
  return bounce && (cycle & 1) ? last - rest : first + rest;
}

TwerperFailures::TwerperFailures() : outer_(std::exchange(listening, this)) {}
TwerperFailures::~TwerperFailures() { listening = outer_; }
void TwerperFailures::say(std::size_t twerper, const std::string& why) {
  if (listening) listening->all.emplace(twerper, why);
}

int channels(Type type) {
  switch (type) {
    case Type::pair:
      return 2;
    case Type::vector:
    case Type::color:
    case Type::aim:
      return 3;
    case Type::rotation:
    case Type::orientation:
      return 4;
    default:
      return 1;
  }
}

bool numeric(const Value& v) {
  return std::holds_alternative<double>(v) || std::holds_alternative<Vec3>(v) || std::holds_alternative<Color>(v) ||
         std::holds_alternative<bool>(v) || std::holds_alternative<Angles>(v) || std::holds_alternative<Quat>(v);
}

int to_numbers(const Value& v, double* out) {
  if (const auto* d = std::get_if<double>(&v)) return out[0] = *d, 1;
  if (const auto* b = std::get_if<bool>(&v)) return out[0] = *b ? 1 : 0, 1;
  if (const auto* p = std::get_if<Vec3>(&v)) return out[0] = p->x, out[1] = p->y, out[2] = p->z, 3;
  if (const auto* c = std::get_if<Color>(&v)) return out[0] = c->r, out[1] = c->g, out[2] = c->b, 3;
  if (const auto* a = std::get_if<Angles>(&v)) return out[0] = a->xyz.x, out[1] = a->xyz.y, out[2] = a->xyz.z, 3;
  if (const auto* q = std::get_if<Quat>(&v)) return store(*q, out), 4;
  return 0;
}

double ease(double u, double a, double b) {
  if (a + b > 1) {
    const double fit = 1 / (a + b);
    a *= fit, b *= fit;
  }
  const double v = 1 / (1 - (a + b) / 2);  // the constant speed in between
  if (u < a) return v * u * u / (2 * a);
  if (u > 1 - b) return 1 - v * (1 - u) * (1 - u) / (2 * b);
  return v * (u - a / 2);
}

double bezier_factor(double u, const std::array<double, 4>& xy) {
  if (u <= 0 || u >= 1) return u;
  const auto at = [](double p, double q, double s) {
    return ((1 - 3 * q + 3 * p) * s + (3 * q - 6 * p)) * s * s + 3 * p * s;
  };
  // x rises over [0, 1] because the language keeps x1 and x2 there: halving always ends.
  double low = 0, high = 1, s = u;
  for (int i = 0; i < 60; ++i) {
    const double x = at(xy[0], xy[2], s);
    if (std::abs(x - u) < 1e-15) break;
    (x < u ? low : high) = s;
    const double slope = 3 * (1 - s) * (1 - s) * xy[0] + 6 * (1 - s) * s * (xy[2] - xy[0]) + 3 * s * s * (1 - xy[2]);
    const double newton = slope > 1e-9 ? s - (x - u) / slope : low;
    s = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return at(xy[1], xy[3], s);
}

Quat slerp(Quat a, Quat b, double s) {
  const double d = dot(a, b);
  if (d > 1 - 1e-12)
    return normalize({a.w + s * (b.w - a.w), a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)});
  const double angle = std::acos(std::max(-1.0, d)), sine = std::sin(angle);
  if (sine < 1e-12) return a;  // opposite signs of one orientation: nothing to turn
  const double p = std::sin((1 - s) * angle) / sine, q = std::sin(s * angle) / sine;
  return {p * a.w + q * b.w, p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z};
}

Curve CurveSet::add(const Track& track, Type type, bool component) {
  Curve c;
  c.first = static_cast<std::uint32_t>(times_.size());
  c.values = static_cast<std::uint32_t>(values_.size());
  c.orientation = type == Type::orientation || (type == Type::rotation && !all_angles(track));
  const int all = type == Type::rotation && !c.orientation ? 3 : channels(type);
  c.channels = static_cast<std::uint8_t>(component ? 1 : all);
  c.srgb = track.srgb && type == Type::color;
  c.before = track.before, c.after = track.after;
  const auto first_detail = details_.size();
  std::vector<std::uint32_t> kept;  // events that only change the twerper

  const auto push = [&](const Event& e, const Numbers& n) {
    const auto index = static_cast<std::uint32_t>(times_.size());
    times_.push_back(e.time.flicks);
    values_.insert(values_.end(), n.begin(), n.begin() + c.channels);
    const Twerper t = resolve(track, e, type, c.orientation);
    twerpers_.push_back(static_cast<std::uint8_t>(t));
    if (!e.detail && !(track.global == Twerper::bezier)) return;
    CurveDetail d;
    d.event = index;
    d.ease_in = static_cast<double>(e.detail->ease_in.flicks);
    d.ease_out = static_cast<double>(e.detail->ease_out.flicks);
    d.bezier = track.global == Twerper::bezier ? track.bezier : e.detail->bezier;
    if (e.detail->before) d.cut = true, d.before = compiled(*e.detail->before, c, type);
    if (e.detail->tangent_in) d.has_in = true, d.tangent_in = compiled(*e.detail->tangent_in, c, type);
    if (e.detail->tangent_out) d.has_out = true, d.tangent_out = compiled(*e.detail->tangent_out, c, type);
    details_.push_back(d);
  };

  bool any_kept = false;
  track.events.each([&](const Event& e) { any_kept = any_kept || e.keep; });
  if (any_kept) {
    // The curve through the events that have values says what the others keep.
    Track valued = track;
    std::vector<Time> without;
    track.events.each([&](const Event& e) {
      if (e.keep) without.push_back(e.time);
    });
    for (Time t : without) valued.events.erase(t, t);
    CurveSet set;
    Curve through = valued.events.empty() ? Curve{} : set.add(valued, type, component);
    through.srgb = false;  // columns hold the numbers as written
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
  c.count = static_cast<std::uint32_t>(times_.size()) - c.first;

  if (c.orientation) {  // q and -q are one orientation: each key takes the sign nearer to the one before it
    auto d = details_.begin() + static_cast<std::ptrdiff_t>(first_detail);
    Quat last;
    for (std::uint32_t k = 0; k < c.count; ++k) {
      double* v = &values_[c.values + 4 * k];
      if (d != details_.end() && d->event == c.first + k) {
        if (d->cut) {
          if (k > 0 && dot(last, quat(d->before.data())) < 0) store(-quat(d->before.data()), d->before.data());
          last = quat(d->before.data());
        }
        ++d;
      }
      if (k > 0 && dot(last, quat(v)) < 0) store(-quat(v), v);
      last = quat(v);
    }
  }
  return c;
}

double CurveSet::factor(Twerper t, double u, const CurveDetail* from, const CurveDetail* to, double h) const {
  const double s = segment_factor(t, u, from, to, h);
  return is_own(t) ? own_factor(own, t, s) : s;
}

const CurveDetail* CurveSet::detail(std::uint32_t event) const {
  if (details_.empty()) return nullptr;
  const auto at = std::lower_bound(details_.begin(), details_.end(), event,
                                   [](const CurveDetail& d, std::uint32_t e) { return d.event < e; });
  return at != details_.end() && at->event == event ? &*at : nullptr;
}

// The segment from event k to event k + 1 (R-T4), `since` flicks after event k.
void CurveSet::segment(const Curve& c, std::uint32_t k, double since, double* out) const {
  const std::uint32_t n = c.channels;
  const std::int64_t* time = &times_[c.first];
  const double* value = &values_[c.values];
  const auto twerper_of = [&](std::uint32_t i) { return static_cast<Twerper>(twerpers_[c.first + i]); };
  const Twerper twerper = twerper_of(k);
  const CurveDetail *here = detail(c.first + k), *next = detail(c.first + k + 1);
  const double* p1 = value + n * k;
  const double* p2 = next && next->cut ? next->before.data() : p1 + n;
  const double h = static_cast<double>(time[k + 1] - time[k]);
  const double u = since / h;
  const double s = factor(twerper, u, here, next, h);

  if (twerper == Twerper::hold) {
    std::copy_n(p1, n, out);
    return;
  }
  if (twerper == Twerper::linear || twerper == Twerper::bezier || is_own(twerper)) {
    if (c.orientation) return store(slerp(quat(p1), quat(p2), s), out);
    for (std::uint32_t i = 0; i < n; ++i) out[i] = p1[i] + s * (p2[i] - p1[i]);
    return;
  }
  if (twerper == Twerper::slerp) return store(slerp(quat(p1), quat(p2), s), out);

  // Neighbours; across a cut, a hold or the track's end they are reflected.
  Numbers p0, p3;
  double h0 = h, h2 = h;
  const bool left = k > 0 && !(here && here->cut) && twerper_of(k - 1) != Twerper::hold;
  const bool right = k + 2 < c.count && !(next && next->cut) && twerper_of(k + 1) != Twerper::hold;
  if (left) {
    std::copy_n(p1 - n, n, p0.begin());
    h0 = static_cast<double>(time[k] - time[k - 1]);
  }
  if (right) {
    const CurveDetail* after = detail(c.first + k + 2);
    std::copy_n(after && after->cut ? after->before.data() : value + n * (k + 2), n, p3.begin());
    h2 = static_cast<double>(time[k + 2] - time[k + 1]);
  }

  if (c.orientation) {
    const Quat q1 = quat(p1), q2 = quat(p2);
    const Quat q0 = left ? quat(p0.data()) : q1 * conjugate(q2) * q1;
    const Quat q3 = right ? quat(p3.data()) : q2 * conjugate(q1) * q2;
    if (twerper == Twerper::bspline) {  // cumulative form: every step's turn, weighted
      const double s2 = s * s, s3 = s2 * s;
      const double b1 = (5 + 3 * s - 3 * s2 + s3) / 6, b2 = (1 + 3 * s + 3 * s2 - 2 * s3) / 6, b3 = s3 / 6;
      return store(
          normalize(q0 * power(conjugate(q0) * q1, b1) * power(conjugate(q1) * q2, b2) * power(conjugate(q2) * q3, b3)),
          out);
    }
    if (twerper == Twerper::squad) {
      const auto control = [](Quat a, Quat b, Quat d) {
        const Quat f = log(conjugate(b) * d), g = log(conjugate(b) * a);
        return b * exp({0, -(f.x + g.x) / 4, -(f.y + g.y) / 4, -(f.z + g.z) / 4});
      };
      return store(
          normalize(slerp(slerp(q1, q2, s), slerp(control(q0, q1, q2), control(q1, q2, q3), s), 2 * s * (1 - s))), out);
    }
    return store(slerp(q1, q2, s * s * (3 - 2 * s)), out);  // hermite: at rest at both ends
  }

  const double seconds = h / static_cast<double>(flicks_per_second);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = left ? p0[i] : 2 * p1[i] - p2[i], b = p1[i], e = p2[i], d = right ? p3[i] : 2 * p2[i] - p1[i];
    if (twerper == Twerper::bspline) {
      const double s2 = s * s, s3 = s2 * s, r = 1 - s;
      out[i] = (r * r * r * a + (3 * s3 - 6 * s2 + 4) * b + (-3 * s3 + 3 * s2 + 3 * s + 1) * e + s3 * d) / 6;
      continue;
    }
    double m1, m2;  // tangents, over the segment
    if (twerper == Twerper::hermite) {
      m1 = here && here->has_out ? here->tangent_out[i] * seconds : 0;
      m2 = next && next->has_in ? next->tangent_in[i] * seconds : 0;
    } else {  // smooth: the tangent of the parabola through three neighbours, in their real times
      const double chord = e - b;
      m1 = ((b - a) * (h / h0) * h + chord * h0) / (h0 + h);
      m2 = (chord * h2 + (d - e) * (h / h2) * h) / (h + h2);
    }
    const double a2 = 3 * (e - b) - 2 * m1 - m2, a3 = m1 + m2 - 2 * (e - b);
    out[i] = ((a3 * s + a2) * s + m1) * s + b;
  }
}

// Beyond the first or last event, `past` flicks from it: the speed that the end segment has there goes on. An
// orientation keeps turning.
void CurveSet::beyond(const Curve& c, bool after, double past, double* out) const {
  const std::uint32_t end = after ? c.count - 1 : 0, k = after ? end - 1 : 0, n = c.channels;
  const double* value = &values_[c.values + end * n];
  const double h = static_cast<double>(times_[c.first + k + 1] - times_[c.first + k]);
  const auto twerper = static_cast<Twerper>(twerpers_[c.first + k]);
  std::copy_n(value, n, out);
  if (twerper == Twerper::hold) return;
  const CurveDetail *from = detail(c.first + k), *to = detail(c.first + k + 1);
  const bool plain = (twerper == Twerper::linear || twerper == Twerper::slerp) && !(from && from->ease_out > 0) &&
                     !(to && to->ease_in > 0);
  if (plain) return segment(c, k, after ? h + past : past, out);  // exact

  // The slope by a formula that is exact for parabolas, eases among them.
  const double step = (after ? -1 : 1) * h / 4096, origin = after ? h : 0;
  Numbers one{}, two{};
  segment(c, k, origin + step, one.data());
  segment(c, k, origin + 2 * step, two.data());
  if (c.orientation) {
    const Quat a = log(conjugate(quat(value)) * quat(one.data())), b = log(conjugate(quat(value)) * quat(two.data()));
    const double f = past / (2 * step);
    return store(quat(value) * exp({0, f * (4 * a.x - b.x), f * (4 * a.y - b.y), f * (4 * a.z - b.z)}), out);
  }
  for (std::uint32_t i = 0; i < n; ++i) out[i] += (-3 * value[i] + 4 * one[i] - two[i]) / (2 * step) * past;
}

// The numbers as the columns hold them.
void CurveSet::find(const Curve& c, std::int64_t t, double* out) const {
  const std::int64_t *first = &times_[c.first], *last = first + c.count - 1;
  if (t < *first || t > *last) {
    const bool after = t > *last;
    const Extend how = after ? c.after : c.before;
    if (how == Extend::cycle || how == Extend::bounce) {
      t = fold(t, *first, *last, how == Extend::bounce);
    } else {
      // A cut at an end leaves one value outside it, and no slope.
      const CurveDetail* end = detail(c.first + (after ? c.count - 1 : 0));
      const bool cut = end && end->cut;
      if (how == Extend::linear && c.count > 1 && !cut)
        return beyond(c, after, static_cast<double>(t - (after ? *last : *first)), out);
      const double* value = &values_[c.values + (after ? c.count - 1 : 0) * c.channels];
      std::copy_n(cut && !after ? end->before.data() : value, c.channels, out);
      return;
    }
  }
  const auto k = static_cast<std::uint32_t>(std::upper_bound(first, last + 1, t) - first) - 1;
  if (k + 1 == c.count)
    std::copy_n(&values_[c.values + k * c.channels], c.channels, out);
  else
    segment(c, k, static_cast<double>(t - first[k]), out);
}

void CurveSet::evaluate(const Curve& c, Time time, double* out) const {
  find(c, time.flicks, out);
  if (c.srgb)
    for (int i = 0; i < c.channels; ++i) out[i] = to_linear(out[i]);
}

void CurveSet::derivative(const Curve& c, Time time, double* out) const {
  // Five values about the time, all in its own segment: the difference that is exact for quartics.
  const std::int64_t *first = &times_[c.first], *last = first + c.count - 1;
  const std::int64_t t = time.flicks;
  const double second = static_cast<double>(flicks_per_second);
  std::fill_n(out, c.orientation ? 3 : c.channels, 0.0);
  if (c.count < 2) return;
  const bool outside = t < *first || t >= *last;
  std::array<Numbers, 5> v{};
  double h = 0, offset = 0;  // a step, and where the time is among the five, in steps
  if (outside) {
    const Extend how = t < *first ? c.before : c.after;
    if (how == Extend::hold) return;
    h = std::max(1.0, std::min(static_cast<double>(*last - *first) / 4096, second / 1024));
    const auto step = static_cast<std::int64_t>(h);
    h = static_cast<double>(step);
    for (int i = 0; i < 5; ++i) evaluate(c, {t + i * step}, v[static_cast<std::size_t>(i)].data());
  } else {
    const auto k = static_cast<std::uint32_t>(std::upper_bound(first, last + 1, t) - first) - 1;
    const double length = static_cast<double>(first[k + 1] - first[k]), since = static_cast<double>(t - first[k]);
    h = length / 1024;
    const double begin = std::clamp(since - 2 * h, 0.0, length - 4 * h);
    offset = (since - begin) / h;
    for (int i = 0; i < 5; ++i) {
      auto& n = v[static_cast<std::size_t>(i)];
      segment(c, k, begin + i * h, n.data());
      if (c.srgb)
        for (double& x : n) x = to_linear(x);
    }
  }
  // Weights of the derivative of the quartic through five points, at `offset`.
  std::array<double, 5> w{};
  for (int i = 0; i < 5; ++i) {
    double below = 1, sum = 0;
    for (int j = 0; j < 5; ++j) {
      if (j == i) continue;
      below *= i - j;
      double product = 1;
      for (int m = 0; m < 5; ++m)
        if (m != i && m != j) product *= offset - m;
      sum += product;
    }
    w[static_cast<std::size_t>(i)] = sum / below / (h / second);
  }
  if (!c.orientation) {
    for (std::size_t i = 0; i < 5; ++i)
      for (int n = 0; n < c.channels; ++n) out[n] += w[i] * v[i][static_cast<std::size_t>(n)];
    return;
  }
  // Turns away from the middle one, in the axes outside.
  const Quat middle = quat(v[2].data());
  for (std::size_t i = 0; i < 5; ++i) {
    Quat q = quat(v[i].data());
    if (dot(q, middle) < 0) q = -q;
    const Quat turn = log(q * conjugate(middle));
    out[0] += 2 * w[i] * turn.x, out[1] += 2 * w[i] * turn.y, out[2] += 2 * w[i] * turn.z;
  }
}

void CurveSet::integrate(const Curve& c, std::uint32_t k, double u, double* out) const {
  // Gauss and Legendre's five points are exact to the ninth degree: a cubic of an ease has the sixth. The eases' seams
  // part the segment; what is no polynomial is cut finer.
  static constexpr double at[] = {0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                  0.95308992296933200};
  static constexpr double weight[] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                      0.23931433524968324, 0.11846344252809454};
  std::fill_n(out, c.channels, 0.0);
  const double h = static_cast<double>(times_[c.first + k + 1] - times_[c.first + k]);
  const auto twerper = static_cast<Twerper>(twerpers_[c.first + k]);
  const CurveDetail *here = detail(c.first + k), *next = detail(c.first + k + 1);
  double a = here ? here->ease_out / h : 0, b = next ? next->ease_in / h : 0;
  if (a + b > 1) {
    const double fit = 1 / (a + b);
    a *= fit, b *= fit;
  }
  std::vector<double> seams{0};
  const auto seam = [&](double x) {
    if (x > seams.back() && x < u) seams.push_back(x);
  };
  seam(a), seam(1 - b);
  if (twerper == Twerper::bezier || is_own(twerper))
    for (int i = 1; i < 64; ++i) seam(i / 64.0);
  seams.push_back(u);
  Numbers n{};
  for (std::size_t i = 0; i + 1 < seams.size(); ++i)
    for (std::size_t g = 0; g < 5; ++g) {
      const double width = seams[i + 1] - seams[i];
      segment(c, k, (seams[i] + at[g] * width) * h, n.data());
      for (int x = 0; x < c.channels; ++x)
        out[x] += weight[g] * width * n[static_cast<std::size_t>(x)] * h / static_cast<double>(flicks_per_second);
    }
}

std::size_t CurveSet::bytes() const {
  return times_.size() * sizeof(times_[0]) + values_.size() * sizeof(double) + twerpers_.size() +
         details_.size() * sizeof(CurveDetail);
}

StepTrack::StepTrack(const Track& track, Type type) : before_(track.before), after_(track.after) {
  track.events.each([&](const Event& e) {
    if (e.keep && values_.empty()) return;
    const auto twerper = static_cast<std::uint8_t>(resolve(track, e, type, false));
    if (e.detail && e.detail->before) values_.push_back(*e.detail->before);
    const std::size_t comes_to = values_.size() - (e.keep || (e.detail && e.detail->before) ? 1 : 0);
    if (!e.keep) values_.push_back(e.value);
    keys_.push_back({e.time, comes_to, values_.size() - 1, twerper, e.detail});
    if (track.global == Twerper::bezier) keys_.back().detail.edit().bezier = track.bezier;
  });
}

Between StepTrack::at(Time time, const CurveSet& set) const {
  std::int64_t t = time.flicks;
  const std::int64_t first = keys_.front().time.flicks, last = keys_.back().time.flicks;
  const Extend how = t < first ? before_ : after_;
  if ((t < first || t > last) && how >= Extend::cycle) t = fold(t, first, last, how == Extend::bounce);
  const auto next =
      std::upper_bound(keys_.begin(), keys_.end(), t, [](std::int64_t at, const Key& k) { return at < k.time.flicks; });
  if (next == keys_.begin()) return {next->comes_to, next->comes_to, 0};
  const Key& key = next[-1];
  const auto twerper = static_cast<Twerper>(key.twerper);
  if (next == keys_.end() || twerper == Twerper::hold) return {key.goes_on, key.goes_on, 0};
  const double h = static_cast<double>((next->time - key.time).flicks);
  CurveDetail from, to;
  from.ease_out = static_cast<double>(key.detail->ease_out.flicks), from.bezier = key.detail->bezier;
  to.ease_in = static_cast<double>(next->detail->ease_in.flicks);
  double s = segment_factor(twerper, static_cast<double>(t - key.time.flicks) / h, &from, &to, h);
  if (twerper == Twerper::hermite || twerper == Twerper::bspline) s = s * s * (3 - 2 * s);
  if (is_own(twerper)) s = own_factor(set.own, twerper, s);
  return {key.goes_on, next->comes_to, s};
}

std::optional<Time> StepTrack::next_change(Time t) const {
  if (keys_.size() < 2) return std::nullopt;  // one value, always
  if ((t < keys_.front().time ? before_ : after_) != Extend::hold) return t;
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), t, [](Time at, const Key& k) { return at < k.time; });
  if (next == keys_.end()) return std::nullopt;
  const bool blends = next != keys_.begin() && static_cast<Twerper>(next[-1].twerper) != Twerper::hold;
  return blends ? t : next->time;
}

}  // namespace betwixt
