// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "language/values.h"
#include "scene/colors.h"
#include "scene/environment.h"
#include "scene/flat_shapes.h"
#include "scene/names.h"
#include "scene/power.h"
#include "track/along.h"
#include "track/procedure.h"

namespace betwixt {

std::string write_environment(const std::string& name, const Environment& e) {
  std::string out;
  for (std::size_t i = 0; i < e.size(); ++i) {
    const EnvironmentEvent& event = e.event(i);
    const auto* a = std::get_if<EnvironmentEvent::Animate>(&event.what);
    static constexpr std::string_view verbs[] = {"halt", "kill", "cancel", "animate"};
    out += fmt::format("at {}t {} {}", event.tick, verbs[event.what.index()], name);
    if (a) {
      const Timing& t = a->timing;
      Mat4 still = a->motion;
      for (int k = 0; k < 3; ++k) still(k, 3) = 0;
      // A matrix alone would be rounded to a rigid motion when read; with a second factor each digit stays.
      const std::string moved = still == Mat4{}
                                    ? "translate" + write_vector({a->motion(0, 3), a->motion(1, 3), a->motion(2, 3)})
                                    : write_matrix(a->motion) + (unrounded(a->motion) ? " scale(1)" : "");
      out += fmt::format(" every {}t by {}", t.interval, moved);
      if (t.change != 0)
        out += fmt::format(" {} {}t per {}t", t.change > 0 ? "slower" : "faster", std::abs(t.change), t.period);
      if (t.ceiling != Timing{}.ceiling) out += fmt::format(" limit {}t", t.ceiling);
      if (a->from) out += fmt::format(" from {}t", *a->from);
      if (a->until) out += fmt::format(" until {}t", *a->until);
      if (a->keep_phase) out += " keep-phase";
    }
    out += "\n";
  }
  return out;
}

std::string write_number(double v) { return v == 0 ? "0" : fmt::format("{}", v); }

// Ten decimals are finer than a flick. Long times are written as hours:minutes:seconds, because a double of seconds
// would lose flicks.
std::string write_seconds(Time t) {
  const auto trim = [](std::string text) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
  };
  const std::int64_t flicks = std::abs(t.flicks);
  const char* sign = t.flicks < 0 ? "-" : "";
  if (flicks < 10'000 * flicks_per_second) return sign + trim(fmt::format("{:.10f}", Time{flicks}.seconds())) + "s";
  const std::int64_t minutes = flicks / (60 * flicks_per_second);
  return fmt::format("{}{}:{:02}:{}", sign, minutes / 60, minutes % 60,
                     trim(fmt::format("{:013.10f}", Time{flicks % (60 * flicks_per_second)}.seconds())));
}

std::string write_time(Time t, Rate rate) {
  const std::string frames = format_time(t, rate);
  return frames.back() == 'f' ? frames : write_seconds(t);
}

std::string write_cut_way(const CutWay& way, Rate rate) {
  const double frames = rate.frame_number(way.length) - 1;
  const bool whole = frames == std::round(frames) && rate.span(frames) == way.length;
  std::string out = "for " + (whole ? write_number(frames) + "f" : write_seconds(way.length));
  if (way.kind != ChangeKind::dissolve) out += " wipe=" + std::string(change_names[static_cast<std::size_t>(way.kind)]);
  return out;
}

std::string write_vector(Vec3 v, int numbers) {
  std::string out = "(";
  for (int i = 0; i < numbers; ++i) out += (i ? " " : "") + write_number(v[i]);
  return out + ")";
}

std::string write_color(Color c) {
  std::uint32_t rgb = 0;
  for (double v : {c.r, c.g, c.b})
    rgb = rgb << 8 | static_cast<std::uint32_t>(std::lround(std::min(1.0, std::max(0.0, v)) * 255));
  if (from_bytes(rgb) == c) {
    const auto name = name_of_color(rgb);
    return name.empty() ? fmt::format("#{:06x}", rgb) : std::string(name);
  }
  return "rgb" + write_vector({c.r, c.g, c.b});
}

std::string write_angle(double radians) {
  if (radians == 0) return "0";
  const double degrees = std::round(radians / (pi / 180) * 1e9) / 1e9;
  if (degrees * (pi / 180) == radians) return write_number(degrees) + "deg";
  return write_number(radians) + "rad";
}

std::string write_angles(Vec3 v) {
  return fmt::format("({} {} {})", write_angle(v.x), write_angle(v.y), write_angle(v.z));
}

std::string write_matrix(const Mat4& m) {
  std::string out = "matrix(";
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) out += (row + column ? " " : "") + write_number(m(row, column));
  return out + ")";
}

