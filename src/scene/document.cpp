// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/document.h"

#include <algorithm>
#include <set>

#include "base/cancellation.h"
#include "base/memory.h"
#include "base/names.h"
#include "scene/formula_parts.h"
#include "scene/names.h"
#include "track/curve.h"
#include "track/types.h"

namespace betwixt {
namespace {

auto key(const Slot& s) { return std::pair(s.function, s.layer.index + 1); }  // without a layer 0, before all others
auto key(FunctionId f, ObjectId layer) { return std::pair(f, layer.index + 1); }

}  // namespace

const Slot* Object::find(FunctionId f, ObjectId layer) const {
  const auto at = std::lower_bound(slots.begin(), slots.end(), key(f, layer),
                                   [](const Slot& s, const auto& k) { return key(s) < k; });
  return at != slots.end() && at->function == f && at->layer == layer ? &*at : nullptr;
}

Slot& Object::slot(FunctionId f, ObjectId layer) {
  const auto at = std::lower_bound(slots.begin(), slots.end(), key(f, layer),
                                   [](const Slot& s, const auto& k) { return key(s) < k; });
  if (at != slots.end() && at->function == f && at->layer == layer) return *at;
  Slot fresh;
  fresh.function = f;
  fresh.layer = layer;
  return *slots.insert(at, std::move(fresh));
}

std::size_t Objects::add(Object object) {
  if (size_ % files == 0) shelves_.emplace_back();
  FileSource& last = shelves_.back().edit();
  if (size_ % chunk == 0) last.emplace_back();
  last.back().edit().emplace_back(std::move(object));
  return size_++;
}

std::size_t Objects::bytes_apart(const Objects& other) const {
  std::size_t sum = bytes_held(shelves_);
  for (std::size_t s = 0; s < shelves_.size(); ++s)
    if (s >= other.shelves_.size() || !shelves_[s].same(other.shelves_[s]))
      sum += shared_bytes<FileSource> + bytes_held(*shelves_[s]);
  each_chunk_apart(
      other, [&](std::size_t, const Chunk& mine, const Chunk*) { sum += shared_bytes<Chunk> + bytes_held(mine); });
  return sum;
}

const FunctionSpec& spec_of(const Scene& s, FunctionId f) {
  const auto built_in = built_in_functions();
  return f < built_in.size() ? built_in[f] : (*s.defined)[f - built_in.size()];
}

std::optional<FunctionId> find_function(const Scene& s, Kind kind, std::string_view name) {
  if (const auto f = find_built_in(kind, name)) return f;
  const auto own = s.defined->find(name);
  return own ? std::optional(static_cast<FunctionId>(built_in_functions().size() + *own)) : std::nullopt;
}

std::vector<std::string_view> function_names(const Scene& s, Kind kind) {
  std::vector<std::string_view> out;
  for (const auto& f : built_in_functions())
    if (f.kinds & bit(kind)) out.push_back(f.name);
  for (const auto& f : *s.defined) out.push_back(f.name);
  return out;
}

namespace {

// Returns the objects of `each_object` that match a word without braces, in order of names.
template <class Each>
void add_matching(const Scene& s, std::string_view word, const Each& each_object, std::vector<ObjectId>& out) {
  const auto first = static_cast<std::ptrdiff_t>(out.size());
  each_object([&](ObjectId id) {
    if (Cancellation::check(); !s.objects[id.index].removed && matches(word, s.objects[id.index].name))
      out.push_back(id);
  });
  std::sort(out.begin() + first, out.end(), [&](ObjectId a, ObjectId b) {
    Cancellation::check();
    return natural_less(s.objects[a.index].name, s.objects[b.index].name);
  });
}

// Returns the objects of a word that is not an alias.
void select_plain(const Scene& s, std::string_view word, std::vector<ObjectId>& out) {
  const auto words = expand_braces(with_keys(*s.tables, word));
  if (!words) return;
  const auto all = [&](const auto& f) {
    for (std::uint32_t i = 0; i < s.objects.size(); ++i) f(ObjectId{i});
  };
  for (const auto& w : *words)
    if (is_pattern(w))
      add_matching(s, w, all, out);
    else if (const auto id = s.names.find(w))
      out.push_back(id);
    else
      for (const ObjectId part : parts_by_content(s, w)) out.push_back(part);
}

// Removes repetitions.
std::vector<ObjectId> once_each(const Scene& s, const std::vector<ObjectId>& all) {
  if (all.size() < 2) return all;
  std::vector<ObjectId> once;
  std::vector<bool> seen(s.objects.size());
  for (ObjectId id : all)
    if (!seen[id.index]) seen[id.index] = true, once.push_back(id);
  return once;
}

}  // namespace

std::vector<ObjectId> select(const Scene& s, std::string_view word) {
  std::vector<ObjectId> out;
  // An alias takes precedence over an object of the same name and is expanded once, which ends cycles: inside itself
  // its name is the object's. A list in place of recursion: aliases of aliases may be nested as deep as the author
  // likes.
  struct Step {
    std::string_view word;
    bool end = false;  // of the alias
  };
  std::vector<Step> todo{{word}};
  std::map<std::string_view, bool> open;  // aliases seen, and whether we are inside
  std::set<std::string_view> plain;       // words that have been looked up: the second time they add nothing
  while (!todo.empty()) {
    const Step step = todo.back();
    todo.pop_back();
    if (step.end) {
      open[step.word] = false;
      continue;
    }
    const auto alias = s.aliases->find(step.word);
    if (alias == s.aliases->end()) {
      if (plain.insert(step.word).second) select_plain(s, step.word, out);
    } else if (const auto [seen, fresh] = open.try_emplace(step.word, true); fresh) {
      todo.push_back({step.word, true});
      for (auto e = alias->second.rbegin(); e != alias->second.rend(); ++e) todo.push_back({*e});
    } else if (seen->second) {
      if (const auto id = s.names.find(step.word)) out.push_back(id);
    }
  }
  return once_each(s, out);
}

std::vector<ObjectId> select(const Scene& s, std::string_view pattern, const std::vector<ObjectId>& some) {
  const auto words = expand_braces(with_keys(*s.tables, pattern));
  if (!words) return {};
  const auto these = [&](const auto& f) { std::for_each(some.begin(), some.end(), f); };
  std::vector<ObjectId> out;
  for (const std::string& w : *words) add_matching(s, w, these, out);
  return once_each(s, out);
}

std::vector<AttachmentSpan> attachments(const Object& o) {
  std::vector<AttachmentSpan> out;
  const Slot* slot = o.find(fn::attachment);
  if (!slot) return out;
  const auto begin = [&](Time from, const Value& v) {
    const auto* plain = std::get_if<Attachment>(&v);
    out.push_back({from, {INT64_MAX}, plain ? *plain : Attachment{}, !plain});
  };
  begin({INT64_MIN}, slot->set.value_or(Attachment{}));
  slot->track->events.each([&](const Event& e) {
    if (e.keep) return;
    out.back().until = e.time;
    begin(e.time, e.value);
  });
  return out;
}

std::vector<ObjectId> circle(const Scene& s, ObjectId child, ObjectId parent, Time from, Time until) {
  if (child == parent) return {child};
  if (!s.objects[child.index].leads) return {};  // it has no children: the usual case, and cheap
  // Upwards from the parent, through every attachment in this time.
  struct Step {
    ObjectId at;
    Time from, until;
    std::size_t below;  // the previous step
  };
  std::vector<Step> steps{{parent, from, until, 0}};
  const std::size_t enough = 4 * s.objects.size() + 10'000;  // a circle made by moving events must not stop us
  for (std::size_t i = 0; i < steps.size() && steps.size() < enough; ++i) {
    Cancellation::check();
    for (const AttachmentSpan& a : attachments(s.objects[steps[i].at.index])) {
      const Time begin = std::max(a.from, steps[i].from), end = std::min(a.until, steps[i].until);
      if (a.to.kind < AttachmentKind::hang || !find_object(s, a.to.parent) || begin >= end) continue;
      steps.push_back({a.to.parent, begin, end, i});
      if (a.to.parent != child) continue;
      std::vector<ObjectId> path{child};
      for (std::size_t k = i;; k = steps[k].below) {
        path.push_back(steps[k].at);
        if (k == 0) break;
      }
      return path;
    }
  }
  return {};
}

Result<Target> find_target(const Scene& s, std::string_view text, ObjectId self) {
  const auto dot = text.find('.');
  if (dot == std::string_view::npos) return fail(ErrorCode::name, "a target has a dot, as in 'ball.position'");
  Target t;
  t.object = dot == 0 ? self : find_named(s, text.substr(0, dot));
  if (!find_object(s, t.object)) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < s.objects.size() && i < 1000; ++i)
      if (!s.objects[i].removed) names.push_back(s.objects[i].name);
    const auto name = text.substr(0, dot);
    return unknown_name("object", name, did_you_mean(name, names));
  }
  std::vector<std::string_view> words;
  for (std::string_view rest = text.substr(dot + 1);;) {
    const auto next = rest.find('.');
    words.push_back(rest.substr(0, next));
    if (next == std::string_view::npos) break;
    rest.remove_prefix(next + 1);
  }
  if (const auto query = find_query(s.objects[t.object.index].kind, words[0])) {
    const int part = words.size() > 1 && query == Query::world ? find_component(Type::vector, words[1]) : -1;
    if (words.size() == 1 || (words.size() == 2 && part >= 0)) return Target(t.object, *query, part);
    return fail(ErrorCode::name, "there is no such part; a matrix is a table of 16 numbers, with x y z");
  }
  const Kind kind = s.objects[t.object.index].kind;
  const auto f = find_function(s, kind, words[0]);
  if (!f) {
    const auto names = function_names(s, kind);
    return unknown_name("function", words[0], did_you_mean(words[0], names));
  }
  t.function = *f;
  const Type type = spec_of(s, *f).type;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const int component = find_component(type, words[i]);
    if (words[i] == "velocity" && has_velocity(type) && !t.velocity)
      t.velocity = true;
    else if (component >= 0 && t.component < 0)
      t.component = component;
    else
      return unknown_name("part", words[i]);
  }
  return t;
}

