// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/window.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QShortcut>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "base/files.h"
#include "studio/assets/asset_panel.h"
#include "studio/course/course_panel.h"
#include "studio/curves/curves.h"
#include "studio/objects/creating.h"
#include "studio/panels/data_panel.h"
#include "studio/panels/history_panel.h"
#include "studio/panels/live_panel.h"
#include "studio/panels/outliner.h"
#include "studio/panels/properties.h"
#include "studio/panels/server_panel.h"
#include "studio/poses/pose_panel.h"
#include "studio/script/script_panel.h"
#include "studio/shell/actions.h"
#include "studio/shell/asking.h"
#include "studio/shell/console.h"
#include "studio/shell/control_names.h"
#include "studio/shell/export_dialog.h"
#include "studio/shell/films.h"
#include "studio/shell/key_focus.h"
#include "studio/shell/keys.h"
#include "studio/shell/preferences.h"
#include "studio/shell/sound.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"
#include "studio/timeline/sheet.h"
#include "studio/timeline/timeline.h"
#include "studio/viewport/views.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

constexpr int recent_files = 10;

// Returns whether a layout shows a panel.
bool in_layout(const QString& layout, const QString& panel) {
  return (layout == "all" && panel != "live" && panel != "server" && panel != "course") || panel == "timeline" ||
         (layout == "live" && (panel == "live" || panel == "server")) ||
         (layout == "animate" && (panel == "sheet" || panel == "curves" || panel == "outliner" || panel == "poses")) ||
         (layout == "script" && (panel == "script_panel" || panel == "console"));
}

// Gives all text the size that the user wants, and returns it.
double text_size_of_user() {
  const double size = Preferences::of_user().share("interface-size");
  size_all_text(size);
  return size;
}

// Installs an event filter for the whole program, once for all windows.
template <class Filter>
void filter_all() {
  static QPointer<Filter> there;
  if (!there) qApp->installEventFilter(there = new Filter(qApp));
}

}  // namespace

Window::Window(Workspace& workspace, Manner manner)
    : workspace_(workspace),
      manner_(manner),
      text_size_(text_size_of_user()),
      views_(new Views(workspace, this)),
      viewport_(&views_->first()),
      sound_(new Sound(workspace, this)),
      said_(new QLabel(this)) {
  setObjectName("studio");
  filter_all<ControlNames>(), filter_all<KeyFocus>();
  setDockNestingEnabled(true);
  setAcceptDrops(true);
  resize(1280, 800);
  viewport_->set_plain(manner.bare);
  setCentralWidget(views_);
  add_panels();
  add_menus();
  said_->setTextFormat(Qt::PlainText);
  said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long lines do not widen the window
  statusBar()->addWidget(said_, 1);
  statusBar()->setVisible(!manner_.bare);
  menuBar()->setVisible(!manner_.bare);
  workspace.ask = [this](const Session::Question& question) { return answer(question); };
  connect(&workspace, &Workspace::document_changed, this, &Window::name_film);
  connect(&workspace, &Workspace::text_changed, this, &Window::name_film);
  connect(&workspace, &Workspace::opened, this, &Window::note_file);
  connect(&workspace, &Workspace::named, this, &Window::note_file);
  connect(&workspace, &Workspace::wants_to_quit, this, [this] {
    if (!std::exchange(leaving_, true)) QTimer::singleShot(0, this, [this] { window()->close(); });
  });
  // The status bar shows the last line carried out, or its error, even if the console is hidden.
  connect(&workspace, &Workspace::said, this, [this](const QString& line, const QString& answer, bool refused) {
    said_->setText(beginning_of((refused ? answer : line).section('\n', 0, 0), 500));
    QPalette p;
    if (refused) p.setColor(QPalette::WindowText, colors().error);
    said_->setPalette(p);
  });
  show_work();
  if (manner_.bare) {  // as in the terminal player
    connect(new QShortcut(Qt::Key_Q, this), &QShortcut::activated, this, [this] { window()->close(); });
    connect(new QShortcut(Qt::Key_M, this), &QShortcut::activated, this,
            [this] { Preferences::of_user().set("mute", !sound_->muted()); });
  }
  set_layout(manner_.bare ? "picture" : "all");
  for (const Preference& row : preference_rows()) apply(text_of(row.name));
  connect(&Preferences::of_user(), &Preferences::changed, this, &Window::apply);
  connect(&Keys::of_user(), &Keys::changed, this, &Window::apply_keys);
  if (manner_.remembers) recall(), follow_guides();
  name_film();
}

