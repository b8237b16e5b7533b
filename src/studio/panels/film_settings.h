// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The settings of the film: rate, range, size, background and so on. Each is a command of the language.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <vector>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class FilmSettings : public QWidget {
  Q_OBJECT
 public:
  explicit FilmSettings(Workspace&, QWidget* parent = nullptr);
  void refresh();  // shows the settings of the workspace's film

 private:
  struct Row {
    std::string verb;
    QComboBox* box;
    QLabel* called;
  };
  void say(const Row&);
  void choose_color(const Row&);
  void choose_file(const Row&, const char* endings);

  Workspace& workspace_;
  std::vector<Row> rows_;
};

}  // namespace betwixt::studio
