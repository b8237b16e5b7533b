// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The icons of axes, plots, charts, code and diagrams.
#pragma once

#include <QPainter>

#include "betwixt/shape.h"

namespace betwixt::studio {

// Draws the icon of such a kind into a square from 0 to 16, with the pen and the brush that the painter has. Returns
// false for other kinds.
bool draw_chart_icon(QPainter&, Kind);

}  // namespace betwixt::studio