// Shows the progress of slow work.
void Window::show_work() {
  auto* progress = new QProgressBar(this);
  progress->setObjectName("work");
  progress->setRange(0, 100), progress->setMaximumWidth(200), progress->setFormat(tr("working: %p %"));
  progress->hide();
  statusBar()->addPermanentWidget(progress);
  auto* stop = new QPushButton(tr("Stop"), this);
  stop->setObjectName("stop");
  stop->setToolTip(tr("Stops the work; the film stays as it was"));
  stop->setFocusPolicy(Qt::NoFocus);
  stop->hide();
  statusBar()->addPermanentWidget(stop);
  workspace_.jobs().set_stopper(stop);
  connect(stop, &QPushButton::clicked, this, [this] { workspace_.jobs().stop(); });
  connect(&workspace_.jobs(), &BackgroundJobs::takes_long, this, [this, progress, stop](float share, bool may_stop) {
    progress->setValue(static_cast<int>(100 * share));
    progress->show(), statusBar()->show();
    stop->setVisible(may_stop);
    setCursor(Qt::BusyCursor);
  });
  connect(&workspace_.jobs(), &BackgroundJobs::over, this, [this, progress, stop] {
    progress->hide(), stop->hide(), statusBar()->setVisible(!manner_.bare);
    unsetCursor();
  });
}

Window::~Window() { workspace_.ask = {}; }

void Window::add_panels() {
  const auto add = [&](QWidget* panel, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(panel->windowTitle(), this);
    dock->setObjectName(panel->objectName() + "_dock");
    dock->setFont(QApplication::font());  // a title has a font of its own, which follows no other
    dock->setWidget(panel);
    addDockWidget(area, dock);
    docks_.push_back(dock);
    return dock;
  };
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  auto* outliner = add(new Outliner(workspace_), Qt::LeftDockWidgetArea);
  tabifyDockWidget(outliner, add(new PosePanel(workspace_), Qt::LeftDockWidgetArea)), outliner->raise();
  auto* timeline = add(new Timeline(workspace_), Qt::BottomDockWidgetArea);
  auto* sheet = add(new Sheet(workspace_), Qt::BottomDockWidgetArea);
  auto* curves = add(new Curves(workspace_), Qt::BottomDockWidgetArea);
  auto* script = add(new ScriptPanel(workspace_), Qt::RightDockWidgetArea);
  auto* properties = add(new Properties(workspace_), Qt::RightDockWidgetArea);
  auto* console = add(new Console(workspace_), Qt::RightDockWidgetArea);
  auto* history = add(new HistoryPanel(workspace_), Qt::RightDockWidgetArea);
  auto* course = add(new CoursePanel(*this), Qt::RightDockWidgetArea);
  tabifyDockWidget(history, console), tabifyDockWidget(console, course), console->raise();
  auto* live = add(new LivePanel(workspace_), Qt::LeftDockWidgetArea);
  auto* server = add(new ServerPanel, Qt::LeftDockWidgetArea);
  tabifyDockWidget(live, server), live->raise();
  auto* assets = new AssetPanel(workspace_);
  tabifyDockWidget(outliner, add(assets, Qt::LeftDockWidgetArea)), outliner->raise();
  connect(assets, &AssetPanel::chosen, this,
          [this](const QString& file) { viewport_->import_file(file, viewport_->rect().center()); });
  splitDockWidget(timeline, sheet, Qt::Vertical);
  tabifyDockWidget(sheet, curves), sheet->raise();
  tabifyDockWidget(properties, script);
  tabifyDockWidget(script, add(new DataPanel(workspace_), Qt::RightDockWidgetArea)), script->raise();
}

