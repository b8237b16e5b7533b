// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An environment: a matrix A that is multiplied by M again and again (an accumulating transform). It is a track of
// events with times, like any other; A at any tick is in closed form, without stepping, so live history can be sought.
//
// Times are whole ticks. Column vectors: an update is A <- A M. With n updates since event k, A = A_k M^n: each motion
// acts along the axes of the object as it has been moved until then. (The source has row vectors and
// writes A <- M A.) A is the identity before the first Animate, M from that tick on, M^2 an interval later.
//
// In one tick updates come first, then events in the order of their numbers: a Halt keeps the update due at its tick,
// an Animate gives its first update one interval later.
//
// A name that is killed and animated again is a new *generation*; objects of the old one keep its last A.
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
    bool keep_phase = false;  // the first update comes when the old motion's next one was due
    // In ticks after the event: the delays until it starts and until it halts. Only Cancel and Kill undo these.
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
  std::uint64_t number = 0;  // the order of events in one tick, also of its starts and stops
  std::variant<Halt, Kill, Cancel, Animate> what;
  friend bool operator==(const EnvironmentEvent&, const EnvironmentEvent&) = default;
};

class Environment {
 public:
  // The largest distance of events from tick 0, and of their starts and stops from their event.
  static constexpr std::int64_t furthest = std::int64_t{1} << 60;

  Environment() = default;
  // Compiles events in any order. An event without a meaning is ignored and reported by problems().
  static Environment compile(std::vector<EnvironmentEvent> events);
  // Adds an event. At the end this costs no more for a long track than for a short one; before the end everything is
  // compiled again. An event without a meaning is refused and changes nothing. `like`: an environment that has just got
  // the same event, whose preparation is shared.
  Status add(const EnvironmentEvent& event, const Environment* like = nullptr);

  struct Problem {
    std::uint64_t number = 0;  // of the event
    Severity severity = Severity::error;
    Error what;
  };
  // Returns the events without a meaning (errors), and, once, an Animate that came before the first update of the one
  // before it, since repeated ones never lead to any (warning).
  std::vector<Problem> problems() const;

  std::size_t size() const { return events_.size(); }
  const EnvironmentEvent& event(std::size_t i) const { return events_[i]; }  // by tick, then by number

  // Generations count from 0, in the order of their creation.
  int generations() const { return static_cast<int>(births_.size()); }
  // Returns the one that exists after the events of `tick`.
  std::optional<int> generation_at(std::int64_t tick) const;
  // Returns the generation of a site that is made at `tick`, after the event `number` and before the next: the one
  // that exists then, else the next one, else nullopt.
  std::optional<int> bind(std::int64_t tick, std::uint64_t number = std::numeric_limits<std::uint64_t>::max()) const;

  // Returns A: the identity if the generation does not exist, or not yet; after its Kill the last one.
  Mat4 at(int generation, std::int64_t tick) const;
  // The same with motion between updates, if M has real powers.
  Mat4 smooth(int generation, double tick) const;
  // Returns the number of updates in (beginning of the generation, tick].
  std::int64_t count(int generation, std::int64_t tick) const;
  // Returns whether A is limited by Power::bound.
  bool clamped(int generation, std::int64_t tick) const;

  // Returns the first tick after `tick` at which any A changes: an update, or a first Animate. nullopt: never again.
  std::optional<std::int64_t> next_due(std::int64_t tick) const;

  // Return M and the current interval of the generation that exists then: the last ones if it is halted, the future
  // ones if it has not started yet.
  std::optional<Mat4> matrix(std::int64_t tick) const;
  std::optional<std::int64_t> interval(std::int64_t tick) const;

  // The prepared motion of an Animate.
  struct Motion {
    Mat4 matrix;
    Timing timing;
    bool keep_phase = false;
    Power power;
  };
  // From its tick until the next span of its generation: A = a * M^n, n by its pace while it runs, otherwise 0.
  struct Span {
    std::int64_t tick = 0;
    Mat4 a;
    std::shared_ptr<const Motion> motion;
    Pace pace;
    std::int64_t before = 0;    // updates of this generation before it
    std::int64_t interval = 1;  // while it does not run
    bool running = false;
    bool first = false;  // A jumps from the identity to M here
  };
  // Returns the span that determines A, or null before the generation.
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
  // The result of events: spans and problems.
  struct Output {
    std::vector<Span> spans;
    std::vector<Problem> problems;
  };
  // The state of the track after the events until now.
  struct Now {
    Span span;
    bool started = false;  // the generation has had its first Animate
    bool warned = false;
  };
  // The effects of the scheduled starts and stops if no other event comes; made on first use.
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
