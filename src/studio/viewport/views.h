// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// One picture, or four: from above, from the front, from the right, and through the camera or the free view.
#pragma once

#include <QWidget>
#include <array>

#include "studio/viewport/viewport.h"

namespace betwixt::studio {

class Views : public QWidget {
  Q_OBJECT
 public:
  explicit Views(Workspace&, QWidget* parent = nullptr);
  Viewport& first() const { return *first_; }    // through the camera or the free view
  Viewport& active() const { return *active_; }  // the one in which the user worked last
  bool are_four() const { return four_; }
  void set_four(bool);
  std::vector<Viewport*> all() const;  // those that are shown

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void add(Viewport&);

  Workspace& workspace_;
  Viewport *first_, *active_;
  std::array<Viewport*, 3> sides_ = {};
  bool four_ = false;
};

}  // namespace betwixt::studio
