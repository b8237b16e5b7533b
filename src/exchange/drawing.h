// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Drawings from files: SVG by pugixml.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "betwixt/result.h"
#include "betwixt/value.h"
#include "exchange/file_source.h"

namespace betwixt {

// A gradient as a film has it. Kind and spread are numbers of GradientKind and GradientSpread.
struct DrawnGradient {
  std::uint32_t kind = 0, spread = 0;
  double turn = 0, move_x = 0, move_y = 0, size = 1;
  std::string stops;  // as they are written
  friend bool operator==(const DrawnGradient&, const DrawnGradient&) = default;
};

// A flat outline, or a group. `at` is relative to its group; its points are relative to `at`.
struct DrawnThing {
  static constexpr std::uint32_t nothing = 0xffffffff;
  std::string name;               // from the drawing; valid as an object's name after a '/'
  std::uint32_t above = nothing;  // its group, which comes earlier in the list
  bool group = false;
  Vec3 at;
  std::vector<Vec3> points, holes;  // in the format of a polygon's
  bool fills = true, strokes = false, round = false;
  Color color, stroke;
  double stroke_width = 0, transparency = 0, trim_to = 1;
  Vec3 dash;
  DrawnGradient gradient, stroke_gradient;
};
inline constexpr std::size_t most_drawn_things = 100'000, most_drawn_points = 2'000'000;

// A drawing one metre high, centred, y up; later shapes are in front.
struct DrawingFile {
  double width = 1;
  std::vector<DrawnThing> things;
  std::vector<std::string> left_out;  // sentences
};

// Reads a drawing in a process of its own. Errors: file, range.
Result<std::shared_ptr<const DrawingFile>> load_drawing(const std::string& path, const MayRead& may_read,
                                                        bool any_size = false);
// Reads it in this process, without protection.
Result<std::shared_ptr<const DrawingFile>> parse_drawing(const std::string& path, FileSource&);
Result<std::shared_ptr<const DrawingFile>> read_svg(const std::string& text, const std::string& path);

}  // namespace betwixt
