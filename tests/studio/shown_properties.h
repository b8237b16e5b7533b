// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The properties of an object of a film, in a window.
#pragma once

#include <QTest>

#include "studio/film.h"
#include "studio/panels/properties.h"

namespace betwixt::studio {

struct ShownProperties : Film {
  Properties panel{workspace};
  explicit ShownProperties(const QByteArray& text, const char* selected, int width) : Film(text) {
    panel.resize(width, 900);
    panel.show();
    if (!QTest::qWaitForWindowActive(&panel)) qFatal("no window");
    select(selected);
  }
};

}  // namespace betwixt::studio
