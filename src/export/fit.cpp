// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace betwixt {
namespace {

constexpr double most_turned = 12 * pi / 180;  // of linear pieces, for players that cut corners
constexpr double most_arc = 150 * pi / 180;    // beyond it the direction is not certain
constexpr std::int64_t shortest = flicks_per_second / 20'000;

KeyValue plus(const KeyValue& a, double s, const KeyValue& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2], a[3] + s * b[3]};
}
double dot(const KeyValue& a, const KeyValue& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }
double apart(const KeyValue& a, const KeyValue& b) {
  const KeyValue d = plus(a, -1, b);
  return std::sqrt(dot(d, d));
}
KeyValue unit(const KeyValue& q) {
  const double l = std::sqrt(dot(q, q));
  return l > 0 ? KeyValue{q[0] / l, q[1] / l, q[2] / l, q[3] / l} : KeyValue{0, 0, 0, 1};
}

KeyValue straight_at(const KeyPiece& p, double u, bool turn) {
  if (!turn) return plus(plus({}, 1 - u, p.begin), u, p.end);
  const double cosine = dot(p.begin, p.end);
  const KeyValue end = cosine < 0 ? plus({}, -1, p.end) : p.end;
  const double angle = 2 * std::atan2(apart(end, p.begin), std::sqrt(2 + 2 * std::abs(cosine)));
  if (angle < 1e-8) return unit(plus(plus({}, 1 - u, p.begin), u, end));
  return unit(plus(plus({}, std::sin((1 - u) * angle), p.begin), std::sin(u * angle), end));
}

KeyValue cubic_at(const KeyPiece& p, double u, bool turn) {
  const double seconds = (p.until - p.from).seconds(), u2 = u * u, u3 = u2 * u;
  KeyValue v = plus(plus({}, 2 * u3 - 3 * u2 + 1, p.begin), 3 * u2 - 2 * u3, p.end);
  v = plus(plus(v, (u3 - 2 * u2 + u) * seconds, p.leaving), (u3 - u2) * seconds, p.arriving);
  return turn ? unit(v) : v;
}

KeyValue piece_at(const KeyPiece& p, double u, bool turn) {
  return p.shape == KeyPiece::held       ? p.begin
         : p.shape == KeyPiece::straight ? straight_at(p, u, turn)
                                         : cubic_at(p, u, turn);
}

Time in_flicks(float seconds, Time beginning) { return beginning + from_seconds(static_cast<double>(seconds)); }

class Follower {
 public:
  Follower(const Followed& f, const KeyOptions& options, Time beginning, std::size_t most, bool straight, bool cubic)
      : f_(f), options_(options), beginning_(beginning), most_(most), straight_(straight), cubic_(cubic) {}

