// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// All display functions of what is selected, and what makes their values now.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class Properties : public QWidget {
  Q_OBJECT
 public:
  explicit Properties(Desk&, QWidget* parent = nullptr);

 private:
  Desk& desk_;
};

}  // namespace betwixt::studio
