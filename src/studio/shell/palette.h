// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The command palette: finds commands by a few of their letters, and carries out any script line.
#pragma once

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace betwixt::studio {

class Window;

// Returns the score of a match, in which the name has all letters in this order; 0 if it does not match.
int fit(const QString& letters, const QString& name);

class Palette : public QDialog {
  Q_OBJECT
 public:
  explicit Palette(Window&);

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void list(const QString& letters);
  void run();

  Window& window_;
  QLineEdit* line_;
  QListWidget* found_;
};

}  // namespace betwixt::studio
