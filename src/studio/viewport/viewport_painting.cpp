// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Painting of the overlays on the picture.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "betwixt/object.h"
#include "scene/functions.h"
#include "studio/objects/object_lines.h"
#include "studio/shell/marks.h"
#include "studio/shell/theme.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

bool has_members(Kind k) { return k == Kind::group || find_built_in(k, "bare"); }

// Outlines would cover such small letters.
bool is_text_of_chart(const Document& d, ObjectId id) { return kind(d, id) == Kind::text && !(whole_of(d, id) == id); }

constexpr std::size_t most_outlined = 60;     // objects
constexpr std::size_t most_corners = 40'000;  // of their meshes
constexpr std::size_t most_cleared = 60;      // objects in front of the grid
constexpr std::size_t most_bracketed = 300;
constexpr double grid_pixels = 40;  // least distance of two lines

// Shows where a film is transparent.
QBrush checkerboard() {
  QPixmap two(16, 16);
  two.fill(QColor(0x66, 0x66, 0x66));
  QPainter p(&two);
  p.fillRect(0, 0, 8, 8, QColor(0x99, 0x99, 0x99));
  p.fillRect(8, 8, 8, 8, QColor(0x99, 0x99, 0x99));
  p.end();
  return two;
}

}  // namespace

void Viewport::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), palette().color(QPalette::Window).darker(120));
  p.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!shown_.image.isNull() && workspace_.document().transparent()) p.fillRect(picture_box(), checkerboard());
  if (!shown_.image.isNull()) p.drawImage(picture_box(), shown_.image);
  if (plain_) return;
  if (!is_free()) {
    p.setPen(QPen(colors().line, 1));
    p.drawRect(picture_box().adjusted(0, 0, -1, -1));
  }
  if (!is_free()) paint_guides(p);
  const Scope s = scope();
  const bool stands = !workspace_.playhead().playing();
  if (switches_.grid) paint_grid(p, s);
  const Ghosts::Kinds kinds{switches_.ghosts, switches_.key_ghosts};
  if ((kinds.frames || kinds.events) && stands && !workspace_.looks_ahead())
    ghosts_.paint(p, s, eye(), frame(), kinds, [this] { return with_what_hangs_on(workspace_.selected()); });
  if (switches_.trails && !workspace_.selected().empty() && !trails_.paint(p, s, shown_time()))
    QMetaObject::invokeMethod(this, qOverload<>(&QWidget::update), Qt::QueuedConnection);
  if (!workspace_.selected().empty()) paint_outlines(p, s);
  if (is_free() || !workspace_.selected().empty()) paint_icons(p, s);
  if (is_free() && stands) paint_camera(p, s);
  if (const auto motion = motion_handles()) motion->paint(p, s, motion_drag_ ? motion_drag_->part : hot_motion_);
  if (pull_)
    paint_pull(p);
  else if (const auto h = handles())
    h->paint(p, hot_);
  if (switches_.guides) paint_own_guides(p);
  if (switches_.measures) paint_measure(p, s);
  if (switches_.auto_key) paint_auto_key(p);
  paint_words(p);
}

// A red frame: every change writes an event.
void Viewport::paint_auto_key(QPainter& p) {
  p.setRenderHint(QPainter::Antialiasing, false);
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(colors().error, 4));
  p.drawRect(rect().adjusted(2, 2, -2, -2));
  const QString words = tr("auto-key: every change writes an event");
  const QRect box(rect().right() - fontMetrics().horizontalAdvance(words) - 16,
                  rect().bottom() - fontMetrics().height() - 12, fontMetrics().horizontalAdvance(words) + 12,
                  fontMetrics().height() + 8);
  p.fillRect(box, colors().error);
  p.setPen(text_on(colors().error));
  p.drawText(box, Qt::AlignCenter, words);
}

