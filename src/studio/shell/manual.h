// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The manual: the pages of docs, in a window.
#pragma once

#include <QDialog>
#include <QTextBrowser>

class QLineEdit;

namespace betwixt::studio {

// Returns the folder that has the pages; "" if they are not installed.
QString manual_folder();

class ManualPage : public QTextBrowser {
  Q_OBJECT
 public:
  explicit ManualPage(QWidget* parent);
  void go(const QUrl&);  // another page, or a place in one

 private:
  void go_to_heading(const QString& name);
  QVariant loadResource(int type, const QUrl&) override;
};

class Manual : public QDialog {
  Q_OBJECT
 public:
  explicit Manual(const QString& folder, QWidget* parent = nullptr);

 private:
  void find(const QString& words);

  ManualPage* page_;
  QLineEdit* search_;
};

}  // namespace betwixt::studio
