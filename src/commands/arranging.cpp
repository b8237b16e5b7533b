// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Arranges objects by their sizes: in a row, a column, a grid, a circle, or one next to another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/names.h"
#include "betwixt/pose.h"
#include "commands/command.h"
#include "commands/measuring.h"
#include "program/compiled.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

constexpr double far_away = 1e9;

// Moves the object by this vector in the world: sets its position, or adds an event at the command's time.
bool move_to(Command& k, const Measured& m, Vec3 by, std::string_view about) {
  const std::optional<Mat4> inward = inverse(m.to_world);
  const Vec3 to = inward ? m.position + transform_vector(*inward, by) : Vec3{NAN, 0, 0};
  if (!(length(to) < far_away))
    return k.cursor.fail(ErrorCode::range,
                         fmt::format("{} cannot be moved there: its parent is flat, or the place is too far away",
                                     k.scene.objects[m.id.index].name),
                         about);
  const Target t{m.id, fn::position};
  if (!k.time) return set_value(k.scene, t, to), true;
  Event e;
  e.time = *k.time;
  e.value = to;
  put_event(k.scene, t, std::move(e));
  return true;
}

struct Layout {
  std::string_view in;
  long columns = 0;
  double gap = 0.2, radius = 0;
  Vec3 centre;
};

// Returns offsets in a line along an axis, with the centres on it; downwards for y.
std::vector<Vec3> in_line(const std::vector<Measured>& all, const Layout& how, int axis) {
  double whole = -how.gap;
  for (const Measured& m : all) whole += m.size()[axis] + how.gap;
  const double way = axis == 1 ? -1 : 1;
  double at = how.centre[axis] - way * whole / 2;
  std::vector<Vec3> out;
  for (const Measured& m : all) {
    Vec3 middle = how.centre;
    middle[axis] = at + way * m.size()[axis] / 2;
    at += way * (m.size()[axis] + how.gap);
    out.push_back(middle);
  }
  return out;
}

// Returns offsets in a grid. All cells have the size of the largest object; the first row is at the top.
std::vector<Vec3> in_grid(const std::vector<Measured>& all, const Layout& how) {
  const std::size_t columns = how.columns > 0
                                  ? static_cast<std::size_t>(how.columns)
                                  : static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(all.size()))));
  const std::size_t rows = (all.size() + columns - 1) / columns;
  double wide = 0, high = 0;
  for (const Measured& m : all) wide = std::max(wide, m.size().x), high = std::max(high, m.size().y);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double column = static_cast<double>(i % columns) - static_cast<double>(std::min(columns, all.size()) - 1) / 2;
    const double row = static_cast<double>(i / columns) - static_cast<double>(rows - 1) / 2;
    out.push_back(how.centre + Vec3{column * (wide + how.gap), -row * (high + how.gap), 0});
  }
  return out;
}

// Returns offsets in a circle: the first at the top, then clockwise. Without a radius, the gaps are measured along the
// chords.
std::vector<Vec3> in_circle(const std::vector<Measured>& all, const Layout& how) {
  double largest = 0;
  for (const Measured& m : all) largest = std::max({largest, m.size().x, m.size().y});
  const double n = static_cast<double>(all.size()), chord = largest + how.gap;
  const double radius = how.radius > 0 ? how.radius : all.size() < 2 ? 0 : chord / (2 * std::sin(pi / n));
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / n;
    out.push_back(how.centre + Vec3{radius * std::sin(angle), radius * std::cos(angle), 0});
  }
  return out;
}

bool unknown_key(Cursor& c, std::string_view key, const char* start, std::string_view what, const char* known) {
  return c.fail(ErrorCode::name, fmt::format("{} has no '{}'", what, key.empty() ? std::string_view(start, 1) : key),
                key.empty() ? c.since(start) : key, known);
}
bool equals(Cursor& c, std::string_view key) {
  return c.accept('=') || c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", key));
}

