// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the parts of a value in the properties: what is added, tuned, switched off, exchanged and removed. Each test
// compares the film with that of a script that an author would write.
#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QTest>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "studio/panels/new_parts.h"
#include "studio/panels/properties.h"
#include "studio/shell/number_field.h"
#include "studio/shown_properties.h"

namespace betwixt::studio {

class PartsTest : public QObject {
  Q_OBJECT

  struct Shown : ShownProperties {
    explicit Shown(const QByteArray& text, const char* selected = "ball") : ShownProperties(text, selected, 1600) {}
    PartsView& parts(const char* function) {
      auto* button = panel.findChild<QToolButton*>(QString("unfold_") + function);
      if (!button) qFatal("no %s", function);
      button->setChecked(true);
      return *panel.findChild<PartsView*>(QString("parts_") + function);
    }
    NumberField& at(const char* function) {
      return *panel.findChild<ValueEditor*>(function)->findChild<NumberField*>("value");
    }
    static QStringList titles(const PartsView& view) {
      QStringList all;
      for (const ValuePart& p : view.parts()) all << QString::fromStdString(p.title);
      return all;
    }
    template <class W>
    static W& in(PartsView& view, int part, const char* name) {
      auto* row = view.findChild<QWidget*>(QString("part_%1").arg(part));
      // A row that was replaced lives until the next event.
      for (auto* w : view.findChildren<QWidget*>(QString("part_%1").arg(part)))
        if (!w->isHidden()) row = w;
      if (!row || !row->findChild<W*>(name)) qFatal("part %d has no %s", part, name);
      return *row->findChild<W*>(name);
    }
    void add(const char* function, const char* menu, const char* name) {
      auto* all = panel.findChild<QMenu*>(QString("new_parts_") + function);
      if (!all) qFatal("no menu of %s", function);
      emit all->aboutToShow();
      if (*menu) all = all->findChild<QMenu*>(menu);
      for (QAction* a : all->actions())
        if (a->text() == name) return a->trigger();
      qFatal("%s has no %s", menu, name);
    }
    // Returns whether the film is that of another script, by the values of the ball.
    bool is(const std::string& script) const { return workspace.document() == load_text(script, "other").document; }
    static void type(QLineEdit& into, const char* keys) {
      QTest::mouseClick(&into, Qt::LeftButton);
      into.selectAll();
      QTest::keyClicks(&into, keys);
      QTest::keyClick(&into, Qt::Key_Return);
    }
  };

 private Q_SLOTS:
  void a_new_filter_is_shown_and_its_first_number_has_the_focus() {
    Shown s(
        "range 1f 48f\ncreate ball sphere\nball.position\n  1f (0 0 0)\n  24f (4 0 0)\nfilter ball.position smooth\n");
    QVERIFY(!s.panel.findChild<PartsView*>("parts_position"));
    s.add("position", "Filter", "noise");
    QTRY_VERIFY(s.panel.findChild<PartsView*>("parts_position"));
    PartsView& view = *s.panel.findChild<PartsView*>("parts_position");
    QTRY_VERIFY(s.panel.focusWidget() && view.isAncestorOf(s.panel.focusWidget()));
    QVERIFY2(s.panel.focusWidget()->accessibleName().startsWith("noise"),
             qPrintable(s.panel.focusWidget()->accessibleName()));
  }

  void filters_are_added_tuned_and_removed() {
    const QByteArray first =
        "rate 24\nrange 1f 48f\ncreate ball sphere  # round\nball.position\n  1f (0 0 0)\n"
        "  24f (4 0 0)\n";
    Shown s(first);
    s.add("position", "Filter", "smooth");
    QCOMPARE(s.text(), QString(first) + "filter ball.position smooth width=0.5s\n");
    PartsView& view = s.parts("position");
    QCOMPARE(Shown::titles(view), QStringList({"2 events, 1f to 24f", "smooth"}));
    Shown::type(Shown::in<NumberField>(view, 1, "width"), "6f");
    QCOMPARE(s.text(), QString(first) + "filter ball.position smooth width=6f\n");
    QCOMPARE(Shown::in<NumberField>(view, 1, "width").text(), "6f");
    Shown::type(Shown::in<NumberField>(view, 1, "width"), "much");  // refused, and nothing changes
    QCOMPARE(s.text(), QString(first) + "filter ball.position smooth width=6f\n");
    QTest::mouseClick(&Shown::in<QToolButton>(view, 1, "remove"), Qt::LeftButton);
    QCOMPARE(s.text(), QString(first));
    for (int i = 0; i < 3; ++i) s.workspace.undo();
    QCOMPARE(s.text(), QString(first));
    QVERIFY(!s.workspace.session().enter("undo").done);
  }

