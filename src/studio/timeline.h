// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The ruler that the playhead is on, with notes and cuts; keys to play.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class Timeline : public QWidget {
  Q_OBJECT
 public:
  explicit Timeline(Desk&, QWidget* parent = nullptr);

 private:
  Desk& desk_;
};

}  // namespace betwixt::studio
