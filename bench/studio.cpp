// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how quickly the studio answers: pictures a second during playback, and the time from a key in the script or
// a mouse move over the ruler to the picture with the result. Prints the median, the 99th percentile and the maximum.
//   bench_studio [--type | --scrub] FILE… (of films without a file: 10000 moving things, a million events; --type: only
//   keys; --scrub: only a hand on the ruler of the given files, in a window of 1920x1080)
#include <fmt/format.h>

#include <QTest>
#include <QtWidgets>
#include <algorithm>
#include <random>

#include "betwixt/language.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/views.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

using Clock = std::chrono::steady_clock;
double milliseconds(Clock::duration d) { return 1e3 * std::chrono::duration<double>(d).count(); }

void print(const char* what, std::vector<double> all) {
  std::ranges::sort(all);
  const auto at = [&](double share) {
    return all[std::min(all.size() - 1, static_cast<std::size_t>(share * static_cast<double>(all.size())))];
  };
  fmt::print("  {:28} p50 {:8.1f}  p99 {:8.1f}  most {:8.1f} ms  of {}\n", what, at(0.5), at(0.99), all.back(),
             all.size());
}

std::string many_things() {
  std::string text = "range 1f 240f\ncreate eye camera position=(50 60 160) look-at=(50 0 -50)\n";
  for (int i = 0; i < 10'000; ++i)
    text += fmt::format("create b{} box size=(0.6 0.6 0.6) color=#{:06x}\n", i, (i * 7919) & 0xffffff);
  for (int i = 0; i < 10'000; ++i)
    text += fmt::format("b{}.position\n  1f ({} 0 {})\n  {}f ({} 3 {})\n  240f ({} 0 {})\n", i, i % 100, -(i / 100),
                        60 + i % 120, i % 100, -(i / 100), i % 100, -(i / 100));
  return text;
}
std::string many_events() {
  std::mt19937 random(5);
  std::string text = "range 1f 2000f\ncreate eye camera position=(16 10 60) look-at=(16 0 -16)\n";
  for (int i = 0; i < 1000; ++i) text += fmt::format("create b{} sphere radius=0.2\n", i);
  for (int i = 0; i < 1000; ++i) {
    text += fmt::format("b{}.position\n", i);
    for (int k = 0; k < 1000; ++k)
      text += fmt::format("  {}f ({} {:.3f} {})\n", 1 + 2 * k, i % 32, 1e-3 * static_cast<double>(random() % 1000),
                          -(i / 32));
  }
  return text;
}

class Trial {
 public:
  explicit Trial(const std::string& file) : window_(workspace_) {
    window_.resize(1280, 800);
    window_.show();
    QObject::connect(&window_.viewport(), &Viewport::picture_came, [this](const PictureMade& m) { came_ = m; });
    if (!workspace_.open(QString::fromStdString(file))) throw std::runtime_error(workspace_.last_said());
    window_.viewport().await_picture();
    QApplication::processEvents();
  }

  void play(double seconds) {
    int pictures = 0;
    const auto counting = QObject::connect(&window_.viewport(), &Viewport::picture_came, [&] { ++pictures; });
    workspace_.play(1);
    const auto begun = Clock::now();
    std::vector<double> late;
    while (milliseconds(Clock::now() - begun) < 1e3 * seconds)
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    const double took = 1e-3 * milliseconds(Clock::now() - begun);
    workspace_.pause();
    QObject::disconnect(counting);
    fmt::print("  {:28} {:.1f} pictures a second of {:.0f}; the playhead went {:.2f} s in {:.2f} s\n", "playing",
               pictures / took, workspace_.document().rate().per_second(), took, took);
  }

  void scrub(int moves) {
    QWidget* ruler = window_.panel("timeline")->findChild<QWidget*>("ruler");
    if (!ruler) return fmt::print("  there is no ruler\n");
    std::vector<double> all;
    const int y = 8;
    QTest::mousePress(ruler, Qt::LeftButton, {}, {ruler->width() / 4, y});
    for (int i = 0; i < moves; ++i) {
      const Time before = workspace_.time();
      const int x = ruler->width() / 4 + (i * 37) % (ruler->width() / 2);
      const auto begun = Clock::now();
      QTest::mouseMove(ruler, {x, y});
      if (workspace_.time() == before) continue;
      until([&] { return came_ && came_->time == workspace_.time(); });
      all.push_back(milliseconds(Clock::now() - begun));
    }
    QTest::mouseRelease(ruler, Qt::LeftButton, {}, {ruler->width() / 4, y});
    if (!all.empty()) print("mouse to picture, scrubbing", all);
  }

  void show_four() { window_.views().set_four(true), QApplication::processEvents(); }
  // The hand moves 125 times a second, whether there are pictures or not, and rests once a second.
  void scrub_freely(int moves) {
    window_.resize(1920, 1080);
    window_.viewport().await_picture();
    QWidget* ruler = window_.panel("timeline")->findChild<QWidget*>("ruler");
    const auto middle = window_.viewport().size();
    std::map<Time, Clock::time_point> moved;  // when the hand was there first since its picture came
    std::vector<double> all, gaps;
    std::optional<Clock::time_point> before;
    const auto counting = QObject::connect(&window_.viewport(), &Viewport::picture_came, [&](const PictureMade& m) {
      const auto now = Clock::now();
      const auto at = moved.find(m.time);
      if (at == moved.end()) return;  // a finer picture of the same time
      all.push_back(milliseconds(now - at->second));
      if (before) gaps.push_back(milliseconds(now - *before));
      before = now;
      moved.clear();
    });
    const int y = 8;
    const auto wait = [](int ms) {
      QEventLoop loop;
      QTimer::singleShot(ms, Qt::PreciseTimer, &loop, &QEventLoop::quit);
      loop.exec();
    };
    QTest::mousePress(ruler, Qt::LeftButton, {}, {ruler->width() / 4, y});
    for (int i = 0; i < moves; ++i) {
      const Time was = workspace_.time();
      QTest::mouseMove(ruler, {ruler->width() / 4 + (i * 3) % (ruler->width() / 2), y});
      if (workspace_.time() != was) moved.try_emplace(workspace_.time(), Clock::now());
      wait(8);
      if (i % 125 == 124) wait(1000), before.reset(), moved.clear();
    }
    QTest::mouseRelease(ruler, Qt::LeftButton, {}, {ruler->width() / 4, y});
    QObject::disconnect(counting);
    fmt::print("  picture of {}x{}\n", middle.width(), middle.height());
    if (!all.empty()) print("hand to picture", all);
    if (!gaps.empty()) print("picture to picture", gaps);
    came_.reset();
    workspace_.step(1);
    const auto stopped = Clock::now();
    const int wide = window_.viewport().frame_box().width();
    until([&] { return came_ && came_->image.width() >= wide && !came_->draft; });
    fmt::print("  {:28} {:.0f} ms after one step\n", "the whole picture", milliseconds(Clock::now() - stopped));
  }

  void type(int keys) {
    auto* editor = window_.panel("script_panel")->findChild<QPlainTextEdit*>();
    window_.show_panel("script_panel");
    QApplication::processEvents();
    // A number in an event row in the middle of the text.
    until([&] { return !editor->isReadOnly(); });  // a long text fills it part by part
    const QString text = editor->toPlainText();
    const int row = static_cast<int>(text.indexOf("f (", text.size() / 2)) + 3;
    QTextCursor c = editor->textCursor();
    c.setPosition(row);
    editor->setTextCursor(c);
    std::vector<double> all, read;
    int changes = 0;
    auto changed = Clock::now();
    QObject::connect(&workspace_, &Workspace::document_changed, &window_, [&] { ++changes, changed = Clock::now(); });
    const std::size_t size = workspace_.text().size();
    for (int i = 0; i < keys; ++i) {
      const int before = changes;
      const std::size_t typed = size + (i % 2 == 0 ? 1 : 0);  // what was typed earlier may settle meanwhile
      const auto begun = Clock::now();
      QTest::keyClick(editor, i % 2 == 0 ? Qt::Key_1 : Qt::Key_Backspace);
      until([&] {
        return changes > before && workspace_.text().size() == typed && came_ && came_->program &&
               &came_->program->compiled() == &workspace_.program().compiled();
      });
      all.push_back(milliseconds(Clock::now() - begun));
      read.push_back(milliseconds(changed - begun));
    }
    print("key in the script to film", read);
    print("key in the script to picture", all);
    const auto begun = Clock::now();
    workspace_.settle_typing();
    fmt::print("  {:28} {:.1f} ms\n", "what was typed is one step", milliseconds(Clock::now() - begun));
  }

  void drag(int moves) {
    const auto events_of = [&](ObjectId id) { return tracks(workspace_.document(), id); };
    for (const ObjectId id : objects(workspace_.document())) {
      if (events_of(id).empty() || events_of(id)[0].target.component >= 0) continue;
      const TrackView t = events_of(id)[0];
      const std::string at = workspace_.when(t.first), name = workspace_.document().name(t.target);
      std::vector<double> all;
      for (int i = 0; i < moves; ++i) {
        const auto begun = Clock::now();
        if (!workspace_.look_ahead({fmt::format("move {} {}..{} by -{}f", name, at, at, 1 + i % 2)})) return;
        until(
            [&] { return came_ && came_->program && &came_->program->compiled() == &workspace_.program().compiled(); });
        all.push_back(milliseconds(Clock::now() - begun));
      }
      print("an event dragged, to picture", all);
      const auto begun = Clock::now();
      workspace_.say(fmt::format("move {} {}..{} by -1f", name, at, at));
      fmt::print("  {:28} {:.1f} ms\n", "let go: said, and in its row", milliseconds(Clock::now() - begun));
      return;
    }
  }

 private:
  template <class Done>
  static void until(Done&& done) {
    QTimer wakes;  // processEvents() with a limit of time would poll, and take one of the cores
    wakes.start(100);
    for (const auto end = Clock::now() + std::chrono::seconds(20); !done() && Clock::now() < end;)
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }

  Workspace workspace_;
  Window window_;
  std::optional<PictureMade> came_;
};

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
  QApplication app(argc, argv);
  set_theme(app, Theme::dark);
  QTemporaryDir folder;
  const auto put = [&](const char* name, const std::string& text) {
    QFile file(folder.filePath(name));
    if (file.open(QIODevice::WriteOnly)) file.write(text.data(), static_cast<qint64>(text.size()));
    return file.fileName().toStdString();
  };
  std::vector<std::string> files(argv + 1, argv + argc);
  const bool all = std::erase(files, "--type") == 0, scrubs = std::erase(files, "--scrub") > 0;
  if (!scrubs) {
    files.push_back(put("ten-thousand-things.bx", many_things()));
    files.push_back(put("million-events.bx", many_events()));
  }
  for (const std::string& file : files) {
    const auto begun = Clock::now();
    Trial trial(file);
    fmt::print("{}: opened in {:.0f} ms\n", QFileInfo(QString::fromStdString(file)).fileName().toStdString(),
               milliseconds(Clock::now() - begun));
    if (scrubs) {
      trial.scrub_freely(500);
      trial.show_four();
      trial.scrub_freely(500);
      std::fflush(stdout);
      continue;
    }
    if (all) trial.play(8), trial.scrub(120), trial.drag(60);
    trial.type(60);
    std::fflush(stdout);
  }
}
