// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The data that a document is compiled to. Every display function in use has a place in one array of numbers. Constants
// are stored there by the compiler; curves write their values for the requested time. Other values (texts, shapes,
// names) are looked up when needed.
#pragma once

#include <algorithm>
#include <map>
#include <optional>

#include "betwixt/evaluation.h"
#include "program/playing.h"
#include "scene/document.h"
#include "scene/materials.h"
#include "scene/rig.h"
#include "track/reign.h"

namespace betwixt {

// Where the value of a display function of an object comes from.
struct Binding {
  FunctionId function = 0;
  std::uint8_t channels = 0;  // numbers; 0 for a value without numbers
  bool orientation = false;   // a rotation held as a quaternion
  std::uint32_t offset = 0;   // index of the first number
  std::uint32_t first_curve = 0, curves = 0;
  std::int32_t steps = -1;  // index of its step track, for a value without numbers …
  Value constant;           // … or the constant value
  std::int32_t live = -1;   // index into CompiledFilm::lives, for a value from several tracks or from code
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
  std::int32_t integral = -1;  // of a velocity that code computes: index into CompiledFilm::integrals
};

// A track of a function's value or component, and the properties that make it live.
struct LivePart {
  int component = -1;
  Type type = Type::scalar;
  bool orientation = false, srgb_numbers = false;
  bool velocity = false;      // its values are rates of change
  std::vector<Piece> pieces;  // by time; empty if scripted
  Track track;                // scripted: some events are procedures
  Value rest;
  Curve plain;  // of numbers with tweens: the track as it is where no tween is in force; count 0: there is none
  // A colour's component blends as light; its values are numbers.
  Type value_type() const { return component >= 0 && row_of(type).light ? Type::scalar : type; }
  std::size_t piece_at(Time) const;  // requires pieces
};

struct LiveStrand {
  ObjectId layer;
  bool mix = false;
  std::int32_t plain = -1;  // if the whole strand is a plain binding: index into CompiledFilm::plains
  Value set;
  Time from{INT64_MIN};  // on a layer: the time of its first value
  std::vector<LivePart> parts;
  std::vector<Filter> filters;
};

// A function's value that is not one plain track: velocities, procedures, filters, layers.
struct Live {
  std::uint32_t object = 0;
  FunctionId function = 0;
  std::int32_t collision = -1;           // of a position with obstacles: index into CompiledFilm::collisions
  std::vector<LiveStrand> strands = {};  // the object's own first, then the layers'
};

// An attachment, in force from a time on.
struct CompiledSpan {
  Time from;
  AttachmentKind kind = AttachmentKind::detach;
  std::int32_t parent = -1;  // a node
  std::int32_t frozen = -1;  // index of the transforms kept by letgo or keep-world
  bool one_body = false;     // with the parent
  bool computed = false;     // computed by code: see held() in placing.h
};
// The transforms that a letgo or keep-world keeps, from the world at its time: see thaw() in placing.h.
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

// The motions of one object, in sequence: each begins where the ones before it end.
struct Moving {
  struct Piece {
    Time from, until;
    Motion motion;                  // centres are in the space of positions
    Mat4 before;                    // product of all earlier pieces, completed
    Curve progress;                 // the fraction done
    bool open = false;              // has no end, and no effect
    bool computed = false;          // by code, when it begins
    std::vector<Problem> problems;  // of that code
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
  std::int32_t around = -1, drive = -1;  // indices into CompiledFilm::sitings
  std::int32_t moving = -1;              // index into CompiledFilm::movings
  bool on_axes = false;                  // axes place it
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

// A part of a formula, which takes what it lacks from the whole.
struct FormulaPiece {
  std::uint32_t whole = 0;  // an object
  Text key;
};

const MaterialRow& material_of(const Value&);

// The bindings of a drawable's functions from `first_of` to `last`.
template <FunctionId first_of, FunctionId last>
struct GivenFunctions {
  static constexpr FunctionId first = first_of;
  static constexpr std::size_t count = last - first_of + 1;
  std::array<const Binding*, count> bound{};  // null if it has its default
  const Binding* at(FunctionId f) const { return bound[static_cast<std::size_t>(f - first)]; }
};
// Those that make a finish.
struct FinishUse : GivenFunctions<fn::metalness, fn::texture_turn> {
  bool colored = false;  // whether it has a colour of its own, in place of the material's
};
// Those that make gradients.
struct GradientUse : GivenFunctions<fn::gradient, fn::stroke_gradient_spread> {};

// The functions that say which picture of a video a drawable shows: offsets into the numbers.
struct VideoUse {
  std::uint32_t at = 0, from = 0, until = 0, speed = 0, loop = 0, time = 0;
  bool timed = false;           // `time` says it alone
  std::optional<double> begin;  // seconds of the film, in place of `at`
};

// A node that is drawn, or may be; it has the node's number.
struct Drawable {
  std::uint32_t transparency = 0, shininess = 0, casts = 0;  // offsets into the numbers
  const Binding *material = nullptr, *texture = nullptr, *geometry = nullptr;
  std::uint32_t shape = 0;  // index into CompiledFilm::shapes; beyond its end if the shape varies
  // The texture is constant, no video, and stored below; so is the material, if `made_of` is not null.
  bool plain = false;
  std::int32_t video = -1;  // index into CompiledFilm::video_uses, if its texture may be a video
  std::int32_t skin = -1;
  std::int32_t slow = -1;   // index into CompiledFilm::slow_shapes
  std::int32_t blend = -1;  // index into CompiledFilm::slow_blends
  const MaterialRow* made_of = nullptr;
  std::int32_t finish = -1;     // index into CompiledFilm::finishes
  std::int32_t gradients = -1;  // index into CompiledFilm::gradients
  std::uint32_t texture_number = 0;
  std::int32_t whole = -1;  // of a part of a formula: the node of the formula
  bool matches = false;     // its text may turn into another one, sign by sign
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
  std::uint32_t member = 0;  // index into CompiledFilm::many
  friend bool operator==(const Site&, const Site&) = default;
};
struct Siting {
  struct Change {
    Time from;
    std::vector<Site> sites;
    friend bool operator==(const Change&, const Change&) = default;
  };
  std::vector<Change> changes;  // by time; the first one holds before it too
  std::int32_t live = -1;       // if code computes the list
};

// The part of each array of Compiled that belongs to one object. It ends where the next object's part begins.
struct ObjectPiece {
  std::uint32_t binding = 0, curve = 0, step = 0, number = 0, source = 0;  // start indices
  bool alone = false;  // independent of other objects, so an edited document can reuse it
  std::shared_ptr<const CurveColumns> columns;
};

// All of it is set by the compiler, and constant from then on.
struct CompiledFilm {
  explicit CompiledFilm(Document d) : document(std::move(d)) {}

