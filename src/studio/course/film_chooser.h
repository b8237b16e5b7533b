// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// File, New: a dialog with pictures of the films to begin with.
#pragma once

#include <QDialog>
#include <string>

#include "studio/assets/small_pictures.h"

class QLabel;
class QListWidget;

namespace betwixt::studio {

class FilmChooser : public QDialog {
  Q_OBJECT
 public:
  FilmChooser(const QStringList& opened_last, QWidget* parent);
  void await_pictures();  // for screenshots

 Q_SIGNALS:
  void chosen(const std::string& text);  // the script of a new film
  void wants_file(const QString&);       // a film that there is already; "": one for which to ask
  void wants_course();

 private:
  bool show_pictures();  // returns false while one is missing
  void choose();
  QWidget* list_of(const QStringList& files);

  SmallPictures pictures_;
  QListWidget* films_;
  QLabel* sentence_;
};

}  // namespace betwixt::studio
