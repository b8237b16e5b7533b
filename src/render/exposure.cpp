// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/exposure.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/blends.h"
#include "render/blur.h"
#include "render/closing.h"
#include "render/content_geometry.h"
#include "render/view.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

constexpr double exact_enough = 0.125;  // pixels; motion is approximated twice
constexpr int most_steps = 64;
constexpr std::size_t most_states = 400'000, most_corners = 8'000'000;  // of all things

struct State {
  std::vector<Content> things;
  Camera camera;
  std::vector<Light> lights;
};

// How large things are in a picture.
class PixelScale {
 public:
  PixelScale(const Camera& camera, int width, int height) : half_(0.5 * width) {
    bool good = false;
    view_ = make_view(camera, width, height, good);
    if (!good) half_ = 0;
  }
  // Pixels per metre at a point of the world.
  double at(Vec3 p) const { return at_depth(view_.depth(p - view_.eye)); }
  double at_depth(double depth) const {
    return half_ * view_.sx / (view_.orthographic ? 1 : std::max(std::abs(depth), 1e-3));
  }
  const View& view() const { return view_; }

 private:
  View view_;
  double half_;
};

// What is compared of an object's states.
struct Trail {
  bool there = false;
  std::vector<Vec3> points;  // in the world
  Vec3 color;
  double transparency = 0;
};

bool same_shape(const Content& a, const Content& b) {
  return a.shape == b.shape && a.toward == b.toward && a.look.blend == b.look.blend;
}

constexpr Detail usual_detail{24, true};

// `bends`: whether its triangles change too.
Trail trail_of(const Content& p, bool bends) {
  Trail t{p.look.visible && p.shape, {}, p.look.color, p.look.transparency};
  if (!t.there) return t;
  const Extent box = extent(*p.shape);
  const Vec3 h = box.half();
  for (std::size_t k = 0; k < 8; ++k)
    t.points.push_back(
        transform_point(p.world, box.middle() + Vec3{k & 1 ? h.x : -h.x, k & 2 ? h.y : -h.y, k & 4 ? h.z : -h.z}));
  if (!bends) return t;
  constexpr std::size_t some = 128;
  const Geometry g = geometry_of(p, usual_detail);
  const auto& all = g.mesh->positions;
  for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(all.size() / some, 1))
    t.points.push_back(transform_point(p.world * g.local, {all[i][0], all[i][1], all[i][2]}));
  return t;
}

// Returns whether a state may be between two others.
bool mixes(const Content& a, const Content& b) {
  if (a.look.visible != b.look.visible || !a.shape != !b.shape) return false;
  if (!a.look.visible || same_shape(a, b)) return true;
  const Geometry x = geometry_of(a, usual_detail), y = geometry_of(b, usual_detail);
  return x.mesh->positions.size() == y.mesh->positions.size() && x.mesh->triangles == y.mesh->triangles;
}

// Returns how far the mix of two states is from a third one, in pixels. Colours count by how visible they are.
double off(const Trail& a, const Trail& b, double share, const Trail& is, const PixelScale& scale) {
  constexpr double color_step = exact_enough * 255 / 2;
  if (a.points.size() != b.points.size() || a.points.size() != is.points.size()) return 0;
  double most = 0;
  for (std::size_t i = 0; i < is.points.size(); ++i)
    most = std::max(most, length(mix(a.points[i], b.points[i], share) - is.points[i]) * scale.at(is.points[i]));
  const auto number = [&](double x, double y, double z) { return std::abs((1 - share) * x + share * y - z); };
  const Vec3 color = mix(a.color, b.color, share) - is.color;
  const double shown = std::max({std::abs(color.x), std::abs(color.y), std::abs(color.z),
                                 number(a.transparency, b.transparency, is.transparency)});
  return std::max(most, color_step * shown);
}

double off(const Camera& a, const Camera& b, double share, const Camera& is, int width, int height) {
  const PixelScale first(a, width, height), second(b, width, height), scale(is, width, height);
  const auto along = [](const View& v, double x, double y) {
    return (x - v.shift_x) / v.sx * v.right + (y - v.shift_y) / v.sy * v.up - v.backward;
  };
  const Vec3 eye = mix(first.view().eye, second.view().eye, share) - scale.view().eye;
  double most = length(eye) * scale.at_depth(is.focus / 2);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}}) {
    const Vec3 d = mix(along(first.view(), x, y), along(second.view(), x, y), share) - along(scale.view(), x, y);
    most = std::max(most, length(d) * scale.at_depth(1));
  }
  return most;
}

class ExposureMaker {
 public:
  ExposureMaker(Evaluation& e, Time opened, double shutter, int width, int height)
      : e_(e),
        opened_(opened),
        closed_(opened + from_seconds(shutter)),
        shutter_(shutter),
        width_(width),
        height_(height),
        closes_(closing(e, shutter > 0 ? e.program().discontinuities(opened, closed_) : std::vector<Time>{})) {}

