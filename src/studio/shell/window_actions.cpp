// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Actions of the window: time inserted and removed, objects added, and the palette.
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <utility>

#include "studio/poses/trial_dialog.h"
#include "studio/shell/palette.h"
#include "studio/shell/window.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/key_lines.h"
#include "studio/timeline/ripple.h"
#include "studio/timeline/ruler.h"
#include "track/twerpers.h"

namespace betwixt::studio {

void Window::insert_time() {
  bool chosen = false;
  const int frames = QInputDialog::getInt(this, tr("Insert time"), tr("Frames to insert at the playhead:"), 12, 1,
                                          1'000'000, 1, &chosen);
  if (!chosen) return;
  const Document& d = workspace_.document();
  const Lines lines = insert_time_lines(d, workspace_.time(), d.rate().span(frames));
  if (lines.empty()) return said_->setText(tr("there is nothing at or after the playhead"));
  workspace_.say(lines);
}

void Window::remove_time() {
  const Document& d = workspace_.document();
  const Time from = workspace_.playhead().first(), to = workspace_.playhead().last() + d.rate().span(1);
  if (std::pair(from, workspace_.playhead().last()) == d.range())
    return said_->setText(tr("set the part to remove first: I at its first frame, O at its last"));
  if (workspace_.say(remove_time_lines(d, from, to))) workspace_.set_range(std::nullopt);
}

void Window::add_note() {
  show_panel("timeline");
  if (auto* ruler = panel("timeline")->findChild<Ruler*>()) ruler->add_note();
}

void Window::ask_breakdown() {
  EventActions& events = EventActions::of(workspace_);
  if (events.breakdown(0.5).empty())
    return said_->setText(tr("the selection has no track with events before and after the playhead"));
  const auto lines = [&](double share) { return events.breakdown(share); };
  if (const auto share = ask_share(workspace_, this, tr("Breakdown: how far to the next event"), -20, 120, 50, lines))
    workspace_.say(lines(*share));
}

void Window::ask_retiming() {
  const auto share = [](const std::array<double, 4>& curve) {
    return [curve](double part) { return bezier_factor(part, curve); };
  };
  const std::vector<EventAt> selected = workspace_.events_selected();
  if (const auto [first, last] = span(selected); !(last > first))
    return said_->setText(tr("select events at two times or more"));
  const Document film = workspace_.document();
  const auto lines = [&](const std::array<double, 4>& curve) {
    return retime_lines(film, selected, retiming(film, selected, share(curve)));
  };
  if (const auto curve = ask_curve(workspace_, this, tr("Retime by a curve"), lines))
    EventActions::of(workspace_).warp(share(*curve));
}

void Window::add_object() { kinds_->popup(QCursor::pos()); }

void Window::find_command() {
  Palette palette(*this);
  palette.exec();
}

}  // namespace betwixt::studio
