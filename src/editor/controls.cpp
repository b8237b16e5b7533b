// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/names.h"
#include "betwixt/language.h"
#include "language/values.h"
#include "scene/document.h"
#include "track/operations.h"

namespace betwixt {
namespace {

std::string shown(std::string_view address) { return std::string(address.substr(0, 60)); }

std::string in_words(std::size_t count) {
  static constexpr std::string_view words[] = {"no number", "one number", "two numbers", "three numbers"};
  return count < 4 ? std::string(words[count]) : fmt::format("{} numbers", count);
}

// Angles come in degrees, as in a script.
Value made_of(Type type, std::span<const double> n) {
  std::array<double, 4> held{};
  for (std::size_t i = 0; i < n.size(); ++i) held[i] = row_of(type).angles ? n[i] * (pi / 180) : n[i];
  const Value v = value_of_numbers(type, held.data());
  return std::holds_alternative<bool>(v) ? Value(n[0] >= 0.5) : v;  // a fader has a middle
}

// What lies beyond what is possible becomes the nearest that is not: a control knows no limits.
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

Result<Value> mapped(const Dial& dial, double number) {
  const double k = std::clamp((number - dial.low) / (dial.high - dial.low), 0.0, 1.0);
  // from + k (to - from), in an order that gives both ends exactly.
  const std::optional<Value> rest = add_scaled(dial.from, dial.from, -k);
  const std::optional<Value> v = rest ? add_scaled(*rest, dial.to, k) : std::nullopt;
  if (!v) return fail(ErrorCode::type, dial.address + ": its two values have nothing between them");
  return *v;
}

// Whether a script can say the text, as a recording will have to: whoever sends may send anything.
bool writable(const std::string& text) {
  return !has_errors(load_text("define said text " + write_text(text), "text").diagnostics);
}

Result<Value> text_value(const FunctionSpec& spec, const Dial& dial, const std::string& text) {
  if (spec.name == "file" || spec.name == "texture" || spec.name == "font")
    return fail(ErrorCode::type,
                fmt::format("{}: {} names a file, and live input opens none", dial.address, spec.name));
  if (!writable(text))
    return fail(ErrorCode::type, dial.address + ": this is not a text: it is not UTF-8, or has control characters");
  const std::string choice = "|" + spec.words + "|";
  if (!spec.words.empty() &&
      (text.find('|') != std::string::npos || choice.find("|" + text + "|") == std::string::npos))
    return fail(ErrorCode::type, fmt::format("{}: {} is one of {}", dial.address, spec.name, spec.words));
  return Value(Text(text));
}

Result<Value> value_of(const FunctionSpec& spec, const Dial& dial, std::span<const double> numbers,
                       const std::string* text) {
  const bool whole = dial.target.component < 0;
  const Type type = whole ? spec.type : component_type(spec.type);
  if (type == Type::text) {
    if (!text) return fail(ErrorCode::type, fmt::format("{}: {} takes a text", dial.address, spec.name));
    return text_value(spec, dial, *text);
  }
  const std::size_t wanted = dial.mapped ? 1 : row_of(type).dials ? static_cast<std::size_t>(number_count(type)) : 0;
  if (wanted == 0) return fail(ErrorCode::type, fmt::format("no dial can turn {}", to_string(type)));
  if (text || numbers.size() != wanted)
    return fail(ErrorCode::type, fmt::format("{}: {} wants {}, not {}", dial.address, spec.name, in_words(wanted),
                                             text ? "a text" : in_words(numbers.size())));
  if (!finite(numbers)) return fail(ErrorCode::range, dial.address + ": this is no number");
  Result<Value> v = dial.mapped ? mapped(dial, numbers[0]) : made_of(type, numbers);
  if (!v) return v;
  FunctionSpec limits = spec;
  limits.type = type;
  if (row_of(spec.type).light && !whole) limits.low = 0;
  return within(limits, *std::move(v));
}

// Code and quaternions give all components together; none of them can be turned alone.
bool indivisible(const Value& v) { return std::holds_alternative<Quat>(v) || std::holds_alternative<Procedure>(v); }
bool indivisible(const Slot& slot) {
  bool any = slot.set && indivisible(*slot.set);
  slot.track->events.each([&](const Event& e) { any = any || indivisible(e.value); });
  return any;
}

// Tracks and filters that would speak against a value for all times. Of the other components they stay.
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

Status turn_one(Scene& s, const Dial& dial, const Value& v, Time now) {
  const FunctionSpec& spec = spec_of(s, dial.target.function);
  const Target& t = dial.target;
  const Slot* slot = s.objects[t.object.index].find(t.function, t.layer);
  if (t.component >= 0 && slot && indivisible(*slot))
    return fail(ErrorCode::type,
                fmt::format("{}: {} is given as a whole here; it has no separate components", dial.address, spec.name));
  if (!s.recording) {
    give_way(s.objects.edit(t.object.index).slot(t.function, t.layer), t.component, spec.type);
    set_value(s, t, v);
    return Nothing{};
  }
  Event event;
  event.time = now;
  event.value = v;
  if (fits(Twerper::linear, t.component < 0 ? spec.type : component_type(spec.type))) event.twerper = Twerper::linear;
  put_event(s, t, std::move(event));
  return Nothing{};
}

Error unknown(const Scene& s, std::string_view address) {
  std::vector<std::string_view> known;
  for (const Dial& d : *s.dials) known.push_back(d.address);
  return fail(ErrorCode::name, fmt::format("no dial has the address {}", shown(address)), did_you_mean(address, known));
}

}  // namespace

Result<Document> turn(const Document& document, std::string_view address, std::span<const double> numbers,
                      const std::string* text, Time now) {
  const Scene& before = document.scene();
  std::shared_ptr<Scene> after;
  for (const Dial& dial : *before.dials) {
    if (dial.address != address || !find_object(before, dial.target.object)) continue;
    const Result<Value> v = value_of(spec_of(before, dial.target.function), dial, numbers, text);
    if (!v) return v.error();
    if (!after) after = std::make_shared<Scene>(before);
    if (Status turned = turn_one(*after, dial, *v, now); !turned) return turned.error();
  }
  if (!after) return unknown(before, address);
  return Document(std::move(after));
}

}  // namespace betwixt
