// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/traced_pixel.h"

namespace betwixt::traced {

PixelSums& PixelSums::operator+=(const PixelSums& o) {
  for (const auto sum : {&PixelSums::lit, &PixelSums::plain, &PixelSums::albedo, &PixelSums::lit_square,
                         &PixelSums::lit_sample, &PixelSums::normal, &PixelSums::place})
    this->*sum = this->*sum + o.*sum;
  for (const auto sum :
       {&PixelSums::clear, &PixelSums::weight, &PixelSums::seen, &PixelSums::seen_square, &PixelSums::far,
        &PixelSums::far_square, &PixelSums::whole, &PixelSums::whole_square, &PixelSums::samples})
    this->*sum += o.*sum;
  return *this;
}

namespace {

void add_surfaces(const CameraSample& seen, double sign, PixelSums& sums) {
  const Vec3 light = seen.lit + seen.plain;
  const double whole = sign * (0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z);
  sums.whole += whole, sums.whole_square += whole * whole;
  sums.lit_sample = sums.lit_sample + seen.lit, sums.lit_square = sums.lit_square + seen.lit * seen.lit;
  sums.albedo = sums.albedo + sign * seen.albedo;
  sums.normal = sums.normal + seen.normal, sums.place = sums.place + seen.place;
  if (!(seen.seen > 0)) return;
  const double away = std::sqrt(dot(seen.place, seen.place)) / seen.seen;
  sums.seen += seen.seen, sums.seen_square += seen.seen * seen.seen;
  sums.far += seen.seen * away, sums.far_square += seen.seen * away * away;
}

// Some light in each cell of a pixel. The highlights of each cell roll off separately, so bright edges are smooth and
// the noise of single samples has little effect.
class PixelCells {
 public:
  explicit PixelCells(std::uint32_t samples) : side_(samples >= 64 ? 4 : samples >= 4 ? 2 : 1) {}
  void add(double right, double down, double sign, const CameraSample& seen) {
    const auto i = static_cast<std::size_t>(static_cast<int>(side_ * down) * side_ + static_cast<int>(side_ * right));
    lit_[i] = lit_[i] + seen.lit, shares_[i] += seen.share, signs_[i] += sign, counts_[i] += 1;
  }
  // Returns the light as it is, or rolled off.
  Vec3 sum(bool rolled) const {
    Vec3 all;
    for (std::size_t i = 0; i < lit_.size(); ++i) {
      if (!(shares_[i] > 0)) continue;
      const Vec3 light = rolled ? shares_[i] * tone_mapped(1 / shares_[i] * lit_[i]) : lit_[i];
      all = all + signs_[i] / counts_[i] * light;
    }
    return all;
  }

 private:
  int side_;
  std::array<Vec3, 16> lit_;
  std::array<double, 16> shares_{}, signs_{}, counts_{};  // signs_: the sum of the signs of the samples' weights
};

// Returns which ray of a pixel is taken: its place, its time, and its point of the lens.
std::array<double, 5> ray_numbers(PixelSampler sampler, bool blurs) {
  if (blurs) return sampler.next_5d();
  const auto [x, y] = sampler.next_2d();
  return {x, y, 0, 0, 0};
}

}  // namespace

void sample_pixel(const ExposedTracer& tracer, const FilterSampler& filter, const PixelPlace& place,
                  std::span<const SampleBlock> blocks, bool unclamped, std::array<PixelSums, 2>& halves) {
  PixelCells cells(blocks.size() == 1 ? blocks[0].count : blocks[0].count + blocks[1].count);
  std::array<PixelSums, 2> added;
  for (std::size_t half = 0; half < blocks.size(); ++half) {
    const SampleBlock& block = blocks[half];
    PixelSums& sums = added[half];
    sums.samples = block.count;
    for (std::uint32_t s = 0; s < block.count; ++s) {
      PixelSampler sampler(place.number, block.first + s, block.all, block.block);
      sampler.next_2d();
      const auto [right, down, time, lens_x, lens_y] =
          ray_numbers(PixelSampler(place.number, block.first + s, block.all).of_segment(block.segment), tracer.blurs());
      const auto [in_x, sign_x] = filter.at(right);
      const auto [in_y, sign_y] = filter.at(down);
      const double sign = sign_x * sign_y;
      const CameraSample seen = tracer.sample(
          {(place.x + in_x) / place.width, (place.y + in_y) / place.height, time, lens_x, lens_y}, sampler);
      cells.add(right, down, sign, seen);
      sums.lit = sums.lit + sign * seen.lit, sums.plain = sums.plain + sign * seen.plain;
      sums.clear += sign * seen.clear, sums.weight += sign;
      add_surfaces(seen, sign, sums);
    }
  }
  if (blocks.size() == 1) {
    added[0].lit = cells.sum(!unclamped);
  } else if (!unclamped) {
    const Vec3 whole = cells.sum(false), rolled = cells.sum(true);
    for (int i = 0; i < 3; ++i)
      for (PixelSums& sums : added) sums.lit[i] *= whole[i] > 0 ? std::clamp(rolled[i] / whole[i], 0.0, 2.0) : 1;
  }
  for (std::size_t half = 0; half < blocks.size(); ++half) halves[half] += added[half];
}

}  // namespace betwixt::traced
