// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document is compiled to. Every display function in use has a place in one array of numbers; the constants are
// there already, curves write theirs for the time asked. What is not numbers (texts, shapes, names) is looked up when
// wanted.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <optional>

#include "betwixt/evaluation.h"
#include "betwixt/program.h"
#include "program/environment_set.h"
#include "program/playing.h"
#include "scene/document.h"
#include "scene/extent.h"
#include "scene/line.h"
#include "scene/rig.h"
#include "track/reign.h"

namespace betwixt {

struct Whole;
struct Answer;
class Beside;
class Tracer;

// Where the value of one display function of one object comes from.
struct Binding {
  FunctionId function = 0;
  std::uint8_t channels = 0;  // numbers; 0: a value that is not made of numbers
  bool orientation = false;   // a rotation held as a quaternion
  std::uint32_t offset = 0;   // of its numbers
  std::uint32_t first_curve = 0, curves = 0;
  std::int32_t steps = -1;  // events of a value that is not numbers …
  Value constant;           // … or the value for good
  std::int32_t live = -1;   // worked out from more than one track, or by code: Compiled::lives
  bool varies() const { return curves > 0 || steps >= 0 || live >= 0; }
};

struct CurveUse {
  Curve curve;
  std::uint32_t offset = 0;
  bool bounded = false;  // a curve that swings past what the function can be stays at that
  double low = 0, high = 0;
  void bound(double* numbers) const {
    if (bounded)
      for (int i = 0; i < curve.channels; ++i) numbers[i] = std::clamp(numbers[i], low, high);
  }
};

// Part of the time of a track with a velocity beside it: the primary track's own, or a reign (R-T5).
struct Piece {
  Time from;
  bool scripted = false;  // the primary track has procedures
  Curve primary;          // count 0: the value at rest
  std::int32_t reign = -1;
};

// One track of a function's value or component, with what is not plain about it.
struct LivePart {
  int component = -1;
  Type type = Type::scalar;
  bool orientation = false, srgb_numbers = false;
  std::vector<Piece> pieces;  // by time; empty: scripted
  Track track;                // scripted: events among which are procedures
  Value rest;
  // A colour's component blends as light; its values are numbers.
  Type value_type() const { return component >= 0 && row_of(type).light ? Type::scalar : type; }
  std::size_t piece_at(Time) const;  // where there are pieces
};

struct LiveStrand {
  ObjectId layer;
  bool mix = false;
  std::int32_t plain = -1;  // all of it is a plain binding: Compiled::plains
  Value set;
  Time from{INT64_MIN};  // on a layer: when it begins to say something
  std::vector<LivePart> parts;
  std::vector<Filter> filters;
};

// A function's value that is not one plain track: velocities, procedures, filters, layers.
struct Live {
  std::uint32_t object = 0;
  FunctionId function = 0;
  std::vector<LiveStrand> strands;  // the object's own first
};

// A value that is worked out: of a live, or of one component of it, at a time.
struct Sought {
  std::int32_t live = 0;
  int component = -1;
  std::int64_t time = 0;
  friend auto operator<=>(const Sought&, const Sought&) = default;
};

// What one question leads to. Values found on the way are kept, unless a circle was cut to find them (R-T11).
struct Asking {
  struct Taken {  // by an answer
    std::uint64_t cost = 0;
    std::vector<Sought> asked;  // on the way, and itself: while one of these is open the answer may be another
  };
  template <class T>
  struct Found {
    T value;
    Taken taken;
  };
  std::vector<Sought> open;    // being worked out
  std::vector<Sought> asked;   // what that has taken so far
  std::size_t cut = SIZE_MAX;  // how deep in `open` the outermost cut reached
  std::map<Sought, Found<Value>> found;
  std::map<std::int64_t, Found<std::shared_ptr<const Contacts>>> found_contacts;
  std::uint64_t cost = 0;           // so far, in steps
  std::uint64_t begun = 0;          // what it was when the outermost question began …
  bool given_up = false;            // … which has taken more than it may: it is left without an answer
  std::uint64_t most = UINT64_MAX;  // that all of it may take; whoever says less throws the answer away then
  bool in_haste() const { return most < UINT64_MAX; }
  std::vector<std::string> problems;
  std::vector<Frame::CodeError> errors;
  std::vector<Target> read;        // what procedures looked at
  const Beside* beside = nullptr;  // who has the answers of the outermost questions; null: they are worked out here

