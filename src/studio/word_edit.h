// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A place to write the language in: its words are offered while it is written. What it takes back is the film's own
// undo, never its own.
#pragma once

#include <QPlainTextEdit>
#include <QTreeWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class WordEdit : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit WordEdit(Desk&, QWidget* parent = nullptr);
  // Shows what the word before the cursor can become; a single word is put there at once.
  void offer_words();

 protected:
  // What shall be completed: the line up to the cursor, as somebody would say it.
  virtual std::string said_so_far() const;
  void keyPressEvent(QKeyEvent*) override;
  void focusOutEvent(QFocusEvent*) override;
  Desk& desk_;

 private:
  bool chooses(QKeyEvent*);
  void put(const QString& word);
  QTreeWidget* words_;
};

}  // namespace betwixt::studio
