// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How surfaces with finishes scatter light.
#include "render/physical_tracer.h"
#include "render/traced_sampling.h"
#include "scene/materials.h"

namespace betwixt::traced {
namespace {

double fifth(double x) { return x * x * x * x * x; }

// The shares of light from all around that a rough surface reflects, by the cosine of the angle of sight and the
// roughness: for a reflectance of 0 at all angles but grazing ones, and what a reflectance adds. Worked out once.
class ReflectedShares {
 public:
  ReflectedShares() {
    for (std::size_t j = 0; j < side; ++j)
      for (std::size_t i = 0; i < side; ++i)
        at_[j * side + i] =
            worked_out(std::max(static_cast<double>(i), 0.05) / (side - 1), static_cast<double>(j) / (side - 1));
    for (std::size_t j = 0; j < side; ++j) {
      double sum = 0, weight = 0;
      for (std::size_t i = 0; i < side; ++i) {
        const double nv = static_cast<double>(i) * (i + 1 < side ? 1 : 0.5);
        sum += nv * (at_[j * side + i][0] + at_[j * side + i][1]), weight += nv;
      }
      mean_[j] = sum / weight;
    }
  }
  // The mean of their sum over all angles of incidence.
  double mean(double roughness) const {
    const double y = std::clamp(roughness, 0.0, 1.0) * (side - 1);
    const auto j = static_cast<std::size_t>(y), j1 = std::min(j + 1, side - 1);
    const double b = y - static_cast<double>(j);
    return (1 - b) * mean_[j] + b * mean_[j1];
  }
  std::array<double, 2> at(double nv, double roughness) const {
    const double x = std::clamp(nv, 0.0, 1.0) * (side - 1), y = std::clamp(roughness, 0.0, 1.0) * (side - 1);
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
    const std::size_t i1 = std::min(i + 1, side - 1), j1 = std::min(j + 1, side - 1);
    const double a = x - static_cast<double>(i), b = y - static_cast<double>(j);
    std::array<double, 2> r{};
    for (std::size_t k = 0; k < 2; ++k)
      r[k] = (1 - b) * ((1 - a) * at_[j * side + i][k] + a * at_[j * side + i1][k]) +
             b * ((1 - a) * at_[j1 * side + i][k] + a * at_[j1 * side + i1][k]);
    return r;
  }

 private:
  static constexpr std::size_t side = 32;
  static std::array<double, 2> worked_out(double nv, double roughness) {
    constexpr int count = 256;
    const double a = std::max(roughness * roughness, 0.002), a2 = a * a;
    const Vec3 v{std::sqrt(1 - nv * nv), 0, nv};
    std::array<double, 2> sum{};
    for (int i = 0; i < count; ++i) {
      double reversed = 0, step = 0.5;
      for (int bits = i; bits > 0; bits /= 2, step /= 2) reversed += step * (bits % 2);
      const double u = (i + 0.5) / count, c = std::sqrt((1 - u) / (1 + (a2 - 1) * u));
      const Vec3 h = cylindrical(std::sqrt(std::max(1 - c * c, 0.0)), reversed, c);
      const double vh = dot(v, h), nl = 2 * vh * h.z - v.z;
      if (!(nl > 0) || !(vh > 0)) continue;
      const double seen = 2 * nl / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
      const double share = seen * nv * vh / (h.z * nv), rim = fifth(1 - vh);
      sum[0] += (1 - rim) * share, sum[1] += rim * share;
    }
    return {sum[0] / count, sum[1] / count};
  }
  std::array<std::array<double, 2>, side * side> at_{};
  std::array<double, side> mean_{};
};
const ReflectedShares& reflected_shares() {
  static const ReflectedShares shares;
  return shares;
}

// Charlie's sheen over the cosine of the angle of incidence, times pi. Its power is one of a few squares, since powers
// have other bits on other processors.
double charlie(double nh, double nl, double nv, double alpha) {
  const double sine2 = std::max(1 - nh * nh, 0.0078), inv = 1 / alpha;
  double power = 1, base = std::sqrt(sine2), left = std::min(inv, 64.0);
  for (; left >= 1; left -= 1) power *= base;
  power *= 1 - left + left * base;
  return (2 + inv) * power * 0.5 / (4 * (nl + nv - nl * nv));
}

// The share of light from all around that a sheen reflects, by the cosine of the angle of sight and its roughness.
class SheenShares {
 public:
  SheenShares() {
    for (std::size_t j = 0; j < side; ++j)
      for (std::size_t i = 0; i < side; ++i)
        at_[j * side + i] =
            worked_out(std::max(static_cast<double>(i), 0.25) / (side - 1), static_cast<double>(j) / (side - 1));
  }
  double at(double nv, double roughness) const {
    const double x = std::clamp(nv, 0.0, 1.0) * (side - 1), y = std::clamp(roughness, 0.0, 1.0) * (side - 1);
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
    const std::size_t i1 = std::min(i + 1, side - 1), j1 = std::min(j + 1, side - 1);
    const double a = x - static_cast<double>(i), b = y - static_cast<double>(j);
    return (1 - b) * ((1 - a) * at_[j * side + i] + a * at_[j * side + i1]) +
           b * ((1 - a) * at_[j1 * side + i] + a * at_[j1 * side + i1]);
  }

