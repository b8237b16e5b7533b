// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/memory.h"

#include <algorithm>
#include <unordered_set>

#include "base/memory.h"
#include "scene/document.h"

namespace betwixt {
namespace {

// Beyond what fits into a string itself.
std::size_t letters(const std::string& s) { return s.capacity() > std::string().capacity() ? s.capacity() + 1 : 0; }

class Weighing {
 public:
  SceneSize sum;

  // Counts the object, with those of its tracks that the other does not share.
  void apart(const Object& o, const Object* other) {
    sum.bytes += shared_bytes<Object> + letters(o.name) + bytes_held(o.slots);
    for (const Slot& s : o.slots) {
      const Slot* there = other ? other->find(s.function, s.layer) : nullptr;
      apart(s, there), apart(s.velocity, there ? &there->velocity : nullptr);
    }
    if (o.environment && (!other || other->environment != o.environment)) sum.bytes += shared_bytes<Environment>;
  }
  void object(const Object& o) {
    sum.bytes += shared_bytes<Object> + letters(o.name) + bytes_held(o.slots);
    for (const Slot& s : o.slots) {
      strand(s), strand(s.velocity);
      if (s.set) value(*s.set);
      sum.bytes += bytes_held(s.filters);
    }
    if (o.environment && first(o.environment.get()))
      sum.bytes += shared_bytes<Environment> + o.environment->size() * sizeof(EnvironmentEvent);
  }

 private:
  void apart(const Strand& s, const Strand* other) {
    sum.bytes += bytes_held(s.components);
    apart(s.track, other ? other->track : Cow<Track>());
    for (std::size_t i = 0; i < s.components.size(); ++i)
      apart(s.components[i], other && i < other->components.size() ? other->components[i] : Cow<Track>());
  }
  void apart(const Cow<Track>& t, const Cow<Track>& other) {
    if (t && !t.same(other)) sum.bytes += shared_bytes<Track> + t->events.bytes_apart(other->events);
  }
  void strand(const Strand& s) {
    sum.bytes += bytes_held(s.components);
    track(s.track);
    for (const Cow<Track>& c : s.components) track(c);
  }
  void track(const Cow<Track>& t) {
    if (!t || !first(&*t)) return;
    sum.bytes += shared_bytes<Track> + t->events.bytes();
    sum.events += t->events.size();
    t->events.each([&](const Event& e) {
      value(e.value);
      if (e.detail) sum.bytes += sizeof(EventDetail);
    });
  }
  // What it holds elsewhere.
  void value(const Value& v) {
    if (const auto* text = std::get_if<Text>(&v); text && first(text->at.get()))
      sum.bytes += shared_bytes<std::string> + letters(**text);
    if (const auto* points = std::get_if<Points>(&v); points && first(points->at.get()))
      sum.bytes += shared_bytes<std::vector<Vec3>> + bytes_held(**points);
    if (const auto* names = std::get_if<Names>(&v); names && first(names->at.get()))
      sum.bytes += shared_bytes<std::vector<std::string>> + bytes_held(**names);
    if (const auto* matrix = std::get_if<Matrix>(&v); matrix && first(matrix->at.get()))
      sum.bytes += shared_bytes<Mat4>;
    if (const auto* moves = std::get_if<Moves>(&v); moves && first(moves->at.get())) sum.bytes += shared_bytes<Motion>;
  }
  // Counts shared parts once.
  bool first(const void* thing) { return seen_.insert(thing).second; }

  std::unordered_set<const void*> seen_;
};

}  // namespace

SceneSize size_of(const Scene& scene) {
  Weighing all;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) all.object(scene.objects[i]);
  all.sum.bytes += sizeof(Scene) + scene.objects.size() * sizeof(Cow<Object>) + scene.names.bytes();
  return all.sum;
}

std::size_t bytes_apart(const Scene& before, const Scene& after) {
  Weighing lost;
  before.objects.each_changed(after.objects, [&](std::size_t i) {
    lost.apart(before.objects[i], i < after.objects.size() ? &after.objects[i] : nullptr);
  });
  lost.sum.bytes += sizeof(Scene) + before.objects.bytes_apart(after.objects) + before.names.bytes_apart(after.names);
  const auto whole = [&lost](const auto& was, const auto& is) {  // what an edit copies as a whole
    if (!was.same(is)) lost.sum.bytes += bytes_held(*was);
    return !was.same(is);
  };
  if (whole(before.notes, after.notes))
    for (const auto& note : *before.notes) lost.sum.bytes += letters(note.second);
  if (whole(before.later_lists, after.later_lists))
    for (const auto& later : *before.later_lists) lost.sum.bytes += bytes_held(later.second);
  whole(before.lists, after.lists), whole(before.expansion, after.expansion), whole(before.spare, after.spare);
  whole(before.views, after.views), whole(before.cuts, after.cuts), whole(before.lets, after.lets);
  return lost.sum.bytes;
}

}  // namespace betwixt
