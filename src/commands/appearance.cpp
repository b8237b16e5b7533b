// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands about the look of a film as a whole.
#include <fmt/format.h>

#include <cmath>

#include "base/names.h"
#include "commands/command.h"
#include "scene/colors.h"
#include "scene/materials.h"
#include "scene/pixel_filter.h"

namespace betwixt {
namespace {

bool size(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view w = c.next_word();
  const auto size = parse_size(w);
  if (w.empty()) return c.fail_here(ErrorCode::syntax, "a size is missing here");
  if (!size) {
    const std::string said(w.substr(0, 40));
    return c.fail(ErrorCode::range, fmt::format("'{}' is not a size: expected WIDTHxHEIGHT, each from 1 to 8192", said),
                  w, "as in size 1920x1080");
  }
  if (!finish(c)) return false;
  s.appearance.size = size;
  return true;
}

// Reads a whole number of `what`, and the end of the line. `rule`: which numbers fit. `hint` is for other numbers.
bool whole_number(Command& k, const char* what, const char* rule, bool (*fits)(long), std::optional<int>& out,
                  const Hint& hint = {}) {
  Cursor& c = k.cursor;
  c.space();
  const char* const start = c.at;
  double n = 0;
  if (!values(k).scalar(n)) return false;
  const auto whole = static_cast<int>(std::clamp(n, 0.0, 1e6));
  if (whole != n || !fits(whole))
    return c.fail(ErrorCode::range, fmt::format("the number of {} must be {}, not '{}'", what, rule, c.since(start)),
                  c.since(start), hint);
  if (!finish(c)) return false;
  out = whole;
  return true;
}

bool samples(Command& k) {
  if (k.cursor.accept_word("auto")) {
    if (!finish(k.cursor)) return false;
    k.scene.appearance.samples = 0;
    return true;
  }
  return whole_number(k, "samples", "1, 4, 9, 16 or auto", samples_fit, k.scene.appearance.samples,
                      "traced pictures take their number from the command line: --style traced --samples 64");
}

bool pixel_filter(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view w = c.next_word();
  const PixelFilter* filter = find_pixel_filter(w);
  if (!filter) {
    std::vector<std::string_view> names;
    for (const PixelFilter& f : pixel_filters()) names.push_back(f.name);
    const Hint near = did_you_mean(w, names);
    return no_choice(c, w, "a pixel filter must be one of " + fmt::format("{}", fmt::join(names, ", ")), near);
  }
  if (!finish(c)) return false;
  s.appearance.pixel_filter = filter->name;
  return true;
}

bool subframes(Command& k) {
  return whole_number(k, "subframes", "from 1 to 4096", subframes_fit, k.scene.appearance.subframes);
}

bool film(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view w = c.next_word();
  if (w != "flat" && w != "solid")
    return no_choice(c, w, "a film must be flat or solid", did_you_mean(w, {"flat", "solid"}));
  if (!finish(c)) return false;
  s.appearance.flat = w == "flat";
  return true;
}

// Reads a colour. If the word is no colour, suggests the words that are also allowed here.
bool color_or(Command& k, std::initializer_list<std::string_view> words, Color& out) {
  Cursor& c = k.cursor;
  c.space();
  const std::string_view w = c.peek_word();
  if (values(k).color(out)) return true;
  if (Hint near = did_you_mean(w, words); !near.empty() && c.error) set_hint(*c.error, std::move(near));
  return false;
}

bool background(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::optional<Color> color, below;
  const bool clear = c.accept_word("transparent");
  if (!clear && !c.accept_word("none")) {
    if (!color_or(k, {"transparent", "none"}, color.emplace())) return false;
    if (c.accept_word("to") && !values(k).color(below.emplace())) return false;
  }
  if (!finish(c)) return false;
  s.background = color, s.appearance.below = below, s.appearance.clear = clear;
  return true;
}

bool ambient(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Color color{0, 0, 0};
  if (!c.accept_word("off") && !color_or(k, {"off"}, color)) return false;
  if (!finish(c)) return false;
  s.appearance.ambient = color;
  return true;
}

bool exposure(Command& k) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* const start = c.at;
  double stops = 0;
  if (!values(k).scalar(stops)) return false;
  if (!(std::abs(stops) <= 20))
    return c.fail(ErrorCode::range, "an exposure must be from -20 to 20", c.since(start),
                  "1 more means twice the light");
  if (!finish(c)) return false;
  s.appearance.exposure = stops;
  return true;
}

bool distance(Command& k, const char* word, double& out, std::string_view& about) {
  Cursor& c = k.cursor;
  c.space();
  if (!c.accept_word(word))
    return c.fail(ErrorCode::syntax, fmt::format("'{}' and a distance are missing here", word), c.peek_word());
  c.space();
  const char* const start = c.at;
  if (!values(k).scalar(out, Unit::metres)) return false;
  about = c.since(start);
  if (!(out >= 0 && out <= 1e12)) return c.fail(ErrorCode::range, "a distance must be from 0 to 1e12 m", about);
  return true;
}

bool fog(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (c.accept_word("off")) {
    if (!finish(c)) return false;
    s.appearance.fog.reset();
    return true;
  }
  Appearance::Fog fog;
  std::string_view about;
  if (!color_or(k, {"off"}, fog.color) || !distance(k, "from", fog.from, about) || !distance(k, "to", fog.to, about))
    return false;
  if (!(fog.from < fog.to))
    return c.fail(ErrorCode::range, "the fog ends before it begins", about,
                  "write first the distance where it begins, then the one where it hides everything");
  if (!finish(c)) return false;
  s.appearance.fog = fog;
  return true;
}

bool ground(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::optional<Color> color;
  const bool off = c.accept_word("off");
  const std::string_view word = (c.space(), c.peek_word());
  if (word == "material" || (material_row(word).word == word && !named_color(word)))
    return no_choice(c, c.next_word(), "the ground has a color and no material",
                     "a plane has one: create floor plane size=(200 200) rotation=euler(-90deg 0 0) material=grass");
  if (!off && !c.accept_word("on") && !color_or(k, {"on", "off"}, color.emplace())) return false;
  if (!finish(c)) return false;
  s.appearance.ground = !off, s.appearance.ground_color = color;
  return true;
}

bool contact(Command& k) {
  return on_or_off(k.cursor, "contact shading must be on or off", k.scene.appearance.contact);
}

constexpr Verb appearance_rows[] = {
    {"size", "size WxH, as in size 1920x1080",
     "The size of the film's pictures in pixels; the command line overrides it.", "size 1920x1080",
     Verb::once | Verb::aside, size, "1280x720 1920x1080 3840x2160"},
    {"samples", "samples 1|4|9|16|auto",
     "The number of samples a pixel, more is smoother; the command line overrides it. `auto` is the usual number, and "
     "with `--style traced` as many as each pixel needs.",
     "samples 9", Verb::once | Verb::aside, samples, "1 4 9 16 auto"},
    {"pixel-filter", "pixel-filter box|tent|gaussian|mitchell|lanczos",
     "How the samples are averaged to pixels (reconstruction filter): `box` is sharp and fast, `gaussian` soft, "
     "`mitchell` between them, `lanczos` sharper. The command line overrides it.",
     "pixel-filter mitchell", Verb::once | Verb::aside, pixel_filter, "box tent gaussian mitchell lanczos"},
    {"subframes", "subframes N",
     "The largest number of subframes that are averaged for motion blur and depth of field; the command line overrides "
     "it.",
     "subframes 32", Verb::once | Verb::aside, subframes},
    {"film", "film flat|solid",
     "`flat` makes the film a drawing: all objects have exactly their own color, without light. The view is 9 m high, "
     "the pictures have 1920x1080 pixels and the background is dark, unless the script sets others. `solid`, the "
     "default, is a film of lit objects.",
     "film flat", Verb::once | Verb::aside, film, "flat solid"},
    {"background", "background COLOR [to COLOR] or background transparent|none",
     "The background: one color, a top and a bottom color, transparent, or none for the default gradient.",
     "background navy to black", Verb::once | Verb::aside, background, "none transparent COLOR; to; COLOR"},
    {"ambient", "ambient COLOR|off", "The ambient light, which comes from everywhere.", "ambient #202428",
     Verb::once | Verb::aside, ambient, "off COLOR"},
    {"exposure", "exposure STOPS", "Makes all light brighter or darker: 1 is twice as much, -1 half.", "exposure 0.5",
     Verb::once | Verb::aside, exposure, "NUMBER…"},
    {"fog", "fog COLOR from METRES to METRES or fog off",
     "Fog of a color: none up to the first distance from the camera, full from the second on.",
     "fog lightsteelblue from 10 to 60", Verb::once | Verb::aside, fog, "off COLOR; from; NUMBER; to; NUMBER"},
    {"ground", "ground on|off|COLOR", "An endless floor at y = 0 that takes shadows and fades into the background.",
     "ground on", Verb::once | Verb::aside, ground, "on off COLOR"},
    {"contact", "contact on|off",
     "Ambient occlusion: darkens corners, and places where things meet each other and the ground. (For collisions see "
     "`NAME.touching`.)",
     "contact on", Verb::once | Verb::aside, contact, "on off"},
};

}  // namespace

std::span<const Verb> appearance_verbs() { return appearance_rows; }

}  // namespace betwixt
