// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/theme.h"

#include <QPalette>
#include <QStyleFactory>
#include <algorithm>

namespace betwixt::studio {
namespace {

const Colors dark{.back = 0x1b1d21,
                  .raised = 0x26292e,
                  .line = 0x383c43,
                  .text = 0xdcdfe4,
                  .dim = 0x878d98,
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
                   .playhead = 0xd9411e,
                   .event = 0xa97a00,
                   .selected = 0x101010,
                   .error = 0xc42020,
                   .warning = 0x9c6200,
                   .note = 0x1f7f48,
                   .cut = 0x8038b4,
                   .x = 0xc93432,
                   .y = 0x3d8c22,
                   .z = 0x2565c0};

// After the colours of Okabe and Ito, lighter on dark ground and darker on light ground.
Colors safe_dark() {
  Colors c = dark;
  c.accent = 0x56b4e9, c.playhead = 0xff7f32, c.event = 0xf0e442, c.error = 0xff7f50, c.warning = 0xe69f00;
  c.note = 0x35c4a0, c.cut = 0xd990bb;
  c.x = 0xe8702a, c.y = 0x2fc79f, c.z = 0x56b4e9;
  return c;
}
Colors safe_light() {
  Colors c = light;
  c.accent = 0x0072b2, c.playhead = 0xc04a00, c.event = 0x7a6a00, c.error = 0xb83a00, c.warning = 0x8a5a00;
  c.note = 0x00785a, c.cut = 0xa8487f;
  c.x = 0xc04a00, c.y = 0x00805f, c.z = 0x0072b2;
  return c;
}
const Colors dark_safe = safe_dark(), light_safe = safe_light();
const Colors *now = &dark, *on_pictures = &dark;

}  // namespace

const Colors& colors() { return *now; }

QColor faint(QColor c, float alpha) {
  c.setAlphaF(alpha);
  return c;
}

QColor swatch(const Color& c) {
  const auto part = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
  return QColor::fromRgbF(part(c.r), part(c.g), part(c.b));
}
const Colors& picture_colors() { return *on_pictures; }

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
  p.setColor(QPalette::HighlightedText, Qt::white);
  p.setColor(QPalette::Link, c.accent);
  p.setColor(QPalette::Mid, c.line), p.setColor(QPalette::Dark, c.line), p.setColor(QPalette::Shadow, c.line);
  p.setColor(QPalette::Light, c.line), p.setColor(QPalette::Midlight, c.line);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, c.dim);
  app.setStyle(QStyleFactory::create("Fusion"));
  app.setPalette(p);
}

}  // namespace betwixt::studio
