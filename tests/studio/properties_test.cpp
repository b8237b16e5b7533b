// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests values changed in the properties panel, and the lines that result.
#include "studio/panels/properties.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QFileDialog>
#include <QTest>
#include <QTimer>

#include "betwixt/language.h"
#include "scene/document.h"
#include "studio/shell/number_field.h"
#include "studio/shown_properties.h"

namespace betwixt::studio {

class PropertiesTest : public QObject {
  Q_OBJECT

  struct Shown : ShownProperties {
    explicit Shown(const QByteArray& text, const char* selected = "ball") : ShownProperties(text, selected, 500) {}
    template <class W = NumberField>
    W& at(const char* function, const char* part = "value") {
      auto* editor = panel.findChild<ValueEditor*>(function);
      if (!editor || !editor->findChild<W*>(part)) qFatal("%s has no %s", function, part);
      return *editor->findChild<W*>(part);
    }
    QToolButton& diamond(const char* f) { return *panel.findChild<QToolButton*>(QString("diamond_") + f); }
    QString made(const char* f) { return panel.findChild<QLabel*>(QString("made_") + f)->text(); }
    void type(QLineEdit& into, const char* keys) {
      QTest::mouseClick(&into, Qt::LeftButton);
      into.selectAll();
      QTest::keyClicks(&into, keys);
      QTest::keyClick(&into, Qt::Key_Return);
    }
    void drag(QWidget& w, int pixels, bool let_go = true) {
      const QPoint from = w.rect().center();
      QTest::mousePress(&w, Qt::LeftButton, {}, from);
      for (int i = 1; i <= 4; ++i) {
        const QPointF to = from + QPointF(pixels * i / 4.0, 0);
        QMouseEvent move(QEvent::MouseMove, to, w.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&w, &move);
      }
      if (let_go) QTest::mouseRelease(&w, Qt::LeftButton, {}, from + QPoint(pixels, 0));
    }
  };

 private Q_SLOTS:
  void shows_what_is_selected() {
    Shown s("create ball sphere radius=2 color=gold\ncreate car box\n");
    QCOMPARE(s.panel.findChild<QLineEdit*>("name")->text(), "ball");
    QCOMPARE(s.at("radius").text(), "2");
    QCOMPARE(s.at<QLineEdit>("color").text(), "gold");
    QCOMPARE(s.made("radius"), "set");
    QCOMPARE(s.made("scale"), "");
    s.select("car");
    QCOMPARE(s.at("size", "x").text(), "1");
    QVERIFY(!s.panel.findChild<ValueEditor*>("radius"));
  }

  void a_narrow_field_shows_a_shorter_number_and_keeps_the_whole_one() {
    Shown s("create ball sphere radius=1234.56789 rotation=euler(0 0 -123.456deg)\n");
    NumberField &radius = s.at("radius"), &angle = s.at("rotation", "z");
    s.panel.resize(1200, 900);
    QCoreApplication::processEvents();
    QCOMPARE(angle.text(), "-123.456deg");
    radius.setFixedWidth(radius.minimumWidth()), angle.setFixedWidth(angle.minimumWidth());
    QCoreApplication::processEvents();
    for (NumberField* field : {&radius, &angle}) {
      QVERIFY(field->fontMetrics().horizontalAdvance(field->text()) < field->width());
      const double whole = field == &radius ? 1234.56789 : -123.456;
      QVERIFY2(std::abs(field->text().toDouble() - whole) < 1, qPrintable(field->text()));
    }
    QVERIFY(angle.toolTip().contains("-123.456deg"));
    const QString before = s.text();
    QTest::mouseClick(&angle, Qt::LeftButton);
    QCOMPARE(angle.text(), "-123.456deg");
    QTest::keyClick(&angle, Qt::Key_Escape);
    QTest::mouseClick(&radius, Qt::LeftButton);
    radius.clearFocus();
    QCOMPARE(s.text(), before);  // what is only looked at does not change
    s.drag(angle, 10);
    QVERIFY2(s.text().contains("-118deg"), qPrintable(s.text()));
  }

