// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/films.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QStackedWidget>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "studio/shell/about.h"
#include "studio/shell/text_of.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

QString file_of(const Window& w) { return QString::fromStdString(w.workspace().session().file()); }

bool same_file(const QString& a, const QString& b) {
  const QString real = QFileInfo(a).canonicalFilePath();
  return !real.isEmpty() && real == QFileInfo(b).canonicalFilePath();
}

}  // namespace

Films::Films(const LoadOptions& options, Window::Manner manner)
    : options_(options), manner_(manner), tabs_(new QTabBar(this)), stack_(new QStackedWidget(this)) {
  manner_.films = this;
  setObjectName("films");
  QApplication::setWindowIcon(program_icon());
  resize(1280, 800);
  tabs_->setObjectName("tabs");
  tabs_->setAutoHide(true), tabs_->setMovable(true), tabs_->setTabsClosable(true);
  tabs_->setExpanding(false), tabs_->setDocumentMode(true), tabs_->setElideMode(Qt::ElideMiddle);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0), all->setSpacing(0);
  all->addWidget(tabs_), all->addWidget(stack_, 1);
  connect(tabs_, &QTabBar::currentChanged, this, &Films::show_page);
  connect(tabs_, &QTabBar::tabCloseRequested, this, [this](int i) { close_film(*windows()[i]); });
  connect(tabs_, &QTabBar::tabMoved, this, [this](int from, int to) {
    Page page = std::move(pages_[from]);
    pages_.erase(pages_.begin() + from);
    pages_.insert(pages_.begin() + to, std::move(page));
  });
  add();
}

Films::~Films() {
  for (const Page& p : pages_) delete p.window;  // before its workspace
}

Window& Films::current() const { return *pages_[tabs_->currentIndex()].window; }

std::vector<Window*> Films::windows() const {
  std::vector<Window*> all;
  for (const Page& p : pages_) all.push_back(p.window);
  return all;
}

int Films::index_of(const Window& w) const {
  return static_cast<int>(std::ranges::find(pages_, &w, &Page::window) - pages_.begin());
}

// The journal of one more film without a file: one that no film has and no crash has left.
std::string Films::free_journal() const {
  for (int n = 2;; ++n) {
    const std::string name = ".betwixt-" + std::to_string(n) + ".journal";
    const auto is_its = [&](const Page& p) { return p.workspace->nameless_journal() == name; };
    if (std::ranges::none_of(pages_, is_its) && !QFileInfo::exists(QString::fromStdString(name))) return name;
  }
}

Window* Films::make_window(Workspace& workspace) {
  auto* window = new Window(workspace, manner_);
  connect(window, &Window::film_named, this, &Films::name_tabs);
  return window;
}

Window& Films::add(const std::string& nameless_journal) {
  if (!pages_.empty() && manner_.remembers) current().remember();  // the new tab begins with these panels
  auto workspace = std::make_unique<Workspace>(
      options_, pages_.empty() || !nameless_journal.empty() ? nameless_journal : free_journal());
  Window* window = make_window(*workspace);
  pages_.push_back({std::move(workspace), window});
  stack_->addWidget(window);
  const int index = tabs_->addTab({});
  for (const auto side : {QTabBar::LeftSide, QTabBar::RightSide})
    if (QWidget* button = tabs_->tabButton(index, side)) button->setToolTip(word_of("Close film"));
  tabs_->setCurrentIndex(index);
  name_tabs();
  return *window;
}

void Films::remove(Window& w) {
  const int index = index_of(w);
  Workspace* workspace = pages_[index].workspace.release();
  pages_.erase(pages_.begin() + index);
  stack_->removeWidget(&w);
  tabs_->removeTab(index);
  show_page();
  // Later, because one of their own actions may have asked for it.
  connect(&w, &QObject::destroyed, workspace, &QObject::deleteLater);
  w.deleteLater();
}

void Films::go_to(Window& w) { tabs_->setCurrentIndex(index_of(w)); }

void Films::go_on(int by) {
  const int all = tabs_->count();
  tabs_->setCurrentIndex((tabs_->currentIndex() + by + all) % all);
}

void Films::show_page() {
  if (tabs_->currentIndex() < 0 || tabs_->count() != static_cast<int>(pages_.size())) return;
  Window& next = current();
  for (const Page& p : pages_)
    if (p.window != &next) p.workspace->pause();
  stack_->setCurrentWidget(&next);
  name_tabs();
}

void Films::name_tabs() {
  if (tabs_->count() != static_cast<int>(pages_.size())) return;
  for (int i = 0; i < tabs_->count(); ++i) {
    const Window& w = *pages_[i].window;
    const QString name = w.film_name().replace('&', "&&") + (w.is_saved() ? "" : " *");
    const QString file = file_of(w);
    if (tabs_->tabText(i) != name) tabs_->setTabText(i, name);
    tabs_->setTabToolTip(i, file.isEmpty() ? name : QFileInfo(file).absoluteFilePath());
  }
  if (tabs_->accessibleName().isEmpty()) tabs_->setAccessibleName(tr("Films"));
  setWindowTitle(current().windowTitle());
  setWindowModified(current().isWindowModified());
}

Window& Films::place_for_another() { return manner_.bare || current().is_untouched() ? current() : add(); }

void Films::open(const QString& file) {
  for (const Page& p : pages_)
    if (same_file(file_of(*p.window), file)) return go_to(*p.window);
  Window& before = current();
  Window& place = place_for_another();
  if (place.workspace().say("open " + as_one_word(file.toStdString())) || &place == &before) return;
  const std::string why = place.workspace().last_said();
  remove(place);
  go_to(before);
  emit before.workspace().said({}, QString::fromStdString(why), true);
}

void Films::close_film(Window& w) {
  if (pages_.size() == 1) return (void)close();
  if (!w.is_saved()) go_to(w);
  if (!w.has_left() && !w.may_leave()) return;
  w.leave();
  remove(w);
}

// Asks for all films before it leaves one. A film that was left by `quit` does not come back if another one stays.
void Films::closeEvent(QCloseEvent* e) {
  for (Window* w : windows()) {
    if (w->has_left() || w->may_leave()) continue;
    for (Window* left : windows())
      if (left->has_left()) remove(*left);
    return e->ignore();
  }
  if (manner_.remembers) current().remember();
  for (Window* w : windows()) w->leave();
  e->accept();
}

void Films::recover_others(Session::Earlier earlier) {
  Window& first = current();
  for (const QString& journal : QDir().entryList({".betwixt-*.journal"}, QDir::Files | QDir::Hidden)) {
    Window& w = add(journal.toStdString());
    const bool opened = w.workspace().open({}, earlier);
    const Session& session = w.workspace().session();
    if (!opened || !session.may_change() || session.unsaved() == 0) remove(w);  // nothing there, or of another program
  }
  go_to(first);
}

void Films::speak_anew() {
  tabs_->setAccessibleName(tr("Films"));
  for (Page& p : pages_) {
    const QByteArray panels = p.window->saveState();
    const int index = stack_->indexOf(p.window);
    const std::string begun = p.window->first_text();
    delete p.window;
    p.window = make_window(*p.workspace);
    p.window->begun_with(begun);
    stack_->insertWidget(index, p.window);
    // After what the new window recalls.
    QTimer::singleShot(0, p.window, [w = p.window, panels] { w->restoreState(panels); });
    p.window->show_film_anew();
  }
  show_page();
}

}  // namespace betwixt::studio