  void a_drag_shows_what_the_line_would_do() {
    const QByteArray film =
        "rate 24\nrange 1f 48f\ncreate ball sphere\nball.radius\n  1f 1\n  24f 3 linear\n"
        "filter ball.radius delay by=0.5s\n";
    Shown s(film);
    s.workspace.go_to(s.at_time("18f"));
    auto& field = Shown::in<NumberField>(s.parts("radius"), 1, "by");
    const double before = s.radius("ball");
    const QPoint from = field.rect().center();
    QTest::mousePress(&field, Qt::LeftButton, {}, from);
    for (int x : {10, 20}) {
      const QPointF to = from + QPointF(x, 0);
      QMouseEvent move(QEvent::MouseMove, to, field.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&field, &move);
    }
    QVERIFY(s.workspace.looks_ahead());
    QCOMPARE(field.text(), "0.6s");
    QVERIFY(s.radius("ball") != before);
    QCOMPARE(s.text(), QString(film));
    QTest::keyClick(&field, Qt::Key_Escape);
    QCOMPARE(s.radius("ball"), before);
    QTest::mouseRelease(&field, Qt::LeftButton, {}, from + QPoint(20, 0));
    QCOMPARE(s.text(), QString(film));
  }

  void a_filter_is_switched_off_by_a_word() {
    const std::string film =
        "create ball sphere\nball.radius\n  1f 1\n  24f 3\n"
        "filter ball.radius wobble amount=0.1  # trembles\nfilter ball.radius limit low=0.5\n";
    Shown s(QByteArray::fromStdString(film));
    PartsView& view = s.parts("radius");
    QTest::mouseClick(&Shown::in<QCheckBox>(view, 1, "on"), Qt::LeftButton, {}, {8, 8});
    QVERIFY2(s.text().contains("\nfilter ball.radius wobble amount=0.1 off  # trembles\n"), qPrintable(s.text()));
    QCOMPARE(Shown::titles(view), QStringList({"2 events, 1f to 1s", "wobble", "limit"}).replaceInStrings("1s", "24f"));
    QVERIFY(view.parts()[1].off && !view.parts()[2].off);
    QTest::mouseClick(&Shown::in<QCheckBox>(view, 1, "on"), Qt::LeftButton, {}, {8, 8});
    QCOMPARE(s.text().toStdString(), film);
  }

  // A filter that is a comment is off too.
  void a_comment_is_a_filter_that_is_off() {
    Shown s("create ball sphere\nball.radius\n  1f 1\n  24f 3\n# filter ball.radius wobble amount=0.1  # trembles\n");
    PartsView& view = s.parts("radius");
    QVERIFY(view.parts()[1].off);
    QTest::mouseClick(&Shown::in<QCheckBox>(view, 1, "on"), Qt::LeftButton, {}, {8, 8});
    QVERIFY2(s.text().endsWith("\nfilter ball.radius wobble amount=0.1  # trembles\n"), qPrintable(s.text()));
    QVERIFY(!view.parts()[1].off);
  }

  // Of a filter that a line gives to several objects, one is switched off.
  void a_filter_of_several_is_switched_off_for_one() {
    Shown s("create ball sphere\ncreate box2 sphere\nball.radius\n  1f 1\n  24f 3\nfilter b*.radius limit low=2\n");
    PartsView& view = s.parts("radius");
    QTest::mouseClick(&Shown::in<QCheckBox>(view, 1, "on"), Qt::LeftButton, {}, {8, 8});
    QVERIFY2(s.text().endsWith("filter ball.radius none\nfilter ball.radius limit low=2 off\n"), qPrintable(s.text()));
    QVERIFY(view.parts()[1].off);
    QTest::mouseClick(&Shown::in<QCheckBox>(view, 1, "on"), Qt::LeftButton, {}, {8, 8});
    QVERIFY2(s.text().endsWith("filter ball.radius limit low=2\n"), qPrintable(s.text()));
    QCOMPARE(s.radius("ball"), 2.0);
  }

