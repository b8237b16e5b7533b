// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A document: an immutable value that holds a film. Copies are cheap and share everything; keeping one is undo.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"
#include "betwixt/time.h"
#include "betwixt/value.h"

namespace betwixt {

struct Scene;  // src/scene/document.h

// A display function of an object, or one component of it (0 x r, 1 y g, 2 z b; -1: the whole).
// What can be asked for, not set: the full matrix, of an environment its A; an environment's M, interval in ticks
// and number of updates; of a thing drawn what it touches, and whether any of it is in view.
inline constexpr std::uint16_t world_function = 0xffff, motion_function = 0xfffe, interval_function = 0xfffd,
                               count_function = 0xfffc, touching_function = 0xfffb, in_view_function = 0xfffa;
constexpr bool only_asked(std::uint16_t function) { return function >= in_view_function; }
struct Target {
  constexpr Target() = default;
  constexpr Target(ObjectId o, std::uint16_t f, int c = -1) : object(o), function(f), component(c) {}

  ObjectId object;
  std::uint16_t function = 0;
  int component = -1;
  bool velocity = false;  // its rate of change, per second
  ObjectId layer;         // the track on a layer; none: the object's own
  friend constexpr bool operator==(Target, Target) = default;
};

class Document {
 public:
  Document();
  explicit Document(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

  Rate rate() const;
  // First and last frame's time. Without a `range` command: frame 1 to the last event, one second where there are no
  // events.
  std::pair<Time, Time> range() const;
  int frame_count() const;  // frames in the range, ends included; at least 1

  std::vector<std::string> names() const;  // of all objects, in the order they were created
  ObjectId find(std::string_view name) const;
  std::string name(ObjectId) const;
  std::string name(const Target&) const;                                      // "ball.position.x"
  std::vector<std::pair<Time, std::string>> notes(Time from, Time to) const;  // both ends included

  const Scene& scene() const { return *scene_; }
  friend bool operator==(const Document&, const Document&);  // same content

 private:
  std::shared_ptr<const Scene> scene_;
};

}  // namespace betwixt