Viewport& Window::viewport() { return views_->active(); }
const Viewport& Window::viewport() const { return views_->active(); }

QWidget* Window::panel(const QString& name) const {
  for (QDockWidget* dock : docks_)
    if (dock->widget()->objectName() == name) return dock->widget();
  return nullptr;
}

void Window::show_panel(const QString& name) {
  if (name == viewport_->objectName()) viewport_->setFocus();
  for (QDockWidget* dock : docks_) {
    if (dock->widget()->objectName() != name) continue;
    dock->show(), dock->raise();
    dock->widget()->setFocus();
  }
}

void Window::add_menus() {
  const auto menu_of = [&](const QString& name) {
    QMenu* into = menuBar()->findChild<QMenu*>(name);
    if (!into)
      into = menuBar()->addMenu(word_of(name.toStdString())), into->setObjectName(name), into->setToolTipsVisible(true);
    return into;
  };
  for (const ActionRow& row : action_rows()) {
    QMenu* into = menu_of(text_of(row.menu));
    if (row.divides) into->addSeparator();
    auto* action = into->addAction(text_of(row.name));
    actions_.emplace_back(action, &row);
    action->setToolTip(word_of(row.sentence));
    action->setStatusTip(word_of(row.sentence));
    action->setCheckable(row.is_on != nullptr);
    addAction(action);  // works while the menu bar is hidden, too
    connect(action, &QAction::triggered, this, [this, &row] { row.run(*this); });
    if (row.is_on)
      connect(into, &QMenu::aboutToShow, action, [this, action, &row] { action->setChecked(row.is_on(*this)); });
    if (row.name == "Open…") recent_ = into->addMenu(tr("Open recent"));
    if (row.name == "Add object") action->setMenu(kinds_ = new QMenu(this)), fill_kinds(*kinds_, workspace_, this);
  }
  apply_keys();
  QMenu* view = menu_of("View");
  view->addSeparator();
  QMenu* layouts_menu = view->addMenu(tr("Layout"));
  for (const QString& name : layouts())
    layouts_menu->addAction(word_of(name.toStdString()), this, [this, name] { set_layout(name); });
  for (QDockWidget* dock : docks_) view->addAction(dock->toggleViewAction());
  connect(recent_, &QMenu::aboutToShow, this, &Window::list_recent);
}

QStringList Window::layouts() { return {"all", "animate", "script", "live", "picture"}; }

bool Window::set_layout(const QString& name) {
  if (!layouts().contains(name)) return false;
  const auto show_panels = [&](const QString& layout) {
    for (QDockWidget* dock : docks_) dock->setVisible(in_layout(layout, dock->widget()->objectName()));
  };
  // The kept state hides what needs much room, so that a small window does not grow when it is restored.
  if (arranged_.isEmpty())
    show_panels("all"), arranged_ = saveState();
  else
    restoreState(arranged_);
  show_panels(name);
  // Sizes are parts of the window. All panels of one column get their sizes in one call.
  using Shares = std::initializer_list<std::pair<const char*, double>>;
  const auto share = [&](Shares shares, Qt::Orientation way) {
    QList<QDockWidget*> docks;
    QList<int> sizes;
    for (const auto& [panel, part] : shares)
      for (QDockWidget* dock : docks_)
        if (dock->widget()->objectName() == panel && dock->isVisibleTo(this))
          docks << dock, sizes << static_cast<int>(part * (way == Qt::Horizontal ? width() : height()));
    if (!docks.isEmpty()) resizeDocks(docks, sizes, way);
  };
  const bool script = name == "script";
  // The left column has room for the names of its panels.
  const double left = std::max(0.14, std::min(0.2, 14.0 * fontMetrics().height() / width()));
  share({{"outliner", left}, {"live", 0.24}, {"script_panel", script ? 0.42 : 0.29}}, Qt::Horizontal);
  share({{"sheet", name == "animate" ? 0.48 : 0.34}}, Qt::Vertical);
  share({{"script_panel", 0.72}, {"console", 0.28}}, Qt::Vertical);
  return true;
}

