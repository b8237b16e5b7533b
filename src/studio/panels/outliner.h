// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The outliner: the objects of the film as a tree of attachments, and whether each is shown.
#pragma once

#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>
#include <QWidget>
#include <set>

#include "studio/panels/outliner_model.h"

namespace betwixt::studio {

// A row dragged onto another one becomes its child; dragged to an empty place it loses its parent.
class OutlinerTree : public QTreeView {
  Q_OBJECT
 public:
  explicit OutlinerTree(Workspace&, OutlinerModel&, QWidget* parent = nullptr);

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void paintEvent(QPaintEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dragMoveEvent(QDragMoveEvent*) override;
  void dropEvent(QDropEvent*) override;

 private:
  std::vector<ObjectId> marked() const;
  void toggle(ObjectId);
  void drop(QPoint, Qt::KeyboardModifiers);
  void take_selection();

  Workspace& workspace_;
  OutlinerModel& model_;
  bool has_only_pieces(const QModelIndex&) const;
  void fold();
  // Objects that the user has closed, or opened. Others are open unless they have only pieces.
  std::set<std::uint32_t> folded_, opened_;
  std::optional<QPoint> pressed_;
  bool dragging_ = false, selecting_ = false, folding_ = false;
  QPoint at_;
};

class Outliner : public QWidget {
  Q_OBJECT
 public:
  explicit Outliner(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 private:
  OutlinerModel* model_;
  OutlinerTree* tree_;
  QLineEdit* pattern_;
};

}  // namespace betwixt::studio
