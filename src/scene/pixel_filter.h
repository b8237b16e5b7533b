// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pixel filters (reconstruction filters): how the samples around the centre of a pixel are averaged to the pixel.
#pragma once

#include <span>
#include <string_view>

namespace betwixt {

struct PixelFilter {
  std::string_view name, what;  // `what`: a description, as in "the mean of the pixel's own samples"
  double radius;                // in pixels; samples beyond it have no weight
  double (*weight)(double x);   // along one axis, x pixels from the centre; the weights of both axes are multiplied
};

std::span<const PixelFilter> pixel_filters();  // the first is the default
// Returns the filter of this name, or null.
const PixelFilter* find_pixel_filter(std::string_view name);

}  // namespace betwixt
