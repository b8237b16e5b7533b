// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live values: filters and layers on top of the tracks (live_parts.h), and the limits of evaluating them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/cancellation.h"
#include "program/collisions.h"
#include "program/deferred_evaluation.h"
#include "program/live_parts.h"
#include "track/operations.h"

namespace betwixt {
namespace {

bool looks_at_grid(const Filter& f) {
  const FilterSpec* spec = f.code ? nullptr : find_filter(f.name);
  return spec && spec->on_grid;
}

// Evaluates one function of one object at any time.
struct Worker : LiveParts {
  // The input of a filter.
  struct Through : Input {
    const Worker& w;
    const LiveStrand& s;
    std::size_t stage;
    int component;
    bool on_grid;
    bool called_off = false;
    Through(const Worker& worker, const LiveStrand& strand, std::size_t at, const Filter& f)
        : w(worker), s(strand), stage(at), component(f.component), on_grid(looks_at_grid(f)) {}
    Value at(double seconds) override {
      if (!(std::abs(seconds) <= longest_seconds)) seconds = 0;
      const Value v = look(from_seconds(seconds));
      return component < 0 ? v : Value(component_of(v, component));
    }
    Value look(Time t) {
      try {
        if (!called_off) return w.looked_at(s, stage, t, on_grid);
      } catch (const Cancelled&) {
        called_off = true;
      }
      return w.given_up();
    }
    Rate rate() const override { return w.scene.rate; }
    void work(std::uint64_t steps) override { w.asking.work(steps + 300); }
  };

  // Returns the input of a filter at a time. Stacked filters sample the same times again, on grids of their own. A
  // cache for this one answer makes their cost the sum, not the product.
  Value looked_at(const LiveStrand& s, std::size_t stage, Time t, bool on_grid = false) const {
    Cancellation::check();
    if (asking.work(20)) return given_up();
    const auto value = [&] { return on_grid && stage == 0 ? grid_value(s, t) : strand_value(s, stage, t); };
    if (s.filters.size() < 2) return value();
    const auto key = std::tuple(&s, stage, t.flicks);
    if (const auto known = seen.find(key); known != seen.end()) return known->second;
    Value v = value();
    if (!asking.given_up && seen.size() < most_seen) seen.emplace(key, v);
    return v;
  }
  static constexpr std::size_t most_seen = 1'000'000;
  mutable std::map<std::tuple<const LiveStrand*, std::size_t, std::int64_t>, Value> seen{};

  // Returns the value without filters, for one that will look at the same times again in other frames. What failed is
  // not kept, since each frame reports its own errors. Values of a stack are not kept either: what they cost depends on
  // what this answer has seen before.
  Value grid_value(const LiveStrand& s, Time t) const {
    if (asking.deferred || asking.in_haste() || asking.step) return strand_value(s, 0, t);
    const auto index = [](const auto& all, const auto& one) { return static_cast<std::int32_t>(&one - all.data()); };
    const FilterInputs::Key key{index(c.lives, live), index(live.strands, s), t.flicks};
    if (auto known = c.caches.filter_inputs.find(key, asking)) {
      asking.work(0);
      return *std::move(known);
    }
    const std::vector<Target> before = std::exchange(asking.read, {});
    Working working(asking);
    Value v = strand_value(s, 0, t);
    auto taken = working.done();
    std::vector<Target> read = std::exchange(asking.read, before);
    for (const Target& target : read) asking.note_read(target);
    if (taken && !asking.given_up && asking.problems.empty())
      c.caches.filter_inputs.keep(key, {v, *std::move(taken), std::move(read)});
    return v;
  }