  Exposure made(int subframes) {
    if (!(shutter_ > 0)) return with(0);
    const int held = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::clamp(subframes, 2, most_steps))));
    int steps = 2;
    Exposure all = with(steps);
    for (int round = 0; round < 4; ++round) {
      const int most = affordable(all);
      int wanted = any_held(all) ? std::max(steps, held) : steps;
      if (const double far = error(all, steps); far > exact_enough) {
        const double times = std::min(std::sqrt(far / exact_enough), 1.0 * most_steps);
        wanted = std::max(wanted, steps * static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(times)))));
      }
      wanted = std::min(wanted, most);
      if (wanted <= steps) break;
      all = with(steps = wanted);
    }
    thin_out(all, steps);
    return all;
  }

 private:
  State at(double part) {
    const Held held = held_at(e_, opened_, part, closes_);
    e_.to(part > 0 ? std::min(opened_ + from_seconds(shutter_ * part), closed_ - Time{1}) : opened_);
    const Columns c = columns_of(e_);
    State s{{}, held.camera.value_or(e_.camera()), held.lights.value_or(e_.lights())};
    s.things.resize(c.looks.size());
    for (std::uint32_t i = 0; i < s.things.size(); ++i)
      if (c.looks[i].visible) s.things[i] = content_of(c, i);
    for (const auto& [i, thing] : held.places) s.things[i] = thing.look.visible ? thing : Content();
    return s;
  }

  // Adds the state of a step to those before; as long as nothing changes there is one.
  template <class T, class Same>
  static void add(std::vector<T>& all, const T& now, std::size_t step, const Same& same) {
    if (step == 0) {
      all = {now};
    } else if (all.size() > 1 || !same(all.front(), now)) {
      if (all.size() == 1) all.resize(step, T(all.front()));
      all.push_back(now);
    }
  }

  Exposure with(int steps) {
    Exposure all;
    const auto same = [](const auto& a, const auto& b) { return a == b; };
    for (int k = 0; k <= steps; ++k) {
      const auto step = static_cast<std::size_t>(k);
      const State s = at(steps > 0 ? static_cast<double>(k) / steps : 0);
      all.things.resize(s.things.size());
      for (std::size_t i = 0; i < s.things.size(); ++i) {
        Course& course = all.things[i];
        add(course.states, s.things[i], step, same);
        course.mixes = course.mixes && mixes(course.states.front(), course.states.back());
      }
      add(all.cameras, s.camera, step, same);
      add(all.lights, s.lights, step, same_lights);
      if (k > 0) continue;
      const Columns c = columns_of(e_);
      all.background = c.background, all.surroundings = c.surroundings;
    }
    return all;
  }

  static bool any_held(const Exposure& all) {
    return std::any_of(all.things.begin(), all.things.end(), [](const Course& c) { return !c.mixes; });
  }

  // Returns how many steps memory allows.
  static int affordable(const Exposure& all) {
    std::size_t states = 1, corners = 1;
    for (const Course& c : all.things) {
      if (c.states.size() < 2) continue;
      const Content &first = c.states.front(), &last = c.states.back();
      ++states;
      if (first.shape != last.shape && last.shape && last.shape->mesh) corners += last.shape->mesh->positions.size();
    }
    int steps = most_steps;
    while (steps > 2 && (states * static_cast<std::size_t>(steps) > most_states ||
                         corners * static_cast<std::size_t>(steps) > most_corners))
      steps /= 2;
    return steps;
  }

  // Returns the largest difference, in pixels, from states between those of the exposure, as if they were just in the
  // middle. Uneven times are among them, so that rotations do not come back to the same state.
  double error(const Exposure& all, int steps) {
    std::vector<double> parts{0.19, 0.43, 0.71};
    constexpr int some = 6;
    for (int k = 0; k < std::min(steps, some); ++k)
      parts.push_back((std::floor((k + 0.5) * steps / std::min(steps, some)) + 0.5) / steps);
    double most = 0;
    for (const double part : parts) {
      const double place = part * steps, share = place - std::floor(place), bent = 4 * share * (1 - share);
      if (bent > 0.6) most = std::max(most, error_at(all, static_cast<std::size_t>(place), share, at(part)) / bent);
    }
    return most;
  }
  double error_at(const Exposure& all, std::size_t step, double share, const State& is) {
    const PixelScale scale(is.camera, width_, height_);
    double most = 0;
    for (std::size_t i = 0; i < is.things.size(); ++i) {
      const auto& states = all.things[i].states;
      const Content &a = states.size() > 1 ? states[step] : states[0],
                    &b = states.size() > 1 ? states[step + 1] : states[0];
      const Content& thing = is.things[i];
      if (!all.things[i].mixes || (states.size() == 1 && a == thing)) continue;
      const bool bends = !same_shape(a, b) || !same_shape(a, thing);
      most = std::max(most, off(trail_of(a, bends), trail_of(b, bends), share, trail_of(thing, bends), scale));
    }
    const auto& c = all.cameras;
    most = std::max(most, c.size() > 1 ? off(c[step], c[step + 1], share, is.camera, width_, height_)
                                       : off(c[0], c[0], share, is.camera, width_, height_));
    const auto& l = all.lights;
    const auto lights = l.size() > 1 ? lights_between(l[step], l[step + 1], share) : l[0];
    for (std::size_t i = 0; i < std::min(lights.size(), is.lights.size()); ++i)
      if (!is.lights[i].sun)
        most = std::max(most, length(lights[i].position - is.lights[i].position) * scale.at(is.lights[i].position));
    return most;
  }

  // Leaves out states that are nearly the mix of others, and finds what jumps by code.
  void thin_out(Exposure& all, int steps) const {
    std::vector<PixelScale> scales;
    for (const Camera& c : all.cameras) scales.emplace_back(c, width_, height_);
    for (Course& course : all.things) {
      if (course.states.size() < 2 || !course.mixes) continue;
      std::vector<Trail> trails;
      const bool bends = std::any_of(course.states.begin(), course.states.end(),
                                     [&](const Content& p) { return !same_shape(p, course.states.front()); });
      for (const Content& p : course.states) trails.push_back(trail_of(p, bends));
      course.mixes = !leaps(trails, scales);
      for (int fewer = 1; fewer < steps && course.mixes; fewer *= 2) {
        const auto stride = static_cast<std::size_t>(steps / fewer);
        if (!enough(course.states, trails, scales, stride)) continue;
        for (std::size_t k = 1; k * stride < course.states.size(); ++k) course.states[k] = course.states[k * stride];
        course.states.resize(static_cast<std::size_t>(fewer) + 1);
        break;
      }
    }
  }
  static bool enough(const std::vector<Content>& states, const std::vector<Trail>& trails,
                     const std::vector<PixelScale>& scales, std::size_t stride) {
    const Content& first = states.front();
    for (std::size_t k = 0; k < states.size(); ++k) {
      const Content& s = states[k];
      if (s.finish != first.finish || s.texture != first.texture || s.gradients != first.gradients) return false;
      if (k % stride == 0) continue;
      const std::size_t before = k / stride * stride;
      const double share = static_cast<double>(k - before) / static_cast<double>(stride);
      if (off(trails[before], trails[before + stride], share, trails[k], scales[std::min(k, scales.size() - 1)]) >
          exact_enough)
        return false;
    }
    return true;
  }
  // Returns whether an object that is still otherwise goes most of its way within one step.
  static bool leaps(const std::vector<Trail>& trails, const std::vector<PixelScale>& scales) {
    double all = 0, longest = 0;
    for (std::size_t k = 1; k < trails.size(); ++k) {
      const double way = off(trails[k - 1], trails[k - 1], 0, trails[k], scales[std::min(k, scales.size() - 1)]);
      all += way, longest = std::max(longest, way);
    }
    return trails.size() > 8 && longest > 2 && longest > 0.5 * all;
  }

  static bool same_lights(const std::vector<Light>& a, const std::vector<Light>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_light);
  }

  Evaluation& e_;
  const Time opened_, closed_;
  const double shutter_;
  const int width_, height_;
  const Closing closes_;
};

}  // namespace

