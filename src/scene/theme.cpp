// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/theme.h"

#include <algorithm>

#include "scene/document.h"

namespace betwixt {
namespace {

struct ThemeRow {
  const char* name;
  unsigned paper, ink, muted, label, faint, panel, accent;
  unsigned palette[12];
  unsigned code[code_class_names.size()];
};
constexpr ThemeRow theme_rows[] = {
    {"dark",
     0x0e1526,
     0xeef1f6,
     0x8b95a7,
     0xc3cad6,
     0x39424f,
     0x1c2b47,
     0xffd166,
     {0x4aa8ff, 0xffb02e, 0x35c77a, 0xff6b6b, 0xb58cff, 0x2ccfd6, 0xff8fc7, 0xa6d82e, 0xff9248, 0x7d9bff, 0xe3c14a,
      0x5ed3a8},
     {0xe6ebf4, 0xff8fa3, 0xf2c66d, 0x7cb7ff, 0xa5d76e, 0xf7a072, 0x7f8da3, 0x9fb0c8}},
    {"light",
     0xffffff,
     0x1d2433,
     0x6b7688,
     0x3d4657,
     0xd9dee6,
     0xeef2f8,
     0xffd24d,
     {0x1f77d0, 0xd98200, 0x1e9e57, 0xdd4444, 0x8257d8, 0x0d9aa2, 0xd4579a, 0x6f9a12, 0xd6681c, 0x4f6edb, 0xa88a12,
      0x2d9a77},
     {0x1d2433, 0xc2255c, 0x9a6700, 0x0b62c4, 0x2b7a31, 0xb35309, 0x7a8699, 0x5a6678}},
    {"paper",
     0xf6f0e4,
     0x2b2620,
     0x857a6a,
     0x51493e,
     0xddd3c1,
     0xebe3d2,
     0xf0c35a,
     {0x2f6f9f, 0xc77d1e, 0x3f7f4f, 0xb8483f, 0x77599b, 0x2f8384, 0xad5580, 0x73842a, 0xb5622f, 0x566ba8, 0x94791f,
      0x3d8069},
     {0x2b2620, 0xa33b50, 0x8a6414, 0x2a5d8f, 0x44702f, 0xa0521c, 0x8d8374, 0x6b6153}},
};

Color hex(unsigned rgb) { return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0}; }

Theme theme_of_row(const ThemeRow& r) {
  Theme t{r.name,       hex(r.paper), hex(r.ink),    hex(r.muted), hex(r.label),
          hex(r.faint), hex(r.panel), hex(r.accent), {},           {}};
  std::transform(std::begin(r.palette), std::end(r.palette), t.palette.begin(), hex);
  std::transform(std::begin(r.code), std::end(r.code), t.code.begin(), hex);
  return t;
}

}  // namespace

std::span<const Theme> themes() {
  static const std::array<Theme, 3> all{theme_of_row(theme_rows[0]), theme_of_row(theme_rows[1]),
                                        theme_of_row(theme_rows[2])};
  return all;
}

const Theme* find_theme(std::string_view name) {
  for (const Theme& t : themes())
    if (t.name == name) return &t;
  return nullptr;
}

std::span<const ThemeColor> theme_colors() {
  static constexpr ThemeColor all[] = {
      {"paper", &Theme::paper}, {"ink", &Theme::ink},     {"muted", &Theme::muted},   {"soft", &Theme::label},
      {"faint", &Theme::faint}, {"panel", &Theme::panel}, {"accent", &Theme::accent}, {"lake", nullptr, 0},
      {"amber", nullptr, 1},    {"leaf", nullptr, 2},     {"rose", nullptr, 3},       {"grape", nullptr, 4},
      {"lagoon", nullptr, 5},   {"blush", nullptr, 6},    {"moss", nullptr, 7},       {"clay", nullptr, 8},
      {"iris", nullptr, 9},     {"straw", nullptr, 10},   {"jade", nullptr, 11}};
  return all;
}

const Theme& theme_of(const Scene& s) {
  if (const Theme& own = *s.appearance.theme; !own.name.empty()) return own;
  const auto bright = [](const Color& c) { return 0.3 * c.r + 0.6 * c.g + 0.1 * c.b > 0.6; };
  const bool on_paper = s.background && !s.appearance.clear && bright(*s.background) &&
                        bright(s.appearance.below.value_or(*s.background));
  return *find_theme(on_paper ? "light" : "dark");
}

}  // namespace betwixt