  // Returns nullopt if it takes too many pieces.
  std::optional<std::vector<KeyPiece>> through(std::span<const Time> knots) {
    const Time end = knots.back();
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
      Time from = pieces_.empty() ? knots[k] : pieces_.back().until;
      // Intervals of limited length, since the number of samples is limited.
      const std::int64_t longest = std::max<std::int64_t>(100 * f_.step.flicks, 1);
      for (Time at = knots[k]; at < knots[k + 1];) {
        Time next{std::min(at.flicks + longest, knots[k + 1].flicks)};
        if (knots[k + 1].flicks - next.flicks < longest / 4) next = knots[k + 1];
        if (!stretch(from, next)) return std::nullopt;
        if (!pieces_.empty()) from = pieces_.back().until;
        at = next;
      }
    }
    // The value after a jump at the very end.
    if (pieces_.empty() || (!options_.in_floats && jumps_at(end)))
      pieces_.push_back({KeyPiece::held, pieces_.empty() ? knots.front() : end, end, value(end), value(end)});
    merge();
    return std::move(pieces_);
  }

 private:
  // A leap in floats may end shortly before its time: then the next value holds already.
  Time meant(Time t) const {
    const auto next = early_.upper_bound(t);
    return next == early_.begin() ? t : std::max(t, std::prev(next)->second);
  }
  KeyValue value(Time t) const { return f_.at(meant(t)); }
  KeyValue near(const KeyValue& v, const KeyValue& other) const {
    return f_.turn && dot(v, other) < 0 ? plus({}, -1, v) : v;
  }
  double off(const KeyValue& a, const KeyValue& b) const { return f_.turn ? 2 * apart(a, near(b, a)) : apart(a, b); }
  bool jumps_at(Time t) { return off(f_.at({t.flicks - 1}), f_.at(t)) > 0.02 * f_.tolerance; }

  // Returns the nearest time that a file can store.
  Time kept(Time t) const { return options_.in_floats ? in_flicks(static_cast<float>((t - beginning_).seconds())) : t; }
  std::pair<Time, Time> kept_around(Time t) {
    const auto around = around_jump(t, beginning_, f_.step, options_);
    if (options_.in_floats) early_[around.second] = t;
    return around;
  }
  // Returns the final value of a piece that ends before a jump.
  KeyValue just_before(Time end, Time jump) const {
    return options_.style == KeyStyle::linear && options_.in_floats ? value(end) : f_.at({jump.flicks - 1});
  }
  Time in_flicks(float seconds) const { return betwixt::in_flicks(seconds, beginning_); }

  // Fits from the end of the last piece to a possible jump.
  bool stretch(Time from, Time until) {
    const bool jump = jumps_at(until);
    const auto [end, next] = jump ? kept_around(until) : std::pair(kept(until), kept(until));
    if (end > from && !split(from, end, jump ? just_before(end, until) : value(end), 0)) return false;
    if (jump) leap(end, next);
    return true;
  }
  void leap(Time from, Time to) {
    if (from == to || pieces_.empty()) return;
    KeyPiece p{KeyPiece::leap, from, to};
    p.begin = pieces_.back().end;
    p.end = near(value(to), p.begin);
    pieces_.push_back(p);
  }

  // What has ended just before a jump ends where that begins: its keys would be too near to each other.
  void shorten(Time until) {
    if (pieces_.empty() || until <= pieces_.back().from) return;
    KeyPiece& last = pieces_.back();
    if (last.shape != KeyPiece::straight && last.shape != KeyPiece::held) return;
    const double share = (until - last.from).seconds() / (last.until - last.from).seconds();
    last.end = piece_at(last, share, f_.turn), last.until = until;
  }

  bool keep(const KeyPiece& p) {
    pieces_.push_back(p);
    return pieces_.size() <= most_;
  }

  bool split(Time a, Time b, const KeyValue& end, int depth) {
    if (const auto p = one(a, b, end)) return keep(*p);
    if (depth > 3 && depth < 60)
      if (const auto jump = find_jump(a, b)) {
        const auto [before, after] = kept_around(*jump);
        if (before > a && !split(a, before, just_before(before, *jump), depth + 1)) return false;
        if (before <= a) shorten(before);
        if (pieces_.empty()) pieces_.push_back({KeyPiece::held, a, a, value(a), value(a)});
        if (after > a) leap(pieces_.back().until, after);
        return after >= b || split(after, b, end, depth + 1);
      }
    const Time middle = kept({(a.flicks + b.flicks) / 2});
    if (depth > 60 || b.flicks - a.flicks < shortest || middle <= a || middle >= b) {
      KeyPiece p{f_.turn && !straight_ ? KeyPiece::cubic : KeyPiece::straight, a, b, value(a), end};
      p.end = near(p.end, p.begin);
      for (std::size_t i = 0; i < 4; ++i) p.leaving[i] = p.arriving[i] = (p.end[i] - p.begin[i]) / (b - a).seconds();
      return keep(p);
    }
    return parts(a, b, end, depth);
  }
  // Splits into as many equal parts as are probably needed: the error of a cubic falls with the fourth power of its
  // length, that of a linear piece with the second.
  bool parts(Time a, Time b, const KeyValue& end, int depth) {
    const double needed = std::pow(too_far_ / f_.tolerance, cubic_ ? 0.25 : 0.5);
    const int n = std::clamp(static_cast<int>(std::ceil(1.02 * needed)), 2, 8);
    Time from = a;
    for (int i = 1; i < n; ++i) {
      const Time to = kept({a.flicks + (b.flicks - a.flicks) / n * i});
      if (to <= from || to >= b) continue;
      if (!split(from, to, value(to), depth + (n > 3 ? 2 : 1))) return false;
      from = to;
    }
    return split(from, b, end, depth + 1);
  }

  // Finds a jump between two times, if most of the change happens at once.
  std::optional<Time> find_jump(Time a, Time b) {
    std::int64_t low = meant(a).flicks, high = b.flicks - 1;
    if (low >= high) return std::nullopt;
    const double whole = off(f_.at({low}), f_.at({high}));
    if (whole < f_.tolerance) return std::nullopt;
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      off(f_.at({low}), f_.at({middle})) > off(f_.at({middle}), f_.at({high})) ? high = middle : low = middle;
      if (off(f_.at({low}), f_.at({high})) < 0.3 * whole) return std::nullopt;
    }
    return Time{high};
  }

  // Fits one piece; returns nullopt if none is within the tolerance.
  std::optional<KeyPiece> one(Time a, Time b, const KeyValue& end) {
    KeyPiece p{KeyPiece::held, a, b};
    p.begin = value(a);
    if (!pieces_.empty()) p.begin = near(p.begin, pieces_.back().end);
    const auto steps = static_cast<double>(b.flicks - a.flicks) / static_cast<double>(f_.step.flicks);
    const int looks = 3 * std::clamp(static_cast<int>(steps / 3), steps < 4 ? 2 : 6, 70);
    looks_.clear();
    KeyValue last = p.begin;
    double far = 0, turned = 0;
    for (int i = 1; i < looks; ++i) {
      const double share = static_cast<double>(i) / looks;
      const Time t{a.flicks + std::llround(share * static_cast<double>(b.flicks - a.flicks))};
      const KeyValue v = near(value(t), last);
      far = std::max(far, apart(v, p.begin));
      if (f_.turn) turned += 2 * std::asin(std::min(1.0, 0.5 * apart(v, last)));
      looks_.push_back({static_cast<double>(t.flicks - a.flicks) / static_cast<double>(b.flicks - a.flicks), v});
      last = v;
    }
    p.end = near(end, last);
    far = std::max(far, apart(p.end, p.begin));
    if (far < 1e-3 * f_.tolerance) {
      p.end = p.begin;
      return p;
    }
    p.shape = KeyPiece::straight;
    const double limit = options_.style == KeyStyle::linear ? most_turned : most_arc;
    if (straight_ && (!f_.turn || 2 * turned < limit) && follows(p)) return p;
    if (f_.turn && 2 * turned > limit) too_far_ = f_.tolerance * std::pow(2 * turned / limit, cubic_ ? 4 : 2);
    if (!cubic_ || (f_.turn && 2 * turned > most_arc)) return std::nullopt;
    p.shape = KeyPiece::cubic;
    const KeyValue &one_third = looks_[static_cast<std::size_t>(looks / 3 - 1)].value,
                   &two_thirds = looks_[static_cast<std::size_t>(2 * looks / 3 - 1)].value;
    const double seconds = (b - a).seconds();
    for (std::size_t i = 0; i < 4; ++i) {
      p.leaving[i] = (-11 * p.begin[i] + 18 * one_third[i] - 9 * two_thirds[i] + 2 * p.end[i]) / 2 / seconds;
      p.arriving[i] = (11 * p.end[i] - 18 * two_thirds[i] + 9 * one_third[i] - 2 * p.begin[i]) / 2 / seconds;
    }
    if (follows(p)) return p;
    return std::nullopt;
  }
  bool follows(const KeyPiece& p) {
    too_far_ = 0;
    for (const Look& look : looks_) too_far_ = std::max(too_far_, off(piece_at(p, look.share, f_.turn), look.value));
    // A player that ignores tangents may also blend the four numbers of a rotation.
    if (f_.turn && options_.style == KeyStyle::linear)
      for (const auto& [share, v] : looks_)
        too_far_ = std::max(too_far_, off(unit(plus(plus({}, 1 - share, p.begin), share, p.end)), v));
    return too_far_ <= f_.tolerance;
  }

  // Merges neighbours that one piece can replace.
  void merge() {
    std::vector<KeyPiece> all = std::move(pieces_);
    pieces_.clear();
    for (const KeyPiece& p : all) {
      if (!pieces_.empty()) {
        KeyPiece last = pieces_.back();
        const bool goes_on =
            last.shape == p.shape && p.shape != KeyPiece::leap && apart(last.end, p.begin) < 1e-3 * f_.tolerance;
        if (goes_on) {
          pieces_.pop_back();
          if (const auto both = one(last.from, p.until, p.end); both && both->shape == p.shape) {
            pieces_.push_back(*both);
            continue;
          }
          pieces_.push_back(last);
        }
      }
      pieces_.push_back(p);
    }
  }

  struct Look {
    double share = 0;
    KeyValue value{};
  };
  const Followed& f_;
  const KeyOptions& options_;
  const Time beginning_;
  const std::size_t most_;
  const bool straight_, cubic_;
  std::vector<Look> looks_;
  std::map<Time, Time> early_;  // ends of leaps that end early, and the times of the jumps
  double too_far_ = 0;          // the error of the last piece that failed
  std::vector<KeyPiece> pieces_;
};

