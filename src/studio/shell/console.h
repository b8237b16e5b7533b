// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The console: an input line, its help, and a log of all lines and answers.
#pragma once

#include <QLabel>
#include <QStringList>
#include <QWidget>

#include "studio/shell/word_edit.h"

namespace betwixt::studio {

// The input line. It grows while a bracket is open. Enter carries the line out; up and down recall earlier ones.
class ConsoleLine : public WordEdit {
  Q_OBJECT
 public:
  explicit ConsoleLine(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 Q_SIGNALS:
  void entered(const QString& line);

 protected:
  void keyPressEvent(QKeyEvent*) override;
  std::string said_so_far() const override;

 private:
  bool remember(int step);
  QStringList earlier_;
  qsizetype at_ = 0;  // position in the history; equal to its size: a new line
  QString begun_;     // the unfinished line, kept while an earlier one is shown
};

class Console : public QWidget {
  Q_OBJECT
 public:
  explicit Console(Workspace&, QWidget* parent = nullptr);

 private:
  void write_down(const QString& line, const QString& answer, bool refused);
  void carry_out(const QString& lines);
  void show_help();

  Workspace& workspace_;
  QPlainTextEdit* log_;
  QLabel *help_, *prompt_;
  ConsoleLine* line_;
};

}  // namespace betwixt::studio
