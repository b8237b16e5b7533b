// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the public headers for reading: they alone are enough to list a whole document, which must equal its script.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "betwixt/environment.h"
#include "betwixt/language.h"
#include "betwixt/object.h"
#include "betwixt/pose.h"
#include "betwixt/track.h"
#include "language/values.h"

namespace betwixt {
namespace {

// Writes what it is told of a document, frames for times.
struct Lister {
  const Document& d;
  std::ostringstream out{};

  std::string time(Time t) const {
    return t == earliest_time ? "beginning" : t == latest_time ? "end" : format_time(t, d);
  }
  std::string value(const Value& v) const {
    std::ostringstream o;
    const auto three = [&](Vec3 p) { o << '(' << p.x << ' ' << p.y << ' ' << p.z << ')'; };
    if (const auto* n = std::get_if<double>(&v)) o << *n;
    if (const auto* p = std::get_if<Vec3>(&v)) three(*p);
    if (const auto* c = std::get_if<Color>(&v)) o << "rgb", three({c->r, c->g, c->b});
    if (const auto* b = std::get_if<bool>(&v)) o << (*b ? "on" : "off");
    if (const auto* a = std::get_if<Angles>(&v)) o << "turns", three(1 / (2 * pi) * a->xyz);
    if (const auto* q = std::get_if<Quat>(&v)) o << "quat " << q->w << ' ', three({q->x, q->y, q->z});
    if (const auto* id = std::get_if<ObjectId>(&v)) o << d.name(*id);
    if (const auto* t = std::get_if<Text>(&v)) o << '"' << **t << '"';
    if (const auto* all = std::get_if<Points>(&v))
      for (const Vec3& p : **all) three(p);
    if (const auto* names = std::get_if<Names>(&v))
      for (const auto& n : **names) o << '<' << n << '>';
    if (const auto* a = std::get_if<Attachment>(&v)) o << attachment(a->kind) << ' ' << d.name(a->parent);
    if (const auto* p = std::get_if<Procedure>(&v)) o << procedure(*p).language << ' ' << procedure(*p).source;
    if (const auto* m = std::get_if<Matrix>(&v)) three(translation_of(**m));
    if (const auto* m = std::get_if<Moves>(&v)) o << ((*m)->factors.empty() ? "still" : to_string(**m));
    return o.str();
  }
  static std::string_view attachment(AttachmentKind h) {
    static constexpr std::string_view words[] = {"detach", "letgo", "hang", "attach", "couple"};
    return words[static_cast<std::size_t>(h)];
  }

