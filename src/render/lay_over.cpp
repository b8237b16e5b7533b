// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "render/bloom.h"
#include "render/composer.h"

namespace betwixt {
namespace {

float blended(LayerBlend how, float below, float above) {
  const float b = std::min(below, 1.0F), a = std::min(above, 1.0F);
  switch (how) {
    case LayerBlend::screen:
      return below + above - b * a;
    case LayerBlend::multiply:
      return below * above;
    case LayerBlend::add:
      return below + above;
    case LayerBlend::overlay:
      return b <= 0.5F ? 2 * below * above : 1 - 2 * (1 - b) * (1 - a);
    case LayerBlend::normal:
      break;
  }
  return above;
}

}  // namespace

void lay_over(LinearPicture& below, const LinearPicture& above, LayerBlend how, double opacity) {
  each_pixel_of(below, [&](std::size_t i) {
    const auto o = static_cast<float>(opacity);
    const float a = o * std::clamp(above.rgba[i + 3], 0.0F, 1.0F), b = std::clamp(below.rgba[i + 3], 0.0F, 1.0F);
    for (std::size_t c = i; c < i + 3; ++c) {
      const float light = o * above.rgba[c];
      float& to = below.rgba[c];
      if (how == LayerBlend::normal)
        to = to * (1 - a) + light;
      else if (how == LayerBlend::add)
        to += light;
      else {
        // Where both are, their straight colours blend; light beyond an opacity, such as a glow, is added.
        const float extra = std::max(light - a, 0.0F), straight = a > 0 ? std::min(light / a, 1e6F) : 0;
        const float behind = b > 0 ? to / b : 0;
        const float both = blended(how, behind, extra > 0 ? std::min(straight, 1.0F) : straight);
        to = to * (1 - a) + (light - extra) * (1 - b) + a * b * both + extra;
      }
    }
    below.rgba[i + 3] = how == LayerBlend::add ? b : b + a - a * b;
  });
}

}  // namespace betwixt
