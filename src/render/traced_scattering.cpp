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
// The share of facets that are not hidden from a direction.
double shown(double nv, double a) { return 2 * nv / (nv + std::sqrt(nv * nv * (1 - a * a) + a * a)); }
// The density of a reflection by one of the facets that are visible.
double density_of(double nh, double nv, double a) {
  return shown(nv, a) * facets(nh, a) / (4 * pi * std::max(nv, 1e-9));
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
  bent_ = dot(p.smooth, p.smooth) > 0, smooth_ = p.smooth;
  transmission_ = f.transmission * (1 - metal), ior_ = std::max(f.ior, 1.0), thin_ = !(f.thickness > 0) || !p.solid,
  leaves_ = p.inside && !thin_;
  smooth_pane_ = (p.finish != nullptr ? p.roughness : plain.roughness) <= 0.03;
  if (transmission_ > 0) repeated_ = {1, 1, 1};  // what its facets hide from each other goes on: see sample()
  left_ = {1 - once_.x - again.x, 1 - once_.y - again.y, 1 - once_.z - again.z};
  diffuse_ = (1 - metal) * (1 - transmission_) * p.opacity * (left_ * p.color);
  // Light goes through both sides of a body, and through a thin wall once.
  const Vec3 c{std::max(p.color.x, 0.0), std::max(p.color.y, 0.0), std::max(p.color.z, 0.0)};
  tint_ = thin_ ? c : Vec3{std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z)};
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
  to_facets_ = (mirror + through) / sum, to_diffuse_ = diffuse / sum, to_coat_ = coat / sum;
}

// The reflectance of a facet at grazing angles has the fifth power of this. Light that leaves a body is reflected as
// much as light that comes in along the same path, or all of it.
double Scattering::slant(double vh) const {
  if (!leaves_) return 1 - vh;
  const double square = 1 - ior_ * ior_ * (1 - vh * vh);
  return square > 0 ? 1 - std::sqrt(square) : 1;
}

Vec3 Scattering::reflectance(double vh) const {
  const double rim = fifth(slant(vh));
  Vec3 share;
  for (int i = 0; i < 3; ++i) share[i] = f0_[i] + std::max(f90_ - f0_[i], 0.0) * rim;
  return share;
}

// How often a facet reflects a path, rather than letting it through.
double Scattering::reflects(double vh) const {
  if (!(transmission_ > 0)) return 1;
  const double back = largest(reflectance(vh)), through = transmission_ * std::max(1 - back, 0.0);
  return back + through > 0 ? back / (back + through) : 1;
}

Vec3 Scattering::albedo() const {
  Vec3 all = diffuse_ + once_ * repeated_ + transmission_ * (left_ * tint_);
  for (int i = 0; i < 3; ++i) all[i] = std::clamp(all[i], 0.0, 1.0);
  return all;
}

// What a bent normal sends behind the surface meets the next bump, which sends it back with the surface's colour.
Vec3 Scattering::value(Vec3 l) const {
  if (!bent_) return value_of_lobes(l);
  const double up = dot(smooth_, l);
  return up > 0 ? value_of_lobes(l) + albedo() * value_of_lobes(l - 2 * up * smooth_) : Vec3{};
}

double Scattering::density(Vec3 l) const {
  if (!bent_) return density_of_lobes(l);
  const double up = dot(smooth_, l);
  return up > 0 ? density_of_lobes(l) + density_of_lobes(l - 2 * up * smooth_) : 0;
}

Vec3 Scattering::value_of_lobes(Vec3 l) const {
  const double nl = dot(n_, l);
  if (!(nl > 0)) return {};
  const Vec3 h = unit(l + toward_);
  const double nh = std::clamp(dot(n_, h), 0.0, 1.0), vh = std::clamp(dot(toward_, h), 0.0, 1.0);
  const double shine = facets(nh, alpha_) * unhidden(nl, nv_, alpha_);
  Vec3 sum = coat_left_ * (diffuse_ + shine * (reflectance(vh) * repeated_));
  if (coat_ > 0) {
    const double rim = fifth(1 - vh);
    const double c = coat_ * facets(nh, coat_alpha_) * unhidden(nl, nv_, coat_alpha_) * (0.04 + 0.96 * rim);
    sum = sum + Vec3{c, c, c};
  }
  if (largest(sheen_) > 0) {
    sum = sum + charlie(nh, nl, nv_, sheen_alpha_) * sheen_;
  }
  return nl * sum;
}