std::vector<KeyPiece> baked(const Followed& f, Time from, Time until) {
  std::vector<KeyPiece> pieces;
  KeyValue last = f.at(from);
  for (Time t = from; t < until;) {
    const Time next{std::min(t.flicks + 2 * f.step.flicks, until.flicks)};
    KeyPiece p{KeyPiece::straight, t, next, last, f.at(next)};
    if (f.turn && dot(p.begin, p.end) < 0) p.end = plus({}, -1, p.end);
    last = p.end, t = next;
    pieces.push_back(p);
  }
  if (pieces.empty()) pieces.push_back({KeyPiece::held, from, until, last, last});
  return pieces;
}

bool is_held(const KeyPiece& p) { return p.shape == KeyPiece::held; }

}  // namespace

bool Channel::constant() const {
  return std::all_of(pieces.begin(), pieces.end(), [&](const KeyPiece& p) {
    return p.shape == KeyPiece::held && apart(p.begin, pieces.front().begin) < 1e-12;
  });
}

bool Channel::steps() const {
  return std::all_of(pieces.begin(), pieces.end(),
                     [](const KeyPiece& p) { return p.shape == KeyPiece::held || p.shape == KeyPiece::leap; });
}

bool Channel::jumps_behind(std::size_t piece) const {
  return piece + 1 < pieces.size() && apart(pieces[piece].end, pieces[piece + 1].begin) > 1e-9;
}

