// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The window of preferences. Its pages are made from the table of preferences; changes take effect at once.
#pragma once

#include <QDialog>

class QListWidget;
class QStackedWidget;

namespace betwixt::studio {

struct Preference;

class PreferencesWindow : public QDialog {
  Q_OBJECT
 public:
  explicit PreferencesWindow(QWidget* parent = nullptr);
  void turn_to(const QString& page);  // by its name in the table

 private:
  QWidget* page_of(std::string_view name);
  QWidget* field_of(const Preference&);
  QListWidget* names_;
  QStackedWidget* pages_;
};

}  // namespace betwixt::studio