QImage Viewport::layer() const {
  QImage image(size() * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(devicePixelRatioF());
  image.fill(Qt::transparent);
  return image;
}

// Returns whether the picture is so bright that dark lines are easier to see.
bool Viewport::is_bright() const {
  const QImage& image = shown_.image;
  if (image.isNull()) return false;
  int sum = 0;
  constexpr int side = 8;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      sum += qGray(image.pixel(image.width() * (2 * x + 1) / (2 * side), image.height() * (2 * y + 1) / (2 * side)));
  return sum > 170 * side * side;
}

// Paints lines on the floor, or on the paper of a flat film.
void Viewport::paint_grid(QPainter& p, const Scope& s) {
  const Camera eye = this->eye();
  if (!grid_ || !(grid_->eye == eye) || grid_->box != picture_box()) {
    grid_ = Layer{layer(), {}, eye, picture_box()};
    QPainter on(&grid_->image);
    on.setClipRect(s.box);
    draw_grid(on, s);
    if (!frame().surroundings.flat) clear_things(on, s);
  }
  p.drawImage(0, 0, grid_->image);
}

std::pair<Vec3, double> Viewport::grid_middle(const Scope& s) const {
  const bool flat = frame().surroundings.flat;
  const Vec3 up = flat ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Ray middle = s.projection.ray(0.5, flat ? 0.5 : 0.65);
  const double slope = dot(middle.along, up);
  Vec3 centre{};
  if (slope < -1e-3 && dot(middle.from, up) > 0) centre = middle.from - dot(middle.from, up) / slope * middle.along;
  return {centre, std::max(s.depth(centre), 1e-3)};
}

double Viewport::grid_step(const Scope& s) const {
  return 2 * step_below(s.metres(grid_middle(s).second) * grid_pixels);
}

void Viewport::draw_grid(QPainter& p, const Scope& s) const {
  const bool flat = frame().surroundings.flat;
  const Vec3 u{1, 0, 0}, v = flat ? Vec3{0, 1, 0} : Vec3{0, 0, 1}, centre = grid_middle(s).first;
  const double step = grid_step(s);
  constexpr int lines = 24;
  const double cu = std::round(dot(centre, u) / step), cv = std::round(dot(centre, v) / step);
  const QColor plain = is_bright() ? QColor(Qt::black) : QColor(Qt::white);
  p.setRenderHint(QPainter::Antialiasing);
  const auto draw = [&](Vec3 along, Vec3 across, double c_along, double c_across, const QColor& axis) {
    for (int i = -lines; i <= lines; ++i) {
      const double k = c_across + i;
      const bool is_axis = k == 0, major = std::fmod(k, 5) == 0;
      QColor color = is_axis ? axis : plain;
      std::optional<QPointF> before;
      for (int j = -lines; j <= lines; ++j) {
        const auto spot = s.spot(step * (k * across + (c_along + j) * along));
        if (before && spot) {
          const double far = std::hypot(i, j - 0.5) / lines;
          color.setAlphaF(std::clamp(1 - far, 0.0, 1.0) * (is_axis ? 0.9 : major ? 0.5 : 0.22));
          p.setPen(QPen(color, is_axis ? 1.5 : 1));
          p.drawLine(*before, *spot);
        }
        before = spot;
      }
    }
  };
  draw(u, v, cu, cv, picture_colors().x);
  draw(v, u, cv, cu, flat ? picture_colors().y : picture_colors().z);
}

// Erases the grid behind objects. The ground itself keeps its lines.
void Viewport::clear_things(QPainter& p, const Scope& s) const {
  p.setCompositionMode(QPainter::CompositionMode_DestinationOut);
  p.setRenderHint(QPainter::Antialiasing, false);
  std::size_t things = 0, corners = 0;
  HeldShapes held;
  for (const Item& i : frame().items) {
    corners += i.shape->mesh ? i.shape->mesh->positions.size() : 300;
    if (i.transparency > 0.5 || ++things > most_cleared || corners > most_corners) continue;
    Box box;
    for (const Vec3& corner : drawn(i).corners) box.add(corner);
    const Vec3 half = box.half();
    if (half.y > 0.02 * std::max(half.x, half.z)) paint_silhouette(p, s, i, Qt::black, held);
  }
}

// Paints an outline around the visible part of selected objects; of many objects, only the corners of their boxes.
void Viewport::paint_outlines(QPainter& p, const Scope& s) {
  const Camera eye = this->eye();
  if (!outline_ || outline_->of != workspace_.selected() || !(outline_->eye == eye) || outline_->box != picture_box()) {
    outline_ = Layer{{}, workspace_.selected(), eye, picture_box()};
    bracketed_.clear();
    QImage mask = layer();
    QPainter on(&mask);
    on.setClipRect(s.box);
    std::size_t things = 0, corners = 0;
    const HeldShapes before = std::exchange(outlined_shapes_, {});
    // A group is outlined through its members, a chart through its pieces.
    const std::vector<ObjectId>& ids = workspace_.selected();
    const bool groups =
        std::any_of(ids.begin(), ids.end(), [&](ObjectId id) { return has_members(kind(workspace_.document(), id)); });
    const Marks marked(groups ? with_what_hangs_on(ids) : ids);
    const Marks selected(ids);
    for (const Item& i : frame().items) {
      if (!marked(i.id) || (is_text_of_chart(workspace_.document(), i.id) && !selected(i.id))) continue;
      corners += i.shape->mesh ? i.shape->mesh->positions.size() : 300;
      if (++things > most_outlined || corners > most_corners) {
        if (bracketed_.size() < most_bracketed) bracketed_.push_back(i.id);
        continue;
      }
      paint_silhouette(on, s, i, i.id == ids.back() ? picture_colors().event : picture_colors().accent,
                       outlined_shapes_);
    }
    on.end();
    QImage line = layer();
    QPainter over(&line);
    // A dark border makes the line visible on its own colour, too.
    QImage dark = mask;
    QPainter darken(&dark);
    darken.setCompositionMode(QPainter::CompositionMode_SourceIn);
    darken.fillRect(rect(), QColor(0, 0, 0, 60));
    darken.end();
    for (const auto& [x, y] : {std::pair(-3, 0), {3, 0}, {0, -3}, {0, 3}, {-2, -2}, {2, -2}, {-2, 2}, {2, 2}})
      over.drawImage(x, y, dark);
    for (const auto& [x, y] : {std::pair(-2, 0), {2, 0}, {0, -2}, {0, 2}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}})
      over.drawImage(x, y, mask);
    over.setCompositionMode(QPainter::CompositionMode_DestinationOut);
    over.drawImage(0, 0, mask);
    over.end();
    outline_->image = std::move(line);
  }
  p.drawImage(0, 0, outline_->image);
  for (const ObjectId id : bracketed_) paint_brackets(p, s, id);
}

