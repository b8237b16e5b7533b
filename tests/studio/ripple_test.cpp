// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests inserted and removed time: later events and notes move by it, earlier ones stay.
#include "studio/timeline/ripple.h"

#include <QTest>
#include <filesystem>
#include <map>
#include <random>

#include "betwixt/object.h"
#include "betwixt/track.h"
#include "studio/film.h"

namespace betwixt::studio {

class RippleTest : public QObject {
  Q_OBJECT

  // The times of all events by their tracks, and those of notes.
  static std::map<std::string, std::vector<Time>> times(const Document& d) {
    std::map<std::string, std::vector<Time>> all;
    for (const ObjectId id : objects(d))
      for (const TrackView& t : tracks(d, id))
        for (const EventView& e : events(d, t.target))
          all[(t.target.layer ? d.name(t.target.layer) + ":" : "") + d.name(t.target)].push_back(e.time);
    for (const Note& n : d.notes(earliest_time, latest_time)) all["note " + n.text].push_back(n.time);
    for (const Pause& p : d.pauses()) all["step " + p.text].push_back(p.time);
    for (const Description& said : d.descriptions()) all["description " + said.text].push_back(said.time);
    return all;
  }

 private Q_SLOTS:
  void later_things_come_later() {
    Film f(
        "rate 24\nrange 1f 48f\ncreate ball sphere\nball.position.x\n  1f 0\n  24f 4 linear\n  48f 8\n"
        "ball.radius\n  30f 2\nat 24f note \"up\"\nat 12f note \"down\"\n"
        "at 24f step \"a\"\nat 30f step \"b\"\nat 24f describe \"c\"\n");
    const QString before = f.text();
    const Document& d = f.workspace.document();
    QCOMPARE(
        insert_time_lines(d, f.at_time("24f"), d.rate().span(12)),
        (Lines{"move ball.position.x 24f..48f by 12f", "move ball.radius 30f..30f by 12f", "move notes 24f..24f by 12f",
               "move steps 24f..30f by 12f", "move descriptions 24f..24f by 12f", "range 1f 60f"}));
    QVERIFY(f.workspace.say(insert_time_lines(d, f.at_time("24f"), d.rate().span(12))));
    QVERIFY2(f.text().contains("  36f 4 linear\n  60f 8\n") && f.text().contains("range 1f 60f\n"),
             qPrintable(f.text()));
    QVERIFY(f.workspace.say(remove_time_lines(d, f.at_time("24f"), f.at_time("36f"))));
    f.workspace.undo(), f.workspace.undo();
    QCOMPARE(f.text(), before);
    QVERIFY(f.workspace.say(remove_time_lines(d, f.at_time("10f"), f.at_time("31f"))));
    QCOMPARE(times(d)["ball.position.x"], (std::vector{f.at_time("1f"), f.at_time("27f")}));
    QVERIFY(!times(d).contains("note up") && !times(d).contains("step a") && !times(d).contains("ball.radius"));
    f.workspace.undo();
    QCOMPARE(f.text(), before);
  }

  void in_all_examples_it_is_there_and_gone_again() {
    std::mt19937 dice(4);
    int done = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/examples")) {
      if (entry.path().extension() != ".bx") continue;
      Workspace workspace;
      if (!workspace.open(QString::fromStdString(entry.path().string()))) continue;
      const Document first = workspace.document();
      const int frames = first.frame_count();
      const Time at = first.rate().frame(1 + static_cast<double>(dice() % static_cast<unsigned>(frames)));
      const Time by = first.rate().span(1 + static_cast<double>(dice() % 30));
      const Lines lines = insert_time_lines(first, at, by);
      if (lines.empty()) continue;
      const auto there = workspace.session().look_ahead(lines);
      if (!there) continue;  // rows of code, and motions that other lines make, cannot always be moved
      auto expected = times(first);
      for (auto& [track, all] : expected)
        for (Time& t : all)
          if (t >= at) t = t + by;
      QVERIFY2(times(*there) == expected, entry.path().c_str());
      QCOMPARE(there->range().second, first.range().second >= at ? first.range().second + by : first.range().second);
      QVERIFY2(workspace.say(lines), entry.path().c_str());
      QVERIFY2(workspace.say(remove_time_lines(workspace.document(), at, at + by)), entry.path().c_str());
      QVERIFY2(times(workspace.document()) == times(first), entry.path().c_str());
      workspace.undo(), workspace.undo();  // without a journal left behind
      ++done;
    }
    QVERIFY2(done > 20, std::to_string(done).c_str());
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::RippleTest)
#include "ripple_test.moc"
