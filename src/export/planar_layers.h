// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Groups that are drawn as a whole, over the time of a film.
#pragma once

#include <map>

#include "betwixt/export.h"
#include "betwixt/keys.h"
#include "betwixt/layer.h"

namespace betwixt {

struct PlanarLayer {
  ObjectId object;
  std::int32_t within = -1;               // the layer that it is a part of; -1: the picture
  bool is_mask = false;                   // seen only where another has it as its mask
  std::vector<std::int32_t> masks;        // of the first time that it has some
  LayerBlend blend = LayerBlend::normal;  // the first that is not normal
  Channel opacity;
  Channel blur;           // metres
  Channel glow;           // how much, and metres
  Channel shadow, shade;  // to the right, up and how soft, metres; sRGB and opacity
};

struct PlanarLayers {
  std::vector<PlanarLayer> all;
  std::map<std::uint32_t, std::int32_t> of;  // the innermost layer of an object
  bool changes = false;                      // a blend or a mask changes, which no drawing has
};

PlanarLayers planar_layers(const Program&, const ExportOptions&);

}  // namespace betwixt
