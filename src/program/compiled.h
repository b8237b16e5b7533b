// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The result of compiling a document. Every display function in use has a place in one array of numbers. Constants are
// stored there by the compiler; curves write their values for the requested time. Other values (texts, shapes, names)
// are looked up when needed.
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
struct Question;
class DeferredEvaluation;
class Tracer;

// Where the value of a display function of an object comes from.
struct Binding {
  FunctionId function = 0;
  std::uint8_t channels = 0;  // numbers; 0 for a value without numbers
  bool orientation = false;   // a rotation held as a quaternion
  std::uint32_t offset = 0;   // index of the first number
  std::uint32_t first_curve = 0, curves = 0;
  std::int32_t steps = -1;  // index of its step track, for a value without numbers …
  Value constant;           // … or the constant value
  std::int32_t live = -1;   // index into Compiled::lives, for a value from several tracks or from code
  std::int32_t coded = -1;  // index into Schedule::coded, for tracks with twerpers written in code
  bool varies() const { return curves > 0 || steps >= 0 || live >= 0; }
};

struct CurveUse {
  Curve curve;
  std::uint32_t offset = 0;
  bool bounded = false;  // clamp a curve that overshoots the function's range
  double low = 0, high = 0;
  bool coded = false;  // has twerpers written in code
  void bound(double* numbers) const {
    if (bounded)
      for (int i = 0; i < curve.channels; ++i) numbers[i] = std::clamp(numbers[i], low, high);
  }
};

// A piece of time of a track with a velocity track: either the primary track or a velocity is in force.
struct Piece {
  Time from;
  bool scripted = false;  // the primary track contains procedures
  Curve primary;          // count 0: the value at rest
  std::int32_t reign = -1;
};

// A track of a function's value or component, and the properties that make it live.
struct LivePart {
  int component = -1;
  Type type = Type::scalar;
  bool orientation = false, srgb_numbers = false;
  std::vector<Piece> pieces;  // by time; empty if scripted
  Track track;                // scripted: some events are procedures
  Value rest;
  // A colour's component blends as light; its values are numbers.
  Type value_type() const { return component >= 0 && row_of(type).light ? Type::scalar : type; }
  std::size_t piece_at(Time) const;  // requires pieces
};

struct LiveStrand {
  ObjectId layer;
  bool mix = false;
  std::int32_t plain = -1;  // if the whole strand is a plain binding: index into Compiled::plains
  Value set;
  Time from{INT64_MIN};  // on a layer: the time of its first value
  std::vector<LivePart> parts;
  std::vector<Filter> filters;
};

// A function's value that is not one plain track: velocities, procedures, filters, layers.
struct Live {
  std::uint32_t object = 0;
  FunctionId function = 0;
  std::vector<LiveStrand> strands;  // the object's own first, then the layers'
};

// A value to evaluate: of a live, or of one of its components, at a time.
struct Sought {
  std::int32_t live = 0;
  int component = -1;
  std::int64_t time = 0;
  friend auto operator<=>(const Sought&, const Sought&) = default;
};

// The state of one evaluation. It caches the values found on the way, except those that depend on a cut cycle.
struct Asking {
  struct Taken {  // the cost and the inputs of an answer
    std::uint64_t cost = 0;
    std::vector<Sought> asked;  // itself and all values it read; the answer may differ while one of these is open
  };
  template <class T>
  struct Found {
    T value;
    Taken taken;
  };
  std::vector<Sought> open;    // being evaluated, outermost first
  std::vector<Sought> asked;   // read by the open ones up to now
  std::size_t cut = SIZE_MAX;  // depth in `open` of the outermost value that a cut cycle reached
  std::map<Sought, Found<Value>> found;
  std::map<std::int64_t, Found<std::shared_ptr<const Contacts>>> found_contacts;
  std::uint64_t cost = 0;   // in steps
  std::uint64_t begun = 0;  // the cost when the outermost question began …
  bool given_up = false;    // … and whether it has exceeded its limit: then it has no answer
  // The limit for the whole evaluation; a caller that lowers it discards an answer that exceeds it.
  std::uint64_t most = UINT64_MAX;
  bool in_haste() const { return most < UINT64_MAX; }
  std::vector<std::string> problems;
  std::vector<Frame::CodeError> errors;
  std::vector<Target> read;  // values that procedures have read
  const DeferredEvaluation* deferred =
      nullptr;  // has the answers of the outermost questions; null to compute them here