void Viewport::paint_brackets(QPainter& p, const Scope& s, ObjectId id) {
  const auto item = std::find_if(frame().items.begin(), frame().items.end(), [&](const Item& i) { return i.id == id; });
  if (item == frame().items.end()) return;
  const auto r = rectangle_around(drawn(*item), s.projection);
  if (!r) return;
  const auto x = [&](double v) { return s.box.left() + std::clamp(v, 0.0, 1.0) * s.box.width(); };
  const auto y = [&](double v) { return s.box.top() + std::clamp(v, 0.0, 1.0) * s.box.height(); };
  const QRectF box = QRectF(QPointF(x(r->left), y(r->top)), QPointF(x(r->right), y(r->bottom))).adjusted(-3, -3, 3, 3);
  const double l = std::min({12.0, box.width() / 3, box.height() / 3});
  p.setPen(QPen(id == workspace_.selected().back() ? picture_colors().event : picture_colors().accent, 1.5));
  for (const auto& [corner, dx, dy] : {std::tuple(box.topLeft(), 1, 1),
                                       {box.topRight(), -1, 1},
                                       {box.bottomLeft(), 1, -1},
                                       {box.bottomRight(), -1, -1}}) {
    p.drawLine(corner, corner + QPointF(dx * l, 0));
    p.drawLine(corner, corner + QPointF(0, dy * l));
  }
}

void Viewport::paint_icons(QPainter& p, const Scope& s) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setClipRect(s.box);
  const std::vector<ObjectId>& ids = workspace_.selected();
  const Marks marked(ids);
  for (const Icon& i : icons()) {
    const bool selected = marked(i.id);
    if (!is_free() && !selected) continue;
    const auto spot = s.spot(i.place);
    // The current camera has no icon in its own view. In a flat film it would cover the middle of the picture.
    const bool here = i.kind == Kind::camera && !selected &&
                      (frame().surroundings.flat || length(i.place - s.projection.eye()) < 1e-3);
    if (!spot || here) continue;
    const QColor color =
        selected ? (i.id == ids.back() ? picture_colors().event : picture_colors().accent) : QColor(0xe8, 0xe8, 0xe8);
    for (const bool shade : {true, false}) {
      p.setPen(QPen(shade ? QColor(0, 0, 0, 130) : color, shade ? 3.5 : 1.5));
      if (i.kind == Kind::light) {
        p.drawEllipse(*spot, 4, 4);
        for (int k = 0; k < 8; ++k) {
          const QPointF out(std::cos(k * pi / 4), std::sin(k * pi / 4));
          p.drawLine(*spot + 6.5 * out, *spot + 9 * out);
        }
      } else if (i.kind == Kind::camera) {
        p.drawRect(QRectF(*spot - QPointF(8, 5), QSizeF(11, 10)));
        p.drawPolygon(QPolygonF() << *spot + QPointF(3, 0) << *spot + QPointF(9, -5) << *spot + QPointF(9, 5));
      } else {
        p.drawLine(*spot - QPointF(7, 0), *spot + QPointF(7, 0));
        p.drawLine(*spot - QPointF(0, 7), *spot + QPointF(0, 7));
      }
    }
  }
  p.restore();
}