namespace {

std::string write_points(const std::vector<Vec3>& list) {
  const bool flat = std::all_of(list.begin(), list.end(), [](Vec3 p) { return p.z == 0; });
  std::string out = "(";
  for (const Vec3 p : list) out += (out.size() > 1 ? " " : "") + write_vector(p, flat ? 2 : 3);
  return out + ")";
}

// Writes ring by ring if all rings are closed; otherwise the list is a single open one.
std::string write_holes(const std::vector<Vec3>& list) {
  const Contours all = rings(list);
  std::size_t points = 0;
  for (const auto& ring : all) points += ring.size() + 1;
  if (all.empty() || points != list.size()) return write_points(list);
  std::string out = "(";
  for (const auto& ring : all) out += (out.size() > 1 ? " " : "") + write_points(ring);
  return out + ")";
}

}  // namespace

std::string write_value(const Value& v, const FunctionSpec& spec, int component,
                        const std::function<std::string(ObjectId)>& name_of) {
  const Type type = component < 0 ? spec.type : component_type(spec.type);
  if (const auto* d = std::get_if<double>(&v)) {
    if (row_of(type).angles) return write_angle(*d);
    const bool time = spec.unit == Unit::moment || spec.unit == Unit::seconds || spec.unit == Unit::opening;
    return write_number(*d) + (time ? "s" : spec.unit == Unit::millimetres ? "mm" : "");
  }
  if (const auto* p = std::get_if<Vec3>(&v); p && spec.name == "focus") return write_number(-p->z);
  if (const auto* p = std::get_if<Vec3>(&v)) return write_vector(*p, component_count(type) == 2 ? 2 : 3);
  if (const auto* c = std::get_if<Color>(&v))
    return *c == no_color && spec.rest == Value(no_color) ? "none" : write_color(*c);
  if (const auto* b = std::get_if<bool>(&v)) return *b ? "on" : "off";
  if (const auto* a = std::get_if<Angles>(&v)) return "euler" + write_angles(a->xyz);
  if (const auto* q = std::get_if<Quat>(&v))
    return fmt::format("quat({} {} {} {})", write_number(q->w), write_number(q->x), write_number(q->y),
                       write_number(q->z));
  if (const auto* id = std::get_if<ObjectId>(&v)) {
    const std::string name = name_of(*id);
    return name.empty() ? "none" : type == Type::shape ? "shape(" + name + ")" : name;
  }
  if (const auto* t = std::get_if<Text>(&v)) return spec.words.empty() ? write_text(**t) : **t;
  if (const auto* list = std::get_if<Points>(&v))
    return spec.name == "holes" ? write_holes(**list) : write_points(**list);
  if (const auto* a = std::get_if<Attachment>(&v)) {
    static constexpr std::string_view words[] = {"detach", "letgo", "hang on ", "attach to ", "couple to "};
    std::string out(words[static_cast<std::size_t>(a->kind)]);
    if (a->kind >= AttachmentKind::hang) out += name_of(a->parent) + (a->keep_world ? " keep-world" : "");
    return out;
  }
  if (const auto* m = std::get_if<Matrix>(&v)) return write_matrix(**m);
  if (const auto* m = std::get_if<Moves>(&v)) return (*m)->factors.empty() ? "\"\"" : to_string(**m);
  if (const Along* a = along(v)) {
    const std::string road = name_of(a->road);
    return road.empty() ? write_value(spec.rest, spec, component, name_of)
                        : fmt::format("along {} {}", road, write_number(a->share));
  }
  if (const auto* p = std::get_if<Procedure>(&v)) return "= " + write_text(p->code->source);
  std::string out = "(";
  for (const auto& n : *std::get<Names>(v)) out += (out.size() > 1 ? " " : "") + n;
  return out + ")";
}

}  // namespace betwixt
