// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A document: an immutable value that holds a film. Copies are cheap and share everything; keeping one is undo.
//
// Room: scene
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/result.h"
#include "betwixt/time.h"
#include "betwixt/value.h"

namespace betwixt {

struct Scene;  // src/scene/document.h

// The ends of time.
inline constexpr Time from_the_beginning{INT64_MIN}, for_good{INT64_MAX};

// What can be asked of an object, and not set: a target has it in the place of a display function.
enum class Query : std::uint16_t {
  loudness = 0xfff8,  // of a sound, as it is heard then: 0 to 1, the root of the mean square over 50 ms
  onsets,             // how many beats and strokes of it have been heard by then
  in_view,            // whether any of a thing drawn is in view
  touching,           // the names of what a thing drawn touches
  count,              // of an environment: how many updates there have been
  interval,           // ticks from one update to the next
  motion,             // M
  world,              // of an object the matrix that takes it to the world, of an environment A
};

// A display function of an object, or one component of it (0 x r, 1 y g, 2 z b; -1: the whole), or a query.
struct Target {
  constexpr Target() = default;
  constexpr Target(ObjectId o, std::uint16_t f, int c = -1) : object(o), function(f), component(c) {}
  constexpr Target(ObjectId o, Query q, int c = -1) : Target(o, static_cast<std::uint16_t>(q), c) {}
  constexpr std::optional<Query> query() const {
    return function < static_cast<std::uint16_t>(Query::loudness) ? std::nullopt
                                                                  : std::optional(static_cast<Query>(function));
  }

  ObjectId object;
  std::uint16_t function = 0;
  int component = -1;
  bool velocity = false;  // its rate of change, per second
  ObjectId layer;         // the track on a layer; none: the object's own
  friend constexpr bool operator==(Target, Target) = default;
};

// What words stand for: patterns and names, which are looked up at each use.
using Aliases = std::map<std::string, std::vector<std::string>, std::less<>>;

class Document {
 public:
  Document();
  explicit Document(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

  Rate rate() const;   // frames a second
  Rate ticks() const;  // of environments, contacts and the imaging server
  // First and last frame's time. Without a `range` command: frame 1 to the last event, one second where there are no
  // events.
  std::pair<Time, Time> range() const;
  // What the script says of its pictures: pixels, and samples a pixel.
  std::optional<std::pair<int, int>> size() const;
  std::optional<int> samples() const;
  std::optional<int> subframes() const;  // that blurred pictures are added up of
  bool transparent() const;              // nothing is behind its things
  double aspect() const;                 // width by height; 16:9 where nobody says a size
  int frame_count() const;               // frames in the range, ends included; at least 1

  std::vector<std::string> names() const;  // of all objects, in the order they were created
  ObjectId find(std::string_view name) const;
  std::string name(ObjectId) const;
  std::string name(const Target&) const;                                      // "ball.position.x"
  std::vector<std::pair<Time, std::string>> notes(Time from, Time to) const;  // both ends included
  const Aliases& aliases() const;
  const std::map<Time, ObjectId>& cuts() const;  // which camera is looked through from when on

  const Scene& scene() const { return *scene_; }
  friend bool operator==(const Document&, const Document&);  // same content

 private:
  std::shared_ptr<const Scene> scene_;
};

}  // namespace betwixt
