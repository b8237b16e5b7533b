// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "betwixt/evaluation.h"
#include "betwixt/pose.h"
#include "export/fit.h"
#include "export/seen.h"

namespace betwixt::gltf {
namespace {

Json perspective(double yfov, double aspect) {
  return {{"type", "perspective"},
          {"perspective",
           {{"yfov", static_cast<float>(yfov)},
            {"aspectRatio", static_cast<float>(aspect)},
            {"znear", 0.01},
            {"zfar", 10000}}}};
}
Json orthographic(double height, double aspect) {
  return {{"type", "orthographic"},
          {"orthographic",
           {{"xmag", static_cast<float>(height / 2 * aspect)},
            {"ymag", static_cast<float>(height / 2)},
            {"znear", 0.01},
            {"zfar", 10000}}}};
}

}  // namespace

void Views::add_lights() {
  std::unordered_map<std::uint32_t, Light> all;
  for (double share : {0.0, 0.5, 1.0})
    for (const Light& l :
         program_
             .frame({options_.from.flicks +
                     static_cast<std::int64_t>(share * static_cast<double>((options_.until - options_.from).flicks))})
             .lights)
      if (l.id) all.try_emplace(l.id.index, l);
  for (const auto& [index, l] : std::map(all.begin(), all.end())) {
    if (!nodes_.has({index}) || !is_asked({index}, options_.objects)) continue;
    const Target intensity{{index}, fn::intensity}, color{{index}, fn::color};
    Channel power = value_keys(program_, intensity, options_.from, options_.until, options_.keys);
    const Channel tint = value_keys(program_, color, options_.from, options_.until, options_.keys);
    // Full light is pi lux. At the end of a lamp's range a twentieth of that is left, as when scenes are read.
    const double unit = l.sun ? pi : pi * l.range * l.range / 20;
    for (KeyPiece& p : power.pieces)
      for (auto* v : {&p.begin, &p.end, &p.leaving, &p.arriving}) (*v)[0] *= unit;
    Json light{{"type", l.sun ? "directional" : "point"},
               {"color", numbers(within_one(tint.pieces.front().begin), 3)},
               {"intensity", static_cast<float>(power.pieces.front().begin[0])}};
    if (!l.sun && l.range > 0) light["range"] = static_cast<float>(l.range);
    const std::size_t number = lights.size();
    lights.push_back(light);
    film_.use("KHR_lights_punctual");
    std::size_t node = nodes_.of({index});
    if (l.sun) node = sun(l.id);
    nodes_[node]["extensions"] = {{"KHR_lights_punctual", {{"light", number}}}};
    if (!power.constant())
      film_.point(fmt::format("/extensions/KHR_lights_punctual/lights/{}/intensity", number), power);
    if (!tint.constant()) film_.point(fmt::format("/extensions/KHR_lights_punctual/lights/{}/color", number), tint);
  }
}

// A sun shines towards the world's origin, whatever its rotation.
std::size_t Views::sun(ObjectId id) {
  const std::size_t node = nodes_.add_root({{"name", document_.name(id) + " rays"}});
  Followed f = followed(document_, 4, options_.keys.radians, [&](Time t) -> KeyValue {
    const Vec3 from = translation_of(pose(program_, id, t).world);
    const Quat q = from_matrix(look_at({}, normalize(-from, {0, -1, 0})));
    return {q.x, q.y, q.z, q.w};
  });
  f.turn = true;
  const auto knots =
      knots_between(program_.discontinuities(options_.from, options_.until), options_.from, options_.until);
  nodes_.put(node, "rotation", follow(f, knots, options_.keys), {0, 0, 0, 1});
  return node;
}

void Views::add_cameras() {
  const Evaluation first = [&] {
    Evaluation e(program_);
    e.to(options_.from);
    return e;
  }();
  const double aspect = document_.aspect();
  bool any = false;
  for (const ObjectId id : objects(document_)) {
    if (kind(document_, id) != Kind::camera || !nodes_.has(id) || !is_asked(id, options_.objects)) continue;
    const auto number = [&](FunctionId f) { return betwixt::numbers(program_.read({id, f}, options_.from))[0]; };
    any = true;
    if (const double height = number(fn::camera_height); height > 0) {
      add_camera(nodes_.of(id), document_.name(id), orthographic(height, aspect));
      continue;
    }
    const auto view = [&](Time t) {
      const double fov = betwixt::numbers(program_.read({id, fn::fov}, t))[0];
      const double lens = betwixt::numbers(program_.read({id, fn::lens}, t))[0];
      const double wide = fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(18 / std::max(lens, 0.1));
      return 2 * std::atan(std::tan(wide / 2) / aspect);
    };
    const std::size_t number_of =
        add_camera(nodes_.of(id), document_.name(id), perspective(view(options_.from), aspect));
    Channel lens = value_keys(program_, {id, fn::lens}, options_.from, options_.until, options_.keys);
    Channel fov = value_keys(program_, {id, fn::fov}, options_.from, options_.until, options_.keys);
    if (lens.constant() && fov.constant()) continue;
    const Followed f = followed(document_, 1, options_.keys.radians, [&](Time t) -> KeyValue { return {view(t)}; });
    film_.point(fmt::format("/cameras/{}/perspective/yfov", number_of),
                follow(f, keys_of({&lens, &fov}, options_.from, options_.until), options_.keys));
  }
  if (!any && options_.objects.empty()) {
    const Camera& c = first.camera();
    const std::size_t node = nodes_.add_root({{"name", "camera"}});
    const Quat q = from_matrix(c.world);
    const Vec3 at = translation_of(c.world);
    nodes_[node]["translation"] = numbers({at.x, at.y, at.z}, 3);
    nodes_[node]["rotation"] = numbers({q.x, q.y, q.z, q.w}, 4);
    add_camera(node, "camera",
               c.orthographic ? orthographic(c.height, aspect)
                              : perspective(2 * std::atan(std::tan(c.fov / 2) / aspect), aspect));
  }
  if (document_.cuts().size() > 1) leave_out(film_.made, "cuts between cameras are only in the extras of the scene");
}

std::size_t Views::add_camera(std::size_t node, const std::string& name, Json camera) {
  camera["name"] = name;
  cameras.push_back(std::move(camera));
  nodes_[node]["camera"] = cameras.size() - 1;
  return cameras.size() - 1;
}

}  // namespace betwixt::gltf