  // Rows that are replaced while the user types in them say nothing.
  void a_field_that_goes_says_nothing() {
    Shown s("create ball sphere\nball.radius\n  1f 1\n  24f 3\nfilter ball.radius wobble amount=0.1\n");
    PartsView& view = s.parts("radius");
    auto& field = Shown::in<NumberField>(view, 1, "amount");
    QTest::mouseClick(&field, Qt::LeftButton);
    field.selectAll(), QTest::keyClicks(&field, "7");
    QVERIFY(s.workspace.say(std::string("filter ball.radius none")));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(!s.text().contains('7'));
    QCOMPARE(Shown::titles(view), QStringList({"2 events, 1f to 24f"}));
    // The whole panel is built anew, too.
    auto& value = s.at("radius");
    QTest::mouseClick(&value, Qt::LeftButton);
    value.selectAll(), QTest::keyClicks(&value, "7");
    QVERIFY(s.workspace.say(std::string("set ball.radius = \"1 + t\"")));
    QVERIFY(s.workspace.say(std::string("clear ball.radius 1f..24f")));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(!s.text().contains('7'));
  }

  void filters_change_places() {
    const std::string film =
        "create ball sphere\nball.radius\n  1f 1\n  24f 3\nfilter ball.radius quantise by=1\n"
        "# a remark\nfilter ball.radius wobble amount=0.1\n";
    Shown s(QByteArray::fromStdString(film));
    PartsView& view = s.parts("radius");
    QVERIFY(!Shown::in<QToolButton>(view, 1, "up").isEnabled());
    QTest::mouseClick(&Shown::in<QToolButton>(view, 1, "down"), Qt::LeftButton);
    QCOMPARE(s.text().toStdString(),
             "create ball sphere\nball.radius\n  1f 1\n  24f 3\nfilter ball.radius wobble amount=0.1\n"
             "# a remark\nfilter ball.radius quantise by=1\n");
    s.workspace.undo();
    QCOMPARE(s.text().toStdString(), film);
  }

  void filters_are_dragged_to_another_place() {
    const std::string film =
        "create ball sphere\nball.radius\n  1f 1\n  24f 3\nfilter ball.radius quantise by=1\n"
        "# a remark\nfilter ball.radius wobble amount=0.1\n# filter ball.radius limit low=1\n\nset ball.color red\n";
    Shown s(QByteArray::fromStdString(film));
    PartsView& view = s.parts("radius");
    QCOMPARE(Shown::titles(view).mid(1), (QStringList{"quantise", "wobble", "limit"}));
    const auto pull = [&](int part, int to, bool held) {
      QApplication::processEvents();  // new rows get their places
      auto& grip = Shown::in<QLabel>(view, part, "grip");
      auto& other = Shown::in<QToolButton>(view, to, "title");
      const QPoint at = grip.mapFromGlobal(other.mapToGlobal(other.rect().center()));
      QTest::mousePress(&grip, Qt::LeftButton, {}, grip.rect().center());
      for (const QPoint& p : {grip.rect().center() + QPoint(0, 2), at}) {
        QMouseEvent move(QEvent::MouseMove, p, grip.mapToGlobal(p), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&grip, &move);
      }
      if (!held) QTest::mouseRelease(&grip, Qt::LeftButton, {}, at);
    };
    pull(1, 3, true);
    QVERIFY(s.workspace.looks_ahead());  // the picture shows what the line would do
    QTest::keyClick(&Shown::in<QLabel>(view, 1, "grip"), Qt::Key_Escape);
    QVERIFY(!s.workspace.looks_ahead());
    QTest::mouseRelease(&Shown::in<QLabel>(view, 1, "grip"), Qt::LeftButton);
    QCOMPARE(s.text().toStdString(), film);
    pull(1, 3, false);
    QCOMPARE(s.text().toStdString(),
             "create ball sphere\nball.radius\n  1f 1\n  24f 3\nfilter ball.radius wobble amount=0.1\n"
             "# a remark\n# filter ball.radius limit low=1\nfilter ball.radius quantise by=1\n\nset ball.color red\n");
    QCOMPARE(Shown::titles(view).mid(1), (QStringList{"wobble", "limit", "quantise"}));
    pull(3, 1, false);
    QCOMPARE(s.text().toStdString(), film);
    s.workspace.undo(), s.workspace.undo();
    QCOMPARE(s.text().toStdString(), film);
    pull(1, 0, false);  // the events are no filter
    QCOMPARE(s.text().toStdString(), film);
  }

  void filters_of_a_pattern_are_dragged_for_one_object() {
    Shown s(
        "create b{1..2} sphere\nb*.radius\n  1f 1\n  24f 3\nfilter b*.radius wobble amount=0.1\n"
        "filter b*.radius limit low=0.5\nfilter b1.radius quantise by=1\n",
        "b1");
    PartsView& view = s.parts("radius");
    const std::string text = s.workspace.text();
    s.workspace.say(move_part(s.workspace.document(), text, view.parts(), 1, 3));
    QVERIFY(
        s.is("create b{1..2} sphere\nb*.radius\n  1f 1\n  24f 3\nfilter b2.radius wobble amount=0.1\n"
             "filter b2.radius limit low=0.5\nfilter b1.radius limit low=0.5\nfilter b1.radius quantise by=1\n"
             "filter b1.radius wobble amount=0.1\n"));
    s.workspace.undo();
    QCOMPARE(s.workspace.text(), text);
  }