  // The limit of work for one question: steps of procedures, inputs of filters, nested questions. The count ignores the
  // cache, so it does not depend on earlier questions.
  static constexpr std::uint64_t most_work = 10'000'000;
  // The limit for all questions of one frame together.
  static constexpr std::uint64_t most_of_a_frame = 50'000'000;
  // Adds to the cost. Returns true if a limit is exceeded, now or earlier.
  bool work(std::uint64_t steps) {
    cost += steps;
    given_up = given_up || cost - begun > most_work || cost > most;
    if (given_up) cut = 0;  // caches no value from here on
    return given_up;
  }

  // Whether an answer from `deferred` counts, and which; null before the first one.
  struct Deferred {
    bool yes = false;
    const Answer* answer = nullptr;
  };
  Deferred deferred_answer(const Question&, Time) const;
  void say(std::string problem);
  void err(std::string problem, const std::string& source);  // an error in the author's code
  void say_all(const Answer&);                               // reports its problems and errors
  bool is_open(const Taken&) const;                          // one of the values it read is still open
  void take(const Taken&);                                   // adds its cost and inputs to the present question
};

// An evaluation in progress: measures its cost and inputs.
class Working {
 public:
  explicit Working(Asking&);
  // Ends the evaluation. Returns nullopt if the answer must not be cached, because a cycle through an outer value was
  // cut.
  std::optional<Asking::Taken> done();

 private:
  Asking& asking_;
  std::uint64_t before_;
  std::size_t depth_, outer_cut_;
  std::ptrdiff_t first_;
};

// The transform of a node inside its environments, and the rotation that children inherit if they do not inherit scale.
struct Placed {
  Mat4 world;
  Quat turn;
};
// The same, with the product of those environments.
struct Sited : Placed {
  Mat4 around;
  Mat4 in_world() const { return around * world; }
};

// An attachment, in force from a time on.
struct CompiledSpan {
  Time from;
  AttachmentKind kind = AttachmentKind::detach;
  std::int32_t parent = -1;  // a node
  std::int32_t frozen = -1;  // index of the transforms kept by letgo or keep-world
  bool one_body = false;     // with the parent
  bool computed = false;     // computed by code: see Compiled::held
};
struct Frozen {
  std::uint32_t node = 0;
  std::int32_t span = 0;  // index among the node's spans
  enum { asleep, busy, done } state = asleep;
  Mat4 before;  // applied after the object's own transform, before the parent's
  Quat before_turn;
  Mat4 turn3, parent;  // letgo: the matrix B and the parent's matrix at that time
  Mat4 around;         // letgo: the parent's environments
  Quat parent_turn;
  Vec3 attach;
  bool held = false;  // letgo: the object had a parent
};

// Maps an object's position p to the world: above (kept p + attach). Also holds the inherited rotation.
struct Carrier {
  Mat4 above, kept;
  Vec3 attach;
  Quat turn;
  std::optional<Vec3> seen(Vec3 in_world) const;  // converts to a position; nullopt if a matrix is singular
};

// The motions of one object, in sequence: each begins where the ones before it end.
struct Moving {
  struct Piece {
    Time from, until;
    Motion motion;      // centres are in the space of positions
    Mat4 before;        // product of all earlier pieces, completed
    Curve progress;     // the fraction done
    bool open = false;  // has no end, and no effect
  };
  struct Place {
    const Piece* piece = nullptr;
    Time time;  // the one that the asked time repeats
    Extrapolation how = Extrapolation::hold;
  };
  std::optional<Place> place(Time) const;  // nullopt before the first piece
  std::vector<Piece> pieces;               // by time
  Time first, last;                        // of the track's events
  Extrapolation extend_before = Extrapolation::hold, extend_after = Extrapolation::hold;
  std::size_t placed = 0;  // pieces whose centres are known; all of them after compiling
};

struct Node {
  std::uint32_t object = 0;
  std::uint32_t first_span = 0, spans = 0;
  Kind kind = Kind::group;
  bool orientation = false;
  // Offsets into the numbers.
  std::uint32_t position = 0, rotation = 0, scale = 0, pivot = 0, attach = 0, display = 0, color = 0;
  std::int32_t around = -1, drive = -1;  // indices into Compiled::sitings
  std::int32_t moving = -1;              // index into Compiled::movings
  bool transform = false;                // has a transform
  bool looks = false;                    // turned by look-at or roll
  bool bends = false;                    // may be turned by inverse kinematics
  std::uint8_t reaches = 0;              // joints of its inverse-kinematics chain; 0 if it reaches for nothing
};

