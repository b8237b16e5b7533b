// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/views.h"

#include <QEvent>
#include <QGridLayout>

namespace betwixt::studio {
namespace {

// As in other programs: from above over from the front, with the right side beside it.
struct SideRow {
  const char* name;
  Vec3 along;
  int row, column;
};
const SideRow side_rows[] = {
    {"top_view", {0, -1, 0}, 0, 0}, {"front_view", {0, 0, -1}, 1, 0}, {"right_view", {-1, 0, 0}, 1, 1}};

}  // namespace

Views::Views(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), first_(new Viewport(workspace, this)), active_(first_) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  grid->addWidget(first_, 0, 1);
  add(*first_);
}

void Views::add(Viewport& view) {
  view.installEventFilter(this);
  connect(&view, &Viewport::switches_changed, this, [this, &view] {
    for (Viewport* other : findChildren<Viewport*>(Qt::FindDirectChildrenOnly))
      if (!(other->switches() == view.switches())) other->set_switches(view.switches());
  });
}

std::vector<Viewport*> Views::all() const {
  std::vector<Viewport*> out{first_};
  if (four_) out.insert(out.end(), sides_.begin(), sides_.end());
  return out;
}

void Views::set_four(bool four) {
  if (four == four_) return;
  four_ = four, active_ = first_;
  auto* grid = static_cast<QGridLayout*>(layout());
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const bool fresh = !sides_[i];
    if (fresh) {
      sides_[i] = new Viewport(workspace_, this);
      sides_[i]->setObjectName(side_rows[i].name);
      sides_[i]->set_style(first_->style());
      sides_[i]->set_switches(first_->switches());
      grid->addWidget(sides_[i], side_rows[i].row, side_rows[i].column);
      add(*sides_[i]);
    }
    sides_[i]->setVisible(four);
    if (!fresh) continue;
    grid->activate();  // the view fits the film into its size
    sides_[i]->stay_at_side(side_rows[i].along);
  }
  for (const int i : {0, 1}) grid->setRowStretch(i, 1), grid->setColumnStretch(i, four || i == 1 ? 1 : 0);
  if (!four) grid->setRowStretch(1, 0);
  first_->setFocus();
}

bool Views::eventFilter(QObject* on, QEvent* e) {
  if (e->type() == QEvent::FocusIn || e->type() == QEvent::MouseButtonPress || e->type() == QEvent::Wheel)
    if (auto* view = qobject_cast<Viewport*>(on)) active_ = view;
  return QWidget::eventFilter(on, e);
}

}  // namespace betwixt::studio
