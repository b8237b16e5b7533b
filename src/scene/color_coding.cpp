// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Light as the signals of Display P3, of ITU-R BT.2020, and of BT.2100 (PQ and HLG), and back.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "betwixt/linear_picture.h"
#include "track/track.h"

namespace betwixt {
namespace {

using Color3 = std::array<double, 3>;
using Matrix3 = std::array<Color3, 3>;

// From the primaries of sRGB; all have the white D65.
constexpr Matrix3 none{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix3 to_p3{
    {{0.8224619687, 0.1775380313, 0}, {0.0331941989, 0.9668058011, 0}, {0.0170826307, 0.0723974407, 0.9105199286}}};
constexpr Matrix3 to_2020{{{0.6274038959, 0.3292830384, 0.0433130657},
                           {0.0690972894, 0.9195403951, 0.0113623156},
                           {0.0163914389, 0.0880133079, 0.8955952532}}};
constexpr Color3 product_of(const Matrix3& m, const Color3& v) {
  Color3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}
constexpr Matrix3 inverse_of(const Matrix3& m) {
  const auto minor = [&](std::size_t i, std::size_t k) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (k + 1) % 3, d = (k + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double whole = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix3 out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) out[k][i] = minor(i, k) / whole;
  return out;
}
constexpr const Matrix3& from_srgb(ColorCoding c) {
  return c == ColorCoding::srgb ? none : c == ColorCoding::p3 ? to_p3 : to_2020;
}

// SMPTE ST 2084. `share`: of 10,000 nits.
constexpr double m1 = 2610.0 / 16384, m2 = 2523.0 / 32, c1 = 3424.0 / 4096, c2 = 2413.0 / 128, c3 = 2392.0 / 128;
double pq(double share) {
  const double y = std::pow(share, m1);
  return std::pow((c1 + c2 * y) / (1 + c3 * y), m2);
}
double from_pq(double signal) {
  const double y = std::pow(signal, 1 / m2);
  return std::pow(std::max(y - c1, 0.0) / (c2 - c3 * y), 1 / m1);
}

// BT.2100, table 5. `light`: of the scene, 0 to 1. A screen of 1000 nits shows it with a gamma of 1.2.
constexpr double hlg_a = 0.17883277, hlg_b = 0.28466892, hlg_c = 0.55991073, hlg_gamma = 1.2;
double hlg(double light) {
  return light <= 1.0 / 12 ? std::sqrt(3 * light) : hlg_a * std::log(12 * light - hlg_b) + hlg_c;
}
double from_hlg(double signal) {
  return signal <= 0.5 ? signal * signal / 3 : (std::exp((signal - hlg_c) / hlg_a) + hlg_b) / 12;
}
double luminance_2020(const Color3& c) { return 0.2627 * c[0] + 0.6780 * c[1] + 0.0593 * c[2]; }

// A curve at 512 places of each power of two from 2^-24 to 8; linear between them: within 1e-6.
class LightCurve {
 public:
  template <class F>
  explicit LightCurve(const F& f) {
    for (std::size_t i = 0; i < at_.size(); ++i) at_[i] = f(static_cast<double>(place(i)));
    zero_ = f(0.0);
  }
  double operator()(double light) const {
    const float x = static_cast<float>(light);
    if (!(x >= place(0))) return zero_ + std::max(light, 0.0) / static_cast<double>(place(0)) * (at_[0] - zero_);
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(std::min(x, 7.99F)) - first;
    const std::size_t below = bits >> shift;
    const double share = static_cast<double>(bits & ((1U << shift) - 1)) / (1U << shift);
    return at_[below] + share * (at_[below + 1] - at_[below]);
  }

 private:
  static constexpr std::uint32_t shift = 14, first = 103U << 23;  // the bits of 2^-24
  static float place(std::size_t i) { return std::bit_cast<float>(first + (static_cast<std::uint32_t>(i) << shift)); }
  std::array<double, 27 * 512 + 1> at_{};
  double zero_ = 0;
};

constexpr double most_light = peak_nits / white_nits;

// The signals of light, 1 being white; of Rec.2020 with highlights.
Color3 coded(Color3 c, ColorCoding coding) {
  static const LightCurve srgb([](double x) { return to_srgb(std::min(x, 1.0)); });
  static const LightCurve of_pq([](double x) { return pq(x * white_nits / 10000); });
  static const LightCurve of_hlg([](double x) { return hlg(std::min(x, 1.0)); });
  static const LightCurve darker([](double x) { return std::pow(x, 1 / hlg_gamma - 1); });
  for (double& x : c) x = std::clamp(x, 0.0, has_highlights(coding) ? most_light : 1.0);
  if (coding == ColorCoding::pq) return {of_pq(c[0]), of_pq(c[1]), of_pq(c[2])};
  if (coding != ColorCoding::hlg) return {srgb(c[0]), srgb(c[1]), srgb(c[2])};
  for (double& x : c) x /= most_light;
  const double y = luminance_2020(c), by = y > 0x1p-24 ? darker(y) : 0;
  return {of_hlg(by * c[0]), of_hlg(by * c[1]), of_hlg(by * c[2])};
}

Color3 decoded_light(const Color3& signals, ColorCoding coding) {
  Color3 c{};
  if (!has_highlights(coding)) {
    for (std::size_t i = 0; i < 3; ++i) c[i] = to_linear(signals[i]);
    return c;
  }
  for (std::size_t i = 0; i < 3; ++i)
    c[i] = coding == ColorCoding::pq ? from_pq(signals[i]) * 10000 / white_nits : from_hlg(signals[i]);
  if (coding == ColorCoding::pq) return c;
  const double y = luminance_2020(c), by = y > 0 ? most_light * std::pow(y, hlg_gamma - 1) : 0;
  for (double& x : c) x *= by;
  return c;
}

}  // namespace

std::vector<std::uint16_t> to_coded_16(const LinearPicture& picture, ColorCoding coding) {
  if (coding == ColorCoding::srgb) return to_shown_16(picture);
  const Matrix3& m = from_srgb(coding);
  const double room = has_highlights(coding) ? most_light : 1;
  std::vector<std::uint16_t> out(picture.rgba.size());
  const auto steps = [](double share) { return static_cast<std::uint16_t>(65535 * share + 0.5); };
  for (std::size_t i = 0; i + 4 <= picture.rgba.size(); i += 4) {
    Color3 light{};
    for (std::size_t c = 0; c < 3; ++c) {
      const auto is = static_cast<double>(picture.rgba[i + c]);
      light[c] = is > 0 ? std::min(is, 1e6) : 0;  // NaN becomes 0
    }
    const double alpha = static_cast<double>(picture.rgba[i + 3]), bright = std::max({light[0], light[1], light[2]});
    const double opacity = std::min(std::max(alpha > 0 ? alpha : 0, bright / room), 1.0);
    if (opacity > 0)
      for (double& c : light) c /= opacity;
    const Color3 signals = coded(product_of(m, light), coding);
    for (std::size_t c = 0; c < 3; ++c) out[i + c] = steps(std::min(signals[c], 1.0));
    out[i + 3] = steps(opacity);
  }
  return out;
}

LinearPicture to_light(int width, int height, const std::vector<std::uint16_t>& rgba, ColorCoding coding) {
  const Matrix3 m = inverse_of(from_srgb(coding));
  LinearPicture out{width, height, std::vector<float>(rgba.size())};
  for (std::size_t i = 0; i + 4 <= rgba.size(); i += 4) {
    const double opacity = rgba[i + 3] / 65535.0;
    Color3 light = decoded_light({rgba[i] / 65535.0, rgba[i + 1] / 65535.0, rgba[i + 2] / 65535.0}, coding);
    if (coding != ColorCoding::srgb) light = product_of(m, light);
    for (std::size_t c = 0; c < 3; ++c) out.rgba[i + c] = static_cast<float>(opacity * light[c]);
    out.rgba[i + 3] = static_cast<float>(opacity);
  }
  return out;
}

void change_primaries(LinearPicture& picture, ColorCoding to) {
  if (to == ColorCoding::srgb) return;
  const Matrix3& m = from_srgb(to);
  for (std::size_t i = 0; i + 4 <= picture.rgba.size(); i += 4) {
    float* const p = &picture.rgba[i];
    const Color3 c = product_of(m, {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<float>(c[k]);
  }
}

}  // namespace betwixt
