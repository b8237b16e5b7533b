// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Actions of the window: the size of text, time inserted and removed, the palette, and the list of keys.
#include <QApplication>
#include <QInputDialog>
#include <QLabel>
#include <QShortcut>
#include <QTextBrowser>
#include <algorithm>
#include <utility>

#include "studio/poses/trial_dialog.h"
#include "studio/shell/actions.h"
#include "studio/shell/palette.h"
#include "studio/shell/text_of.h"
#include "studio/shell/window.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/key_lines.h"
#include "studio/timeline/ripple.h"
#include "studio/timeline/ruler.h"
#include "track/twerpers.h"

namespace betwixt::studio {

void Window::set_text_size(double size) {
  size = std::clamp(size, 0.7, 2.5);
  const double by = size / std::exchange(text_size_, size);
  const auto scaled = [by](QFont f) {
    f.setPointSizeF(f.pointSizeF() * by);
    return f;
  };
  // Widgets with a font of their own do not follow that of the application.
  for (QWidget* w : findChildren<QWidget*>())
    if (w->testAttribute(Qt::WA_SetFont) && w->font().pointSizeF() > 0) w->setFont(scaled(w->font()));
  QApplication::setFont(scaled(QApplication::font()));
}

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

void Window::find_command() {
  Palette palette(*this);
  palette.exec();
}

void Window::show_keys() {
  auto* page = new QTextBrowser(this);
  page->setWindowFlag(Qt::Window);  // closes with this window
  connect(new QShortcut(Qt::Key_Escape, page), &QShortcut::activated, page, &QWidget::close);
  page->setAttribute(Qt::WA_DeleteOnClose);
  page->setWindowTitle(tr("Keys"));
  QString html = "<table cellpadding='4'>";
  std::string_view menu;
  for (const ActionRow& row : action_rows()) {
    if (row.menu != menu) html += "<tr><td colspan='3'><b>" + text_of(menu = row.menu) + "</b></td></tr>";
    html += "<tr><td>" + text_of(row.keys).toHtmlEscaped() + "</td><td>" + text_of(row.name).toHtmlEscaped() +
            "</td><td>" + text_of(row.sentence).toHtmlEscaped() + "</td></tr>";
  }
  page->setHtml(html + "</table>");
  page->resize(60 * fontMetrics().height(), 40 * fontMetrics().height());
  page->show();
}

}  // namespace betwixt::studio
