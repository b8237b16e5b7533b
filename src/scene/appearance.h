// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The look of a film besides its objects, as in the script. Colours are sRGB.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "betwixt/setting.h"
#include "betwixt/value.h"
#include "scene/theme.h"

namespace betwixt {

// A look file or a configuration of colours, as in the script; "": not said.
struct ViewFile {
  std::string file, display, through, look, space;
  friend bool operator==(const ViewFile&, const ViewFile&) = default;
};

struct Appearance {
  struct Fog {
    Color color;
    double from = 0, to = 0;  // metres from the eye
    friend bool operator==(const Fog&, const Fog&) = default;
  };

  std::optional<std::pair<int, int>> size;  // pixels
  std::optional<int> samples;               // a pixel
  std::string_view pixel_filter;            // a name of the table; "": the default
  std::optional<int> subframes;             // the most pictures that one is averaged from
  bool flat = false;                        // a drawing: its own view, unlit
  bool clear = false;                       // a transparent background
  std::optional<Color> below;               // the colour at the bottom of the background
  std::optional<Color> ambient;
  double exposure = 0;  // stops
  std::optional<Fog> fog;
  bool ground = false;
  std::optional<Color> ground_color;  // nullopt: the default
  bool sky = false;
  Sky environment;
  std::string sky_file;  // of a picture, as in the script
  Grade grade;
  ViewFile view_file;  // of the grade's table
  bool contact = false;
  Shared<Theme> theme;
  friend bool operator==(const Appearance&, const Appearance&) = default;
};

// Reads 1920x1080; returns nullopt if it is no size that can be drawn.
std::optional<std::pair<int, int>> parse_size(std::string_view);
bool samples_fit(long samples);
bool subframes_fit(long subframes);

}  // namespace betwixt
