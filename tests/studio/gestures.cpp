// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A long session of random input in the whole window: lines, clicks, drags, keys, typing. Then undoes all of it, redoes
// it, saves and loads the film. Run it under the address sanitizer. It takes long, so ./test does not run it.
//   studio_gestures [COUNT] [SEED] [FILE]
#include <fmt/format.h>

#include <QTest>
#include <QtWidgets>
#include <random>

#include "betwixt/language.h"
#include "studio/panels/new_parts.h"
#include "studio/panels/value_parts.h"
#include "studio/shell/actions.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/key_types.h"
#include "studio/timeline/ripple.h"
#include "studio/timeline/simplified.h"
#include "studio/viewport/viewport.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const char* const film =
    "rate 24\nrange 1f 72f\n"
    "create eye camera position=(0 3 14) look-at=(0 1 0)\n"
    "create ball sphere radius=0.5 color=gold  # round\ncreate hand box\ncreate g{1..4} box position=(i*1.2-3 0 -2)\n"
    "layer sway add\n"
    "ball.position\n  1f (0 0 0)\n  12f (2 3 0) linear # up\n  24f (4 0 0) ease-in=4f\n\n"
    "hand.rotation\n  1f (0 0 0)\n  48f (0 90deg 0)\n"
    "g*.position.y\n  1f 0\n  24f 2\n  48f 0\n"
    "at 24f attach ball to hand keep-world\nat 48f letgo ball\n"
    "filter hand.rotation smooth over=3f\n"
    "on sway ball.position\n  6f (0 0.5 0)\n  9f (0 0 0)\n"
    "at 30f note \"taken\"\n";

class Hands {
 public:
  Hands(Workspace& workspace, Window& window, unsigned seed) : workspace_(workspace), window_(window), random_(seed) {}

  void do_something() {
    switch (below(11)) {
      case 0:
      case 1:
      case 2:
        return say();
      case 3:
      case 4:
        return drag();
      case 5:
        return click();
      case 6:
      case 7:
        return press();
      case 8:
        return type();
      case 9:
        return act();
      default:
        return look();
    }
  }
  // Any action that asks nothing and keeps the film open; or what windows with a slider or a curve would do.
  void act() {
    static const std::vector<const ActionRow*> rows = [] {
      constexpr std::string_view not_these[] = {"New", "Save", "Save as…", "Quit", "Open an example", "All keys"};
      std::vector<const ActionRow*> all;
      for (const ActionRow& row : action_rows())
        if (!row.name.ends_with("…") && std::ranges::find(not_these, row.name) == std::end(not_these))
          all.push_back(&row);
      return all;
    }();
    const std::size_t which = below(static_cast<unsigned>(rows.size()) + 7);
    if (which < rows.size()) {
      last_ = fmt::format("action {}", rows[which]->name);
      return rows[which]->run(window_);
    }
    last_ = fmt::format("dialog {}", which - rows.size());
    EventActions& events = EventActions::of(workspace_);
    if (which == rows.size()) return (void)workspace_.say(events.breakdown(0.1 * below(12)));
    if (which == rows.size() + 1) return events.warp([](double u) { return u * u; });
    if (which == rows.size() + 2) return add_part();
    if (which == rows.size() + 4) return change_handles();
    if (which == rows.size() + 5) return simplify();
    if (which == rows.size() + 3) return change_part_of_value();
    workspace_.say(
        insert_time_lines(workspace_.document(), workspace_.time(), workspace_.document().rate().span(1 + below(20))));
  }
  const std::string& last() const { return last_; }