// A mesh deformed by a skeleton or by morph targets.
struct Skin {
  std::uint32_t drawable = 0;
  std::shared_ptr<const Mesh> rest;
  // Nodes, in the order of its rig; -1 for a joint without object, which stays at rest.
  std::vector<std::int32_t> joints;
  std::vector<const Binding*> weights;  // of its morph targets; null for a weight without value
};

// A node that is drawn, or may be; it has the node's number.
struct Drawable {
  std::uint32_t transparency = 0, shininess = 0, casts = 0;  // offsets into the numbers
  const Binding *material = nullptr, *texture = nullptr, *geometry = nullptr;
  std::uint32_t shape = 0;  // index into Compiled::shapes; beyond its end if the shape varies
  // The material and the texture are constant and are stored below.
  bool plain = false;
  std::int32_t skin = -1;
  std::int32_t slow = -1;   // index into Compiled::slow_shapes
  std::int32_t blend = -1;  // index into Compiled::slow_blends
  Material material_number = Material::plastic;
  std::uint32_t texture_number = 0;
};

// The parts of an object that a value affects.
namespace affects {
// `around`: the product of the node's environments.
enum : std::uint8_t { place = 1, look = 2, form = 4, aim = 8, other = 16, around = 32, all = 63 };
}  // namespace affects

// The schedule of changes. From one time to another, only those sources need evaluation that change at the first time
// or begin to change before the second.
struct Schedule {
  struct Source {
    enum What : std::uint8_t { curve, steps, attachment, motion, siting } what = curve;
    std::uint8_t affects = 0;
    std::uint32_t index = 0;  // into curves, steps, movings or sitings
    std::uint32_t node = 0;
    std::uint32_t first_activity = 0, activities = 0;
  };
  struct LiveSource {
    const Binding* binding = nullptr;
    std::uint8_t affects = 0;
    std::uint32_t node = 0;
    bool solid = false;  // contacts may depend on it
  };
  struct Edge {
    std::int64_t time = 0;
    std::uint32_t source = 0;
  };
  std::vector<Source> sources;
  std::vector<CurveEvents> events;                              // for each source that is a curve
  std::vector<Activity> activities;                             // by source, then time
  std::vector<Edge> begins, ends;                               // of all activities, by time
  std::vector<LiveSource> lives;                                // values that may change at any time
  std::vector<LiveSource> coded;                                // tracks with twerpers written in code
  const Activity* active(const Source&, std::int64_t t) const;  // the activity that continues after t, or null
};

// An environment that encloses an object. The event that names it fixes the generation.
struct Site {
  std::uint32_t environment = 0;
  int generation = 0;
  std::uint32_t member = 0;  // index into Compiled::many
  friend bool operator==(const Site&, const Site&) = default;
};
struct Siting {
  struct Change {
    Time from;
    std::vector<Site> sites;
    friend bool operator==(const Change&, const Change&) = default;
  };
  std::vector<Change> changes;  // by time; the first one holds before it too
};

// The part of each array of Compiled that belongs to one object. It ends where the next object's part begins.
struct ObjectPiece {
  std::uint32_t binding = 0, curve = 0, step = 0, number = 0, source = 0;  // start indices
  bool alone = false;  // independent of other objects, so an edited document can reuse it
  std::shared_ptr<const CurveColumns> columns;
};

struct Program::Compiled {
  explicit Compiled(Document d);
  ~Compiled();

  Document document;
  CurveSet set;
  std::vector<double> rest;  // the array of numbers, with the constants
  std::vector<CurveUse> curves;
  std::vector<std::shared_ptr<const StepTrack>> steps;
  std::vector<Binding> bindings;                    // by object, then function
  std::vector<ObjectPiece> pieces;                  // per object, and one at the end
  std::vector<Binding> defaults;                    // per function, for objects without a value
  std::map<Kind, std::vector<FunctionId>> shaping;  // functions that are part of a shape, for each kind
  std::vector<Binding> plains;                      // for strands of lives
  std::vector<Live> lives;
  std::vector<Reign> reigns;
  std::vector<Node> nodes;  // drawables, then the others, each by object
  std::vector<Drawable> drawables;
  std::vector<Skin> skins;
  std::vector<std::shared_ptr<const Shape>> shapes;  // constant shapes, each once
  std::vector<std::shared_ptr<const Picture>> textures;
  std::vector<std::uint32_t> lights, eyes;    // nodes; eyes: those that look at or reach for something
  std::vector<std::uint32_t> borrowers;       // drawables that may take another object's geometry
  std::vector<std::uint32_t> slow_shapes;     // drawables whose shapes may take long to make
  std::vector<std::uint32_t> slow_blends;     // … or the blends between the shapes that they take
  std::optional<std::uint32_t> first_camera;  // an object
  Schedule schedule;
  std::vector<CompiledSpan> spans;          // by node, then time
  std::vector<std::uint32_t> held_by_code;  // nodes that code attaches at some time
  mutable std::vector<Frozen> frozen;       // all done after compiling
  std::vector<std::shared_ptr<const Environment>> environments;
  std::vector<Siting> sitings;
  std::vector<Moving> movings;
  // With many environments, all step from tick to tick together (SIMD). Each evaluator has its own set; queries for
  // single values share this one under a lock. Few environments are evaluated one by one.
  std::optional<EnvironmentSet> mutable many;
  mutable std::mutex many_in_use;
  bool sited = false;                     // some node is in an environment
  bool looks = false;                     // some node is turned by look-at or inverse kinematics
  bool turning = false;                   // some node depends on another's rotation alone
  std::vector<playing::Offsets> offsets;  // per node
  std::vector<std::string> notices;       // attachments that had to be ignored
  std::vector<std::uint32_t> node_of;     // per object

