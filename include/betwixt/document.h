// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A document: an immutable value that holds a film. Copies are cheap and share their content. To undo, keep a copy.
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
inline constexpr Time earliest_time{INT64_MIN}, latest_time{INT64_MAX};

// Values of an object that you can read but not set. Target::function holds a query instead of a display function.
enum class Query : std::uint16_t {
  loudness = 0xfff8,  // of a sound, as heard at the time: the root mean square over 50 ms, 0 to 1
  onsets,             // the number of onsets (beats, strokes) of the sound until the time
  in_view,            // whether any part of a drawn object is in view
  touching,           // the names of the objects that a drawn object touches
  count,              // ENV.count: the number of updates of an environment until the time
  every,              // ENV.every: ticks from one update of an environment to the next
  by,                 // ENV.by: the matrix of one update of an environment
  world,              // the matrix from the object's space to the world; of an environment, the product of its updates
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
  std::uint16_t function = 0;  // FunctionView::id of an object's display function (betwixt/object.h), or a Query
  int component = -1;
  bool velocity = false;  // the rate of change instead, per second
  ObjectId layer;         // the layer that has the track; empty: the object's own track
  friend constexpr bool operator==(Target, Target) = default;
};

// A note: a text at a time. Other tools call it a marker.
struct Note {
  Time time;
  std::string text;
  std::optional<Color> color;  // in which the studio shows it; nullopt: its usual one
  friend bool operator==(const Note&, const Note&) = default;
};

// A part of the film with a name. The times in its block count from its beginning, and pass `speed` times as fast.
// Other tools call it a chapter or a composition.
struct Section {
  std::string name;
  Time begin, end;
  double speed = 1;
  friend bool operator==(const Section&, const Section&) = default;
};

// A place where a speaker waits: `step` in a script. Other tools call it a slide or a pause.
struct Pause {
  Time time;
  std::string text, note;  // a name, and what the speaker reads; both may be empty
  friend bool operator==(const Pause&, const Pause&) = default;
};

// A sentence for those who cannot see the film, from a time on.
struct Description {
  Time time;
  std::string text;
  friend bool operator==(const Description&, const Description&) = default;
};

// The patterns and names that each alias stands for. They are looked up at each use.
using Aliases = std::map<std::string, std::vector<std::string>, std::less<>>;

class Document {
 public:
  Document();
  explicit Document(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

  Rate rate() const;  // frames a second
  // Ticks a second: the time step of environments (transforms that are applied again and again), of contacts and of the
  // imaging server.
  Rate ticks() const;
  // Returns the first and the last time of the film; the last frame may be a little earlier. Without a `range` command
  // the film goes from frame 1 to the last event, camera cut, note or change of a display list. If none of these is
  // after frame 1, it lasts one second.
  std::pair<Time, Time> range() const;
  // Return what the script sets, or std::nullopt if it sets nothing. Only size() has a default for flat films: 1920 x
  // 1080.
  std::optional<std::pair<int, int>> size() const;  // width and height in pixels
  std::optional<int> samples() const;               // per pixel
  std::optional<int> subframes() const;             // the most pictures that are averaged into a blurred one
  bool transparent() const;                         // whether the background is transparent
  double aspect() const;                            // width / height; 16:9 if the script sets no size
  int frame_count() const;                          // frames in the range, ends included; at least 1

  std::vector<std::string> names() const;             // of all objects, in order of creation
  ObjectId find(std::string_view name) const;         // an empty id if no object has the name
  std::string name(ObjectId) const;                   // "none" if there is no such object
  std::string name(const Target&) const;              // "ball.position.x"
  std::vector<Note> notes(Time from, Time to) const;  // both ends included
  const std::vector<Section>& sections() const;       // in the order of the script
  std::vector<Pause> pauses() const;                  // in the order of time
  std::vector<Description> descriptions() const;      // in the order of time
  const Aliases& aliases() const;
  const std::map<Time, ObjectId>& cuts() const;  // the camera from each time on

  const Scene& scene() const { return *scene_; }
  friend bool operator==(const Document&, const Document&);  // same content

 private:
  std::shared_ptr<const Scene> scene_;
};

}  // namespace betwixt