void Window::name_film() {
  setWindowTitle(film_name() + "[*] — Betwixt");
  setWindowModified(!is_saved());
  emit film_named();
}

// ---- files

bool Window::save() {
  workspace_.settle_typing();
  return workspace_.session().file().empty() ? save_as() : workspace_.say(std::string("save"));
}

bool Window::save_as() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the film"), "film.bx", tr("Films (*.bx)"), nullptr,
                                                    QFileDialog::DontConfirmOverwrite);  // the session asks
  const QString name = QFileInfo(file).suffix().isEmpty() ? file + ".bx" : file;
  return !file.isEmpty() && workspace_.say("save " + as_one_word(name.toStdString()));
}

void Window::note_file() {
  name_film();
  if (!manner_.remembers || workspace_.session().file().empty()) return;
  QSettings settings("betwixt", "studio");
  QStringList files = settings.value("recent").toStringList();
  const QString file = QFileInfo(QString::fromStdString(workspace_.session().file())).absoluteFilePath();
  files.removeAll(file);
  files.prepend(file);
  settings.setValue("recent", files.mid(0, recent_files));
}

QStringList Window::films_opened_last() {
  QStringList all = QSettings("betwixt", "studio").value("recent").toStringList();
  all.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return all;
}

void Window::list_recent() {
  recent_->clear();
  for (const QString& file : films_opened_last()) recent_->addAction(file, this, [this, file] { open_film(file); });
  if (recent_->isEmpty()) recent_->addAction(tr("none yet"))->setEnabled(false);
}

void Window::save_session() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Save session"), "session.txt");
  if (name.isEmpty()) return;
  std::string all;
  for (const std::string& line : workspace_.session_lines()) all += line + "\n";
  if (const Status s = write_whole(name.toStdString(), all, true); !s)
    said_->setText(QString::fromStdString(s.error().message));
}

void Window::make_film() {
  auto* dialog = new ExportDialog(workspace_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

void Window::closeEvent(QCloseEvent* e) {
  if (!leaving_) workspace_.say(std::string("quit"));  // asks about unsaved changes
  if (!leaving_) return e->ignore();
  if (manner_.remembers) remember();
  e->accept();
}

// ---- settings

void Window::remember() {
  QSettings settings("betwixt", "studio");
  if (!manner_.bare) settings.setValue("geometry", window()->saveGeometry()), settings.setValue("panels", saveState());
  const ViewportSwitches& s = viewport_->switches();
  settings.setValue("safe-frames", s.safe), settings.setValue("thirds", s.thirds), settings.setValue("snaps", s.snaps);
  settings.setValue("rulers", s.guides);
}

// The studio must start whatever the settings hold: if a start does not finish, the next one drops the geometry of the
// window and the panels.
void Window::recall() {
  Preferences::of_user().recall();
  Keys::of_user().recall();
  QSettings settings("betwixt", "studio");
  ViewportSwitches s = viewport_->switches();
  s.safe = settings.value("safe-frames").toBool(), s.thirds = settings.value("thirds").toBool();
  s.snaps = settings.value("snaps").toBool(), s.guides = settings.value("rulers").toBool();
  viewport_->set_switches(s);
  if (manner_.bare) return;
  if (settings.contains("starting")) settings.remove("geometry"), settings.remove("panels");
  settings.setValue("starting", true);
  settings.sync();
  QWidget& around = manner_.films ? *static_cast<QWidget*>(manner_.films) : *this;
  if (!around.isVisible()) around.restoreGeometry(settings.value("geometry").toByteArray());
  // Restore the panels after the window has its size: Qt crashes if it restores them into a window that is about to be
  // maximised.
  QTimer::singleShot(0, this, [this] {
    restoreState(QSettings("betwixt", "studio").value("panels").toByteArray());
    QTimer::singleShot(0, this, [] { QSettings("betwixt", "studio").remove("starting"); });
  });
}

}  // namespace betwixt::studio