const NamedProcedure* find_procedure(const Scene& s, std::string_view name) {
  for (const NamedProcedure& p : *s.procedures)
    if (p.name == name) return &p;
  return nullptr;
}

std::string twerper_name(const Scene& s, Twerper t) {
  if (!is_own(t)) return std::string(name_of(t));
  const auto i = static_cast<std::size_t>(t) - first_own_twerper;
  return i < s.procedures->size() ? (*s.procedures)[i].name : "unset";
}

std::optional<Twerper> find_own_twerper(const Scene& s, std::string_view name) {
  const auto& own = *s.procedures;
  for (std::size_t i = 0; i < own.size(); ++i)
    if (own[i].name == name && (own[i].role == Role::twerper || own[i].role == Role::tween))
      return static_cast<Twerper>(first_own_twerper + i);
  return std::nullopt;
}

const Routine* tween(const Scene& s, Twerper t) {
  const std::size_t i = is_own(t) ? static_cast<std::size_t>(t) - first_own_twerper : s.procedures->size();
  if (i >= s.procedures->size() || (*s.procedures)[i].role != Role::tween) return nullptr;
  return (*s.procedures)[i].code.get();
}

bool fits(const Scene& s, Twerper t, Type type, std::string* why) {
  if (!tween(s, t)) return fits(t, type, why);
  if (row_of(type).computed && type != Type::attachment && type != Type::motion) return true;
  if (why) *why = "a tween cannot return " + std::string(to_string(type));
  return false;
}

