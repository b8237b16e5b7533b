// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/theme.h"

#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>
#include <algorithm>
#include <cmath>

#include "studio/shell/text_size.h"

namespace betwixt::studio {
namespace {

const Colors dark{.back = 0x1b1d21,
                  .raised = 0x26292e,
                  .line = 0x383c43,
                  .text = 0xdcdfe4,
                  .dim = 0x90969f,
                  .accent = 0x4a9eff,
                  .playhead = 0xff6b4a,
                  .event = 0xe8c35a,
                  .selected = 0xffffff,
                  .error = 0xff5c5c,
                  .warning = 0xe5a33d,
                  .note = 0x62c48a,
                  .cut = 0xc087e8,
                  .x = 0xf0625f,
                  .y = 0x7bc95f,
                  .z = 0x5f9df0};
const Colors light{.back = 0xf6f6f4,
                   .raised = 0xffffff,
                   .line = 0xd2d2cd,
                   .text = 0x202226,
                   .dim = 0x6d7178,
                   .accent = 0x1668c8,
                   .playhead = 0xc93c1a,
                   .event = 0x8f6700,
                   .selected = 0x101010,
                   .error = 0xc42020,
                   .warning = 0x9c6200,
                   .note = 0x1f7f48,
                   .cut = 0x8038b4,
                   .x = 0xc93432,
                   .y = 0x3d8c22,
                   .z = 0x2565c0};

// Hues as those of Okabe and Ito. Their lightness differs too, so that axes, events and notes are told apart with each
// kind of colour blindness (CIE Lab: at least 30 apart).
Colors safe_dark() {
  Colors c = dark;
  c.x = 0xa8661c, c.playhead = 0xc48949, c.y = c.note = 0x03fda5, c.z = c.accent = 0x1994fb;
  c.event = 0xfae133, c.cut = 0xf650a5;
  c.error = 0xff7f50, c.warning = 0xe69f00;
  return c;
}
Colors safe_light() {
  Colors c = light;
  c.x = c.playhead = 0x5a1406, c.y = 0x168873, c.note = 0x117e69, c.z = 0x14265b;
  c.event = 0x817000, c.cut = 0xbc02de;
  c.accent = 0x0072b2, c.error = 0xb83a00, c.warning = 0x8a5a00;
  return c;
}
const Colors dark_safe = safe_dark(), light_safe = safe_light();
const Colors *now = &dark, *on_pictures = &dark;

}  // namespace

const Colors& colors() { return *now; }

double contrast(const QColor& a, const QColor& b) {
  const auto light = [](const QColor& c) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF()) + 0.05;
  };
  return std::max(light(a), light(b)) / std::min(light(a), light(b));
}

QColor text_on(const QColor& ground) {
  const QColor black(0x10, 0x10, 0x10);
  return contrast(Qt::white, ground) > contrast(black, ground) ? QColor(Qt::white) : black;
}

QColor faint(QColor c, float alpha) {
  c.setAlphaF(alpha);
  return c;
}

QColor swatch(const Color& c) {
  const auto part = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
  return QColor::fromRgbF(part(c.r), part(c.g), part(c.b));
}
const Colors& picture_colors() { return *on_pictures; }

namespace {

// Fusion outlines check boxes in a colour that dark windows hide, and its icons and boxes do not grow with the text.
class SeenBoxes : public QProxyStyle {
 public:
  SeenBoxes() : QProxyStyle("Fusion") {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    const int size = QProxyStyle::pixelMetric(metric, option, widget);
    switch (metric) {
      case PM_SmallIconSize:
      case PM_ButtonIconSize:
      case PM_ListViewIconSize:
      case PM_LineEditIconSize:
      case PM_TabBarIconSize:
      case PM_TabBarScrollButtonWidth:
      case PM_IndicatorWidth:
      case PM_IndicatorHeight:
      case PM_MenuButtonIndicator:
      case PM_ScrollBarExtent:
      case PM_SliderThickness:
      case PM_SliderLength:
      case PM_SliderControlThickness:
        return static_cast<int>(std::lround(size * size_of_all_text()));
      default:
        return size;
    }
  }
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* p,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, p, widget);
    if (element != PE_IndicatorCheckBox) return;
    p->setPen(option->palette.color(QPalette::PlaceholderText));
    p->setBrush(Qt::NoBrush);
    p->drawRect(option->rect.adjusted(0, 0, -1, -1));
  }
};

}  // namespace

void set_theme(QApplication& app, Theme theme, bool safe) {
  on_pictures = safe ? &dark_safe : &dark;
  now = theme == Theme::dark ? on_pictures : safe ? &light_safe : &light;
  const Colors& c = *now;
  QPalette p;
  p.setColor(QPalette::Window, c.raised);
  p.setColor(QPalette::WindowText, c.text);
  p.setColor(QPalette::Base, c.back);
  p.setColor(QPalette::AlternateBase, c.raised);
  p.setColor(QPalette::ToolTipBase, c.raised);
  p.setColor(QPalette::ToolTipText, c.text);
  p.setColor(QPalette::Text, c.text);
  p.setColor(QPalette::PlaceholderText, c.dim);
  p.setColor(QPalette::Button, c.raised);
  p.setColor(QPalette::ButtonText, c.text);
  p.setColor(QPalette::Highlight, c.accent);
  p.setColor(QPalette::HighlightedText, text_on(c.accent));
  p.setColor(QPalette::Link, c.accent);
  p.setColor(QPalette::Mid, c.line), p.setColor(QPalette::Dark, c.line), p.setColor(QPalette::Shadow, c.line);
  p.setColor(QPalette::Light, c.line), p.setColor(QPalette::Midlight, c.line);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, c.dim);
  app.setStyle(new SeenBoxes);
  app.setPalette(p);
}

}  // namespace betwixt::studio
