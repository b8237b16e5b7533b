// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/constant_code.h"

#include <algorithm>

#include "program/compile.h"
#include "program/live_parts.h"
#include "track/procedure.h"

namespace betwixt {
namespace {

constexpr std::uint64_t most_constant_steps = 3'000'000;  // of all code while a film is compiled: some 30 ms

// Has no time and no film. Notes that the code reads one of them.
class Timeless final : public Questions {
 public:
  Timeless(const Scene& scene, std::uint32_t object) : scene_(scene), object_(object) {}
  bool timeless() const override { return true; }
  bool asked() const { return asked_; }

  double seconds() const override { return asked_ = true, 0; }
  Rate rate() const override { return asked_ = true, scene_.rate; }
  std::string_view self() const override { return scene_.objects[object_].name; }
  const Routine* procedure(std::string_view name) override {
    const NamedProcedure* p = find_procedure(scene_, name);
    return p && (p->role == Role::value || p->role == Role::steps) ? p->code.get() : nullptr;
  }
  Result<Value> value(std::string_view, double, std::uint64_t&) override { return no(); }
  Result<Vec3> place(std::string_view, double, double, std::uint64_t&) override { return no(); }
  Status axes(std::string_view, double, AxesSpace&, std::uint64_t&) override { return no(); }
  Turn turn(std::string_view) override { return asked_ = true, Turn(); }
  Result<State> state(std::string_view, double, std::uint64_t&) override { return no(); }

 private:
  Error no() const { return asked_ = true, fail(ErrorCode::type, "there is no time"); }

  const Scene& scene_;
  const std::uint32_t object_;
  mutable bool asked_ = false;
};

class Folding {
 public:
  Folding(CompiledFilm& film, std::uint32_t object, FunctionId function)
      : film_(film), object_(object), function_(function) {}

  std::optional<Slot> slot(const Slot& said) {
    const FunctionSpec& spec = spec_of(scene(), function_);
    const Type type = spec.type;
    Slot out = said;
    bool any = false;
    if (said.set && scripted(*said.set))
      if (auto v = value(*said.set, type)) out.set = bounded(*std::move(v), spec), any = true;
    any |= track(out.track, type);
    for (auto& c : out.components) any |= track(c, component_track_type(type));
    return any ? std::optional(std::move(out)) : std::nullopt;
  }

 private:
  const Scene& scene() const { return film_.document.scene(); }

  static Value bounded(Value v, const FunctionSpec& spec) {
    if (auto* d = std::get_if<double>(&v)) *d = std::clamp(*d, spec.low, spec.high);
    if (auto* p = std::get_if<Vec3>(&v); p && spec.low > -1e300)
      for (int i = 0; i < 3; ++i) (*p)[i] = std::clamp((*p)[i], spec.low, spec.high);
    return v;
  }

  // Replaces the code of all rows or of none.
  bool track(Cow<Track>& track, Type type) {
    if (!scripted(*track) || track->before != Extrapolation::hold || track->after != Extrapolation::hold) return false;
    std::vector<Event> made;
    bool all = true;
    track->events.each([&](const Event& e) {
      const bool code = scripted(e.value), before = e.detail && e.detail->before && scripted(*e.detail->before);
      const bool last = e.time == track->events.back().time;
      const bool blends = last || e.twerper != Twerper::unset || track->global != Twerper::unset;
      all = all && !e.keep && (!code || blends);
      if (!all || (!code && !before)) return;
      Event constant = e;
      auto v = code ? value(e.value, type) : e.value;
      auto cut = before ? value(*e.detail->before, type) : std::nullopt;
      all = v && (cut || !before);
      if (!all) return;
      constant.value = *std::move(v);
      if (before) constant.detail.edit().before = std::move(cut);
      made.push_back(std::move(constant));
    });
    if (!all) return false;
    for (Event& e : made) track.edit().events.put(std::move(e));
    return true;
  }

  std::optional<Value> value(const Value& code, Type type) {
    const Routine& routine = *std::get<Procedure>(code).code;
    if (!routine.may_be_constant() || routine.varies || film_.constant_steps > most_constant_steps) return std::nullopt;
    Timeless questions(scene(), object_);
    std::uint64_t cost = 0;
    const Result<Value> answer = routine.value(questions, {}, cost);
    film_.constant_steps += cost + 300;  // starting the code costs something too
    if (!answer || questions.asked()) routine.varies = true;
    if (!answer || questions.asked()) return std::nullopt;
    auto fitting = usable(scene(), function_, type, *answer);
    if (!fitting || !independent(*fitting)) return std::nullopt;
    return *std::move(fitting);
  }

  // Returns false if the meaning of the value may change with other objects or files.
  bool independent(const Value& v) const {
    if (std::holds_alternative<Text>(v)) return function_ != fn::texture && function_ != fn::file;
    return numeric(v) || std::holds_alternative<Points>(v);
  }

  CompiledFilm& film_;
  const std::uint32_t object_;
  const FunctionId function_;
};

bool any_code(const Slot& slot) {
  bool any = slot.set && scripted(*slot.set);
  each_track(slot, [&](const Track& t) { any = any || scripted(t); });
  return any;
}

}  // namespace

std::optional<Slot> with_constants(CompiledFilm& film, std::uint32_t object, const Slot& slot) {
  return any_code(slot) ? Folding(film, object, slot.function).slot(slot) : std::nullopt;
}

}  // namespace betwixt