  // The work that one question may set going: procedures' steps, what filters look at, whatever asks whatever. It is
  // counted as if nothing were known already, so that it is the same whoever asked before.
  static constexpr std::uint64_t most_work = 10'000'000;
  // … and all questions of one frame, one after the other.
  static constexpr std::uint64_t most_of_a_frame = 50'000'000;
  // Counts work; true: it was too much, here or before.
  bool work(std::uint64_t steps) {
    cost += steps;
    given_up = given_up || cost - begun > most_work || cost > most;
    if (given_up) cut = 0;  // nothing found from here on is kept
    return given_up;
  }

  void say(std::string problem);
  void err(std::string problem, const std::string& source);  // of the author's code
  void say_all(const Answer&);                               // what that has said
  bool is_open(const Taken&) const;                          // one of what it asked is
  void take(const Taken&);                                   // once more, for what is being worked out now
};

// An answer being worked out, and what it takes.
class Working {
 public:
  explicit Working(Asking&);
  // It is worked out. None where it is not to be kept: something outside it was cut for it.
  std::optional<Asking::Taken> done();

 private:
  Asking& asking_;
  std::uint64_t before_;
  std::size_t depth_, outer_cut_;
  std::ptrdiff_t first_;
};

// Where a node is within the environments that enclose it, and the part of that which children take on when scales
// stay out (R-H2, R-H7).
struct Placed {
  Mat4 world;
  Quat turn;
};
// The same, and those environments' matrix.
struct Sited : Placed {
  Mat4 around;
  Mat4 in_world() const { return around * world; }
};

// An attachment in force from a time on.
struct CompiledSpan {
  Time from;
  AttachmentKind kind = AttachmentKind::detach;
  std::int32_t parent = -1;  // a node
  std::int32_t frozen = -1;  // what a letgo or keep-world keeps
  bool one_body = false;     // with the parent
  bool computed = false;     // code says what it hangs on: Compiled::held
};
struct Frozen {
  std::uint32_t node = 0;
  std::int32_t span = 0;  // which of the node's
  enum { asleep, busy, done } state = asleep;
  Mat4 before;  // applied to what the tracks say, before the parent
  Quat before_turn;
  Mat4 turn3, parent;  // letgo: B and the parent's matrix, as they were
  Mat4 around;         // letgo: the environments that the parent was in
  Quat parent_turn;
  Vec3 attach;
  bool held = false;  // letgo: there was a parent
};

// What carries an object's position p: in the world it is above (kept p + attach). And how it is turned by that.
struct Carrier {
  Mat4 above, kept;
  Vec3 attach;
  Quat turn;
  std::optional<Vec3> seen(Vec3 in_world) const;  // as a position; none where it is flattened
};

// The motions of one object, one after the other: each begins where the ones before it end. (rules, R-H7)
struct Moving {
  struct Piece {
    Time from, until;
    Motion motion;      // its centres are places
    Mat4 before;        // all pieces before it, whole
    Curve progress;     // how much of it is done
    bool open = false;  // it has no end, and does nothing
  };
  std::vector<Piece> pieces;  // by time
  Time first, last;           // of the track's events
  Extrapolation extend_before = Extrapolation::hold, extend_after = Extrapolation::hold;
  std::size_t placed = 0;  // whose centres are known: all, when compiling ends
};

struct Node {
  std::uint32_t object = 0;
  std::uint32_t first_span = 0, spans = 0;
  Kind kind = Kind::group;
  bool orientation = false;
  std::uint32_t position = 0, rotation = 0, scale = 0, pivot = 0, attach = 0, display = 0, color = 0;  // offsets
  std::int32_t around = -1, drive = -1;                                                                // sitings
  std::int32_t moving = -1;                                                                            // motions
  bool transform = false;                                                                              // it has one
  bool looks = false;        // it is turned by what it looks at, or rolled
  bool bends = false;        // it may be turned by what reaches for something
  std::uint8_t reaches = 0;  // for something, by so many joints
};

// A mesh that is deformed from time to time.
struct Skin {
  std::uint32_t drawable = 0;
  std::shared_ptr<const Mesh> rest;
  std::vector<std::int32_t> joints;     // nodes, by the numbers of its rig; -1: none, which stays where it was
  std::vector<const Binding*> weights;  // of its targets; null: nobody says any
};

// What is drawn, or may be: the node of the same number.
struct Drawable {
  std::uint32_t transparency = 0, shininess = 0, casts = 0;  // offsets
  const Binding *material = nullptr, *texture = nullptr, *geometry = nullptr;
  std::uint32_t shape = 0;  // a number of Compiled::shapes; one beyond them where it varies
  // Of its material and texture, where these do not vary.
  bool plain = false;
  std::int32_t skin = -1;
  std::int32_t slow = -1;  // of Compiled::slow_shapes
  Material material_number = Material::plastic;
  std::uint32_t texture_number = 0;
};

// What of an object depends on a value.
namespace affects {
// `around`: the product of the environments that a node is in.
enum : std::uint8_t { place = 1, look = 2, form = 4, aim = 8, other = 16, around = 32, all = 63 };
}  // namespace affects

// When what changes: from one time to another only those sources need be asked that go on changing at the first, or
// begin to on the way.
struct Schedule {
  struct Source {
    enum What : std::uint8_t { curve, steps, attachment, motion, siting } what = curve;
    std::uint8_t affects = 0;
    std::uint32_t index = 0;  // of curves, steps, movings, sitings
    std::uint32_t node = 0;
    std::uint32_t first_activity = 0, activities = 0;
  };
  struct LiveSource {
    const Binding* binding = nullptr;
    std::uint8_t affects = 0;
    std::uint32_t node = 0;
    bool solid = false;  // what touches what may depend on it
  };
  struct Edge {
    std::int64_t time = 0;
    std::uint32_t source = 0;
  };
  std::vector<Source> sources;
  std::vector<CurveEvents> events;                              // of each source that is a curve
  std::vector<Activity> activities;                             // by source, then time
  std::vector<Edge> begins, ends;                               // of all activities, by time
  std::vector<LiveSource> lives;                                // nobody knows when they change
  const Activity* active(const Source&, std::int64_t t) const;  // in which it goes on changing behind t; or null
};

// The environments that something is in, the outermost first, and since when. Which generation of a name that is was
// settled when the event that says so came (R-E9).
struct Site {
  std::uint32_t environment = 0;
  int generation = 0;
  std::uint32_t member = 0;  // of Compiled::many
  friend bool operator==(const Site&, const Site&) = default;
};
struct Siting {
  struct Change {
    Time from;
    std::vector<Site> sites;
    friend bool operator==(const Change&, const Change&) = default;
  };
  std::vector<Change> changes;  // by time; the first one counts before it too
};

// What one object was compiled to, in the arrays of Compiled: pieces that begin where those of the object before end.
struct ObjectPiece {
  std::uint32_t binding = 0, curve = 0, step = 0, number = 0, source = 0;  // where it begins
  bool alone = false;  // nothing of it depends on others: an edited document can have it as it is
  std::shared_ptr<const CurveColumns> columns;
};

struct Program::Compiled {
  explicit Compiled(Document d);
  ~Compiled();

