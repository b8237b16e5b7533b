// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/theme.h"

#include <algorithm>

#include "scene/document.h"

namespace betwixt {
namespace {

Color hex(unsigned rgb) { return {(rgb >> 16 & 255) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0}; }
template <std::size_t n>
std::array<Color, n> all_of(const unsigned (&rgb)[n]) {
  std::array<Color, n> out;
  std::transform(std::begin(rgb), std::end(rgb), out.begin(), hex);
  return out;
}

Theme dark_theme() {
  return {"dark",
          hex(0x0e1526),
          hex(0xeef1f6),
          hex(0x8b95a7),
          hex(0xc3cad6),
          hex(0x39424f),
          hex(0x1c2b47),
          hex(0xffd166),
          all_of({0x4aa8ff, 0xffb02e, 0x35c77a, 0xff6b6b, 0xb58cff, 0x2ccfd6, 0xff8fc7, 0xa6d82e, 0xff9248, 0x7d9bff,
                  0xe3c14a, 0x5ed3a8}),
          all_of({0xe6ebf4, 0xff8fa3, 0xf2c66d, 0x7cb7ff, 0xa5d76e, 0xf7a072, 0x7f8da3, 0x9fb0c8})};
}
Theme light_theme() {
  return {"light",
          hex(0xffffff),
          hex(0x1d2433),
          hex(0x6b7688),
          hex(0x3d4657),
          hex(0xd9dee6),
          hex(0xeef2f8),
          hex(0xffd24d),
          all_of({0x1f77d0, 0xd98200, 0x1e9e57, 0xdd4444, 0x8257d8, 0x0d9aa2, 0xd4579a, 0x6f9a12, 0xd6681c, 0x4f6edb,
                  0xa88a12, 0x2d9a77}),
          all_of({0x1d2433, 0xc2255c, 0x9a6700, 0x0b62c4, 0x2b7a31, 0xb35309, 0x7a8699, 0x5a6678})};
}
Theme paper_theme() {
  return {"paper",
          hex(0xf6f0e4),
          hex(0x2b2620),
          hex(0x857a6a),
          hex(0x51493e),
          hex(0xddd3c1),
          hex(0xebe3d2),
          hex(0xf0c35a),
          all_of({0x2f6f9f, 0xc77d1e, 0x3f7f4f, 0xb8483f, 0x77599b, 0x2f8384, 0xad5580, 0x73842a, 0xb5622f, 0x566ba8,
                  0x94791f, 0x3d8069}),
          all_of({0x2b2620, 0xa33b50, 0x8a6414, 0x2a5d8f, 0x44702f, 0xa0521c, 0x8d8374, 0x6b6153})};
}

}  // namespace

std::span<const Theme> themes() {
  static const std::array<Theme, 3> all{dark_theme(), light_theme(), paper_theme()};
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
  const Theme& own = *s.appearance.theme;
  return own.name.empty() ? themes()[0] : own;
}

}  // namespace betwixt