  // A line of several objects stays as it is; the filters of the one object are written anew.
  void a_pattern_keeps_the_others() {
    const std::string film =
        "create b{1..2} sphere\nb*.radius\n  1f 1\n  24f 3\nfilter b*.radius wobble amount=0.1\n"
        "filter b*.radius limit low=0.5\n";
    Shown s(QByteArray::fromStdString(film), "b1");
    PartsView& view = s.parts("radius");
    QVERIFY(!view.parts()[1].own);
    Shown::type(Shown::in<NumberField>(view, 1, "amount"), "0.3");
    QVERIFY2(s.is("create b{1..2} sphere\nb*.radius\n  1f 1\n  24f 3\nfilter b1.radius wobble amount=0.3\n"
                  "filter b1.radius limit low=0.5\nfilter b2.radius wobble amount=0.1\n"
                  "filter b2.radius limit low=0.5\n"),
             qPrintable(s.text()));
    QVERIFY(view.parts()[1].own);  // from now on it has a line of its own
    s.workspace.undo();
    QCOMPARE(s.text().toStdString(), film);
  }

  void a_layer_adds_nothing_at_first_and_its_weight_gets_keys() {
    const std::string film = "rate 24\nrange 1f 48f\ncreate ball sphere\nball.position\n  1f (0 0 0)\n  24f (4 1 0)\n";
    Shown s(QByteArray::fromStdString(film));
    const Document before = s.workspace.document();
    s.add("position", "Layer", "new layer that adds");
    QCOMPARE(s.text().toStdString(), film + "layer layer1 add\non layer1 at 1f ball.position (0 0 0)\n");
    const Program was = Program::compile(before);
    for (int f = -10; f < 60; ++f) {
      const Time t = before.rate().frame(f);
      QCOMPARE(s.workspace.program().read(s.target("ball.position"), t), was.read(s.target("ball.position"), t));
    }
    PartsView& view = s.parts("position");
    QCOMPARE(Shown::titles(view), QStringList({"2 events, 1f to 24f", "layer layer1 (add)"}));
    Shown::type(Shown::in<NumberField>(view, 1, "valuey"), "2");
    Shown::type(Shown::in<NumberField>(view, 1, "weight"), "0.5");
    QCOMPARE(s.value("ball.position"), Value(Vec3{0, 1, 0}));
    QTest::mouseClick(&Shown::in<QToolButton>(view, 1, "key"), Qt::LeftButton);
    s.workspace.go_to(s.at_time("24f"));
    Shown::type(Shown::in<NumberField>(view, 1, "weight"), "1");
    QCOMPARE(s.events_of("layer1.weight"), std::size_t{2});
    QCOMPARE(s.value("ball.position"), Value(Vec3{4, 3, 0}));
    QTest::mouseClick(&Shown::in<QToolButton>(view, 1, "remove"), Qt::LeftButton);
    QVERIFY(layers(s.workspace.document()).empty());
    QCOMPARE(s.text().toStdString(), film);  // its lines are gone
    while (s.workspace.session().unsaved() > 0) s.workspace.undo();
    QCOMPARE(s.text().toStdString(), film);
  }

  void code_and_velocity() {
    Shown s("rate 24\nrange 1f 48f\ncreate ball sphere\n");
    s.add("radius", "Code", "a formula");
    QVERIFY2(s.text().contains("set ball.radius = \"1 + 0.1 * sin(t * tau)\""), qPrintable(s.text()));
    PartsView& view = s.parts("radius");
    QCOMPARE(Shown::titles(view), QStringList({"code"}));
    auto& line = Shown::in<QLineEdit>(view, 0, "value");
    QCOMPARE(line.text(), "1 + 0.1 * sin(t * tau)");
    line.setFocus(), line.selectAll();
    QTest::keyClicks(&line, "2 + t"), QTest::keyClick(&line, Qt::Key_Return);
    QCOMPARE(s.text(), "rate 24\nrange 1f 48f\ncreate ball sphere\nset ball.radius = \"2 + t\"\n");
    s.add("position", "", "Velocity");
    QVERIFY2(s.text().contains("at 1f ball.position.velocity (1 0 0)\n"), qPrintable(s.text()));
    PartsView& moves = s.parts("position");
    QCOMPARE(Shown::titles(moves), QStringList({"position.velocity"}));
    Shown::type(Shown::in<NumberField>(moves, 0, "valuex"), "3");
    QVERIFY2(s.text().contains("at 1f ball.position.velocity (3 0 0)"), qPrintable(s.text()));
    QTest::mouseClick(&Shown::in<QToolButton>(moves, 0, "remove"), Qt::LeftButton);
    QVERIFY(!s.text().contains("velocity"));
  }

