// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tree of attachments at a time. It is computed again only at times where an attachment changes, so playback stays
// cheap.
#pragma once

#include <QAbstractItemModel>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class OutlinerModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { name, eye };
  explicit OutlinerModel(Workspace&, QObject* parent = nullptr);

  // Shows only objects that match a pattern, and their parents. A word that is no object's name matches all names that
  // contain it; "" matches all.
  void filter(const QString& pattern);
  ObjectId object(const QModelIndex&) const;
  QModelIndex index_of(ObjectId, int column = name) const;
  bool shown(ObjectId) const;  // whether its display is on

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex&) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return 2; }
  QVariant data(const QModelIndex&, int role) const override;
  bool setData(const QModelIndex&, const QVariant&, int role) override;  // renames the object
  Qt::ItemFlags flags(const QModelIndex&) const override;

  // Rebuild the tree if the document or the time changes it.
  void follow_document();
  void follow_time();

 private:
  struct Node {
    ObjectId parent;
    int row = 0;
    bool there = false, wanted = true;
    std::vector<ObjectId> children;
    friend bool operator==(const Node&, const Node&) = default;
  };
  void make();
  const Node* node(ObjectId id) const;

  Workspace& workspace_;
  QString pattern_;
  std::vector<Node> nodes_;                          // by object index; the last one is the root
  Time from_ = earliest_time, until_ = latest_time;  // the time in which the tree is valid
};

}  // namespace betwixt::studio