  bool draws(std::uint32_t node) const { return node < drawables.size(); }
  const Binding& find(std::uint32_t object, FunctionId f) const;
  static Material material(const Value&);
  std::uint32_t texture(const Value&) const;  // Look::none if there is no such picture

  // Evaluation of one value or one object; evaluator.h evaluates everything. `numbers` is the array for the time.
  void evaluate(const CurveUse& use, Time t, double* out) const;
  // Evaluates the numbers of one binding.
  void evaluate(const Binding& b, Time t, Asking&, double* out) const;
  void evaluate_curves(const Binding& b, Time t, double* out) const;  // of one that is not live
  // Returns a value in the author's units. With `component`, returns that number alone, if parted() allows; so one
  // component may depend on another.
  Value live_value(std::int32_t live, Time t, Asking&, int component = -1) const;
  bool parted(std::int32_t live, int component) const;
  // Returns the rate of change per second, in the author's units, or nullopt for types without one. The rate is the one
  // after t, or before t with `coming`.
  std::optional<Value> velocity(std::uint32_t object, FunctionId f, Time t, Asking&, bool coming = false) const;
  // Takes the rate from a velocity in force or from the curve. Returns false if neither gives one.
  bool said_velocity(const LivePart&, Time t, bool coming, double* out) const;
  Value read(const Target&, Time t, Asking&) const;
  Value heard(const Target&, Time t, Asking&) const;
  // Reports each failed twerper once.
  void say(const TwerperFailures&, Asking&) const;

  const CompiledSpan* span(const Node& n, Time t) const;  // nullptr if it never hangs on anything
  // Returns what the node hangs on, code included. If code makes it hang on itself, it is free.
  CompiledSpan held(std::uint32_t node, Time t, Asking&) const;
  CompiledSpan said_to_hold(std::uint32_t node, Time t, Asking&) const;  // may be a cycle
  bool one_body(std::uint32_t node, std::uint32_t parent) const;
  // Returns the product of its environments. `own`: the caller's set, already at that tick.
  Mat4 product(std::int32_t siting, Time t, const EnvironmentSet* own = nullptr) const;
  Mat4 matrix(const Site&, Time t) const;  // the environment's matrix A
  // `drive`: the product of the environments that drive it, if known.
  std::optional<Mat4> driven(const Node&, Time t, Asking&, const Mat4* drive = nullptr) const;
  std::optional<Mat4> moved(const Node&, Time t, Asking&) const;
  // Returns the transform of one node, and evaluates only what it depends on. Without `turned`, only the position is
  // exact.
  Sited placement(std::uint32_t node, Time t, Asking&, bool turned = true) const;
  Vec3 place(std::uint32_t node, Time t, Asking&) const;  // in world space
  double place(std::uint32_t node, Time t, Asking&, int component) const;
  Carrier carried(const Node&, Time t, Asking&) const;
  // Returns the point at a fraction of the length of an object's line, in world space, or nullopt if there is no line.
  std::optional<MeasuredLine::Place> on_line(ObjectId road, double share, Time t, Asking&) const;
  Result<Vec3> place_on(std::string_view road, double share, double seconds, Asking&) const;
  // Returns that point as the value of an object's position or rotation. Returns nullopt and reports the reason if
  // there is none.
  std::optional<Value> along(std::uint32_t object, FunctionId, ObjectId road, double share, Time t, Asking&) const;
  // Returns the world rotation that points its front in that direction.
  Quat turned(const Node&, Vec3 direction, Time t, Asking&) const;
  std::vector<std::uint32_t> goals(std::uint32_t object, FunctionId) const;
  void find_joints();
  // Returns the joints of an inverse-kinematics chain, with the rotations that give the same pose.
  std::vector<std::pair<ObjectId, Quat>> reached_turns(ObjectId hand, Time, Asking&) const;
  // Returns a function's value as a shape uses it. Points in transition lie between two of the author's. `numbers`: the
  // array for the time, or null to evaluate.
  Value shape_part(const Binding& b, Time t, const double* numbers, Asking&) const;
  Shape shape(std::uint32_t object, Time t, const double* numbers, Asking&) const;
  // `place`: returns a node's world position.
  std::optional<Vec3> aim(std::uint32_t object, FunctionId, Time t, const double* numbers,
                          const std::function<Vec3(std::uint32_t)>& place, Asking&) const;
  const StepTrack& steps_of(const Binding& b) const { return *steps[static_cast<std::size_t>(b.steps)]; }
  Between between(const Binding& b, Time t, Asking&) const;
  // Returns the shape that the drawable has by itself.
  std::shared_ptr<const Shape> drawn_shape(std::uint32_t drawable, Time t, Asking&) const;
  // Returns the deformed mesh of a skin.
  std::shared_ptr<const Mesh> posed(std::int32_t skin, Time t, Asking&) const;
  // Returns true if a track with coded twerpers runs one of them at t.
  bool runs_code(const Schedule::LiveSource& coded, Time t) const;
  Value value(const Binding& b, Time t, Asking&) const;  // at t; points may be in transition
  void thaw(std::int32_t frozen, Asking&) const;