bool arrange(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> things;
  if (!objects(k, word, things)) return false;
  if (!c.accept_word("in"))
    return c.fail_here(ErrorCode::syntax, "'in' is missing here", "arrange b* in row, column, grid or circle");
  static constexpr std::string_view ways[] = {"row", "column", "grid", "circle"};
  Layout how;
  how.in = c.next_word();
  if (std::find(std::begin(ways), std::end(ways), how.in) == std::end(ways)) {
    const Hint near = did_you_mean(how.in, {std::begin(ways), std::end(ways)});
    return no_choice(c, how.in, "the arrangement must be row, column, grid or circle", near);
  }
  while (!c.at_line_end()) {
    const char* const start = c.at;
    const std::string_view key = c.word();
    if (key != "gap" && key != "centre" && !(key == "columns" && how.in == "grid") &&
        !(key == "radius" && how.in == "circle"))
      return unknown_key(c, key, start, fmt::format("arrange … in {}", how.in),
                         "write gap= or centre=, columns= for a grid, radius= for a circle");
    if (!equals(c, key)) return false;
    if (key == "columns" && !c.whole_number(1, 1'000'000, "columns", how.columns)) return false;
    if (key == "centre" && !values(k).vector(3, how.centre, Unit::metres)) return false;
    if (key == "gap" && !values(k).scalar(how.gap, Unit::metres)) return false;
    if (key == "radius" && !values(k).scalar(how.radius, Unit::metres)) return false;
    if (key == "radius" && !(how.radius > 0))
      return c.fail(ErrorCode::range, "the radius must be greater than 0", c.since(start));
  }
  if (things.empty()) return true;
  const std::vector<Measured> all = measured(s, things, time.value_or(Time{}));
  const std::vector<Vec3> to = how.in == "row"      ? in_line(all, how, 0)
                               : how.in == "column" ? in_line(all, how, 1)
                               : how.in == "grid"   ? in_grid(all, how)
                                                    : in_circle(all, how);
  Rollback rollback(s);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!move_to(k, all[i], to[i] - all[i].middle(), word)) return false;
  rollback.keep();
  return true;
}

// An edge or the middle along an axis.
struct Side {
  std::string_view word;
  int axis, towards;  // -1: the low edge, 1: the high one, 0: the middle
};
constexpr Side sides[] = {{"left", 0, -1}, {"right", 0, 1}, {"bottom", 1, -1}, {"top", 1, 1},
                          {"back", 2, -1}, {"front", 2, 1}, {"centre", 0, 0}};
bool read_side(Command& k, const char* what, bool centre, Side& out) {
  const std::string_view w = k.cursor.next_word();
  std::vector<std::string_view> words;
  for (const Side& side : sides) {
    if (side.towards == 0 && !centre) continue;
    if (side.word == w) return out = side, true;
    words.push_back(side.word);
  }
  return k.cursor.fail(w.empty() ? ErrorCode::syntax : ErrorCode::type,
                       fmt::format("{} must be {}", what, fmt::join(words, ", ")),
                       w.empty() ? std::string_view(k.cursor.at, 0) : w, did_you_mean(w, words));
}

bool place(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> things;
  ObjectId other;
  if (!objects(k, word, things)) return false;
  if (!c.accept_word("next-to"))
    return c.fail_here(ErrorCode::syntax, "'next-to' is missing here", "as in place b next-to a side=right");
  if (!values(k).object(other)) return false;
  Side side = sides[1], align{"centre", 0, 0};
  double gap = 0.2;
  while (!c.at_line_end()) {
    const char* const start = c.at;
    const std::string_view key = c.word();
    if (key != "side" && key != "gap" && key != "align")
      return unknown_key(c, key, start, "place … next-to", "write side=, gap= or align=");
    if (!equals(c, key)) return false;
    if (key == "side" && !read_side(k, "the side", false, side)) return false;
    if (key == "gap" && !values(k).scalar(gap, Unit::metres)) return false;
    if (key == "align" && !read_side(k, "align", true, align)) return false;
  }
  if (align.towards != 0 && align.axis == side.axis)
    return c.fail(ErrorCode::syntax,
                  fmt::format("an object at the {} side cannot be aligned to the {}", side.word, align.word), word);
  if (!placed(s.objects[other.index].kind))
    return c.fail(ErrorCode::type,
                  fmt::format("objects cannot be placed next to {}", a_kind(s.objects[other.index].kind)), word);
  if (things.size() == 1 && things[0] == other)
    return c.fail(ErrorCode::name, fmt::format("'{}' cannot be placed next to itself", s.objects[other.index].name),
                  word);
  // Each object is placed next to the one before.
  std::vector<ObjectId> all{other};
  for (const ObjectId id : things)
    if (id != other) all.push_back(id);
  const std::vector<Measured> m = measured(s, all, time.value_or(Time{}));
  Vec3 low = m[0].low, high = m[0].high;
  Rollback rollback(s);
  for (std::size_t i = 1; i < m.size(); ++i) {
    Vec3 by = 0.5 * (low + high) - m[i].middle();
    by[side.axis] =
        side.towards > 0 ? high[side.axis] + gap - m[i].low[side.axis] : low[side.axis] - gap - m[i].high[side.axis];
    if (align.towards != 0)
      by[align.axis] =
          align.towards > 0 ? high[align.axis] - m[i].high[align.axis] : low[align.axis] - m[i].low[align.axis];
    if (!move_to(k, m[i], by, word)) return false;
    low = m[i].low + by, high = m[i].high + by;
  }
  rollback.keep();
  return true;
}