 private:
  unsigned below(unsigned n) { return random_() % n; }
  std::optional<Target> some_function() {
    const Document& d = workspace_.document();
    if (workspace_.selected().empty()) return std::nullopt;
    const auto all = functions(d, workspace_.selected().back());
    // Mostly the first ones, such as the position: only there is something to change.
    return Target(workspace_.selected().back(), all[below(pick({3u, static_cast<unsigned>(all.size())}))].id);
  }
  void add_part() {
    const auto on = some_function();
    if (!on) return;
    const auto all = new_parts(workspace_.document(), workspace_.program(), {*on}, workspace_.time());
    if (!all.empty()) workspace_.say(all[below(static_cast<unsigned>(all.size()))].lines);
  }
  void change_handles() {
    const KeyType type = key_types()[below(static_cast<unsigned>(key_types().size()))].type;
    workspace_.say(key_type_lines(workspace_.document(), workspace_.events_selected(), type));
  }
  void simplify() {
    const Document& d = workspace_.document();
    workspace_.say(clear_lines(d, simplified(d, workspace_.events_selected(), 0.02 * below(20)).gone));
  }
  void change_part_of_value() {
    const auto on = some_function();
    if (!on) return;
    const Document& d = workspace_.document();
    const std::string text = workspace_.text();
    const auto all = value_parts(d, workspace_.program(), text, *on, workspace_.time());
    if (all.empty()) return;
    const std::size_t from = below(static_cast<unsigned>(all.size())), to = below(static_cast<unsigned>(all.size()));
    const ValuePart& a = all[from];
    Lines lines = below(2)   ? switch_part(d, text, a)
                  : below(2) ? remove_part(d, text, a)
                             : move_part(d, text, all, from, to);
    if (below(2) && !a.fields.empty())
      lines = change_part(d, text, a, a.fields.back(), 0, std::to_string(1 + below(3)), workspace_.time());
    if (!lines.empty()) workspace_.say(lines);
  }
  template <class T>
  T pick(std::initializer_list<T> all) {
    return *(all.begin() + below(static_cast<unsigned>(all.size())));
  }
  std::string frame() { return fmt::format("{}f", 1 + below(72)); }
  std::string vector() { return fmt::format("({} {} {})", below(7), below(4), below(5)); }

  void say() {
    const std::string t =
        pick({"ball.position", "hand.rotation", "g*.position.y", "g2.position", "ball.scale", "hand.position"});
    const std::string o = pick({"ball", "hand", "g1", "g2", "g*", "g{2..3}"});
    const std::string made = fmt::format("n{}", below(30));
    std::string line;
    switch (below(18)) {
      case 0:
        line = fmt::format("at {} ball.position {} {}", frame(), vector(),
                           pick({"", "hold", "linear", "smooth", "bounce-out"}));
        break;
      case 1:
        line = fmt::format("set {}.color {}", o, pick({"red", "gold", "#336699"}));
        break;
      case 2:
        line = fmt::format("move {} 1f..{} by {}f", t, frame(), static_cast<int>(below(9)) - 4);
        break;
      case 3:
        line = fmt::format("stretch {} 1f..{} by {}", t, frame(), pick({"2", "0.5", "1.5"}));
        break;
      case 4:
        line = fmt::format("reverse {} 1f..{}", t, frame());
        break;
      case 5:
        line = fmt::format("clear {} {}", t, frame());
        break;
      case 6:
        line = fmt::format("copy {} 1f..12f to {}", t, frame());
        break;
      case 7:
        line = fmt::format("create {} {}", made, pick({"sphere", "box", "cone", "text", "light", "camera"}));
        break;
      case 8:
        line = fmt::format("remove {}", made);
        break;
      case 9:
        line = fmt::format("rename {} n{}", made, below(30));
        break;
      case 10:
        line = fmt::format("at {} {} {} to hand keep-world", frame(), pick({"attach", "couple"}), pick({"ball", "g1"}));
        break;
      case 11:
        line = fmt::format("at {} letgo ball", frame());
        break;
      case 12:
        line = fmt::format("filter {} {}", t, pick({"smooth over=4f", "delay by=2f", "none", "noise"}));
        break;
      case 13:
        line = fmt::format("on sway at {} ball.position {}", frame(), vector());
        break;
      case 14:
        line = fmt::format("at {} note \"{}\"", frame(), below(100));
        break;
      case 15:
        line = fmt::format("{} {}", pick({"hide", "show"}), o);
        break;
      case 16:
        line = pick({"undo", "redo", "undo", "help sphere", "list", "nonsense here", "describe ball"});
        break;
      case 17:
        line = fmt::format("twerper {} {}", t, pick({"linear", "smooth", "none"}));
        break;
    }
    last_ = "say " + line;
    workspace_.say(line);
  }

