// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/names.h"
#include "betwixt/language.h"
#include "betwixt/program.h"
#include "language/values.h"
#include "scene/document.h"
#include "scene/names.h"
#include "track/operations.h"

namespace betwixt {
namespace {

// A control that has not changed for this long, in seconds, has rested: the value holds until it moves again.
constexpr double rest = 0.1;

// Returns the number with the fewest digits that differs from v by less than `within`.
double shortest(double v, double within) {
  if (!(within > 0)) return v;
  char text[40];
  for (int digits = 1; digits < 17; ++digits) {
    const auto [end, failed] = std::to_chars(text, text + sizeof text, v, std::chars_format::scientific, digits - 1);
    double said = v;
    if (failed == std::errc()) std::from_chars(text, end, said);
    if (std::abs(said - v) < within) return said;
  }
  return v;
}

std::string shown(std::string_view address) { return std::string(address.substr(0, 60)); }

std::string in_words(std::size_t count) {
  static constexpr std::string_view words[] = {"no number", "one number", "two numbers", "three numbers"};
  return count < 4 ? std::string(words[count]) : fmt::format("{} numbers", count);
}

// Messages give angles in degrees, as scripts do.
Value made_of(Type type, std::span<const double> n) {
  std::array<double, 4> held{};
  for (std::size_t i = 0; i < n.size(); ++i) held[i] = row_of(type).angles ? n[i] * (pi / 180) : n[i];
  const Value v = value_of_numbers(type, held.data());
  return std::holds_alternative<bool>(v) ? Value(n[0] >= 0.5) : v;  // a fader has a middle
}

// Clamps a value to the limits of its function: a control does not know them.
Value within(const FunctionSpec& spec, Value v) {
  const auto limit = [&](double& d) { d = std::clamp(d, spec.low, spec.high); };
  if (auto* d = std::get_if<double>(&v)) limit(*d);
  if (auto* p = std::get_if<Vec3>(&v)) {
    for (int i = 0; i < number_count(spec.type); ++i) limit((*p)[i]);
  }
  if (auto* c = std::get_if<Color>(&v))
    for (double* channel : {&c->r, &c->g, &c->b}) *channel = std::max(*channel, 0.0);
  return v;
}

// Returns the value with as few digits as the tolerance of each number allows, in the author's units.
Value shortened(Type type, Value v, std::span<const double> within) {
  std::array<double, 4> n{};
  const int count = to_numbers(v, n.data());
  const double unit = row_of(type).angles ? pi / 180 : 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count) && i < within.size(); ++i)
    n[i] = shortest(n[i] / unit, within[i]) * unit;
  return within.empty() || std::holds_alternative<bool>(v) ? v : with_numbers(std::move(v), n.data(), count);
}

// Converts the tolerance of a message into that of each number of the dial's value, in the author's units.
std::vector<double> within_value(const Dial& dial, Type type, std::span<const double> within) {
  if (!dial.mapped || within.empty()) return {within.begin(), within.end()};
  std::array<double, 4> from{}, to{};
  const int count = std::min(to_numbers(dial.from, from.data()), to_numbers(dial.to, to.data()));
  std::vector<double> out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    out.push_back(within[0] * std::abs((to[i] - from[i]) / (dial.high - dial.low)) /
                  (row_of(type).angles ? pi / 180 : 1));
  return out;
}

Result<Value> mapped(const Dial& dial, double number) {
  const double k = std::clamp((number - dial.low) / (dial.high - dial.low), 0.0, 1.0);
  // from + k (to - from), in an order that gives both ends exactly.
  const std::optional<Value> rest = add_scaled(dial.from, dial.from, -k);
  const std::optional<Value> v = rest ? add_scaled(*rest, dial.to, k) : std::nullopt;
  if (!v) return fail(ErrorCode::type, dial.address + ": there is no value between its two values");
  return *v;
}

// Returns true if a script can contain the text; a recording needs that, and a sender may send any bytes.
bool writable(const std::string& text) {
  return !has_errors(load_text("define said text " + write_text(text), "text").diagnostics);
}

