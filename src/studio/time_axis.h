// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where times lie from left to right: one for all panels of a desk, so that what happens together stands below each
// other.
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "studio/desk.h"

namespace betwixt::studio {

class TimeAxis : public QObject {
  Q_OBJECT
 public:
  static TimeAxis& of(Desk&);

  // In pixels from where the panels' time begins.
  double x_of(Time t) const { return (t.seconds() - first_) * scale_; }
  Time time_at(double x) const;
  double frame_width() const { return scale_ / desk_.document().rate().per_second(); }
  void zoom(double factor, double x);  // what is at x stays there
  void scroll(double pixels);
  void show(Time from, Time to, double width);  // all of it, and a little more
  // The whole film, as long as nobody has zoomed or scrolled since it was opened.
  void fit(double width);
  void fit_again() { touched_ = false; }

  // How times are written: frames, or seconds.
  bool in_seconds() const { return in_seconds_; }
  void count_in_seconds(bool);
  // What stands left of the time, in pixels, equally wide in all panels.
  int gutter() const { return gutter_; }
  void set_gutter(int);

  // Where the ruler has lines from x = 0 to `width`; those with a label are main ones.
  struct Tick {
    double x;
    QString label;
  };
  std::vector<Tick> ticks(double width, double label_width) const;

 Q_SIGNALS:
  void changed();

 private:
  explicit TimeAxis(Desk&);

  Desk& desk_;
  double first_ = 0, scale_ = 100;  // seconds; pixels a second
  double width_ = 0;                // that it was to be fitted into last
  std::optional<std::pair<Time, Time>> fitted_;
  bool touched_ = false, in_seconds_ = false;
  int gutter_ = 0;
};

}  // namespace betwixt::studio
