// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Themes: the colors of what has no color of its own. Colours are sRGB.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "betwixt/value.h"
#include "scene/code_languages.h"

namespace betwixt {

struct Theme {
  std::string name;  // of the theme that it began as; "": a film without one
  Color paper, ink, muted, label, faint, panel, accent;
  std::array<Color, 12> palette{};
  std::array<Color, code_class_names.size()> code{};  // by CodeClass
  friend bool operator==(const Theme&, const Theme&) = default;
};

// The themes that have a name: dark, light, paper.
std::span<const Theme> themes();
const Theme* find_theme(std::string_view name);

// The colors of a theme by their names, which scripts can use: ink, muted …, and the twelve of the palette.
struct ThemeColor {
  std::string_view name;
  Color Theme::*one = nullptr;  // or a color of the palette
  std::size_t in_palette = 0;
  Color of(const Theme& t) const { return one ? t.*one : t.palette[in_palette]; }
  Color& of(Theme& t) const { return one ? t.*one : t.palette[in_palette]; }
};
std::span<const ThemeColor> theme_colors();

struct Scene;
// Returns the theme of a film. Without one, that is the light theme on a bright background, otherwise the dark one.
const Theme& theme_of(const Scene&);

}  // namespace betwixt