  // Returns the object's own value without code, filters and layers, for a cycle or too much work.
  Value without_asking(Time t, int component) const {
    if (component >= 0) {
      const LivePart* part = part_of(component);
      return part ? settled(*part, t) : component_of(live.strands[0].set, component);
    }
    const LiveStrand& own = live.strands[0];
    if (own.plain >= 0) return strand_value(own, 0, t);
    if (own.parts.size() == 1 && own.parts[0].component < 0) return settled(own.parts[0], t);
    Value v = std::holds_alternative<Procedure>(own.set) ? at_rest({}) : own.set;
    for (const LivePart& part : own.parts) {
      const Value of_part = settled(part, t);
      if (const auto* d = std::get_if<double>(&of_part)) v = with_component(v, part.component, *d);
    }
    return v;
  }
  // Returns any value of the right type: it will be discarded.
  const Value& given_up() const {
    if (!stopped) stopped = without_asking({}, -1);
    return *stopped;
  }
  mutable std::optional<Value> stopped{};

  // Returns the value after the first `stage` filters.
  Value strand_value(const LiveStrand& s, std::size_t stage, Time t) const {
    if (stage == 0) {
      if (s.plain >= 0) return plain_value(c.plains[static_cast<std::size_t>(s.plain)], t);
      if (s.parts.size() == 1 && s.parts[0].component < 0) return part_value(s.parts[0], t);
      Value v = s.set;
      if (const auto* p = std::get_if<Procedure>(&v)) {
        LivePart whole;
        whole.type = spec_of(scene, live.function).type;
        const auto made = run(*p, whole, t);
        v = made ? *made : at_rest(whole);
      }
      for (const LivePart& part : s.parts) {
        const Value of_part = part_value(part, t);
        if (const auto* d = std::get_if<double>(&of_part)) v = with_component(v, part.component, *d);
      }
      return v;
    }
    const Filter& f = s.filters[stage - 1];
    Value plain = looked_at(s, stage - 1, t);
    if (f.segment && (t < f.segment->first || t > f.segment->second)) return plain;
    Through input(*this, s, stage - 1, f);
    const auto made = apply(f, input, t.seconds());
    if (input.called_off) throw Cancelled{};
    const auto pass = [&](const std::string& why, int line = 0) {
      const auto source = f.code ? std::optional(f.code->source) : std::nullopt;
      asking.say({Problem::filter, name(f.component), f.name, why, source, line});
      return plain;
    };
    if (!made) return pass(made.error().message, made.error().place.line);
    double n[4];
    if (!finite({n, static_cast<std::size_t>(to_numbers(*made, n))}))
      return pass("it returns a value that is not finite");
    if (f.component >= 0) {
      const auto* d = std::get_if<double>(&*made);
      return d ? with_component(plain, f.component, *d) : pass("it does not return a number");
    }
    const Type type = spec_of(scene, live.function).type;
    const auto fitting = fit(*made, type, scene);
    return fitting ? *fitting : pass(fitting.error().message);
  }

  Value plain_value(const Binding& b, Time t) const {
    if (b.channels == 0) return c.value(b, t, asking);
    double n[4] = {};
    c.evaluate(b, t, asking, n);
    return written_value(spec_of(scene, b.function).type, n, b.orientation);
  }

  const LivePart* part_of(int component) const {
    for (const LivePart& part : live.strands[0].parts)
      if (part.component == component) return &part;
    return nullptr;
  }

  Value value(Time t, int component) const {
    if (component >= 0) {
      const FunctionSpec& spec = spec_of(scene, live.function);
      const LivePart* part = part_of(component);
      const Value v = part ? part_value(*part, t) : component_of(live.strands[0].set, component);
      const auto* d = std::get_if<double>(&v);
      return d ? Value(std::clamp(*d, spec.low, spec.high)) : v;
    }
    Value v = laid_together(t);
    auto* place = std::get_if<Vec3>(&v);
    if (place && live.collision >= 0) *place = among_obstacles(c, live, *place, t, asking);
    return v;
  }

