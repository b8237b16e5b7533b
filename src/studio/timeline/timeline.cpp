// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/timeline.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QVBoxLayout>

#include "betwixt/language.h"
#include "studio/shell/control_names.h"
#include "studio/shell/scrolled.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"
#include "studio/timeline/ruler.h"

namespace betwixt::studio {
namespace {

// Returns the symbol of a playback button in a unit square.
QPainterPath sign(const QString& name) {
  QPainterPath path;
  const auto triangle = [&](double base, double tip) {
    path.moveTo(base, 0.15), path.lineTo(tip, 0.5), path.lineTo(base, 0.85), path.closeSubpath();
  };
  const auto bar = [&](double x, double w) { path.addRect(x, 0.15, w, 0.7); };
  if (name == "begin") bar(0.12, 0.12), triangle(0.9, 0.3);
  if (name == "back") bar(0.68, 0.12), triangle(0.58, 0.1);
  if (name == "play_back") triangle(0.85, 0.15);
  if (name == "pause") bar(0.2, 0.22), bar(0.58, 0.22);
  if (name == "play") triangle(0.15, 0.85);
  if (name == "on") bar(0.2, 0.12), triangle(0.42, 0.9);
  if (name == "end") triangle(0.1, 0.7), bar(0.76, 0.12);
  if (name == "loop") {
    path.arcMoveTo(0.15, 0.15, 0.7, 0.7, 60), path.arcTo(0.15, 0.15, 0.7, 0.7, 60, 300);
    QPainterPathStroker stroke;
    stroke.setWidth(0.12);
    path = stroke.createStroke(path);
    path.moveTo(0.55, 0.02), path.lineTo(0.9, 0.2), path.lineTo(0.58, 0.42), path.closeSubpath();
  }
  path.setFillRule(Qt::WindingFill);
  return path;
}

QIcon icon(const QString& name, int size, double ratio) {
  QIcon out;
  for (const bool on : {false, true}) {
    QPixmap map(QSize(size, size) * ratio);
    map.setDevicePixelRatio(ratio);
    map.fill(Qt::transparent);
    QPainter p(&map);
    p.setRenderHint(QPainter::Antialiasing);
    p.scale(size, size);
    p.fillPath(sign(name), on ? colors().accent : colors().text);
    p.end();
    out.addPixmap(map, QIcon::Normal, on ? QIcon::On : QIcon::Off);
  }
  return out;
}

}  // namespace

Timeline::Timeline(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), axis_(TimeAxis::of(workspace)) {
  setObjectName("timeline");
  setWindowTitle(tr("Time"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0), all->setSpacing(0);
  auto* controls = new QWidget(this);
  auto* bar = new QHBoxLayout(controls);
  bar->setContentsMargins(4, 2, 4, 2), bar->setSpacing(1);
  all->addWidget(new Scrolled(controls, Qt::Horizontal, this));
  all->addWidget(new Ruler(workspace, this), 1);

  at_ = new QLineEdit(this);
  at_->setObjectName("at");
  at_->setAlignment(Qt::AlignRight), at_->setFocusPolicy(Qt::ClickFocus);
  measure_by_text(*at_, [this] { at_->setFixedWidth(12 * at_->fontMetrics().averageCharWidth()); });
  at_->setToolTip(tr("The time of the playhead. Type a frame number, or a time such as 2.5s."));
  of_ = new QLabel(this);
  rate_ = new QLabel(this);
  rate_->setObjectName("rate");
  for (QLabel* l : {of_, rate_}) l->setForegroundRole(QPalette::PlaceholderText);
  bar->addWidget(at_), bar->addWidget(of_);
  bar->addStretch();
  bar->addWidget(button("begin", tr("Go to start"), [](Workspace& d) { d.go_to(d.playhead().first()); }));
  bar->addWidget(button("back", tr("Previous frame"), [](Workspace& d) { d.step(-1); }));
  bar->addWidget(button("play_back", tr("Play backwards or stop"), [](Workspace& d) { d.play(-1); }));
  bar->addWidget(button("play", tr("Play or stop"), [](Workspace& d) { d.play(1); }));
  bar->addWidget(button("on", tr("Next frame"), [](Workspace& d) { d.step(1); }));
  bar->addWidget(button("end", tr("Go to end"), [](Workspace& d) { d.go_to(d.playhead().last()); }));
  auto* loop = button("loop", tr("Loop"), [](Workspace& d) { d.playhead().loop(!d.playhead().loops()); });
  loop->setCheckable(true);
  bar->addWidget(loop);
  bar->addStretch();
  bar->addWidget(rate_);
  seconds_ = new QToolButton(this);
  seconds_->setObjectName("seconds");
  seconds_->setText(tr("seconds"));
  seconds_->setCheckable(true), seconds_->setAutoRaise(true), seconds_->setFocusPolicy(Qt::TabFocus);
  seconds_->setToolTip(tr("Shows times in seconds instead of frames"));
  bar->addWidget(seconds_);
  draw_buttons();

  connect(seconds_, &QToolButton::toggled, this, [this](bool on) { axis_.count_in_seconds(on), show_time(); });
  connect(at_, &QLineEdit::returnPressed, this, &Timeline::go_where_said);
  connect(&workspace, &Workspace::time_changed, this, &Timeline::show_time);
  connect(&workspace, &Workspace::document_changed, this, &Timeline::show_time);
  connect(&workspace, &Workspace::playing_changed, this, &Timeline::show_playing);
  show_time(), show_playing();
  // The panels below get the rest of the height. Sounds need more of it.
  const auto fit = [this] { setMaximumHeight(sizeHint().height()); };
  connect(&workspace, &Workspace::document_changed, this, fit);
  fit();
}

QToolButton* Timeline::button(const QString& name, const QString& tip, void (*does)(Workspace&)) {
  auto* b = new QToolButton(this);
  b->setObjectName(name), b->setToolTip(tip);
  b->setAutoRaise(true), b->setFocusPolicy(Qt::TabFocus);
  connect(b, &QToolButton::clicked, this, [this, does] { does(workspace_), show_playing(); });
  buttons_.push_back(b);
  return b;
}

void Timeline::draw_buttons() {
  const int size = fontMetrics().height();
  for (QToolButton* b : buttons_) {
    const int direction = workspace_.playhead().direction();
    const bool plays =
        (b->objectName() == "play" && direction > 0) || (b->objectName() == "play_back" && direction < 0);
    b->setIconSize({size, size});
    b->setIcon(icon(plays ? "pause" : b->objectName(), size, devicePixelRatioF()));
  }
}

void Timeline::changeEvent(QEvent* e) {
  if (e->type() == QEvent::PaletteChange || e->type() == QEvent::StyleChange || e->type() == QEvent::FontChange)
    draw_buttons();
  QWidget::changeEvent(e);
}

void Timeline::show_time() {
  const Document& d = workspace_.document();
  const auto number = [&](Time t) {
    return axis_.in_seconds() ? QString::number(t.seconds(), 'f', 3) + " s"
                              : QString::number(std::round(d.rate().frame_number(t) * 100) / 100);
  };
  if (!at_->hasFocus() || !at_->isModified()) show_text(*at_, number(workspace_.time()));
  of_->setText(tr(" of %1").arg(number(d.range().second)));
}

void Timeline::show_playing() {
  const Playhead& t = workspace_.playhead();
  for (QToolButton* b : buttons_)
    if (b->objectName() == "loop") b->setChecked(t.loops());
  draw_buttons();
  const QString wanted = QString::number(t.rate().per_second(), 'g', 5);
  const double shown = workspace_.frames_shown();
  rate_->setText(t.playing() && shown > 0 ? tr("%1 of %2 frames a second ").arg(shown, 0, 'f', 1).arg(wanted)
                 : wanted == "1"          ? tr("1 frame a second ")
                                          : tr("%1 frames a second ").arg(wanted));
}

void Timeline::go_where_said() {
  const QString said = at_->text().trimmed();
  bool plain = false;
  const double n = said.toDouble(&plain);
  const QString time =
      plain ? QString::number(n, 'g', 15) + (axis_.in_seconds() ? "s" : "f") : said.simplified().remove(' ');
  at_->setModified(false);
  if (const auto t = parse_time(time.toStdString(), workspace_.document())) workspace_.pause(), workspace_.go_to(*t);
  show_time();
  findChild<Ruler*>()->setFocus();  // return the keyboard to the ruler
}

}  // namespace betwixt::studio
