// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a function's value in the properties: they are unfolded below it, and a menu adds further ones.
#include <QGridLayout>
#include <QMenu>
#include <QTimer>

#include "betwixt/object.h"
#include "editor/made_by.h"
#include "studio/panels/new_parts.h"
#include "studio/panels/properties.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"

namespace betwixt::studio {

void Properties::add_part_buttons(Row& row, QWidget* section) {
  auto* both = new QWidget(section);
  auto* line = new QHBoxLayout(both);
  line->setContentsMargins(0, 0, 0, 0), line->setSpacing(0);
  const QString name = text_of(row.name);
  const auto button = [&](const char* what, const QString& tip) {
    auto* b = new QToolButton(both);
    b->setObjectName(what + name), b->setToolTip(tip), b->setAccessibleName(tip.section(':', 0, 0) + " " + name);
    b->setAutoRaise(true), b->setFocusPolicy(Qt::TabFocus);
    measure_by_text(*b, [b] { b->setFixedWidth(b->fontMetrics().horizontalAdvance("mm")); });
    line->addWidget(b);
    return b;
  };
  row.unfold =
      button("unfold_", tr("Shows what makes the value: what is set, events, velocity, filters, layers, code"));
  row.unfold->setArrowType(Qt::RightArrow), row.unfold->setCheckable(true);
  QSizePolicy keeps_place = row.unfold->sizePolicy();
  keeps_place.setRetainSizeWhenHidden(true);
  row.unfold->setSizePolicy(keeps_place);
  row.add = button("add_", tr("Add: a filter, a layer, a velocity, code or a motion"));
  row.add->setText("+");
  row.add->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(row.add);
  menu->setObjectName("new_parts_" + name);
  row.add->setMenu(menu);
  row.add->setStyleSheet("QToolButton::menu-indicator { image: none; }");
  Row* of = &row;
  connect(menu, &QMenu::aboutToShow, this, [=, this] { fill_new_parts_of(*menu, *of); });
  connect(row.unfold, &QToolButton::toggled, this, [this, of](bool open) { unfold(*of, open); });
  for (QLabel* label : {row.called, row.made}) {
    label->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(label, &QWidget::customContextMenuRequested, this,
            [menu, label](const QPoint& at) { menu->popup(label->mapToGlobal(at)); });
  }
  static_cast<QGridLayout*>(section->layout())->addWidget(both, row.at, 4);
  if (unfolded_.contains(name)) row.unfold->setChecked(true);
}

void Properties::unfold(Row& row, bool open) {
  const QString name = text_of(row.name);
  unfolded_.removeAll(name);
  row.unfold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  if (open) unfolded_.push_back(name);
  if (open == static_cast<bool>(row.parts)) return;
  if (!open) {
    row.parts->retire(), row.parts->hide(), row.parts->deleteLater();
    row.parts = nullptr;
    return;
  }
  QWidget* section = row.add->parentWidget()->parentWidget();
  row.parts = new PartsView(workspace_, Target(leading(), row.of.id), section);
  row.parts->setObjectName("parts_" + name);
  static_cast<QGridLayout*>(section->layout())
      ->addWidget(row.parts, row.at + (row.kind == EditorKind::lines ? 2 : 1), 1, 1, 4);
  row.parts->show();
}

// Returns what makes a value, such as "between 1f and 24f, filter noise", in the language of the user.
QString Properties::words_of(const std::vector<ValueSource>& sources) {
  using What = ValueSource::What;
  const auto one = [](const ValueSource& s) {
    const QString name = text_of(s.name);
    switch (s.what) {
      case What::event_here:
        return tr("event here");
      case What::between:
        return tr("between %1 and %2").arg(name, text_of(s.until));
      case What::since:
        return tr("since %1").arg(name);
      case What::before:
        return tr("before %1").arg(name);
      case What::set:
        return tr("set");
      case What::code:
        return tr("code");
      case What::velocity:
        return tr("velocity");
      case What::layer:
        return tr("layer %1").arg(name);
      case What::filter:
        return tr("filter %1").arg(name);
    }
    return QString();
  };
  QStringList all;
  for (const ValueSource& s : sources) all << one(s);
  return all.join(", ");
}

void Properties::fill_new_parts_of(QMenu& menu, const Row& row) {
  menu.clear();
  qDeleteAll(menu.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
  const Document& d = workspace_.document();
  std::vector<Target> targets;
  for (const ObjectId id : workspace_.selected())
    for (const FunctionView& f : functions(d, id))
      if (f.name == row.name && f.type == row.of.type) targets.emplace_back(id, f.id);
  fill_new_parts(menu, workspace_, new_parts(d, workspace_.program(), targets, workspace_.time()));
  // The menu tells it before the action has carried out its lines.
  if (!targets.empty()) {
    const Target whole(leading(), row.of.id);
    const auto before = value_parts(d, workspace_.program(), workspace_.text(), whole, workspace_.time());
    menu.disconnect(this);
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu, of = &row] { fill_new_parts_of(menu, *of); });
    connect(
        &menu, &QMenu::triggered, this, [this, name = text_of(row.name), before] { show_new_part(name, before); },
        Qt::QueuedConnection);
  }
  if (menu.isEmpty()) menu.addAction(tr("Nothing can be added to %1").arg(text_of(row.name)))->setEnabled(false);
}

// Unfolds the parts of a function and goes to the first field of the new one.
void Properties::show_new_part(const QString& function, const std::vector<ValuePart>& before) {
  for (const auto& row : rows_) {
    if (text_of(row->name) != function) continue;
    row->unfold->setChecked(true);
    if (!row->parts) return;
    QWidget* field = row->parts->first_new_field(before);
    if (!field) return;
    field->setFocus(Qt::TabFocusReason);
    QTimer::singleShot(0, field, [this, field] { area_->ensureWidgetVisible(field); });  // after the layout
  }
}

}  // namespace betwixt::studio
