// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks against time: an exposure sheet that events are dragged about in.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class Sheet : public QWidget {
  Q_OBJECT
 public:
  explicit Sheet(Desk&, QWidget* parent = nullptr);

 private:
  Desk& desk_;
};

}  // namespace betwixt::studio