Exposure moment_of(const Columns& c) {
  Exposure all;
  all.things.resize(c.looks.size());
  for (std::uint32_t i = 0; i < all.things.size(); ++i)
    all.things[i].states.push_back(c.looks[i].visible ? content_of(c, i) : Content());
  all.cameras = {c.camera}, all.lights = {c.lights};
  all.background = c.background, all.surroundings = c.surroundings;
  return all;
}

std::optional<Exposure> exposure_of(Evaluation& e, Time t, const Blur& how, int width, int height) {
  e.to(t);
  const double shutter = std::clamp(how.shutter.value_or(e.camera().shutter), 0.0, 60.0);
  if (subframes_needed(e, t, shutter, how.subframes, width, height) == 1) return std::nullopt;
  return ExposureMaker(e, t, shutter, width, height).made(how.subframes);
}

std::vector<Light> lights_between(const std::vector<Light>& a, const std::vector<Light>& b, double share) {
  std::vector<Light> all = share < 0.5 ? a : b;
  for (std::size_t i = 0; i < all.size() && a.size() == b.size(); ++i) {
    const Light &x = a[i], &y = b[i];
    if (x.id != y.id || x.sun != y.sun || x.shape != y.shape) continue;
    Light& l = all[i];
    const auto number = [&](double Light::*n) { l.*n = (1 - share) * x.*n + share * y.*n; };
    for (const auto n : {&Light::range, &Light::width, &Light::height, &Light::cone, &Light::cone_edge}) number(n);
    l.position = mix(x.position, y.position, share), l.color = mix(x.color, y.color, share);
    l.direction = normalize(mix(x.direction, y.direction, share), l.direction);
    l.across = normalize(mix(x.across, y.across, share), l.across);
  }
  return all;
}

}  // namespace betwixt
