// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The dope sheet: a row for each object and each of its tracks, with events at their times.
#pragma once

#include <optional>

#include "studio/timeline/event_lines.h"
#include "studio/timeline/sheet_rows.h"
#include "studio/timeline/time_pane.h"

class QLineEdit;
class QScrollBar;

namespace betwixt::studio {

class SheetPane : public TimePane {
  Q_OBJECT
 public:
  explicit SheetPane(Workspace&, QWidget* parent = nullptr);

  const std::vector<SheetRow>& rows() const { return rows_; }
  void show_only_selected(bool);
  void search(const std::string&);
  // Returns the position of an event of a row.
  QPointF place(std::size_t row, Time) const;
  // Returns the box around the selected events that are shown; the user can drag its sides.
  std::optional<QRectF> box() const;

 protected:
  void paint_content(QPainter&) override;
  void resizeEvent(QResizeEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void press(QMouseEvent*) override;
  void drag(QMouseEvent*) override;
  void release(QMouseEvent*) override;
  void hover(QMouseEvent*) override;
  void call_off() override;
  bool key(int, Qt::KeyboardModifiers, bool act) override;
  void wheel(QWheelEvent*) override;
  void pan(double) override;

 private:
  enum class Hand { none, box, move, stretch_left, stretch_right };
  void lay_out();
  double row_top(std::size_t row) const;
  std::optional<std::size_t> row_at(double y) const;
  double half() const { return line_height() * 0.26; }  // half the size of an event's diamond
  std::vector<EventAt> events_at(const QPointF&) const;
  std::vector<EventAt> events_in(const QRectF&) const;
  void press_name(QMouseEvent*, std::size_t row);
  // Return the new time of an event, and the lines, of the current drag. Return nullopt or no lines if there is none.
  std::optional<Time> retimed(Time) const;
  Lines lines() const;
  void keep_selection();  // updates picked_
  void edit(const EventAt&);
  void go_to_row(int by);
  void paint_names(QPainter&) const;
  void paint_row(QPainter&, std::size_t row) const;
  void paint_track(QPainter&, const Target&, double y, bool whole) const;

  SheetChoice choice_;
  bool only_selected_ = true;
  std::vector<SheetRow> rows_;
  PickedTimes picked_;  // the selection as shown, with the drag applied
  std::size_t current_ = 0;
  QScrollBar* scroll_;
  QLineEdit* words_ = nullptr;

  Hand hand_ = Hand::none;
  QPointF from_, to_;
  Time held_;                       // the dragged event
  std::pair<Time, Time> was_, is_;  // the span of the selection, before and after the drag
  std::vector<EventAt> before_;     // the selection before a box adds to it
};

}  // namespace betwixt::studio
