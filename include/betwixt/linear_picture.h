// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of linear light (high dynamic range), for compositing and further processing.
//
// Room: scene
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "betwixt/mesh.h"

namespace betwixt {

// Linear light without an upper limit, with the primaries of sRGB and premultiplied alpha. Rows from the top, four
// numbers a pixel: r g b a.
struct LinearPicture {
  int width = 0, height = 0;
  std::vector<float> rgba;
};

// How files have their colours: by which primaries and by which curve. pq and hlg have room for light above white.
enum class ColorCoding : std::uint8_t { srgb, p3, rec2020, pq, hlg };
// In the order of ColorCoding.
inline constexpr std::array<std::string_view, 5> color_coding_names{"srgb", "p3", "rec2020", "pq", "hlg"};
// How bright white is in pq and hlg (ITU-R BT.2408), and how bright the brightest light, in nits.
inline constexpr double white_nits = 203, peak_nits = 1000;
constexpr bool has_highlights(ColorCoding c) { return c == ColorCoding::pq || c == ColorCoding::hlg; }

// Converts to sRGB with straight alpha, for screens. Light above white becomes white. A pixel brighter than its
// opacity (a highlight on glass) gets more opacity. A number that is NaN becomes black.
void to_shown(const LinearPicture&, Picture& out);
// The same, with 16 bits a channel.
std::vector<std::uint16_t> to_shown_16(const LinearPicture&);
// The same, with these primaries and this curve. Light above the peak gets its brightness.
std::vector<std::uint16_t> to_coded_16(const LinearPicture&, ColorCoding);
// Converts a shown picture, with four numbers of 16 bits a pixel, back to linear light.
LinearPicture to_light(int width, int height, const std::vector<std::uint16_t>& rgba, ColorCoding = ColorCoding::srgb);
// Converts light to other primaries, for files of light.
void change_primaries(LinearPicture&, ColorCoding to);

}  // namespace betwixt
