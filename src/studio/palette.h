// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The palette of commands: whatever can be done is found by a few of its letters, and any line of the language is said.
#pragma once

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace betwixt::studio {

class Window;

// How well letters fit a name, the first of which stand in it in their order; 0: not at all.
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
