// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt-studio: the program that `betwixt studio` and `betwixt play` start if there is a display.
#include <QApplication>
#include <QCommandLineParser>
#include <QDockWidget>
#include <QFile>
#include <QSettings>
#include <QToolButton>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>

#include "base/tell_user.h"
#include "betwixt/language.h"
#include "studio/course/film_chooser.h"
#include "studio/shell/export_dialog.h"
#include "studio/shell/films.h"
#include "studio/shell/preferences.h"
#include "studio/shell/preferences_window.h"
#include "studio/shell/sound.h"
#include "studio/shell/theme.h"
#include "studio/shell/words.h"
#include "studio/viewport/views.h"

namespace {

// Carries out the lines of a recorded session. Prints an error and returns false if the file or a line fails.
bool play_back(betwixt::studio::Workspace& workspace, const QString& name) {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) {
    betwixt::tell_user("betwixt: error: '" + name.toStdString() + "' cannot be read\n");
    return false;
  }
  std::string line;
  for (const QString& part : QString::fromUtf8(file.readAll()).split('\n')) {
    line += (line.empty() ? "" : "\n") + part.toStdString();
    if (betwixt::Session::needs_more(line)) continue;
    if (!line.empty() && !workspace.say(line) && !workspace.last_said().empty()) {
      betwixt::tell_user(workspace.last_said());
      return false;
    }
    line.clear();
  }
  return true;
}

// Returns the picture of one panel, of the given size if it is not empty. "columns" is the exposure sheet, "export" the
// export dialog, "new" the films to begin with, and "preferences", "appearance" and "keys" are pages of the
// preferences. Returns a null pixmap if there is no such panel.
QPixmap picture_of(betwixt::studio::Window& window, const QString& name, QSize size) {
  using namespace betwixt::studio;
  if (name == "picture") return window.viewport().grab();
  std::unique_ptr<QDialog> dialog;
  if (name == "export") dialog = std::make_unique<ExportDialog>(window.workspace());
  if (name == "preferences" || name == "appearance" || name == "keys") {
    auto own = std::make_unique<PreferencesWindow>();
    own->turn_to(name == "keys" ? "Keyboard" : name == "appearance" ? "Appearance" : "General");
    dialog = std::move(own);
  }
  if (dialog) {
    dialog->resize(size.isEmpty() ? dialog->sizeHint() : size);
    dialog->show();
    QApplication::processEvents();
    return dialog->grab();
  }
  if (name == "new") {
    auto* chooser = new FilmChooser({}, &window);
    if (!size.isEmpty()) chooser->resize(size);
    chooser->show();
    chooser->await_pictures();
    return chooser->grab();
  }
  QWidget* panel = window.panel(name == "columns" ? "sheet" : name == "script" ? "script_panel" : name);
  if (!panel) return {};
  if (name == "columns") panel->findChild<QToolButton*>("columns")->setChecked(true);
  auto* dock = qobject_cast<QDockWidget*>(panel->parentWidget());
  dock->setTitleBarWidget(new QWidget(dock));
  dock->setFloating(true), dock->show();
  const QSize around = dock->size() - panel->size();
  dock->resize((size.isEmpty() ? panel->sizeHint() : size) + around);
  QApplication::processEvents();
  QApplication::processEvents();  // a second pass, for layouts changed by the first
  return panel->grab();
}

