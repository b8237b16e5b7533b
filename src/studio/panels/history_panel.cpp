// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/history_panel.h"

#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

constexpr std::size_t most_rows = 1000;  // the latest steps

QString words_of(const Session::PastStep& step) {
  if (step.line.starts_with("rewrite "))
    return HistoryPanel::tr("typed: %1").arg(text_of(step.line).section(' ', 1, 1));
  QString words = beginning_of(text_of(std::string_view(step.line).substr(0, 1000)), 500).simplified();
  if (!step.sheet.empty()) words = text_of(step.sheet) + ": " + words;
  if (step.lines > 1) words += HistoryPanel::tr(" and %1 more").arg(step.lines - 1);
  return words;
}

}  // namespace

HistoryPanel::HistoryPanel(Workspace& workspace, QWidget* parent) : QListWidget(parent), workspace_(workspace) {
  setObjectName("history");
  setWindowTitle(tr("History"));
  setAccessibleName(tr("History"));
  setUniformItemSizes(true);
  setFrameShape(QFrame::NoFrame);
  setToolTip(tr("Click a step to go back or forward to it: `undo`, `redo`"));
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { go_to(row(item)); });
  connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { go_to(row(item)); });
  connect(&workspace, &Workspace::text_changed, this, &HistoryPanel::refresh);
  connect(&workspace, &Workspace::opened, this, &HistoryPanel::refresh);
}

void HistoryPanel::showEvent(QShowEvent* e) {
  QListWidget::showEvent(e);
  refresh();
}

void HistoryPanel::refresh() {
  if (!isVisible() || going_) return;
  const std::vector<Session::PastStep> steps = workspace_.session().history(most_rows);
  clear();
  addItem(steps.size() < most_rows ? tr("the film as it was opened") : tr("earlier steps"));
  standing_ = 0;
  for (const Session::PastStep& step : steps) {
    auto* item = new QListWidgetItem(words_of(step), this);
    item->setToolTip(tip_of(beginning_of(text_of(std::string_view(step.line).substr(0, 4000)))));
    if (step.stands)
      standing_ = count() - 1;
    else
      item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
  }
  setCurrentRow(standing_);
  scrollToItem(item(standing_));
}

void HistoryPanel::go_to(int row) {
  if (going_) return;
  going_ = true;
  workspace_.settle_typing();
  for (int more = row - standing_; more != 0; more += more < 0 ? 1 : -1)
    if (!workspace_.say(std::string(more < 0 ? "undo" : "redo"))) break;
  going_ = false;
  refresh();
}

}  // namespace betwixt::studio
