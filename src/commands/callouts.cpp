// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts beside things: they follow the things, and stand where nothing else is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "commands/command.h"
#include "commands/connecting.h"
#include "commands/furnishing.h"
#include "commands/furniture_rows.h"
#include "commands/measuring.h"
#include "commands/translating.h"
#include "exchange/fonts.h"
#include "language/values.h"
#include "program/compiled.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

struct TextSide {
  std::string_view word;  // "": only if no side is said
  double x, y;
};
constexpr TextSide text_sides[] = {{"right", 1, 0}, {"above", 0, 1}, {"left", -1, 0}, {"below", 0, -1},
                                   {"", 1, 1},      {"", -1, 1},     {"", 1, -1},     {"", -1, -1}};

struct Beside {
  double size = 0.28;  // of the letters
  bool line = false;   // from the text to the thing
  double away() const { return line ? 0.7 : 0.12; }
};

struct Rect {
  Vec3 low, high;
  bool meets(const Rect& b) const {
    return low.x < b.high.x && b.low.x < high.x && low.y < b.high.y && b.low.y < high.y;
  }
  bool holds(const Rect& b) const {
    return low.x <= b.low.x && b.high.x <= high.x && low.y <= b.low.y && b.high.y <= high.y;
  }
};

// Measures a thing, and then all other things that are drawn; the pieces below the thing belong to it.
std::vector<Measured> thing_and_others(Command& k, ObjectId id, Time t) {
  std::vector<ObjectId> all{id};
  const std::vector<ObjectId> parts = k.script.below(k.scene, k.scene.objects[id.index].name, false);
  std::set<std::uint32_t> own;
  for (const ObjectId part : parts) own.insert(part.index);
  for (std::uint32_t i = 0; i < k.scene.objects.size(); ++i)
    if (const Object& o = k.scene.objects[i]; !o.removed && i != id.index && !own.contains(i) && drawable(o.kind))
      all.push_back({i});
  return measured(k.scene, all, t);
}

// Returns where other things are, without those around the thing, such as a panel that it lies on.
std::vector<Rect> taken(const std::vector<Measured>& all, const Rect& own) {
  std::vector<Rect> out;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (const Rect r{all[i].low, all[i].high}; all[i].any && !r.holds(own)) out.push_back(r);
  return out;
}

// Returns what the camera sees in the plane of the thing; nullopt if it does not look straight at it.
std::optional<Rect> view_at(Command& k, double z, Time t) {
  const Camera eye = Program::compile(Document(std::make_shared<const Scene>(k.scene))).frame(t).camera;
  const Vec3 along = transform_vector(eye.world, {0, 0, -1}), up = transform_vector(eye.world, {0, 1, 0});
  if (along.z > -0.999 || up.y < 0.999) return std::nullopt;
  const Vec3 at = transform_point(eye.world, {});
  const double far = at.z - z;
  const double width = eye.orthographic ? eye.height * eye.aspect : 2 * far * std::tan(eye.fov / 2);
  const Vec3 half{width / 2, width / eye.aspect / 2, 0};
  return far > 0 ? std::optional(Rect{at - half, at + half}) : std::nullopt;
}

// Returns what the letters of a text cover, with a little room above and below.
Rect extent_of_text(const std::string& text, double size) {
  Rect out{{0, -0.2, 0}, {0, 0.75, 0}};
  for (const Contour& contour : text_outline(text, "DejaVu Sans").contours)
    for (const Vec3 p : contour) {
      out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y), 0};
      out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y), 0};
    }
  return {size * out.low, size * out.high};
}

Rect text_beside(const Rect& own, const TextSide& side, Vec3 text, double away) {
  const Vec3 middle = 0.5 * (own.low + own.high), half = 0.5 * (own.high - own.low);
  const double slanted = side.x != 0 && side.y != 0 ? 0.7 : 1;
  const Vec3 at = middle + Vec3{side.x * (half.x + slanted * away + text.x / 2),
                                side.y * (half.y + slanted * away + text.y / 2), 0};
  return {at - 0.5 * text, at + 0.5 * text};
}