Result<Value> text_value(const FunctionSpec& spec, const Dial& dial, const std::string& text) {
  const bool picture = spec.name == "texture" || spec.name == "picture" || spec.name.ends_with("-map");
  if (spec.name == "file" || picture || spec.name == "font")
    return fail(ErrorCode::type,
                fmt::format("{}: {} is a file name, and live input cannot open files", dial.address, spec.name));
  if (!writable(text))
    return fail(ErrorCode::type, dial.address + ": this is not a text: it is not UTF-8 or has control characters");
  const std::string choice = "|" + spec.words + "|";
  if (!spec.words.empty() &&
      (text.find('|') != std::string::npos || choice.find("|" + text + "|") == std::string::npos))
    return fail(ErrorCode::type, fmt::format("{}: {} must be one of {}", dial.address, spec.name, spec.words));
  return Value(Text(text));
}

Result<Value> value_of(const FunctionSpec& spec, const Dial& dial, std::span<const double> numbers,
                       const std::string* text, std::span<const double> may_be_off = {}) {
  const bool whole = dial.target.component < 0;
  const Type type = whole ? spec.type : component_type(spec.type);
  if (type == Type::text) {
    if (!text) return fail(ErrorCode::type, fmt::format("{}: {} needs a text", dial.address, spec.name));
    return text_value(spec, dial, *text);
  }
  const std::size_t wanted = dial.mapped ? 1 : row_of(type).dials ? static_cast<std::size_t>(number_count(type)) : 0;
  if (wanted == 0) return fail(ErrorCode::type, fmt::format("a dial cannot control {}", to_string(type)));
  if (text || numbers.size() != wanted)
    return fail(ErrorCode::type, fmt::format("{}: {} needs {}, not {}", dial.address, spec.name, in_words(wanted),
                                             text ? "a text" : in_words(numbers.size())));
  if (!finite(numbers)) return fail(ErrorCode::range, dial.address + ": this is not a finite number");
  Result<Value> v = dial.mapped ? mapped(dial, numbers[0]) : made_of(type, numbers);
  if (!v) return v;
  v = shortened(type, *std::move(v), within_value(dial, type, may_be_off));
  FunctionSpec limits = spec;
  limits.type = type;
  if (row_of(spec.type).light && !whole) limits.low = 0;
  return within(limits, *std::move(v));
}

// Code and quaternions give all components together, so that no component can be set alone.
bool indivisible(const Value& v) { return std::holds_alternative<Quat>(v) || std::holds_alternative<Procedure>(v); }
bool indivisible(const Slot& slot) {
  bool any = slot.set && indivisible(*slot.set);
  slot.track->events.each([&](const Event& e) { any = any || indivisible(e.value); });
  return any;
}

// Removes the tracks and filters that would override a constant value. Other components keep theirs.
void give_way(Slot& slot, int component, Type type) {
  if (component < 0) {
    static_cast<Strand&>(slot) = {};
    slot.velocity = {};
    slot.filters.clear();
    return;
  }
  for (Strand* strand : {static_cast<Strand*>(&slot), &slot.velocity}) {
    *strand = split_into_components(*strand, type);
    strand->components[static_cast<std::size_t>(component)].reset();
  }
  std::erase_if(slot.filters, [&](const Filter& f) { return f.component == component; });
}

// Returns success if the dial can set its target in the current document.
Status can_turn(const Scene& s, const Dial& dial) {
  const Slot* slot = s.objects[dial.target.object.index].find(dial.target.function, dial.target.layer);
  if (dial.target.component < 0 || !slot || !indivisible(*slot)) return Nothing{};
  return fail(ErrorCode::type, fmt::format("{}: the whole of {} is set here, so its components cannot be controlled",
                                           dial.address, spec_of(s, dial.target.function).name));
}

Error unknown(const Scene& s, std::string_view address) {
  std::vector<std::string_view> known;
  for (const Dial& d : *s.dials) known.push_back(d.address);
  return fail(ErrorCode::name, fmt::format("no dial has the address {}", shown(address)), did_you_mean(address, known));
}

