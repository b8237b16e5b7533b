// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The exposure sheet as on paper: a column for each track, a row for each frame, values in the cells.
#pragma once

#include <QWidget>
#include <optional>

#include "studio/timeline/event_lines.h"
#include "studio/timeline/sheet_rows.h"

class QLineEdit;
class QScrollBar;

namespace betwixt::studio {

class Exposures : public QWidget {
  Q_OBJECT
 public:
  explicit Exposures(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override;

  const std::vector<Target>& columns() const { return columns_; }
  void show_only_selected(bool);
  void search(const std::string&);
  QRectF cell(std::size_t column, int frame) const;

 protected:
  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  enum class Hand { none, scrub, box, move };
  int line_height() const;
  int head() const { return 2 * line_height() + 4; }  // height of the tracks' names
  int side() const;                                   // width of the frame numbers
  int column_width() const;
  int frame_at(double y) const;
  std::optional<std::size_t> column_at(double x) const;
  Time begin(int frame) const { return workspace_.document().rate().frame(frame); }
  std::vector<EventAt> events_in(std::size_t column, int first, int last) const;  // first and last frame
  void lay_out();
  void show_frame();  // scrolls to the playhead
  void edit(std::size_t column, int frame);
  bool key(int, Qt::KeyboardModifiers, bool act);
  void call_off();
  void paint_column(QPainter&, std::size_t column, int first, int last) const;

  Workspace& workspace_;
  SheetChoice choice_;
  bool only_selected_ = true;
  std::vector<Target> columns_;
  PickedTimes picked_;
  std::size_t current_ = 0;
  int first_ = 1;  // frame of the first row
  QScrollBar *down_, *across_;
  QLineEdit* words_ = nullptr;
  Hand hand_ = Hand::none;
  QPointF from_, to_;
  Time by_;
  std::vector<EventAt> before_;
};

}  // namespace betwixt::studio
