// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The language: a line, its help, and all that was said.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class Console : public QWidget {
  Q_OBJECT
 public:
  explicit Console(Desk&, QWidget* parent = nullptr);

 private:
  Desk& desk_;
};

}  // namespace betwixt::studio
