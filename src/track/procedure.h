// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Code of the author's: what the rooms that hold and evaluate documents know of it. src/procedure fills it with Lua and
// with plug-ins. (twixt notes, 3.4: inquisitive events; 2.4: a user's routine is used exactly like a built-in one)
//
// A procedure is pure: the same question gives the same answer, whoever asks and in whatever order. It is immutable and
// may be called from several threads at once. One that errs, or does not come to an end, returns an Error in plain
// words ("attempt to index a nil value", "stopped: it took more than 1000000 steps"); the caller goes on without it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/result.h"
#include "betwixt/time.h"
#include "betwixt/value.h"

namespace betwixt {

// What a procedure stands in for.
enum class Role : std::uint8_t { value, twerper, filter, command };
inline constexpr std::array<std::string_view, 4> role_names{"value", "twerper", "filter", "command"};

// A filter's or command's key=value pairs; texts as they stand.
using Parameters = std::vector<std::pair<std::string, Value>>;

class Routine;

// What a procedure may ask of the film while it runs. `cost` grows by what the answer took, in steps (instructions and
// the like), however it was come by; whoever asks adds it to its own.
class Questions {
 public:
  virtual ~Questions() = default;
  virtual double seconds() const = 0;         // the time that a value is wanted for
  virtual Rate rate() const = 0;              // of frames
  virtual std::string_view self() const = 0;  // the name of the object it is wanted of; empty: of none
  // "leg.rotation.z", ".scale.x" (of the object itself), "ball.world", "ball.position.velocity"; at any time.
  // Colours as the author writes them, angles in radians.
  virtual Result<Value> value(std::string_view target, double seconds, std::uint64_t& cost) = 0;
  // Where the line that an object is has got to at a share of its length, in the world.
  virtual Result<Vec3> place(std::string_view line, double share, double seconds, std::uint64_t& cost) = 0;
  // A procedure of role `value` by its name, or null.
  virtual const Routine* procedure(std::string_view name) = 0;
};

// What a filter may ask: the track it stands on, unfiltered, at any time.
class Input {
 public:
  virtual ~Input() = default;
  virtual Value at(double seconds) = 0;
  virtual Rate rate() const = 0;       // of frames
  virtual void work(std::uint64_t) {}  // so many steps were taken beside what was asked
};

// What a command may do.
class Host {
 public:
  virtual ~Host() = default;
  virtual Status run(std::string_view line) = 0;  // a command of the language, as if the author had typed it
  virtual Result<Value> value(std::string_view target, double seconds) = 0;  // of the document as it now is
  virtual std::vector<std::string> objects(std::string_view pattern) = 0;    // names, in the order of selection
};

class Routine {
 public:
  virtual ~Routine() = default;
  std::string language;  // "lua" or "plug-in"
  std::string source;    // as the author wrote it; a plug-in's path

  // One of these, by the role. `arguments`: what another procedure passes on.
  virtual Result<Value> value(Questions&, const std::vector<Value>& arguments, std::uint64_t& cost) const;
  virtual Result<double> blend(double u) const;  // the factor at u, 0 to 1 along the segment (eases are in it already)
  virtual Result<Value> filter(Input&, double seconds, const Parameters&) const;
  virtual Status command(Host&, const std::vector<std::string>& words) const;
};

}  // namespace betwixt