  Document document;
  CurveSet set;
  std::vector<double> rest;  // the array of numbers, constants filled in
  std::vector<CurveUse> curves;
  std::vector<std::shared_ptr<const StepTrack>> steps;
  std::vector<Binding> bindings;                    // by object, then function
  std::vector<ObjectPiece> pieces;                  // per object, and one more
  std::vector<Binding> defaults;                    // per function: where no object says otherwise
  std::map<Kind, std::vector<FunctionId>> shaping;  // what is part of a shape, of each kind
  std::vector<Binding> plains;                      // of strands of lives
  std::vector<Live> lives;
  std::vector<Reign> reigns;
  std::vector<Node> nodes;  // drawables, then the others, each by object
  std::vector<Drawable> drawables;
  std::vector<Skin> skins;
  std::vector<std::shared_ptr<const Shape>> shapes;  // those that do not vary, each once
  std::vector<std::shared_ptr<const Picture>> textures;
  std::vector<std::uint32_t> lights, eyes;    // nodes; eyes: those that look at something
  std::vector<std::uint32_t> borrowers;       // drawables that may look like others
  std::vector<std::uint32_t> slow_shapes;     // drawables whose shapes may take long to make
  std::optional<std::uint32_t> first_camera;  // an object
  Schedule schedule;
  std::vector<CompiledSpan> spans;          // by node, then time
  std::vector<std::uint32_t> held_by_code;  // nodes, at some time
  mutable std::vector<Frozen> frozen;       // all done when compiling ends
  std::vector<std::shared_ptr<const Environment>> environments;
  std::vector<Siting> sitings;
  std::vector<Moving> movings;
  // Where there are many, all of them go from tick to tick together: each evaluator has a set of its own, and whoever
  // asks for one value waits for this one. Few are asked one by one.
  std::optional<EnvironmentSet> mutable many;
  mutable std::mutex many_in_use;
  bool sited = false;                     // some node is in an environment
  bool looks = false;                     // some node is turned by what it looks at
  bool turning = false;                   // some node hangs on how another is turned alone
  std::vector<playing::Offsets> offsets;  // by node
  std::vector<std::string> notices;       // attachments that had to be ignored
  std::vector<std::uint32_t> node_of;     // per object

