// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Selection and transforms in the picture.
#include <QContextMenuEvent>
#include <QMenu>
#include <algorithm>

#include "betwixt/object.h"
#include "scene/functions.h"
#include "studio/objects/object_actions.h"
#include "studio/shell/marks.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

constexpr double slack = 5;          // pixels beside a line
constexpr double icon_reach = 10;    // pixels
constexpr double handle_reach = 80;  // pixels

}  // namespace

// ---- Selection

// Lists the lights and cameras, and the selected groups: they have no shape.
const std::vector<Viewport::Icon>& Viewport::icons() const {
  if (icons_) return *icons_;
  icons_.emplace();
  std::vector<Target> places;
  const Marks marked(workspace_.selected());
  for (const ObjectId id : objects(workspace_.document())) {
    const Kind k = kind(workspace_.document(), id);
    const bool selected = k == Kind::group && marked(id);
    if ((k != Kind::light && k != Kind::camera && !selected) || id == through_) continue;
    icons_->push_back({id, k, {}});
    places.emplace_back(id, Query::world);
  }
  const std::vector<Value> worlds = workspace_.program().read(places, shown_time());
  for (std::size_t i = 0; i < worlds.size(); ++i)
    if (const auto* m = std::get_if<Matrix>(&worlds[i])) (*icons_)[i].place = translation_of(**m);
  return *icons_;
}

std::optional<Hit> Viewport::hit(QPointF p) const {
  const Scope s = scope();
  if (is_free())
    for (const Icon& i : icons())
      if (const auto spot = s.spot(i.place); spot && QLineF(*spot, p).length() < icon_reach)
        return Hit{i.id, i.place, s.depth(i.place)};
  const QPointF at = s.in_picture(p);
  if (!QRectF(0, 0, 1, 1).contains(at)) return std::nullopt;
  return pick(frame(), s.projection, at.x(), at.y(), slack / s.box.height());
}

void Viewport::press_on(QPointF p, Qt::KeyboardModifiers modifiers) {
  if (auto h = motion_handles())
    if (const auto part = h->part_at(scope(), p)) {
      workspace_.pause();
      const double angle = h->row().motion.factors[part->factor].angle;
      motion_drag_ = MotionDrag{*std::move(h), *part, angle};
      gesture_ = Gesture::motion;
      return update();
    }
  if (const auto h = handles())
    if (const Part part = h->part_at(p); part != Part::none) return begin_pull(switches_.tool, part, p);
  if (switches_.trails && !workspace_.playhead().playing())
    if (const auto event = trails_.event_at(scope(), p, shown_time())) {
      workspace_.select_events({*event});
      return begin_pull(Tool::move, Part::all, p, *event);
    }
  gesture_ = Gesture::press;
  const auto found = hit(p);
  pressed_ = clicked_ = found ? std::optional(found->id) : std::nullopt;
  if (!pressed_) return;
  std::vector<ObjectId> ids = workspace_.selected();
  // Of a chart, the first click takes the whole, the next one a piece.
  const Document& d = workspace_.document();
  const ObjectId whole = whole_of(d, *pressed_);
  const bool has_whole = std::ranges::find(ids, whole) != ids.end();
  const bool inside = std::ranges::any_of(ids, [&](ObjectId id) { return !(id == whole) && whole_of(d, id) == whole; });
  if (!inside) pressed_ = whole;
  if (!inside && !has_whole) clicked_ = whole;
  const auto known = std::find(ids.begin(), ids.end(), *pressed_);
  if (modifiers & Qt::ShiftModifier) {
    if (known != ids.end())
      ids.erase(known), pressed_.reset();
    else
      ids.push_back(*pressed_);
    workspace_.select(ids);
  } else if (known == ids.end()) {
    workspace_.select({*pressed_});
  }
}

void Viewport::select_in_box(Qt::KeyboardModifiers modifiers) {
  const Scope s = scope();
  const QPointF a = s.in_picture(from_), b = s.in_picture(at_);
  std::vector<ObjectId> found =
      pick_within(frame(), s.projection,
                  {std::min(a.x(), b.x()), std::min(a.y(), b.y()), std::max(a.x(), b.x()), std::max(a.y(), b.y())});
  if (is_free())
    for (const Icon& i : icons())
      if (const auto spot = s.spot(i.place); spot && QRectF(from_, at_).normalized().contains(*spot))
        found.push_back(i.id);
  std::vector<ObjectId> ids;
  if (modifiers & Qt::ShiftModifier) ids = workspace_.selected();
  const Marks known(ids);
  for (const ObjectId id : found)
    if (!known(id)) ids.push_back(id);
  workspace_.select(ids);
}

