// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Does the exercises of the course with the mouse and keys alone, and counts the actions: a click, a drag, a key.
#include <QtTest/QtTest>
#include <QtWidgets>
#include <functional>

#include "betwixt/language.h"
#include "betwixt/pick.h"
#include "real_hands.h"
#include "studio/course/course_panel.h"
#include "studio/panels/outliner.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/timeline/ruler.h"
#include "studio/timeline/sheet_pane.h"
#include "studio/viewport/hand.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {

class CourseHandsTest : public QObject {
  Q_OBJECT

  Workspace workspace_;
  std::unique_ptr<Window> window_;
  std::unique_ptr<Hands> hands_;
  int actions_ = 0, typed_ = 0;

  CoursePanel& course() { return *static_cast<CoursePanel*>(window_->panel("course")); }
  template <class W>
  W& part(const QString& name) {
    auto* found = window_->findChild<W*>(name);
    if (!found) qFatal("there is no %s", qPrintable(name));
    return *found;
  }

  void click(QWidget& on, QPoint at, Qt::MouseButton button = Qt::LeftButton) {
    ++actions_;
    hands_->click(on, at, {}, button);
  }
  void drag(QWidget& on, QPoint from, QPoint to) {
    ++actions_;
    hands_->drag(on, from, to);
  }
  void key(QWidget& on, const QString& k) {
    ++actions_;
    hands_->move(on, on.rect().center());
    hands_->key(k);
  }

  // Opens a menu by `open`, and clicks through its rows.
  void choose(QStringList rows, const std::function<void()>& open) {
    auto* look = new QTimer(this);
    QPointer<QWidget> before;
    connect(look, &QTimer::timeout, this, [=, this]() mutable {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (!menu || menu == before || !menu->windowHandle() || !menu->windowHandle()->isExposed()) return;
      before = menu;
      const QString row = rows.takeFirst();
      if (rows.isEmpty()) look->stop(), look->deleteLater();
      for (QAction* a : menu->actions())
        if (a->text().section('\t', 0, 0) == row) {
          if (!a->font().bold()) qFatal("%s is not marked", qPrintable(row));
          return click(*menu, menu->actionGeometry(a).center());
        }
      qFatal("the menu has no %s", qPrintable(row));
    });
    look->start(10);
    open();
    if (!QTest::qWaitFor([&] { return !QApplication::activePopupWidget() && rows.size() < 100; }))
      qFatal("a menu stays");
  }

  QPoint in_tree(const QString& name) {
    auto& tree = part<OutlinerTree>("outliner_tree");
    const ObjectId id = workspace_.document().find(name.toStdString());
    return tree.visualRect(static_cast<OutlinerModel*>(tree.model())->index_of(id)).center();
  }
  QPoint in_picture(Vec3 place) { return window_->viewport().scope().spot(place)->toPoint(); }

  // Drags a handle of the selection, as a condition such as `value ball.position.y > 2` needs it.
  void drag_handle(const QString& condition) {
    const QStringList words = condition.split(' ');
    const QString name = words[1].section('.', 0, 0), function = words[1].section('.', 1, 1);
    const int axis = QString("xyz").indexOf(words[1].section('.', 2));
    const bool up = words[2] == ">";
    const Hand hand(workspace_.program(), workspace_.time(), workspace_.selected(), false);
    const Scope scope = window_->viewport().scope();
    const Vec3 place = hand.place();
    const double pixel = scope.metres(scope.depth(place));
    Vec3 along{};
    along[axis] = 1;
    if (function == "rotation") {  // the blue ring, by 40 degrees
      const auto at = [&](double degrees) {
        const double a = degrees * std::numbers::pi / 180;
        return in_picture(place + 80 * pixel * Vec3{std::cos(a), std::sin(a), 0});
      };
      const double now = 10;
      const double by = up ? 40 : -80;
      QWidget& on = window_->viewport();
      ++actions_;
      hands_->move(on, at(now)), hands_->press(on, at(now));
      for (int i = 1; i <= 8; ++i) hands_->move(on, at(now + by * i / 8));
      return hands_->release(on, at(now + by));
    }
    const auto target = find_targets(words[1].toStdString(), workspace_.document());
    const double now = std::get<double>(workspace_.program().read(target->front(), workspace_.time()));
    const double wanted = words[3].toDouble() + (up ? 1 : -1) * (function == "scale" ? 0.15 : 0.4);
    // A handle of scale is 80 pixels from the middle at a scale of 1.
    const double pixels = function == "scale" ? 80 * (wanted / now - 1) : (wanted - now) / pixel;
    drag(window_->viewport(), in_picture(place + 70 * pixel * along),
         in_picture(place + (70 + pixels) * pixel * along));
  }

