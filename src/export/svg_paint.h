// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Colours and gradients of an SVG, and how numbers change over its time.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "export/fit.h"
#include "export/formats.h"
#include "export/planar_layers.h"
#include "export/planar_look.h"
#include "track/track.h"

namespace betwixt {

inline std::string svg_color(const Color& c) {
  const auto byte = [](double v) { return std::lround(255 * std::clamp(v, 0.0, 1.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(c.r), byte(c.g), byte(c.b));
}
inline std::string svg_color(const KeyValue& v) { return svg_color(Color{v[0], v[1], v[2]}); }

// The time of an SVG.
struct SvgClock {
  Time from, until;

  double seconds() const { return (until - from).seconds(); }
  // Browsers count in whole microseconds, and the time of a frame means the value after a jump there.
  double share(Time t) const {
    constexpr double a_moment = 1.5e-6;
    if (t >= until) return seconds() > 0 ? 1 : 0;
    return seconds() > 0 ? std::clamp(((t - from).seconds() - a_moment) / seconds(), 0.0, 1.0) : 0;
  }
  // Writes linear keys from value to value; nothing if it is constant.
  template <class F>
  void animate(const Channel& c, std::string_view attribute, std::string_view indent, std::string& out, F value,
               std::string_view element = "animate") const {
    if (c.constant()) return;
    std::string times, values;
    for (const KeyPiece& p : c.pieces)
      for (const auto& [t, v] : {std::pair(p.from, p.begin), std::pair(p.until, p.end)}) {
        const char* between = times.empty() ? "" : ";";
        times += fmt::format("{}{:.9g}", between, share(t)), values += between + value(v);
      }
    // Key times begin with 0 and end with 1.
    if (!times.ends_with(";1")) times += ";1", values += values.substr(values.rfind(';'));
    out += fmt::format("{}<{} attributeName=\"{}\" dur=\"{}s\" fill=\"freeze\" keyTimes=\"{}\" values=\"{}\"/>\n",
                       indent, element, attribute, short_number(std::max(seconds(), 1e-9)), times, values);
  }
};

// Defines a gradient; returns how it is named as a colour. `pixels`: of a metre.
std::string add_gradient(const PlanarGradient&, const std::string& id, const SvgClock&, double pixels,
                         std::string& out);

// The picture, in user units.
struct SvgPage {
  double width = 0, height = 0, pixels = 1;  // pixels: of a metre
};
// Defines what blurs a group and lets it glow and drop a shadow; returns its attribute, or "" if it needs none.
std::string add_effects(const PlanarLayer&, const std::string& id, const SvgClock&, const SvgPage&, std::string& out);

}  // namespace betwixt