  Document document;
  CurveSet set;
  std::vector<double> rest;  // the array of numbers, with the constants
  std::vector<CurveUse> curves;
  std::vector<std::shared_ptr<const StepTrack>> steps;
  std::vector<Binding> bindings;                            // by object, then function
  std::vector<ObjectPiece> pieces;                          // per object, and one at the end
  std::vector<Binding> defaults;                            // per function, for objects without a value
  std::map<Kind, std::vector<FunctionId>> shaping;          // functions that are part of a shape, for each kind
  std::vector<Binding> plains;                              // for strands of lives
  std::vector<std::unique_ptr<NamedProcedure>> integrals;   // of velocities that code computes: see integrals.h
  std::vector<std::unique_ptr<NamedProcedure>> collisions;  // the laws of positions with obstacles: see collisions.h
  std::vector<Live> lives;
  std::uint64_t constant_steps = 0;  // taken to find constant code: see constant_code.h
  std::vector<Reign> reigns;
  std::vector<Node> nodes;  // drawables, then the others, each by object
  std::vector<Drawable> drawables;
  std::vector<Skin> skins;
  std::vector<std::shared_ptr<const Shape>> shapes;  // constant shapes, each once
  std::vector<FinishUse> finishes;
  std::vector<GradientUse> gradients;
  std::vector<std::shared_ptr<const Picture>> textures;
  // The videos follow the pictures, with a number for each of their pictures.
  struct NumberedVideo {
    std::shared_ptr<const Video> video;
    std::uint32_t first = 0;
  };
  std::vector<NumberedVideo> videos;
  std::vector<VideoUse> video_uses;
  std::vector<std::uint32_t> lights, eyes;                   // nodes; eyes: those that look at or reach for something
  std::vector<std::uint32_t> layers;                         // nodes of groups that may be drawn as a whole
  std::map<std::uint32_t, FormulaPiece> pieces_of_formulas;  // by the object of the part
  std::map<std::uint32_t, Text> apart;                       // by the object of a formula: its parts that are objects
  std::vector<std::uint32_t> formula_pieces;                 // drawables that are parts of formulas
  bool matching = false;                                     // some text may turn into another one
  std::vector<std::uint32_t> borrowers;                      // drawables that may take another object's geometry
  std::vector<std::uint32_t> slow_shapes;                    // drawables whose shapes may take long to make
  std::vector<std::uint32_t> slow_blends;                    // … or the blends between the shapes that they take
  std::optional<std::uint32_t> first_camera;                 // an object
  Schedule schedule;
  std::vector<CompiledSpan> spans;          // by node, then time
  std::vector<std::uint32_t> held_by_code;  // nodes that code attaches at some time
  std::vector<std::shared_ptr<const Environment>> environments;
  std::vector<Siting> sitings;
  bool computes_sitings = false;  // code computes some of them
  std::vector<Moving> movings;
  bool sited = false;                     // some node is in an environment
  bool looks = false;                     // some node is turned by look-at or inverse kinematics
  bool turning = false;                   // some node depends on another's rotation alone
  bool traces = false;                    // the film has traces
  std::vector<playing::Offsets> offsets;  // per node
  std::vector<std::string> notices;       // attachments that had to be ignored
  std::vector<std::uint32_t> node_of;     // per object

