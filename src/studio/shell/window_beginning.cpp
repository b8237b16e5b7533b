// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How films begin in the window, and the question before another film replaces them.
#include <QLabel>

#include "studio/course/film_chooser.h"
#include "studio/shell/asking.h"
#include "studio/shell/example.h"
#include "studio/shell/recovery.h"
#include "studio/shell/window.h"

namespace betwixt::studio {
namespace {

const std::vector<std::string> saving{"save", "discard", "stay"};  // the choices before a film is left

}  // namespace

bool Window::may_leave() {
  if (workspace_.session().unsaved() == 0 || is_as_begun()) return true;
  const auto said = answer({{}, "this film is not saved", saving});
  return said && *said != "stay" && (*said != "save" || save());
}

bool Window::is_as_begun() const { return workspace_.session().file().empty() && workspace_.text() == first_text_; }

void Window::new_film() {
  if (!may_leave()) return;
  begin_film({});
  choose_film();
}

void Window::choose_film() {
  delete findChild<FilmChooser*>();
  auto* chooser = new FilmChooser(this);
  connect(chooser, &FilmChooser::chosen, this, &Window::begin_film);
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
  // A question before the first show would activate the layout of a maximised window too early: Qt crashes then.
  if (!isVisible()) show();
  if (question.choices.size() > 2 && question.choices[0] == "recover") {
    Recovery recovery(workspace_.opening(), question.text, this);
    recovery.exec();
    return recovery.chosen();
  }
  // A film needs no saving if the user has not changed it.
  if (is_as_begun() && !first_text_.empty() && question.choices == saving) return "discard";
  const auto said = ask_in_window(this, question);
  if (said != "save" || !workspace_.session().file().empty()) return said;
  return save_as() ? "discard" : "stay";  // an unnamed film: now it has been saved
}

}  // namespace betwixt::studio