// Calls f(scene, dial, value) for each dial of the address on a copy of the scene. If one fails, nothing changes.
template <class F>
Result<Document> each_dial(const Document& document, std::string_view address, std::span<const double> numbers,
                           const std::string* text, std::span<const double> within, const F& f) {
  const Scene& before = document.scene();
  std::shared_ptr<Scene> after;
  for (const Dial& dial : *before.dials) {
    if (dial.address != address || !find_object(before, dial.target.object)) continue;
    const Result<Value> v = value_of(spec_of(before, dial.target.function), dial, numbers, text, within);
    if (!v) return v.error();
    if (!after) after = std::make_shared<Scene>(before);
    if (Status can = can_turn(*after, dial); !can) return can.error();
    f(*after, dial.target, *v);
  }
  if (!after) return unknown(before, address);
  return Document(std::move(after));
}

Type type_of(const Scene& s, const Target& t) {
  const Type whole = spec_of(s, t.function).type;
  return t.component < 0 ? whole : component_type(whole);
}

Event event_at(const Scene& s, const Target& t, Time when, const Value& v) {
  Event e;
  e.time = when, e.value = v;
  if (fits(Twerper::linear, type_of(s, t))) e.twerper = Twerper::linear;
  return e;
}

Target velocity_of(Target t) {
  t.velocity = true;
  return t;
}

bool has_events(const Scene& s, const Target& t, Time from, Time to) {
  const auto tracks = tracks_of(s, t);
  return std::any_of(tracks.begin(), tracks.end(),
                     [&](const Track* track) { return track->events.count(from, to) > 0; });
}

void erase(Scene& s, const Target& t, Time from, Time to = latest_time) {
  if (!has_events(s, t, from, to)) return;
  for (Track* track : edit_tracks(s, t)) track->events.erase(from, to);
}

// Copies the events from..to from the tracks of `then` to the same tracks of `now`.
void bring(Scene& now, Scene then, const Target& t, Time from, Time to) {
  if (!has_events(then, t, from, to)) return;
  const auto theirs = edit_tracks(then, t), ours = edit_tracks(now, t);
  for (std::size_t i = 0; i < std::min(theirs.size(), ours.size()); ++i)
    theirs[i]->events.each_between(from, to, [&](const Event& e) { ours[i]->events.put(e); });
}

// Returns the film's value of a target, rounded; nullopt if it cannot be the value of an event on the target's own
// track.
std::optional<Value> value_before(const Document& d, const Target& t, Time when, const Value& like) {
  const Object& o = d.scene().objects[t.object.index];
  const Slot* slot = o.find(t.function, t.layer);
  if (!fits(Twerper::linear, type_of(d.scene(), t)) || (slot && !slot->filters.empty())) return std::nullopt;
  if (t.function == fn::position && o.find(fn::obstacles)) return std::nullopt;
  Value v = Program::compile(d).read(t, when);
  std::array<double, 4> n{};
  const int count = to_numbers(v, n.data());
  if (v.index() != like.index() || v == like || !finite(std::span(n).first(static_cast<std::size_t>(count))))
    return std::nullopt;
  const double unit = row_of(type_of(d.scene(), t)).angles ? pi / 180 : 1;
  for (double& d : n) d = shortest(d / unit, 5e-7 * std::max(1.0, std::abs(d))) * unit;
  return with_numbers(std::move(v), n.data(), count);
}

}  // namespace

Result<Document> turn(const Document& document, std::string_view address, std::span<const double> numbers,
                      const std::string* text) {
  return each_dial(document, address, numbers, text, {}, [](Scene& s, const Target& t, const Value& v) {
    give_way(s.objects.edit(t.object.index).slot(t.function, t.layer), t.component, spec_of(s, t.function).type);
    set_value(s, t, v);
  });
}

Status Take::turn(std::string_view address, std::span<const double> numbers, const std::string* text, Time now,
                  std::span<const double> within) {
  const auto touched = touched_;
  Result<Document> next = each_dial(document_, address, numbers, text, within,
                                    [&](Scene& s, const Target& t, const Value& v) { record(s, t, v, now); });
  if (!next) {
    touched_ = touched;
    return next.error();
  }
  document_ = *std::move(next);
  return Nothing{};
}

