// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Works on a film in the studio's window with mouse and keys, from its first object to the question when the window
// closes. The whole script is compared each time. The chapters run in order, and each continues with the result of the
// one before.
#include <QTabBar>
#include <functional>

#include "betwixt/language.h"
#include "real_hands.h"
#include "studio/panels/outliner.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/timeline/ruler.h"
#include "studio/timeline/sheet_pane.h"
#include "studio/viewport/picture_maker.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

const std::string head = R"(# A man takes a ball.
rate 24
range 1f 73f
create eye camera position=(0 0 14)
create man group
create man/arm box size=(2 0.5 0.5) position=(1 1 0)
create man/leg box size=(0.5 2 0.5) position=(0 -1 0)
)";
// How the man moves, at these frames, with his arm so high.
std::string man(const std::string& first, const std::string& middle, const std::string& last, int high = 2) {
  const std::string arm = "(1 " + std::to_string(high) + " 0)";
  return "\nman.position  # he walks\n  " + first + "f (0 0 0)\n  " + last + "f (2 0 0)\n\nman/arm.position\n  " +
         first + "f (1 1 0)\n  " + middle + "f " + arm + "  # up\n  " + last + "f (1 1 0)\nman/leg.position\n  " +
         first + "f (0 -1 0)\n  " + middle + "f (0 -1 1)\n  " + last + "f (0 -1 0)\n";
}
std::string replaced(std::string in, const std::string& what, const std::string& by) {
  const std::size_t at = in.find(what);
  return at == std::string::npos ? "" : in.replace(at, what.size(), by);
}
const std::string film = head + man("1", "13", "25");
const std::string ball = "create ball sphere radius=0.5 color=gold position=(-4 2 0)\n";

}  // namespace

