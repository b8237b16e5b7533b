// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves/key_fields.h"

#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "betwixt/language.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/curves/curve_pane.h"
#include "studio/shell/control_names.h"
#include "studio/shell/number_field.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/timeline/event_actions.h"
#include "studio/viewport/hand.h"

namespace betwixt::studio {

KeyFields::KeyFields(Workspace& workspace, CurvePane& pane, QWidget* parent)
    : QWidget(parent), workspace_(workspace), pane_(pane), time_(new QLineEdit(this)), value_(new NumberField(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0), row->setSpacing(4);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  for (const auto& [field, name, tip] :
       {std::tuple<QLineEdit*, const char*, QString>(
            time_, "key_time", tr("Time of the selected events: a frame number or a time. The first one comes there.")),
        {value_, "key_value", tr("Value of the selected events on the curve that you clicked last. Type, or drag.")}}) {
    field->setObjectName(name), field->setToolTip(tip), field->setFrame(false);
    measure_by_text(*field, [field] { field->setFixedWidth(field->fontMetrics().horizontalAdvance("-0000.000f")); });
    auto* label = new QLabel(field == time_ ? tr("time") : tr("value"), this);
    label->setEnabled(false);
    row->addWidget(label), row->addWidget(field);
  }
  time_->setAccessibleName(tr("Time of the selected events")),
      value_->setAccessibleName(tr("Value of the selected events"));
  time_->setAlignment(Qt::AlignRight);
  connect(time_, &QLineEdit::editingFinished, this, &KeyFields::take_time);
  connect(value_, &NumberField::looked, this, [this](const QString& t) {
    if (const Lines lines = value_lines(t); !lines.empty()) workspace_.look_ahead(lines);
  });
  connect(value_, &NumberField::called_off, this, [this] { workspace_.look_back(); });
  connect(value_, &NumberField::said, this, [this](const QString& t) {
    workspace_.look_back();
    if (const Lines lines = value_lines(t); !lines.empty()) workspace_.say(lines);
    refresh();
  });
  connect(&workspace, &Workspace::selection_changed, this, &KeyFields::refresh);
  connect(&workspace, &Workspace::document_changed, this, &KeyFields::refresh);
  refresh();
}

std::vector<EventAt> KeyFields::on_curve() const {
  std::vector<EventAt> events;
  const auto line = pane_.active();
  for (const EventAt& e : workspace_.events_selected())
    if (line && e.target == pane_.lines()[*line].target) events.push_back(e);
  return events;
}

void KeyFields::refresh() {
  const std::vector<EventAt>& events = workspace_.events_selected();
  time_->setEnabled(!events.empty());
  if (!time_->hasFocus() || !time_->isModified())
    show_text(*time_, events.empty() ? QString() : text_of(workspace_.when(span(events).first)));
  const std::vector<EventAt> on = on_curve();
  std::optional<double> value;
  bool same = true;
  for (const EventAt& at : on) {
    const Event* e = find_event(workspace_.document(), at);
    const auto number = e && !e->keep && !e->release ? shown(pane_.lines()[*pane_.active()], e->value) : std::nullopt;
    same = same && (!value || !number || *value == *number);
    if (number) value = number;
  }
  value_->setEnabled(value.has_value());
  const bool degrees = value && pane_.lines()[*pane_.active()].degrees;
  value_->set_unit(degrees ? "deg" : "");
  value_->show_value(!value  ? QString()
                     : !same ? "…"
                             : text_of(write_number(rounded(*value, 1e-9))) + (degrees ? "deg" : ""));
}

void KeyFields::take_time() {
  if (!time_->isModified()) return;
  time_->setModified(false);
  const std::vector<EventAt> events = workspace_.events_selected();
  std::string typed = time_->text().trimmed().toStdString();
  if (!typed.empty() && typed.find_first_not_of("0123456789.-") == std::string::npos) typed += "f";
  const auto to = parse_time(typed, workspace_.document());
  if (!to) {
    emit workspace_.said({}, text_of(to.error().message) + "\n", true);
  } else if (!events.empty() && *to != span(events).first) {
    const Time by = *to - span(events).first;
    EventActions::of(workspace_).retime(move_lines(workspace_.document(), events, by), [by](Time t) { return t + by; });
  }
  refresh();
}

Lines KeyFields::value_lines(const QString& typed) const {
  const auto line = pane_.active();
  bool good = false;
  QString digits = typed.trimmed();
  if (digits.endsWith("deg")) digits.chop(3);
  const double to = digits.toDouble(&good);
  if (!line) return {};
  if (!good) {
    emit workspace_.said({}, tr("'%1' is not a number\n").arg(typed), true);
    return {};
  }
  const Document& d = workspace_.session().document();
  Lines lines;
  for (const EventAt& at : on_curve()) {
    const Event* e = find_event(d, at);
    const auto now = e ? shown(pane_.lines()[*line], e->value) : std::nullopt;
    if (!now || *now == to) continue;
    for (std::string& l : point_lines(d, pane_.lines()[*line], {at}, {}, to - *now)) lines.push_back(std::move(l));
  }
  return lines;
}

}  // namespace betwixt::studio