// Shows a menu of the objects under the pointer, from front to back, and of the actions on the selection.
void Viewport::contextMenuEvent(QContextMenuEvent* e) {
  if (gesture_ != Gesture::none || std::exchange(called_off_, false)) return;
  QMenu menu(this);
  const Scope s = scope();
  const QPointF at = s.in_picture(e->pos());
  const std::vector<Hit> all = pick_through(frame(), s.projection, at.x(), at.y());
  for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 12); ++i)
    menu.addAction(in_words(all[i].id), this, [this, id = all[i].id] { workspace_.select({id}); });
  if (!workspace_.selected().empty()) {
    menu.addSeparator();
    std::vector<std::string> lines;
    for (const ObjectId id : workspace_.selected())
      lines.push_back("at " + workspace_.when(workspace_.time()) + " hide " + workspace_.name(id));
    menu.addAction(tr("Frame it"), this, [this] { frame_selected(); });
    menu.addAction(tr("Hide from now on"), this, [this, lines] { workspace_.say(lines); })
        ->setToolTip(QString::fromStdString(lines[0]));
    add_motion_menu(menu);
  }
  menu.addSeparator();
  ObjectActions::of(workspace_).fill(menu);
  menu.exec(e->globalPos());
}

void Viewport::select_all() {
  std::vector<ObjectId> ids;
  for (const Item& i : frame().items) ids.push_back(i.id);
  workspace_.select(ids);
}

// ---- Transforms

const Hand& Viewport::grip() const {
  if (!grip_) grip_.emplace(workspace_.program(), shown_time(), workspace_.selected(), switches_.auto_key);
  return *grip_;
}

std::optional<Handles> Viewport::handles() const {
  if (plain_ || !switches_.handles || workspace_.selected().empty() || workspace_.playhead().playing() ||
      grip().empty())
    return std::nullopt;
  Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (switches_.own_axes || switches_.tool == Tool::scale) std::copy_n(grip().axes(), 3, axes);
  return Handles(scope(), switches_.tool, grip().place(), axes, handle_reach);
}

void Viewport::begin_pull(Tool tool, Part part, QPointF from, std::optional<EventAt> event) {
  workspace_.pause();
  refusal_.clear();
  Hand hand = event ? Hand(workspace_.program(), event->time, {event->target.object}, false)
                    : Hand(workspace_.program(), workspace_.time(), workspace_.selected(), switches_.auto_key);
  if (hand.empty()) {
    refusal_ = QString::fromStdString(hand.refusal(0));
    update();
    gesture_ = Gesture::none;
    return;
  }
  pull_.emplace(scope(), tool, part, std::move(hand), from, switches_.own_axes);
  gesture_ = Gesture::pull, pull_by_keys_ = false;
  held_ = Marks(with_what_hangs_on(event ? std::vector{event->target.object} : workspace_.selected()));
  held_box_ = event ? Box() : box_of(workspace_.selected());
  say_refusal();
  update();
}

void Viewport::say_refusal() {
  const std::uint16_t all[] = {fn::position, fn::rotation, fn::scale};
  refusal_ = QString::fromStdString(pull_->hand().refusal(all[static_cast<int>(pull_->tool())]));
}

void Viewport::take(Tool tool) {
  if (workspace_.selected().empty()) return;
  QPointF from = at_;
  if (!rect().contains(from.toPoint())) from = rect().center();
  begin_pull(tool, Part::all, from);
  pull_by_keys_ = true;
}

void Viewport::go_on_pulling(QPointF p, Qt::KeyboardModifiers modifiers) {
  if (!pull_) return;
  const bool grid = modifiers & Qt::ControlModifier;
  pull_->move_to(p, modifiers & Qt::ShiftModifier, grid);
  pull_->snap_to_lines(switches_.grid ? grid_step(pull_->scope()) : 0);
  pull_->snap_to(switches_.snaps && !grid ? snap_place(p, held_) : std::nullopt);
  pull_->snap_to_guides(shown_guides(), held_box_);
  show_pull();
}

void Viewport::show_pull() {
  const std::vector<std::string> lines = pull_->lines();
  lines.empty() ? workspace_.look_back() : (void)workspace_.look_ahead(lines);
  update();
}

