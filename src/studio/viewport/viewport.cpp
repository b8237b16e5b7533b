// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/viewport.h"

#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "scene/kinds.h"
#include "studio/objects/object_actions.h"
#include "studio/shell/key_focus.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr double steady = 4;  // pixels that the mouse may move in a click

}  // namespace

Viewport::Viewport(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), trails_(workspace), ghosts_(workspace) {
  setObjectName("viewport");
  setWindowTitle(tr("Picture"));
  setFocusPolicy(Qt::StrongFocus);
  follow_pointer(*this);
  setMouseTracking(true);
  setAcceptDrops(true);
  make_corner();
  connect(&workspace, &Workspace::document_changed, this, [this] {
    forget();
    trails_.forget(), ghosts_.forget();
    if (through_ && workspace_.name(through_).empty()) through_ = {};
    ask(), show_corner();
  });
  connect(&workspace, &Workspace::time_changed, this, [this] {
    if (pull_) end_pull(false);
    forget();
    ask();
  });
  connect(&workspace, &Workspace::selection_changed, this, [this] {
    if (pull_) end_pull(false);
    grip_.reset(), outline_.reset(), refusal_.clear();
    trails_.forget(), ghosts_.forget();
    update();
  });
  connect(&workspace, &Workspace::opened, this, [this] {
    through_ = {};
    fills_ = false;
    side_ ? stay_at_side(*side_) : set_free(false);
  });
  connect(&workspace, &Workspace::left_out_changed, this, [this] {
    forget();
    trails_.forget(), ghosts_.forget();
    ask();
  });
  // While the film plays, what is drawn over it belongs to the picture that is shown; then to the playhead's time.
  connect(&workspace, &Workspace::playing_changed, this, [this] {
    forget();
    ask(), update();
  });
  connect(&workspace, &Workspace::jumped, this, [this] {
    if (!fills_by_itself_) fills_ = false;
  });
  connect(&workspace, &Workspace::makes_events_changed, this, [this] {
    if (switches_.auto_key != workspace_.makes_events()) flip(&ViewportSwitches::auto_key);
  });
  connect(&maker_, &PictureMaker::made, this, &Viewport::take_picture, Qt::QueuedConnection);
}
Viewport::~Viewport() = default;

// Returns the largest box with the film's aspect ratio.
QRect Viewport::frame_box() const {
  const double aspect = workspace_.document().aspect();
  const int w = std::max(1, std::min(width(), static_cast<int>(height() * aspect)));
  const int h = std::max(1, static_cast<int>(w / aspect));
  return {(width() - w) / 2, (height() - h) / 2, w, h};
}

QRect Viewport::picture_box() const { return is_free() ? rect() : frame_box(); }

void Viewport::set_style(const std::string& style) {
  if (style == style_) return;
  style_ = style;
  ask();
  show_corner();
  emit style_changed();
}

void Viewport::set_switches(const ViewportSwitches& s) {
  switches_ = s;
  workspace_.set_makes_events(s.auto_key);
  grip_.reset();
  if (!s.measures) measured_.clear();
  show_corner();
  update();
  emit switches_changed();
}

void Viewport::flip(bool ViewportSwitches::*which) {
  ViewportSwitches s = switches_;
  s.*which = !(s.*which);
  set_switches(s);
}

void Viewport::forget() {
  frame_.reset(), grip_.reset(), icons_.reset(), outline_.reset(), grid_.reset();
  update();
}

// Overlays match the picture. During playback pictures arrive later than their times.
Time Viewport::shown_time() const {
  return workspace_.playhead().playing() && !shown_.image.isNull() ? shown_.time : workspace_.time();
}

const Frame& Viewport::frame() const {
  if (frame_) return *frame_;
  frame_ = film_.evaluate(workspace_.program(), shown_time()).frame();
  leave_out(workspace_.left_out().get(), *frame_);
  return *frame_;
}

// During playback the camera comes with the picture.
Camera Viewport::eye() const {
  if (workspace_.playhead().playing() && !shown_.image.isNull() && !free_) return shown_.eye;
  return own_eye(shown_time()).value_or(frame().camera);
}

Scope Viewport::scope() const {
  const QRectF box = picture_box();
  return {Projection(eye(), box.width() / box.height()), box};
}

void Viewport::showEvent(QShowEvent*) { ask(); }

void Viewport::resizeEvent(QResizeEvent*) {
  outline_.reset();
  place_corner();
  ask();
}

// ---- The mouse

void Viewport::mousePressEvent(QMouseEvent* e) {
  setFocus();
  from_ = at_ = e->position();
  called_off_ = false;
  if (gesture_ == Gesture::pull && pull_by_keys_) {
    called_off_ = e->button() == Qt::RightButton;
    return end_pull(e->button() == Qt::LeftButton);
  }
  if (gesture_ != Gesture::none) return;
  const bool shift = e->modifiers() & Qt::ShiftModifier, alt = e->modifiers() & Qt::AltModifier;
  const bool flat = frame().surroundings.flat;
  if (e->button() == Qt::MiddleButton || (alt && e->button() == Qt::LeftButton)) {
    gesture_ = shift || flat || (side_ && !(e->modifiers() & Qt::ControlModifier)) ? Gesture::pan
               : e->modifiers() & Qt::ControlModifier                              ? Gesture::zoom
                                                                                   : Gesture::orbit;
    pivot_ = pivot();
    setCursor(gesture_ == Gesture::pan ? Qt::ClosedHandCursor : Qt::SizeAllCursor);
  } else if (e->button() == Qt::LeftButton && take_guide(from_)) {
    drag_guide(from_, e->modifiers());
  } else if (e->button() == Qt::LeftButton && switches_.measures) {
    measure_to(from_);
  } else if (e->button() == Qt::LeftButton) {
    press_on(from_, e->modifiers());
  }
}

