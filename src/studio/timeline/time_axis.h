// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps times to x positions. All panels of a workspace share one axis, so that events at the same time line up.
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class TimeAxis : public QObject {
  Q_OBJECT
 public:
  static TimeAxis& of(Workspace&);

  // Convert pixels, counted from the left end of the time area.
  double x_of(Time t) const { return (t.seconds() - first_) * scale_; }
  Time time_at(double x) const;
  double frame_width() const { return scale_ / workspace_.document().rate().per_second(); }
  void zoom(double factor, double x);  // the time at x stays at x
  void scroll(double pixels);
  void show(Time from, Time to, double width);  // fits a span of time, with a small margin
  // Fits the whole film, unless the user has zoomed or scrolled since it was opened.
  void fit(double width);
  void fit_again() { touched_ = false; }

  // Whether times are shown in seconds instead of frames.
  bool in_seconds() const { return in_seconds_; }
  void count_in_seconds(bool);
  // The width of the area left of the time, in pixels, equal in all panels.
  int gutter() const { return gutter_; }
  void set_gutter(int);

  // Returns the lines of the ruler from x = 0 to `width`. Main lines have a label.
  struct Tick {
    double x;
    QString label;
  };
  std::vector<Tick> ticks(double width, double label_width) const;

 Q_SIGNALS:
  void changed();

 private:
  explicit TimeAxis(Workspace&);

  Workspace& workspace_;
  double first_ = 0, scale_ = 100;  // seconds; pixels a second
  double width_ = 0;                // width of the last fit()
  std::optional<std::pair<Time, Time>> fitted_;
  bool touched_ = false, in_seconds_ = false;
  int gutter_ = 0;
};

}  // namespace betwixt::studio
