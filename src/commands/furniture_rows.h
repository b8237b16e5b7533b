// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The kinds that own children, a row each: the lines that make their pieces.
#pragma once

#include <fmt/format.h>

#include <string>

#include "commands/furnishing.h"
#include "scene/theme.h"

namespace betwixt {

// What a kind takes at `create` besides its functions.
enum class Takes : std::uint8_t { nothing, numbers, cells, series };  // series: numbers, or pairs of them

// Returns the color number n of the theme's palette, from 0; it begins again after the last.
std::string palette(const Scene&, std::size_t n);
std::string theme_color(const Scene&, Color Theme::*);

struct Furnishing {
  Scene& scene;
  ObjectId id;
  const std::string name;
  const Furniture& said;
  std::string lines;
  std::string problem, hint;  // set if it cannot be made
  int problem_at = 0;         // the column in the text of `of`, from 1; 0: none

  const Object& object() const { return scene.objects[id.index]; }
  template <class... A>
  void line(fmt::format_string<A...> format, A&&... arguments) {
    lines += fmt::format(format, std::forward<A>(arguments)...) + "\n";
  }
  // Returns the value that is set, or the default.
  Value value(std::string_view function) const;
  Vec3 vector(std::string_view function) const { return std::get<Vec3>(value(function)); }
  double number(std::string_view function) const { return std::get<double>(value(function)); }
  std::string text(std::string_view function) const;
  bool says(std::string_view function) const;  // whether the author has set it
  bool colored() const;
  // The colors of the film's theme.
  std::string muted() const { return theme_color(scene, &Theme::muted); }
  std::string label() const { return theme_color(scene, &Theme::label); }
  std::string faint() const { return theme_color(scene, &Theme::faint); }
  std::string ink() const { return theme_color(scene, &Theme::ink); }
  std::string panel() const { return theme_color(scene, &Theme::panel); }
  std::string tint(std::size_t n) const { return palette(scene, n); }
};

struct FurnitureRow {
  Kind kind;
  Takes takes = Takes::nothing;
  bool needs_axes = false;
  void (*make)(Furnishing&) = nullptr;
};
const FurnitureRow* furniture_of(Kind);

// chart_rows.cpp
void make_bars(Furnishing&);
void make_columns(Furnishing&);
void make_pie(Furnishing&);
void make_line_chart(Furnishing&);
void make_table(Furnishing&);
void make_matrix(Furnishing&);
// code_rows.cpp
void make_code(Furnishing&);
// diagram_rows.cpp
void make_diagram(Furnishing&);

}  // namespace betwixt
