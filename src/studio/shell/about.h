// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the program says of itself: its icon, its version, its licence.
#pragma once

#include <QIcon>

namespace betwixt::studio {

QIcon program_icon();
QString about_words();
void open_about(QWidget* over);

}  // namespace betwixt::studio
