// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/memory.h"

#include <algorithm>
#include <unordered_set>

#include "base/cancellation.h"
#include "base/memory.h"
#include "scene/document.h"
#include "scene/own_font.h"
#include "scene/own_kinds.h"
#include "scene/rig.h"
#include "track/procedure.h"

namespace betwixt {
namespace {

constexpr std::size_t compiled_code = 200;  // bytes: about what a line of code is compiled to

// The shared thing that a value refers to, or null.
const void* elsewhere(const Value& v) {
  return std::visit(
      [](const auto& one) -> const void* {
        if constexpr (requires { one.at.get(); }) return one.at.get();
        if constexpr (requires { one.code.get(); }) return one.code.get();
        return nullptr;
      },
      v);
}

// Bytes of the copy of a whole. Texts and points of values are shared, and not counted.
std::size_t all_held(const std::string& s) { return bytes_held(s); }
std::size_t all_held(const FunctionSpec& f) { return bytes_held(f.name) + bytes_held(f.words); }
std::size_t all_held(const NamedProcedure& p) { return bytes_held(p.name); }
std::size_t all_held(const Note& n) { return bytes_held(n.text); }
std::size_t all_held(const Dial& d) { return bytes_held(d.address); }
std::size_t all_held(const Let& l) {
  const auto* list = std::get_if<LetList>(&l);
  return list ? bytes_held(*list) : 0;
}
template <class K, class V>
std::size_t all_held(const std::pair<K, V>&);
template <class T>
std::size_t all_held(const std::vector<T>&);
template <class K, class V, class C>
std::size_t all_held(const std::map<K, V, C>&);
template <class T>
std::size_t all_held(const T&) {
  return 0;
}
template <class K, class V>
std::size_t all_held(const std::pair<K, V>& p) {
  return all_held(p.first) + all_held(p.second);
}
template <class T>
std::size_t sum_held(const T& all) {
  std::size_t sum = bytes_held(all);
  for (const auto& one : all) sum += all_held(one);
  return sum;
}
template <class T>
std::size_t all_held(const std::vector<T>& all) {
  return sum_held(all);
}
template <class K, class V, class C>
std::size_t all_held(const std::map<K, V, C>& all) {
  return sum_held(all);
}

// Display lists: an edit copies the end of one list, or the part in which it replaces a command.
std::size_t apart(const DisplayLists& before, const DisplayLists& after) {
  constexpr std::size_t part = 64;
  std::size_t sum = sum_held(before);
  for (const auto& [name, list] : before) {
    const auto there = after.find(name);
    if (there != after.end() && there->second.same(list)) continue;
    const std::size_t n = list->commands.size();
    sum += shared_bytes<DisplayList> + sum_held(list->tags) + in_heap((n + part - 1) / part * sizeof(Cow<int>)) +
           shared_bytes<std::vector<DisplayCommand>> + in_heap(std::min(n, part) * sizeof(DisplayCommand));
  }
  return sum;
}

// Kinds: an edit copies the list of instances, and the instances that it changes.
std::size_t apart(const OwnKinds& before, const OwnKinds& after) {
  std::size_t sum = shared_bytes<OwnKinds> + bytes_held(before.all);
  for (const OwnKind& kind : before.all) {
    const OwnKind* there = after.find(kind.name);
    sum += bytes_held(kind.name) + bytes_held(kind.parts) + bytes_held(kind.instances);
    for (std::size_t i = 0; i < kind.instances.size(); ++i) {
      const Cow<KindInstance>& one = kind.instances[i];
      if (there && i < there->instances.size() && there->instances[i].same(one)) continue;
      sum += shared_bytes<KindInstance> + bytes_held(one->parts) + bytes_held(one->own);
    }
  }
  return sum;
}

class Weighing {
 public:
  SceneSize sum;

