// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The look of the studio: the light and the dark theme, and the colours of painted content.
#pragma once

#include <QApplication>
#include <QColor>

#include "betwixt/value.h"

namespace betwixt::studio {

enum class Theme { dark, light };
// Safe colours differ for colour-blind eyes too.
void set_theme(QApplication&, Theme, bool safe = false);

// The colours of painted content, in the current theme.
struct Colors {
  QColor back, raised, line, text, dim, accent, playhead, event, selected, error, warning, note, cut;
  QColor x, y, z;  // of axes and components, and of a colour's red, green and blue
};
const Colors& colors();
// How much two colours differ in lightness, from 1 to 21 (WCAG). Text needs 4.5, a large sign or a line needs 3.
double contrast(const QColor&, const QColor&);
QColor text_on(const QColor& ground);  // black or white
QColor faint(QColor, float alpha);
QColor swatch(const Color&);  // a colour of the film
// Returns the colours for overlays on pictures, the same in each theme.
const Colors& picture_colors();

}  // namespace betwixt::studio
