// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The content of a document. A Scene is a value: a copy shares all its parts; editing the copy does not change the
// original. An edit costs as much as it changes, however large the document is.
#pragma once

#include <algorithm>
#include <array>
#include <map>

#include "base/cow.h"
#include "betwixt/document.h"
#include "betwixt/layer.h"
#include "betwixt/sound.h"
#include "scene/appearance.h"
#include "scene/display_list.h"
#include "scene/environment.h"
#include "scene/functions.h"
#include "scene/kinds.h"
#include "scene/name_index.h"
#include "scene/outline.h"
#include "scene/own_functions.h"
#include "scene/part.h"
#include "scene/quantity.h"
#include "scene/spoken_words.h"
#include "scene/table.h"
#include "scene/video.h"
#include "track/filter.h"
#include "track/track.h"
#include "track/twerpers.h"

namespace betwixt {

struct OwnKinds;  // scene/own_kinds.h

// The state of a display function of an object: the value while there are no events, and the track, or the tracks of
// its components.
struct Strand {
  Cow<Track> track;                    // events of the whole value …
  std::vector<Cow<Track>> components;  // … or of each component (as many as the type has); never both
};
struct Slot : Strand {
  FunctionId function = 0;
  ObjectId layer;  // the layer that it is on; without one, the object's own
  std::optional<Value> set;
  Strand velocity;              // per second; overrides the track during its reign
  std::vector<Filter> filters;  // the first gets the track, each further one the result of the one before
};

struct Object {
  std::string name;
  Kind kind = Kind::group;
  bool removed = false;
  bool leads = false;                              // has had children, so it may be part of a circle
  bool derived = false;                            // comes from a display list
  bool hidden = false;                             // belongs to the hidden model of a kind: never shown nor heard
  std::vector<Slot> slots;                         // sorted by function, then layer (the object's own first)
  std::shared_ptr<const Environment> environment;  // of Kind::environment

  const Slot* find(FunctionId f, ObjectId layer = {}) const;
  Slot& slot(FunctionId f, ObjectId layer = {});  // makes it if there is none
};

// Objects by number, in a tree that copies share: an edit copies the path to one object, however many there are.
class Objects {
 public:
  std::size_t size() const { return size_; }
  const Object& operator[](std::size_t i) const { return *object(i); }
  Object& edit(std::size_t i) { return shelves_[i / files].edit()[i / chunk % chunk].edit()[i % chunk].edit(); }
  std::size_t add(Object object);
  // Returns whether both share the object. If not, the two may still be equal.
  bool same(std::size_t i, const Objects& other) const {
    return i < size_ && i < other.size_ && object(i).same(other.object(i));
  }
  // Calls f(number) for objects that may differ from those of `before`; skips those that both share.
  template <class F>
  void each_changed(const Objects& before, F&& f) const {
    each_chunk_apart(before, [&](std::size_t first, const Chunk& mine, const Chunk* theirs) {
      for (std::size_t k = 0; k < mine.size(); ++k)
        if (!theirs || k >= theirs->size() || !mine[k].same((*theirs)[k])) f(first + k);
    });
  }

  void share(const Objects& before);  // shares the objects that are exactly equal
  std::size_t bytes_apart(
      const Objects& other) const;  // of its own nodes that the other does not share, without objects

