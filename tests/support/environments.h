// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Short functions that make events of environments.
#pragma once

#include "scene/environment.h"

namespace betwixt::environments {

using Event = EnvironmentEvent;
using Animate = Event::Animate;
using Halt = Event::Halt;
using Kill = Event::Kill;
using Cancel = Event::Cancel;

inline constexpr double degree = pi / 180;
inline const Mat4 step = translation({1, 0, 0});

inline Animate every(std::int64_t interval, const Mat4& m) {
  Animate a;
  a.motion = m;
  a.timing.interval = interval;
  return a;
}

}  // namespace betwixt::environments
