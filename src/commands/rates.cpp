// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Rates of change: velocities, and the tangents of hermite.
#include <fmt/format.h>

#include "commands/command.h"

namespace betwixt {

// Reads a value per second. For a rotation: a rate for each angle, or an angular velocity about an axis.
bool rate_of_change(Command& k, const Selected& to, Value& out) {
  auto& [s, c, time, layer, script] = k;
  const Type type = to.type();
  if (row_of(type).changes != Changes::by_turning) return values(k).value(unbounded(*to.spec), to.component, out);
  c.space();
  Vec3 v;
  if (c.peek_word() == "axis") {
    double angle = 0;
    c.word();
    if (!c.open()) return false;
    c.space();
    if (c.peek() == '(' || c.peek() == 'x' || c.peek() == 'y' || c.peek() == 'z') {
      if (!values(k).axis(v)) return false;
    } else {
      const char* start = c.at;
      for (int i = 0; i < 3; ++i)
        if (!c.number(v[i])) return false;
      if (v == Vec3{}) return c.fail(ErrorCode::range, "the axis 0 0 0 has no direction", c.since(start));
    }
    if (!values(k).angle(angle) || !c.close()) return false;
    out = angle * normalize(v);
    return true;
  }
  if (c.peek_word() == "quat")
    return c.fail_here(ErrorCode::type, "expected an angular velocity here, not an orientation",
                       "as in axis(0 1 0, 90deg)");
  const bool spin = c.accept_word("spin");  // about the fixed axes, as one vector
  if (!spin && c.peek() != '(' && !c.accept_word("euler"))
    return c.fail_here(ErrorCode::type, "expected an angular velocity here",
                       "as in axis(0 1 0, 90deg) or euler(0 90deg 0)");
  if (!c.open()) return false;
  for (int i = 0; i < 3; ++i)
    if (!values(k).angle(v[i])) return false;
  if (!c.close()) return false;
  out = spin || type == Type::orientation ? Value(v) : Value(Angles{v});
  return true;
}

namespace {

// Reads quat(w x y z), the change of the four numbers per second, as in glTF; or an angular velocity about fixed axes.
// The track stores the former, which has one form for every orientation.
bool turning_tangent(Command& k, const Selected& to, const Event& e, Value& out) {
  Cursor& c = k.cursor;
  const auto* q = std::get_if<Quat>(&e.value);
  if (!q) return c.fail_here(ErrorCode::type, "'keep' takes no tangent of an orientation");
  if (c.accept_word("quat")) {
    Quat rate;
    if (!c.open()) return false;
    for (double* n : {&rate.w, &rate.x, &rate.y, &rate.z})
      if (!c.number(*n)) return false;
    out = rate;
    return c.close();
  }
  if (c.peek_word() == "euler" || c.peek() == '(')
    return c.fail_here(ErrorCode::type, "the tangent of an orientation must be an angular velocity or quat(…)",
                       "as in tangent=axis(0 1 0, 90deg) or tangent=spin(0 90deg 0)");
  Value speed;
  if (!rate_of_change(k, to, speed)) return false;
  const Vec3 w = 0.5 * std::get<Vec3>(speed);
  out = Quat{0, w.x, w.y, w.z} * *q;
  return true;
}

}  // namespace

// Reads tangent=V, tangent-in=V, tangent-out=V: the slopes of hermite, per second.
bool tangent(Command& k, const Selected& to, std::string_view key, Event& e) {
  auto& [s, c, time, layer, script] = k;
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", key));
  const Type type = to.type();
  if (!row_of(type).tangents) return c.fail(ErrorCode::type, fmt::format("{} has no tangents", to_string(type)), key);
  Value v;
  c.space();
  const char* const start = c.at;
  const bool turns = type == Type::orientation || std::holds_alternative<Quat>(e.value);
  if (turns && !to.velocity ? !turning_tangent(k, to, e, v)
                            : !values(k).value(unbounded(*to.spec), to.component, v))  // a speed may be of any size
    return false;
  if (std::holds_alternative<Quat>(v) && !turns)
    return c.fail(ErrorCode::type, "the tangent of angles must be angles", c.since(start),
                  "as in tangent=euler(0 90deg 0)");
  EventDetail& d = e.detail.edit();
  if (key != "tangent-out") d.tangent_in = v, d.handle_in.reset();
  if (key != "tangent-in") d.tangent_out = v, d.handle_out.reset();
  return true;
}

// Reads handle-in=(LENGTH VALUE), handle-out=(LENGTH VALUE): the handles of fcurve, relative to the event.
bool handle(Command& k, const Selected& to, std::string_view key, Event& e) {
  auto& [s, c, time, layer, script] = k;
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", key));
  const Type type = to.type();
  if (!row_of(type).tangents) return c.fail(ErrorCode::type, fmt::format("{} has no handles", to_string(type)), key);
  if (type == Type::orientation || std::holds_alternative<Quat>(e.value))
    return c.fail(ErrorCode::type, "an orientation has no handles", key, "angles have handles: euler(0 90deg 0)");
  c.space();
  if (c.peek() != '(')
    return c.fail_here(ErrorCode::syntax, fmt::format("{} must be a length of time and a difference of value", key),
                       fmt::format("as in {}=(4f 1)", key));
  if (!c.open()) return false;
  c.space();
  const char* const start = c.at;
  Time length;
  if (!c.length(length)) return false;
  if (length < Time{}) return c.fail(ErrorCode::range, "a handle must not be negative", c.since(start));
  Value v;
  if (!values(k).value(unbounded(*to.spec), to.component, v)) return false;
  if (std::holds_alternative<Quat>(v))
    return c.fail(ErrorCode::type, "the handle of angles must be angles", c.since(start),
                  "as in (4f euler(0 90deg 0))");
  if (!c.close()) return false;
  EventDetail& d = e.detail.edit();
  (key == "handle-in" ? d.tangent_in : d.tangent_out) = std::move(v);
  (key == "handle-in" ? d.handle_in : d.handle_out) = length;
  return true;
}

}  // namespace betwixt
