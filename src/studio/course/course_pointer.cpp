// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/course/course_pointer.h"

#include <QDockWidget>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QScrollArea>
#include <QTreeView>

#include "betwixt/language.h"
#include "betwixt/pick.h"
#include "studio/panels/outliner_model.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/timeline/ruler.h"
#include "studio/timeline/sheet_pane.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

constexpr int frame_width = 3, space = 3;  // pixels: of the frame, and between it and the place

QRect box_in_picture(const Viewport& picture, ObjectId id) {
  const Scope scope = picture.scope();
  QRectF all;
  for (const Item& item : picture.frame().items)
    if (item.id == id)
      if (const auto r = rectangle_around(drawn(item), scope.projection)) {
        const QRectF share(QPointF(r->left, r->top), QPointF(r->right, r->bottom));
        all |= QRectF(scope.box.x() + share.x() * scope.box.width(), scope.box.y() + share.y() * scope.box.height(),
                      share.width() * scope.box.width(), share.height() * scope.box.height());
      }
  return all.toAlignedRect() & picture.rect();
}

QRect box_of_event(const SheetPane& sheet, const Target& target, Time time) {
  const auto& rows = sheet.rows();
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].object == target.object && (rows[i].whole ? !found : rows[i].target.function == target.function))
      found = i;
  if (!found) return {};
  const int half = sheet.fontMetrics().height() / 2;
  return QRect(-half, -half, 2 * half, 2 * half).translated(sheet.place(*found, time).toPoint()) & sheet.rect();
}

}  // namespace

CoursePointer::CoursePointer(Window& window) : QWidget(&window), window_(window) {
  setObjectName("course_pointer");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  hide();
  qApp->installEventFilter(this);
}

CoursePointer::Spot CoursePointer::find(const std::string& place) const {
  const QStringList words = QString::fromStdString(place).section(" > ", 0, 0).split(' ', Qt::SkipEmptyParts);
  const QString what = words.value(0), name = words.value(1);
  if (what.isEmpty()) return {};
  const Document& d = window_.workspace().document();
  const auto time = [&](const QString& t) { return parse_time(t.toStdString(), d); };
  if (what == "menu") {
    auto* menu = window_.menuBar()->findChild<QMenu*>(name);
    return menu ? Spot{window_.menuBar(), window_.menuBar()->actionGeometry(menu->menuAction())} : Spot();
  }
  if (what == "object") {
    const ObjectId id = d.find(name.toStdString());
    return id ? Spot{&window_.viewport(), box_in_picture(window_.viewport(), id)} : Spot();
  }
  if (what == "row") {
    auto* tree = window_.findChild<QTreeView*>("outliner_tree");
    const ObjectId id = d.find(name.toStdString());
    if (!tree || !id) return {};
    const QModelIndex row = static_cast<OutlinerModel*>(tree->model())->index_of(id);
    return {tree->viewport(), tree->visualRect(row)};
  }
  if (what == "frame") {
    auto* ruler = window_.findChild<Ruler*>();
    const auto t = time(name);
    if (!ruler || !t) return {};
    const int half = ruler->fontMetrics().height();
    return {ruler, QRect(static_cast<int>(ruler->x_of(*t)) - half, 0, 2 * half, ruler->ruler_height())};
  }
  if (what == "event") {
    auto* sheet = window_.findChild<SheetPane*>();
    const auto targets = find_targets(name.toStdString(), d);
    const auto t = time(words.value(2));
    return sheet && targets && !targets->empty() && t ? Spot{sheet, box_of_event(*sheet, targets->front(), *t)}
                                                      : Spot();
  }
  const bool in_properties = what == "property" || what == "diamond";
  auto* widget = (in_properties ? window_.panel("properties") : &window_)
                     ->findChild<QWidget*>(what == "diamond" ? "diamond_" + name : name);
  return widget ? Spot{widget, widget->rect()} : Spot();
}

void CoursePointer::point_at(const std::string& place) {
  if (place != place_) brought_ = false;
  place_ = place;
  rows_ = QString::fromStdString(place).split(" > ").mid(1);
  for (QString& row : rows_) row = QObject::tr(row.toUtf8());
  Spot spot = find(place);
  if (!brought_) bring_forward(spot.on);
  if (!spot.on || spot.on->visibleRegion().isEmpty() || spot.box.isEmpty()) return hide();
  QWidget* const above = spot.on->window();
  if (parentWidget() != above) setParent(above);
  const int margin = frame_width + space;
  setGeometry(
      QRect(spot.on->mapTo(above, spot.box.topLeft()), spot.box.size()).adjusted(-margin, -margin, margin, margin));
  show(), raise();
}

// Shows the panel with the place, and scrolls to it.
void CoursePointer::bring_forward(QWidget* on) {
  brought_ = on;
  const bool in_properties = place_.starts_with("property") || place_.starts_with("diamond");
  if (!on && in_properties) on = window_.panel("properties");  // which makes its rows when it is seen
  for (QWidget* w = on; w; w = w->parentWidget()) {
    if (auto* area = qobject_cast<QScrollArea*>(w)) area->ensureWidgetVisible(on);
    if (auto* dock = qobject_cast<QDockWidget*>(w)) return dock->show(), dock->raise();
  }
}

void CoursePointer::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double half = frame_width / 2.0;
  p.setPen(QPen(colors().playhead, frame_width));
  p.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), 5, 5);
}

// Marks the rows of a menu that opens.
bool CoursePointer::eventFilter(QObject* on, QEvent* e) {
  if (e->type() == QEvent::Show)
    if (auto* menu = qobject_cast<QMenu*>(on))
      for (QAction* action : menu->actions()) {
        QFont font = menu->font();
        font.setBold(rows_.contains(action->text().section('\t', 0, 0)));
        action->setFont(font);
      }
  return QWidget::eventFilter(on, e);
}

}  // namespace betwixt::studio
