// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What hangs on what at a time, as a tree. Between two changes nothing is looked at again, however long it plays.
#pragma once

#include <QAbstractItemModel>

#include "studio/desk.h"

namespace betwixt::studio {

class OutlinerModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { name, eye };
  explicit OutlinerModel(Desk&, QObject* parent = nullptr);

  // Only what a pattern of the language names, and what that hangs on; a word that is no name stands for all that have
  // it in theirs; "": all.
  void filter(const QString& pattern);
  ObjectId object(const QModelIndex&) const;
  QModelIndex index_of(ObjectId, int column = name) const;
  bool shown(ObjectId) const;  // whether its display is on

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex&) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return 2; }
  QVariant data(const QModelIndex&, int role) const override;
  bool setData(const QModelIndex&, const QVariant&, int role) override;  // another name: said
  Qt::ItemFlags flags(const QModelIndex&) const override;

  // The film or the time is another one; makes the tree anew where that changes it.
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

  Desk& desk_;
  QString pattern_;
  std::vector<Node> nodes_;  // by the numbers of the objects; behind them the one that holds what hangs on nothing
  Time from_ = from_the_beginning, until_ = for_good;  // while the tree is the same
};

}  // namespace betwixt::studio