ObjectId add_object(Scene& s, Object object) {
  const std::string name = object.name;
  const ObjectId id{static_cast<std::uint32_t>(s.objects.add(std::move(object)))};
  s.names.put(name, id);
  return id;
}

void remove_objects(Scene& s, const std::vector<ObjectId>& ids, const std::vector<std::uint32_t>& speaking) {
  for (ObjectId id : ids) {
    if (s.objects[id.index].removed) continue;  // named twice
    s.names.erase(s.objects[id.index].name);
    Object& gone = s.objects.edit(id.index);
    gone.removed = true;
    gone.slots.clear();
  }
  const auto is_gone = [&](ObjectId id) { return id && s.objects[id.index].removed; };
  const auto held = [&](const Value& v) {
    const auto* a = std::get_if<Attachment>(&v);
    return a && is_gone(a->parent);
  };
  for (const std::uint32_t i : speaking) {
    const Object& o = s.objects[i];
    if (std::any_of(o.slots.begin(), o.slots.end(), [&](const Slot& x) { return is_gone(x.layer); }))
      std::erase_if(s.objects.edit(i).slots, [&](const Slot& x) { return is_gone(x.layer); });
    const Slot* slot = o.find(fn::attachment);
    if (!slot) continue;
    bool any = slot->set && held(*slot->set);
    slot->track->events.each([&](const Event& e) { any = any || held(e.value); });
    if (!any) continue;
    Slot& mine = s.objects.edit(i).slot(fn::attachment);
    if (mine.set && held(*mine.set)) mine.set.reset();
    mine.track.edit().events.edit_between({INT64_MIN}, {INT64_MAX}, [&](Event& e) {
      if (held(e.value)) e.value = Attachment{};
    });
  }
  if (std::any_of(s.dials->begin(), s.dials->end(), [&](const Dial& d) { return is_gone(d.target.object); }))
    std::erase_if(s.dials.edit(), [&](const Dial& d) { return is_gone(d.target.object); });
  const auto gone_cut = [&](const auto& cut) { return is_gone(cut.second); };
  if (std::any_of(s.cuts->begin(), s.cuts->end(), gone_cut)) std::erase_if(s.cuts.edit(), gone_cut);
  const auto no_cut = [&](const auto& way) { return s.cuts->count(way.first) == 0; };
  if (std::any_of(s.cut_ways->begin(), s.cut_ways->end(), no_cut)) std::erase_if(s.cut_ways.edit(), no_cut);
}