 private:
  using Chunk = std::vector<Cow<Object>>;
  using FileSource = std::vector<Cow<Chunk>>;
  static constexpr std::size_t chunk = 128, files = chunk * chunk;
  const Cow<Object>& object(std::size_t i) const { return (*(*shelves_[i / files])[i / chunk % chunk])[i % chunk]; }
  // Calls f(number of its first object, chunk, the other's chunk or null) for chunks that the other does not share.
  template <class F>
  void each_chunk_apart(const Objects& other, F&& f) const {
    for (std::size_t s = 0; s < shelves_.size(); ++s) {
      const Cow<FileSource> theirs = s < other.shelves_.size() ? other.shelves_[s] : Cow<FileSource>();
      if (shelves_[s].same(theirs)) continue;
      for (std::size_t c = 0; c < shelves_[s]->size(); ++c) {
        const Cow<Chunk>& mine = (*shelves_[s])[c];
        const Cow<Chunk>* there = c < theirs->size() ? &(*theirs)[c] : nullptr;
        if (!there || !mine.same(*there)) f(files * s + chunk * c, *mine, there ? &**there : nullptr);
      }
    }
  }
  std::vector<Cow<FileSource>> shelves_;
  std::size_t size_ = 0;
};

enum class Policy : std::uint8_t { translate, ignore, ask };
inline constexpr std::array<std::string_view, 3> policy_names{"translate", "ignore", "ask"};

// The times of a stepped procedure's steps.
struct Stepping {
  Time every;         // 0: one frame of the film
  Time from;          // of step 0
  bool hold = false;  // between two steps, the state is that of the first and not a blend
  friend bool operator==(const Stepping&, const Stepping&) = default;
};

// A named parameter of a command of the author's own.
struct CommandParameter {
  std::string name, type;  // `type`: a word of the language, as in "time"
  std::string said, code;  // the default, as the script says it and in Lua; both are empty if it has none
  friend bool operator==(const CommandParameter&, const CommandParameter&) = default;
};

// The author's or a plug-in's code, with a name.
struct NamedProcedure {
  std::string name;
  Role role = Role::value;
  std::shared_ptr<const Routine> code;
  Stepping stepping = {};                         // of the role `steps`
  std::vector<CommandParameter> parameters = {};  // of the role `command`; without any, it gets words
  std::string help = {};                          // the author's sentence about it
  Place code_at = {};                             // of the code, for the messages of a command
  friend bool operator==(const NamedProcedure& a, const NamedProcedure& b) {
    return a.name == b.name && a.role == b.role && a.stepping == b.stepping && a.parameters == b.parameters &&
           a.help == b.help && Procedure{a.code} == Procedure{b.code};
  }
};

// A control of live input and its target: values low..high become from..to.
struct Dial {
  std::string address;  // "/fader/1"
  Target target;
  double low = 0, high = 1;
  Value from = 0.0, to = 1.0;
  bool mapped = false;  // false: numbers are passed unchanged
};

// The objects of a scene file as they were made. A written script has this command and the differences from it.
struct FromFile {
  ObjectId root;              // its parts follow it
  std::string name, command;  // the root's name then; `scene file="truck.glb" animation=1`
  std::vector<Object> parts;
};

// A change of the camera that takes time.
struct CutWay {
  Time length;
  ChangeKind kind = ChangeKind::dissolve;
  friend bool operator==(const CutWay&, const CutWay&) = default;
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
  Cow<OwnFunctions> defined;  // the user's own functions; ids follow the built-in ones
  Cow<OwnKinds> kinds;        // the user's own kinds
  Objects kinds_saw;          // the objects when the instances of kinds were last updated; empty without kinds
  Cow<Aliases> aliases;
  Cow<Lets> lets;                        // the names in formulas
  Cow<Tables> tables;                    // the data of the film, by name
  Cow<PartsByName> parts;                // lines that `create` carries out
  Cow<Tables> tables_read;               // all that were read, by what follows `data NAME`
  Cow<std::multimap<Time, Note>> notes;  // those of one time in the order in which they came
  Cow<std::vector<Section>> sections;    // as they are written
  Cow<std::map<Time, Pause>> pauses;     // where a speaker waits
  Cow<std::map<Time, Description>> descriptions;
  Cow<std::vector<NamedProcedure>> procedures;  // events refer to own twerpers by their index here
  Cow<std::vector<Dial>> dials;
  Cow<DisplayLists> lists;                // from the beginning
  Cow<LaterLists> later_lists;            // the versions that edits at a time have made
  std::string main;                       // the list that is expanded; may be ""
  Cow<std::vector<ObjectId>> expansion;   // its objects, parents before children
  Cow<std::vector<std::uint32_t>> spare;  // removed objects whose numbers derived ones may get
  Cow<std::map<Time, ObjectId>> views;    // the main list's camera from each time on, if it has any
  std::uint64_t environment_events = 0;   // the number of events until now, which orders those in one tick
  bool smooth_ticks = false;              // environments move between their ticks, where they can
  bool recording = false;                 // dials make events
  Cow<std::map<Time, ObjectId>> cuts;     // the camera from each time on
  Cow<std::map<Time, CutWay>> cut_ways;   // how the picture goes over to it, for those that are no sudden cuts
  // The content of files when they were named, by the path in the script.
  Cow<std::map<std::string, std::shared_ptr<const Mesh>>> meshes;
  Cow<std::vector<FromFile>> from_files;
  Cow<std::map<std::string, std::shared_ptr<const Picture>>> pictures;
  Cow<std::map<std::string, std::shared_ptr<const Sound>>> sounds;
  Cow<std::map<std::string, std::shared_ptr<const Video>>> videos;
  Cow<std::map<std::string, std::shared_ptr<const SpokenWords>>> words;
  Cow<std::map<std::string, std::shared_ptr<const OwnFont>>> fonts;
  Cow<std::map<std::string, std::shared_ptr<const Outline>>> formulas;  // set by TeX, by their text
};

const FunctionSpec& spec_of(const Scene&, FunctionId);
// Returns the function of this name that objects of the kind have.
std::optional<FunctionId> find_function(const Scene&, Kind, std::string_view name);
std::vector<std::string_view> function_names(const Scene&, Kind);  // for suggestions

inline const Object* find_object(const Scene& s, ObjectId id) {
  return id.index < s.objects.size() && !s.objects[id.index].removed ? &s.objects[id.index] : nullptr;
}

// Returns the objects that a word names: an alias (in its order), a pattern or braces (in order of names), or one name.
// Unknown names are skipped.
std::vector<ObjectId> select(const Scene&, std::string_view word);
// Returns those of some objects that a pattern names, in its order.
std::vector<ObjectId> select(const Scene&, std::string_view pattern, const std::vector<ObjectId>& some);
// Returns first the attachment from the beginning, then those of the track, each until the next.
std::vector<AttachmentSpan> attachments(const Object&);
// The environments that an object is in (fn::environments) or that drive it (fn::drive), the outermost first, each list
// until the next; the first ones count before their time too. The generation of each name was determined when its
// event came.
struct Generation {
  ObjectId environment;
  int number = 0;
};
struct EnvironmentsFrom {
  Time from;
  std::vector<Generation> all;
};
std::vector<EnvironmentsFrom> environments_of(const Scene&, const Object&, FunctionId);
// Returns the circle that would arise if `child` were attached to `parent` from `from` to `until`, as objects from the
// child on, or an empty list if there would be none at any time.
std::vector<ObjectId> circle(const Scene&, ObjectId child, ObjectId parent, Time from, Time until);
// Reads "leg.rotation.z", "ball.world", "ball.position.velocity"; ".scale.x" is of `self`.
Result<Target> find_target(const Scene&, std::string_view text, ObjectId self = {});
const NamedProcedure* find_procedure(const Scene&, std::string_view name);
std::string twerper_name(const Scene&, Twerper);
// Returns the author's twerper or tween of this name.
std::optional<Twerper> find_own_twerper(const Scene&, std::string_view name);
// Returns the code of a tween: a twerper of the author's that returns the value itself. Null for all other twerpers.
const Routine* tween(const Scene&, Twerper);
// Returns whether the twerper, which may be the author's, has a meaning for values of the type; sets `why` if not.
bool fits(const Scene&, Twerper, Type, std::string* why = nullptr);

ObjectId add_object(Scene&, Object object);
// Removes objects. Their children have no parent then, and references to them are cleared. `speaking`: who may have
// any.
void remove_objects(Scene&, const std::vector<ObjectId>&, const std::vector<std::uint32_t>& speaking);

// Returns the track for events of a target; writing a component splits the track (rules, section 6). Returns null for
// the whole value of a split track: write its components.
Track* edit_track(Scene&, const Target&);
// Returns all tracks of a target: one, or one for each component.
std::vector<Track*> edit_tracks(Scene&, const Target&);
std::vector<const Track*> tracks_of(const Scene&, const Target&);
void put_event(Scene&, const Target&, Event);
Strand split_into_components(const Strand&, Type type);
void set_value(Scene&, const Target&, const Value&);

// Returns whether the content is equal: names, values, tracks, everything that the author can see, but not its history.
bool same(const Scene&, const Scene&);
// Shares the parts that are exactly equal in an earlier scene, so that compiling costs only the differences.
void share(Scene&, const Scene& before);
// Replaces the centres that no longer exist by the origin, for evaluation, writing and comparison alike.
Motion about_what_is_there(const Scene&, Motion);

}  // namespace betwixt
