// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The file itself, which is edited live.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class ScriptPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ScriptPanel(Desk&, QWidget* parent = nullptr);

 private:
  Desk& desk_;
};

}  // namespace betwixt::studio