void Viewport::mouseMoveEvent(QMouseEvent* e) {
  const QPointF by = e->position() - at_;
  at_ = e->position();
  switch (gesture_) {
    case Gesture::none: {
      if (switches_.measures) return update();
      const auto of_motion = motion_handles();
      const auto hot_motion = of_motion ? of_motion->part_at(scope(), at_) : std::nullopt;
      if (std::exchange(hot_motion_, hot_motion) != hot_motion) update();
      const auto h = handles();
      const Part hot = h && !hot_motion ? h->part_at(at_) : Part::none;
      if (std::exchange(hot_, hot) != hot) update();
      show_cursor_of_guide(at_);
      break;
    }
    case Gesture::orbit:
    case Gesture::pan:
    case Gesture::zoom:
      drag_eye(by);
      break;
    case Gesture::press:
      if (QLineF(from_, at_).length() < steady) break;
      if (pressed_)
        begin_pull(Tool::move, Part::all, from_), go_on_pulling(at_, e->modifiers());
      else
        gesture_ = Gesture::box;
      update();
      break;
    case Gesture::box:
      update();
      break;
    case Gesture::pull:
      go_on_pulling(at_, e->modifiers());
      break;
    case Gesture::motion:
      drag_motion(at_, e->modifiers());
      break;
    case Gesture::guide:
      drag_guide(at_, e->modifiers());
      break;
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* e) {
  at_ = e->position();
  switch (gesture_) {
    case Gesture::orbit:
    case Gesture::pan:
    case Gesture::zoom:
      unsetCursor();
      gesture_ = Gesture::none;
      break;
    case Gesture::press:  // a click on one of several selected objects selects only this one
      gesture_ = Gesture::none;
      if (!(e->modifiers() & Qt::ShiftModifier))
        workspace_.select(clicked_ ? std::vector{*clicked_} : std::vector<ObjectId>{});
      break;
    case Gesture::box:
      gesture_ = Gesture::none;
      select_in_box(e->modifiers());
      break;
    case Gesture::pull:
      if (!pull_by_keys_) end_pull(true);
      break;
    case Gesture::motion:
      end_motion(true);
      break;
    case Gesture::guide:
      end_guide(true);
      break;
    case Gesture::none:
      break;
  }
  update();
}

void Viewport::leaveEvent(QEvent*) {
  hot_ = Part::none;
  update();
}

// "ball, a sphere"
QString Viewport::in_words(ObjectId id) const {
  return QString::fromStdString(workspace_.name(id) + ", " + a_kind(kind(workspace_.document(), id)));
}

bool Viewport::event(QEvent* e) {
  if (e->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(e);
    const auto found = gesture_ == Gesture::none ? hit(help->pos()) : std::nullopt;
    found ? QToolTip::showText(help->globalPos(), in_words(found->id), this) : QToolTip::hideText();
    return true;
  }
  // The viewport's keys have priority over the menus'.
  if (e->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(e);
    const auto held = key->modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
    const QString own = held == Qt::NoModifier ? "013579FWETGRSA" : held == Qt::ShiftModifier ? "A" : "";
    if ((pull_ && key->key() != Qt::Key_Space) || (key->key() < 128 && own.contains(QChar(key->key()))) ||
        (key->key() == Qt::Key_Escape && (gesture_ != Gesture::none || switches_.measures))) {
      e->accept();
      return true;
    }
  }
  return QWidget::event(e);
}

void Viewport::keyPressEvent(QKeyEvent* e) {
  if (pull_) {
    if (!pulling_key(e)) e->ignore();
    return;
  }
  if (guide_drag_) return e->key() == Qt::Key_Escape ? end_guide(false) : e->ignore();
  if (motion_drag_) return e->key() == Qt::Key_Escape ? end_motion(false) : e->ignore();
  const bool shift = e->modifiers() & Qt::ShiftModifier;
  const bool plain = !(e->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) && (!shift || e->key() == Qt::Key_A);
  ViewportSwitches s = switches_;
  const auto use = [&](Tool t) { s.tool = t, s.handles = true, set_switches(s); };
  if (looking_key(e->key(), e->modifiers())) return;
  if (e->key() == Qt::Key_Escape && gesture_ != Gesture::none) {
    gesture_ = Gesture::none;
    unsetCursor(), update();
    return;
  }
  if (e->key() == Qt::Key_Escape && switches_.measures) return flip(&ViewportSwitches::measures);
  if (ObjectActions::of(workspace_).key(*e)) return;
  if (!plain) return QWidget::keyPressEvent(e);
  switch (e->key()) {
    case Qt::Key_W:
      return use(Tool::move);
    case Qt::Key_E:
      return use(Tool::turn);
    case Qt::Key_T:
      return use(Tool::scale);
    case Qt::Key_G:
      return take(Tool::move);
    case Qt::Key_R:
      return take(Tool::turn);
    case Qt::Key_S:
      return take(Tool::scale);
    case Qt::Key_A:
      return shift ? workspace_.select({}) : select_all();
    default:
      QWidget::keyPressEvent(e);
  }
}

}  // namespace betwixt::studio
