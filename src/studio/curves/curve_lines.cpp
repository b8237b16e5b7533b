// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves/curve_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "scene/document.h"
#include "studio/viewport/hand.h"
#include "track/swing.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

constexpr double degree = pi / 180;

bool drawn(Type t) { return row_of(t).channels > 0 || t == Type::boolean; }

// Returns the event of a track at a time.
std::optional<EventView> view(const Document& d, const Target& t, std::optional<Time> at) {
  std::optional<EventView> out;
  if (at) each_event(d, t, *at, *at, [&](const EventView& e) { out = e; });
  return out;
}

Event changed(const Document& d, const EventAt& at) {
  const Event* e = find_event(d, at);
  return e ? *e : Event();
}

double fine(double v) { return rounded(v, std::max(1e-9, 1e-6 * std::abs(v))); }

}  // namespace

bool has_aligned_handles(const CurveLine& line, const Event& e) {
  if (!e.detail || !e.detail->tangent_in || !e.detail->tangent_out || !e.detail->handle_in || !e.detail->handle_out ||
      e.detail->before)
    return false;
  const double in = shown(line, *e.detail->tangent_in).value_or(0) / e.detail->handle_in->seconds();
  const double out = shown(line, *e.detail->tangent_out).value_or(0) / e.detail->handle_out->seconds();
  return std::abs(in + out) <= 1e-4 * std::max({1e-3, std::abs(in), std::abs(out)});
}

std::vector<CurveLine> curve_lines(const Document& d, const std::vector<ObjectId>& objects) {
  std::vector<CurveLine> all;
  int shade = 0;
  const auto add = [&](const Target& t, Type type, bool angles, const std::string& name, bool tracked, int numbers,
                       const std::vector<std::string_view>& components) {
    CurveLine line{
        t, 0, 3, shade, name, type, angles, type == Type::boolean, type == Type::color && t.component < 0, tracked};
    if (line.swatch || numbers == 1) {
      line.color = t.component >= 0 ? t.component : 3;
      all.push_back(line);
      return;
    }
    for (line.part = 0; line.part < numbers; ++line.part) {
      const auto i = static_cast<std::size_t>(line.part);
      line.color = numbers == 4 ? (line.part + 3) % 4 : line.part;
      line.name = name + "." +
                  std::string(numbers == 4            ? std::string_view("wxyz").substr(i, 1)
                              : i < components.size() ? components[i]
                                                      : "");
      all.push_back(line);
    }
  };
  for (const ObjectId id : objects)
    for (const FunctionView& f : functions(d, id)) {
      if (!f.animated || !drawn(f.type)) continue;
      const std::string before = objects.size() > 1 ? d.name(id) + "." : "";
      bool any = false;
      const std::size_t before_it = all.size();
      ObjectId layer;
      for (const bool velocity : {false, true})
        for (const TrackView& t : tracks(d, id)) {
          if (t.target.function != f.id || t.target.velocity != velocity || t.event_count == 0) continue;
          any = any || (!velocity && !t.target.layer);
          std::string name = before + d.name(t.target).substr(d.name(id).size() + 1);
          if (t.target.layer) name += " on " + d.name(t.target.layer);
          if (std::exchange(layer, t.target.layer) != t.target.layer) ++shade;  // its curves lie near those below
          // A rotation has three angles, or four numbers if its events are turns.
          bool turns = false;
          if (t.target.component < 0)
            each_event(d, t.target, t.first, t.first,
                       [&](const EventView& e) { turns = e.value && std::holds_alternative<Quat>(*e.value); });
          const bool angles = row_of(f.type).angles && !turns;
          add(t.target, f.type, angles, name, true,
              t.target.component >= 0 ? 1
              : turns                 ? 4
                                      : number_count(f.type),
              f.components);
        }
      // A component with a velocity but no events has a curve, too.
      for (const TrackView& t : tracks(d, id)) {
        Target value = t.target;
        value.velocity = false;
        if (!any || t.target.function != f.id || !t.target.velocity || value.component < 0) continue;
        if (std::ranges::find(all, value, &CurveLine::target) == all.end())
          add(value, f.type, row_of(f.type).angles, before + d.name(value).substr(d.name(id).size() + 1), false, 1, {});
      }
      if (!any)
        add({id, f.id}, f.type, row_of(f.type).angles, before + std::string(f.name), false, number_count(f.type),
            f.components);
      if (all.size() > before_it) ++shade;
    }
  return all;
}

