// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The switches in the upper corners of the picture.
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

#include "studio/shell/keys.h"
#include "studio/shell/scrolled.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

struct Toggle {
  const char *name, *sign, *tip;
  bool ViewportSwitches::*is;
};
const Toggle toggles[] = {
    {"own_axes", "∠", "Shows the handles along the object's own axes instead of the world's",
     &ViewportSwitches::own_axes},
    {"auto_key", "●", "Auto-key: every change becomes an event at the playhead: `at 24f ball.position (1 2 3)`",
     &ViewportSwitches::auto_key},
    {"trails", "⌇", "Motion paths of the selection, with larger dots at events", &ViewportSwitches::trails},
    {"ghosts", "◌", "Onion skin: the objects 2, 4 and 6 frames before and after", &ViewportSwitches::ghosts},
    {"grid", "▦", "A grid on the ground", &ViewportSwitches::grid},
    {"snaps", "∩", "Snapping: what you move goes to points and surfaces of other objects; with Ctrl to a grid",
     &ViewportSwitches::snaps},
    {"measures", "↔", "Measures the distance between two points that you click", &ViewportSwitches::measures},
};
struct ToolRow {
  Tool tool;
  const char *name, *sign, *tip;
};
const ToolRow tools[] = {
    {Tool::move, "move", "✥",
     "Handles to move ({Handles to move}); press {Move selection} to move without handles: `set ball.position (1 2 "
     "3)`"},
    {Tool::turn, "turn", "↻",
     "Handles to rotate ({Handles to turn}); press {Rotate selection} to rotate without handles: `set ball.rotation "
     "euler(0 90deg 0)`"},
    {Tool::scale, "scale", "⤢",
     "Handles to scale ({Handles to scale}); press {Scale selection} to scale without handles: `set ball.scale (2 2 "
     "2)`"},
};

constexpr const char* eye_tip = "Switches between the film's camera and a free view ({Free view})";

QToolButton* button(QWidget* parent, const char* name, const char* sign, const char* tip) {
  auto* b = new QToolButton(parent);
  b->setObjectName(name);
  b->setText(QString::fromUtf8(sign));
  b->setToolTip(word_of(tip));
  b->setCheckable(true);
  b->setAutoRaise(true);
  b->setFocusPolicy(Qt::TabFocus);
  parent->layout()->addWidget(b);
  return b;
}

QWidget* bar(QWidget* parent) {
  auto* w = new QWidget(parent);
  auto* row = new QHBoxLayout(w);
  row->setContentsMargins(3, 2, 3, 2);
  row->setSpacing(1);
  return w;
}

QWidget* scrolled_bar(QWidget* content, QWidget* parent) {
  auto* w = new Scrolled(content, Qt::Horizontal, parent);
  w->setAutoFillBackground(true);
  w->setCursor(Qt::ArrowCursor);
  return w;
}

}  // namespace

void Viewport::make_corner() {
  QWidget* const on_left = bar(this);
  corner_ = scrolled_bar(on_left, this);
  for (int i = 0; i < 3; ++i) {
    tools_[i] = button(on_left, tools[i].name, tools[i].sign, tools[i].tip);
    connect(tools_[i], &QToolButton::clicked, this, [this, i] {
      ViewportSwitches s = switches_;
      s.handles = s.tool != tools[i].tool || !s.handles, s.tool = tools[i].tool;
      set_switches(s);
    });
  }
  for (std::ptrdiff_t i = 0; i < std::ssize(toggles); ++i) {
    toggles_[i] = button(on_left, toggles[i].name, toggles[i].sign, toggles[i].tip);
    connect(toggles_[i], &QToolButton::clicked, this, [this, i](bool on) {
      ViewportSwitches s = switches_;
      s.*toggles[i].is = on;
      set_switches(s);
    });
  }
  QWidget* const on_right = bar(this);
  eye_corner_ = scrolled_bar(on_right, this);
  styles_ = new QComboBox(on_right);
  styles_->setObjectName("style");
  styles_->setSizeAdjustPolicy(QComboBox::AdjustToContents),
      styles_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  styles_->setFocusPolicy(Qt::TabFocus);
  styles_->setToolTip(tr("The style of the picture"));
  for (const Style& s : betwixt::styles()) {
    styles_->addItem(text_of(s.name));
    styles_->setItemData(styles_->count() - 1, text_of(s.what), Qt::ToolTipRole);
  }
  on_right->layout()->addWidget(styles_);
  connect(styles_, &QComboBox::textActivated, this, [this](const QString& s) { set_style(s.toStdString()); });
  eye_button_ = button(on_right, "eye", "", eye_tip);
  connect(eye_button_, &QToolButton::clicked, this, [this] { set_free(!is_free()); });
  measure_by_text(*this, [this] { place_corner(); });
  // Their tips name the keys that the user has chosen.
  const auto tell_keys = [this] {
    for (int i = 0; i < 3; ++i) tools_[i]->setToolTip(with_keys(word_of(tools[i].tip)));
    eye_button_->setToolTip(with_keys(word_of(eye_tip)));
  };
  tell_keys();
  connect(&Keys::of_user(), &Keys::changed, this, tell_keys);
  show_corner();
}

void Viewport::show_corner() {
  for (int i = 0; i < 3; ++i) tools_[i]->setChecked(switches_.handles && switches_.tool == tools[i].tool);
  for (std::ptrdiff_t i = 0; i < std::ssize(toggles); ++i) toggles_[i]->setChecked(switches_.*toggles[i].is);
  styles_->setCurrentText(QString::fromStdString(style_));
  eye_button_->setText(
      !side_words().isEmpty() ? side_words()
      : through_              ? tr("through %1").arg(QString::fromStdString(workspace_.name(through_)))
      : is_free()             ? tr("free view")
                  : tr("camera %1").arg(QString::fromStdString(film_camera() ? workspace_.name(film_camera()) : "")));
  eye_button_->setChecked(is_free());
  place_corner();
}

void Viewport::set_plain(bool plain) {
  plain_ = plain;
  corner_->setHidden(plain || side_), eye_corner_->setHidden(plain);
  update();
}

void Viewport::place_corner() {
  const int margin = fontMetrics().height() / 3;
  const int edge = static_cast<int>(ruler()) + margin;
  for (QWidget* w : {corner_, eye_corner_}) {
    w->adjustSize();
    if (const int room = width() - edge - margin; w->width() > room && room > 0)
      w->resize(room, w->height()), w->resize(room, w->sizeHint().height());  // with a scroll bar
  }
  corner_->move(edge, edge);
  const bool below = !side_ && edge + corner_->width() + eye_corner_->width() + 2 * margin > width();
  eye_corner_->move(std::max(margin, width() - eye_corner_->width() - margin),
                    below ? corner_->height() + edge + margin : edge);
}

}  // namespace betwixt::studio
