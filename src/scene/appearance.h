// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How a film looks beside its things, as a script says it; colours as written.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "betwixt/value.h"

namespace betwixt {

struct Appearance {
  struct Fog {
    Color color;
    double from = 0, to = 0;  // metres from the eye
    friend bool operator==(const Fog&, const Fog&) = default;
  };

  std::optional<std::pair<int, int>> size;  // pixels
  std::optional<int> samples;               // a pixel
  std::optional<int> subframes;             // that a picture is added up of, at most
  bool flat = false;                        // a drawing: its own view, and no light
  bool clear = false;                       // there is no background
  std::optional<Color> below;               // what the background goes over to at the bottom
  std::optional<Color> ambient;
  double exposure = 0;  // stops
  std::optional<Fog> fog;
  bool ground = false;
  std::optional<Color> ground_color;  // none: its usual one
  bool sky = false;
  bool contact = false;
  friend bool operator==(const Appearance&, const Appearance&) = default;
};

// 1920x1080; none where this is no size that can be drawn.
std::optional<std::pair<int, int>> parse_size(std::string_view);
bool samples_fit(long samples);
bool subframes_fit(long subframes);

}  // namespace betwixt
