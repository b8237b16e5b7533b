// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A document: an immutable value that holds a film. Copies are cheap and share their content. To undo, keep one.
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

// The earliest and the latest time.
inline constexpr Time from_the_beginning{INT64_MIN}, for_good{INT64_MAX};

// Values of an object that you can read and not set. A target has one in place of a display function.
enum class Query : std::uint16_t {
  loudness = 0xfff8,  // of a sound, as heard at the time: the root mean square over 50 ms, 0 to 1
  onsets,             // how many onsets (beats, strokes) of the sound there were until the time
  in_view,            // whether any part of a drawn object is in view
  touching,           // the names of the objects that a drawn object touches
  count,              // of an environment: the number of updates until the time
  interval,           // of an environment: ticks from one update to the next
  motion,             // of an environment: M, the matrix of one update
  world,              // of an object: the matrix from its space to the world; of an environment: A
};

// A display function (animatable property) of an object, one of its components (0 x r, 1 y g, 2 z b; -1: all), or a
// query.
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
  bool velocity = false;  // the rate of change instead, per second
  ObjectId layer;         // the layer whose track it is; without one, the object's own
  friend constexpr bool operator==(Target, Target) = default;
};

// What each alias means: patterns and names, which are looked up at each use.
using Aliases = std::map<std::string, std::vector<std::string>, std::less<>>;

class Document {
 public:
  Document();
  explicit Document(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

  Rate rate() const;   // frames a second
  Rate ticks() const;  // ticks a second, for environments, contacts and the imaging server
  // Returns the times of the first and the last frame. Without a `range` command: frame 1 to the last event, or one
  // second if there are no events.
  std::pair<Time, Time> range() const;
  // Return the width and height in pixels, and the samples a pixel, that the script sets; nullopt if it sets none.
  std::optional<std::pair<int, int>> size() const;
  std::optional<int> samples() const;
  std::optional<int> subframes() const;  // pictures that a blurred one is averaged from
  bool transparent() const;              // whether the background is transparent
  double aspect() const;                 // width / height; 16:9 if the script sets no size
  int frame_count() const;               // frames in the range, ends included; at least 1

  std::vector<std::string> names() const;      // of all objects, in order of creation
  ObjectId find(std::string_view name) const;  // an empty id if no object has the name
  std::string name(ObjectId) const;
  std::string name(const Target&) const;                                      // "ball.position.x"
  std::vector<std::pair<Time, std::string>> notes(Time from, Time to) const;  // both ends included
  const Aliases& aliases() const;
  const std::map<Time, ObjectId>& cuts() const;  // the camera from each time on

  const Scene& scene() const { return *scene_; }
  friend bool operator==(const Document&, const Document&);  // same content

 private:
  std::shared_ptr<const Scene> scene_;
};

}  // namespace betwixt
