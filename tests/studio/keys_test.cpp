// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests handle types, pictures of twerpers, simplifying, separate axes, and the fields and views of the curve panel.
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <random>

#include "betwixt/language.h"
#include "hands.h"
#include "scene/document.h"
#include "studio/curves/curve_actions.h"
#include "studio/curves/curve_pane.h"
#include "studio/curves/curves.h"
#include "studio/shell/number_field.h"
#include "studio/timeline/axes.h"
#include "studio/timeline/key_types.h"
#include "studio/timeline/simplified.h"
#include "studio/timeline/twerper_grid.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const std::string head = "rate 24\nrange 1f 97f\ncreate ball sphere\n";

struct Shown {
  Film at;
  Curves panel{at.workspace};
  CurvePane& pane;
  explicit Shown(const std::string& text) : at(text), pane(*panel.findChild<CurvePane*>("curve_pane")) {
    show(panel, 1000, 500);
    at.workspace.select({at.find("ball")});
    pane.finish(), pane.fit();
  }
  Target target(const std::string& words) const { return find_targets(words, at.workspace.document())->front(); }
  std::vector<EventAt> all(const std::string& words) const {
    std::vector<EventAt> out;
    for (const EventView& e : events(at.workspace.document(), target(words))) out.push_back({target(words), e.time});
    return out;
  }
};

// The largest difference of a target's numbers in two films, at many times.
double difference(const Document& a, const Document& b, const Target& t, Time first, Time last, int times = 997) {
  const Program one = Program::compile(a), two = Program::compile(b);
  double most = 0;
  for (int i = -50; i <= times + 50; ++i) {
    const Time at = first + Time{(last - first).flicks / times * i};
    const auto x = numbers(one.read(t, at)), y = numbers(two.read(t, at));
    for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, std::abs(x[k] - y[k]));
  }
  return most;
}

}  // namespace

class KeysTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  // Whatever the twerpers, eases and cuts are, free handles keep the film.
  void free_handles_keep_the_curve() {
    std::mt19937 random(7);
    const auto below = [&](unsigned n) { return random() % n; };
    const auto pick = [&](std::initializer_list<const char*> all) { return *(all.begin() + below(all.size())); };
    for (int film = 0; film < 60; ++film) {
      const bool vector = film % 2 == 0;
      std::string text = head + (vector ? "ball.position\n" : "ball.radius\n");
      const auto value = [&] {
        return vector ? fmt::format("({} {} {})", below(9), below(9), below(9)) : fmt::format("{}", 1 + below(9));
      };
      for (unsigned f = 1; f < 90; f += 5 + below(12)) {
        text += fmt::format("  {}f {}", f, value());
        if (below(5) == 0) text += " cut " + value();
        text += std::string(" ") + pick({"", "linear", "smooth", "auto", "hermite", "fcurve", "hold", "bounce-out",
                                         "bezier(0.3 0.1 0.2 1.4)", "bspline", "steps(3)"});
        if (below(4) == 0) text += " ease-out=2f";
        if (below(4) == 0) text += " ease-in=1f";
        text += "\n";
      }
      Film at(text);
      const Target t = find_targets(vector ? "ball.position" : "ball.radius", at.workspace.document())->front();
      std::vector<EventAt> some;
      for (const EventView& e : events(at.workspace.document(), t))
        if (below(2)) some.push_back({t, e.time});
      const Document before = at.workspace.document();
      const Lines lines = key_type_lines(before, some, KeyType::free);
      if (lines.empty()) continue;
      QVERIFY2(at.workspace.say(lines), at.workspace.last_said().c_str());
      const double off = difference(before, at.workspace.document(), t, at.frame(1), at.frame(90));
      QVERIFY2(off < 1e-7, fmt::format("{}: {}\n{}\nbecame\n{}", film, off, text, at.workspace.text()).c_str());
      at.workspace.undo();
      QCOMPARE(at.workspace.text(), text);
    }
  }

  void aligned_handles_stay_in_line() {
    Shown s(head + "ball.radius\n  1f 1 linear\n  25f 4 linear\n  73f 2\n");
    const Target t = s.target("ball.radius");
    QVERIFY(s.at.workspace.say(key_type_lines(s.at.workspace.document(), {{t, s.at.frame(25)}}, KeyType::aligned)));
    const CurveLine& line = s.pane.lines()[0];
    const auto event = [&] { return *find_event(s.at.workspace.document(), {t, s.at.frame(25)}); };
    QVERIFY(has_aligned_handles(line, event()));
    for (const Handle& h : handles(s.at.workspace.document(), line, s.at.frame(25)))
      if (h.what == Handle::What::handle_out)
        QVERIFY(s.at.workspace.say(handle_lines(s.at.workspace.document(), line, h, s.at.frame(35), 6, true)));
    QVERIFY(has_aligned_handles(line, event()));
    QCOMPARE(*event().detail->handle_out, s.at.frame(11) - s.at.frame(1));
    // Just before and just after the event, the speed is the same.
    const double e = 1e-4, at = s.at.frame(25).seconds();
    const auto value = [&](double x) { return std::get<double>(s.at.workspace.program().read(t, from_seconds(x))); };
    QVERIFY(std::abs((value(at) - value(at - e)) - (value(at + e) - value(at))) < 1e-6);
    // With alt one side moves alone.
    for (const Handle& h : handles(s.at.workspace.document(), line, s.at.frame(25)))
      if (h.what == Handle::What::handle_in)
        QVERIFY(s.at.workspace.say(handle_lines(s.at.workspace.document(), line, h, s.at.frame(20), 1, false)));
    QVERIFY(!has_aligned_handles(line, event()));
  }

  void a_key_opens_the_handle_types() {
    Shown s(head + "ball.radius\n  1f 1\n  25f 4\n  49f 1\n");
    s.at.workspace.select_events({{s.target("ball.radius"), s.at.frame(25)}});
    s.pane.setFocus();
    QTest::keyClick(&s.pane, Qt::Key_V);
    QMenu* menu = nullptr;
    for (QWidget* w : QApplication::topLevelWidgets())
      if (w->objectName() == "key_types") menu = qobject_cast<QMenu*>(w);
    QVERIFY(menu);
    QCOMPARE(menu->actions().size(), qsizetype(key_types().size()));
    menu->actions()[2]->trigger();
    menu->close();
    QCOMPARE(s.at.said, std::vector<std::string>{"at 25f ball.radius 4 linear"});
    s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), head + "ball.radius\n  1f 1\n  25f 4\n  49f 1\n");
  }

  void pictures_of_twerpers_are_their_curves() {
    const Document d = load_text("procedure mine twerper lua \"u * u\"\n", "film").document;
    const auto at = [&](const char* name, double u) {
      const auto shape = twerper_shape(d, name);
      return shape.empty() ? -99
                           : shape[static_cast<std::size_t>(std::lround(u * (static_cast<double>(shape.size()) - 1)))];
    };
    QVERIFY(std::abs(at("linear", 0.5) - 0.5) < 1e-9);
    QVERIFY(std::abs(at("quad-in", 0.25) - 0.0625) < 1e-9);
    QVERIFY(std::abs(at("sine-out", 0.5) - std::sqrt(0.5)) < 1e-9);
    QVERIFY(std::abs(at("mine", 0.5) - 0.25) < 1e-9);
    QCOMPARE(at("hold", 0.5), 0.0);
    QVERIFY(std::abs(at("steps", 0.5) - 0.5) < 1e-9);
    QVERIFY(twerper_shape(d, "slerp").empty() || !twerper_shape(d, "no-such").size());
  }

  void a_twerper_is_chosen_from_pictures() {
    const std::string film = head + "ball.radius\n  1f 1\n  25f 4\n  49f 1\n";
    Shown s(film);
    s.at.workspace.select_events({{s.target("ball.radius"), s.at.frame(1)}});
    ask_twerper(s.at.workspace, &s.panel);
    auto* grid = s.panel.findChild<TwerperGrid*>("twerper_grid");
    QVERIFY(grid);
    auto* bounce = grid->findChild<QToolButton*>("bounce-out");
    QVERIFY(bounce && !bounce->icon().isNull());
    QVERIFY(!grid->findChild<QToolButton*>("slerp"));  // numbers do not turn
    QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
    QApplication::sendEvent(bounce, &enter);
    QVERIFY(s.at.workspace.looks_ahead());
    QCOMPARE(s.at.workspace.text(), film);
    QTest::mouseClick(bounce, Qt::LeftButton);
    QVERIFY(!s.at.workspace.looks_ahead());
    QCOMPARE(s.at.said, std::vector<std::string>{"at 1f ball.radius 1 bounce-out"});
    s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), film);
  }

  void simplifying_keeps_within_the_tolerance() {
    std::mt19937 random(3);
    for (const char* twerper : {"", "linear", "auto"}) {
      std::string text = head + "ball.radius\n";
      for (int f = 1; f <= 97; ++f)
        text += fmt::format("  {}f {:.4f} {}\n", f, 3 + 2 * std::sin(f * 0.13) + 0.004 * (random() % 5), twerper);
      Film at(text);
      const Target t = find_targets("ball.radius", at.workspace.document())->front();
      std::vector<EventAt> all;
      for (const EventView& e : events(at.workspace.document(), t)) all.push_back({t, e.time});
      std::size_t last = 0;
      for (const double tolerance : {0.003, 0.01, 0.05, 0.2}) {
        const Document before = at.workspace.document();
        const Simplified made = simplified(before, all, tolerance);
        QVERIFY(made.gone.size() >= last);
        last = made.gone.size();
        QVERIFY(at.workspace.say(clear_lines(before, made.gone)));
        const double off = difference(before, at.workspace.document(), t, at.frame(1), at.frame(97), 20011);
        // The range is 4 or a little more; between samples the difference can be a little larger.
        QVERIFY2(off <= tolerance * 4.05 * 1.05, fmt::format("{} {} {}", twerper, tolerance, off).c_str());
        QVERIFY(made.error <= tolerance);
        // No single event more can go.
        for (const EventAt& e : all) {
          if (std::ranges::find(made.gone, e) != made.gone.end() || e == all.front() || e == all.back()) continue;
          std::vector<EventAt> more = made.gone;
          more.push_back(e);
          Result<Document> then = at.workspace.session().look_ahead(clear_lines(at.workspace.document(), {e}));
          QVERIFY(then);
          QVERIFY(difference(before, *then, t, at.frame(1), at.frame(97), 96 * 12) > tolerance * 4 * 0.99);
        }
        at.workspace.undo();
        QCOMPARE(at.workspace.text(), text);
      }
      QVERIFY2(last > 70, fmt::format("{}", last).c_str());
    }
  }

  // Events on one straight line are all superfluous; cuts and the ends stay.
  void what_is_needed_stays() {
    Film at(head + "ball.radius\n  1f 1 linear\n  25f 2 linear\n  49f 3 cut 5 linear\n  61f 6 linear\n  73f 7\n");
    const Target t = find_targets("ball.radius", at.workspace.document())->front();
    std::vector<EventAt> all;
    for (const EventView& e : events(at.workspace.document(), t)) all.push_back({t, e.time});
    const Simplified made = simplified(at.workspace.document(), all, 1e-6);
    QCOMPARE(made.gone, (std::vector<EventAt>{{t, at.frame(25)}, {t, at.frame(61)}}));
    // Only what is selected goes.
    QCOMPARE(simplified(at.workspace.document(), {{t, at.frame(61)}}, 1e-6).gone.size(), std::size_t(1));
  }

  void axes_are_separated() {
    const std::string film = head +
                             "ball.position\n  1f (0 1 2) auto # begins\n  25f (4 0 3) cut (5 5 5) ease-in=3f\n"
                             "  49f (1 2 3) linear\n  73f (0 0 0)  # ends\nset ball.color red\n";
    Shown s(film);
    const Document before = s.at.workspace.document();
    s.at.workspace.select_events(s.all("ball.position"));
    separate_axes(s.at.workspace);
    QCOMPARE(s.at.workspace.events_selected().size(), std::size_t(12));  // the same events of each axis
    const Target t = s.target("ball.position");
    QVERIFY(difference(before, s.at.workspace.document(), t, s.at.frame(1), s.at.frame(73)) < 1e-9);
    QVERIFY2(QString::fromStdString(s.at.workspace.text()).count("\nball.position.") == 3,
             (s.at.workspace.text() + fmt::format("{}", fmt::join(s.at.said, "\n"))).c_str());
    QVERIFY2(s.at.workspace.text().find("ball.position.x\n  1f 0 auto # begins\n") != std::string::npos,
             s.at.workspace.text().c_str());
    QVERIFY(s.at.workspace.text().ends_with("set ball.color red\n"));
    // One axis can now have an event of its own.
    QVERIFY(s.at.workspace.say(std::string("move ball.position.y 25f..25f by 5f")));
    QCOMPARE(events(s.at.workspace.document(), s.target("ball.position.x"))[1].time, s.at.frame(25));
    s.at.workspace.undo(), s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), film);
    // A line of several objects stays.
    Shown many("create {ball,box} sphere\n{ball,box}.rotation\n  1f (0 0 0)\n  24f (0 90deg 45deg)\n");
    const Document was = many.at.workspace.document();
    separate_axes(many.at.workspace);
    QVERIFY(!many.at.workspace.session().history(1).empty());
    QVERIFY(difference(was, many.at.workspace.document(), many.target("ball.rotation"), many.at.frame(1),
                       many.at.frame(24)) < 1e-9);
    QVERIFY(betwixt::track(many.at.workspace.document(), many.target("box.rotation")));
    QVERIFY(!can_separate(many.at.workspace.document(), many.target("ball.rotation")));
  }

  void time_and_value_are_typed() {
    const std::string film = head + "ball.position\n  1f (0 0 0) linear\n  25f (4 1 0) linear\n  49f (0 0 0)\n";
    Shown s(film);
    auto& time = *s.panel.findChild<QLineEdit*>("key_time");
    auto& value = *s.panel.findChild<NumberField*>("key_value");
    QVERIFY(!time.isEnabled() && !value.isEnabled());
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.pane.place(1, s.at.frame(25), 1).toPoint());
    QCOMPARE(time.text(), "25f");
    QCOMPARE(value.text(), "1");
    QTest::mouseClick(&value, Qt::LeftButton);
    value.selectAll(), QTest::keyClicks(&value, "2.5"), QTest::keyClick(&value, Qt::Key_Return);
    QCOMPARE(s.at.said, std::vector<std::string>{"at 25f ball.position (4 2.5 0) linear"});
    time.setFocus(), time.selectAll(), QTest::keyClicks(&time, "31"), QTest::keyClick(&time, Qt::Key_Return);
    QCOMPARE(s.at.said.back(), "move ball.position 25f..25f by 6f");
    QCOMPARE(s.at.workspace.events_selected()[0].time, s.at.frame(31));
    time.setFocus(), time.selectAll(), QTest::keyClicks(&time, "soon"), QTest::keyClick(&time, Qt::Key_Return);
    QVERIFY(s.at.said.back().starts_with("refused"));
    QCOMPARE(time.text(), "31f");
    s.at.workspace.undo(), s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), film);
  }

  void frames_and_reference_are_views() {
    const std::string film = head + "ball.radius\n  1f 1 linear\n  25f 9 linear\n  49f 8 linear\n  97f 8\n";
    Shown s(film);
    const Target t = s.target("ball.radius");
    s.at.workspace.select_events({{t, s.at.frame(25)}, {t, s.at.frame(49)}});
    s.pane.setFocus();
    const double before = s.pane.place(0, s.at.frame(1), 8).y() - s.pane.place(0, s.at.frame(1), 9).y();
    QTest::keyClick(&s.pane, Qt::Key_Period);
    QVERIFY(s.pane.place(0, s.at.frame(1), 8).y() - s.pane.place(0, s.at.frame(1), 9).y() > 2 * before);
    QVERIFY(s.pane.place(0, s.at.frame(25), 9).x() > 0 && s.pane.place(0, s.at.frame(49), 8).x() < s.pane.width());
    QVERIFY(s.pane.place(0, s.at.frame(97), 8).x() > s.pane.width());
    QTest::keyClick(&s.pane, Qt::Key_Home);
    QVERIFY(s.pane.place(0, s.at.frame(97), 8).x() < s.pane.width());
    s.pane.finish();
    const QImage plain = s.pane.grab().toImage();
    s.pane.freeze(true);
    QVERIFY(s.at.workspace.say(std::string("at 25f ball.radius 2 linear")));
    s.pane.finish();
    const QImage with = s.pane.grab().toImage();
    s.pane.freeze(false);
    QVERIFY(s.pane.grab().toImage() != with);  // the old curve was still there
    s.at.workspace.undo();
    s.pane.finish();
    QCOMPARE(s.pane.grab().toImage(), plain);
    QCOMPARE(s.at.workspace.text(), film);
  }
};

QTEST_MAIN(KeysTest)
#include "keys_test.moc"
