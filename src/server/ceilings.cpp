// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/ceilings.h"

#include <fmt/format.h>

namespace betwixt {
namespace {

std::size_t events_of(const Strand& s) {
  std::size_t n = s.track->events.size();
  for (const Cow<Track>& t : s.components) n += t->events.size();
  return n;
}

std::size_t events_of(const Object& o) {
  std::size_t n = o.environment ? o.environment->size() : 0;
  for (const Slot& s : o.slots) n += events_of(s) + events_of(s.velocity);
  return n;
}

// Counts the environments that have not been killed for good.
std::size_t environments(const Objects& all) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Object& o = all[i];
    if (!o.removed && o.environment && o.environment->generation_at(Environment::furthest)) ++n;
  }
  return n;
}

// Objects are only added at the end, so an unchanged number of them needs no count.
bool too_many_environments(std::size_t most, const Objects& before, const Objects& after) {
  if (after.size() == before.size() || after.size() <= most) return false;
  const std::size_t n = environments(after);
  return n > most && n > environments(before);
}

Error too_many(const char* what, std::size_t most, const std::string& hint) {
  return fail(ErrorCode::range, fmt::format("the film would have more than {} {}", most, what), hint);
}

}  // namespace

std::size_t count_events(const Objects& before, std::size_t events, const Objects& after) {
  after.each_changed(before, [&](std::size_t i) {
    if (i < before.size()) events -= events_of(before[i]);
    events += events_of(after[i]);
  });
  return events;
}

Status within(const Ceilings& c, const Objects& before, std::size_t events_before, const Objects& after,
              std::size_t events_after) {
  if (too_many_environments(c.environments, before, after))
    return too_many("environments", c.environments, "kill environments that you no longer need");
  if (after.size() > c.objects && after.size() > before.size())
    return too_many("objects, including removed ones", c.objects, "to allow more: betwixt serve --objects N");
  if (events_after > c.events && events_after > events_before)
    return too_many("events", c.events, "clear some events, or allow more: betwixt serve --events N");
  return Nothing{};
}

}  // namespace betwixt
