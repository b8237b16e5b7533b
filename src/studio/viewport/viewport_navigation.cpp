// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Navigation: how the user moves the free camera.
#include <QWheelEvent>
#include <algorithm>

#include "betwixt/object.h"
#include "language/values.h"
#include "program/compiled.h"
#include "studio/objects/object_lines.h"
#include "studio/shell/marks.h"
#include "studio/viewport/navigation.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

constexpr double turn_per_pixel = 0.008;  // radians
constexpr double zoom_per_notch = 0.85;
constexpr double zoom_per_pixel = 0.993;
constexpr std::size_t many = 500;  // objects; a box around more of them holds only their positions

}  // namespace

void Viewport::set_free(bool free) {
  if (free == is_free() && !through_) return;
  if (pull_) end_pull(false);
  const QRectF part = frame_box();
  if (free && through_)
    free_ = eye();
  else if (free)
    free_ = widened(frame().camera, part.width() / std::max(1, width()), part.height() / std::max(1, height()));
  else
    free_.reset();
  through_ = {};
  if (!side_) workspace_.set_view(free_);
  icons_.reset();
  outline_.reset();
  ask();
  show_corner();
  update();
}

void Viewport::move_eye(const Camera& c) {
  const QString words = side_words();
  free_ = c;
  if (side_words() != words) show_corner();
  if (!side_) workspace_.set_view(free_);
  outline_.reset();
  ask();
  update();
}

// Returns objects with all their descendants, so that a group stands for its members.
std::vector<ObjectId> Viewport::with_what_hangs_on(const std::vector<ObjectId>& ids) const {
  const Document& d = workspace_.document();
  Marks in(ids);
  std::vector<ObjectId> out = ids;
  const std::vector<ObjectId> all = objects(d);
  for (bool more = true; more;) {
    more = false;
    for (const ObjectId id : all) {
      if (in(id)) continue;
      for (const AttachmentSpan& s : attachments(d, id))
        if (s.from <= workspace_.time() && workspace_.time() < s.until && s.to.kind >= AttachmentKind::hang &&
            s.to.parent && in(s.to.parent)) {
          in.add(id), out.push_back(id), more = true;
          break;
        }
    }
  }
  return out;
}

// Returns the box around these objects, or around all visible ones.
Box Viewport::box_of(const std::vector<ObjectId>& ids) const {
  Box box;
  const Marks wanted(ids.empty() ? ids : with_what_hangs_on(ids));
  const auto is_wanted = [&](ObjectId id) { return ids.empty() || wanted(id); };
  const bool closely = frame().items.size() <= many || (!ids.empty() && ids.size() <= many);
  for (const Item& i : frame().items) {
    if (!is_wanted(i.id)) continue;
    if (closely)
      for (const Vec3& corner : drawn(i).corners) box.add(corner);
    else
      box.add(translation_of(i.world));
  }
  for (const Icon& i : icons())
    if (!ids.empty() && is_wanted(i.id)) box.add(i.place);
  if (box.empty() && !ids.empty()) box.add(grip().place());
  return box;
}

// Returns the centre of an orbit: the selection; otherwise the object in the middle of the picture.
Vec3 Viewport::pivot() const {
  const Scope s = scope();
  if (!workspace_.selected().empty() && !grip().empty()) return grip().place();
  if (const auto h = pick(frame(), s.projection, 0.5, 0.5)) return h->place;
  Box all;
  for (const Item& i : frame().items) all.add(translation_of(i.world));
  const double depth = all.empty() ? last_depth_ : s.depth(all.middle());
  return s.projection.place(0.5, 0.5, depth > 0 ? depth : last_depth_);
}

void Viewport::drag_eye(QPointF by) {
  set_free(true);
  const double aspect = double(width()) / std::max(1, height());
  const double depth = std::max(1e-3, scope().depth(pivot_));
  last_depth_ = depth;
  if (gesture_ == Gesture::orbit)
    move_eye(orbited(*free_, pivot_, -turn_per_pixel * by.x(), -turn_per_pixel * by.y()));
  else if (gesture_ == Gesture::pan)
    move_eye(panned(*free_, aspect, by.x() / width(), by.y() / height(), depth));
  else
    move_eye(zoomed(*free_, pivot_, std::pow(zoom_per_pixel, by.x() - by.y())));
}

// Zooms to the place under the pointer, which stays there.
void Viewport::wheelEvent(QWheelEvent* e) {
  const double notches = e->angleDelta().y() / 120.0;
  if (notches == 0) return e->ignore();
  set_free(true);
  const Scope s = scope();
  const QPointF at = s.in_picture(e->position());
  const auto h = pick(frame(), s.projection, at.x(), at.y());
  const double depth = h ? h->depth : std::max(1e-3, s.depth(pivot()));
  last_depth_ = depth;
  move_eye(zoomed(*free_, s.projection.place(at.x(), at.y(), depth), std::pow(zoom_per_notch, notches)));
  e->accept();
}