  // Returns the node of an object, or nullopt for an environment, and for an object that does not exist.
  std::optional<std::uint32_t> node_of_object(ObjectId) const;
  bool draws(std::uint32_t node) const { return node < drawables.size(); }
  const Binding& find(std::uint32_t object, FunctionId f) const;
  // The same, but for a part of a formula what it lacks is that of the whole.
  const Binding& find_shown(std::uint32_t object, FunctionId f) const;
  const StepTrack& steps_of(const Binding& b) const { return *steps[static_cast<std::size_t>(b.steps)]; }
  std::uint32_t texture(const Value&) const;  // Look::none if there is no such picture
  // Returns the video of this name, or null.
  const NumberedVideo* video(const Value&) const;
  // Returns the number of the picture that a use of a video shows.
  std::uint32_t shown(const NumberedVideo&, const VideoUse&, Time, const double* numbers) const;
  // Returns the texture of a number. Errors: those of Video::picture.
  Result<std::shared_ptr<const Picture>> picture(std::uint32_t number) const;
  // Returns what differs for different pictures, without reading any.
  std::pair<const void*, std::uint32_t> picture_key(std::uint32_t number) const;
  void evaluate_curve(const CurveUse& use, Time t, double* out) const;
  void evaluate_curves(const Binding& b, Time t, double* out) const;  // of one that is not live
  // Returns true if one number of a live value can be evaluated alone; so one component may depend on another.
  bool parted(std::int32_t live, int component) const;
  // Returns true if a track with coded twerpers runs one of them at t.
  bool runs_code(const Schedule::LiveSource& coded, Time t) const;
  const CompiledSpan* span(const Node& n, Time t) const;  // nullptr if it never hangs on anything
  // Returns true if an object forms one body with its parent: if the parent is drawn, or if the object's name makes it
  // a part of the parent (car/wheel on car).
  bool one_body(std::uint32_t node, std::uint32_t parent) const;
  // Returns the nodes that an aim may name at any time.
  std::vector<std::uint32_t> goals(std::uint32_t object, FunctionId) const;
  std::optional<std::uint32_t> camera_at(Time t) const;  // the active camera object; nullopt if the film has none
  // The change of cameras that is going on.
  struct Changing {
    std::optional<std::uint32_t> from;  // the camera object of before
    double share = 0;                   // of the change that is done
    ChangeKind kind = ChangeKind::dissolve;
  };
  std::optional<Changing> changing_at(Time t) const;
  bool sees_all(Time t) const { return !document.scene().appearance.flat && !camera_at(t); }  // the camera does
  // Returns true if anything in a frame may take long.
  bool may_take_long() const {
    return !lives.empty() || !schedule.coded.empty() || !slow_shapes.empty() || !slow_blends.empty();
  }
  // Returns true if the default camera may take long: it must see everything that ever appears.
  bool asks_for_camera() const { return !first_camera && may_take_long(); }
};

}  // namespace betwixt
