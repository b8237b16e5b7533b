// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands about the whole document.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/command.h"

namespace betwixt {
namespace {

bool read_rate(Command& k, Rate& rate, bool used, const char* what) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* start = c.at;
  Rate fresh;
  if (!c.per_second(fresh, what)) return false;
  const std::string_view about = c.since(start);
  const bool smooth = &rate == &s.ticks && c.accept_word("smooth");
  if (!finish(c)) return false;
  if (&rate == &s.ticks) s.smooth_ticks = smooth;
  if (used && !(fresh == rate))
    script.note(Severity::warning,
                fmt::format("times in {} above this line were read at {} per second and do not change", what,
                            rate.den == 1 ? std::to_string(rate.num) : fmt::format("{}/{}", rate.num, rate.den)),
                about, "write the rate first");
  rate = fresh;
  return true;
}

bool rate(Command& k) { return read_rate(k, k.scene.rate, k.cursor.frames_read, "frames"); }
bool ticks(Command& k) { return read_rate(k, k.scene.ticks, k.cursor.ticks_read, "ticks"); }

bool range(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Time from, to;
  c.space();
  const char* start = c.at;
  if (!c.time(from)) return false;
  if (c.peek() == '.' && c.end - c.at > 1 && c.at[1] == '.') c.at += 2;  // range 1f..72f is a segment, too
  if (!c.time(to)) return false;
  if (to < from) return c.fail(ErrorCode::range, "the range ends before it begins", c.since(start));
  if (!finish(c)) return false;
  s.range = {from, to};
  return true;
}

bool policy(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view w = c.next_word();
  const auto at = std::find(policy_names.begin(), policy_names.end(), w);
  if (at == policy_names.end())
    return no_choice(c, w, "the policy must be translate, ignore or ask",
                     did_you_mean(w, {policy_names.begin(), policy_names.end()}));
  if (!finish(c)) return false;
  s.policy = static_cast<Policy>(at - policy_names.begin());
  return true;
}

constexpr Verb settings_rows[] = {
    {"rate", "rate N, as in rate 24 or rate 30000/1001", "How many frames a second has; write it first.", "rate 25",
     Verb::once, rate, "NUMBER…"},
    {"range", "range FROM TO, as in range 1f 48f", "The first and the last frame of the film.", "range 1f 48f",
     Verb::once | Verb::aside, range, "NUMBER…"},
    {"ticks", "ticks N [smooth]",
     "How many ticks a second has: `90t` is a time in ticks, and environments move at ticks. With `smooth` they also "
     "move "
     "between two ticks.",
     "ticks 60 smooth", 0, ticks, "NUMBER…"},
    {"policy", "policy translate|ignore|ask",
     "What to do with a value of the wrong type: convert it, ignore the line, or ask.", "policy ignore", 0, policy,
     "translate ignore ask"},
};

}  // namespace

std::span<const Verb> settings_verbs() { return settings_rows; }

}  // namespace betwixt
