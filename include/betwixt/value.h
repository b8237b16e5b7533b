// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a display function can have for a value.
//
// Room: track
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "betwixt/algebra.h"
#include "betwixt/math.h"

namespace betwixt {

// An object of a document, numbered in the order of creation. A number is never given out twice, so an id that outlives
// its object finds nothing.
struct ObjectId {
  static constexpr std::uint32_t nothing = 0xffffffff;
  std::uint32_t index = nothing;
  constexpr explicit operator bool() const { return index != nothing; }
  friend constexpr bool operator==(ObjectId, ObjectId) = default;
};

// A colour as the author writes it: sRGB, 0 to 1 (more is brighter than white). Blending is in linear light.
struct Color {
  double r = 1, g = 1, b = 1;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

// Rotation as three angles, radians, about the object's own x, y and z axes in that order. Whole turns count.
struct Angles {
  Vec3 xyz;
  friend constexpr bool operator==(const Angles&, const Angles&) = default;
};

// Immutable and shared: copying a value never copies text or points.
template <class T>
struct Shared {
  std::shared_ptr<const T> at;
  Shared() : at(empty()) {}
  Shared(T value) : at(std::make_shared<const T>(std::move(value))) {}
  const T& operator*() const { return *at; }
  const T* operator->() const { return at.get(); }
  friend bool operator==(const Shared& a, const Shared& b) { return a.at == b.at || *a.at == *b.at; }

 private:
  static const std::shared_ptr<const T>& empty() {
    static const auto e = std::make_shared<const T>();
    return e;
  }
};
using Text = Shared<std::string>;
using Points = Shared<std::vector<Vec3>>;
using Names = Shared<std::vector<std::string>>;
using Matrix = Shared<Mat4>;   // affine
using Moves = Shared<Motion>;  // from this event to the next one

// What an object hangs on, and how (rules, section 5).
//   hang    its position only is moved by the parent    attach  the parent turns it too, its scale does not
//   couple  the parent's whole matrix                   detach  nothing holds it: its tracks are in the world
//   letgo   nothing holds it, but what held it stays as it was at that moment
enum class AttachmentKind : std::uint8_t { detach, letgo, hang, attach, couple };
struct Attachment {
  AttachmentKind kind = AttachmentKind::detach;
  ObjectId parent;          // of hang, attach and couple
  bool keep_world = false;  // it stays where it is in the world at that moment
  friend constexpr bool operator==(const Attachment&, const Attachment&) = default;
};

// A value that the author's code computes (an inquisitive event). Equal: the same words in the same language.
class Routine;  // src/track/procedure.h
struct Procedure {
  std::shared_ptr<const Routine> code;
  friend bool operator==(const Procedure&, const Procedure&);
};

// The types that values have. A display function has one type, its values and its events too.
enum class Type : std::uint8_t {
  scalar,       // double
  angle,        // double, radians
  pair,         // Vec3 with z = 0
  vector,       // Vec3
  color,        // Color
  boolean,      // bool
  rotation,     // Angles or Quat
  orientation,  // Quat
  shape,        // ObjectId: the geometry of that object; none: its own
  aim,          // Vec3, a point of the world, or ObjectId
  text,         // Text
  points,       // Points
  names,        // Names
  attachment,   // Attachment
  transform,    // Matrix
  motion,       // Moves
};
std::string_view to_string(Type);  // in the author's words: "a number", "a vector", …
bool has_velocity(Type);           // whether values of the type have a rate of change

using Value = std::variant<double, Vec3, Color, bool, Angles, Quat, ObjectId, Text, Points, Names, Attachment,
                           Procedure, Matrix, Moves>;

}  // namespace betwixt
