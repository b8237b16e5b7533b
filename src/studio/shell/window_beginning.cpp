// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How films begin in the window, and the question before another film replaces them.
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <utility>

#include "studio/course/film_chooser.h"
#include "studio/shell/asking.h"
#include "studio/shell/example.h"
#include "studio/shell/films.h"
#include "studio/shell/recovery.h"
#include "studio/shell/window.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

const std::vector<std::string> saving{"save", "discard", "stay"};  // the choices before a film is left

}  // namespace

QString Window::film_name() const {
  const QString file = QString::fromStdString(workspace_.session().file());
  return file.isEmpty() ? tr("new film") : QFileInfo(file).fileName();
}

bool Window::is_saved() const { return workspace_.session().unsaved() == 0 || is_untouched(); }
bool Window::is_untouched() const {
  return workspace_.session().file().empty() &&
         (workspace_.session().unsaved() == 0 || workspace_.text() == first_text_);
}

bool Window::may_leave() {
  if (!workspace_.jobs().hears()) return false;
  workspace_.settle_typing();
  if (is_saved()) return true;
  const auto said = answer({{}, {}, saving});
  return said && *said != "stay" && (*said != "save" || save());
}

void Window::leave() {
  if (std::exchange(leaving_, true)) return;
  workspace_.ask = [](const Session::Question&) { return "discard"; };
  workspace_.say(std::string("quit"));
}

Window* Window::place_for_another() {
  if (manner_.films) return &manner_.films->place_for_another();
  return may_leave() ? this : nullptr;
}

void Window::open_film(const QString& file) {
  manner_.films ? manner_.films->open(file) : (void)workspace_.say("open " + as_one_word(file.toStdString()));
}

void Window::go_to_film(int by) {
  if (manner_.films) manner_.films->go_on(by);
}

void Window::close_film() { manner_.films ? manner_.films->close_film(*this) : (void)close(); }

void Window::open_asking() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a film"), {}, tr("Films (*.bx)"));
  if (!file.isEmpty()) open_film(file);
}

void Window::dragEnterEvent(QDragEnterEvent* e) {
  for (const QUrl& url : e->mimeData()->urls())
    if (url.toLocalFile().endsWith(".bx")) e->acceptProposedAction();
}

void Window::dropEvent(QDropEvent* e) {
  for (const QUrl& url : e->mimeData()->urls())
    if (url.toLocalFile().endsWith(".bx")) open_film(url.toLocalFile());
}

// Panels that float are windows of their own; in a tab that is left they would stay.
void Window::hideEvent(QHideEvent* e) {
  QMainWindow::hideEvent(e);
  if (!manner_.films || e->spontaneous()) return;
  for (QDockWidget* dock : docks_)
    if (dock->isFloating() && dock->isVisible()) dock->hide(), floating_.push_back(dock);
}

void Window::showEvent(QShowEvent* e) {
  QMainWindow::showEvent(e);
  for (QDockWidget* dock : std::exchange(floating_, {})) dock->show();
}

void Window::new_film() {
  delete findChild<FilmChooser*>();
  auto* chooser = new FilmChooser(films_opened_last(), this);
  connect(chooser, &FilmChooser::chosen, this, [this](const std::string& text) {
    if (Window* place = place_for_another()) place->begin_film(text);
  });
  connect(chooser, &FilmChooser::wants_file, this,
          [this](const QString& file) { file.isEmpty() ? open_asking() : open_film(file); });
  connect(chooser, &FilmChooser::wants_course, this, [this] { show_panel("course"); });
  chooser->open();
}

void Window::open_example() { begin_film(example_film); }

void Window::begin_film(const std::string& text) {
  workspace_.open("", Session::Earlier::discard);
  if (!text.empty()) workspace_.begin_with(text);
  first_text_ = workspace_.text();
  said_->clear();
  workspace_.go_to(workspace_.document().range().first);
  name_film();
}

std::optional<std::string> Window::answer(const Session::Question& question) {
  if (manner_.films) manner_.films->go_to(*this);  // you see the film that is asked about
  // A question before the first show would activate the layout of a maximised window too early: Qt crashes then.
  if (!window()->isVisible()) window()->show();
  if (question.choices.size() > 2 && question.choices[0] == "recover") {
    Recovery recovery(workspace_.opening(), question.text, this, workspace_.nameless_journal());
    recovery.exec();
    return recovery.chosen();
  }
  // A film needs no saving if the user has not changed it.
  if (is_untouched() && !first_text_.empty() && question.choices == saving) return "discard";
  Session::Question shown = question;
  if (question.choices == saving) shown.text = tr("'%1' has unsaved changes.").arg(film_name()).toStdString();
  const auto said = ask_in_window(this, shown);
  if (said != "save" || !workspace_.session().file().empty()) return said;
  return save_as() ? "discard" : "stay";  // an unnamed film: now it has been saved
}

}  // namespace betwixt::studio
