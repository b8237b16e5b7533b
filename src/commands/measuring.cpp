// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/measuring.h"

#include <algorithm>

#include "betwixt/pose.h"
#include "exchange/geometry.h"
#include "program/compiled.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

// Adds the corners of an item to the bounds; for a text, the corners of its letters.
void take_in(Measured& m, const Item& item) {
  Extent e = extent(*item.shape);
  if (item.shape->kind == Kind::text) {
    const Geometry g = realise(*item.shape);
    const Box box = g.mesh->box();
    e.low = transform_point(g.local, box.low), e.high = transform_point(g.local, box.high);
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at = transform_point(item.world, {(corner & 1 ? e.high : e.low).x, (corner & 2 ? e.high : e.low).y,
                                                 (corner & 4 ? e.high : e.low).z});
    for (int i = 0; i < 3; ++i) {
      m.low[i] = m.any ? std::min(m.low[i], at[i]) : at[i];
      m.high[i] = m.any ? std::max(m.high[i], at[i]) : at[i];
    }
    m.any = true;
  }
}

}  // namespace

std::vector<Measured> measured(const Scene& s, const std::vector<ObjectId>& objects, Time t) {
  const Program program = Program::compile(Document(std::make_shared<const Scene>(s)));
  std::vector<Measured> all(objects.size());
  std::vector<std::int32_t> whose(s.objects.size(), -1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Kinematics k = program.kinematics(objects[i], t);
    all[i] = {objects[i],
              k.position,
              k.position,
              k.track_to_world,
              std::get<Vec3>(program.read(Target{objects[i], fn::position}, t)),
              {},
              false};
    whose[objects[i].index] = static_cast<std::int32_t>(i);
  }
  const std::vector<Pose> standing = poses(program, t);
  for (Measured& m : all) m.world = standing[m.id.index].world;
  for (const Item& item : program.frame(t).items) {
    ObjectId at = item.id;
    for (std::size_t up = 0; at && up < 1000 && whose[at.index] < 0; ++up) at = standing[at.index].parent;
    if (at && whose[at.index] >= 0) take_in(all[static_cast<std::size_t>(whose[at.index])], item);
  }
  return all;
}

}  // namespace betwixt
