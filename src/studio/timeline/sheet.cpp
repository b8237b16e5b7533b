// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/sheet.h"

#include <QFocusEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QStackedLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "studio/timeline/exposures.h"
#include "studio/timeline/sheet_pane.h"

namespace betwixt::studio {

Sheet::Sheet(Workspace& workspace, QWidget* parent) : QWidget(parent), either_(new QStackedLayout) {
  setObjectName("sheet");
  setWindowTitle(tr("Sheet"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0), all->setSpacing(0);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(4, 2, 4, 2), bar->setSpacing(4);
  auto* pane = new SheetPane(workspace, this);
  auto* exposures = new Exposures(workspace, this);
  either_->addWidget(pane), either_->addWidget(exposures);
  all->addLayout(bar), all->addLayout(either_, 1);

  auto* search = new QLineEdit(this);
  search->setObjectName("search");
  search->setPlaceholderText(tr("search: ball*.position"));
  search->setToolTip(tr("Part of a name, or a pattern as in lines: wheel*.rotation"));
  search->setClearButtonEnabled(true);
  search->setMaximumWidth(30 * fontMetrics().averageCharWidth());
  connect(search, &QLineEdit::textChanged, pane,
          [pane, exposures](const QString& s) { pane->search(s.toStdString()), exposures->search(s.toStdString()); });
  connect(search, &QLineEdit::returnPressed, this, [this] { setFocus(); });
  const auto toggle = [&](const char* name, const QString& text, const QString& tip) {
    auto* b = new QToolButton(this);
    b->setObjectName(name), b->setText(text), b->setToolTip(tip);
    b->setCheckable(true), b->setAutoRaise(true), b->setFocusPolicy(Qt::TabFocus);
    return b;
  };
  auto* only =
      toggle("only_selected", tr("selected"), tr("Shows only the selection, or all tracks if nothing is selected"));
  only->setChecked(true);
  connect(only, &QToolButton::toggled, pane, &SheetPane::show_only_selected);
  connect(only, &QToolButton::toggled, exposures, &Exposures::show_only_selected);
  auto* columns = toggle("columns", tr("columns"), tr("Tracks side by side, frames downwards, values in the cells"));
  connect(columns, &QToolButton::toggled, either_, [this](bool on) { either_->setCurrentIndex(on ? 1 : 0); });
  bar->addWidget(search), bar->addWidget(only), bar->addWidget(columns), bar->addStretch();
}

// A focus proxy would change the order of Tab: from the rows it goes to the controls above them.
void Sheet::focusInEvent(QFocusEvent* e) { either_->currentWidget()->setFocus(e->reason()); }

}  // namespace betwixt::studio
