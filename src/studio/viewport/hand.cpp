// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/hand.h"

#include <algorithm>
#include <cmath>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "betwixt/track.h"
#include "editor/made_by.h"
#include "language/values.h"
#include "program/asking.h"
#include "program/on_axes.h"
#include "scene/functions.h"

namespace betwixt::studio {
namespace {

constexpr std::size_t looked_through = 1000;  // a limit for the search for code in events

// Returns the parent of an object at a time.
ObjectId holder(const Document& d, ObjectId id, Time t) {
  for (const AttachmentSpan& s : attachments(d, id))
    if (s.from <= t && t < s.until) return s.to.kind >= AttachmentKind::hang ? s.to.parent : ObjectId{};
  return {};
}

bool hangs_only(const Document& d, ObjectId id, Time t) {
  for (const AttachmentSpan& s : attachments(d, id))
    if (s.from <= t && t < s.until) return s.to.kind == AttachmentKind::hang || s.computed;
  return false;
}

bool hangs_on(const Document& d, ObjectId id, Time t, const std::vector<ObjectId>& others) {
  for (ObjectId up = holder(d, id, t); up; up = holder(d, up, t))
    if (std::find(others.begin(), others.end(), up) != others.end()) return true;
  return false;
}

// Returns the function's own tracks that have events: the whole one, or those of components.
std::vector<TrackView> own_tracks(const Document& d, ObjectId id, std::uint16_t function) {
  std::vector<TrackView> out;
  for (const TrackView& t : tracks(d, Target{id, function}))
    if (t.event_count > 0 && !t.target.velocity && !t.target.layer) out.push_back(t);
  return out;
}

bool is_code(const Value* v) { return v && std::holds_alternative<Procedure>(*v); }

bool from_code(const Document& d, ObjectId id, std::uint16_t function) {
  if (is_code(value_set(d, {id, function}))) return true;
  bool code = false;
  for (const TrackView& t : own_tracks(d, id, function))
    if (t.event_count <= looked_through)
      each_event(d, t.target, t.first, t.last, [&](const EventView& e) { code = code || is_code(e.value); });
  return code;
}

Mat4 without_length(const Mat4& m) {
  Mat4 out;
  for (int c = 0; c < 3; ++c) {
    Vec3 unit{};
    unit[c] = 1;
    const Vec3 v = normalize(column(m, c), unit);
    for (int r = 0; r < 3; ++r) out(r, c) = v[r];
  }
  return out;
}

Value component(const Value& v, int c) {
  if (const auto* a = std::get_if<Angles>(&v)) return a->xyz[c];
  if (const auto* w = std::get_if<Vec3>(&v)) return (*w)[c];
  return v;
}

bool looks_at_something(const Program& p, ObjectId id, Time t) {
  const Value aim = p.read({id, fn::look_at}, t);
  const auto* at = std::get_if<ObjectId>(&aim);
  return !at || *at;
}

// Objects turn and scale about their pivots.
Vec3 pivot_in_world(const Program& program, ObjectId id, const Mat4& world, Time time) {
  for (const FunctionView& f : functions(program.document(), id))
    if (f.id == fn::pivot)
      if (const Value v = program.read(Target(id, fn::pivot), time); const auto* p = std::get_if<Vec3>(&v))
        return transform_point(world, *p);
  return translation_of(world);
}

// Returns the axes in whose numbers the position of an object counts.
std::optional<AxesSpace> axes_below(const Program& program, ObjectId id, Time t) {
  const Scene& scene = program.document().scene();
  if (!position_by_axes(scene, scene.objects[id.index])) return std::nullopt;
  Asking asking;
  const Result<AxesSpace> space = axes_space(program.compiled(), id, t, asking);
  return space ? std::optional(*space) : std::nullopt;
}

// Returns the numbers of axes after a move in metres, as tidy as a step there. Numbers that the move leaves alone stay.
Vec3 moved_numbers(const AxesSpace& axes, Vec3 numbers, Vec3 by, double step) {
  const Vec3 to = axes.place(numbers) + by;
  const std::optional<Vec3> there = axes.numbers_at(to);
  if (!there || !std::isfinite(to.x + to.y + to.z)) return numbers;
  Vec3 steps;  // how far the numbers change along a step
  for (int i = 0; i < 3; ++i) {
    Vec3 aside = to;
    aside[i] += step;
    if (const auto beside = axes.numbers_at(aside))
      for (int c = 0; c < 3; ++c) steps[c] = std::max(steps[c], std::abs((*beside)[c] - (*there)[c]));
  }
  Vec3 out = numbers;
  for (int c = 0; c < 3; ++c)
    if (std::abs((*there)[c] - numbers[c]) > 1e-6 * steps[c]) out[c] = rounded((*there)[c], steps[c]);
  return out;
}

}  // namespace

Quat orientation_of(const Value& v) {
  if (const auto* a = std::get_if<Angles>(&v)) return from_angles(a->xyz);
  const auto* q = std::get_if<Quat>(&v);
  return q ? normalize(*q) : Quat{};
}

std::string value_words(const Document& d, const Target& t, const Value& v) {
  return write_value(v, spec_of(d.scene(), t.function), t.component, [&](ObjectId id) { return d.name(id); });
}

double step_below(double at_most) {
  const double power = std::pow(10, std::floor(std::log10(std::clamp(at_most, 1e-12, 1e12))));
  const double times = at_most / power * (1 + 1e-9);
  return power * (times >= 5 ? 5 : times >= 2 ? 2 : 1);
}

double rounded(double v, double step) {
  const int decimals = -static_cast<int>(std::floor(std::log10(std::clamp(step, 1e-12, 1e12)) + 1e-9));
  const double power = std::pow(10, std::abs(decimals));
  const double out = decimals >= 0 ? std::round(v * power) / power : std::round(v / power) * power;
  return out == 0 ? 0 : out;
}

Vec3 angles_near(Quat q, Vec3 angles) {
  const Mat4 m = rotation(q);
  const double y = std::asin(std::clamp(m(0, 2), -1.0, 1.0));
  Vec3 a{std::atan2(-m(1, 2), m(2, 2)), y, std::atan2(-m(0, 1), m(0, 0))};
  if (std::abs(m(0, 2)) > 1 - 1e-12) {  // gimbal lock: x keeps its angle
    const double both = std::atan2(m(1, 0), m(1, 1));
    a = {angles.x, y, y > 0 ? both - angles.x : both + angles.x};
  }
  const auto nearest = [&](Vec3 v) {
    for (int i = 0; i < 3; ++i) v[i] += 2 * pi * std::round((angles[i] - v[i]) / (2 * pi));
    return v;
  };
  const Vec3 one = nearest(a), other = nearest({a.x + pi, pi - a.y, a.z + pi});
  return length(one - angles) <= length(other - angles) ? one : other;
}

std::string line_for(const Document& d, const Target& t, const Value& v, Time time, bool make_event) {
  const std::string value = value_words(d, t, v);
  if (!make_event) return "set " + d.name(t) + " " + value;
  return line_of_event(d, t, time, value);
}

std::vector<std::string> lines_to_bring(const Program& program, ObjectId id, const Mat4& world, Time time, double step,
                                        bool always) {
  const Document& d = program.document();
  std::vector<std::string> lines;
  if (looks_at_something(program, id, time)) {
    const auto own = own_tracks(d, id, fn::look_at);
    lines.push_back(line_for(d, {id, fn::look_at}, ObjectId{}, time, always || !own.empty()));
  }
  const Hand hand(program, time, {id}, always);
  if (hand.empty()) return {};
  const auto moved = hand.move(pivot_in_world(program, id, world, time) - hand.place(), step);
  const auto turned = hand.turn_to(from_matrix(world));
  lines.insert(lines.end(), moved.begin(), moved.end());
  lines.insert(lines.end(), turned.begin(), turned.end());
  return lines;
}

Hand::Hand(const Program& program, Time time, const std::vector<ObjectId>& ids, bool always)
    : program_(program), time_(time), always_(always) {
  const Document& d = program.document();
  for (const ObjectId id : ids)
    if (!d.name(id).empty() && !hangs_on(d, id, time, ids)) take(id);
  if (held_.empty()) return;
  place_ = held_.back().place;
  const Quat q = held_.back().parent * orientation_of(held_.back().rotation);
  const Mat4 m = rotation(q);
  for (int i = 0; i < 3; ++i) axes_[i] = column(m, i);
}

void Hand::take(ObjectId id) {
  const Document& d = program_.document();
  bool placed = false;
  for (const FunctionView& f : functions(d, id)) placed = placed || f.id == fn::position;
  if (!placed) return;  // a layer or an environment
  if (derived(d, id)) {
    derived_ = true;
    return;
  }
  Held h;
  h.id = id;
  const auto values =
      program_.read({{id, fn::position}, {id, fn::rotation}, {id, fn::scale}, Target{id, Query::world}}, time_);
  if (const auto* p = std::get_if<Vec3>(&values[0])) h.position = *p;
  if (const auto* s = std::get_if<Vec3>(&values[2])) h.scale = *s;
  h.rotation = values[1];
  const auto* world = std::get_if<Matrix>(&values[3]);
  if (!world) return;
  h.place = pivot_in_world(program_, id, **world, time_);
  const Mat4 to_world = program_.kinematics(id, time_).track_to_world;
  h.back = inverse(to_world).value_or(Mat4{});
  h.axes = axes_below(program_, id, time_);
  h.aims = looks_at_something(program_, id, time_);
  // A parent's rotation turns the object too, unless it hangs, which passes on only the position.
  if (!hangs_only(d, id, time_))
    h.parent = from_matrix(without_length(to_world));
  else if (const auto own = inverse(rotation(orientation_of(h.rotation)) * scaling(h.scale)))
    h.parent = from_matrix(without_length(linear_product(**world, *own)));
  const std::uint16_t all[] = {fn::position, fn::rotation, fn::scale};
  for (int i = 0; i < 3; ++i) h.still[i] = from_code(d, id, all[i]);
  held_.push_back(std::move(h));
}

std::string Hand::refusal(std::uint16_t function) const {
  if (derived_) return "this object belongs to a display list";
  const Document& d = program_.document();
  for (const Held& h : held_) {
    const int which = function == fn::position ? 0 : function == fn::rotation ? 1 : 2;
    if (h.still[which]) return "code computes " + d.name(Target{h.id, function}) + " is";
    if (which == 1 && h.aims) return d.name(h.id) + " looks at an object, so its rotation has no effect";
  }
  return {};
}

// Sets the whole function, or only the components that have tracks or change.
void Hand::put(const Held& h, std::uint16_t function, const Vec3& before, const Vec3& after, double least,
               std::vector<std::string>& lines) const {
  const Document& d = program_.document();
  if (length(after - before) < least) return;
  const bool angles = function == fn::rotation;
  const Value whole = angles ? Value(Angles{after}) : Value(after);
  const auto own = own_tracks(d, h.id, function);
  if (own.empty() || own.front().target.component < 0) {
    lines.push_back(line_for(d, {h.id, function}, whole, time_, always_ || !own.empty()));
    return;
  }
  for (int c = 0; c < 3; ++c) {
    if (after[c] == before[c]) continue;
    const bool keyed = std::any_of(own.begin(), own.end(), [&](const TrackView& t) { return t.target.component == c; });
    lines.push_back(line_for(d, {h.id, function, c}, component(whole, c), time_, always_ || keyed));
  }
}

void Hand::put_position(const Held& h, Vec3 by, double step, std::vector<std::string>& lines) const {
  if (h.still[0]) return;
  const Vec3 own = transform_vector(h.back, by);
  Vec3 to = h.axes ? moved_numbers(*h.axes, h.position, own, step) : h.position;
  for (int i = 0; i < 3 && !h.axes; ++i)
    if (std::abs(own[i]) > 1e-9 * (1 + length(own))) to[i] = rounded(h.position[i] + own[i], step);
  put(h, fn::position, h.position, to, 1e-12, lines);
}

std::vector<std::string> Hand::move(Vec3 by, double step) const {
  std::vector<std::string> lines;
  for (const Held& h : held_) put_position(h, by, step, lines);
  return lines;
}

// `way`: the axis in the object's own space and the angle about it, so that whole turns count.
void Hand::put_rotation(const Held& h, Quat to, std::optional<std::pair<Vec3, double>> way,
                        std::vector<std::string>& lines) const {
  constexpr double degree = pi / 180;
  const auto* before = std::get_if<Angles>(&h.rotation);
  if (!before) {
    to = normalize(to);
    const Quat q{rounded(to.w, 1e-4), rounded(to.x, 1e-4), rounded(to.y, 1e-4), rounded(to.z, 1e-4)};
    const auto own = own_tracks(program_.document(), h.id, fn::rotation);
    lines.push_back(line_for(program_.document(), {h.id, fn::rotation}, q, time_, always_ || !own.empty()));
    return;
  }
  Vec3 angles = before->xyz;
  const int steps = way ? 1 + static_cast<int>(std::abs(way->second) / 0.5) : 1;
  for (int i = 1; i < steps; ++i)
    angles = angles_near(axis_angle(way->first, way->second * i / steps) * from_angles(before->xyz), angles);
  angles = angles_near(to, angles);
  for (int i = 0; i < 3; ++i)
    angles[i] =
        std::abs(angles[i] - before->xyz[i]) < 1e-9 ? before->xyz[i] : rounded(angles[i] / degree, 0.1) * degree;
  put(h, fn::rotation, before->xyz, angles, 1e-9, lines);
}

std::vector<std::string> Hand::turn(Vec3 axis, double angle, double step) const {
  std::vector<std::string> lines;
  for (const Held& h : held_) {
    const Quat turned = axis_angle(axis, angle);
    const Vec3 way = h.place - place_;
    put_position(h, transform_vector(rotation(turned), way) - way, step, lines);
    if (h.still[1]) continue;
    const Vec3 own = transform_vector(rotation(conjugate(h.parent)), axis);
    put_rotation(h, axis_angle(own, angle) * orientation_of(h.rotation), std::pair(own, angle), lines);
  }
  return lines;
}

std::vector<std::string> Hand::turn_to(Quat world) const {
  std::vector<std::string> lines;
  for (const Held& h : held_)
    if (!h.still[1]) put_rotation(h, conjugate(h.parent) * world, std::nullopt, lines);
  return lines;
}

std::vector<std::string> Hand::scale(Vec3 factors, double step) const {
  std::vector<std::string> lines;
  const bool even = factors.x == factors.y && factors.y == factors.z;
  for (const Held& h : held_) {
    if (even) put_position(h, (factors.x - 1) * (h.place - place_), step, lines);
    if (h.still[2]) continue;
    Vec3 to = h.scale;
    for (int i = 0; i < 3; ++i)
      if (factors[i] != 1) to[i] = rounded(h.scale[i] * factors[i], 0.01 * std::clamp(std::abs(h.scale[i]), 1e-6, 1.0));
    put(h, fn::scale, h.scale, to, 1e-12, lines);
  }
  return lines;
}

}  // namespace betwixt::studio
