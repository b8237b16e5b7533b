// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of the film (`data`), to look at: their columns, keys and rows.
#pragma once

#include <QAbstractTableModel>
#include <QWidget>
#include <memory>

#include "scene/table.h"
#include "studio/shell/workspace.h"

class QComboBox;
class QLabel;
class QTableView;

namespace betwixt::studio {

// The first rows of a table.
class TableRows : public QAbstractTableModel {
  Q_OBJECT
 public:
  static constexpr int most_rows = 10'000;
  using QAbstractTableModel::QAbstractTableModel;
  void show(const std::string& name, std::shared_ptr<const Table>);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex&, int role) const override;
  QVariant headerData(int section, Qt::Orientation, int role) const override;

 private:
  std::string name_;
  std::shared_ptr<const Table> table_;
};

class DataPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DataPanel(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {24 * fontMetrics().horizontalAdvance('m'), 300}; }

 protected:
  void showEvent(QShowEvent*) override;

 private:
  void refresh();
  void show_table();

  Workspace& workspace_;
  Tables tables_;  // that are listed
  QComboBox* names_;
  QLabel* about_;
  TableRows rows_;
  QTableView* view_;
};

}  // namespace betwixt::studio