void Take::record(Scene& s, const Target& t, const Value& v, Time now) {
  Event event = event_at(s, t, now, v);
  const auto at = std::find_if(touched_.begin(), touched_.end(), [&](const Touched& was) { return was.target == t; });
  if (at == touched_.end()) {
    if (const auto before = value_before(before_, t, now, v)) event.detail.edit().before = *before;
    erase(s, t, now);
    erase(s, velocity_of(t), now);
    if (has_events(s, velocity_of(t), earliest_time, now)) {
      Event ends;
      ends.time = now, ends.value = 0.0, ends.release = true;
      put_event(s, velocity_of(t), std::move(ends));
    }
    touched_.push_back({t, now, now, now, v});
    return put_event(s, t, std::move(event));
  }
  at->held = now;
  if (v == at->value) return;
  const Time frame = s.rate.span(1);
  if ((now - at->last).seconds() > rest && now - frame > at->last)
    put_event(s, t, event_at(s, t, now - frame, at->value));
  // Of several messages at one time the last one counts. The first event keeps the value from which the take began.
  if (now == at->from)
    for (const Track* track : tracks_of(s, t))
      if (const Event* first = track->events.find(now); first && first->detail) event.detail = first->detail;
  put_event(s, t, std::move(event));
  at->last = now, at->value = v;
}

void Take::end(Time now) {
  if (touched_.empty()) return;
  auto after = std::make_shared<Scene>(document_.scene());
  for (const Touched& t : touched_) {
    // The recording ends at `now`, but shows the last change for one frame at least. After it the film is as it was.
    const Time to = std::max({now, t.held, t.last + after->rate.span(1)});
    if (has_events(before_.scene(), t.target, to + Time{1}, latest_time) || to <= before_.range().second) {
      Event event = event_at(*after, t.target, to, t.value);
      const Value was = Program::compile(before_).read(t.target, to);
      if (const auto goes_on = value_before(before_, t.target, to, t.value)) {
        event.detail.edit().before = t.value;
        event.value = *goes_on;
      } else if (!fits(Twerper::linear, type_of(*after, t.target)) && was.index() == t.value.index()) {
        event.value = was;
      }
      put_event(*after, t.target, std::move(event));
    }
    for (const Target& one : {t.target, velocity_of(t.target)})
      bring(*after, before_.scene(), one, to + Time{1}, latest_time);
    covered_.push_back({t.target, t.from, to});
  }
  document_ = before_ = Document(std::move(after));
  touched_.clear();
}

std::string Take::text(std::string_view script) const {
  std::string out(script);
  if (!out.empty() && out.back() != '\n') out += '\n';
  out += "\n# Recorded\n";
  std::vector<Target> done;
  for (const Covered& c : covered_) {
    if (std::find(done.begin(), done.end(), c.target) != done.end()) continue;
    done.push_back(c.target);
    for (const Target& t : {c.target, velocity_of(c.target)}) {
      // A copy whose track has the recorded events only.
      auto only = std::make_shared<Scene>(document_.scene());
      erase(*only, t, earliest_time);
      for (const Covered& part : covered_) {
        if (!(part.target == c.target)) continue;
        if (has_events(script_.scene(), t, part.from, part.to))
          out += fmt::format("clear {} {}..{}\n", document_.name(t), format_time(part.from, document_.rate()),
                             format_time(part.to, document_.rate()));
        bring(*only, document_.scene(), t, part.from, part.to);
      }
      const Document recorded(std::move(only));
      const std::size_t tracks = tracks_of(recorded.scene(), t).size();
      for (std::size_t i = 0; i < tracks; ++i) {
        Target one = t;
        if (tracks > 1) one.component = static_cast<int>(i);
        if (has_events(recorded.scene(), one, earliest_time, latest_time))
          out += recorded.name(one) + "\n" + write_rows(recorded, one);
      }
    }
  }
  return out;
}

}  // namespace betwixt