  QWidget* widget() {
    QList<QWidget*> all;
    for (const char* name :
         {"viewport", "outliner", "timeline", "sheet", "curves", "properties", "console", "script_panel", "assets"})
      if (QWidget* panel = name == std::string("viewport") ? &window_.viewport() : window_.panel(name);
          panel && panel->isVisible()) {
        all << panel;
        for (QWidget* w : panel->findChildren<QWidget*>())
          if (w->isVisible() && w->isEnabled()) all << w;
      }
    return all.isEmpty() ? nullptr : all[static_cast<int>(below(static_cast<unsigned>(all.size())))];
  }
  QPoint place(QWidget* w) {
    return {static_cast<int>(below(static_cast<unsigned>(std::max(1, w->width())))),
            static_cast<int>(below(static_cast<unsigned>(std::max(1, w->height()))))};
  }
  Qt::KeyboardModifiers modifiers() {
    return pick<Qt::KeyboardModifiers>(
        {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier});
  }

  void click() {
    QPointer<QWidget> w = widget();
    if (!w) return;
    last_ = "click " + name(w);
    const auto button = pick({Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton});
    below(4) == 0 ? QTest::mouseDClick(w, button, modifiers(), place(w))
                  : QTest::mouseClick(w, button, modifiers(), place(w));
  }
  void drag() {
    QPointer<QWidget> w = widget();
    if (!w) return;
    last_ = "drag " + name(w);
    const auto button = pick({Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton});
    const auto with = modifiers();
    QTest::mousePress(w, button, with, place(w));
    for (unsigned n = 1 + below(4); n > 0 && w; --n) QTest::mouseMove(w, place(w));
    if (w && below(6) == 0) QTest::keyClick(w, Qt::Key_Escape);
    if (w) QTest::mouseRelease(w, button, with, place(w));
  }
  void press() {
    QPointer<QWidget> w = widget();
    if (!w) return;
    w->setFocus();
    const int key = below(3) == 0
                        ? pick({Qt::Key_Return, Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,
                                Qt::Key_Down, Qt::Key_Home, Qt::Key_End, Qt::Key_Tab, Qt::Key_Space, Qt::Key_Backspace})
                        : static_cast<int>(Qt::Key_A + below(26));
    auto with = modifiers();
    if ((with & Qt::ControlModifier) && (key == Qt::Key_Q || key == Qt::Key_S || key == Qt::Key_R))
      with = Qt::NoModifier;
    last_ = fmt::format("press {:x} on {}", key, name(w));
    QTest::keyClick(w, static_cast<Qt::Key>(key), with);
  }
  void type() {
    auto* editor = window_.panel("script_panel")->findChild<QPlainTextEdit*>();
    if (!editor) return;
    last_ = "type";
    QTextCursor c = editor->textCursor();
    c.setPosition(
        static_cast<int>(below(static_cast<unsigned>(std::max(1, editor->document()->characterCount() - 1)))));
    editor->setTextCursor(c);
    for (unsigned n = 1 + below(4); n > 0; --n) {
      const auto what = below(5);
      what == 0   ? QTest::keyClick(editor, Qt::Key_Backspace)
      : what == 1 ? QTest::keyClick(editor, Qt::Key_Return)
                  : QTest::keyClicks(editor, pick({QString("1"), QString(" "), QString("("), QString("ball"),
                                                   QString("2f"), QString("\"")}));
    }
  }
  void look() {
    last_ = "look";
    switch (below(5)) {
      case 0:
        workspace_.go_to(workspace_.document().rate().frame(1 + below(72)));
        break;
      case 1:
        workspace_.play(pick({1, -1}));
        break;
      case 2:
        workspace_.pause();
        break;
      case 3:
        if (const auto all = objects(workspace_.document()); !all.empty())
          workspace_.select({all[below(static_cast<unsigned>(all.size()))]});
        break;
      case 4:
        window_.set_layout(Window::layouts()[static_cast<int>(below(4))]);
        break;
    }
  }
  static std::string name(QWidget* w) {
    std::string out = w->metaObject()->className();
    for (; w; w = w->parentWidget())
      if (!w->objectName().isEmpty()) return out + " of " + w->objectName().toStdString();
    return out;
  }

