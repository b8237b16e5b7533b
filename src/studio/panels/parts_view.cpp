// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/parts_view.h"

#include <fmt/format.h>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "editor/plain_values.h"
#include "studio/shell/control_names.h"
#include "studio/shell/number_field.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

using What = ValuePart::What;

// What decides which widgets a row has.
std::string shape_of(const ValuePart& p) {
  std::string all =
      fmt::format("{} {} {} {} {} {} {} {}", static_cast<int>(p.what), p.target.component, p.target.layer.index,
                  p.target.velocity, p.what == What::filter ? p.title : "", p.off, p.comment, p.own);
  for (const PartField& f : p.fields) all += fmt::format(" {} {} {}", f.key, f.numbers.size(), f.text);
  return all;
}

QToolButton* small_button(QWidget* parent, const QString& name, const QString& sign, const QString& tip) {
  auto* b = new QToolButton(parent);
  b->setObjectName(name), b->setText(sign), b->setToolTip(tip);
  b->setAccessibleName(tip.section(':', 0, 0));
  b->setAutoRaise(true), b->setFocusPolicy(Qt::TabFocus);
  if (sign.size() == 1) measure_by_text(*b, [b] { b->setFixedWidth(b->fontMetrics().horizontalAdvance("mm")); });
  return b;
}

}  // namespace

PartsView::PartsView(Workspace& workspace, const Target& whole, QWidget* parent)
    : QWidget(parent), workspace_(workspace), whole_(whole), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(fontMetrics().horizontalAdvance("mm"), 0, 0, 4);
  column_->setSpacing(1);
  refresh();
}

void PartsView::refresh() {
  constexpr std::size_t long_text = 400'000;  // bytes: too many to read for each frame
  if (workspace_.playhead().playing() && workspace_.text().size() > long_text) return;
  if (workspace_.looks_ahead()) return;  // the parts have their places in the script as it stands
  parts_ = value_parts(workspace_.document(), workspace_.program(), workspace_.text(), whole_, workspace_.time());
  std::vector<std::string> shapes;
  for (const ValuePart& p : parts_) shapes.push_back(shape_of(p));
  if (shapes != built_ || rows_.size() != parts_.size()) built_ = std::move(shapes), rebuild();
  for (std::size_t i = 0; i < parts_.size(); ++i) show_row(i);
}

QWidget* PartsView::first_new_field(const std::vector<ValuePart>& before) const {
  const auto as_before = [&](const ValuePart& p) {
    return std::ranges::any_of(before, [&](const ValuePart& b) {
      return b.what == p.what && b.target == p.target && b.title == p.title && b.index == p.index;
    });
  };
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (!as_before(parts_[i]) && !rows_[i].fields.empty() && !rows_[i].fields[0].empty()) return rows_[i].fields[0][0];
  return nullptr;
}

void PartsView::retire() {
  for (QWidget* w : findChildren<QWidget*>()) w->disconnect(this);
}

void PartsView::rebuild() {
  retire();
  drag_.reset();
  for (const PartRow& row : rows_) row.box->hide(), row.box->deleteLater();
  rows_.clear();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    rows_.push_back(make_row(i));
    column_->addWidget(rows_.back().box);
  }
}

