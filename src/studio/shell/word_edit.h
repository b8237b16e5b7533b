// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A text field with completion of script words. Undo here is the film's, never the field's own.
#pragma once

#include <QPlainTextEdit>
#include <QTreeWidget>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class WordEdit : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit WordEdit(Workspace&, QWidget* parent = nullptr);
  // Shows the completions of the word before the cursor; a single one is inserted at once.
  void offer_words();

 protected:
  // Returns the text to complete: the line up to the cursor, as one would type it in the console.
  virtual std::string said_so_far() const;
  void keyPressEvent(QKeyEvent*) override;
  void focusOutEvent(QFocusEvent*) override;
  Workspace& workspace_;

 private:
  bool chooses(QKeyEvent*);
  void put(const QString& word);
  QTreeWidget* words_;
};

}  // namespace betwixt::studio
