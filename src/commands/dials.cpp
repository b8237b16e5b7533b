// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that map live input to targets.
#include <fmt/format.h>

#include <algorithm>

#include "commands/command.h"

namespace betwixt {
namespace {

// Runs dial /address to TARGET [from A B to C D]
bool dial(Command& k) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* start = c.at;
  while (c.at < c.end && !blank(*c.at) && *c.at != '\n') ++c.at;
  Dial made;
  made.address = c.since(start);
  if (made.address.size() < 2 || made.address[0] != '/')
    return c.fail(ErrorCode::syntax, "an address must begin with '/'", c.since(start),
                  "as in dial /fader/1 to ball.position.y");
  const auto at = [&] {
    auto& dials = *k.scene.dials;
    return std::find_if(dials.begin(), dials.end(), [&](const Dial& d) { return d.address == made.address; });
  };
  if (!c.accept_word("to")) return c.fail_here(ErrorCode::syntax, "'to' is missing here");
  if (c.accept_word("none")) {
    if (!finish(c)) return false;
    if (at() != s.dials->end()) {
      const auto i = at() - s.dials->begin();
      s.dials.edit().erase(s.dials.edit().begin() + i);
    }
    return true;
  }
  Selected to;
  const std::string_view word = c.next_word();
  if (!targets(k, word, to)) return false;
  if (to.velocity) return c.fail(ErrorCode::type, "a dial cannot control a velocity", word);
  if (to.targets.size() != 1)
    return c.fail(ErrorCode::name, "a dial can control only one target", word,
                  "to control many objects, use their group or a function of your own");
  made.target = to.targets[0];
  if (!row_of(to.type()).dials)
    return c.fail(ErrorCode::type, fmt::format("a dial cannot control {}", to_string(to.type())), word);
  if (c.accept_word("from")) {
    if (!c.number(made.low) || !c.number(made.high)) return false;
    if (made.low == made.high) return c.fail_here(ErrorCode::range, "the range of the dial must not be empty");
    if (!c.accept_word("to")) return c.fail_here(ErrorCode::syntax, "'to' and two values are missing here");
    const FunctionSpec free = unbounded(*to.spec);
    if (!values(k).value(free, to.component, made.from) || !values(k).value(free, to.component, made.to)) return false;
    if (!add_scaled(made.from, made.to, 1))
      return c.fail(ErrorCode::type, fmt::format("{} has no range", to_string(to.type())), word);
    made.mapped = true;
  }
  if (!finish(c)) return false;
  if (at() != s.dials->end()) {
    const auto i = static_cast<std::size_t>(at() - s.dials->begin());
    s.dials.edit()[i] = std::move(made);
  } else {
    s.dials.edit().push_back(std::move(made));
  }
  return true;
}

bool record(Command& k) {
  auto& [s, c, time, layer, script] = k;
  return on_or_off(c, "recording must be on or off", s.recording);
}

constexpr Verb dials_rows[] = {
    {"dial", "dial ADDRESS to TARGET [from LOW HIGH to LOW HIGH]",
     "Connects a control of live input (OSC or MIDI) to a target. The numbers after `from` are of the control, those "
     "after "
     "`to` of the target.",
     "dial /fader/1 to ball.radius from 0 1 to 0.5 2", 0, dial},
    {"record", "record on or record off", "Turns the recording of dials as events on or off.", "record on", 0, record,
     "on off"},
};

}  // namespace

std::span<const Verb> dials_verbs() { return dials_rows; }

}  // namespace betwixt
