// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/ceilings.h"

#include <fmt/format.h>

#include <unordered_set>

#include "base/still_wanted.h"
#include "track/procedure.h"

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
std::size_t environments(const Scene& s) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < s.objects.size(); ++i) {
    const Object& o = s.objects[i];
    if (!o.removed && o.environment && o.environment->generation_at(Environment::furthest)) ++n;
  }
  return n;
}

// Objects are only added at the end, so an unchanged number of them needs no count.
bool too_many_environments(std::size_t most, const Scene& before, const Scene& after) {
  if (after.objects.size() == before.objects.size() || after.objects.size() <= most) return false;
  const std::size_t n = environments(after);
  return n > most && n > environments(before);
}

// Adds up the bytes of values; a shared value counts once.
class Held {
 public:
  std::size_t bytes = 0;
  void strand(const Strand& s) {
    track(*s.track);
    for (const Cow<Track>& t : s.components) track(*t);
  }
  void value(const Value& v) {
    if (const auto* text = std::get_if<Text>(&v); text && first(text->at.get())) bytes += (*text)->size();
    if (const auto* points = std::get_if<Points>(&v); points && first(points->at.get()))
      bytes += (*points)->size() * sizeof(Vec3);
    if (const auto* names = std::get_if<Names>(&v); names && first(names->at.get()))
      for (const std::string& name : **names) bytes += sizeof name + name.size();
    if (const auto* code = std::get_if<Procedure>(&v); code && code->code && first(code->code.get()))
      bytes += 3 * code->code->source.size();  // the source and its compiled form
  }

 private:
  void track(const Track& t) {
    if (!t.events.empty() && first(&t)) t.events.each([&](const Event& e) { value(e.value); });
  }
  bool first(const void* thing) { return seen_.insert(thing).second; }
  std::unordered_set<const void*> seen_;
};

Error too_many(const char* what, std::size_t most, const std::string& hint) {
  return fail(ErrorCode::range, fmt::format("there would be more than {} {}", most, what), hint);
}

}  // namespace

std::size_t count_events(const Scene& before, std::size_t events, const Scene& after) {
  after.objects.each_changed(before.objects, [&](std::size_t i) {
    if (i < before.objects.size()) events -= events_of(before.objects[i]);
    events += events_of(after.objects[i]);
  });
  return events;
}

std::size_t bytes_of_values(const Scene& scene) {
  Held all;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    StillWanted::ask();
    for (const Slot& slot : scene.objects[i].slots) {
      if (slot.set) all.value(*slot.set);
      all.strand(slot), all.strand(slot.velocity);
    }
  }
  return all.bytes;
}

Error too_many_bytes(const Ceilings& c) {
  return fail(ErrorCode::range,
              fmt::format("texts, points, lists of names and code would have more than {} bytes", c.values),
              "betwixt serve --values N lets more in");
}

Status within(const Ceilings& c, const Scene& before, std::size_t events_before, const Scene& after,
              std::size_t events_after) {
  if (too_many_environments(c.environments, before, after))
    return too_many("environments", c.environments, "kill some that are not needed any more");
  if (after.objects.size() > c.objects && after.objects.size() > before.objects.size())
    return too_many("objects, removed ones included", c.objects, "betwixt serve --objects N lets more in");
  if (events_after > c.events && events_after > events_before)
    return too_many("events", c.events, "erase some; betwixt serve --events N lets more in");
  return Nothing{};
}

}  // namespace betwixt
