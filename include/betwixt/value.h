// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The values that display functions (animatable properties) can have.
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

// The id of an object in a document, numbered in order of creation. Numbers are never reused, so the id of a removed
// object finds nothing.
struct ObjectId {
  static constexpr std::uint32_t nothing = 0xffffffff;
  std::uint32_t index = nothing;
  constexpr explicit operator bool() const { return index != nothing; }
  friend constexpr bool operator==(ObjectId, ObjectId) = default;
};

// A colour as the author writes it: sRGB, 0 to 1 (above 1 is brighter than white). Colours blend in linear light.
struct Color {
  double r = 1, g = 1, b = 1;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

// A rotation as three angles in radians, about the object's own x, y and z axes in that order. Whole turns count.
struct Angles {
  Vec3 xyz;
  friend constexpr bool operator==(const Angles&, const Angles&) = default;
};

// An immutable, shared value. Copying it never copies the text or the points.
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
using Moves = Shared<Motion>;  // the motion from this event to the next

// The parent of an object, and how much of the parent's matrix it inherits (docs/guide/attachment.md).
//   hang    the parent's matrix moves its position, and no more
//   attach  the parent also turns it; the parent's scale moves its position only
//   couple  the parent's whole matrix
//   detach  no parent: its tracks are in world space
//   letgo   no parent; the object keeps the matrix that the parent has at the time of this event
enum class AttachmentKind : std::uint8_t { detach, letgo, hang, attach, couple };
struct Attachment {
  AttachmentKind kind = AttachmentKind::detach;
  ObjectId parent;          // of hang, attach and couple
  bool keep_world = false;  // the object's matrix in world space does not jump at this event
  friend constexpr bool operator==(const Attachment&, const Attachment&) = default;
};

// A value that the author's code computes anew for each time. Two are equal if their code and language are equal.
class Routine;  // src/track/procedure.h
struct Procedure {
  std::shared_ptr<const Routine> code;
  friend bool operator==(const Procedure&, const Procedure&);
};

// The types of values. A display function has one type; all its events have values of this type.
enum class Type : std::uint8_t {
  scalar,       // double
  angle,        // double, radians
  pair,         // Vec3 with z = 0
  vector,       // Vec3
  color,        // Color
  boolean,      // bool
  rotation,     // Angles or Quat
  orientation,  // Quat
  shape,        // ObjectId: the geometry of that object; empty: the object's own
  aim,          // Vec3, a point in the world, or ObjectId
  text,         // Text
  points,       // Points
  names,        // Names
  attachment,   // Attachment
  transform,    // Matrix
  motion,       // Moves
};
std::string_view to_string(Type);  // in the author's words: "a number", "a vector", …
bool has_velocity(Type);           // whether the type has velocities (rates of change)

using Value = std::variant<double, Vec3, Color, bool, Angles, Quat, ObjectId, Text, Points, Names, Attachment,
                           Procedure, Matrix, Moves>;

}  // namespace betwixt
