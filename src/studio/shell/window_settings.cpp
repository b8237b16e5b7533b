// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the settings of the user do to a window: its colours, sizes and keys.
#include <QApplication>
#include <QDockWidget>
#include <QPlainTextEdit>
#include <algorithm>
#include <cmath>
#include <utility>

#include "studio/shell/about.h"
#include "studio/shell/actions.h"
#include "studio/shell/key_sheet.h"
#include "studio/shell/keys.h"
#include "studio/shell/manual.h"
#include "studio/shell/preferences.h"
#include "studio/shell/preferences_window.h"
#include "studio/shell/sound.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

QFont scaled(QFont f, double by) {
  f.setPointSizeF(f.pointSizeF() * by);
  return f;
}

}  // namespace

void Window::set_light(bool light) { Preferences::of_user().set("light", light); }
bool Window::is_light() const { return Preferences::of_user().is_on("light"); }

void Window::set_text_size(double size) {
  Preferences::of_user().set("interface-size", static_cast<int>(std::lround(100 * size)));
}

// Widgets with a font of their own do not follow that of the application.
void Window::scale_text(double size) {
  const double by = size / std::exchange(text_size_, size);
  for (QWidget* w : findChildren<QWidget*>())
    if (w->testAttribute(Qt::WA_SetFont) && w->font().pointSizeF() > 0) w->setFont(scaled(w->font(), by));
  size_all_text(size);
  for (QDockWidget* dock : docks_) dock->setFont(QApplication::font());
}

// Guides belong to a film and are kept in the settings, because they are no part of it.
void Window::follow_guides() {
  const auto read = [this] {
    ViewportSwitches s = viewport_->switches();
    s.own_guides = kept_guides(workspace_.session().file());
    viewport_->set_switches(s);
  };
  const auto keep = [this] { keep_guides(workspace_.session().file(), viewport_->switches().own_guides); };
  connect(&workspace_, &Workspace::opened, this, read);
  connect(&workspace_, &Workspace::named, this, keep);
  connect(viewport_, &Viewport::switches_changed, this, keep);
  read();
}

// Lets a setting have its effect here.
void Window::apply(const QString& name) {
  const Preferences& user = Preferences::of_user();
  if (name == "light" || name == "safe-colors") {
    set_theme(*qApp, user.is_on("light") ? Theme::light : Theme::dark, user.is_on("safe-colors"));
    for (QWidget* w : findChildren<QWidget*>()) w->update();
    emit workspace_.colors_changed();
  } else if (name == "interface-size") {
    scale_text(user.share("interface-size"));
  } else if (name == "script-size") {
    const double by = user.share("script-size") / std::exchange(script_size_, user.share("script-size"));
    for (QPlainTextEdit* edit : findChildren<QPlainTextEdit*>()) edit->setFont(scaled(edit->font(), by));
  } else if (name == "less-motion") {
    const bool less = user.is_on("less-motion");
    static const int blinks = QApplication::cursorFlashTime();
    QApplication::setCursorFlashTime(less ? 0 : blinks);
    for (const auto effect : {Qt::UI_AnimateMenu, Qt::UI_AnimateCombo, Qt::UI_AnimateTooltip, Qt::UI_FadeMenu})
      QApplication::setEffectEnabled(effect, !less);
    setAnimated(!less);
  } else if (name == "loop") {
    workspace_.playhead().loop(user.is_on("loop"));
    emit workspace_.playing_changed();
  } else if (name == "mute") {
    sound_->mute(user.is_on("mute"));
  }
}

// Menus show the keys of the panels too, which panels handle themselves.
void Window::apply_keys() {
  const Keys& keys = Keys::of_user();
  for (const auto& [action, row] : actions_) {
    const KeyRow* own = keys.row("everywhere", row->name);
    const QString name = word_of(row->name), shown = own ? QString() : keys.shown(row->name);
    action->setShortcuts(own ? keys.keys(*own) : QList<QKeySequence>());
    action->setText(shown.isEmpty() ? name : name + "\t" + shown);
  }
}

void Window::show_film_anew() {
  emit workspace_.opened();
  emit workspace_.document_changed();
  emit workspace_.text_changed();
  emit workspace_.selection_changed();
  emit workspace_.time_changed();
  name_film();
}

void Window::show_keys() { (new KeySheet(*this))->show(); }

void Window::show_manual() {
  const QString folder = manual_folder();
  if (folder.isEmpty()) return said_->setText(tr("the manual is not installed: it is the folder docs of the source"));
  (new Manual(folder, this))->show();
}

void Window::show_about() { open_about(this); }

void Window::show_preferences(const QString& page) {
  auto* open = findChild<PreferencesWindow*>();
  if (!open) open = new PreferencesWindow(this);
  if (!page.isEmpty()) open->turn_to(page);
  open->show(), open->raise(), open->activateWindow();
}

}  // namespace betwixt::studio
