// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document holds. A Scene is a value: copying it shares all its parts, editing a copy leaves the original as it
// was, and costs what the edit touches, not what the document holds.
#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "base/cow.h"
#include "betwixt/document.h"
#include "betwixt/sound.h"
#include "scene/appearance.h"
#include "scene/display_list.h"
#include "scene/environment.h"
#include "scene/functions.h"
#include "scene/kinds.h"
#include "scene/name_index.h"
#include "scene/outline.h"
#include "scene/quantity.h"
#include "track/filter.h"
#include "track/track.h"
#include "track/twerpers.h"

namespace betwixt {

// What is known of one display function of one object: the value while there are no events, and the track or the tracks
// of its components.
struct Strand {
  Cow<Track> track;                    // events of the whole value …
  std::vector<Cow<Track>> components;  // … or of each component (as many as the type has); never both
};
struct Slot : Strand {
  FunctionId function = 0;
  ObjectId layer;  // none: the object's own; else what the layer lays over it
  std::optional<Value> set;
  Strand velocity;              // per second; rules while it reigns (R-T5)
  std::vector<Filter> filters;  // the first one sees the track, each next one what the one before made of it
};

struct Object {
  std::string name;
  Kind kind = Kind::group;
  bool removed = false;
  bool leads = false;                              // something has been attached to it: it may be part of a circle
  bool derived = false;                            // a display list says what it is
  std::vector<Slot> slots;                         // sorted by function, then layer (the object's own first)
  std::shared_ptr<const Environment> environment;  // of Kind::environment

  const Slot* find(FunctionId f, ObjectId layer = {}) const;
  Slot& slot(FunctionId f, ObjectId layer = {});  // made where there is none
};

// Objects by number, in a tree that copies share: an edit copies the way to one object, however many there are.
class Objects {
 public:
  std::size_t size() const { return size_; }
  const Object& operator[](std::size_t i) const { return *object(i); }
  Object& edit(std::size_t i) { return shelves_[i / shelf].edit()[i / chunk % chunk].edit()[i % chunk].edit(); }
  std::size_t add(Object object);
  // Whether an object is the one that is there too; it may be equal and another.
  bool same(std::size_t i, const Objects& other) const {
    return i < size_ && i < other.size_ && object(i).same(other.object(i));
  }
  // f(number) for those that may be others than the ones of `before`; what both share is passed over.
  template <class F>
  void each_changed(const Objects& before, F&& f) const {
    each_chunk_apart(before, [&](std::size_t first, const Chunk& mine, const Chunk* theirs) {
      for (std::size_t k = 0; k < mine.size(); ++k)
        if (!theirs || k >= theirs->size() || !mine[k].same((*theirs)[k])) f(first + k);
    });
  }

  void share(const Objects& before);                    // takes over those that are exactly the same there
  std::size_t bytes_apart(const Objects& other) const;  // of what it holds and the other does not, but for the objects

 private:
  using Chunk = std::vector<Cow<Object>>;
  using Shelf = std::vector<Cow<Chunk>>;
  static constexpr std::size_t chunk = 128, shelf = chunk * chunk;
  const Cow<Object>& object(std::size_t i) const { return (*(*shelves_[i / shelf])[i / chunk % chunk])[i % chunk]; }
  // f(number of its first object, chunk, what the other has there or null) for those that the other does not share.
  template <class F>
  void each_chunk_apart(const Objects& other, F&& f) const {
    for (std::size_t s = 0; s < shelves_.size(); ++s) {
      const Cow<Shelf> theirs = s < other.shelves_.size() ? other.shelves_[s] : Cow<Shelf>();
      if (shelves_[s].same(theirs)) continue;
      for (std::size_t c = 0; c < shelves_[s]->size(); ++c) {
        const Cow<Chunk>& mine = (*shelves_[s])[c];
        const Cow<Chunk>* there = c < theirs->size() ? &(*theirs)[c] : nullptr;
        if (!there || !mine.same(*there)) f(shelf * s + chunk * c, *mine, there ? &**there : nullptr);
      }
    }
  }
  std::vector<Cow<Shelf>> shelves_;
  std::size_t size_ = 0;
};

enum class Policy : std::uint8_t { translate, ignore, ask };
inline constexpr std::array<std::string_view, 3> policy_names{"translate", "ignore", "ask"};

// Code of the author's, or of a plug-in, with a name of its own.
struct NamedProcedure {
  std::string name;
  Role role = Role::value;
  std::shared_ptr<const Routine> code;
  friend bool operator==(const NamedProcedure& a, const NamedProcedure& b) {
    return a.name == b.name && a.role == b.role && Procedure{a.code} == Procedure{b.code};
  }
};

// A control of live input, and what it turns: values from low..high become values from..to.
struct Dial {
  std::string address;  // "/fader/1"
  Target target;
  double low = 0, high = 1;
  Value from = 0.0, to = 1.0;
  bool mapped = false;  // else the numbers go as they come
};

// What a file of a scene has made, as it was then: written, it is that command and what differs from it by now.
struct FromFile {
  ObjectId root;              // those that follow it are its parts
  std::string name, command;  // the root's name then; `scene file="truck.glb" animation=1`
  std::vector<Object> parts;
};

struct Scene {
  Rate rate, ticks{30, 1};
  std::optional<std::pair<Time, Time>> range;
  std::optional<Color> background;
  Appearance appearance;
  bool notes_shown = true;
  Policy policy = Policy::ask;

