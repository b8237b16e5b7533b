// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/twerper_grid.h"

#include <QFocusEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QScreen>
#include <QToolButton>
#include <algorithm>

#include "betwixt/track.h"
#include "scene/document.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "studio/timeline/event_actions.h"
#include "track/curve.h"
#include "track/twerpers.h"

namespace betwixt::studio {

std::vector<double> twerper_shape(const Document& d, const std::string& name) {
  constexpr int steps = 48;
  const auto own = find_own_twerper(d.scene(), name);
  const auto twerper = own ? own : find_twerper(name);
  if (!twerper || !fits(d.scene(), *twerper, Type::scalar)) return {};
  if (own && std::ranges::any_of(*d.scene().procedures,
                                 [&](const NamedProcedure& p) { return p.name == name && p.role != Role::twerper; }))
    return {};  // a tween makes values, not a share
  Track track;
  // The events beside it are for twerpers that use their neighbours.
  constexpr std::pair<int, double> events[] = {{0, 0.6}, {1, 0}, {2, 1}, {3, 0.4}};
  for (const auto& [second, value] : events) {
    Event e;
    e.time = from_seconds(second), e.value = value, e.twerper = *twerper;
    if (name == "steps") e.detail.edit().arguments = TwerperArguments(4, 0, 0, 0);
    track.events.put(std::move(e));
  }
  CurveSet set;
  for (const NamedProcedure& p : *d.scene().procedures) set.own.push_back(p.code);
  const Curve curve = set.add(track, Type::scalar);
  std::vector<double> shape;
  for (int i = 0; i <= steps; ++i) {
    double v[4] = {};
    set.evaluate(curve, from_seconds(1 + i / static_cast<double>(steps)), v);
    shape.push_back(v[0]);
  }
  return shape;
}

QIcon twerper_picture(const Document& d, const std::string& name) {
  const std::vector<double> shape = twerper_shape(d, name);
  constexpr int w = 96, h = 72;
  QPixmap pix(w, h);
  pix.setDevicePixelRatio(2), pix.fill(Qt::transparent);
  QPainter p(&pix);
  p.setRenderHint(QPainter::Antialiasing);
  const auto y = [](double v) { return 27 - v * 18; };
  p.setPen(QPen(colors().line, 0.7));
  for (const double v : {0.0, 1.0}) p.drawLine(QPointF(3, y(v)), QPointF(45, y(v)));
  QPainterPath path;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const QPointF at(3 + 42.0 * static_cast<double>(i) / static_cast<double>(shape.size() - 1), y(shape[i]));
    i == 0 ? path.moveTo(at) : path.lineTo(at);
  }
  p.setPen(QPen(colors().accent, 1.5));
  p.drawPath(path);
  return pix;
}

void TwerperGrid::pop_up(Workspace& workspace, QWidget* parent, const QPoint& at) {
  if (workspace.events_selected().empty()) return;
  auto* grid = new TwerperGrid(workspace, parent);
  grid->adjustSize();
  const QScreen* screen = QGuiApplication::screenAt(at);
  const QRect room = screen ? screen->availableGeometry() : QRect(at, grid->size());
  grid->move(std::max(room.left(), std::min(at.x(), room.right() - grid->width())),
             std::max(room.top(), std::min(at.y(), room.bottom() - grid->height())));
  grid->show();
  const auto buttons = grid->findChildren<QToolButton*>();
  const auto now = std::ranges::find_if(buttons, [](QToolButton* b) { return b->isChecked(); });
  if (!buttons.isEmpty()) (now == buttons.end() ? buttons.front() : *now)->setFocus(Qt::PopupFocusReason);
}

TwerperGrid::TwerperGrid(Workspace& workspace, QWidget* parent) : QFrame(parent, Qt::Popup), workspace_(workspace) {
  setObjectName("twerper_grid");
  setAccessibleName(tr("Twerpers (easings)"));
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  auto* all = new QGridLayout(this);
  all->setContentsMargins(4, 4, 4, 4), all->setSpacing(1);
  for (const TwerperRow& row : twerpers().subspan(1)) add(std::string(row.name), text_of(row.sentence));
  for (const ProcedureView& p : procedures(workspace.document()))
    if (p.role == "twerper" || p.role == "tween") add(std::string(p.name), text_of(p.source));
}

void TwerperGrid::add(const std::string& name, const QString& sentence) {
  constexpr int columns = 9;
  const Document& d = workspace_.document();
  const auto& events = workspace_.events_selected();
  const bool any = std::ranges::any_of(events, [&](const EventAt& at) {
    std::string_view now;
    each_event(d, at.target, at.time, at.time, [&](const EventView& e) { now = e.twerper; });
    return now == name;
  });
  if (!any && twerper_lines(d, events, name).empty()) return;  // has no meaning for these values
  auto* b = new QToolButton(this);
  b->setObjectName(text_of(name)), b->setText(text_of(name)), b->setToolTip(tip_of(sentence));
  b->setIcon(twerper_picture(d, name)), b->setIconSize({48, 36});
  b->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  b->setAutoRaise(true), b->setFocusPolicy(Qt::TabFocus);
  b->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  b->setCheckable(true), b->setChecked(any);
  b->installEventFilter(this);
  connect(b, &QToolButton::clicked, this, [this, name] {
    workspace_.look_back();
    EventActions::of(workspace_).twerper(name);
    close();
  });
  static_cast<QGridLayout*>(layout())->addWidget(b, count_ / columns, count_ % columns);
  ++count_;
}

bool TwerperGrid::eventFilter(QObject* on, QEvent* e) {
  const bool by_key = e->type() == QEvent::FocusIn && static_cast<QFocusEvent*>(e)->reason() != Qt::PopupFocusReason;
  if (e->type() == QEvent::Enter || by_key) {
    workspace_.look_back();
    const std::string name = on->objectName().toStdString();
    if (const Lines lines = twerper_lines(workspace_.session().document(), workspace_.events_selected(), name);
        !lines.empty())
      workspace_.look_ahead(lines);
  } else if (e->type() == QEvent::Leave) {
    workspace_.look_back();
  }
  return QFrame::eventFilter(on, e);
}

void TwerperGrid::closeEvent(QCloseEvent* e) {
  workspace_.look_back();
  QFrame::closeEvent(e);
}

}  // namespace betwixt::studio
