// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/window.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include "studio/actions.h"
#include "studio/console.h"
#include "studio/curves.h"
#include "studio/outliner.h"
#include "studio/properties.h"
#include "studio/script_panel.h"
#include "studio/sheet.h"
#include "studio/timeline.h"
#include "studio/viewport.h"

namespace betwixt::studio {

Window::Window(Desk& desk, bool bare) : desk_(desk), viewport_(new Viewport(desk, this)) {
  setObjectName("studio");
  setDockNestingEnabled(true);
  resize(1280, 800);
  setCentralWidget(viewport_);
  add_panels();
  add_menus();
  connect(&desk, &Desk::document_changed, this, &Window::name_film);
  connect(&desk, &Desk::text_changed, this, &Window::name_film);
  set_layout(bare ? "picture" : "all");
  name_film();
}
Window::~Window() = default;

void Window::add_panels() {
  const auto add = [&](QWidget* panel, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(panel->windowTitle(), this);
    dock->setObjectName(panel->objectName() + "_dock");
    dock->setWidget(panel);
    addDockWidget(area, dock);
    docks_.push_back(dock);
    return dock;
  };
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  add(new Outliner(desk_), Qt::LeftDockWidgetArea);
  add(new Timeline(desk_), Qt::BottomDockWidgetArea);
  auto* sheet = add(new Sheet(desk_), Qt::BottomDockWidgetArea);
  auto* curves = add(new Curves(desk_), Qt::BottomDockWidgetArea);
  auto* script = add(new ScriptPanel(desk_), Qt::RightDockWidgetArea);
  auto* properties = add(new Properties(desk_), Qt::RightDockWidgetArea);
  add(new Console(desk_), Qt::RightDockWidgetArea);
  tabifyDockWidget(sheet, curves), sheet->raise();
  tabifyDockWidget(script, properties), script->raise();
}

void Window::add_menus() {
  for (const ActionRow& row : action_rows()) {
    const QString menu = QString::fromUtf8(row.menu.data(), static_cast<int>(row.menu.size()));
    QMenu* into = menuBar()->findChild<QMenu*>(menu);
    if (!into) into = menuBar()->addMenu(menu), into->setObjectName(menu);
    auto* action = into->addAction(QString::fromUtf8(row.name.data(), static_cast<int>(row.name.size())));
    QList<QKeySequence> keys;
    for (const QString& k :
         QString::fromUtf8(row.keys.data(), static_cast<int>(row.keys.size())).split("; ", Qt::SkipEmptyParts))
      keys.push_back(QKeySequence(k));
    action->setShortcuts(keys);
    action->setToolTip(QString::fromUtf8(row.sentence.data(), static_cast<int>(row.sentence.size())));
    action->setCheckable(row.is_on != nullptr);
    connect(action, &QAction::triggered, this, [this, &row] { row.run(*this); });
    if (row.is_on)
      connect(into, &QMenu::aboutToShow, action, [this, action, &row] { action->setChecked(row.is_on(*this)); });
  }
  QMenu* panels = menuBar()->addMenu(tr("Panels"));
  for (QDockWidget* dock : docks_) panels->addAction(dock->toggleViewAction());
}

QStringList Window::layouts() { return {"all", "animate", "script", "picture"}; }

bool Window::set_layout(const QString& name) {
  if (!layouts().contains(name)) return false;
  for (QDockWidget* dock : docks_) {
    const QString panel = dock->widget()->objectName();
    const bool shown = name == "all" || panel == "timeline" ||
                       (name == "animate" && (panel == "sheet" || panel == "curves" || panel == "outliner")) ||
                       (name == "script" && (panel == "script_panel" || panel == "console"));
    dock->setVisible(shown);
  }
  return true;
}

void Window::name_film() {
  const QString file = QString::fromStdString(desk_.session().file());
  setWindowTitle((file.isEmpty() ? tr("new film") : file) + "[*] — Betwixt");
  setWindowModified(desk_.session().unsaved() > 0);
}

void Window::open_asking() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a film"), {}, tr("Films (*.bx)"));
  if (!file.isEmpty()) desk_.open(file);
}

bool Window::save() {
  QString file = QString::fromStdString(desk_.session().file());
  if (!file.isEmpty()) return desk_.say(std::string("save"));
  file = QFileDialog::getSaveFileName(this, tr("Save the film"), "film.bx", tr("Films (*.bx)"));
  return !file.isEmpty() && desk_.say("save " + file.toStdString());
}

void Window::closeEvent(QCloseEvent* e) {
  desk_.settle_typing();
  if (desk_.session().unsaved() == 0) return e->accept();
  const auto answer = QMessageBox::question(this, tr("Not saved"), tr("This film has changes that are not saved."),
                                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  const bool leave = answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
  leave ? e->accept() : e->ignore();
}

}  // namespace betwixt::studio