  void track(const TrackView& t) {
    out << "  " << d.name(t.target);
    if (t.target.layer) out << " on " << d.name(t.target.layer);
    out << ": " << t.event_count << " events";
    if (t.event_count > 0) out << ' ' << time(t.first) << ".." << time(t.last);
    if (!t.twerper.empty()) out << ", all " << t.twerper;
    out << ", else " << t.default_twerper << ", " << t.extrapolation_before << ' ' << t.extrapolation_after
        << (t.srgb ? ", srgb" : "") << '\n';
    for (const EventView& e : events(d, t.target)) event(e);
  }
  void event(const EventView& e) {
    out << "    " << time(e.time) << ' ';
    if (e.cut_from) out << value(*e.cut_from) << " cut ";
    out << (e.what == EventView::What::keep      ? "keep"
            : e.what == EventView::What::release ? "release"
                                                 : value(*e.value));
    if (!e.twerper.empty()) out << ' ' << e.twerper;
    if (e.twerper == "bezier")
      for (const double x : e.arguments) out << ' ' << x;
    if (e.ease_out != Time{}) out << " out " << e.ease_out.seconds();
    if (e.ease_in != Time{}) out << " in " << e.ease_in.seconds();
    if (e.tangent_in) out << " arrives " << value(*e.tangent_in);
    if (e.tangent_out) out << " leaves " << value(*e.tangent_out);
    out << '\n';
  }
  void object(ObjectId id) {
    out << d.name(id) << ", " << name_of(kind(d, id)) << '\n';
    for (const FunctionView& f : functions(d, id)) {
      if (f.set) out << "  " << f.name << " set " << value(*f.set) << '\n';
      for (const FilterView& filter : filters(d, {id, f.id})) {
        out << "  " << f.name << " filter " << filter.name << (filter.custom ? " (own)" : "");
        if (filter.component >= 0) out << " of " << f.components[static_cast<std::size_t>(filter.component)];
        for (const auto& [key, v] : filter.parameters) out << ' ' << key << '=' << value(v);
        if (filter.segment) out << ' ' << time(filter.segment->first) << ".." << time(filter.segment->second);
        out << '\n';
      }
    }
    for (const TrackView& t : tracks(d, id)) track(t);
    for (const AttachmentSpan& a : attachments(d, id))
      out << "  " << time(a.from) << ".." << time(a.until) << ' ' << value(a.to)
          << (a.to.keep_world ? " kept\n" : "\n");
    const auto spans = [&](const char* what, const std::vector<EnvironmentSpan>& all) {
      for (const EnvironmentSpan& s : all) {
        out << "  " << time(s.from) << ".." << time(s.until) << ' ' << what;
        for (const ObjectId e : s.environments) out << ' ' << d.name(e);
        out << '\n';
      }
    };
    each_environment_event(d, id, [&](const EnvironmentEventView& e) {
      out << "  " << e.tick << "t " << e.what;
      if (e.motion) out << " every " << e.interval << "t by " << (*e.motion)(0, 0) << ' ' << (*e.motion)(0, 3);
      if (e.change != 0) out << ", " << e.change << "t per " << e.period << "t up to " << e.ceiling << 't';
      if (e.from) out << " from " << *e.from << 't';
      if (e.until) out << " until " << *e.until << 't';
      out << (e.keep_phase ? " in phase\n" : "\n");
    });
    spans("in", surrounding(d, id)), spans("driven by", driving(d, id));
  }
  std::string all() {
    out << d.rate().num << '/' << d.rate().den << " frames, " << d.ticks().num << '/' << d.ticks().den << " ticks\n";
    for (const auto& [word, meant] : d.aliases()) {
      out << "alias " << word << ':';
      for (const ObjectId id : objects(d, word)) out << ' ' << d.name(id);
      out << " (" << meant.size() << " patterns)\n";
    }
    for (const Note& n : d.notes(earliest_time, latest_time)) out << "note " << time(n.time) << ' ' << n.text << '\n';
    for (const auto& [t, eye] : d.cuts()) out << "cut " << time(t) << ' ' << d.name(eye) << '\n';
    for (const ProcedureView& p : procedures(d))
      if (p.language != "plug-in")  // those of other tests are in every document made after them
        out << "procedure " << p.name << ' ' << p.role << ' ' << p.language << ": " << p.source << '\n';
    for (const LayerView& l : layers(d))
      out << "layer " << d.name(l.id) << ' ' << l.mode << ", " << d.name(l.weight) << ", " << tracks_on(d, l.id).size()
          << " tracks\n";
    for (const ObjectId id : objects(d)) object(id);
    return out.str();
  }
};

constexpr std::string_view script = R"(rate 24
ticks 30
procedure tick twerper lua "u * u"
procedure loud filter lua "input() * gain"
create ground plane size=(10 10)
create hand group position=(0 2 0)
create ball sphere radius=0.5 color=rgb(1 0.5 0)
create spot light
create near camera lens=50
create far camera
alias props = ball hand
ball.position
  1f  (0 0 0) ease-out=12f
  25f (4 8 -2) cut (5 8 -2) bezier(0.1 0.2 0.3 1) ease-in=6f
  49f (0 0 0) hermite tangent=(1 0 0)
  61f keep linear
  73f (1 1 1) tick
extend ball.position cycle after
ball.scale.y
  1f 1 tick
  13f 2
ball.rotation
  1f  euler(0 0 0)
  25f euler(0 360deg 0) linear
hand.rotation
  1f axis(0 1 0, 90deg)
twerper hand.rotation squad
ball.color
  1f rgb(1 0 0)
twerper ball.color linear in=srgb
at 1f  ball.transparency.velocity 0.1
at 25f ball.transparency.velocity release
at 10f ball.display off
set ball.shininess = "t / 10"
filter ball.position smooth width=0.25s
filter ball.position loud gain=2 1f..24f
filter ball.scale.x noise seed=7
layer sway add weight=0.5
layer take mix
on sway ball.position
  1f  (0 0 0)
  24f (0 1 0)
on take at 12f ball.scale.y 3
couple ball to hand
at 24f letgo ball
at 48f attach ball to hand keep-world
animate spin every 1t by scale(0.5)
animate swing every 2t by translate(1.5 0 0)
at 90t animate swing every 4t by scale(2) slower 1t per 10t from 5t until 50t keep-phase
at 120t halt swing
set hand.environments (swing spin)
at 60t hand.environments (spin)
set hand.drive (swing)
hand.motion
  1f..48f T(6 0) R(-1turn @ ball)
near.look-at
  1f ball
  9f (0 0 1)
at 24f note "half way"
look through near
at 30f look through far
)";

constexpr std::string_view listed = R"(24/1 frames, 30/1 ticks
alias props: ball hand (2 patterns)
note 24f half way
cut beginning near
cut 30f far
procedure tick twerper lua: u * u
procedure loud filter lua: input() * gain
layer sway add, sway.weight, 1 tracks
layer take mix, take.weight, 1 tracks
ground, plane
  size set (10 10 0)
hand, group
  position set (0 2 0)
  environments set <swing><spin>
  drive set <swing>
  hand.rotation: 1 events 1f..1f, all squad, else slerp, hold hold
    1f quat 0.707107 (0 0.707107 0)
  hand.environments: 1 events 49f..49f, else hold, hold hold
    49f <spin>
  hand.motion: 2 events 1f..48f, else linear, hold hold
    1f T(6 0) R(-1turn @ ball)
    48f still
  beginning..49f in swing spin
  49f..end in spin
  beginning..end driven by swing
ball, sphere
  position filter smooth width=0.25
  position filter loud (own) gain=2 1f..24f
  scale filter noise of x seed=7
  color set rgb(1 0.5 0)
  shininess set lua t / 10
  radius set 0.5
  attachment set couple hand
  ball.position: 5 events 1f..73f, else smooth, hold cycle
    1f (0 0 0) out 0.5
    25f (4 8 -2) cut (5 8 -2) bezier 0.1 0.2 0.3 1 in 0.25
    49f (0 0 0) hermite arrives (1 0 0) leaves (1 0 0)
    61f keep linear
    73f (1 1 1) tick
  ball.position on sway: 2 events 1f..24f, else smooth, hold hold
    1f (0 0 0)
    24f (0 1 0)
  ball.rotation: 2 events 1f..25f, else smooth, hold hold
    1f turns(0 0 0)
    25f turns(0 1 0) linear
  ball.scale.y: 2 events 1f..13f, else smooth, hold hold
    1f 1 tick
    13f 2
  ball.scale.y on take: 1 events 12f..12f, else smooth, hold hold
    12f 3
  ball.color: 1 events 1f..1f, all linear, else linear, hold hold, srgb
    1f rgb(1 0 0)
  ball.transparency.velocity: 2 events 1f..25f, else smooth, hold hold
    1f 0.1
    25f release
  ball.display: 1 events 10f..10f, else hold, hold hold
    10f off
  ball.attachment: 2 events 24f..48f, else hold, hold hold
    24f letgo none
    48f attach hand
  beginning..24f couple hand
  24f..48f letgo none
  48f..end attach hand kept
spot, light
near, camera
  lens set 50
  near.look-at: 2 events 1f..9f, else hold, hold hold
    1f ball
    9f (0 0 1)
far, camera
sway, layer
  weight set 0.5
  mode set "add"
take, layer
  mode set "mix"
spin, environment
  0t animate every 1t by 0.5 0
swing, environment
  0t animate every 2t by 1 1.5
  90t animate every 4t by 2 0, 1t per 10t up to 30t from 5t until 50t in phase
  120t halt
)";