  Objects objects;
  NameIndex names;
  Cow<std::vector<FunctionSpec>> defined;  // the user's own functions; ids follow the built-in ones
  Cow<Aliases> aliases;
  Cow<Lets> lets;                                        // what names in formulas stand for
  Cow<std::vector<std::pair<Time, std::string>>> notes;  // sorted by time
  Cow<std::vector<NamedProcedure>> procedures;           // events speak of twerpers by their place here
  Cow<std::vector<Dial>> dials;
  Cow<DisplayLists> lists;                // from the beginning
  Cow<LaterLists> later_lists;            // what edits at a time have made of them
  std::string main;                       // the list that is expanded; may be empty
  Cow<std::vector<ObjectId>> expansion;   // the objects it has become, what holds others before them
  Cow<std::vector<std::uint32_t>> spare;  // removed objects whose numbers can be given to derived ones
  Cow<std::map<Time, ObjectId>> views;    // the main list's camera from when on; none: it has none then
  std::uint64_t environment_events = 0;   // so far: the order of those in one tick
  bool smooth_ticks = false;              // environments move between their ticks, where they can (R-E1d)
  bool recording = false;                 // what dials say becomes events
  Cow<std::map<Time, ObjectId>> cuts;     // which camera is looked through from when on
  // What files held when they were named, by the path as the author wrote it.
  Cow<std::map<std::string, std::shared_ptr<const Mesh>>> meshes;
  Cow<std::vector<FromFile>> from_files;
  Cow<std::map<std::string, std::shared_ptr<const Picture>>> pictures;
  Cow<std::map<std::string, std::shared_ptr<const Sound>>> sounds;
  Cow<std::map<std::string, std::shared_ptr<const Outline>>> formulas;  // what TeX made of them, by their own words
};

const FunctionSpec& spec_of(const Scene&, FunctionId);
// The function of this name that objects of the kind have.
std::optional<FunctionId> find_function(const Scene&, Kind, std::string_view name);
std::vector<std::string_view> function_names(const Scene&, Kind);  // for near misses

inline const Object* find_object(const Scene& s, ObjectId id) {
  return id.index < s.objects.size() && !s.objects[id.index].removed ? &s.objects[id.index] : nullptr;
}

// Objects a word names: an alias (its order), a pattern or braces (name order), or one name. Unknown names are left
// out.
std::vector<ObjectId> select(const Scene&, std::string_view word);
// Those of some that a pattern names, in its order.
std::vector<ObjectId> select(const Scene&, std::string_view pattern, const std::vector<ObjectId>& some);
// First what holds from the beginning, then the track's, each until the next.
std::vector<AttachmentSpan> attachments(const Object&);
// The environments that an object is in (fn::environments) or that drive it (fn::drive), the outermost first, each
// until the next; the first ones count before their time too. Which generation of a name that is was settled when the
// event that says so came (R-E9).
struct Generation {
  ObjectId environment;
  int number = 0;
};
struct EnvironmentsFrom {
  Time from;
  std::vector<Generation> all;
};
std::vector<EnvironmentsFrom> environments_of(const Scene&, const Object&, FunctionId);
// Would `child` attached to `parent` from `from` to `until` hang, at some time, on itself? The circle's objects from
// the child on; empty: no.
std::vector<ObjectId> circle(const Scene&, ObjectId child, ObjectId parent, Time from, Time until);
// "leg.rotation.z", "ball.world", "ball.position.velocity"; ".scale.x" is of `self`.
Result<Target> find_target(const Scene&, std::string_view text, ObjectId self = {});
const NamedProcedure* find_procedure(const Scene&, std::string_view name);
std::string twerper_name(const Scene&, Twerper);

ObjectId add_object(Scene&, Object object);
// What was coupled to them stands free; tracks that speak of them hold nothing there. `speaking`: who may do so.
void remove_objects(Scene&, const std::vector<ObjectId>&, const std::vector<std::uint32_t>& speaking);

// The track to write events of a target to; writing a component splits the track (rules, section 6).
// For a whole value of a split track there is none: write its components.
Track* edit_track(Scene&, const Target&);
// All tracks that a target stands for: one, or one per component.
std::vector<Track*> edit_tracks(Scene&, const Target&);
std::vector<const Track*> tracks_of(const Scene&, const Target&);
void put_event(Scene&, const Target&, Event);
Strand split_into_components(const Strand&, Type type);
void set_value(Scene&, const Target&, const Value&);

// Same content: names, values, tracks, everything the author can see; not how it came to be.
bool same(const Scene&, const Scene&);
// Takes over what is exactly the same in a scene before: what is compiled from it then costs what differs.
void share(Scene&, const Scene& before);
// A centre that is gone is the origin, in the film, in what is written and in what is compared.
Motion about_what_is_there(const Scene&, Motion);

}  // namespace betwixt
