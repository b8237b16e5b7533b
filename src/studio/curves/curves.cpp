// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves/curves.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "studio/curves/curve_actions.h"
#include "studio/curves/curve_pane.h"
#include "studio/curves/key_fields.h"
#include "studio/shell/scrolled.h"

namespace betwixt::studio {

Curves::Curves(Workspace& workspace, QWidget* parent) : QWidget(parent) {
  setObjectName("curves");
  setWindowTitle(tr("Curves"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0), all->setSpacing(0);
  auto* controls = new QWidget(this);
  auto* bar = new QHBoxLayout(controls);
  bar->setContentsMargins(4, 2, 4, 2), bar->setSpacing(4);
  auto* pane = new CurvePane(workspace, this);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* b = new QToolButton(this);
    b->setObjectName(name), b->setText(text), b->setToolTip(tip);
    b->setAutoRaise(true), b->setFocusPolicy(Qt::TabFocus);
    bar->addWidget(b);
    return b;
  };
  connect(button("fit", tr("fit all"), tr("Shows all values: F")), &QToolButton::clicked, pane,
          [pane] { pane->finish(), pane->fit(); });
  auto* each = button("each_fills", tr("normalise"),
                      tr("Scales each curve to the full height, so that metres and degrees fit together: N"));
  each->setCheckable(true);
  connect(each, &QToolButton::toggled, pane, [pane](bool on) {
    if (on != pane->each_fills()) pane->let_each_fill(on);
  });
  connect(pane, &CurvePane::fill_changed, each, &QToolButton::setChecked);
  auto* frozen = button("reference", tr("reference"),
                        tr("Keeps the curves as they are, pale, to compare with them; once more, forgets them"));
  frozen->setCheckable(true);
  connect(frozen, &QToolButton::clicked, pane, &CurvePane::freeze);
  connect(pane, &CurvePane::reference_changed, frozen, &QToolButton::setChecked);
  connect(button("types", tr("handles"), tr("Handle types of the selected events: V")), &QToolButton::clicked, this,
          [&workspace, this] { ask_key_type(workspace, this); });
  connect(button("easings", tr("twerpers"), tr("Twerpers (easings) as pictures: T")), &QToolButton::clicked, this,
          [&workspace, this] { ask_twerper(workspace, this); });
  bar->addStretch();
  bar->addWidget(new KeyFields(workspace, *pane, this));
  all->addWidget(new Scrolled(controls, Qt::Horizontal, this)), all->addWidget(pane, 1);
  setFocusProxy(pane);
}

}  // namespace betwixt::studio