const Document& film() {
  static const Loaded loaded = load_text(script, "film.bx");
  static const bool fine = [] {
    for (const Diagnostic& d : loaded.diagnostics)
      if (d.severity == Severity::error) ADD_FAILURE() << to_string(d);
    return true;
  }();
  EXPECT_TRUE(fine);
  return loaded.document;
}

TEST(Views, AWholeDocumentIsListed) { EXPECT_EQ(Lister{film()}.all(), listed); }

const FunctionView* find(const std::vector<FunctionView>& all, std::string_view name) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const FunctionView& f) { return f.name == name; });
  return at == all.end() ? nullptr : &*at;
}

TEST(Views, FunctionsSayWhatTheyAre) {
  const Document& d = film();
  const auto ball = functions(d, d.find("ball")), spot = functions(d, d.find("spot"));
  const FunctionView *position = find(ball, "position"), *shines = find(spot, "shines");
  ASSERT_TRUE(position && shines && find(ball, "color"));
  EXPECT_EQ(position->type, Type::vector);
  EXPECT_EQ(position->unit, Unit::metres);
  EXPECT_EQ(position->components, (std::vector<std::string_view>{"x", "y", "z"}));
  EXPECT_EQ(find(ball, "color")->components, (std::vector<std::string_view>{"r", "g", "b"}));
  EXPECT_EQ(*position->rest, Value(Vec3{}));
  EXPECT_EQ(shines->words, "point|sun");
  EXPECT_EQ(find(ball, "shininess")->high, 1);
  EXPECT_EQ(find(functions(d, d.find("near")), "lens")->unit, Unit::millimetres);
  EXPECT_FALSE(find(ball, "lens"));
  EXPECT_FALSE(find(ball, "world"));
  std::string animated;
  for (const FunctionView& f : ball)
    if (f.animated) animated.append(f.name).append(" ");
  EXPECT_EQ(animated, "position rotation scale color shininess transparency display attachment ");
  // The numbers of functions are those of targets.
  for (const FunctionView& f : ball)
    EXPECT_EQ(find_targets("ball." + std::string(f.name), d)->front(), Target(d.find("ball"), f.id));
}

