// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The picture, in which things are selected and moved.
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "studio/desk.h"
#include "studio/picture_maker.h"

namespace betwixt::studio {

class Viewport : public QWidget {
  Q_OBJECT
 public:
  explicit Viewport(Desk&, QWidget* parent = nullptr);

  // The picture that belongs to the time and the film by now: waits for it. For screenshots and tests.
  void await_picture();
  void set_style(const std::string& style);
  const std::string& style() const { return style_; }
  QSize sizeHint() const override { return {640, 360}; }

 signals:
  void style_changed();

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  PictureWanted wanted() const;
  QRect frame_box() const;  // where the film's picture is, in the widget
  void ask();
  void take(const PictureMade&);

  Desk& desk_;
  PictureMaker maker_;
  PictureMade shown_;
  std::string style_ = "shaded";
};

}  // namespace betwixt::studio