 private:
  static constexpr std::size_t side = 16;
  static double worked_out(double nv, double roughness) {
    constexpr int count = 24;
    const double alpha = std::max(roughness * roughness, 0.01);
    const Vec3 v{std::sqrt(1 - nv * nv), 0, nv};
    double sum = 0;
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < count; ++k) {
        const double nl = (i + 0.5) / count;
        const Vec3 l = cylindrical(std::sqrt(1 - nl * nl), (k + 0.5) / (2 * count), nl);
        sum += 2 * nl * charlie(std::clamp(unit(l + v).z, 0.0, 1.0), nl, nv, alpha);
      }
    return sum / (count * count);
  }
  std::array<double, side * side> at_{};
};
double sheen_share(double nv, double roughness) {
  static const SheenShares shares;
  return shares.at(nv, roughness);
}

// The distribution of microfacets times pi, and the light that they do not hide from each other over four cosines.
double facets(double nh, double a) {
  const double k = nh * nh * (a * a - 1) + 1;
  return a * a / std::max(k * k, 1e-30);
}
double unhidden(double nl, double nv, double a) {
  const double a2 = a * a;
  return 0.5 / std::max(nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2), 1e-30);
}
// The density of a reflection by one of the facets that are visible.
double density_of(double nh, double nv, double a) {
  const double shown = 2 * nv / (nv + std::sqrt(nv * nv * (1 - a * a) + a * a));
  return shown * facets(nh, a) / (4 * pi * std::max(nv, 1e-9));
}

}  // namespace

Scattering::Scattering(const SurfacePoint& p, Vec3 toward, double least_roughness) : n_(p.normal), toward_(toward) {
  const Finish plain = finish_of(p.material, p.shine);
  const Finish& f = p.finish != nullptr ? *p.finish : plain;
  const double metal = p.finish != nullptr ? p.metalness : plain.metalness;
  const double roughness =
      std::clamp(std::max(p.finish != nullptr ? p.roughness : plain.roughness, least_roughness), 0.03, 1.0);
  nv_ = std::clamp(dot(n_, toward), 1e-4, 1.0), alpha_ = roughness * roughness;
  const double edge = (f.ior - 1) / (f.ior + 1), dull = (f.transmission > 0 ? edge * edge : 0.04) * f.specular;
  f0_ = (1 - metal) * Vec3{dull, dull, dull} + metal * p.color;
  f90_ = (1 - metal) * std::min(f.specular, 1.0) + metal;
  const auto shares = reflected_shares().at(nv_, roughness);
  const double single = shares[0] + shares[1], mean = reflected_shares().mean(roughness);
  Vec3 again;
  for (int i = 0; i < 3; ++i) {
    once_[i] = f0_[i] * shares[0] + f90_ * shares[1];
    // Light that the facets reflect several times: each time it takes their colour (Kulla and Conty 2017).
    const double facet = f0_[i] + (f90_ - f0_[i]) / 21;
    again[i] = std::max(1 - single, 0.0) * facet * facet * mean / (1 - facet * (1 - mean));
    repeated_[i] = 1 + again[i] / std::max(once_[i], 1e-6);
  }
  transmission_ = f.transmission * (1 - metal), ior_ = f.ior, thin_ = !(f.thickness > 0) || !p.solid,
  leaves_ = p.inside && !thin_;
  const Vec3 left{1 - once_.x - again.x, 1 - once_.y - again.y, 1 - once_.z - again.z};
  diffuse_ = (1 - metal) * (1 - transmission_) * p.opacity * (left * p.color);
  // Light goes through both sides of a body, and through a thin wall once.
  const Vec3 c{std::max(p.color.x, 0.0), std::max(p.color.y, 0.0), std::max(p.color.z, 0.0)};
  tint_ = left * (thin_ ? c : Vec3{std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z)});
  coat_ = f.clearcoat, coat_alpha_ = std::max(f.clearcoat_roughness, std::max(least_roughness, 0.03));
  coat_alpha_ *= coat_alpha_;
  coat_left_ = 1 - coat_ * (0.04 + 0.96 * fifth(1 - nv_));
  sheen_ = f.sheen, sheen_alpha_ = std::max(f.sheen_roughness * f.sheen_roughness, 0.01);
  // At the rim a smooth sheen would reflect more light than there is.
  const double sheen = largest(sheen_) > 0 ? sheen_share(nv_, f.sheen_roughness) : 0;
  sheen_ = 1 / std::max(sheen, 1.0) * sheen_;
  const double most_sheen = largest(sheen_) * sheen;
  coat_left_ *= 1 - most_sheen;
  const double mirror = std::min(largest(once_) + largest(again), 1.0), diffuse = largest(diffuse_) + most_sheen;
  const double through = transmission_ * (1 - mirror), coat = coat_ > 0 ? std::max(1 - coat_left_, 0.05) : 0;
  const double sum = std::max(mirror + diffuse + through + coat, 1e-9);
  to_mirror_ = mirror / sum, to_diffuse_ = diffuse / sum, to_through_ = through / sum, to_coat_ = coat / sum;
}

