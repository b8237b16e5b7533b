// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What part of time and values the curves show, the reference to compare with, and the panel's own menu.
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "betwixt/object.h"
#include "studio/curves/curve_actions.h"
#include "studio/curves/curve_pane.h"
#include "studio/panels/new_parts.h"
#include "studio/shell/text_of.h"

namespace betwixt::studio {

void CurvePane::fit() {
  std::vector<std::pair<double, double>> spans(lines_.size(), {1e300, -1e300});
  const auto take = [&](std::size_t line, std::optional<double> v) {
    if (!v || !std::isfinite(*v)) return;
    spans[line] = {std::min(spans[line].first, *v), std::max(spans[line].second, *v)};
  };
  for (std::size_t i = 0; i < lines_.size(); ++i)
    for (std::size_t c = 0; seen(i) && !lines_[i].swatch && c < samples_.columns(); ++c)
      take(i, samples_.final(i, c)), take(i, samples_.has_bare(i) ? samples_.bare(i, c) : std::nullopt);
  for (const auto& [line, h] : points()) take(line, h.value);
  // All curves, or those of one function if each fills the height.
  const auto alike = [&](std::size_t a, std::size_t b) {
    const Target &s = lines_[a].target, &t = lines_[b].target;
    return !each_fills_ || (s.object == t.object && s.function == t.function && s.velocity == t.velocity);
  };
  const auto together = [&](std::size_t line) {
    std::pair<double, double> all{1e300, -1e300};
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (alike(line, i)) all = {std::min(all.first, spans[i].first), std::max(all.second, spans[i].second)};
    if (all.first > all.second) all = {-1, 1};
    const double least = std::max(1e-9, std::abs(all.first) * 1e-6);
    if (all.second - all.first < least) all = {all.first - 1, all.second + 1};
    return all;
  };
  const double room = std::max(10.0, (height() - ruler_height()) * 0.8);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto [low, high] = together(i);
    base_[i] = each_fills_ ? low : 0, unit_[i] = each_fills_ ? high - low : 1;
    center_ = each_fills_ ? 0.5 : (low + high) / 2, scale_ = each_fills_ ? room : room / (high - low);
  }
  fit_ = {center_, scale_};
  update();
}

void CurvePane::let_each_fill(bool on) {
  each_fills_ = on;
  finish(), fit();
  emit fill_changed(on);
}

void CurvePane::frame_all() {
  const auto [first, last] = workspace_.document().range();
  axis_.show(first, last, time_box().width());
  finish(), fit();
}

void CurvePane::frame_selection() {
  const std::vector<EventAt>& events = workspace_.events_selected();
  if (events.empty()) return frame_all();
  auto [first, last] = span(events);
  const Time margin = first == last ? workspace_.document().rate().span(6) : (last - first);
  const std::int64_t room = first == last ? margin.flicks : margin.flicks / 8;
  axis_.show(Time{first.flicks - room}, Time{last.flicks + room}, time_box().width());
  finish();
  double low = 1e300, high = -1e300;
  const auto take = [&](std::size_t line, std::optional<double> v) {
    if (!v || !std::isfinite(*v)) return;
    const double level = (*v - base_[line]) / unit_[line];
    low = std::min(low, level), high = std::max(high, level);
  };
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!seen(i) || lines_[i].swatch) continue;
    if (std::ranges::none_of(events, [&](const EventAt& e) { return e.target == lines_[i].target; })) continue;
    for (std::size_t c = 0; c < samples_.columns(); ++c) take(i, samples_.final(i, c));
  }
  if (low > high) return;
  const double least = std::max(1e-9, std::abs(low) * 1e-6);
  if (high - low < least) low -= 1, high += 1;
  center_ = (low + high) / 2, scale_ = std::max(10.0, (height() - ruler_height()) * 0.8) / (high - low);
  update();
}

std::optional<std::size_t> CurvePane::active() const {
  const std::vector<EventAt>& events = workspace_.events_selected();
  const auto has = [&](const Target& t) {
    return std::ranges::any_of(events, [&](const EventAt& e) { return e.target == t; });
  };
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!has(lines_[i].target) || lines_[i].swatch) continue;
    if (lines_[i].target == active_.first && lines_[i].part == active_.second) return i;
    if (!first && seen(i)) first = i;
  }
  return first;
}

void CurvePane::freeze(bool on) {
  reference_.clear();
  if (on) {
    finish();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      Reference frozen{lines_[i].target, lines_[i].part, {}};
      for (std::size_t c = 0; c < samples_.columns() && !lines_[i].swatch; ++c)
        if (const auto v = samples_.final(i, c))
          frozen.points.emplace_back(time_at(axis_.gutter() + static_cast<double>(c)), *v);
      reference_.push_back(std::move(frozen));
    }
  }
  emit reference_changed(has_reference());
  update();
}

void CurvePane::fill_curve_menu(QMenu& menu) {
  const Document& d = workspace_.document();
  std::vector<Target> functions;
  if (const auto line = active())
    functions.emplace_back(lines_[*line].target.object, lines_[*line].target.function);
  else
    for (const CurveLine& l : lines_)
      if (functions.empty() && l.tracked) functions.emplace_back(l.target.object, l.target.function);
  if (!functions.empty()) {
    QMenu* parts = menu.addMenu(tr("Add to %1").arg(text_of(d.name(functions[0]))));
    fill_new_parts(*parts, workspace_, new_parts(d, workspace_.program(), functions, workspace_.time()));
  }
  fill_curve_actions(menu, workspace_, this);
  menu.addSeparator();
  connect(menu.addAction(tr("Show all values") + "\tF"), &QAction::triggered, this, [this] { finish(), fit(); });
  connect(menu.addAction(tr("Frame all") + "\tHome"), &QAction::triggered, this, &CurvePane::frame_all);
  connect(menu.addAction(tr("Frame selection") + "\t."), &QAction::triggered, this, &CurvePane::frame_selection);
  QAction* frozen = menu.addAction(tr("Keep as reference"));
  frozen->setCheckable(true), frozen->setChecked(has_reference());
  connect(frozen, &QAction::triggered, this, &CurvePane::freeze);
}

}  // namespace betwixt::studio
