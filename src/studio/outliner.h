// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects of the film, what hangs on what, and what is seen.
#pragma once

#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>
#include <QWidget>
#include <set>

#include "studio/outliner_model.h"

namespace betwixt::studio {

// Rows are dragged onto others: what is dragged hangs on them then; where nothing is it hangs on nothing.
class OutlinerTree : public QTreeView {
  Q_OBJECT
 public:
  explicit OutlinerTree(Desk&, OutlinerModel&, QWidget* parent = nullptr);

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void paintEvent(QPaintEvent*) override;

 private:
  std::vector<ObjectId> marked() const;
  void toggle(ObjectId);
  void drop(QPoint, Qt::KeyboardModifiers);
  void take_selection();

  Desk& desk_;
  OutlinerModel& model_;
  std::set<std::uint32_t> folded_;
  std::optional<QPoint> pressed_;
  bool dragging_ = false, selecting_ = false;
  QPoint at_;
};

class Outliner : public QWidget {
  Q_OBJECT
 public:
  explicit Outliner(Desk&, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 private:
  void add(const QString& kind);

  Desk& desk_;
  OutlinerModel* model_;
  OutlinerTree* tree_;
  QLineEdit* pattern_;
};

}  // namespace betwixt::studio
