// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The list of all keys: to search, to print, and true for keys that the user has changed.
#pragma once

#include <QDialog>

class QLineEdit;
class QTextBrowser;

namespace betwixt::studio {

class Window;

// Returns the list as a page, of the rows that fit some letters.
QString key_sheet_html(const QString& letters = {});

class KeySheet : public QDialog {
  Q_OBJECT
 public:
  explicit KeySheet(Window&);
  // Writes the list as HTML or, if the name ends so, as PDF. Returns "" or what is wrong.
  static QString write(const QString& file);

 private:
  QLineEdit* search_;
  QTextBrowser* page_;
};

}  // namespace betwixt::studio