  // What a place needs, unless `otherwise` knows better.
  void act(const CourseStep& step) {
    const QStringList parts = QString::fromStdString(with_names(step.point, workspace_)).split(" > ");
    const QStringList words = parts[0].split(' ');
    const QStringList rows = parts.mid(1);
    auto& sheet = part<SheetPane>("sheet_pane");
    const auto time = [&](const QString& t) { return *parse_time(t.toStdString(), workspace_.document()); };
    if (words[0] == "widget" || words[0] == "diamond") {
      auto& widget = part<QWidget>(words[0] == "diamond" ? "diamond_" + words[1] : words[1]);
      return rows.isEmpty() ? click(widget, widget.rect().center())
                            : choose(rows, [&] { click(widget, widget.rect().center()); });
    }
    if (words[0] == "menu") {
      QMenuBar& bar = *window_->menuBar();
      const QPoint at = bar.actionGeometry(bar.findChild<QMenu*>(words[1])->menuAction()).center();
      return choose(rows, [&] { click(bar, at); });
    }
    if (words[0] == "frame") {
      auto& ruler = part<Ruler>("ruler");
      return click(ruler, {qRound(ruler.x_of(time(words[1]))), 5});
    }
    if (words[0] == "event") {
      const auto target = find_targets(words[1].toStdString(), workspace_.document())->front();
      for (std::size_t i = 0; i < sheet.rows().size(); ++i)
        if (!sheet.rows()[i].whole && sheet.rows()[i].object == target.object &&
            sheet.rows()[i].target.function == target.function)
          return choose(rows, [&] { click(sheet, sheet.place(i, time(words[2])).toPoint(), Qt::RightButton); });
      qFatal("the sheet has no %s", qPrintable(words[1]));
    }
    if (words[0] == "row") return click(*part<OutlinerTree>("outliner_tree").viewport(), in_tree(words[1]));
    if (words[0] == "object") {
      for (const std::string& condition : step.until) {
        const QString until = QString::fromStdString(with_names(condition, workspace_));
        if (until.startsWith("value")) return drag_handle(until);
      }
      const ObjectId id = workspace_.document().find(words[1].toStdString());
      for (const Item& item : window_->viewport().frame().items)
        if (item.id == id) return click(window_->viewport(), in_picture(translation_of(item.world)));
    }
    qFatal("how is this done: %s", step.words.c_str());
  }

  // Does all steps of an exercise. `otherwise`: what to do in steps whose sentences contain these words.
  void carry_out(std::size_t exercise, const std::map<QString, std::function<void()>>& otherwise = {}) {
    workspace_.open("", Session::Earlier::discard);
    course().begin(exercise);
    actions_ = typed_ = 0;
    while (course().step()) {
      const std::size_t i = course().step_number();
      const CourseStep& step = *course().step();
      const QString sentence = QString::fromStdString(step.words);
      QCoreApplication::processEvents();
      const auto special =
          std::ranges::find_if(otherwise, [&](const auto& row) { return sentence.contains(row.first); });
      special == otherwise.end() ? act(step) : special->second();
      QTRY_VERIFY2(course().step_number() > i, qPrintable(sentence + "\n" + QString::fromStdString(workspace_.text())));
      if (const QString folder = qEnvironmentVariable("BETWIXT_COURSE_PICTURES"); !folder.isEmpty()) {
        window_->viewport().await_picture();
        window_->grab().save(QString("%1/%2-%3.png").arg(folder).arg(exercise).arg(i, 2, 10, QChar('0')));
      }
    }
    workspace_.pause();
    QVERIFY(workspace_.diagnostics().empty());
    qInfo("%s: %d actions, %d letters typed", exercises()[exercise].name.c_str(), actions_, typed_);
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    set_theme(*qApp, Theme::dark);
    window_ = std::make_unique<Window>(workspace_);
    hands_ = hands_on(*window_);
    QVERIFY(hands_);
    window_->show_panel("course");
  }