// Returns the first side on which the text meets nothing and is in the picture; if there is none, the first that is
// allowed.
Rect free_place(const Rect& own, std::string_view said, Vec3 text, double away, const std::vector<Rect>& others,
                const std::optional<Rect>& view) {
  std::optional<Rect> first;
  for (const double further : {1.0, 1.8, 3.0})
    for (const TextSide& side : text_sides) {
      if (!said.empty() && side.word != said) continue;
      const Rect there = text_beside(own, side, text, further * away);
      if (!first) first = there;
      if (view && !view->holds(there)) continue;
      if (std::none_of(others.begin(), others.end(), [&](const Rect& r) { return r.meets(there); })) return there;
    }
  return *first;
}

template <bool line>
bool put_beside(Command& k) {
  auto& [s, c, time, layer, script] = k;
  ObjectId id;
  c.space();
  const std::string_view word = c.peek_word();
  if (!values(k).object(id)) return false;
  std::string text, said;
  c.space();
  const char* const written = c.at;
  if (!c.text(text)) return false;
  translate_text(script, text, c.since(written));
  Time length = from_seconds(0.5);
  for (const TextSide& side : text_sides)
    if (!side.word.empty() && c.accept_word(side.word)) said = side.word;
  if (!lasting(k, length, word)) return false;
  const Beside how{0.28, line};
  const std::string thing = s.objects[id.index].name, name = thing + (line ? "-callout" : "-label");
  const Time t = time.value_or(Time{});
  const std::vector<Measured> all = thing_and_others(k, id, t);
  const Measured& m = all[0];
  const auto border = end_of_link(s, m);
  if (!border) return c.fail(ErrorCode::range, fmt::format("'{}' draws nothing at this time", thing), word);
  const Rect own{m.low, m.high};
  const Rect letters = extent_of_text(text, how.size);
  const Vec3 extent = letters.high - letters.low;
  const Rect there = free_place(own, said, extent, how.away(), taken(all, own), view_at(k, m.middle().z, t));
  const Vec3 off = 0.5 * (there.low + there.high) - m.middle(), inner = border->middle;
  std::string lines = fmt::format("create {} text text={} size={} color={}\n", name, write_text(text),
                                  write_metres(how.size), theme_color(s, line ? &Theme::ink : &Theme::label));
  const double right = off.x - 0.5 * (letters.low.x + letters.high.x),
               up = off.y - 0.5 * (letters.low.y + letters.high.y);
  // A text of a piece lies below the same object as the piece.
  const std::size_t slash = name.rfind('/');
  const std::string above = slash == std::string::npos ? "" : fmt::format(", '{}'", name.substr(0, slash));
  lines +=
      fmt::format("set {}.position = \"link.beside('{}', {}, {}, {}, {}, {}{})\"\n", name, thing, write_metres(inner.x),
                  write_metres(inner.y), write_metres(inner.z), write_metres(right), write_metres(up), above);
  if (line) {
    Link link;
    link.color = theme_color(s, &Theme::muted);
    link.name = name + "/line", link.arrow = false, link.width = 0.02, link.gap = 0.06;
    link.from = {name, 0.5 * (letters.low + letters.high), extent.x / 2, extent.y / 2};
    link.to = *border;
    lines += lines_of_link(link);
  }
  if (time) lines += fmt::format("at {} fade-in {} for {}\n", write_time(t, s.rate), name, write_seconds(length));
  return all_or_none(k, lines, word);
}

constexpr Verb callouts_rows[] = {
    {"label", "[at TIME] label OBJECT \"TEXT\" [right|left|above|below] [for L]",
     "Puts a text beside an object, where nothing else is; it follows the object and stays upright.",
     "create b circle\nlabel b \"a disc\" below", Verb::timed, put_beside<false>,
     "OBJECT;;right left above below for…"},
    {"callout", "[at TIME] callout OBJECT \"TEXT\" [right|left|above|below] [for L]",
     "Puts a text near an object, with a line between them; it follows the object and stays upright.",
     "create b circle\nat 12f callout b \"a disc\"", Verb::timed, put_beside<true>,
     "OBJECT;;right left above below for…"},
};

}  // namespace

std::span<const Verb> callouts_verbs() { return callouts_rows; }

}  // namespace betwixt
