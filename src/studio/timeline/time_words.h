// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Times as script lines write them.
#pragma once

#include <cmath>
#include <string>

#include "language/values.h"
#include "studio/shell/workspace.h"

namespace betwixt::studio {

// "6f..12f"
inline std::string segment_words(const Workspace& workspace, Time from, Time to) {
  return workspace.when(from) + ".." + workspace.when(to);
}

// Returns a length: "3f" for whole frames, otherwise seconds.
inline std::string length_words(const Document& d, Time length) {
  const double frames = std::round(d.rate().frame_number(length) - 1);
  return d.rate().span(frames) == length ? write_number(frames) + "f" : write_seconds(length);
}
inline std::string length_words(const Workspace& workspace, Time length) {
  return length_words(workspace.document(), length);
}

}  // namespace betwixt::studio