std::optional<double> shown(const CurveLine& line, const Value& v) {
  if (const bool* on = std::get_if<bool>(&v)) return *on ? 1 : 0;
  double n[4];
  if (line.part >= to_numbers(v, n)) return std::nullopt;
  return n[line.part] / (line.degrees ? degree : 1);
}

Value with_shown(const CurveLine& line, const Value& v, double number) {
  if (std::holds_alternative<bool>(v)) return number >= 0.5;
  double n[4];
  const int count = to_numbers(v, n);
  n[line.part] = number * (line.degrees ? degree : 1);
  return with_numbers(v, n, count);
}

std::optional<LineSwing> swing(const Document& d, const CurveLine& line) {
  const Target& t = line.target;
  if (!line.tracked || t.velocity || t.layer) return std::nullopt;
  const Type whole = spec_of(d.scene(), t.function).type;
  for (const Track* track : tracks_of(d.scene(), t)) {
    const Type type = t.component < 0 ? whole : component_track_type(whole);
    const auto far = widest_swing(*track, type, t.component >= 0, d.rate());
    if (!far || far->number != line.part) continue;
    const double unit = line.degrees ? pi / 180 : 1;
    return LineSwing{far->at, far->value / unit,
                     fmt::format("{} swings to {:.4g} at {}: that is far beyond {:.4g}, which it has at {} and at {}.\n"
                                 "auto never goes beyond its events: choose it at {}",
                                 line.name, far->value / unit, format_time(far->at, d), far->rest / unit,
                                 format_time(far->from, d), format_time(far->to, d), format_time(far->from, d))};
  }
  return std::nullopt;
}

std::string_view twerper_of(const TrackView& track, const EventView& e) {
  return !track.twerper.empty() ? track.twerper : !e.twerper.empty() ? e.twerper : track.default_twerper;
}

std::vector<Handle> handles(const Document& d, const CurveLine& line, Time at) {
  using What = Handle::What;
  const EventAt event{line.target, at};
  const auto here = view(d, line.target, at), next = view(d, line.target, next_event(d, line.target, at + Time{1})),
             last = view(d, line.target, event_before(d, line.target, at));
  const auto track = betwixt::track(d, line.target);
  std::vector<Handle> all;
  if (!track || !here || !here->value) return all;
  const std::optional<double> value = shown(line, *here->value);
  const double before = here->cut_from ? shown(line, *here->cut_from).value_or(0) : value.value_or(0);
  if (!value) return all;
  all.push_back({What::point, event, at, *value, at, *value});
  if (line.steps || std::holds_alternative<Quat>(*here->value)) return all;
  const auto number = [&](const Value* v) { return v ? shown(line, *v).value_or(0) : 0; };
  const auto put = [&](What what, Time time, double v, double base) {
    all.push_back({what, event, time, v, at, base});
  };
  const auto third = [](Time length) { return Time{length.flicks / 3}; };
  // Handles after the event.
  if (next && next->value) {
    const Time length = next->time - at;
    const std::string_view by = twerper_of(*track, *here);
    const double to = shown(line, next->cut_from ? *next->cut_from : *next->value).value_or(0);
    if (by == "fcurve")
      put(What::handle_out, at + here->handle_out.value_or(third(length)), *value + number(here->tangent_out), *value);
    if (by == "hermite")
      put(What::tangent_out, at + third(length), *value + number(here->tangent_out) * third(length).seconds(), *value);
    if (by == "bezier" && to != *value) {
      const auto part = [&](double x) { return at + Time{std::llround(static_cast<double>(length.flicks) * x)}; };
      const auto& a = track->twerper.empty() ? here->arguments : track->arguments;
      put(What::bezier_start, part(a[0]), *value + a[1] * (to - *value), *value);
      Handle end{What::bezier_end, event, part(a[2]), *value + a[3] * (to - *value), next->time, to};
      all.push_back(end);
    }
    if (by != "hold") put(What::ease_out, at + here->ease_out, *value, *value);
  }
  // Handles before the event.
  if (last && last->value) {
    const Time length = at - last->time;
    const std::string_view by = twerper_of(*track, *last);
    if (by == "fcurve")
      put(What::handle_in, at - here->handle_in.value_or(third(length)), before + number(here->tangent_in), before);
    if (by == "hermite")
      put(What::tangent_in, at - third(length), before - number(here->tangent_in) * third(length).seconds(), before);
    if (by != "hold") put(What::ease_in, at - here->ease_in, before, before);
  }
  return all;
}

