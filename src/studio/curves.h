// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values against time, with their events.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class Curves : public QWidget {
  Q_OBJECT
 public:
  explicit Curves(Desk&, QWidget* parent = nullptr);

 private:
  Desk& desk_;
};

}  // namespace betwixt::studio
