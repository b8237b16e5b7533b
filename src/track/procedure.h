// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The author's code: the interface for rooms that hold and evaluate documents. src/procedure implements it for Lua and
// plug-ins. (twixt notes, 3.4: inquisitive events; 2.4: a user's routine is used exactly like a built-in one)
//
// A procedure is pure: the same input gives the same result, from any caller and in any order. It is immutable, and
// several threads may call it at once. If it fails or does not end, it returns an Error in plain words ("attempt to
// index a nil value", "stopped: it took more than 1000000 steps"), and the caller continues without it. The error's
// place has the line of code of several lines.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/result.h"
#include "betwixt/time.h"
#include "betwixt/value.h"
#include "track/state.h"

namespace betwixt {

// The kinds of procedures. A twerper and a tween compute what is between two events: a twerper returns the fraction of
// the way, a tween the value itself.
enum class Role : std::uint8_t { value, twerper, filter, command, steps, tween };
inline constexpr std::array<std::string_view, 6> role_names{"value", "twerper", "filter", "command", "steps", "tween"};

// The segment between two events, as a tween sees it.
struct TweenSegment {
  double u = 0;                                     // the fraction of the time that has passed, with eases applied
  double seconds = 0;                               // between the two events
  const Value *from = nullptr, *to = nullptr;       // the values of the two events
  const Value *before = nullptr, *after = nullptr;  // of the events next to them; null if there is none
};

// The key=value pairs of a filter or command; texts as written.
using Parameters = std::vector<std::pair<std::string, Value>>;

class Routine;
struct AxesSpace;  // src/scene/axes.h

// The reads of a procedure while it runs. `cost` grows by the steps (instructions and the like) that the result took,
// even if it was known already; the caller adds it to its own.
class Questions {
 public:
  virtual ~Questions() = default;
  virtual double seconds() const = 0;  // the time at which the value is evaluated
  // Returns true if there is no time: the compiler asks whether code is constant, and code that reads the time fails.
  virtual bool timeless() const { return false; }
  virtual Rate rate() const = 0;              // of frames
  virtual std::string_view self() const = 0;  // the name of the object whose value it is; "" if there is none
  // Reads "leg.rotation.z", ".scale.x" (of the object itself), "ball.world", "ball.position.velocity", at any time.
  // Colours are sRGB, angles radians.
  virtual Result<Value> value(std::string_view target, double seconds, std::uint64_t& cost) = 0;
  // Returns the point of a line, in the world, at a share of its length.
  virtual Result<Vec3> place(std::string_view line, double share, double seconds, std::uint64_t& cost) = 0;
  // Returns a procedure of role `value` or `steps` by its name, or null.
  virtual const Routine* procedure(std::string_view name) = 0;
  // Finds the coordinates of axes, or of the axes that an object is on, at a time. "": of the object itself.
  virtual Status axes(std::string_view object, double seconds, AxesSpace& out, std::uint64_t& cost) = 0;
  // Returns the text that the text of an object turns into, and how far it is; 0 if it stays.
  struct Turn {
    std::string text;
    double share = 0;
  };
  virtual Turn turn(std::string_view object) = 0;
  // Returns the state of a stepped procedure (role `steps`) at a time.
  virtual Result<State> state(std::string_view name, double seconds, std::uint64_t& cost) = 0;
};

// The reads of a filter: the unfiltered track below it, at any time.
class Input {
 public:
  virtual ~Input() = default;
  virtual Value at(double seconds) = 0;
  virtual Rate rate() const = 0;       // of frames
  virtual void work(std::uint64_t) {}  // adds steps that were taken besides the reads
};

// A row of a sheet that a command writes.
struct HostRow {
  double from = 0;              // seconds
  std::optional<double> until;  // not before `from`; set if the row has a segment of time
  Value value;                  // a text for another type stands for itself, as in "keep" or "along road"
  std::string rest;             // "smooth ease-in=3f"
};

// The actions of a command.
class Host {
 public:
  virtual ~Host() = default;
  virtual Status run(
      std::string_view line) = 0;  // carries out a command of the language, as if the author had typed it
  virtual Result<Value> value(std::string_view target, double seconds) = 0;  // from the document as it is now
  virtual std::vector<std::string> objects(std::string_view pattern) = 0;    // names, in the order of selection
  // Returns the point of a line, in the world, at a share of its length.
  virtual Result<Vec3> place(std::string_view line, double share, double seconds) = 0;
  virtual Status sheet(std::string_view target, const std::vector<HostRow>& rows) = 0;
  virtual std::string when(double seconds) = 0;  // the time as the language writes it, to the flick
};

class Routine {
 public:
  virtual ~Routine() = default;
  std::string language;  // "lua" or "plug-in"
  std::string source;    // as written; for a plug-in its path
  // Known to read the time or the film, or to take long, so that nobody tries again whether it is constant.
  mutable std::atomic<bool> varies{false};
  virtual bool stepped() const { return false; }  // its role is `steps`
  // Returns the error of a step that needs itself.
  virtual std::string_view circle() const {
    return "it depends on itself: a step can read its own state only at earlier times, as in (t - dt)";
  }

  // Returns true if `value` can be asked by Questions that are timeless().
  virtual bool may_be_constant() const { return false; }

  // Only the function of its role is called. `arguments`: those that another procedure passes.
  virtual Result<Value> value(Questions&, const std::vector<Value>& arguments, std::uint64_t& cost) const;
  // Returns the state after one more step. `before`: the state of the step before, or nothing. `number`: of this step,
  // counted from 0. `seconds_each`: the time between two steps.
  virtual Result<State> step(Questions&, const State& before, std::int64_t number, double seconds_each,
                             std::uint64_t& cost) const;
  virtual Result<double> blend(double u) const;  // the factor at u, 0 to 1 along the segment, with eases applied
  virtual Result<Value> between(Questions&, const TweenSegment&, std::uint64_t& cost) const;
  virtual Result<Value> filter(Input&, double seconds, const Parameters&) const;
  virtual Status command(Host&, const std::vector<std::string>& words) const;
};

}  // namespace betwixt