  // Returns the input of contacts: items without their looks, and the film's camera, if any.
  Frame solids(Time t, Asking&) const;
  std::shared_ptr<const Contacts> contacts(Time t, Asking&) const;
  std::optional<std::uint32_t> camera_at(Time t) const;  // the active camera object; nullopt if the film has none

  Extent stage() const;
  // Returns the camera of a film without cameras. It sees everything that ever appears, from in front and a little
  // above. In a flat film it looks along -z and is 9 m high.
  const Camera& own_camera() const;
  bool sees_all(Time t) const;  // the camera sees everything
  // Returns true if anything in a frame may take long.
  bool may_take_long() const {
    return !lives.empty() || !schedule.coded.empty() || !slow_shapes.empty() || !slow_blends.empty();
  }
  // Returns true if the default camera may take long: it must see everything that ever appears.
  bool asks_for_camera() const { return !first_camera && may_take_long(); }
  mutable std::once_flag own_camera_once;
  mutable Camera own_camera_made;

  // The points of a trace, in its own space, and whether a trace is still being drawn at a time.
  Points trace(std::uint32_t object, Time t, Asking&) const;
  bool tracing_at(Time t) const;
  Tracer& tracer(std::uint32_t object) const;
  mutable std::recursive_mutex tracing;  // held while lines are drawn; recursive, as a trace may follow a trace
  mutable std::mutex tracers_in_use;
  mutable std::map<std::uint32_t, std::shared_ptr<Tracer>> tracers;  // by object
  bool traces = false;                                               // the film has traces

  // Unused evaluations, for requests of whole frames.
  mutable std::mutex idle_in_use;
  mutable std::vector<std::unique_ptr<Whole>> idle;
};

// Converts between values and the numbers in the array. In the array, colours are linear light, and angles are
// quaternions if `orientation`.
int held_numbers(const Value&, bool orientation, double* out);
Value written_value(Type, const double* numbers, bool orientation);
// Returns a + w b, or the blend from a to b if `mix`; orientations turn. Returns nullopt for incompatible types.
std::optional<Value> laid_over(const Value& a, const Value& b, double w, bool mix);
// Converts a procedure's result to the type. Returns an error if it does not fit.
Result<Value> fit(const Value&, Type, const Scene&);
Vec3 to_angles(Quat);

// Returns the skin of a drawable whose mesh has an animated rig, or nullopt.
std::optional<Skin> compile_skin(const Program::Compiled&, std::uint32_t drawable);

// Compiles the motions of all nodes. settle() later fills in their centres and the transforms that attachments keep.
void compile_motions(Program::Compiled&);
// `frozen`: indices of let-go and kept attachments, by time.
void settle(Program::Compiled&, const std::vector<std::int32_t>& frozen);

inline Vec3 vec3(const double* n) { return {n[0], n[1], n[2]}; }

}  // namespace betwixt
