// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Kinds of objects. Each is a row: its words, its functions, where its shape ends and how that becomes triangles. What
// the other rooms know of a kind they read here.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/object.h"
#include "scene/extent.h"

namespace betwixt {

// Of a text, what is beyond so many letters is not drawn.
inline constexpr std::size_t most_letters = 20'000;

// What is between its borders.
enum class Fill : std::uint8_t {
  nothing,  // it has no shape
  surface,  // triangles made from numbers alone: `mesh`
  outline,  // what contours go round: its `contours`, or letters where it has none (see by_contours)
  file      // the mesh of a file
};

// How many faces round bodies have.
struct Detail {
  int around = 48;   // around the widest circle
  bool even = true;  // thin parts have as many as wide ones: what lines are drawn of
  // Enough for a body that reaches so many pixels from its middle: faces lie within a fifth of a pixel.
  static Detail for_pixels(double radius);
  double pixels() const { return around * around / 25.0; }  // at most
  // Around a circle that is so many times as wide as the widest; even, at least 6.
  int around_thin(double share) const;
  friend bool operator==(const Detail&, const Detail&) = default;
};

struct KindRow {
  Kind kind = Kind::group;
  std::string_view name = {}, article = "a";
  std::string_view sentence = {}, written = {}, example = {};  // for help; `written`: what can be said of it alone
  std::string_view functions = {};  // the shared ones: "radius height"; all others say themselves whose they are
  bool placed = true;               // objects of it are somewhere; else they are only spoken of
  bool ground = false;              // grounds and walls for the rest: not what a film is about
  Fill fill = Fill::nothing;
  bool deep = false;      // an outline that can have a depth
  bool line = false;      // dashes and trims are its own, not those of a stroke
  bool detailed = false;  // its mesh has more triangles where it is larger on the picture
  // A box in object space that holds the shape.
  Extent (*extent)(const Shape&) = nullptr;
  // How far it reaches from its middle along a world axis, `r` being that row of its matrix; null: as far as its box.
  double (*reach)(const Shape&, Vec3 r) = nullptr;
  // What the mesh is stretched by; null: it is made to measure.
  Vec3 (*measures)(const Shape&) = nullptr;
  Mesh (*mesh)(const Shape&, const Detail&) = nullptr;
  std::vector<std::vector<Vec3>> (*contours)(const Shape&) = nullptr;
};

std::span<const KindRow> kinds();  // in the order in which help tells of them
const KindRow& row_of(Kind);
std::optional<Kind> find_kind(std::string_view name);

std::string written_of(const KindRow&);  // with what all of its sort have
std::string a_kind(Kind);                // "a sphere", "an environment"
inline bool drawable(Kind k) { return row_of(k).fill != Fill::nothing; }
inline bool placed(Kind k) { return row_of(k).placed; }

// By the numbers of the kinds.
inline const std::vector<std::string_view> kind_names = [] {
  std::vector<std::string_view> names(kinds().size());
  for (const KindRow& row : kinds()) names[static_cast<std::size_t>(row.kind)] = row.name;
  return names;
}();

}  // namespace betwixt