  bool draws(std::uint32_t node) const { return node < drawables.size(); }
  const Binding& find(std::uint32_t object, FunctionId f) const;
  static Material material(const Value&);
  std::uint32_t texture(const Value&) const;  // Look::none where there is no such picture

  // Evaluation of one value, or of one object; of all there is: evaluator.h. `numbers` is the array for the time.
  void evaluate(const CurveUse& use, Time t, double* out) const;
  // One binding alone: its numbers only.
  void evaluate(const Binding& b, Time t, Asking&, double* out) const;
  // As the author writes values. `component`: that one alone, a number, where it can be worked out alone (parted());
  // so one component may look at another.
  Value live_value(std::int32_t live, Time t, Asking&, int component = -1) const;
  bool parted(std::int32_t live, int component) const;
  // The rate of change per second, as the author would write it; nothing where that means nothing. From the time on, or
  // `coming` to it.
  std::optional<Value> velocity(std::uint32_t object, FunctionId f, Time t, Asking&, bool coming = false) const;
  // By a reign or by its curve; false: by neither.
  bool said_velocity(const LivePart&, Time t, bool coming, double* out) const;
  Value read(const Target&, Time t, Asking&) const;
  Value heard(const Target&, Time t, Asking&) const;
  // Each twerper that failed, named once among the problems.
  void say(const TwerperFailures&, Asking&) const;

