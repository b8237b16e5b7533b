// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/time_axis.h"

#include <QApplication>
#include <QFontMetrics>
#include <algorithm>
#include <cmath>

namespace betwixt::studio {
namespace {

constexpr double narrowest = 1e-3, widest = 1e6;  // limits of scale_, pixels a second

// Returns the smallest step of 1, 2, 5, 10, 20 … that is at least `least`.
double round_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double k : {1., 2., 5.})
    if (k * power >= least * (1 - 1e-9)) return k * power;
  return 10 * power;
}

}  // namespace

TimeAxis::TimeAxis(Workspace& workspace) : QObject(&workspace), workspace_(workspace) {
  gutter_ = 26 * QFontMetrics(QApplication::font()).averageCharWidth();
  connect(&workspace, &Workspace::opened, this, [this] { touched_ = false, emit changed(); });
  connect(&workspace, &Workspace::document_changed, this, [this] {
    if (!touched_ && fitted_ && *fitted_ != workspace_.document().range()) fit(width_);
  });
  // Scrolls to a playhead outside the view, but not while the user drags.
  connect(&workspace, &Workspace::time_changed, this, [this] {
    const double x = x_of(workspace_.time());
    if (width_ < 1 || (x >= 0 && x <= width_) || QApplication::mouseButtons() != Qt::NoButton) return;
    first_ += (x - (x < 0 ? 0.1 : 0.9) * width_) / scale_;
    emit changed();
  });
}

TimeAxis& TimeAxis::of(Workspace& workspace) {
  if (auto* axis = workspace.findChild<TimeAxis*>(QString(), Qt::FindDirectChildrenOnly)) return *axis;
  return *new TimeAxis(workspace);
}

Time TimeAxis::time_at(double x) const {
  return from_seconds(std::clamp(first_ + x / scale_, -longest_seconds, longest_seconds));
}

void TimeAxis::zoom(double factor, double x) {
  const double at = first_ + x / scale_;
  scale_ = std::clamp(scale_ * factor, narrowest, widest);
  first_ = at - x / scale_;
  touched_ = true;
  emit changed();
}

void TimeAxis::scroll(double pixels) {
  first_ = std::clamp(first_ + pixels / scale_, -longest_seconds, longest_seconds);
  touched_ = true;
  emit changed();
}

void TimeAxis::show(Time from, Time to, double width) {
  constexpr double margin = 0.035;
  const double length = std::max((to - from).seconds(), workspace_.document().rate().span(1).seconds());
  scale_ = std::clamp(width / (length * (1 + 2 * margin)), narrowest, widest);
  first_ = from.seconds() - margin * length;
  touched_ = true;
  emit changed();
}

void TimeAxis::fit(double width) {
  if (width >= 1) width_ = width;
  if (touched_ || width < 1) return;
  const auto [from, to] = workspace_.document().range();
  width_ = width, fitted_ = workspace_.document().range();
  show(from, to, width);
  touched_ = false;
}

void TimeAxis::count_in_seconds(bool seconds) {
  in_seconds_ = seconds;
  emit changed();
}

void TimeAxis::set_gutter(int pixels) {
  gutter_ = std::max(0, pixels);
  emit changed();
}

std::vector<TimeAxis::Tick> TimeAxis::ticks(double width, double label_width) const {
  const Rate rate = workspace_.document().rate();
  const double unit = in_seconds_ ? 1 : 1 / rate.per_second(), offset = in_seconds_ ? 0 : 1;  // frame 1 is time 0
  const double least = 1.4 * label_width / (scale_ * unit);
  const double labelled = in_seconds_ ? round_step(least) : std::max(1.0, round_step(least));
  double between = labelled / 5;
  if (!in_seconds_ && between < 1) between = frame_width() >= 3 ? 1 : labelled;
  std::vector<Tick> all;
  const double from = std::floor((first_ / unit + offset) / between), to = (first_ + width / scale_) / unit + offset;
  for (double i = from; i * between <= to && all.size() < 10'000; ++i) {
    const double n = i * between, turns = n / labelled;
    const bool main = std::abs(turns - std::round(turns)) < 1e-6;
    const QString label = main ? QString::number(n, 'g', 9) + (in_seconds_ ? " s" : "") : QString();
    all.push_back({((n - offset) * unit - first_) * scale_, label});
  }
  return all;
}

}  // namespace betwixt::studio