  // Returns the value of the tracks and layers.
  Value laid_together(Time t) const {
    Value v = strand_value(live.strands[0], live.strands[0].filters.size(), t);
    for (std::size_t i = 1; i < live.strands.size(); ++i) {  // in the order the layers were made
      const LiveStrand& s = live.strands[i];
      double w[4] = {1};
      c.evaluate(c.find(s.layer.index, fn::weight), t, asking, w);
      if (w[0] == 0 || t < s.from) continue;
      if (auto both = laid_over(v, strand_value(s, s.filters.size(), t), w[0], s.mix)) v = *std::move(both);
    }
    const FunctionSpec& spec = spec_of(scene, live.function);
    if (auto* d = std::get_if<double>(&v)) *d = std::clamp(*d, spec.low, spec.high);
    if (auto* p = std::get_if<Vec3>(&v); p && spec.low > -1e300)
      for (int i = 0; i < 3; ++i) (*p)[i] = std::clamp((*p)[i], spec.low, spec.high);
    return v;
  }
};

}  // namespace

namespace {

std::string too_far_back(const std::string& name, std::size_t steps, bool adds_up) {
  std::string said = fmt::format(
      " reads its own past through more than {} earlier times. Beyond them it uses its last value without code, so "
      "from here on the result is wrong: read the past in longer steps, or compute the value from t alone",
      steps);
  return adds_up ? said + fmt::format("; to sum up changes, compute {}.velocity instead", name) : said;
}

}  // namespace

Value Program::Compiled::free_position(const Live& live, Time t, Asking& asking) const {
  return Worker{{*this, live, asking}}.laid_together(t);
}

Value Program::Compiled::live_value(std::int32_t index, Time t, Asking& asking, int component) const {
  const Live& live = lives[static_cast<std::size_t>(index)];
  const Worker worker{{*this, live, asking}};
  Cancellation::check();
  if (const auto deferred = asking.deferred_answer({Question::live, static_cast<std::uint32_t>(index)}, t);
      deferred.yes) {
    if (!deferred.answer) {
      const LinearTwerpers plain;
      return worker.without_asking(t, component);
    }
    asking.say_all(*deferred.answer);
    const Value& value = deferred.answer->value;
    return component < 0 ? value : Value(component_of(value, component));
  }
  const Sought key{index, component, t.flicks};
  constexpr std::size_t deepest = 200;  // code that looks back further should add up instead
  const auto again = std::find(asking.open.begin(), asking.open.end(), key);
  if (again != asking.open.end() || asking.open.size() >= deepest) {  // no procedure is called now
    const bool circle = again != asking.open.end();
    asking.cut = std::min(asking.cut, circle ? static_cast<std::size_t>(again - asking.open.begin()) : 0);
    const std::string name = document.name(Target{{live.object}, live.function, -1});
    if (circle)
      asking.say(name, " depends on itself: it uses its last value without code there");
    else
      asking.say(name, too_far_back(name, deepest, has_velocity(spec_of(document.scene(), live.function).type)));
    return worker.without_asking(t, component);
  }
  if (const auto known = asking.found.find(key); known != asking.found.end()) {
    if (asking.is_open(known->second.taken)) {
      asking.found.erase(known);
      return live_value(index, t, asking, component);
    }
    asking.take(known->second.taken);
    return known->second.value;
  }
  const bool outermost = asking.open.empty();
  if (outermost && asking.cost > Asking::most_of_a_frame) {
    asking.say(
        {}, fmt::format("one frame takes more than {} steps: the remaining values are shown without code and filters",
                        Asking::most_of_a_frame));
    return worker.without_asking(t, component);
  }
  if (outermost) asking.begun = asking.cost, asking.given_up = false;
  Working working(asking);
  asking.open.push_back(key);
  asking.asked.push_back(key);
  Value v = worker.value(t, component);
  asking.open.pop_back();
  if (outermost && std::exchange(asking.given_up, false)) {
    asking.say(
        document.name(Target{{live.object}, live.function, -1}),
        fmt::format(" takes more than {} steps: its value is shown without code and filters", Asking::most_work));
    working.done();
    return worker.without_asking(t, component);
  }
  if (auto taken = working.done(); taken && asking.found.size() < 100'000)
    asking.found.emplace(key, Asking::Found<Value>{v, *std::move(taken)});
  return v;
}

}  // namespace betwixt