// Paints the view frustum of the film's camera.
void Viewport::paint_camera(QPainter& p, const Scope& s) {
  const Camera& c = frame().camera;
  const Projection film(c, workspace_.document().aspect());
  const double away = length(film.eye() - s.projection.eye());
  if (away < 1e-6) return;
  const double depth = c.orthographic ? 0 : 0.12 * away;
  QPolygonF window;
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    if (const auto spot = s.spot(film.place(x, y, depth))) window << *spot;
  const auto eye = s.spot(film.eye());
  if (window.size() != 4 || !eye) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  QColor color = picture_colors().accent;
  color.setAlpha(150);
  p.setPen(QPen(color, 1.25));
  p.setBrush(Qt::NoBrush);
  p.drawPolygon(window);
  if (!c.orthographic)
    for (const QPointF& corner : window) p.drawLine(*eye, corner);
  p.restore();
}

// Paints the axes of the current transform.
void Viewport::paint_pull(QPainter& p) {
  const Scope s = scope();
  p.save();
  p.setClipRect(s.box);
  p.setRenderHint(QPainter::Antialiasing);
  const Colors& c = picture_colors();
  const QColor all[] = {c.x, c.y, c.z};
  const double reach = s.metres(std::max(1e-3, s.depth(pull_->hand().place()))) * 4000;
  for (int i = 0; i < 3; ++i) {
    if (!pull_->is_along(i)) continue;
    QColor color = all[i];
    color.setAlpha(170);
    p.setPen(QPen(color, 1.25));
    std::optional<QPointF> before;
    for (int k = -200; k <= 200; ++k) {
      const auto spot = s.spot(pull_->hand().place() + reach * k / 200 * pull_->axis(i));
      if (before && spot) p.drawLine(*before, *spot);
      before = spot;
    }
  }
  if (const auto target = pull_->target())
    if (const auto spot = s.spot(*target)) {
      p.setPen(QPen(picture_colors().event, 2)), p.setBrush(Qt::NoBrush);
      p.drawEllipse(*spot, 7, 7);
    }
  p.restore();
}

void Viewport::paint_words(QPainter& p) {
  if (gesture_ == Gesture::box) {
    QColor inside = picture_colors().accent;
    p.setPen(QPen(inside, 1));
    inside.setAlpha(40);
    p.setBrush(inside);
    p.drawRect(QRectF(from_, at_).normalized());
  }
  QString words = pull_ ? QString::fromStdString(pull_->in_words()) : QString();
  if (guide_drag_)
    words = guide_drag_->now ? tr("guide at %1 m").arg(studio::in_words(*guide_drag_->now)) : tr("removes the guide");
  if (words.isEmpty() && workspace_.left_out()) words = tr("only a part of the film is shown: / shows everything");
  if (!refusal_.isEmpty()) words += (words.isEmpty() ? "" : " — ") + refusal_;
  if (words.isEmpty()) return;
  const QFontMetricsF metrics(font());
  const double pad = metrics.height() / 3;
  QRectF box = metrics.boundingRect(words).adjusted(-2 * pad, -pad, 2 * pad, pad);
  box.moveBottomLeft(QPointF(pad * 2, height() - pad * 2));
  QColor back = colors().raised;
  back.setAlpha(225);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen), p.setBrush(back);
  p.drawRoundedRect(box, pad, pad);
  p.setPen(refusal_.isEmpty() ? colors().text : colors().warning);
  p.drawText(box, Qt::AlignCenter, words);
}

}  // namespace betwixt::studio
