// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Kinds of objects. Each is a row with its words, functions, extent and mesh. Other rooms read everything about a kind
// here.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/object.h"
#include "scene/extent.h"

namespace betwixt {

// The most letters of a text that are drawn.
inline constexpr std::size_t most_letters = 20'000;

// How a shape is filled.
enum class Fill : std::uint8_t {
  nothing,  // it has no shape
  surface,  // triangles from numbers alone: `mesh`
  outline,  // the area of its `contours`, or letters if it has none (see by_contours)
  file      // the mesh of a file
};

// The number of faces of round bodies.
struct Detail {
  int around = 48;   // around the widest circle
  bool even = true;  // thin parts have as many as wide ones, as wireframes need
  // Returns enough for a body of this radius in pixels: faces are off by less than a fifth of a pixel.
  static Detail for_pixels(double radius);
  double pixels() const { return around * around / 25.0; }  // the largest radius
  // Returns the number for a circle that is this share of the widest; even, at least 6.
  int around_thin(double share) const;
  friend bool operator==(const Detail&, const Detail&) = default;
};

struct KindRow {
  Kind kind = Kind::group;
  std::string_view name = {}, article = "a";
  std::string_view sentence = {}, written = {}, example = {};  // for help; `written`: its own parameters
  std::string_view functions = {};  // the shared ones: "radius height"; the others name their kinds themselves
  bool placed = true;               // whether objects of it have a place
  bool coordinates = false;         // others are placed by its numbers: `on`
  bool ground = false;              // grounds and walls: not what a film is about
  Fill fill = Fill::nothing;
  bool deep = false;      // an outline that can have a depth
  bool line = false;      // dashes and trims are of the line itself, not of a stroke
  bool detailed = false;  // its mesh has more triangles where it is larger in the picture
  // Returns a box in object space that contains the shape.
  Extent (*extent)(const Shape&) = nullptr;
  // Returns its half width along a world axis, `r` being that row of its matrix. Null for that of its box.
  double (*reach)(const Shape&, Vec3 r) = nullptr;
  // Returns the scale of the common mesh. Null if each shape has a mesh of its own.
  Vec3 (*measures)(const Shape&) = nullptr;
  // Returns whether a shape of a kind with a common mesh has one of its own, with details. Null if none has.
  bool (*own)(const Shape&) = nullptr;
  Mesh (*mesh)(const Shape&, const Detail&) = nullptr;
  std::vector<std::vector<Vec3>> (*contours)(const Shape&) = nullptr;
};

std::span<const KindRow> kinds();  // in the order of help
const KindRow& row_of(Kind);
std::optional<Kind> find_kind(std::string_view name);

std::string written_of(const KindRow&);  // with the parameters that all kinds of its sort have
std::string a_kind(Kind);                // "a sphere", "an environment"
// Whether the mesh of the shape has more triangles where it is larger in the picture.
inline bool detailed(const Shape& s) {
  const KindRow& row = row_of(s.kind);
  return row.own ? row.own(s) : row.detailed;
}
inline bool drawable(Kind k) { return row_of(k).fill != Fill::nothing; }
inline bool has_coordinates(Kind k) { return row_of(k).coordinates; }
inline bool placed(Kind k) { return row_of(k).placed; }

// The names, by the number of the kind.
inline const std::vector<std::string_view> kind_names = [] {
  std::vector<std::string_view> names(kinds().size());
  for (const KindRow& row : kinds()) names[static_cast<std::size_t>(row.kind)] = row.name;
  return names;
}();

}  // namespace betwixt
