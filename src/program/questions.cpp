// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "program/along.h"
#include "program/on_axes.h"
#include "program/steps.h"
#include "scene/formula_parts.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr std::uint64_t of_a_question = 20;  // steps

// Does the work of a question. Its cost counts once, in the code that asks. Cancelled must not cross the code, so it is
// noted instead.
template <class Work>
auto ask(FilmQuestions& q, std::uint64_t& cost, Work&& work) -> decltype(work()) {
  const std::uint64_t before = q.asking.cost;
  try {
    auto answer = work();
    cost += q.asking.cost - before + of_a_question;
    q.asking.cost = before;
    return answer;
  } catch (const Cancelled&) {
    q.called_off = true;
    return fail(ErrorCode::machine, "cancelled: a newer change replaces this one");
  }
}

}  // namespace

std::string_view FilmQuestions::self() const {
  return object ? std::string_view(scene().objects[object.index].name) : std::string_view();
}

const Routine* FilmQuestions::procedure(std::string_view name) {
  const NamedProcedure* p = find_procedure(scene(), name);
  return p && (p->role == Role::value || p->role == Role::steps) ? p->code.get() : nullptr;
}

Result<Value> FilmQuestions::value(std::string_view text, double seconds, std::uint64_t& cost) {
  return ask(*this, cost, [&]() -> Result<Value> {
    if (!std::isfinite(seconds) || std::abs(seconds) > longest_seconds)
      return fail(ErrorCode::range, fmt::format("value('{}', {}): the time is out of range", text, seconds));
    const auto target = find_target(scene(), text, object);
    if (!target) return lacking = lacking || others_have(text), target.error();
    asking.note_read(*target);
    Value r = c.read(*target, from_seconds(seconds), asking);
    if (asking.given_up) return fail(ErrorCode::range, "stopped: reading this value took too much work");
    return r;
  });
}

Result<Vec3> FilmQuestions::place(std::string_view line, double share, double seconds, std::uint64_t& cost) {
  return ask(*this, cost, [&] { return place_on(c, line, share, seconds, asking); });
}

Status FilmQuestions::axes(std::string_view name, double seconds, AxesSpace& out, std::uint64_t& cost) {
  const auto found = ask(*this, cost, [&]() -> Result<AxesSpace> {
    if (!std::isfinite(seconds) || std::abs(seconds) > longest_seconds)
      return fail(ErrorCode::range, "the time is out of range");
    const ObjectId id = name.empty() ? object : scene().names.find(name);
    if (!id) return fail(ErrorCode::name, fmt::format("there is no object '{}'", name));
    return axes_space(c, id, from_seconds(seconds), asking);
  });
  if (!found) return found.error();
  out = *found;
  return Nothing{};
}

Questions::Turn FilmQuestions::turn(std::string_view name) {
  const ObjectId id = scene().names.find(name);
  if (!id || !has_letters(scene().objects[id.index].kind)) return {};
  const auto turn = c.text_turn(id.index, t, asking);
  const auto* text = turn ? std::get_if<Text>(&turn->to) : nullptr;
  return text ? Turn{**text, turn->share} : Turn();
}

Result<State> FilmQuestions::state(std::string_view name, double seconds, std::uint64_t& cost) {
  return ask(*this, cost, [&]() -> Result<State> {
    if (!std::isfinite(seconds) || std::abs(seconds) > longest_seconds)
      return fail(ErrorCode::range, fmt::format("the time {} is out of range", seconds));
    return state_at(c, *find_procedure(scene(), name), from_seconds(seconds), asking);
  });
}

// Returns true if a target of its own names a function that this kind lacks and other kinds have.
bool FilmQuestions::others_have(std::string_view target) const {
  if (!object) return false;
  const Object& own = scene().objects[object.index];
  if (target.starts_with(own.name)) target.remove_prefix(own.name.size());
  if (!target.starts_with('.')) return false;
  target.remove_prefix(1);
  const std::string_view function = target.substr(0, target.find('.'));
  const auto known = built_in_functions();
  return !find_function(scene(), own.kind, function) &&
         std::any_of(known.begin(), known.end(), [&](const FunctionSpec& f) { return f.name == function; });
}

}  // namespace betwixt