Lines handle_lines(const Document& d, const CurveLine& line, const Handle& h, Time time, double value, bool both) {
  using What = Handle::What;
  Event e = changed(d, h.event);
  const auto next = next_event(d, h.event.target, h.event.time + Time{1});
  const auto last = event_before(d, h.event.target, h.event.time);
  EventDetail& detail = e.detail.edit();
  // Returns a tangent in which one number is replaced.
  const auto way = [&](const std::optional<Value>& was, double number) -> Value {
    double none[4] = {};
    return with_shown(line, was ? *was : with_numbers(e.value, none), number);
  };
  const Time out = std::max(Time{}, time - h.event.time), in = std::max(Time{}, h.event.time - time);
  const bool aligned = both && has_aligned_handles(line, e);
  switch (h.what) {
    case What::point:
      return {};
    case What::handle_out:
      detail.tangent_out = way(detail.tangent_out, value - h.base), detail.handle_out = std::max(out, Time{1});
      if (aligned && out > Time{})
        detail.tangent_in =
            way(detail.tangent_in, fine(-(value - h.base) * detail.handle_in->seconds() / out.seconds()));
      break;
    case What::handle_in:
      detail.tangent_in = way(detail.tangent_in, value - h.base), detail.handle_in = std::max(in, Time{1});
      if (aligned && in > Time{})
        detail.tangent_out =
            way(detail.tangent_out, fine(-(value - h.base) * detail.handle_out->seconds() / in.seconds()));
      break;
    case What::tangent_out:
    case What::tangent_in: {
      const double seconds = (time - h.event.time).seconds();
      if (seconds == 0) return {};
      const double slope =
          rounded((value - h.base) / seconds, std::max(1e-6, std::abs((value - h.base) / seconds) / 1000));
      if (both || h.what == What::tangent_out) detail.tangent_out = way(detail.tangent_out, slope);
      if (both || h.what == What::tangent_in) detail.tangent_in = way(detail.tangent_in, slope);
      break;
    }
    case What::bezier_start:
    case What::bezier_end: {
      if (!next) return {};
      const Event to = changed(d, {h.event.target, *next});
      const double a = shown(line, e.value).value_or(0);
      const double b = shown(line, to.detail->before ? *to.detail->before : to.value).value_or(0);
      const double x = std::clamp(out.seconds() / (*next - h.event.time).seconds(), 0.0, 1.0);
      const std::size_t i = h.what == What::bezier_start ? 0 : 2;
      detail.arguments[i] = rounded(x, 0.01), detail.arguments[i + 1] = rounded((value - a) / (b - a), 0.01);
      break;
    }
    case What::ease_out:
      detail.ease_out = next ? std::min(out, *next - h.event.time) : out;
      break;
    case What::ease_in:
      detail.ease_in = last ? std::min(in, h.event.time - *last) : in;
      break;
  }
  return {event_line(d, h.event.target, e)};
}

Lines point_lines(const Document& d, const CurveLine& line, const std::vector<EventAt>& events, Time by, double more) {
  Lines lines;
  if (by != Time{}) lines = move_lines(d, events, by);
  if (more == 0) return lines;
  for (const EventAt& at : events) {
    if (at.target != line.target) continue;
    Event e = changed(d, at);
    const auto value = shown(line, e.value);
    if (!value || e.keep || e.release || std::holds_alternative<Quat>(e.value)) continue;
    e.time = at.time + by;
    // Rounding removes the errors of decimal sums.
    const auto put = [&](const Value& v) { return with_shown(line, v, rounded(*shown(line, v) + more, 1e-9)); };
    e.value = put(e.value);
    if (e.detail && e.detail->before) e.detail.edit().before = put(*e.detail->before);
    lines.push_back(event_line(d, at.target, e));
  }
  return lines;
}

}  // namespace betwixt::studio
