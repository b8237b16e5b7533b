// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/exposed_tracer.h"

#include "render/blends.h"

namespace betwixt::traced {
namespace {

bool moves(const Exposure& e) {
  return e.lights.size() > 1 ||
         std::any_of(e.things.begin(), e.things.end(), [](const Course& c) { return c.states.size() > 1; });
}

// The view at a time, from the eye of the first one.
View view_at(std::span<const View> views, double time) {
  const TimeStep step(time, views.size());
  View v = views[step.nearest()];
  v.eye = views.front().eye;
  if (!(step.share > 0)) return v;
  const View &a = views[step.first], &b = views[step.first + 1];
  v.backward = unit(mix(a.backward, b.backward, step.share));
  v.right = unit(cross(mix(a.up, b.up, step.share), v.backward));
  v.up = cross(v.backward, v.right);
  return v;
}

std::vector<Light> lights_at(const Exposure& e, double time) {
  const TimeStep step(time, e.lights.size());
  return step.share > 0 ? lights_between(e.lights[step.first], e.lights[step.first + 1], step.share)
                        : e.lights[step.first];
}

}  // namespace

ExposedTracer::ExposedTracer(const World& world, const Exposure& e, std::span<const View> views)
    : camera_(views, e.cameras, moves(e)) {
  constexpr std::size_t many = 64;
  parts_.resize(views.size() > 1 || e.lights.size() > 1 ? many : 1);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const double time = (static_cast<double>(k) + 0.5) / static_cast<double>(parts_.size());
    Part& p = parts_[k];
    p.view = view_at(views, time);
    p.scenery = {lights_at(e, time), e.background, e.surroundings};
    p.tracer = std::make_unique<const PathTracer>(world, p.view, p.scenery);
  }
}

}  // namespace betwixt::traced
