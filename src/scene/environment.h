// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An environment: a matrix A that is multiplied by M again and again. Here it is a track of stamped events like any
// other track; A at any tick comes out in closed form, without stepping, and live history can be sought like a film.
//
// Times are whole ticks. Column vectors: an update is A <- A M, and with n updates since the event k that is in force
// A = A_k M^n: each motion acts in the axes of the object as it has been moved so far. (The source, with row vectors,
// writes A <- M A.) A is the identity before the first Animate, M from that tick on, M^2 an interval later.
//
// In one tick updates come first, then events in the order of their numbers: a Halt keeps the update due at its tick,
// an Animate gives its first update one interval later.
//
// A name that is killed and animated again is a new *generation*: those who used the old one keep its last A.
//
// Source: Animation Imaging Model 2.2.4, 2.2.5, 2.2.7, 3.3.4; acceleration and future events 5.1, 5.2.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "base/cow.h"
#include "base/shared_log.h"
#include "betwixt/math.h"
#include "betwixt/result.h"
#include "scene/pace.h"
#include "scene/power.h"

namespace betwixt {

struct EnvironmentEvent {
  struct Animate {
    Mat4 motion;
    Timing timing;
    bool keep_phase = false;  // the first update is when the old motion's next one was due
    // In ticks after the event: it starts then, not now; it halts then. Neither is undone by later events other than
    // Cancel and Kill.
    std::optional<std::int64_t> from, until;
    friend bool operator==(const Animate&, const Animate&) = default;
  };
  struct Halt {
    friend bool operator==(Halt, Halt) = default;
  };
  struct Kill {
    friend bool operator==(Kill, Kill) = default;
  };
  // Drops the starts and stops that are still to come.
  struct Cancel {
    friend bool operator==(Cancel, Cancel) = default;
  };
  std::int64_t tick = 0;
  std::uint64_t number = 0;  // the order of events in one tick; its starts and stops have it, too
  std::variant<Halt, Kill, Cancel, Animate> what;
  friend bool operator==(const EnvironmentEvent&, const EnvironmentEvent&) = default;
};

class Environment {
 public:
  // Events and their starts and stops are at most so far from tick 0, in time and from their event.
  static constexpr std::int64_t furthest = std::int64_t{1} << 60;

  Environment() = default;
  // Of events in any order. One that means nothing is ignored and told in problems().
  static Environment compile(std::vector<EnvironmentEvent> events);
  // Adds an event; at the end that costs no more for a long track than for a short one, before it all is compiled
  // again. One that means nothing is refused, and changes nothing. `like`: one to which the same has just been said,
  // with which it shares what was prepared.
  Status add(const EnvironmentEvent& event, const Environment* like = nullptr);

  struct Problem {
    std::uint64_t number = 0;  // of the event
    Severity severity = Severity::error;
    Error what;
  };
  // Events that mean nothing (errors); once, an Animate that came before the first update of the one before it, as
  // such never lead to any (warning).
  std::vector<Problem> problems() const;

  std::size_t size() const { return events_.size(); }
  const EnvironmentEvent& event(std::size_t i) const { return events_[i]; }  // by tick, then by number

  // Generations count from 0, in the order of their creation.
  int generations() const { return static_cast<int>(births_.size()); }
  // The one alive after the events of `tick`.
  std::optional<int> generation_at(std::int64_t tick) const;
  // The one that a site issued at `tick`, after the event `number` and before the next, belongs to for good: the one
  // alive then, else the next one to be created, else none.
  std::optional<int> bind(std::int64_t tick, std::uint64_t number = std::numeric_limits<std::uint64_t>::max()) const;

  // A. The identity where there is no such generation, or not yet; after its Kill what it was then.
  Mat4 at(int generation, std::int64_t tick) const;
  // A with a motion that goes on between updates, where M has real powers; else as above.
  Mat4 smooth(int generation, double tick) const;
  // Updates in (beginning of the generation, tick].
  std::int64_t count(int generation, std::int64_t tick) const;
  // An A that is held at Power::bound.
  bool clamped(int generation, std::int64_t tick) const;

  // The first tick after `tick` at which any A changes: an update, or a first Animate. Nothing: never again.
  std::optional<std::int64_t> next_due(std::int64_t tick) const;

  // M and the interval in force, of the generation alive then: the last ones where it is halted, those to come where
  // it has not started yet.
  std::optional<Mat4> matrix(std::int64_t tick) const;
  std::optional<std::int64_t> interval(std::int64_t tick) const;

  // What an Animate asks for, prepared.
  struct Motion {
    Mat4 matrix;
    Timing timing;
    bool keep_phase = false;
    Power power;
  };
  // From its tick on, until that of the next span of its generation: A = a * M^n, n by its pace while running, else 0.
  struct Span {
    std::int64_t tick = 0;
    Mat4 a;
    std::shared_ptr<const Motion> motion;
    Pace pace;
    std::int64_t before = 0;    // updates of this generation until here
    std::int64_t interval = 1;  // where it does not run
    bool running = false;
    bool first = false;  // A jumps from the identity to M here
  };
  // What A follows from; null before the generation.
  const Span* span(int generation, std::int64_t tick) const;

  friend bool operator==(const Environment& a, const Environment& b);

 private:
  struct Key {
    std::int64_t tick = 0;
    std::uint64_t number = 0;
    friend constexpr auto operator<=>(const Key&, const Key&) = default;
  };
  struct Birth {
    Key key;
    std::size_t span = 0;  // its first
  };
  // A start or, without a motion, a stop.
  struct Scheduled {
    Key key;
    std::shared_ptr<const Motion> motion;
  };
  // What came of events: spans, and what there is to say.
  struct Output {
    std::vector<Span> spans;
    std::vector<Problem> problems;
  };
  // Where the track stands after the events so far.
  struct Now {
    Span span;
    bool started = false;  // the generation has had its first Animate
    bool warned = false;
  };
  // What will come of the scheduled starts and stops if no other event comes; made when first asked for.
  struct Tail;

  static void start(Now&, const Scheduled&, Output&);
  static void halt(Now&, Key, Output&);
  static void run(Now&, const Scheduled&, Output&);
  Status check(const EnvironmentEvent&) const;
  void take(const EnvironmentEvent&, const Environment* like = nullptr);
  void apply(const EnvironmentEvent&, const Environment* like);
  void animate(Key, const EnvironmentEvent::Animate&, const Environment* like, Output&);
  void wait(Now&, Key, const Scheduled&, Output&) const;
  void kill(Key, Output&);
  void schedule(Scheduled);
  void keep(Output);
  bool alive() const { return births_.size() > kills_.size(); }
  const Output& tail() const;
  std::size_t spans() const;
  const Span& span_number(std::size_t i) const;
  std::size_t spans_until(std::size_t first, std::size_t end, std::int64_t tick) const;

  SharedLog<EnvironmentEvent> events_;
  SharedLog<Span> spans_;  // until the last event
  SharedLog<Birth> births_;
  SharedLog<Key> kills_;                 // of the generations 0, 1, ...: each is killed before the next is created
  Cow<std::vector<Scheduled>> pending_;  // the next one last
  Cow<std::vector<Problem>> problems_;
  Now now_;
  std::shared_ptr<Tail> tail_;
};

}  // namespace betwixt