  // Counts the object, with those of its tracks that the other does not share.
  void apart(const Object& o, const Object* other) {
    sum.bytes += shared_bytes<Object> + bytes_held(o.name) + bytes_held(o.slots);
    for (const Slot& s : o.slots) {
      const Slot* there = other ? other->find(s.function, s.layer) : nullptr;
      apart(s, there), apart(s.velocity, there ? &there->velocity : nullptr);
      if (s.set && !(there && there->set && elsewhere(*s.set) == elsewhere(*there->set))) value(*s.set);
      filters(s.filters);
    }
    if (o.environment && (!other || other->environment != o.environment)) sum.bytes += shared_bytes<Environment>;
  }
  void object(const Object& o) {
    sum.bytes += shared_bytes<Object> + bytes_held(o.name) + bytes_held(o.slots);
    for (const Slot& s : o.slots) {
      strand(s), strand(s.velocity);
      if (s.set) value(*s.set);
      filters(s.filters);
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
  void filters(const std::vector<Filter>& all) {
    sum.bytes += bytes_held(all);
    for (const Filter& f : all) sum.bytes += bytes_held(f.name) + sum_held(f.parameters);
  }
  // What it holds elsewhere.
  void value(const Value& v) {
    if (const auto* text = std::get_if<Text>(&v); text && first(text->at.get()))
      sum.bytes += shared_bytes<std::string> + bytes_held(**text);
    if (const auto* points = std::get_if<Points>(&v); points && first(points->at.get()))
      sum.bytes += shared_bytes<std::vector<Vec3>> + bytes_held(**points);
    if (const auto* names = std::get_if<Names>(&v); names && first(names->at.get()))
      sum.bytes += shared_bytes<std::vector<std::string>> + sum_held(**names);
    if (const auto* code = std::get_if<Procedure>(&v); code && code->code && first(code->code.get()))
      sum.bytes += shared_bytes<Routine> + bytes_held(code->code->source) + compiled_code;
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
  lost.sum.bytes +=
      shared_bytes<Scene> + before.objects.bytes_apart(after.objects) + before.names.bytes_apart(after.names);
  const auto whole = [&lost](const auto& was, const auto& is) {  // what an edit copies as a whole
    using Whole = std::remove_cvref_t<decltype(*was)>;
    if (was && !was.same(is)) lost.sum.bytes += shared_bytes<Whole> + sum_held(*was);
  };
  whole(before.sections, after.sections), whole(before.pauses, after.pauses);
  whole(before.descriptions, after.descriptions);
  whole(before.notes, after.notes), whole(before.aliases, after.aliases), whole(before.lets, after.lets);
  whole(before.tables, after.tables), whole(before.parts, after.parts), whole(before.tables_read, after.tables_read);
  whole(before.defined, after.defined), whole(before.procedures, after.procedures), whole(before.dials, after.dials);
  whole(before.expansion, after.expansion), whole(before.spare, after.spare);
  whole(before.views, after.views), whole(before.cuts, after.cuts);
  whole(before.cut_ways, after.cut_ways);
  whole(before.meshes, after.meshes), whole(before.pictures, after.pictures), whole(before.sounds, after.sounds);
  whole(before.videos, after.videos);
  whole(before.words, after.words), whole(before.fonts, after.fonts), whole(before.formulas, after.formulas);
  if (before.kinds && !before.kinds.same(after.kinds)) lost.sum.bytes += apart(*before.kinds, *after.kinds);
  if (!before.lists.same(after.lists))
    lost.sum.bytes += shared_bytes<DisplayLists> + apart(*before.lists, *after.lists);
  if (!before.later_lists.same(after.later_lists)) {
    lost.sum.bytes += shared_bytes<LaterLists> + bytes_held(*before.later_lists);
    for (const auto& [time, lists] : *before.later_lists) {
      const auto there = after.later_lists->find(time);
      lost.sum.bytes += apart(lists, there == after.later_lists->end() ? DisplayLists() : there->second);
    }
  }
  return lost.sum.bytes;
}

namespace {

template <class... T>
std::size_t bytes_in(const std::vector<T>&... arrays) {
  return ((arrays.size() * sizeof(T)) + ...);
}

// Adds up the bytes of values.
class ValueBytes {
 public:
  void object(const Object& o) {
    for (const Slot& slot : o.slots) {
      if (slot.set) value(*slot.set);
      strand(slot), strand(slot.velocity);
    }
  }
  void lists(const DisplayLists& all) {
    for (const auto& [name, list] : all)
      if (first(&*list))
        for (std::size_t i = 0; i < list->commands.size(); ++i) value(list->commands[i].value);
  }
  void code(const std::shared_ptr<const Routine>& routine) {
    if (routine && first(routine.get())) sum_ += 3 * routine->source.size();  // the source and its compiled form
  }
  std::size_t sum() const { return sum_; }

 private:
  void strand(const Strand& s) {
    track(*s.track);
    for (const Cow<Track>& t : s.components) track(*t);
  }
  void track(const Track& t) {
    if (!t.events.empty() && first(&t)) t.events.each([&](const Event& e) { value(e.value); });
  }
  void value(const Value& v) {
    if (const auto* text = std::get_if<Text>(&v); text && first(text->at.get())) sum_ += (*text)->size();
    if (const auto* points = std::get_if<Points>(&v); points && first(points->at.get())) sum_ += bytes_in(**points);
    if (const auto* names = std::get_if<Names>(&v); names && first(names->at.get()))
      for (const std::string& name : **names) sum_ += sizeof name + name.size();
    if (const auto* procedure = std::get_if<Procedure>(&v)) code(procedure->code);
  }
  bool first(const void* thing) { return seen_.insert(thing).second; }
  std::unordered_set<const void*> seen_;
  std::size_t sum_ = 0;
};

}  // namespace

std::size_t bytes_of(const Mesh& mesh) {
  return bytes_in(mesh.positions, mesh.normals, mesh.uvs, mesh.triangles, mesh.edges, mesh.parts);
}
std::size_t bytes_of(const Rig& rig) {
  std::size_t sum = bytes_in(rig.joints, rig.weights, rig.inverse_bind);
  for (const Rig::Target& target : rig.targets) sum += bytes_in(target.positions, target.normals);
  return sum;
}

void ContentBytes::add(const std::shared_ptr<const Mesh>& mesh) {
  if (!first(mesh.get())) return;
  sum_ += bytes_of(*mesh);
  for (const MeshPart& part : mesh->parts) add(part.texture);
  if (first(mesh->rig.get())) sum_ += bytes_of(*mesh->rig);
}
void ContentBytes::add(const std::shared_ptr<const Picture>& picture) {
  if (first(picture.get())) sum_ += bytes_in(picture->rgba);
}
void ContentBytes::add(const std::shared_ptr<const LinearPicture>& picture) {
  if (first(picture.get())) sum_ += bytes_in(picture->rgba);
}
void ContentBytes::add(const std::shared_ptr<const ColorTable>& table) {
  if (first(table.get())) sum_ += bytes_in(table->signals);
}
void ContentBytes::add(const std::shared_ptr<const Sound>& sound) {
  if (first(sound.get())) sum_ += bytes_in(sound->energy, sound->onsets);
}
void ContentBytes::add(const std::shared_ptr<const Video>& video) {
  if (first(video.get())) sum_ += bytes_in(video->begins);
}
void ContentBytes::add(const std::shared_ptr<const SpokenWords>& words) {
  if (!first(words.get())) return;
  sum_ += bytes_in(words->words, words->begins) + words->letters.size();
  for (const SpokenWord& word : words->words) sum_ += word.text.size();
}
void ContentBytes::add(const std::shared_ptr<const OwnFont>& font) {
  if (first(font.get())) sum_ += font->bytes.size();
}
void ContentBytes::add(const std::shared_ptr<const Outline>& outline) {
  if (!first(outline.get())) return;
  for (const Contour& contour : outline->contours) sum_ += bytes_in(contour);
}

void ContentBytes::add(const std::shared_ptr<const Table>& table) {
  if (first(table.get())) sum_ += table->bytes();
}

std::size_t bytes_of_values(const Scene& scene) {
  ValueBytes values;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Cancellation::check();
    values.object(scene.objects[i]);
  }
  values.lists(*scene.lists);
  for (const auto& [time, lists] : *scene.later_lists) values.lists(lists);
  for (const NamedProcedure& p : *scene.procedures) values.code(p.code);
  ContentBytes contents;
  const auto add = [&](const auto& files) {
    for (const auto& [path, content] : *files) contents.add(content);
  };
  add(scene.meshes), add(scene.pictures), add(scene.sounds), add(scene.videos), add(scene.words), add(scene.fonts),
      add(scene.formulas);
  add(scene.tables_read);
  return values.sum() + contents.sum();
}

}  // namespace betwixt