  Workspace& workspace_;
  Window& window_;
  std::mt19937 random_;
  std::string last_;
};

// The first line in which two films, written down, are not the same.
std::string difference(const Document& film, const Document& text) {
  const QStringList a = QString::fromStdString(write(film)).split('\n'),
                    b = QString::fromStdString(write(text)).split('\n');
  for (int i = 0; i < std::max(a.size(), b.size()); ++i)
    if (a.value(i) != b.value(i))
      return fmt::format("the film has\n  {}\nthe text makes\n  {}\n", a.value(i).toStdString(),
                         b.value(i).toStdString());
  return "written down they are the same\n";
}

int complain(const std::string& what) {
  fmt::print("FAILED: {}\n", what);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  QApplication app(argc, argv);
  set_theme(app, Theme::dark);
  const int count = argc > 1 ? std::atoi(argv[1]) : 10'000;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  QTemporaryDir folder;
  const QString name = folder.filePath("film.bx");
  {
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly)) return 3;
    file.write(film);
  }
  Workspace workspace;
  Window window(workspace);
  workspace.ask = [](const Session::Question&) { return std::string("stay"); };
  window.resize(1400, 900);
  window.show();
  if (!workspace.open(name)) return complain(workspace.last_said());
  const Document first = workspace.session().document();
  // Whatever opens beside the window is closed again.
  QTimer closes;
  QObject::connect(&closes, &QTimer::timeout, [] {
    if (QWidget* w = QApplication::activePopupWidget()) w->close();
    if (QWidget* w = QApplication::activeModalWidget()) w->close();
  });
  closes.start(5);
  Hands hands(workspace, window, seed);
  for (int i = 0; i < count; ++i) {
    hands.do_something();
    QApplication::processEvents();
    if (!window.isVisible()) window.show();
    if (i % 10 == 0) {
      workspace.settle_typing();
      if (!(load_text(workspace.text(), name.toStdString()).document == workspace.session().document()))
        return complain(fmt::format(
            "after {} gestures ({}) the text is another film: {}\n{}", i, hands.last(),
            difference(workspace.session().document(), load_text(workspace.text(), name.toStdString()).document),
            workspace.text()));
    }
    if (i % 1000 == 999)
      fmt::print("{} gestures, {} steps to undo, {} bytes of script\n", i + 1, workspace.session().unsaved(),
                 workspace.text().size()),
          std::fflush(stdout);
  }
  workspace.pause();
  workspace.settle_typing();
  const Document last = workspace.session().document();
  const std::string text = workspace.text();
  std::size_t undone = 0;
  while (workspace.session().enter("undo").done) ++undone;
  if (workspace.session().text() != film)
    return complain("undone, the text is not the first one:\n" + workspace.session().text());
  if (!(workspace.session().document() == first)) return complain("undone, the film is not the first one");
  for (std::size_t i = 0; i < undone; ++i)
    if (!workspace.session().enter("redo").done) return complain("a step cannot be done again");
  if (workspace.session().text() != text || !(workspace.session().document() == last))
    return complain("done again, it is not the last one");
  if (!workspace.say(std::string("save"))) return complain("it cannot be saved: " + workspace.last_said());
  if (!(load_file(name.toStdString()).document == last)) return complain("saved and loaded, it is another film");
  fmt::print("{} gestures with seed {}: {} steps undone to the first film, done again, saved and loaded\n", count, seed,
             undone);
  return 0;
}
