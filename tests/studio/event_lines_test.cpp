// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/event_lines.h"

#include <filesystem>
#include <random>
#include <set>

#include "betwixt/language.h"
#include "hands.h"
#include "studio/timeline/key_lines.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const std::string film = R"(rate 24
range 1f 100f
create ball sphere
create box box
layer sway add
ball.position
  1f (0 0 0)
  6f (1 0 0)
  12f (2 0 0) linear
  24f (3 0 0)
ball.color
  6f red
  12f blue
box.position
  6f (0 1 0)
  12f (0 2 0)
box.rotation.z
  6f 0
  12f 90deg
on sway ball.position
  6f (0 0 1)
  12f (0 0 2)
)";

struct Events {
  Film at{film};
  std::vector<EventAt> some;
  const Document& d() const { return at.workspace.document(); }
  // "ball.position", 6 12; on a layer: "ball.position", of it.
  Events& add(const std::string& target, std::vector<double> frames, const std::string& layer = "") {
    Target t = find_targets(target, d())->front();
    if (!layer.empty()) t.layer = at.find(layer);
    for (const double f : frames) some.push_back({t, at.frame(f)});
    return *this;
  }
  Time frames(double n) const { return d().rate().span(n); }
};

}  // namespace

class EventLinesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void events_next_to_each_other_move_in_one_line() {
    Events e;
    e.add("ball.position", {12, 6});
    QCOMPARE(move_lines(e.d(), e.some, e.frames(3)), Lines{"move ball.position 6f..12f by 3f"});
  }
  void none_passes_over_another() {
    Events e;
    e.add("ball.position", {1, 12, 24});
    QCOMPARE(move_lines(e.d(), e.some, e.frames(11)),
             (Lines{"move ball.position 12f..24f by 11f", "move ball.position 1f..1f by 11f"}));
    QCOMPARE(move_lines(e.d(), e.some, -e.frames(11)),
             (Lines{"move ball.position 1f..1f by -11f", "move ball.position 12f..24f by -11f"}));
    QVERIFY(e.at.workspace.say(move_lines(e.d(), e.some, e.frames(11))));
    // 1f lands where 12f was; 6f stays.
    std::vector<Time> times;
    for (const EventView& v : events(e.d(), e.some.front().target)) times.push_back(v.time);
    QCOMPARE(times, (std::vector<Time>{e.at.frame(6), e.at.frame(12), e.at.frame(23), e.at.frame(35)}));
  }
  void tracks_that_go_alike_go_together() {
    Events e;
    e.add("ball.position", {6, 12}).add("ball.color", {6, 12}).add("box.position", {6, 12});
    QCOMPARE(move_lines(e.d(), e.some, e.frames(1)),
             (Lines{"move ball.{position,color} 6f..12f by 1f", "move box.position 6f..12f by 1f"}));
    Events f;
    f.add("ball.position", {6}).add("box.position", {6}).add("box.rotation.z", {6}).add("ball.position", {6}, "sway");
    const Lines lines = move_lines(f.d(), f.some, f.frames(0.5));
    QCOMPARE(lines.size(), std::size_t(4));
    QVERIFY(std::ranges::find(lines, "on sway move ball.position 6f..6f by 0.5f") == lines.end());
    QVERIFY(f.at.workspace.say(lines));
  }
  void what_stands_between_others_is_written_anew_when_stretched() {
    Events e;
    e.add("ball.position", {1, 12});
    QCOMPARE(stretch_lines(e.d(), e.some, {e.at.frame(1), e.at.frame(12)}, {e.at.frame(1), e.at.frame(23)}),
             (Lines{"clear ball.position 1f", "clear ball.position 12f", "at 1f ball.position (0 0 0)",
                    "at 23f ball.position (2 0 0) linear"}));
  }
  void what_stands_alone_is_stretched() {
    Events e;
    e.add("ball.position", {1, 6, 12, 24}).add("ball.color", {6, 12});
    QCOMPARE(stretch_lines(e.d(), e.some, {e.at.frame(1), e.at.frame(24)}, {e.at.frame(1), e.at.frame(47)}),
             Lines{"stretch ball.{position,color} 1f..24f by 2"});
    QCOMPARE(stretch_lines(e.d(), e.some, {e.at.frame(1), e.at.frame(24)}, {e.at.frame(-22), e.at.frame(24)}),
             (Lines{"move ball.{position,color} 1f..24f by -23f", "stretch ball.{position,color} -22f..1f by 2"}));
  }
  void all_tracks_are_reversed_about_one_middle() {
    Events e;
    e.add("ball.position", {1, 6, 12, 24}).add("ball.color", {6, 12});
    QCOMPARE(reverse_lines(e.d(), e.some), Lines{"reverse ball.{position,color} 1f..24f"});
  }
  void what_is_copied_keeps_its_distances() {
    Events e;
    e.add("ball.position", {6, 12});
    QCOMPARE(copy_lines(e.d(), e.d(), e.some, e.at.frame(30)), Lines{"copy ball.position 6f..12f to 30f"});
    QCOMPARE(copy_lines(e.d(), e.d(), e.some, e.at.frame(30), e.at.find("box")),
             Lines{"copy ball.position 6f..12f to 30f on box.position"});
    Events apart;
    apart.add("ball.position", {1, 12});
    QCOMPARE(copy_lines(apart.d(), apart.d(), apart.some, apart.at.frame(30)),
             (Lines{"at 30f ball.position (0 0 0)", "at 41f ball.position (2 0 0) linear"}));
  }
  void what_is_gone_is_written_where_it_is_put_in() {
    Events e;
    e.add("ball.position", {6, 12});
    const Document before = e.d();
    QVERIFY(e.at.workspace.say(clear_lines(e.d(), e.some)));
    QCOMPARE(e.at.said, Lines{"clear ball.position 6f..12f"});
    QCOMPARE(copy_lines(e.d(), before, e.some, e.at.frame(6)),
             (Lines{"at 6f ball.position (1 0 0)", "at 12f ball.position (2 0 0) linear"}));
  }
  void twerpers_stand_behind_values() {
    Events e;
    e.add("ball.position", {6, 12}).add("ball.position", {6}, "sway");
    QCOMPARE(twerper_lines(e.d(), e.some, "linear"),
             (Lines{"at 6f ball.position (1 0 0) linear", "on sway at 6f ball.position (0 0 1) linear"}));
    QCOMPARE(twerper_lines(e.d(), e.some, ""), Lines{"at 12f ball.position (2 0 0)"});
    for (const char* name : {"steps", "bezier", "hermite", "bounce-out"})
      QVERIFY(e.at.workspace.say(twerper_lines(e.d(), e.some, name)));
  }
  void an_event_that_is_put_in_has_its_tracks_own_value() {
    Events e;
    e.add("ball.position", {18}).add("ball.position", {9}, "sway").add("box.rotation.z", {9});
    // Half way, linear, of 2 and 3; without what the layer adds.
    QCOMPARE(insert_lines(e.d(), e.at.workspace.program(), {e.some[0].target}, e.at.frame(18)),
             Lines{"at 18f ball.position (2.5 0 0) linear"});
    QCOMPARE(insert_lines(e.d(), e.at.workspace.program(), {e.some[1].target, e.some[2].target}, e.at.frame(9)),
             (Lines{"on sway at 9f ball.position (0 0 1.5) auto", "at 9f box.rotation.z 45deg auto"}));
  }
  // In all examples, many times: what is done is done, and to nothing else.
  void whatever_is_selected_can_be_done() {
    std::mt19937 dice(16);
    const auto chance = [&](unsigned n) { return dice() % n; };
    int done = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/examples")) {
      if (entry.path().extension() != ".bx") continue;
      Workspace workspace;
      if (!workspace.open(QString::fromStdString(entry.path().string()))) continue;
      const Document& d = workspace.document();
      std::vector<TrackView> all;
      for (const ObjectId id : objects(d))
        for (const TrackView& t : tracks(d, id)) {
          const auto is_velocity = [&](const TrackView& other) { return other.target.velocity; };
          if (t.event_count > 0 && t.event_count < 200 && std::ranges::none_of(tracks(d, id), is_velocity))
            all.push_back(t);
        }
      for (int round = 0; round < 4 && !all.empty(); ++round) {
        std::vector<EventAt> some;
        for (std::size_t k = 0; k < 4; ++k) {
          const TrackView& t = all[chance(static_cast<unsigned>(all.size()))];
          const unsigned of = 1 + chance(3);
          each_event(d, t.target, t.first, t.last, [&](const EventView& e) {
            if (chance(of) == 0) some.push_back({t.target, e.time});
          });
        }
        if (some.empty()) continue;
        // An object of a kind takes over what its model does, so what is done to both is done twice to it.
        if (entry.path().filename() == "parade.bx" && by_track(some).size() > 1) continue;
        const Time by = d.rate().span(static_cast<double>(chance(41)) - 20.5);
        QVERIFY2(workspace.look_ahead(move_lines(d, some, by)), entry.path().c_str());
        workspace.look_back();
        const Document before = d;
        const auto same_times = [&](const std::function<Time(Time)>& when, const char* what) {
          for (const Picked& p : by_track(some)) {
            std::set<Time> expected, is;
            for (const EventView& e : events(before, p.target))
              if (std::ranges::find(p.times, e.time) == p.times.end()) expected.insert(e.time);
            for (const Time t : p.times) expected.insert(when(t));
            for (const EventView& e : events(d, p.target)) is.insert(e.time);
            QVERIFY2(is == expected, (entry.path().string() + ": " + what + " " + before.name(p.target)).c_str());
          }
        };
        const bool motion =
            std::ranges::any_of(some, [&](const EventAt& e) { return d.name(e.target).ends_with(".motion"); });
        if (motion) continue;  // the ends of motions come and go with them
        QVERIFY(workspace.look_ahead(move_lines(before, some, by)));
        same_times([&](Time t) { return t + by; }, "move");
        workspace.look_back();
        const auto [first, last] = span(some);
        if (first < last) {
          const auto to = std::pair(first - by, last + (last - first));
          const Lines lines = stretch_lines(before, some, {first, last}, to);
          const double k = (to.second - to.first).seconds() / (last - first).seconds();
          if (k > 0.1) {
            QVERIFY2(workspace.look_ahead(lines), (entry.path().string() + " " + lines.front()).c_str());
            same_times([&, a = first](
                           Time t) { return to.first + Time{std::llround(static_cast<double>((t - a).flicks) * k)}; },
                       "stretch");
            workspace.look_back();
          }
        }
        for (const Lines& lines :
             {reverse_lines(before, some), clear_lines(before, some), copy_lines(before, before, some, last + by),
              twerper_lines(before, some, "linear")}) {
          if (lines.empty()) continue;
          QVERIFY2(workspace.look_ahead(lines), (entry.path().string() + " " + lines.front()).c_str());
          workspace.look_back(), ++done;
        }
      }
    }
    QVERIFY(done > 100);
  }
};

QTEST_MAIN(EventLinesTest)
#include "event_lines_test.moc"