  // A ball that bounces, with squash and stretch, a camera, a light and a twin: no key is needed, and no word is typed.
  void aBallBounces() {
    carry_out(0);
    QVERIFY2(actions_ <= 40, qPrintable(QString::number(actions_)));
    const Document& d = workspace_.document();
    const Program& p = workspace_.program();
    const ObjectId twin = d.find("sphere2");
    QVERIFY(twin);
    const auto height = [&](const char* of, double frame) {
      return std::get<Vec3>(p.read(find_targets(of, d)->front(), d.rate().frame(frame))).y;
    };
    QVERIFY(height("sphere1.position", 1) > 2.2);
    QVERIFY(height("sphere1.position", 13) < 1.4);
    QCOMPARE(height("sphere1.position", 25), height("sphere1.position", 1));
    QVERIFY(height("sphere1.scale", 13) < 1 && height("sphere1.scale", 11) > 1);
    QCOMPARE(height("sphere2.position", 10), height("sphere1.position", 10));
  }

  void aPendulumSwings() {
    carry_out(1, {{"drag the weight onto the rod",
                   [&] { drag(*part<OutlinerTree>("outliner_tree").viewport(), in_tree("weight"), in_tree("rod")); }}});
    QVERIFY2(actions_ <= 20, qPrintable(QString::number(actions_)));
  }

  void aManWalks() {
    auto& sheet = part<SheetPane>("sheet_pane");
    carry_out(2, {{"drag a box",
                   [&] {
                     const Time first = workspace_.document().rate().frame(1),
                                last = workspace_.document().rate().frame(13);
                     drag(sheet, sheet.place(1, first).toPoint() - QPoint(9, 6),
                          sheet.place(1, last).toPoint() + QPoint(9, 6));
                   }},
                  {"{Copy events}",
                   [&] {
                     key(sheet, "Ctrl+C");
                     click(*part<OutlinerTree>("outliner_tree").viewport(), in_tree("man/left-leg"));
                   }},
                  {"{Paste at playhead}", [&] { key(sheet, "Ctrl+V"); }},
                  {"{Insert event at playhead}", [&] { key(window_->viewport(), "K"); }}});
    QVERIFY2(actions_ <= 40, qPrintable(QString::number(actions_)));
  }

  void aHandTakesABall() {
    QWidget& tree = *part<OutlinerTree>("outliner_tree").viewport();
    carry_out(3, {{"drag the ball onto the hand", [&] { drag(tree, in_tree("ball"), in_tree("hand")); }},
                  {"empty place", [&] {
                     drag(tree, in_tree("ball"), {tree.width() / 2, tree.height() - 5});
                   }}});
    QVERIFY2(actions_ <= 15, qPrintable(QString::number(actions_)));
  }

  void aTitleFliesIn() {
    const auto editor = [&](const char* name) -> QWidget& {
      return *window_->panel("properties")->findChild<QWidget*>(name);
    };
    carry_out(4, {{"Write a word",
                   [&] {
                     const auto field = [&]() -> QWidget& { return *editor("text").findChild<QLineEdit*>("value"); };
                     QTRY_VERIFY(window_->panel("properties")->findChild<QWidget*>("text"));
                     QTRY_VERIFY(!field().visibleRegion().isEmpty());
                     click(field(), field().rect().center());
                     key(field(), "Ctrl+A");
                     hands_->type("Hello"), typed_ += 5;
                     key(field(), "Return");
                   }},
                  {"Choose a weight",
                   [&] {
                     auto& box = *editor("weight").findChild<QComboBox*>("value");
                     click(box, box.rect().center());
                     QVERIFY(QTest::qWaitForWindowExposed(box.view()->window()));
                     const QModelIndex bold = box.model()->index(box.findText("bold"), 0);
                     click(*box.view()->viewport(), box.view()->visualRect(bold).center());
                   }},
                  {"Click the swatch",
                   [&] {
                     QWidget& swatch = *editor("color").findChild<QWidget*>("swatch");
                     click(swatch, swatch.rect().center());
                     auto& dialog = *window_->findChild<QColorDialog*>();
                     QVERIFY(QTest::qWaitForWindowExposed(&dialog));
                     dialog.setCurrentColor(Qt::yellow);
                     QWidget& done = *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
                     click(done, done.rect().center());
                   }},
                  {"{Insert event at playhead}", [&] { key(window_->viewport(), "K"); }}});
    QVERIFY2(actions_ <= 30, qPrintable(QString::number(actions_)));
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::CourseHandsTest)
#include "course_hands_test.moc"