  const CompiledSpan* span(const Node& n, Time t) const;  // null: it never hangs on anything
  // What holds a node, by code or not; what code would have hang on itself is free.
  CompiledSpan held(std::uint32_t node, Time t, Asking&) const;
  CompiledSpan said_to_hold(std::uint32_t node, Time t, Asking&) const;  // round in a circle, too
  bool one_body(std::uint32_t node, std::uint32_t parent) const;
  // Of its environments. `own`: a set of all of them that is at that time's tick, of whoever asks for many.
  Mat4 product(std::int32_t siting, Time t, const EnvironmentSet* own = nullptr) const;
  Mat4 matrix(const Site&, Time t) const;  // A
  // `drive`: the product of the environments that drive it, where that is known.
  std::optional<Mat4> driven(const Node&, Time t, Asking&, const Mat4* drive = nullptr) const;
  std::optional<Mat4> moved(const Node&, Time t) const;
  // Of one, evaluating only what it follows from; not `turned`: only where it is counts.
  Sited placement(std::uint32_t node, Time t, Asking&, bool turned = true) const;
  Vec3 place(std::uint32_t node, Time t, Asking&) const;  // in the world
  double place(std::uint32_t node, Time t, Asking&, int component) const;
  Carrier carried(const Node&, Time t, Asking&) const;
  // At a share of the length of the line that an object is, in the world; none: there is no such line.
  std::optional<MeasuredLine::Place> on_line(ObjectId road, double share, Time t, Asking&) const;
  Result<Vec3> place_on(std::string_view road, double share, double seconds, Asking&) const;
  // The same as the value of an object's position or rotation; where there is none, why is among the problems.
  std::optional<Value> along(std::uint32_t object, FunctionId, ObjectId road, double share, Time t, Asking&) const;
  // In the world, with its front in that direction.
  Quat turned(const Node&, Vec3 direction, Time t, Asking&) const;
  std::vector<std::uint32_t> goals(std::uint32_t object, FunctionId) const;
  void find_joints();
  // The joints by which a thing reaches, and the rotations that would do the same.
  std::vector<std::pair<ObjectId, Quat>> reached_turns(ObjectId hand, Time, Asking&) const;
  // The numbers for the time; null: they are worked out.
  // A function's value as a shape takes it; points on their way are between two of the author's.
  Value shape_part(const Binding& b, Time t, const double* numbers, Asking&) const;
  Shape shape(std::uint32_t object, Time t, const double* numbers, Asking&) const;
  // `place`: of a node, in the world.
  std::optional<Vec3> aim(std::uint32_t object, FunctionId, Time t, const double* numbers,
                          const std::function<Vec3(std::uint32_t)>& place, Asking&) const;
  const StepTrack& steps_of(const Binding& b) const { return *steps[static_cast<std::size_t>(b.steps)]; }
  Between between(const Binding& b, Time t) const { return steps_of(b).at(t, set); }
  Value value(const Binding& b, Time t, Asking&) const;  // the one that holds at t; of points those on their way
  void thaw(std::int32_t frozen, Asking&) const;

  // What contacts are worked out from: items without their looks, and the camera, if the film has one.
  Frame solids(Time t, Asking&) const;
  std::shared_ptr<const Contacts> contacts(Time t, Asking&) const;
  std::optional<std::uint32_t> camera_at(Time t) const;  // the object looked through; none: the film has none

  Extent stage() const;
  // The camera of documents that have none: sees all that is ever seen, from in front and a little above.
  // That of a flat film, which sees what it sees: 9 m high, along -z.
  const Camera& own_camera() const;
  bool sees_all(Time t) const;  // the camera does
  // A film without cameras shows all that is ever seen: what that is may take long to say.
  bool asks_for_camera() const { return !first_camera && !(lives.empty() && slow_shapes.empty()); }
  mutable std::once_flag own_camera_once;
  mutable Camera own_camera_made;

  // Of a trace: its points, in its own space. Whether any is still being drawn.
  Points trace(std::uint32_t object, Time t, Asking&) const;
  bool tracing_at(Time t) const;
  Tracer& tracer(std::uint32_t object) const;
  mutable std::recursive_mutex tracing;  // while lines are drawn: a trace may go along a trace
  mutable std::mutex tracers_in_use;
  mutable std::map<std::uint32_t, std::shared_ptr<Tracer>> tracers;  // by object
  bool traces = false;                                               // there are some

  // Evaluations at rest, for whoever asks for whole frames.
  mutable std::mutex idle_in_use;
  mutable std::vector<std::unique_ptr<Whole>> idle;
};

// The numbers that the array holds for a value: colours are linear light, angles orientations where `orientation`. And
// the value of such numbers, as the author writes it.
int held_numbers(const Value&, bool orientation, double* out);
Value written_value(Type, const double* numbers, bool orientation);
// a + w b, or the way from a to b; orientations turn. Nothing where the two do not go together.
std::optional<Value> laid_over(const Value& a, const Value& b, double w, bool mix);
// A procedure's answer as a value of the type; the reason if it is none.
Result<Value> fit(const Value&, Type, const Scene&);
Vec3 to_angles(Quat);

// Of a drawable whose mesh has a rig that something moves; none otherwise.
std::optional<Skin> compile_skin(const Program::Compiled&, std::uint32_t drawable);

// The motions of all nodes. Their centres, and what attachments keep, are not known before settle().
void compile_motions(Program::Compiled&);
// `frozen`: by time, those that are let go or kept.
void settle(Program::Compiled&, const std::vector<std::int32_t>& frozen);

inline Vec3 vec3(const double* n) { return {n[0], n[1], n[2]}; }

}  // namespace betwixt
