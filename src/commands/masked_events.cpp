// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reports events that velocities mask.
#include <fmt/format.h>

#include "base/counted.h"
#include "commands/script.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// Calls f(event) for each event of `primary` while a velocity is in effect.
template <class F>
void each_masked(const Track& primary, const Track& velocity, F&& f) {
  std::optional<Time> from;
  const auto until = [&](Time end) {
    for (const Event& e : primary.events.between({from->flicks + 1}, {end.flicks - 1})) f(e);
  };
  velocity.events.each([&](const Event& e) {
    if (e.release && from) {
      until(e.time);
      from.reset();
    } else if (!e.release && !from) {
      from = e.time;
    }
  });
  if (from) until({INT64_MAX});
}

// Does the same for a function's whole track, or for the tracks of its components.
template <class F>
void each_masked(const Slot& slot, Type type, F&& f) {
  if (slot.components.empty() && slot.velocity.components.empty())
    return each_masked(*slot.track, *slot.velocity.track, [&](const Event& e) { f(e, -1); });
  const Strand values = split_into_components(slot, type), rates = split_into_components(slot.velocity, type);
  for (std::size_t i = 0; i < values.components.size(); ++i)
    each_masked(*values.components[i], *rates.components[i], [&](const Event& e) { f(e, static_cast<int>(i)); });
}

}  // namespace

void say_masked_events(const Scene& s, Script& script) {
  constexpr std::size_t named = 3;
  for (auto& velocity : script.velocities) {
    const auto& key = velocity.first;
    Diagnostic& d = velocity.second;
    const Object* o = find_object(s, {key.first});
    const Slot* slot = o ? o->find(key.second) : nullptr;
    if (!slot) continue;
    std::string said;
    std::size_t count = 0;
    each_masked(*slot, spec_of(s, key.second).type, [&](const Event& e, int component) {
      if (++count > named) return;
      said += fmt::format("{}{} at {}", count > 1 ? ", " : "", target_name(s, {{key.first}, key.second, component}),
                          format_time(e.time, s.rate));
    });
    if (count == 0) continue;
    d.what.message =
        fmt::format("a velocity overrides {} ({}{})", counted(count, "event"), said, count > named ? " …" : "");
    d.what.hint = "to end the velocity: at TIME TARGET.velocity release";
    script.diagnostics.push_back(std::move(d));
  }
  script.velocities.clear();
}

void say_idle_releases(const Scene& s, Script& script) {
  for (Script::Release& r : script.releases) {
    if (!find_object(s, r.target.object)) continue;  // the object was removed, so the warning no longer matters
    bool reigns = false;
    for (const Track* track : tracks_of(s, r.target)) {
      bool open = false;
      track->events.each([&](const Event& e) {
        if (e.time < r.time) open = !e.release;
      });
      reigns = reigns || open;
    }
    if (!reigns) script.diagnostics.push_back(std::move(r.idle));
  }
  script.releases.clear();
}

}  // namespace betwixt