class Story : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  Workspace workspace_;
  std::unique_ptr<Window> window_;
  std::unique_ptr<Hands> hands_;
  QImage picture_;
  int steps_ = 0;  // that were done: as many undos lead back
  std::string before_, end_;

  // ---- where things are
  template <class W>
  W& part(const char* name) {
    auto* found = window_->findChild<W*>(name);
    if (!found) qFatal("there is no %s", name);
    return *found;
  }
  SheetPane& sheet() { return part<SheetPane>("sheet_pane"); }
  QPlainTextEdit& script() { return part<QPlainTextEdit>("script"); }
  OutlinerTree& tree() { return part<OutlinerTree>("outliner_tree"); }
  Time frame(double n) const { return workspace_.document().rate().frame(n); }
  ObjectId id(const char* name) const { return workspace_.document().find(name); }
  QPoint in_ruler(double n) { return {qRound(part<Ruler>("ruler").x_of(frame(n))), 5}; }
  QPoint in_sheet(std::size_t row, double n) { return sheet().place(row, frame(n)).toPoint(); }
  QPoint in_tree(const char* name) {
    return tree().visualRect(static_cast<OutlinerModel*>(tree().model())->index_of(id(name))).center();
  }
  QPoint in_picture(Vec3 place) { return window_->viewport().scope().spot(place)->toPoint(); }
  void raise(const QString& panel) {
    for (QTabBar* tabs : window_->findChildren<QTabBar*>())
      for (int i = 0; i < tabs->count(); ++i)
        if (tabs->tabText(i) == panel) return hands_->click(*tabs, tabs->tabRect(i).center());
    qFatal("no tab leads to %s", qPrintable(panel));
  }

  // ---- what is so
  std::string in_file(const char* name) const {
    QFile f(folder_.filePath(name));
    return f.open(QIODevice::ReadOnly) ? f.readAll().toStdString() : "";
  }
  std::string selected() const {
    std::string all;
    for (const ObjectId i : workspace_.selected()) all += (all.empty() ? "" : " ") + workspace_.name(i);
    return all;
  }
  Value value(const char* of, double n) const {
    return workspace_.program().read(find_targets(of, workspace_.document())->front(), frame(n));
  }
  // The text, the film that is made of it, what the script panel shows.
  void is(const std::string& text) {
    const std::string now = workspace_.text();  // a failure prints what differs
    const auto same = std::mismatch(now.begin(), now.end(), text.begin(), text.end());
    QCOMPARE(QString::fromStdString({same.first, now.end()}), QString::fromStdString({same.second, text.end()}));
    QVERIFY(workspace_.document() == load_text(text, "expected").document);
    QCOMPARE(script().toPlainText().toStdString(), text);
    QVERIFY(workspace_.diagnostics().empty());
  }
  // The picture becomes the one that is made of a text by itself.
  void shows(const std::string& text, double n) {
    const QSize size = window_->viewport().scope().box.size().toSize() * window_->devicePixelRatioF();
    RenderOptions o;
    o.width = size.width(), o.height = size.height(), o.style = window_->viewport().style();
    const Program program = Program::compile(load_text(text, "expected").document);
    const QImage expected = PictureMaker::make({program, frame(n), o, {}}).image;
    QVERIFY(!expected.isNull());
    QTRY_COMPARE(picture_, expected);
  }
  void scrub(double from, double to) { hands_->drag(part<Ruler>("ruler"), in_ruler(from), in_ruler(to)); }
  // Whoever asks next, a dialog or a menu, is answered so: they wait, and so does who has called them.
  template <class W>
  void when_asked(std::function<void(W&)> answer) {
    auto* look = new QTimer(this);
    connect(look, &QTimer::timeout, this, [look, answer] {
      QWidget* menu = QApplication::activePopupWidget();
      auto* asks = qobject_cast<W*>(menu ? menu : QApplication::activeModalWidget());
      if (!asks || !asks->windowHandle() || !asks->windowHandle()->isExposed()) return;
      look->stop(), look->deleteLater();
      answer(*asks);
    });
    look->start(20);
  }
  void answer(const QString& word) {
    when_asked<QMessageBox>([this, word](QMessageBox& box) {
      for (QAbstractButton* b : box.buttons())
        if (b->text() == word) return hands_->click(*b);
      qFatal("the answers are others");
    });
  }
  void choose(QMenu& menu, const QString& row) {
    for (QAction* a : menu.actions())
      if (a->text().section('\t', 0, 0) == row) return hands_->click(menu, menu.actionGeometry(a).center());
    qFatal("the menu has no %s", qPrintable(row));
  }

 private Q_SLOTS:
  void initTestCase() {
    qInfo("on %s", qPrintable(QGuiApplication::platformName()));
    set_theme(*qApp, Theme::dark);
    QFile f(folder_.filePath("film.bx"));
    QVERIFY(f.open(QIODevice::WriteOnly));
    f.write(QByteArray::fromStdString(film)), f.close();
    window_ = std::make_unique<Window>(workspace_);
    connect(&workspace_, &Workspace::said, this, [this](const QString& line, const QString&, bool refused) {
      if (!refused && line != "undo" && line != "redo") ++steps_;
    });
    connect(&window_->viewport(), &Viewport::picture_came, this, [this](const PictureMade& p) { picture_ = p.image; });
    QVERIFY(workspace_.open(f.fileName()));
    steps_ = 0;
    hands_ = hands_on(*window_);
    QVERIFY(hands_);
    is(film);
    shows(film, 1);
  }

  void a_ball_is_made_in_the_console() {
    hands_->click(part<QPlainTextEdit>("console_line").viewport()[0]);
    hands_->type(QString::fromStdString(ball).trimmed());
    hands_->key("Return");
    is(before_ = film + ball);
    shows(before_, 1);
  }

  // K, then G with a number, where the playhead is.
  void it_gets_events() {
    hands_->click(window_->viewport(), in_picture({-4, 2, 0}));
    QCOMPARE(selected(), "ball");
    hands_->key("K");
    is(before_ += "at 1f ball.position (-4 2 0) auto\n");
    scrub(8, 25);
    QCOMPARE(workspace_.time(), frame(25));
    hands_->key("Ctrl+1");
    hands_->type("gx3");
    QVERIFY(workspace_.looks_ahead());
    QCOMPARE(value("ball.position", 25), Value(Vec3{-1, 2, 0}));
    hands_->key("Return");
    // Two events are a sheet.
    is(before_ = replaced(before_, "at 1f ball.position (-4 2 0) auto\n",
                          "ball.position\n  1f (-4 2 0) auto\n  25f (-1 2 0) auto\n"));
    shows(workspace_.text(), 25);
  }

  void its_scale_gets_one_in_the_properties() {
    raise("Properties");
    hands_->click(part<QToolButton>("diamond_scale"));
    const std::string so_far = before_;
    is(so_far + "at 25f ball.scale (1 1 1) auto\n");
    QLineEdit& y = *part<QWidget>("scale").findChild<QLineEdit*>("y");
    hands_->click(y);
    hands_->key("Ctrl+A");
    hands_->type("2");
    hands_->key("Return");
    is(so_far + "at 25f ball.scale (1 2 1) auto\n");
    QCOMPARE(value("ball.scale", 40), Value(Vec3{1, 2, 1}));
  }

  void a_key_is_dragged_in_the_sheet() {
    QCOMPARE(sheet().rows().size(), std::size_t(3));  // ball, position, scale
    hands_->drag(sheet(), in_sheet(1, 25), in_sheet(1, 37));
    is(before_ = replaced(before_, "  25f (-1", "  37f (-1") + "at 25f ball.scale (1 2 1) auto\n");
    QCOMPARE(value("ball.position", 37), Value(Vec3{-1, 2, 0}));
  }

  // Escape while the mouse is down.
  void what_is_called_off_changes_nothing() {
    const QPoint in_air = in_picture(std::get<Vec3>(value("ball.position", 25)));
    const std::tuple<QWidget&, QPoint, QPoint> ways[] = {
        {sheet(), in_sheet(1, 37), in_sheet(1, 50)},
        {window_->viewport(), in_air, in_air + QPoint(60, 40)},
    };
    for (const auto& [on, from, to] : ways) {
      hands_->press(on, from);
      hands_->move(on, (from + to) / 2);
      hands_->move(on, to);
      QVERIFY(workspace_.looks_ahead());
      QVERIFY(workspace_.document() != load_text(before_, "expected").document);
      hands_->key("Escape");
      is(before_);
      hands_->release(on, to);
      is(before_);
      QCOMPARE(selected(), "ball");
    }
  }

  void a_double_click_writes_an_event() {
    hands_->double_click(sheet(), in_sheet(2, 25));
    QCOMPARE(part<QLineEdit>("event_words").text(), "(1 2 1) auto");
    hands_->type("(1 1.5 1) hold");
    hands_->key("Return");
    is(before_ = replaced(before_, "(1 2 1) auto", "(1 1.5 1) hold"));
  }

  void menus_do_what_keys_do() {
    QMenuBar& bar = *window_->menuBar();
    auto& edit = *bar.findChild<QMenu*>("Edit");
    for (const char* row : {"Undo", "Redo"}) {
      hands_->click(bar, bar.actionGeometry(edit.menuAction()).center());
      QVERIFY(QTest::qWaitForWindowExposed(&edit));
      choose(edit, row);
      QTRY_VERIFY(!edit.isVisible());
      is(row == std::string("Undo") ? replaced(before_, "(1 1.5 1) hold", "(1 2 1) auto") : before_);
    }
    when_asked<QMenu>([this](QMenu& menu) { choose(menu, "Delete"); });
    hands_->click(sheet(), in_sheet(1, 37), {}, Qt::RightButton);
    QTRY_VERIFY(!QApplication::activePopupWidget());
    is(replaced(before_, "  37f (-1 2 0) auto\n", ""));
    hands_->key("Ctrl+Z");
    is(before_);
    steps_ -= 1;  // it is not done again
  }

  void a_line_is_said_where_commands_are_found() {
    when_asked<QDialog>([this](QDialog&) {
      hands_->type("set ball.color red");
      hands_->key("Return");
    });
    hands_->key("Ctrl+Shift+P");
    QTRY_VERIFY(!QApplication::activeModalWidget());
    is(before_ = replaced(before_, "color=gold", "color=red"));
  }

  void it_plays_and_stops() {
    hands_->key("Ctrl+1");
    hands_->key("Space");
    QTRY_VERIFY(workspace_.time() != frame(25));
    QVERIFY(workspace_.playhead().playing());
    hands_->key("Space");
    QVERIFY(!workspace_.playhead().playing());
    is(before_);
  }

  void it_is_taken_and_let_go() {
    hands_->click(part<QPlainTextEdit>("console_line").viewport()[0]);
    hands_->type("at 49f attach ball to man/arm keep-world");
    hands_->key("Return");
    is(before_ += "at 49f attach ball to man/arm keep-world\n");
    scrub(30, 61);
    hands_->drag(*tree().viewport(), in_tree("ball"),
                 {tree().viewport()->width() / 2, tree().viewport()->height() - 9});
    is(before_ += "at 61f letgo ball\n");
    const auto spans = attachments(workspace_.document(), id("ball"));
    QCOMPARE(spans.back().from, frame(61));
    QCOMPARE(spans.back().to.kind, AttachmentKind::letgo);
  }

  // One number in a row: the film and the picture follow at once.
  void the_script_is_typed() {
    scrub(61, 13);
    raise("Script");
    QTextCursor c = script().document()->find("(1 2 0)");
    c.setPosition(c.selectionStart() + 4);
    hands_->click(*script().viewport(), script().cursorRect(c).center());
    QCOMPARE(selected(), "man/arm");
    hands_->key("Shift+Left");
    hands_->type("5");
    before_ = head + man("1", "13", "25", 5) + before_.substr(film.size());
    is(before_);
    QCOMPARE(value("man/arm.position", 13), Value(Vec3{1, 5, 0}));
    shows(before_, 13);
    QTRY_COMPARE(workspace_.session().text(), before_);  // when typing rests
  }

  // All that a man does, in one go, with another beginning and at another pace.
  void a_whole_man_is_retimed() {
    hands_->click(*tree().viewport(), in_tree("man"));
    hands_->click(*tree().viewport(), in_tree("man/arm"), Qt::ControlModifier);
    hands_->click(*tree().viewport(), in_tree("man/leg"), Qt::ControlModifier);
    QCOMPARE(selected(), "man man/arm man/leg");
    QCOMPARE(sheet().rows().size(), std::size_t(6));
    hands_->drag(sheet(), in_sheet(0, 1) - QPoint(15, 0), in_sheet(5, 25) + QPoint(15, 3));
    QCOMPARE(workspace_.events_selected().size(), std::size_t(8));
    const std::string rest = before_.substr(film.size());
    const QRectF box = *sheet().box();
    const QPoint side(qRound(box.right()), qRound(box.center().y()) + 2);
    const int steps = steps_;
    hands_->drag(sheet(), side, side + QPoint(in_sheet(0, 49).x() - in_sheet(0, 25).x(), 0));
    is(head + man("1", "25", "49", 5) + rest);
    hands_->drag(sheet(), in_sheet(3, 25), in_sheet(3, 37));
    is(end_ = head + man("13", "37", "61", 5) + rest);
    QCOMPARE(steps_, steps + 2);
    hands_->key("Ctrl+Z");
    is(head + man("1", "25", "49", 5) + rest);
    hands_->key("Ctrl+Z");
    is(before_);
    hands_->key("Ctrl+Shift+Z");
    hands_->key("Ctrl+Shift+Z");
    is(end_);
  }

  void all_of_it_is_undone_and_done_again() {
    for (int i = 0; i < steps_; ++i) {
      QVERIFY(workspace_.text() != film);
      hands_->key("Ctrl+Z");
    }
    is(film);
    shows(film, 13);
    for (int i = 0; i < steps_; ++i) hands_->key("Ctrl+Y");
    is(end_);
    shows(end_, 13);
  }

  // What is looked at stays where it was.
  void it_gets_another_name() {
    const int x = in_ruler(61).x();
    window_->viewport().set_free(true);
    const QString second = folder_.filePath("second.bx");
    when_asked<QFileDialog>([this, second](QFileDialog&) {
      hands_->key("Ctrl+A");
      hands_->type(second);
      hands_->key("Return");
    });
    hands_->key("Ctrl+Shift+S");
    QTRY_VERIFY(!QApplication::activeModalWidget());
    QCOMPARE(in_file("second.bx"), end_);
    QCOMPARE(in_file("film.bx"), film);
    QVERIFY(window_->windowTitle().startsWith("second.bx"));
    QCOMPARE(in_ruler(61).x(), x);
    QCOMPARE(workspace_.time(), frame(13));
    QVERIFY(window_->viewport().is_free());
    is(end_);
  }

  void the_door_asks() {
    hands_->click(part<QPlainTextEdit>("console_line").viewport()[0]);
    hands_->type("set ball.radius 1");
    hands_->key("Return");
    const std::string saved = std::exchange(end_, replaced(end_, "radius=0.5", "radius=1"));
    is(end_);
    answer("Stay");
    hands_->key("Ctrl+Q");
    QApplication::processEvents();
    QVERIFY(window_->isVisible());
    is(end_);
    QCOMPARE(in_file("second.bx"), saved);
    answer("Save");
    hands_->key("Ctrl+Q");
    QTRY_VERIFY(!window_->isVisible());
    QCOMPARE(in_file("second.bx"), end_);
    QCOMPARE(in_file("film.bx"), film);
    QVERIFY(load_file(folder_.filePath("second.bx").toStdString()).document == workspace_.document());
    QCOMPARE(QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden), (QStringList{"film.bx", "second.bx"}));
  }

  void cleanupTestCase() { hands_.reset(), window_.reset(); }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::Story)
#include "story_test.moc"