  void a_number_is_typed() {
    Shown s("create ball sphere radius=2\n");
    s.type(s.at("radius"), "3.5");
    QCOMPARE(s.radius("ball"), 3.5);
    QCOMPARE(s.text(), "create ball sphere radius=3.5\n");
    QVERIFY(s.workspace.last_said().empty());
    s.type(s.at("radius"), "2*3");  // a formula
    QCOMPARE(s.radius("ball"), 6.0);
    s.workspace.undo();
    s.workspace.undo();
    QCOMPARE(s.text(), "create ball sphere radius=2\n");
    QCOMPARE(s.at("radius").text(), "2");
  }

  // A file that is chosen is named from the folder of the script.
  void the_film_takes_a_look_file() {
    Shown s("create ball sphere\n");
    const QDir folder = QFileInfo(QString::fromStdString(s.workspace.session().file())).absoluteDir();
    QVERIFY(folder.mkdir("looks"));
    QFile look(folder.filePath("looks/swap.cube"));
    QVERIFY(look.open(QIODevice::WriteOnly));
    look.write("LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    look.close();
    s.workspace.select({});
    QTimer::singleShot(300, this, [&] {
      auto* const dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      dialog->findChild<QLineEdit*>()->setText(look.fileName());
      QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
    });
    s.panel.findChild<QToolButton*>("file_view")->click();
    QVERIFY2(s.text().contains("view \"looks/swap.cube\"\n"), qPrintable(s.text()));
    QVERIFY(s.workspace.document().scene().appearance.grade.table);
  }

  // Without a selection, the panel has the settings of the film; each is a line.
  void the_film_has_settings() {
    Shown s("# a film\nrate 25\ncreate ball sphere\nball.position.x\n  1f 0\n  50f 2\n");
    s.workspace.select({});
    const auto box = [&](const char* verb) -> QComboBox& {
      return *s.panel.findChild<QComboBox*>(QString("film_") + verb);
    };
    QCOMPARE(box("rate").currentText(), "25");
    QCOMPARE(box("range").currentText(), "1f 50f");
    QVERIFY(box("size").currentText().isEmpty());
    s.type(*box("size").lineEdit(), "640x360");
    QTest::keyClick(&box("size"), Qt::Key_Return);
    QVERIFY2(s.text().contains("size 640x360\n"), qPrintable(s.text()));
    s.type(*box("size").lineEdit(), "320x180");
    QTest::keyClick(&box("size"), Qt::Key_Return);
    QCOMPARE(s.text().count("size "), 1);  // it replaces the earlier one
    box("sky").setCurrentText("on");
    emit box("sky").activated(0);
    QVERIFY(s.workspace.document().scene().appearance.sky);
    s.type(*box("rate").lineEdit(), "30");
    QTest::keyClick(&box("rate"), Qt::Key_Return);
    QVERIFY(s.text().startsWith("# a film\nrate 30\n"));
    const QString text = s.text();
    s.type(*box("exposure").lineEdit(), "much");
    QTest::keyClick(&box("exposure"), Qt::Key_Return);
    QCOMPARE(s.text(), text);
    QVERIFY(box("exposure").currentText().isEmpty());  // it is back
    for (int k = 0; k < 4; ++k) s.workspace.undo();
    QVERIFY(!s.workspace.document().scene().appearance.sky);
    QVERIFY(box("sky").currentText().isEmpty());
    s.select("ball");
    QVERIFY(!box("rate").isVisible());
  }

  void frames_need_no_unit_in_the_range() {
    Shown s("rate 24\ncreate ball sphere\n");
    s.workspace.select({});
    auto& range = *s.panel.findChild<QComboBox*>("film_range");
    for (const auto& [typed, line] :
         {std::pair("48", "range 1f 48f"), {"5 40", "range 5f 40f"}, {"60", "range 5f 60f"}}) {
      s.type(*range.lineEdit(), typed);
      QTest::keyClick(&range, Qt::Key_Return);
      QVERIFY2(s.text().contains(line), qPrintable(s.text()));
    }
  }

  // Auto-key is of all panels.
  void auto_key_makes_events_here_too() {
    Shown s("rate 24\nrange 1f 48f\ncreate ball sphere\n");
    s.workspace.set_makes_events(true);
    s.type(s.at("position", "x"), "2");
    QTest::keyClick(&s.at("position", "x"), Qt::Key_Return);
    s.workspace.go_to(s.at_time("48f"));
    s.type(s.at("position", "x"), "5");
    QTest::keyClick(&s.at("position", "x"), Qt::Key_Return);
    QCOMPARE(s.events_of("ball.position"), std::size_t{2});
    s.workspace.go_to(s.at_time("14f"));
    s.type(s.at("position", "y"), "1");
    QTest::keyClick(&s.at("position", "y"), Qt::Key_Return);
    const Vec3 p = std::get<Vec3>(s.value("ball.position"));
    QVERIFY(std::abs(p.x * 1e6 - std::round(p.x * 1e6)) < 1e-6);  // no more digits than one can see
    s.workspace.set_makes_events(false);
  }

  void what_is_wrong_changes_nothing() {
    Shown s("create ball sphere radius=2\n");
    s.type(s.at("radius"), "much");
    QCOMPARE(s.text(), "create ball sphere radius=2\n");
    QCOMPARE(s.at("radius").text(), "2");
  }

  void a_number_is_dragged_and_called_off() {
    Shown s("create ball sphere radius=2\n");
    s.drag(s.at("radius"), 40, false);
    QVERIFY(s.workspace.looks_ahead());
    QCOMPARE(s.radius("ball"), 2.2);  // 20 steps of a hundredth
    QCOMPARE(s.text(), "create ball sphere radius=2\n");
    QTest::keyClick(&s.at("radius"), Qt::Key_Escape);
    QVERIFY(!s.workspace.looks_ahead());
    QCOMPARE(s.radius("ball"), 2.0);
    QTest::mouseRelease(&s.at("radius"), Qt::LeftButton);
    QCOMPARE(s.text(), "create ball sphere radius=2\n");
    s.drag(s.at("radius"), 40);
    QCOMPARE(s.text(), "create ball sphere radius=2.2\n");
    s.workspace.undo();  // one step
    QCOMPARE(s.text(), "create ball sphere radius=2\n");
  }

  void a_component_leaves_the_others() {
    Shown s("create ball sphere position=(1 2 3)\n");
    s.type(s.at("position", "y"), "7");
    QCOMPARE(s.text(), "create ball sphere position=(1 7 3)\n");
    s.type(s.at("rotation", "z"), "90");
    QCOMPARE(s.value("ball.rotation"), Value(Angles{{0, 0, pi / 2}}));
  }

  void where_events_are_an_event_is_made() {
    Shown s("create ball sphere\nball.radius\n  1f 1\n  25f 3\n");
    s.workspace.go_to(s.at_time("13f"));
    QCOMPARE(s.at("radius").text().toDouble(), 2.0);
    QCOMPARE(s.made("radius"), "between 1f and 25f");
    s.type(s.at("radius"), "5");
    QCOMPARE(s.text(), "create ball sphere\nball.radius\n  1f 1\n  13f 5 auto\n  25f 3\n");
    QCOMPARE(s.made("radius"), "event here");
  }

  void the_diamond_makes_and_clears() {
    Shown s("create ball sphere radius=2\n");
    s.workspace.go_to(s.at_time("13f"));
    QTest::mouseClick(&s.diamond("radius"), Qt::LeftButton);
    QCOMPARE(s.made("radius"), "event here");
    QCOMPARE(s.events_of("ball.radius"), std::size_t{1});
    QCOMPARE(s.radius("ball"), 2.0);
    QTest::mouseClick(&s.diamond("radius"), Qt::LeftButton);
    QCOMPARE(s.events_of("ball.radius"), std::size_t{0});
    s.workspace.undo(), s.workspace.undo();
    QCOMPARE(s.text(), "create ball sphere radius=2\n");
  }

  void all_that_are_selected_are_changed_in_one_step() {
    Shown s("create ball sphere radius=2 position=(1 0 0)\ncreate car box position=(5 0 0)\n", "car");
    s.workspace.select({s.id("car"), s.id("ball")});
    s.type(s.at("radius"), "4");  // the box has none
    QCOMPARE(s.radius("ball"), 4.0);
    s.type(s.at("position", "y"), "3");
    QCOMPARE(s.value("ball.position"), Value(Vec3{1, 3, 0}));
    QCOMPARE(s.value("car.position"), Value(Vec3{5, 3, 0}));
    s.workspace.undo();
    QCOMPARE(s.value("ball.position"), Value(Vec3{1, 0, 0}));
    QCOMPARE(s.value("car.position"), Value(Vec3{5, 0, 0}));
  }

  void booleans_choices_texts_colours_and_objects() {
    Shown s("create ball sphere\ncreate car box\ncreate title text text=\"hi\"\n");
    QTest::mouseClick(&s.at<QCheckBox>("display"), Qt::LeftButton, {}, {8, s.at<QCheckBox>("display").height() / 2});
    QCOMPARE(s.value("ball.display"), Value(false));
    auto& material = s.at<QComboBox>("material");
    material.setFocus();
    QTest::keyClicks(&material, "met");
    QTest::keyClick(&material, Qt::Key_Return);
    s.type(s.at<QLineEdit>("color"), "rgb(1 0.5 0)");
    QCOMPARE(s.value("ball.color"), Value(Color{1, 0.5, 0}));
    s.type(*s.at<QComboBox>("geometry").lineEdit(), "car");
    QCOMPARE(s.value("ball.geometry"), Value(s.id("car")));
    s.type(*s.at<QComboBox>("look-at").lineEdit(), "(1 2 3)");
    QCOMPARE(s.value("ball.look-at"), Value(Vec3{1, 2, 3}));
    s.select("title");
    s.type(s.at<QLineEdit>("text"), "say \\\"so\\\"");
    QCOMPARE(*std::get<Text>(s.value("title.text")), std::string("say \"so\""));
  }

  void it_is_hung_on_another() {
    Shown s("create ball sphere position=(1 0 0)\ncreate car box position=(5 0 0)\n");
    s.type(*s.at<QComboBox>("attachment").lineEdit(), "car");
    const auto spans = attachments(s.workspace.document(), s.id("ball"));
    QVERIFY(!spans.empty());
    QCOMPARE(spans.back().to.parent, s.id("car"));
    QCOMPARE(spans.back().to.kind, AttachmentKind::couple);
  }

  void code_is_shown_and_not_changed() {
    Shown s("create ball sphere\nset ball.radius = \"1 + t\"\n");
    QVERIFY(s.panel.findChild<ValueEditor*>("radius")->findChild<QLabel*>("value"));
    QCOMPARE(s.made("radius"), "code");
    QCOMPARE(s.panel.findChild<QLabel*>("made_radius")->toolTip(), "1 + t");
  }

  void the_films_own_functions_are_there() {
    Shown s("define wobble number 3\ncreate ball sphere\n");
    s.type(s.at("wobble"), "4");
    QCOMPARE(s.value("ball.wobble"), Value(4.0));
  }

  void it_is_renamed() {
    Shown s("create ball sphere\nhide ball\n");
    s.type(*s.panel.findChild<QLineEdit*>("name"), "globe");
    QCOMPARE(s.workspace.document().names(), std::vector<std::string>{"globe"});
    QCOMPARE(s.panel.findChild<QLineEdit*>("name")->text(), "globe");
  }

  void widgets_stay_while_it_plays() {
    Shown s("create ball sphere\nball.radius\n  1f 1\n  25f 3\n");
    NumberField* before = &s.at("radius");
    for (int f = 1; f < 25; ++f) s.workspace.go_to(s.workspace.document().rate().frame(f));
    QCOMPARE(&s.at("radius"), before);
    QVERIFY(before->text().startsWith("2.9"));
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::PropertiesTest)
#include "properties_test.moc"