TEST(Views, OfATrackAnyPartIsLookedAt) {
  const Document& d = film();
  const Target position = find_targets("ball.position", d)->front(), scale = find_targets("ball.scale", d)->front();
  std::string seen;
  each_event(d, position, d.rate().frame(25), d.rate().frame(61),
             [&](const EventView& e) { seen += format_time(e.time, d) + " "; });
  EXPECT_EQ(seen, "25f 49f 61f ");
  EXPECT_FALSE(track(d, scale));
  EXPECT_TRUE(events(d, scale).empty());
  EXPECT_EQ(track(d, {scale.object, scale.function, 1})->event_count, 2U);
  EXPECT_FALSE(track(d, {scale.object, scale.function, 2}));
  const auto behind = [&](const Target& t) {
    std::string names;
    for (const TrackView& v : tracks(d, t)) names += d.name(v.target) + " ";
    return names;
  };
  EXPECT_EQ(behind(scale), "ball.scale.y ");
  EXPECT_EQ(behind(position), "ball.position ");
  EXPECT_EQ(behind({position.object, position.function, 1}), "ball.position ");
  EXPECT_EQ(behind({scale.object, scale.function, 1}), "ball.scale.y ");
  EXPECT_EQ(behind({scale.object, scale.function, 0}), "");
  EXPECT_EQ(*value_set(d, find_targets("sway.weight", d)->front()), Value(0.5));
  EXPECT_FALSE(value_set(d, position));
}

TEST(Views, TheNextEventOfALongTrackIsFound) {
  std::string text = "create a box\na.position.x\n";
  for (int i = 0; i < 1000; ++i) text += " " + std::to_string(10 + 3 * i) + "f 1\n";
  const Document d = load_text(text, "a.bx").document;
  const Target x = find_targets("a.position.x", d)->front();
  for (int n = 0; n < 3020; ++n) {
    const int next = n <= 10 ? 10 : 10 + (n - 10 + 2) / 3 * 3, before = 10 + (n - 11) / 3 * 3;
    EXPECT_EQ(next_event(d, x, d.rate().frame(n)), next > 3007 ? std::nullopt : std::optional(d.rate().frame(next)));
    EXPECT_EQ(event_before(d, x, d.rate().frame(n)),
              n <= 10 ? std::nullopt : std::optional(d.rate().frame(std::min(before, 3007))));
  }
  EXPECT_FALSE(next_event(d, {x.object, x.function, 1}, Time{}));
}