void Viewport::stay_at_side(Vec3 direction) {
  side_ = direction;
  set_free(true);
  Camera c = looking_along(*free_, direction, {}, last_depth_);
  c.orthographic = true, c.shift_x = c.shift_y = 0;
  std::vector<ObjectId> things;  // without floors, beside which they would be small
  for (const Item& i : frame().items) {
    Box box;
    for (const Vec3& corner : drawn(i).corners) box.add(corner);
    if (box.half().y > 0.02 * std::max(box.half().x, box.half().z)) things.push_back(i.id);
  }
  const Box box = box_of(things);
  if (!box.empty()) c = framed(c, box, double(width()) / std::max(1, height()));
  move_eye(c);
  set_plain(plain_), show_corner();
}

QString Viewport::side_words() const {
  if (!free_ || !free_->orthographic || through_) return {};
  const Vec3 ahead = Projection(*free_, 1).forward();
  for (const auto& [along, words] : {std::pair(Vec3{0, -1, 0}, tr("top")),
                                     {Vec3{0, 1, 0}, tr("bottom")},
                                     {Vec3{0, 0, -1}, tr("front")},
                                     {Vec3{0, 0, 1}, tr("back")},
                                     {Vec3{-1, 0, 0}, tr("right")},
                                     {Vec3{1, 0, 0}, tr("left")}})
    if (length(ahead - along) < 1e-6) return words;
  return {};
}

void Viewport::look_along(Vec3 direction) {
  const Vec3 about = pivot();
  const double distance = std::max(1e-3, length(about - scope().projection.eye()));
  set_free(true);
  move_eye(looking_along(*free_, direction, about, distance));
}

void Viewport::look_from_behind() {
  const Vec3 about = pivot();
  set_free(true);
  move_eye(orbited(*free_, about, pi, 0));
}

ObjectId Viewport::film_camera() const {
  const auto camera = workspace_.program().compiled().camera_at(shown_time());
  return camera ? ObjectId{*camera} : ObjectId{};
}

void Viewport::bring_camera() {
  if (!is_free()) return;
  set_free(true);
  const Scope s = scope();
  const Vec3 eye = s.projection.eye();
  const double step = s.metres(std::max(1e-3, s.depth(pivot())));
  if (const ObjectId camera = film_camera()) {
    const auto lines =
        lines_to_bring(workspace_.program(), camera, free_->world, workspace_.time(), step, switches_.auto_key);
    if (lines.empty() || !workspace_.say(lines)) return;
  } else {
    const std::string name = free_name(workspace_.document(), "eye");
    constexpr double degree = pi / 180;
    Vec3 place = eye, angles = (1 / degree) * angles_near(from_matrix(free_->world), {});
    for (int i = 0; i < 3; ++i) place[i] = rounded(place[i], step), angles[i] = rounded(angles[i], 0.1);
    if (!workspace_.say("create " + name + " camera position=" + write_vector(place) +
                        " rotation=" + write_angles(degree * angles) +
                        (free_->orthographic ? " height=" + write_number(rounded(free_->height, step)) : "")))
      return;
  }
  set_free(false);
}

void Viewport::bring_selected() {
  if (!is_free() || workspace_.selected().empty()) {
    refusal_ = tr("select an object, and look from where it should be (0 gives you a free view)");
    return update();
  }
  set_free(true);
  const double step = scope().metres(std::max(1e-3, scope().depth(pivot())));
  workspace_.say(lines_to_bring(workspace_.program(), workspace_.selected().back(), free_->world, workspace_.time(),
                                step, switches_.auto_key));
}

void Viewport::toggle_perspective() {
  const double depth = std::max(1e-3, scope().depth(pivot()));
  set_free(true);
  move_eye(with_perspective(*free_, free_->orthographic, double(width()) / std::max(1, height()), depth));
}

void Viewport::frame_selected() {
  const Box box = box_of(workspace_.selected());
  if (box.empty()) return;
  set_free(true);
  move_eye(framed(*free_, box, double(width()) / std::max(1, height())));
}

bool Viewport::looking_key(int key, Qt::KeyboardModifiers modifiers) {
  if (modifiers & ~Qt::KeyboardModifiers(Qt::KeypadModifier)) return false;
  switch (key) {
    case Qt::Key_0:
      set_free(!is_free());
      return true;
    case Qt::Key_1:
      look_along({0, 0, -1});
      return true;
    case Qt::Key_3:
      look_along({-1, 0, 0});
      return true;
    case Qt::Key_7:
      look_along({0, -1, 0});
      return true;
    case Qt::Key_9:
      look_from_behind();
      return true;
    case Qt::Key_5:
      toggle_perspective();
      return true;
    case Qt::Key_F:
      frame_selected();
      return true;
    default:
      return false;
  }
}

}  // namespace betwixt::studio
