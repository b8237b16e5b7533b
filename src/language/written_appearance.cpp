// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes the look of a film.
#include <fmt/format.h>

#include "language/values.h"

namespace betwixt {

namespace {

std::string write_background(const Scene& s) {
  const Appearance& a = s.appearance;
  if (a.clear) return "background transparent\n";
  if (!s.background) return {};
  return a.below ? fmt::format("background {} to {}\n", write_color(*s.background), write_color(*a.below))
                 : fmt::format("background {}\n", write_color(*s.background));
}

std::string write_sky(const Appearance& a) {
  const Sky &sky = a.environment, plain;
  if (sky.kind == Sky::none) return {};
  std::string out = "sky ";
  out += sky.kind == Sky::picture ? write_text(a.sky_file) : std::string(sky_names[sky.kind]);
  if (sky.kind == Sky::day && sky.hour != plain.hour) out += " hour=" + write_number(sky.hour);
  if (sky.turn != 0) out += " turn=" + write_angle(sky.turn);
  if (sky.strength != 1) out += " strength=" + write_number(sky.strength);
  return out + "\n";
}

std::string write_view(const Appearance& a) {
  const Grade& g = a.grade;
  if (!g.table) return g.view == Grade::neutral ? "" : fmt::format("view {}\n", view_names[g.view]);
  const ViewFile& f = a.view_file;
  std::string out = "view " + write_text(f.file);
  const bool of_picture = g.table->takes == ColorTable::picture;
  if (g.view != Grade::neutral && of_picture) out += fmt::format(" takes={}", view_names[g.view]);
  if (!of_picture && !f.file.ends_with(".ocio")) out += " takes=light";
  if (g.table_share != 1) out += " strength=" + write_number(g.table_share);
  const auto add = [&](const char* key, const std::string& name) {
    if (!name.empty()) out += fmt::format(" {}={}", key, write_text(name));
  };
  add("display", f.display), add("through", f.through), add("look", f.look), add("space", f.space);
  return out + "\n";
}

std::string write_grade(const Grade& g) {
  const Grade plain;
  std::string out;
  if (g.white_balance != plain.white_balance) out += fmt::format("white-balance {}\n", write_number(g.white_balance));
  if (g.bloom != 0) out += fmt::format("bloom {}\n", write_number(g.bloom));
  if (g.vignette != 0) out += fmt::format("vignette {}\n", write_number(g.vignette));
  if (g.grain != 0) out += fmt::format("grain {}\n", write_number(g.grain));
  return out;
}

}  // namespace

std::string write_appearance(const Scene& s) {
  const Appearance& a = s.appearance;
  std::string out;
  if (a.size) out += fmt::format("size {}x{}\n", a.size->first, a.size->second);
  if (a.samples) out += *a.samples == 0 ? "samples auto\n" : fmt::format("samples {}\n", *a.samples);
  if (!a.pixel_filter.empty()) out += fmt::format("pixel-filter {}\n", a.pixel_filter);
  if (a.subframes) out += fmt::format("subframes {}\n", *a.subframes);
  if (a.flat) out += "film flat\n";
  out += write_background(s);
  if (a.ambient) out += fmt::format("ambient {}\n", write_color(*a.ambient));
  if (a.exposure != 0) out += fmt::format("exposure {}\n", write_number(a.exposure));
  if (a.fog)
    out += fmt::format("fog {} from {} to {}\n", write_color(a.fog->color), write_number(a.fog->from),
                       write_number(a.fog->to));
  if (a.ground_color) out += fmt::format("ground {}\n", write_color(*a.ground_color));
  if (a.ground != a.ground_color.has_value()) out += a.ground ? "ground on\n" : "ground off\n";
  if (a.sky) out += "sky on\n";
  out += write_sky(a) + write_view(a) + write_grade(a.grade);
  if (a.contact) out += "contact on\n";
  return out;
}

std::string write_theme(const Scene& s) {
  const Theme& t = *s.appearance.theme;
  if (t.name.empty()) return {};
  std::string out = "theme " + t.name + "\n";
  const Theme& base = *find_theme(t.name);
  for (const ThemeColor& c : theme_colors())
    if (c.of(t) != c.of(base)) out += fmt::format("theme {} {}\n", c.name, write_color(c.of(t)));
  const std::string background = write_background(s);
  return out + (background.empty() ? "background none\n" : background);
}

}  // namespace betwixt