TEST(Views, WhatStandsBehindAnEventsTimeIsWritten) {
  for (const std::string said :
       {"(1 2 3) cut (2 2 2) bezier(0.1 0 1 1) ease-in=4f ease-out=2f", "keep linear", "(1 2 3)",
        "(1 2 3) hermite tangent-in=(1 0 0) tangent-out=(0 0.5 0)", "(0 0 0) linear(0 0.25 25% 0.25 75% 1)"}) {
    const Document d = load_text("create a box\na.position\n 1f (0 1 0)\n 9f " + said + "\n", "a.bx").document;
    const Target position = find_targets("a.position", d)->front();
    const Event* e = tracks_of(d.scene(), position).front()->events.find(d.rate().frame(9));
    EXPECT_EQ(write_event(d, position, *e), said);
  }
}

TEST(Views, ViewsStayWhileACopyOfTheirDocumentLives) {
  std::optional<Document> first = load_text("create a box\na.position.x\n 1f 3\n", "a.bx").document;
  const std::vector<EventView> seen = events(*first, find_targets("a.position.x", *first)->front());
  const Document kept = *first;
  first.reset();
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(*seen[0].value, Value(3.0));
}

TEST(Views, WhatIsNotThereIsEmpty) {
  const Document& d = film();
  for (const ObjectId id : {ObjectId{}, ObjectId{1000}}) {
    EXPECT_TRUE(functions(d, id).empty());
    EXPECT_TRUE(tracks(d, id).empty());
    EXPECT_TRUE(tracks_on(d, id).empty());
    EXPECT_TRUE(attachments(d, id).empty());
    EXPECT_TRUE(surrounding(d, id).empty());
    EXPECT_EQ(kind(d, id), Kind::group);
    EXPECT_FALSE(track(d, {id, 0}));
    EXPECT_TRUE(filters(d, {id, 0}).empty());
    EXPECT_EQ(pose(Program::compile(d), id, {}).world, Mat4{});
  }
  EXPECT_FALSE(track(d, {d.find("ball"), Query::world}));
  EXPECT_TRUE(events(d, {d.find("ball"), 5000}).empty());
  EXPECT_TRUE(objects(d, "nobody").empty());
}

void expect_near(const Mat4& a, const Mat4& b, const std::string& where) {
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(a.m[i], b.m[i], 1e-9) << where << ", number " << i;
}

TEST(Views, PosesAreThoseOfTheWorld) {
  const Document& d = film();
  const Program p = Program::compile(d);
  const ObjectId ball = d.find("ball"), hand = d.find("hand");
  for (const double frame : {1.0, 12.0, 24.0, 30.0, 48.0, 60.0}) {
    const Time t = d.rate().frame(frame);
    const std::vector<Pose> all = poses(p, t);
    for (const ObjectId id : objects(d)) {
      const std::string where = d.name(id) + " at " + format_time(t, d);
      const Pose one = pose(p, id, t);
      expect_near(one.world, all[id.index].world, where);
      EXPECT_EQ(one.parent, all[id.index].parent) << where;
      if (kind(d, id) == Kind::layer || kind(d, id) == Kind::environment) continue;
      expect_near(one.world, *std::get<Matrix>(p.read({id, Query::world}, t)), where);
      ASSERT_TRUE(one.local) << where;
      expect_near((one.parent ? all[one.parent.index].world : Mat4{}) * *one.local, one.world, where);
    }
    const AttachmentKind how = frame < 24   ? AttachmentKind::couple
                               : frame < 48 ? AttachmentKind::letgo
                                            : AttachmentKind::attach;
    EXPECT_EQ(all[ball.index].attachment, how);
    EXPECT_EQ(all[ball.index].parent, how == AttachmentKind::letgo ? ObjectId{} : hand);
    EXPECT_EQ(d.name(camera(p, t)), frame < 30 ? "near" : "far");
  }
}

TEST(Views, WhereNothingIsLookedThroughThereIsNoCamera) {
  EXPECT_EQ(camera(Program::compile(load_text("create a box\n", "a.bx").document), {}), ObjectId{});
}

TEST(Views, InAFlattenedParentThereIsNoPlace) {
  const Document d = load_text("create a group scale=(1 0 1)\ncreate b box\ncouple b to a\n", "a.bx").document;
  const Pose b = pose(Program::compile(d), d.find("b"), {});
  EXPECT_EQ(b.parent, d.find("a"));
  EXPECT_FALSE(b.local);
}

}  // namespace
}  // namespace betwixt
