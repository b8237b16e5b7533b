// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/data_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "language/values.h"
#include "scene/document.h"
#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

// Returns the first keys of a table, as names of objects have them.
QString first_keys(const Table& table) {
  constexpr std::size_t most = 5;
  QStringList keys;
  for (std::size_t i = 0; i < std::min(most, table.keys.size()); ++i) keys += text_of(table.keys[i]);
  return keys.join(", ") + (table.keys.size() > most ? " …" : "");
}

QString about_table(const Table& table) {
  QStringList all;
  all += DataPanel::tr("%1 rows, %2 columns").arg(table.rows()).arg(table.columns.size());
  if (table.key)
    all += DataPanel::tr("%1 keys in %2: %3")
               .arg(table.keys.size())
               .arg(text_of(table.columns[*table.key].name), first_keys(table));
  if (table.over) all += DataPanel::tr("times in %1").arg(text_of(table.columns[*table.over].name));
  if (!table.file.empty()) all += text_of(table.file);
  if (table.rows() > TableRows::most_rows)
    all += DataPanel::tr("only the first %1 rows are shown").arg(TableRows::most_rows);
  return all.join("\n");
}

QString word_of_type(TableColumn::Of of) {
  return of == TableColumn::Of::number ? DataPanel::tr("numbers")
         : of == TableColumn::Of::date ? DataPanel::tr("dates")
                                       : DataPanel::tr("texts");
}

}  // namespace

void TableRows::show(const std::string& name, std::shared_ptr<const Table> table) {
  beginResetModel();
  name_ = name, table_ = std::move(table);
  endResetModel();
}

int TableRows::rowCount(const QModelIndex& parent) const {
  if (parent.isValid() || !table_) return 0;
  return static_cast<int>(std::min<std::size_t>(most_rows, table_->rows()));
}

int TableRows::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || !table_ ? 0 : static_cast<int>(table_->columns.size());
}

QVariant TableRows::data(const QModelIndex& at, int role) const {
  if (!table_ || !at.isValid()) return {};
  const TableColumn& column = table_->columns[static_cast<std::size_t>(at.column())];
  const auto row = static_cast<std::size_t>(at.row());
  if (role == Qt::TextAlignmentRole)
    return int(column.of == TableColumn::Of::number ? Qt::AlignRight | Qt::AlignVCenter
                                                    : Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole || !column.has(row)) return {};
  if (column.of == TableColumn::Of::number) return text_of(write_number(column.numbers[row]));
  return beginning_of(text_of(column.cells[row].substr(0, 1000)), 200).simplified();
}

QVariant TableRows::headerData(int section, Qt::Orientation direction, int role) const {
  if (direction == Qt::Vertical || !table_ || section >= columnCount())
    return role == Qt::DisplayRole && direction == Qt::Vertical ? QVariant(section + 1) : QVariant();
  const TableColumn& column = table_->columns[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) return text_of(column.name);
  // What a formula writes for the column.
  if (role == Qt::ToolTipRole) return tip_of(text_of(name_ + "." + column.name) + ": " + word_of_type(column.of));
  return {};
}

DataPanel::DataPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      names_(new QComboBox(this)),
      about_(new QLabel(this)),
      view_(new QTableView(this)) {
  setObjectName("data");
  setWindowTitle(tr("Data"));
  names_->setObjectName("data_names"), names_->setAccessibleName(tr("Tables of the film"));
  names_->setToolTip(tr("The tables that the script reads: data NAME from \"FILE\""));
  about_->setObjectName("data_about"), about_->setWordWrap(true), about_->setTextFormat(Qt::PlainText);
  view_->setObjectName("data_rows"), view_->setAccessibleName(tr("Rows of the table"));
  view_->setModel(&rows_);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setTabKeyNavigation(false), view_->setCornerButtonEnabled(false);  // Tab leaves the panel
  view_->setFrameShape(QFrame::NoFrame), view_->setAlternatingRowColors(true);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(4, 4, 4, 0);
  all->addWidget(names_), all->addWidget(about_), all->addWidget(view_, 1);
  setFocusProxy(view_);
  connect(names_, &QComboBox::currentIndexChanged, this, &DataPanel::show_table);
  connect(&workspace, &Workspace::document_changed, this, &DataPanel::refresh);
  connect(&workspace, &Workspace::opened, this, &DataPanel::refresh);
  show_table();
}

void DataPanel::showEvent(QShowEvent* e) {
  QWidget::showEvent(e);
  refresh();
}

void DataPanel::refresh() {
  if (!isVisible()) return;
  const Tables& now = *workspace_.document().scene().tables;
  if (now == tables_) return;  // tables never change, so equal pointers are equal tables
  tables_ = now;
  const QString before = names_->currentText();
  {
    const QSignalBlocker quiet(names_);
    names_->clear();
    for (const auto& [name, table] : tables_) names_->addItem(text_of(name));
    names_->setCurrentIndex(std::max(0, names_->findText(before)));
  }
  show_table();
}

void DataPanel::show_table() {
  const std::string name = names_->currentText().toStdString();
  const auto found = tables_.find(name);
  const std::shared_ptr<const Table> table = found == tables_.end() ? nullptr : found->second;
  names_->setVisible(table != nullptr);
  about_->setText(table ? about_table(*table)
                        : tr("The film has no tables. A line such as this one reads one:\ndata pop from \"pop.csv\""));
  rows_.show(name, table);
}

}  // namespace betwixt::studio
