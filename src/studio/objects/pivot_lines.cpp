// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pivots at the bottom or in the middle of objects.
#include <algorithm>

#include "betwixt/language.h"
#include "betwixt/math.h"
#include "betwixt/pick.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/objects/object_lines.h"
#include "studio/viewport/hand.h"

namespace betwixt::studio {

Lines pivot_lines(const Program& program, const std::vector<ObjectId>& objects, Time t, bool at_bottom) {
  constexpr double least = 1e-4;  // metres: to which numbers are rounded
  const Document& d = program.document();
  const Frame frame = program.frame(t);
  Lines lines;
  for (const ObjectId id : objects) {
    std::optional<Vec3> low, high;
    for (const Item& item : frame.items) {
      if (item.id != id) continue;
      const std::optional<Mat4> back = inverse(item.world);
      if (!back) continue;
      for (const Vec3& corner : drawn(item, 200).corners) {
        const Vec3 own = transform_point(*back, corner);
        if (!low) low = high = own;
        for (int i = 0; i < 3; ++i) (*low)[i] = std::min((*low)[i], own[i]), (*high)[i] = std::max((*high)[i], own[i]);
      }
    }
    if (!low) continue;
    Vec3 pivot = 0.5 * (*low + *high);
    if (at_bottom) pivot.y = low->y;
    for (int i = 0; i < 3; ++i) pivot[i] = rounded(pivot[i], least);
    lines.push_back("set " + d.name(id) + ".pivot " + write_vector(pivot));
  }
  return lines;
}

}  // namespace betwixt::studio