// The film that was open last, if its file is still there.
QString last_film() {
  for (const QString& file : QSettings("betwixt", "studio").value("recent").toStringList())
    if (QFile::exists(file)) return file;
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  using namespace betwixt;
  using namespace betwixt::studio;
  // A screenshot and the help need no display.
  for (const std::string_view word : std::span(argv, static_cast<std::size_t>(argc)))
    if (word.starts_with("--screenshot") || word == "--help" || word == "-h") qputenv("QT_QPA_PLATFORM", "offscreen");
  // Hides Qt's notices, which concern only developers. Without a display Qt would abort.
  if (!qEnvironmentVariableIsSet("BETWIXT_TOOLKIT_SAYS"))
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& words) {
      if (type == QtFatalMsg && words.contains("platform plugin")) {
        betwixt::tell_user(
            "betwixt: error: the studio needs a display: set DISPLAY, or save a picture of the window: "
            "--screenshot OUT.png\n");
        std::_Exit(3);
      }
      if (type == QtCriticalMsg || type == QtFatalMsg) std::fprintf(stderr, "betwixt: %s\n", qPrintable(words));
    });
  // Pass no arguments to Qt, which would take --session and --style as its own.
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  int own = 1;
  QApplication app(own, argv);
  QApplication::setApplicationName("betwixt-studio");
  QGuiApplication::setDesktopFileName("betwixt");  // the desktop shows its icon
  QCommandLineParser line;
  line.addPositionalArgument("FILE", "the script; each further one gets a tab");
  line.addOptions({{"screenshot", "saves a screenshot of the window and ends", "OUT.png"},
                   {"at", "the time of the playhead", "TIME"},
                   {"layout", "the arrangement of the panels", "NAME"},
                   {"size", "the size of the window or of the panel", "WxH"},
                   {"select", "the selected objects", "PATTERN"},
                   {"panel", "saves a screenshot of one panel only", "NAME"},
                   {"session", "a file with lines to run first", "FILE"},
                   {"style", "the style of the picture", "NAME"},
                   {"light", "light colours"},
                   {"bare", "a window that only plays the film"},
                   {"loop", "plays in a loop"},
                   {"mute", "plays without sound"},
                   {"recover", "recovers the unsaved commands of an earlier session"},
                   {"discard", "discards the unsaved commands of an earlier session"},
                   {"read-anywhere", "lets the script read files outside its own folder"},
                   {"tex", "lets latex typeset the formulas"},
                   {"let", "another value for a let of the script", "NAME=VALUE"},
                   {"language", "the catalogue of its texts", "FILE"},
                   {"load", "a plug-in", "PLUGIN"}});
  line.addHelpOption();
  line.process(arguments);
  const auto refuse = [](const std::string& why) { return betwixt::tell_user("betwixt: error: " + why + "\n"), 2; };
  for (const QString& plugin : line.values("load"))
    if (const Status s = use_plugin(plugin.toStdString()); !s) return refuse(s.error().message);
  LoadOptions options;
  options.read_anywhere = line.isSet("read-anywhere"), options.tex = line.isSet("tex");
  for (const QString& let : line.values("let"))
    options.lets.push_back({let.section('=', 0, 0).toStdString(), let.section('=', 1).toStdString()});
  if (line.isSet("language")) options.language = line.value("language").toStdString();
  const bool shows_only = line.isSet("screenshot");
  set_theme(app, line.isSet("light") ? Theme::light : Theme::dark);
  Preferences& user = Preferences::of_user();
  if (!shows_only) user.recall();
  use_language(wanted_language());
  Films films(options, {.bare = line.isSet("bare"), .remembers = !shows_only});
  Window& window = films.current();
  Workspace& workspace = window.workspace();
  if (line.isSet("light")) window.set_light(true);
  // Shows the window while a long film is still loading.
  QObject::connect(&workspace.jobs(), &BackgroundJobs::takes_long, &window, [&] {
    if (!shows_only) films.show();
  });
  QString file = line.positionalArguments().value(0);
  if (file.isEmpty() && user.word("start") == "last") file = last_film();
  const auto earlier = line.isSet("recover")               ? Session::Earlier::recover
                       : line.isSet("discard")             ? Session::Earlier::discard
                       : user.word("earlier") == "recover" ? Session::Earlier::recover
                       : user.word("earlier") == "discard" ? Session::Earlier::discard
                                                           : Session::Earlier::ask;
  if (!workspace.open(file, earlier)) {
    betwixt::tell_user(workspace.last_said());
    // If the user will decide later about unsaved work, the window stays, with a new film.
    const bool asked = films.isVisible() && !file.isEmpty();
    if (!asked || !workspace.open("", Session::Earlier::ask)) return 1;
  }
  const bool begins = file.isEmpty() && workspace.session().unsaved() == 0 && user.word("start") != "empty";
  if (begins) window.open_example();
  if (line.isSet("style")) window.viewport().set_style(line.value("style").toStdString());
  QSize size;
  if (line.isSet("size")) {
    const QStringList wh = line.value("size").split('x');
    size = {wh.value(0).toInt(), wh.value(1).toInt()};
    if (size.width() < 100 || size.height() < 100 || size.width() > 16384 || size.height() > 16384)
      return refuse("--size: expected a size such as 1280x800");
    if (!line.isSet("panel") || line.value("panel") == "picture")
      films.resize(size), window.resize(size);  // its layout needs the size before it is shown
  }
  if (line.isSet("layout") && !window.set_layout(line.value("layout")))
    return refuse("there is no layout '" + line.value("layout").toStdString() +
                  "': " + Window::layouts().join(", ").toStdString());
  if (line.isSet("session") && !play_back(workspace, line.value("session"))) return 1;
  if (line.isSet("at")) {
    const Result<Time> at = parse_time(line.value("at").toStdString(), workspace.document());
    if (!at) return refuse("--at: " + at.error().message);
    workspace.go_to(*at);
  }
  if (line.isSet("select")) {
    const auto found = find_targets(line.value("select").toStdString() + ".position", workspace.document());
    if (!found) return refuse("--select: " + found.error().message);
    std::vector<ObjectId> objects;
    for (const Target& t : *found) objects.push_back(t.object);
    workspace.select(objects);
  }
  films.show();
  if (shows_only) {
    if (line.isSet("layout")) window.set_layout(line.value("layout"));  // its shares are relative to this size
    QApplication::processEvents();
    for (Viewport* view : window.views().all()) view->await_picture();
    QApplication::processEvents();
    const QString out = line.value("screenshot"), panel = line.value("panel");
    const QPixmap picture = panel.isEmpty() ? films.grab() : picture_of(window, panel, size);
    if (picture.isNull()) return refuse("there is no panel '" + panel.toStdString() + "'");
    return picture.save(out) ? 0
                             : (std::fprintf(stderr, "betwixt: error: '%s' cannot be written\n", qPrintable(out)), 3);
  }
  if (line.isSet("bare")) workspace.playhead().loop(line.isSet("loop"));
  if (line.isSet("mute")) window.sound().mute(true);
  if (line.isSet("bare")) workspace.play(1);
  if (file.isEmpty() && !line.isSet("bare")) films.recover_others(earlier);
  for (const QString& other : line.positionalArguments().mid(1)) films.open(other);
  if (begins && !line.isSet("bare") && !line.isSet("session")) window.new_film();
  // Another language needs other windows; the film, its undo and the playhead stay.
  QObject::connect(
      &user, &Preferences::changed, &app,
      [&](const QString& name) {
        if (name != "language") return;
        use_language(wanted_language());
        films.current().remember();
        films.speak_anew();
        films.current().show_preferences("General");
      },
      Qt::QueuedConnection);
  return QApplication::exec();
}