void Viewport::end_pull(bool carry_out) {
  if (!pull_) return;
  const std::vector<std::string> lines = pull_->lines();
  pull_.reset();
  gesture_ = Gesture::none;
  if (!carry_out || lines.empty())
    workspace_.look_back();
  else
    workspace_.say(lines);
  grip_.reset();
  update();
}

bool Viewport::pulling_key(QKeyEvent* e) {
  const bool plane = e->modifiers() & Qt::ShiftModifier;
  switch (e->key()) {
    case Qt::Key_Escape:
      end_pull(false);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      end_pull(true);
      return true;
    case Qt::Key_X:
      pull_->constrain(plane ? Part::yz : Part::x);
      break;
    case Qt::Key_Y:
      pull_->constrain(plane ? Part::zx : Part::y);
      break;
    case Qt::Key_Z:
      pull_->constrain(plane ? Part::xy : Part::z);
      break;
    case Qt::Key_G:
      pull_->use(Tool::move);
      break;
    case Qt::Key_R:
      pull_->use(Tool::turn);
      break;
    case Qt::Key_S:
      pull_->use(Tool::scale);
      break;
    case Qt::Key_Backspace:
      pull_->erase();
      break;
    default:
      if (!pull_->type(e->text())) return false;
  }
  say_refusal();
  show_pull();
  return true;
}

// ---- Motions

std::optional<MotionHandles> Viewport::motion_handles() const {
  if (plain_ || !switches_.handles || workspace_.selected().size() != 1 || workspace_.playhead().playing())
    return std::nullopt;
  return MotionHandles::make(workspace_.program(), workspace_.selected().front(), shown_time());
}

void Viewport::drag_motion(QPointF p, Qt::KeyboardModifiers modifiers) {
  const Motion now = motion_drag_->handles.dragged(scope(), motion_drag_->part, p, motion_drag_->turned,
                                                   modifiers & Qt::ControlModifier);
  motion_drag_->turned = now.factors[motion_drag_->part.factor].angle;
  const MotionRow& row = motion_drag_->handles.row();
  motion_drag_->line = now == row.motion ? std::string() : row.line(now);
  motion_drag_->line.empty() ? workspace_.look_back() : (void)workspace_.look_ahead({motion_drag_->line});
  update();
}

void Viewport::end_motion(bool carry_out) {
  const std::string line = motion_drag_->line;
  motion_drag_.reset();
  gesture_ = Gesture::none;
  carry_out && !line.empty() ? (void)workspace_.say(line) : workspace_.look_back();
  grip_.reset();
  update();
}

// Adds what can be done with the factors of the motion that acts now: swap, remove and add.
void Viewport::add_motion_menu(QMenu& menu) {
  if (workspace_.selected().size() != 1) return;
  const auto row = motion_row(workspace_.document(), workspace_.selected().front(), shown_time());
  if (!row) return;
  QMenu* of = menu.addMenu(tr("Motion"));
  of->setToolTipsVisible(true);
  const auto add = [&](const QString& words, const Motion& motion) {
    of->addAction(words, this, [this, line = row->line(motion)] {
        workspace_.say(line);
      })->setToolTip(QString::fromStdString(row->line(motion)));
  };
  const auto& all = row->motion.factors;
  const auto word = [&](std::size_t k) { return QString::fromStdString(to_string(Motion{{all[k]}})).left(40); };
  for (std::size_t k = 0; k + 1 < all.size() && k < 12; ++k) {
    Motion swapped = row->motion;
    std::swap(swapped.factors[k], swapped.factors[k + 1]);
    add(tr("Swap %1 and %2").arg(word(k), word(k + 1)), swapped);
  }
  for (std::size_t k = 0; all.size() > 1 && k < all.size() && k < 12; ++k) {
    Motion fewer = row->motion;
    fewer.factors.erase(fewer.factors.begin() + static_cast<std::ptrdiff_t>(k));
    add(tr("Remove %1").arg(word(k)), fewer);
  }
  for (const auto& [words, factor] : {std::pair(tr("Add a translation"), translate_by({1, 0, 0})),
                                      {tr("Add a rotation"), rotate_by(pi / 2)},
                                      {tr("Add a scaling"), scale_by({2, 2, 1})}}) {
    Motion more = row->motion;
    more.factors.insert(more.factors.begin(), factor);
    add(words, more);
  }
}

}  // namespace betwixt::studio