Vec3 Scattering::albedo() const {
  Vec3 all = diffuse_ + once_ * repeated_ + transmission_ * tint_;
  for (int i = 0; i < 3; ++i) all[i] = std::clamp(all[i], 0.0, 1.0);
  return all;
}

Vec3 Scattering::value(Vec3 l) const {
  const double nl = dot(n_, l);
  if (!(nl > 0)) return {};
  const Vec3 h = unit(l + toward_);
  const double nh = std::clamp(dot(n_, h), 0.0, 1.0), vh = std::clamp(dot(toward_, h), 0.0, 1.0), rim = fifth(1 - vh);
  const double shine = facets(nh, alpha_) * unhidden(nl, nv_, alpha_);
  Vec3 sum = diffuse_;
  for (int i = 0; i < 3; ++i) sum[i] += shine * (f0_[i] + std::max(f90_ - f0_[i], 0.0) * rim) * repeated_[i];
  sum = coat_left_ * sum;
  if (coat_ > 0) {
    const double c = coat_ * facets(nh, coat_alpha_) * unhidden(nl, nv_, coat_alpha_) * (0.04 + 0.96 * rim);
    sum = sum + Vec3{c, c, c};
  }
  if (largest(sheen_) > 0) {
    sum = sum + charlie(nh, nl, nv_, sheen_alpha_) * sheen_;
  }
  return nl * sum;
}

double Scattering::density(Vec3 l) const {
  const double nl = dot(n_, l);
  if (!(nl > 0)) return 0;
  const double nh = std::clamp(dot(n_, unit(l + toward_)), 0.0, 1.0);
  return to_diffuse_ * nl / pi + to_mirror_ * density_of(nh, nv_, alpha_) +
         (to_coat_ > 0 ? to_coat_ * density_of(nh, nv_, coat_alpha_) : 0);
}

Scattering::Sample Scattering::sample_through(PixelSampler& sampler) const {
  const Vec3 h = sample_visible_facet(n_, toward_, alpha_, sampler.next_2d());
  Sample s{-toward_, 1 / to_through_ * (transmission_ * tint_), 0, true};
  if (thin_) return s;
  const double eta = leaves_ ? ior_ : 1 / ior_, c = dot(toward_, h), k = 1 - eta * eta * (1 - c * c);
  if (k < 0) {  // all of it is reflected inside
    s.along = mirrored_at(h, toward_), s.through = false;
    return s;
  }
  s.along = unit((eta * c - std::sqrt(k)) * h - eta * toward_);
  return s;
}

Scattering::Sample Scattering::sample(PixelSampler& sampler) const {
  const double choice = sampler.next_1d();
  if (choice < to_through_) return sample_through(sampler);
  const auto random = sampler.next_2d();
  const double rest = choice - to_through_;
  Sample s;
  if (rest < to_diffuse_)
    s.along = sample_cosine_hemisphere(n_, random);
  else {
    const Vec3 h = sample_visible_facet(n_, toward_, rest < to_diffuse_ + to_mirror_ ? alpha_ : coat_alpha_, random);
    s.along = mirrored_at(h, toward_);
  }
  s.density = density(s.along);
  if (s.density > 0) s.weight = 1 / (pi * s.density) * value(s.along);
  return s;
}

}  // namespace betwixt::traced
