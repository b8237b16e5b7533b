// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/poses/pose_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "studio/poses/trial_dialog.h"
#include "studio/shell/scrolled.h"
#include "studio/shell/text_size.h"

namespace betwixt::studio {

PosePanel::PosePanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      poses_(PoseActions::of(workspace)),
      name_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      words_(
          new QLabel(tr("Select a character, type a name, and press Keep pose. A double click gives a kept pose to the "
                        "selection, at the playhead."),
                     this)),
      hint_(new Scrolled(words_, Qt::Vertical, this)) {
  setObjectName("poses");
  setWindowTitle(tr("Poses"));
  name_->setPlaceholderText(tr("name of a new pose"));
  name_->setAccessibleName(tr("Name of a new pose"));
  auto* keeps = new QPushButton(tr("Keep pose"), this);
  keeps->setToolTip(tr("Keeps the pose of the selection in the folder poses, beside the script"));
  auto* row = new QHBoxLayout;
  row->addWidget(name_, 1), row->addWidget(keeps);
  list_->setAccessibleName(tr("Poses"));
  list_->setFrameShape(QFrame::NoFrame);
  measure_by_text(*list_, [this] { list_->setMinimumHeight(2 * list_->fontMetrics().height()); });
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setToolTip(
      tr("Double click gives the pose to the selection, at the playhead. Right click: mirrored, in part"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 4);
  words_->setWordWrap(true);
  hint_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  all->addLayout(row), all->addWidget(hint_), all->addWidget(list_, 1);
  connect(keeps, &QPushButton::clicked, this, &PosePanel::keep);
  connect(name_, &QLineEdit::returnPressed, this, &PosePanel::keep);
  connect(list_, &QListWidget::itemActivated, this, [this] { use(false); });
  connect(list_, &QListWidget::customContextMenuRequested, this, &PosePanel::show_menu);
  connect(&poses_, &PoseActions::kept_changed, this, &PosePanel::refresh);
}

void PosePanel::showEvent(QShowEvent* e) {
  QWidget::showEvent(e);
  refresh();
}

void PosePanel::refresh() {
  if (!isVisible()) return;
  const QString before = chosen();
  list_->clear();
  list_->addItems(poses_.kept());
  hint_->setVisible(list_->count() == 0);
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->text() == before) list_->setCurrentRow(i);
}

QString PosePanel::chosen() const { return list_->currentItem() ? list_->currentItem()->text() : QString(); }

void PosePanel::keep() {
  if (poses_.keep(name_->text().trimmed())) name_->clear();
}

void PosePanel::use(bool in_mirror) {
  if (const auto pose = poses_.read(chosen())) workspace_.say(poses_.lines(*pose, in_mirror, 1));
}

void PosePanel::use_in_part() {
  const auto pose = poses_.read(chosen());
  if (!pose) return;
  const auto lines = [&](double share) { return poses_.lines(*pose, false, share); };
  if (const auto share = ask_share(workspace_, this, tr("How much of the pose"), 0, 150, 50, lines))
    workspace_.say(lines(*share));
}

void PosePanel::ask_to_forget() {
  const QString name = chosen();
  if (QMessageBox::question(this, tr("Remove a pose"), tr("Remove the file of the pose '%1'?").arg(name)) ==
      QMessageBox::Yes)
    poses_.forget(name);
}

void PosePanel::show_menu(QPoint at) {
  if (chosen().isEmpty()) return;
  QMenu menu(this);
  menu.addAction(tr("Use"), this, [this] { use(false); });
  menu.addAction(tr("Use mirrored"), this, [this] { use(true); });
  menu.addAction(tr("Use in part…"), this, [this] { use_in_part(); });
  menu.addSeparator();
  menu.addAction(tr("Remove…"), this, [this] { ask_to_forget(); });
  menu.exec(list_->viewport()->mapToGlobal(at));
}

}  // namespace betwixt::studio