PartsView::PartRow PartsView::make_row(std::size_t i) {
  const ValuePart& part = parts_[i];
  PartRow row;
  row.box = new QWidget(this);
  row.box->setObjectName(QString("part_%1").arg(i));
  auto* lines = new QVBoxLayout(row.box);
  lines->setContentsMargins(0, 0, 0, 0), lines->setSpacing(1);
  auto* line = new QHBoxLayout;
  line->setSpacing(2);
  lines->addLayout(line);
  const QString name = text_of(part.title);
  if (part.what == What::filter) {
    line->addWidget(make_grip(row.box));
    row.on = new QCheckBox(row.box);
    row.on->setObjectName("on"), row.on->setAccessibleName(tr("%1 is on").arg(name));
    row.on->setEnabled(part.own || !part.comment);
    row.on->setToolTip(
        row.on->isEnabled()
            ? tr("Switches this filter off and on: its line gets the word `off`")
            : tr("A comment has this filter for several objects, so it cannot be switched on here alone."));
    connect(row.on, &QCheckBox::clicked, this,
            [this, i] { say(switch_part(workspace_.document(), workspace_.text(), parts_[i])); });
    line->addWidget(row.on);
  }
  row.title = small_button(row.box, "title", name, text_of(part.sentence));
  row.title->setAccessibleName(name);
  connect(row.title, &QToolButton::clicked, this, [this, i] { go_to(i); });
  line->addWidget(row.title);
  line->addStretch(1);
  if (part.what == What::filter) {
    row.up = small_button(row.box, "up", "↑", tr("Earlier: acts before the filter above"));
    row.down = small_button(row.box, "down", "↓", tr("Later: acts after the filter below"));
    for (const auto& [button, by] : {std::pair(row.up, -1), std::pair(row.down, 1)}) {
      connect(button, &QToolButton::clicked, this, [this, i, by] {
        if (const auto other = neighbour(i, by))
          say(move_part(workspace_.document(), workspace_.text(), parts_, i, *other));
      });
      line->addWidget(button);
    }
  }
  row.remove = small_button(row.box, "remove", "×", tr("Remove %1").arg(name));
  connect(row.remove, &QToolButton::clicked, this, [this, i] { remove(i); });
  line->addWidget(row.remove);
  add_fields(i, row, *lines);
  row.box->show();
  return row;
}

// Adds the parameters below the name: two of a single number share a line, so that the panel can be narrow.
void PartsView::add_fields(std::size_t i, PartRow& row, QVBoxLayout& lines) {
  const ValuePart& part = parts_[i];
  QHBoxLayout* line = nullptr;
  int there = 0;
  for (std::size_t f = 0; f < part.fields.size(); ++f) {
    const PartField& field = part.fields[f];
    const bool single = field.numbers.size() == 1 && !field.text;
    if (!line || there == 2 || !single || part.fields[f - 1].numbers.size() > 1) {
      line = new QHBoxLayout;
      line->setContentsMargins(2 * fontMetrics().horizontalAdvance("mm"), 0, 0, 0), line->setSpacing(3);
      lines.addLayout(line);
      there = 0;
    }
    ++there;
    if (!field.key.empty()) {
      auto* label = new QLabel(text_of(field.key), row.box);
      label->setEnabled(false);
      line->addWidget(label);
    }
    row.fields.emplace_back();
    for (std::size_t n = 0; n < field.numbers.size(); ++n) {
      row.fields.back().push_back(make_field(i, f, n, row.box));
      line->addWidget(row.fields.back().back(), 1);
    }
    if (field.key == "weight" && part.what == What::layer) {
      row.key = small_button(row.box, "key", "◆", tr("Writes an event of the weight at the playhead, or removes it"));
      connect(row.key, &QToolButton::clicked, this, [this, i] { key_weight(i); });
      line->addWidget(row.key);
    }
  }
}

QLineEdit* PartsView::make_field(std::size_t part, std::size_t field, std::size_t number, QWidget* parent) {
  const PartField& f = parts_[part].fields[field];
  const QString name = text_of(parts_[part].title + (f.key.empty() ? "" : " " + f.key));
  const auto settle = [=, this](const QString& t) {
    workspace_.look_back();
    const Lines lines = changed(part, field, number, t);
    // An edit that changes nothing carries out no line.
    const auto then = workspace_.session().look_ahead(lines);
    then&&* then == workspace_.session().document() ? refresh() : say(lines);
  };
  if (f.text) {
    auto* line = new QLineEdit(parent);
    line->setObjectName(text_of(f.key.empty() ? "value" : f.key)), line->setAccessibleName(name);
    line->setFrame(false);
    connect(line, &QLineEdit::editingFinished, this, [line, settle] {
      if (!line->isModified()) return;
      line->setModified(false);
      settle(line->text());
    });
    return line;
  }
  auto* line = new NumberField(parent);
  const QString letter = f.numbers.size() > 1 ? QString("xyzw"[number]) : QString();
  line->setObjectName(text_of(f.key.empty() ? "value" : f.key) + letter), line->setAccessibleName(name + " " + letter);
  line->set_unit(text_of(f.unit)), line->set_limits(f.low, f.high);
  if (!letter.isEmpty()) line->set_color(number == 0 ? colors().x : number == 1 ? colors().y : colors().z);
  connect(line, &NumberField::looked, this, [=, this](const QString& t) {
    const Lines lines = changed(part, field, number, t);
    if (!lines.empty()) workspace_.look_ahead(lines);
  });
  connect(line, &NumberField::called_off, this, [this] { workspace_.look_back(); });
  connect(line, &NumberField::said, this, settle);
  return line;
}