  void code_at_an_event_is_a_part() {
    const std::string film =
        "rate 24\nrange 1f 48f\ncreate ball sphere\nball.radius\n  1f 1\n  12f = \"1 + t\"\n"
        "  24f 2\nlayer sway add\non sway at 1f ball.radius 1\nset sway.weight = \"t\"\n"
        "create car box\nset car.size.x = \"1 + value('sway.weight')\"\n";
    Shown s(QByteArray::fromStdString(film));
    PartsView& view = s.parts("radius");
    QCOMPARE(Shown::titles(view), QStringList({"3 events, 1f to 24f", "code at 12f", "layer sway (add)"}));
    auto& line = Shown::in<QLineEdit>(view, 1, "value");
    line.setFocus(), line.selectAll();
    QTest::keyClicks(&line, "2"), QTest::keyClick(&line, Qt::Key_Return);
    QVERIFY2(s.text().contains("\n  12f = \"2\"\n"), qPrintable(s.text()));
    QTest::mouseClick(&Shown::in<QToolButton>(view, 1, "remove"), Qt::LeftButton);
    QVERIFY2(s.text().contains("  1f 1\n  24f 2\n"), qPrintable(s.text()));
    s.workspace.undo(), s.workspace.undo();
    QCOMPARE(s.text().toStdString(), film);
  }

  // What is offered leaves the others alone, and undo gives the first text.
  void undo_gives_the_first_text() {
    const QByteArray film =
        "rate 24\nrange 1f 48f\ncreate ball sphere\ncreate car box\nball.position\n  1f (0 0 0)\n"
        "  24f (4 1 0)\n";
    Film s(film);
    for (const char* function : {"ball.position", "ball.radius", "ball.rotation", "ball.color"})
      for (const NewPart& part :
           new_parts(s.workspace.document(), s.workspace.program(), {s.target(function)}, s.at_time("6f"))) {
        QVERIFY2(s.workspace.say(part.lines), part.lines.back().c_str());
        QVERIFY(s.text().startsWith(film.left(film.indexOf("ball.position"))));
        s.workspace.undo();
        QCOMPARE(s.text(), QString(film));
      }
  }

  // Every entry of every menu is a line that the language takes, for all kinds of objects.
  void all_that_is_offered_is_taken() {
    std::string film = "rate 24\nrange 1f 48f\nprocedure loud filter lua \"input() * 2\"\nlayer sway add\n";
    for (const char* kind : {"sphere", "box", "text", "light", "camera", "polyline", "sound", "group"})
      film += fmt::format("create a{0} {0}\ncreate b{0} {0}\n", kind);
    film += "asphere.color\n  1f red\n  24f blue\nasphere.rotation\n  1f quat(1 0 0 0)\n  24f axis(y, 90deg)\n";
    Film s(QByteArray::fromStdString(film));
    const Document& d = s.workspace.document();
    int offered = 0;
    QStringList wrong;
    for (const ObjectId id : objects(d))
      for (const FunctionView& f : functions(d, id))
        for (const NewPart& part : new_parts(d, s.workspace.program(), {Target(id, f.id)}, s.at_time("6f"))) {
          ++offered;
          if (const auto then = s.workspace.session().look_ahead(part.lines); !then)
            wrong << QString::fromStdString(part.lines.back() + ": " + then.error().message);
        }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    QVERIFY(offered > 500);
  }

  void a_click_goes_to_the_line() {
    Shown s("create ball sphere\nball.radius\n  1f 1\n  24f 3\nfilter ball.radius wobble amount=0.1\n");
    PartsView& view = s.parts("radius");
    QTest::mouseClick(&Shown::in<QToolButton>(view, 1, "title"), Qt::LeftButton);
    QCOMPARE(s.workspace.script_line(), 5);
    QTest::mouseClick(&Shown::in<QToolButton>(view, 0, "title"), Qt::LeftButton);
    QCOMPARE(s.workspace.script_line(), 2);
    QCOMPARE(s.workspace.events_selected().size(), std::size_t{2});
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::PartsTest)
#include "parts_test.moc"