Document::Document() : scene_(std::make_shared<const Scene>()) {}
Rate Document::rate() const { return scene_->rate; }

std::pair<Time, Time> Document::range() const {
  if (scene_->range) return *scene_->range;
  Time last{INT64_MIN};
  const auto reach = [&](const Track& t) {
    if (!t.events.empty()) last = std::max(last, t.events.back().time);
  };
  for (std::size_t i = 0; i < scene_->objects.size(); ++i) {
    if (scene_->objects[i].derived) continue;
    for (const Slot& slot : scene_->objects[i].slots)
      for (const Strand* strand : {static_cast<const Strand*>(&slot), &slot.velocity}) {
        reach(*strand->track);
        for (const auto& c : strand->components) reach(*c);
      }
  }
  if (!scene_->cuts->empty()) last = std::max(last, scene_->cuts->rbegin()->first);
  for (const auto& [from, way] : *scene_->cut_ways) last = std::max(last, from + way.length);
  if (!scene_->notes->empty()) last = std::max(last, scene_->notes->rbegin()->first);
  if (!scene_->pauses->empty()) last = std::max(last, scene_->pauses->rbegin()->first);
  if (!scene_->descriptions->empty()) last = std::max(last, scene_->descriptions->rbegin()->first);
  for (const Section& one : *scene_->sections) last = std::max(last, one.end);
  if (!scene_->later_lists->empty()) last = std::max(last, scene_->later_lists->rbegin()->first);
  if (last <= Time{}) return {{}, scene_->rate.frame(std::max(1.0, std::round(scene_->rate.per_second())))};
  return {{}, last};
}

std::optional<std::pair<int, int>> Document::size() const {
  const Appearance& a = scene_->appearance;
  return !a.size && a.flat ? std::pair(1920, 1080) : a.size;
}
std::optional<int> Document::samples() const { return scene_->appearance.samples; }
std::optional<int> Document::subframes() const { return scene_->appearance.subframes; }
bool Document::transparent() const { return scene_->appearance.clear; }

double Document::aspect() const {
  const auto pixels = size().value_or(std::pair(16, 9));
  return static_cast<double>(pixels.first) / pixels.second;
}

int Document::frame_count() const {
  const auto [from, to] = range();
  const double n = std::floor(scene_->rate.frame_number(to) - scene_->rate.frame_number(from) + 1e-9) + 1;
  return static_cast<int>(std::clamp(n, 1.0, 2e9));
}

std::vector<std::string> Document::names() const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < scene_->objects.size(); ++i)
    if (!scene_->objects[i].removed) out.push_back(scene_->objects[i].name);
  return out;
}

ObjectId Document::find(std::string_view name) const { return find_named(*scene_, name); }

std::vector<Note> Document::notes(Time from, Time to) const {
  std::vector<Note> out;
  if (to < from) return out;
  for (auto n = scene_->notes->lower_bound(from); n != scene_->notes->upper_bound(to); ++n) out.push_back(n->second);
  return out;
}

bool operator==(const Document& a, const Document& b) { return a.scene_ == b.scene_ || same(*a.scene_, *b.scene_); }

}  // namespace betwixt
