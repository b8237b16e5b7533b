// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of the preferences that changes keys: search an action, press its new key.
#pragma once

#include <QKeySequence>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace betwixt::studio {

struct KeyRow;

// A field that takes a key instead of letters.
class KeyField;

// A choice of the preset, which follows it.
QComboBox* make_preset_box(QWidget* parent);

class KeysPage : public QWidget {
  Q_OBJECT
 public:
  explicit KeysPage(QWidget* parent = nullptr);

 private:
  void list();
  void show_row();
  const KeyRow* chosen() const;
  void press(const QKeySequence&);
  void search(const QString&);

  QLineEdit* search_;
  QTreeWidget* rows_;
  KeyField* field_;
  QLabel* says_;
  QPushButton *take_, *none_, *reset_;
};

}  // namespace betwixt::studio
