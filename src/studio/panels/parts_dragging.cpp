// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Drags of filters to another place in their order.
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>

#include "studio/panels/parts_view.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {

QWidget* PartsView::make_grip(QWidget* row) {
  auto* grip = new QLabel(QString::fromUtf8("≡"), row);
  grip->setObjectName("grip");
  grip->setToolTip(tr("Drag: the filter acts earlier or later; its line goes to another place"));
  grip->setCursor(Qt::SizeVerCursor);
  grip->setFocusPolicy(Qt::ClickFocus);  // for Escape; the buttons ↑ and ↓ do the same by keyboard
  grip->installEventFilter(this);
  return grip;
}

// Returns the filter of the dragged one's track whose row is nearest.
std::size_t PartsView::place_under(int y) const {
  std::size_t at = drag_->from;
  const int by = y < rows_[at].box->geometry().center().y() ? -1 : 1;
  for (auto next = neighbour(at, by); next; next = neighbour(at, by)) {
    const QRect box = rows_[*next].box->geometry();
    if (by < 0 ? y > box.bottom() : y < box.top()) break;
    at = *next;
  }
  return at;
}

void PartsView::drag_to(int y) {
  const std::size_t to = place_under(y);
  if (to == drag_->to) return;
  drag_->to = to;
  const Lines lines = move_part(workspace_.session().document(), workspace_.text(), parts_, drag_->from, to);
  lines.empty() ? workspace_.look_back() : (void)workspace_.look_ahead(lines);
  if (!mark_) mark_ = new QWidget(this), mark_->setAutoFillBackground(true);
  QPalette p;
  p.setColor(QPalette::Window, colors().accent);
  mark_->setPalette(p);
  const QRect box = rows_[to].box->geometry();
  mark_->setGeometry(box.left(), to < drag_->from ? box.top() : box.bottom() - 1, box.width(), 2);
  mark_->setVisible(to != drag_->from), mark_->raise();
}

void PartsView::end_drag(bool carry_out) {
  const RowDrag drag = *std::exchange(drag_, std::nullopt);
  if (mark_) mark_->hide();
  workspace_.look_back();
  if (carry_out) say(move_part(workspace_.session().document(), workspace_.text(), parts_, drag.from, drag.to));
}

bool PartsView::eventFilter(QObject* on, QEvent* e) {
  const auto y = [&] { return mapFromGlobal(static_cast<QMouseEvent*>(e)->globalPosition().toPoint()).y(); };
  switch (e->type()) {
    case QEvent::MouseButtonPress:
      if (static_cast<QMouseEvent*>(e)->button() != Qt::LeftButton) return false;
      for (std::size_t i = 0; i < rows_.size(); ++i)
        if (rows_[i].box == static_cast<QWidget*>(on)->parentWidget()) drag_ = RowDrag{i, i};
      static_cast<QWidget*>(on)->setFocus();
      return true;
    case QEvent::MouseMove:
      if (drag_) drag_to(y());
      return true;
    case QEvent::MouseButtonRelease:
      if (drag_) end_drag(true);
      return true;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      if (!drag_ || static_cast<QKeyEvent*>(e)->key() != Qt::Key_Escape) return false;
      if (e->type() == QEvent::KeyPress) end_drag(false);
      e->accept();
      return true;
    default:
      return false;
  }
}

}  // namespace betwixt::studio