void PartsView::show_row(std::size_t i) {
  const ValuePart& part = parts_[i];
  PartRow& row = rows_[i];
  row.title->setText(text_of(part.title));
  if (row.on) row.on->setChecked(!part.off);
  if (row.up) row.up->setEnabled(neighbour(i, -1).has_value()), row.down->setEnabled(neighbour(i, 1).has_value());
  if (row.key) row.key->setText(weight_event_here(part) ? "◆" : "◇");
  const bool value = part.what == What::set || part.what == What::code;  // `create` may say it, with other values
  row.remove->setEnabled(!value || !remove_part(workspace_.document(), workspace_.text(), part).empty());
  for (std::size_t f = 0; f < part.fields.size(); ++f)
    for (std::size_t n = 0; n < row.fields[f].size(); ++n) {
      QLineEdit* line = row.fields[f][n];
      const QString text = text_of(part.fields[f].numbers[n]);
      line->setEnabled(!part.off);
      if (auto* number = qobject_cast<NumberField*>(line))
        number->show_value(text);
      else if (!(line->hasFocus() && line->isModified()) && line->text() != text)
        show_text(*line, text);
    }
}

Lines PartsView::changed(std::size_t part, std::size_t field, std::size_t number, const QString& text) const {
  if (part >= parts_.size() || field >= parts_[part].fields.size()) return {};
  return change_part(workspace_.session().document(), workspace_.text(), parts_[part], parts_[part].fields[field],
                     number, text.toStdString(), workspace_.time());
}

void PartsView::say(const Lines& lines) {
  if (lines.empty()) return;
  // A rewritten line is taken even if it is wrong, as if it were typed. Refuse it here.
  if (const auto then = workspace_.session().look_ahead(lines); !then)
    emit workspace_.said(text_of(lines[0]), text_of(then.error().message) + "\n", true);
  else
    workspace_.say(lines);
  refresh();
}

void PartsView::go_to(std::size_t i) {
  const ValuePart part = parts_[i];
  if (!part.keys.empty()) workspace_.select_events(part.keys);
  workspace_.set_script_line(0);
  if (part.lines.size > 0) workspace_.set_script_line(line_number(workspace_.text(), part.lines.at));
}

void PartsView::remove(std::size_t i) {
  const Document& d = workspace_.document();
  Lines lines = remove_part(d, workspace_.text(), parts_[i]);
  // Other lines may speak of a layer too. Then it is removed at the end of the script.
  if (parts_[i].what == What::layer && !workspace_.session().look_ahead(lines))
    lines = {"remove " + d.name(parts_[i].target.layer)};
  say(lines);
}

bool PartsView::weight_event_here(const ValuePart& part) const {
  const Document& d = workspace_.document();
  bool here = false;
  for (const LayerView& l : layers(d))
    if (l.id == part.target.layer)
      each_event(d, l.weight, workspace_.time(), workspace_.time(), [&](const EventView&) { here = true; });
  return here;
}

// Writes an event of a layer's weight at the playhead, or removes it.
void PartsView::key_weight(std::size_t i) {
  const Document& d = workspace_.document();
  const std::string when = workspace_.when(workspace_.time());
  for (const LayerView& l : layers(d)) {
    if (l.id != parts_[i].target.layer) continue;
    const std::string now = plain_value(workspace_.program().read(l.weight, workspace_.time()), l.weight, d);
    return say({weight_event_here(parts_[i]) ? fmt::format("clear {} {}", d.name(l.weight), when)
                                             : fmt::format("at {} {} {}", when, d.name(l.weight), now)});
  }
}

// The filter before or after it on the same track.
std::optional<std::size_t> PartsView::neighbour(std::size_t i, int by) const {
  const std::size_t k = i + static_cast<std::size_t>(by);
  if (k >= parts_.size() || parts_[k].what != What::filter || parts_[k].target.layer != parts_[i].target.layer)
    return std::nullopt;
  return k;
}

}  // namespace betwixt::studio
