// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/planar_layers.h"

#include <algorithm>

#include "betwixt/evaluation.h"
#include "export/fit.h"
#include "export/seen.h"
#include "program/compiled.h"
#include "track/track.h"

namespace betwixt {
namespace {

// What a group is at a sample; without effects, if it is none.
struct LayerSamples {
  std::vector<KeyValue> opacity, blur, glow, shadow, shade;

  void add(const Layer& l) {
    const Color c = to_srgb(l.shadow_color);
    opacity.push_back({l.opacity}), blur.push_back({l.blur}), glow.push_back({l.glow, l.glow_size});
    shadow.push_back({l.shadow.x, l.shadow.y, l.shadow.z});
    shade.push_back({c.r, c.g, c.b, l.shadow == Vec3{} ? 0 : l.shadow_opacity});
  }
};

// Linear from sample to sample, except before a jump.
Channel joined(const std::vector<KeyValue>& values, const std::vector<Time>& times, const std::vector<Time>& breaks,
               std::size_t width) {
  Channel out{width, false, {}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool last = i + 1 == values.size();
    const bool jumps = !last && std::binary_search(breaks.begin(), breaks.end(), times[i + 1]);
    const KeyValue end = last || jumps ? values[i] : values[i + 1];
    const auto shape = end == values[i] ? KeyPiece::held : KeyPiece::straight;
    const Time until = last ? times[i] : times[i + 1];
    if (!out.pieces.empty() && shape == KeyPiece::held && out.pieces.back().shape == KeyPiece::held &&
        out.pieces.back().begin == values[i])
      out.pieces.back().until = until;
    else if (!last || out.pieces.empty())
      out.pieces.push_back({shape, times[i], until, values[i], end, {}, {}});
  }
  return out;
}

}  // namespace

PlanarLayers planar_layers(const Program& program, const ExportOptions& options) {
  PlanarLayers out;
  if (program.compiled().layers.empty()) return out;
  const std::vector<Time> times = looks_of(program, options.from, options.until);
  const std::vector<Time> breaks = program.discontinuities(options.from, options.until);
  std::vector<LayerSamples> samples;
  std::map<std::uint32_t, std::int32_t> number;  // by the object of the layer
  Evaluation e(program);
  for (std::size_t i = 0; i < times.size(); ++i) {
    e.to(times[i]);
    const Frame frame = e.composed() ? e.frame() : Frame{};
    const auto of = [&](std::int32_t layer) {
      return layer < 0 ? layer : number.at(frame.layers[static_cast<std::size_t>(layer)].object.index);
    };
    for (const Layer& l : frame.layers) {
      const auto [at, fresh] = number.try_emplace(l.object.index, static_cast<std::int32_t>(out.all.size()));
      if (!fresh) continue;
      out.all.emplace_back().object = l.object;
      LayerSamples& mine = samples.emplace_back();
      for (std::size_t k = 0; k < i; ++k) mine.add(Layer{});
      out.changes = out.changes || (i > 0 && (l.blend != LayerBlend::normal || !l.masks.empty() || l.is_mask));
    }
    for (const Layer& l : frame.layers) {
      PlanarLayer& to = out.all[static_cast<std::size_t>(number[l.object.index])];
      std::vector<std::int32_t> masks;
      for (const std::int32_t m : l.masks) masks.push_back(of(m));
      const bool first = samples[static_cast<std::size_t>(number[l.object.index])].opacity.empty() || i == 0;
      out.changes = out.changes || (!first && (to.blend != l.blend || to.masks != masks || to.is_mask != l.is_mask));
      if (to.blend == LayerBlend::normal) to.blend = l.blend;
      if (to.masks.empty()) to.masks = masks;
      to.is_mask = to.is_mask || l.is_mask;
      if (to.within < 0) to.within = of(l.within);
      samples[static_cast<std::size_t>(number[l.object.index])].add(l);
    }
    for (LayerSamples& s : samples)
      if (s.opacity.size() <= i) s.add(Layer{});
    for (const Item& item : frame.items)
      if (item.layer >= 0) out.of.try_emplace(item.id.index, of(item.layer));
  }
  for (std::size_t k = 0; k < out.all.size(); ++k) {
    PlanarLayer& l = out.all[k];
    l.opacity = joined(samples[k].opacity, times, breaks, 1), l.blur = joined(samples[k].blur, times, breaks, 1);
    l.glow = joined(samples[k].glow, times, breaks, 2), l.shadow = joined(samples[k].shadow, times, breaks, 3);
    l.shade = joined(samples[k].shade, times, breaks, 4);
  }
  return out;
}

}  // namespace betwixt