// The placement of a camera that fits a whole box into its picture, with a margin, in the present direction of view.
struct Fitted {
  Vec3 place;
  double height = 0;  // the height of an orthographic view
};
Fitted fit(const Camera& now, Vec3 low, Vec3 high, double aspect, double margin) {
  const auto axis = [&](int i) { return Vec3{now.world(0, i), now.world(1, i), now.world(2, i)}; };
  const Vec3 right = axis(0), up = axis(1), back = axis(2), middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const double across = std::tan(now.fov / 2) / (1 + margin), upwards = across / aspect;
  double away = 0, wide = 0, tall = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at{corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y, corner & 4 ? half.z : -half.z};
    const double x = std::abs(dot(at, right)), y = std::abs(dot(at, up)), near = dot(at, back);
    wide = std::max(wide, x), tall = std::max(tall, y);
    away = std::max(away, near + std::max(x / across, y / upwards));
  }
  if (!now.orthographic) return {middle + away * back, 0};
  const double before = dot(translation_of(now.world) - middle, back), least = length(half) + 1;
  return {middle + std::max(before, least) * back, 2 * (1 + margin) * std::max(tall, wide / aspect)};
}

bool put_on_camera(Command& k, ObjectId eye, FunctionId f, Value v) {
  const Target t{eye, f};
  if (!k.time) return set_value(k.scene, t, std::move(v)), true;
  Event e;
  e.time = *k.time, e.value = std::move(v);
  return put_event(k.scene, t, std::move(e)), true;
}

bool frame(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> things;
  double margin = 0.1;
  if (!objects(k, word, things)) return false;
  while (!c.at_line_end()) {
    const char* const start = c.at;
    const std::string_view key = c.word();
    if (key != "margin") return unknown_key(c, key, start, "frame", "margin=");
    if (!equals(c, key) || !values(k).scalar(margin)) return false;
    if (!(margin >= 0 && margin <= 100))
      return c.fail(ErrorCode::range, "a margin must be from 0 to 100", c.since(start));
  }
  if (things.empty()) return true;
  const Time t = time.value_or(Time{});
  const Program program = Program::compile(Document(std::make_shared<const Scene>(s)));
  const auto eye = program.compiled().camera_at(t);
  if (!eye)
    return c.fail(ErrorCode::name, "the film has no camera yet", word,
                  "create one first: create eye camera position=(0 2 10)");
  Vec3 low, high;
  bool any = false;
  for (const Measured& m : measured(s, things, t)) {
    for (int i = 0; i < 3; ++i) {
      low[i] = any ? std::min(low[i], m.low[i]) : m.low[i];
      high[i] = any ? std::max(high[i], m.high[i]) : m.high[i];
    }
    any = true;
  }
  const Camera now = program.frame(t).camera;
  const Fitted to = fit(now, low, high, now.aspect, margin);
  Rollback rollback(s);
  if (!move_to(k, measured(s, {ObjectId{*eye}}, t)[0], to.place - translation_of(now.world), word)) return false;
  if (now.orthographic) put_on_camera(k, {*eye}, fn::camera_height, to.height);
  if (program.compiled().nodes[program.compiled().node_of[*eye]].looks)
    put_on_camera(k, {*eye}, fn::look_at, 0.5 * (low + high));
  rollback.keep();
  return true;
}

constexpr Verb arranging_rows[] = {
    {"frame", "[at TIME] frame A [margin=0.1]",
     "Fits objects into the picture: moves the camera that the film has at the time, and looks from the same side. "
     "`margin` "
     "is a share of the picture.",
     "frame {ball,hand}", Verb::timed, frame},
    {"arrange", "arrange A in row|column|grid|circle [columns=N] [gap=METRES] [radius=METRES] [centre=(X Y Z)]",
     "Places objects in a row, a column, a grid or a circle, so that they do not overlap.",
     "arrange wheel* in row gap=0.5", Verb::timed, arrange,
     "OBJECT; in; row column grid circle; gap= centre= columns= radius=…"},
    {"place", "place A next-to B [side=left|right|top|bottom|front|back] [gap=METRES] [align=top|…]",
     "Places objects beside another one, so that they do not overlap.", "place ball next-to hand side=top gap=0",
     Verb::timed, place, "OBJECT; next-to; OBJECT; side= gap= align=…"},
};

}  // namespace

std::span<const Verb> arranging_verbs() { return arranging_rows; }

}  // namespace betwixt
