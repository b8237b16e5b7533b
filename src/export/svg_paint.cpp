// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/svg_paint.h"

#include <tuple>

namespace betwixt {
namespace {

void add_stop(const Channel& color, const Channel& place, const SvgClock& clock, std::string& out) {
  const auto opacity = [](const KeyValue& v) { return short_number(std::clamp(v[3], 0.0, 1.0)); };
  const auto offset = [](const KeyValue& v) { return short_number(v[0]); };
  const auto is_opaque = [](const KeyPiece& p) { return p.begin[3] >= 1 && p.end[3] >= 1; };
  const bool opaque = std::all_of(color.pieces.begin(), color.pieces.end(), is_opaque);
  const KeyValue first = color.pieces[0].begin;
  out += fmt::format("      <stop offset=\"{}\" stop-color=\"{}\"", offset(place.pieces[0].begin), svg_color(first));
  if (!opaque) out += fmt::format(" stop-opacity=\"{}\"", opacity(first));
  if (color.constant() && place.constant()) {
    out += "/>\n";
    return;
  }
  out += ">\n";
  clock.animate(place, "offset", "        ", out, offset);
  clock.animate(color, "stop-color", "        ", out, [](const KeyValue& v) { return svg_color(v); });
  if (!opaque) clock.animate(color, "stop-opacity", "        ", out, opacity);
  out += "      </stop>\n";
}

}  // namespace

std::string add_gradient(const PlanarGradient& g, const std::string& id, const SvgClock& clock, double pixels,
                         std::string& out) {
  constexpr std::string_view spreads[] = {"", " spreadMethod=\"repeat\"", " spreadMethod=\"reflect\""};
  const bool linear = g.kind == GradientKind::linear;
  const std::string_view tag = linear ? "linearGradient" : "radialGradient";
  const KeyValue at = g.place.pieces[0].begin;
  const auto x = [&](double v) { return short_number(v * pixels); };
  const auto y = [&](double v) { return short_number(-v * pixels); };
  const auto moved = [&](const KeyValue& v) { return x(v[0]) + " " + y(v[1]); };
  const auto grown = [&](const KeyValue& v) { return x(std::max(v[2], 1e-9)) + " " + x(std::max(v[3], 1e-9)); };
  out += fmt::format("    <{} id=\"{}\" gradientUnits=\"userSpaceOnUse\"{}", tag, id,
                     spreads[static_cast<std::size_t>(g.spread)]);
  if (linear) {
    out += fmt::format(" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\">\n", x(at[0]), y(at[1]), x(at[2]), y(at[3]));
    constexpr std::string_view ends[] = {"x1", "y1", "x2", "y2"};
    for (std::size_t i = 0; i < 4; ++i)
      clock.animate(g.place, ends[i], "      ", out, [&](const KeyValue& v) { return i % 2 == 0 ? x(v[i]) : y(v[i]); });
  } else {
    out += fmt::format(" cx=\"0\" cy=\"0\" r=\"1\" gradientTransform=\"translate({}) scale({})\">\n", moved(at),
                       grown(at));
    constexpr std::string_view move = "animateTransform type=\"translate\" additive=\"replace\"",
                               grow = "animateTransform type=\"scale\" additive=\"sum\"";
    clock.animate(g.place, "gradientTransform", "      ", out, moved, move);
    clock.animate(g.place, "gradientTransform", "      ", out, grown, grow);
  }
  for (std::size_t i = 0; i < g.stops.size(); ++i) add_stop(g.stops[i], g.places[i], clock, out);
  out += fmt::format("    </{}>\n", tag);
  return fmt::format("url(#{})", id);
}

std::string add_effects(const PlanarLayer& l, const std::string& id, const SvgClock& clock, const SvgPage& page,
                        std::string& out) {
  const auto has = [](const Channel& c, std::size_t number) {
    return std::any_of(c.pieces.begin(), c.pieces.end(),
                       [&](const KeyPiece& p) { return p.begin[number] != 0 || p.end[number] != 0; });
  };
  const bool blurs = has(l.blur, 0), glows = has(l.glow, 0), drops = has(l.shade, 3);
  if (!blurs && !glows && !drops) return "";
  const auto length = [&](std::size_t number, double sign) {
    return [&page, number, sign](const KeyValue& v) { return short_number(sign * v[number] * page.pixels); };
  };
  const auto plain = [](std::size_t number) { return [number](const KeyValue& v) { return short_number(v[number]); }; };
  // An element with a number that may change.
  const auto animated = [&](std::string_view tag, const std::string& attributes, auto... numbers) {
    std::string values, moves;
    const auto one = [&](const Channel& c, std::string_view name, auto value) {
      values += fmt::format(" {}=\"{}\"", name, value(c.pieces[0].begin));
      clock.animate(c, name, "        ", moves, value);
    };
    const auto each = [&](const auto& number) { one(*std::get<0>(number), std::get<1>(number), std::get<2>(number)); };
    (each(numbers), ...);
    out += fmt::format("      <{}{}{}>\n{}      </{}>\n", tag, attributes, values, moves, tag);
  };
  const auto number = [](const Channel& c, std::string_view name, auto value) { return std::tuple(&c, name, value); };
  // Pictures are blurred in linear light, which is what filters do by themselves.
  out += fmt::format(
      "    <filter id=\"{}\" filterUnits=\"userSpaceOnUse\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n", id,
      short_number(-page.width), short_number(-page.height), short_number(2 * page.width),
      short_number(2 * page.height));
  std::string last = "SourceGraphic";
  if (blurs) {
    animated("feGaussianBlur", " result=\"blurred\"", number(l.blur, "stdDeviation", length(0, 1)));
    last = "blurred";
  }
  if (drops) {
    animated("feDropShadow", " in=\"" + last + "\" result=\"shadowed\"", number(l.shadow, "dx", length(0, 1)),
             number(l.shadow, "dy", length(1, -1)), number(l.shadow, "stdDeviation", length(2, 1)),
             number(l.shade, "flood-color", [](const KeyValue& v) { return svg_color(v); }),
             number(l.shade, "flood-opacity", plain(3)));
    last = "shadowed";
  }
  if (glows) {
    // The light around it is added where it does not cover.
    animated("feGaussianBlur", " in=\"" + last + "\" result=\"light\"", number(l.glow, "stdDeviation", length(1, 1)));
    out += "      <feComposite in=\"light\" in2=\"" + last + "\" operator=\"out\" result=\"around\"/>\n";
    animated("feComposite", " in=\"" + last + "\" in2=\"around\" operator=\"arithmetic\" k2=\"1\"",
             number(l.glow, "k3", plain(0)));
  }
  out += "    </filter>\n";
  return fmt::format(" filter=\"url(#{})\"", id);
}

}  // namespace betwixt
