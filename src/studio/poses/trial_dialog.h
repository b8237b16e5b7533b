// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Small windows that ask for an amount or a curve. The picture shows what each answer would do. Escape takes it back.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "studio/timeline/event_lines.h"

class QWidget;

namespace betwixt::studio {

// Asks for a share, from `low` to `high` percent. `lines` returns the lines that show it. Returns nullopt after Escape.
std::optional<double> ask_share(Workspace&, QWidget* parent, const QString& title, int low, int high, int start,
                                const std::function<Lines(double share)>& lines);
// Asks for a curve from 0 to 1 that never falls: the x and y of the two handles of a Bézier curve, all from 0 to 1.
std::optional<std::array<double, 4>> ask_curve(Workspace&, QWidget* parent, const QString& title,
                                               const std::function<Lines(const std::array<double, 4>&)>& lines);

// Asks for a tolerance, a share. `words` describes what it does.
std::optional<double> ask_tolerance(Workspace&, QWidget* parent, const QString& title, double start,
                                    const std::function<QString(double share)>& words,
                                    const std::function<Lines(double share)>& lines);

}  // namespace betwixt::studio
