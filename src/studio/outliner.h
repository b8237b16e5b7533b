// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// All objects, and what hangs on what.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class Outliner : public QWidget {
  Q_OBJECT
 public:
  explicit Outliner(Desk&, QWidget* parent = nullptr);

 private:
  Desk& desk_;
};

}  // namespace betwixt::studio
