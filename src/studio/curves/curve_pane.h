// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The curves of the selected objects, with points, handles and eases that the user can drag.
#pragma once

#include <QTimer>
#include <optional>
#include <set>

#include "studio/curves/curve_lines.h"
#include "studio/curves/curve_samples.h"
#include "studio/timeline/time_pane.h"

class QMenu;

namespace betwixt::studio {

class CurvePane : public TimePane {
  Q_OBJECT
 public:
  explicit CurvePane(Workspace&, QWidget* parent = nullptr);

  QColor color(const CurveLine&) const;
  const std::vector<CurveLine>& lines() const { return lines_; }
  const CurveSamples& samples() const { return samples_; }
  void finish();           // computes all columns now, for tests and screenshots
  void fit();              // scales the view to all values of the visible curves
  void frame_all();        // shows all times of the film, too
  void frame_selection();  // shows the times of the selected events, and the values there
  // Keeps the curves as they are, to compare with them; or forgets them.
  void freeze(bool);
  bool has_reference() const { return !reference_.empty(); }
  // Returns the curve that was clicked last, if it has selected events; otherwise the first one that has.
  std::optional<std::size_t> active() const;
  // Scales each curve to the full height, so that metres and degrees are readable together.
  void let_each_fill(bool);
  bool each_fills() const { return each_fills_; }
  QPointF place(std::size_t line, Time t, double value) const { return {x_of(t), y_of(line, value)}; }
  QPointF place(std::size_t line, const Handle& h) const;
  const std::vector<QRectF>& twerper_boxes() const { return words_; }
  // Returns the overshoots, each with the index of its curve.
  const std::vector<std::pair<std::size_t, LineSwing>>& swings() const { return swings_; }
  // Returns the handles of the selected events on visible curves.
  std::vector<std::pair<std::size_t, Handle>> handles() const;

 Q_SIGNALS:
  void fill_changed(bool);
  void reference_changed(bool);

 protected:
  void paint_content(QPainter&) override;
  void resizeEvent(QResizeEvent*) override;
  void showEvent(QShowEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void press(QMouseEvent*) override;
  void drag(QMouseEvent*) override;
  void release(QMouseEvent*) override;
  void hover(QMouseEvent*) override;
  void call_off() override;
  bool key(int, Qt::KeyboardModifiers, bool act) override;
  void wheel(QWheelEvent*) override;
  void pan(double) override;

 private:
  enum class Hand { none, box, points, handle };
  double y_of(double level) const { return middle_ - (level - center_) * scale_; }
  double level_at(double y) const { return center_ + (middle_ - y) / scale_; }
  double y_of(std::size_t line, double value) const { return y_of((value - base_[line]) / unit_[line]); }
  double reach() const { return line_height() * 0.3; }
  double strip(std::size_t line) const;  // the middle of a colour's band
  bool seen(std::size_t line) const { return !hidden_.contains(lines_[line].name); }
  void lay_out();
  void sample();  // starts again
  void go_on();
  std::vector<std::pair<std::size_t, Handle>> points() const;  // of the events in view
  std::optional<std::pair<std::size_t, Handle>> point_at(const QPointF&) const;
  std::optional<std::pair<std::size_t, Handle>> handle_at(const QPointF&) const;
  bool is_selected(const EventAt& e) const { return picked_.has(e); }
  Lines said_by(QMouseEvent*);  // the lines for the current drag
  void press_name(QMouseEvent*);
  bool press_twerper(const QPointF&);
  void paint_values(QPainter&) const;
  void paint_names(QPainter&) const;
  void paint_curves(QPainter&) const;
  void paint_events(QPainter&) const;
  void paint_twerpers(QPainter&) const;
  void paint_swings(QPainter&) const;
  void paint_reference(QPainter&) const;
  void fill_curve_menu(QMenu&);
  const LineSwing* swing_at(const QPointF&) const;

  std::vector<CurveLine> lines_;
  Document laid_out_;  // the film that the lines are of
  std::vector<std::pair<std::size_t, LineSwing>> swings_;
  std::vector<ObjectId> shown_;  // the objects of the curves
  PickedTimes picked_;
  std::set<std::string> hidden_;  // curves by name, whatever the object
  CurveSamples samples_;
  QTimer more_;
  double center_ = 0, scale_ = 50, middle_ = 0;  // the value in the middle; pixels for 1; the y of the middle
  std::vector<double> base_, unit_;              // of each curve: 0 and 1, or its own fit
  bool fitted_ = false, each_fills_ = false;
  std::pair<double, double> fit_;  // center_ and scale_ after the last fit

  struct Reference {
    Target target;
    int part = 0;
    std::vector<std::pair<Time, double>> points;
  };
  std::vector<Reference> reference_;
  std::pair<Target, int> active_;  // the track and the number of the curve that was clicked last

  Hand hand_ = Hand::none;
  QPointF from_, to_;
  std::size_t line_ = 0;  // the curve that is being dragged
  Handle held_;
  Time by_;
  std::vector<EventAt> before_;
  mutable std::vector<QRectF> words_;  // boxes of the twerpers' labels
};

}  // namespace betwixt::studio