double Scattering::density_of_lobes(Vec3 l) const {
  const double nl = dot(n_, l);
  if (!(nl > 0)) return 0;
  const Vec3 h = unit(l + toward_);
  const double nh = std::clamp(dot(n_, h), 0.0, 1.0), vh = std::clamp(dot(toward_, h), 0.0, 1.0);
  return to_diffuse_ * nl / pi + to_facets_ * reflects(vh) * unhindered(nl) * density_of(nh, nv_, alpha_) +
         (to_coat_ > 0 ? to_coat_ * density_of(nh, nv_, coat_alpha_) : 0);
}

Vec3 Scattering::passing(double vh) const {
  const Vec3 back = reflectance(vh);
  Vec3 left;
  for (int i = 0; i < 3; ++i) left[i] = std::max(1 - back[i], 0.0);
  return transmission_ * coat_left_ * (left * tint_);
}

// Through a facet: bent, or in a thin wall as if mirrored and turned to the other side. What facets hide from each
// other goes on in the same direction.
Scattering::Sample Scattering::through(Vec3 h, double chance) const {
  const double c = std::clamp(dot(toward_, h), 0.0, 1.0);
  Sample s{{}, 1 / chance * passing(c), 0, true, straightens()};
  if (s.straight) {
    s.along = -toward_;
    return s;
  }
  if (thin_) {
    const Vec3 mirrored = mirrored_at(h, toward_);
    s.along = unit(mirrored - 2 * std::abs(dot(mirrored, n_)) * n_);
    return s;
  }
  const double eta = leaves_ ? ior_ : 1 / ior_, k = std::max(1 - eta * eta * (1 - c * c), 0.0);
  s.along = unit((eta * c - std::sqrt(k)) * h - eta * toward_);
  s.along = s.along - 2 * std::max(dot(s.along, n_), 0.0) * n_;
  return s;
}

// How much of what a facet of glass reflects in a direction is not stopped by another one.
double Scattering::unhindered(double nl) const {
  if (!(transmission_ > 0)) return 1;
  return nl > 0 ? std::min(4 * nl * nv_ * unhidden(nl, nv_, alpha_) / shown(nv_, alpha_), 1.0) : 0;
}

// What another facet stops: that one lies flat, and lets the light through if it can.
Scattering::Sample Scattering::hindered(Vec3 h, double chance) const {
  Vec3 down = mirrored_at(h, toward_);
  down = down - 2 * std::max(dot(down, n_), 0.0) * n_;
  const double c = -dot(down, n_), eta = leaves_ ? ior_ : 1 / ior_, k = 1 - eta * eta * (1 - c * c);
  Sample s{down, coat_left_ / chance * reflectance(std::clamp(dot(toward_, h), 0.0, 1.0)), 0, true};
  if (!thin_ && k <= 0) {
    s.along = down + 2 * c * n_, s.through = false;
    return s;
  }
  s.weight = transmission_ * (s.weight * tint_);
  if (!thin_) s.along = unit(eta * down + (eta * c - std::sqrt(k)) * n_);
  return s;
}

Scattering::Sample Scattering::sample(PixelSampler& sampler) const {
  double choice = sampler.next_1d();
  const auto random = sampler.next_2d();
  Sample s;
  if (choice < to_facets_) {
    const Vec3 h = sample_visible_facet(n_, toward_, alpha_, random);
    const double back = reflects(std::clamp(dot(toward_, h), 0.0, 1.0));
    if (choice >= to_facets_ * back) return through(h, to_facets_ * (1 - back));
    s.along = mirrored_at(h, toward_);
    if (choice >= to_facets_ * back * unhindered(dot(n_, s.along))) return hindered(h, to_facets_ * back);
  } else if (choice -= to_facets_; choice < to_diffuse_) {
    s.along = sample_cosine_hemisphere(n_, random);
  } else {
    s.along = mirrored_at(sample_visible_facet(n_, toward_, coat_alpha_, random), toward_);
  }
  if (!(dot(n_, s.along) > 0)) return s;
  if (const double up = bent_ ? dot(s.along, smooth_) : 0; up < 0) s.along = s.along - 2 * up * smooth_;
  s.density = density(s.along);
  if (s.density > 0) s.weight = 1 / (pi * s.density) * value(s.along);
  return s;
}

}  // namespace betwixt::traced