std::size_t Channel::keys() const {
  if (constant()) return 1;
  if (steps()) return static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), is_held));
  std::size_t n = pieces.size() + 1;
  for (std::size_t i = 0; i < pieces.size(); ++i) n += jumps_behind(i) ? 1 : 0;
  return n;
}

std::array<double, 4> value_at(const Channel& c, Time t) {
  auto p =
      std::upper_bound(c.pieces.begin(), c.pieces.end(), t, [](Time time, const KeyPiece& q) { return time < q.from; });
  if (p != c.pieces.begin()) --p;
  const double length = static_cast<double>((p->until - p->from).flicks);
  const double u = length > 0 ? static_cast<double>((t - p->from).flicks) / length : 0;
  return piece_at(*p, std::clamp(u, 0.0, 1.0), c.turn);
}

Followed followed(const Document& d, std::size_t width, double tolerance, std::function<KeyValue(Time)> at) {
  return {width, false, 0.5 * tolerance, std::move(at), Time{std::max<std::int64_t>(d.rate().span(0.5).flicks, 1)}};
}

// Who counts in frames or milliseconds multiplies, and rounds again: assimp by floats.
static float before_all(float f) { return std::nextafter(std::nextafter(f, -1e30F), -1e30F); }
static float after_all(float f) { return std::nextafter(std::nextafter(f, 1e30F), 1e30F); }

std::pair<Time, Time> around_jump(Time jump, Time beginning, Time step, const KeyOptions& options) {
  if (!options.in_floats) return {jump, jump};
  const double seconds = (jump - beginning).seconds();
  float f = static_cast<float>(seconds);
  if (static_cast<double>(f) > seconds) f = std::nextafter(f, -1e30F);
  if (options.style == KeyStyle::linear) f = before_all(f);
  const Time after = in_flicks(f, beginning);
  // Blender merges keys that are nearer than a hundredth of a frame.
  if (options.style == KeyStyle::linear) f = static_cast<float>(seconds - 0.021 * step.seconds());
  while (in_flicks(f, beginning) >= after) f = std::nextafter(f, -1e30F);
  const Time before = in_flicks(f, beginning);
  if (options.style != KeyStyle::linear) return {before, after};
  // Whole frames are what is looked at: where one lies on the way, the way begins behind it.
  const std::int64_t frame = 2 * step.flicks;
  const Time last_frame{beginning.flicks + (jump - beginning).flicks / frame * frame};
  const Time behind = in_flicks(after_all(static_cast<float>((last_frame - beginning).seconds())), beginning);
  if (last_frame <= before || behind >= jump) return {before, after};
  return {behind, in_flicks(static_cast<float>((behind - beginning).seconds() + 0.021 * step.seconds()), beginning)};
}

std::vector<Time> knots_between(std::vector<Time> all, Time from, Time until) {
  std::erase_if(all, [&](Time t) { return t <= from || t >= until; });
  all.push_back(from);
  all.push_back(std::max(from, until));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void add_knots(const Channel& c, std::vector<Time>& to) {
  for (const KeyPiece& p : c.pieces) to.push_back(p.shape == KeyPiece::leap ? p.until : p.from);
}

Channel follow(const Followed& f, std::span<const Time> knots, const KeyOptions& options) {
  Channel c{f.width, f.turn, {}};
  if (knots.size() < 2 || options.style == KeyStyle::baked) {
    c.pieces = baked(f, knots.front(), knots.back());
    return c;
  }
  const auto with = [&](std::size_t most, bool straight, bool cubic) {
    return Follower(f, options, knots.front(), most, straight, cubic).through(knots);
  };
  const bool linear = options.style == KeyStyle::linear;
  c.pieces = *with(SIZE_MAX, linear || !f.turn, !linear);
  // Rotations are blended in one of two ways; linear keys are a third of the size of the others.
  if (f.turn && !linear && options.arcs)
    if (auto straight = with(c.pieces.size() * 3 / 2 + 1, true, false)) c.pieces = std::move(*straight);
  return c;
}

}  // namespace betwixt
