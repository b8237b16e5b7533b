// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/module.h"

namespace betwixt {

void Module::draw(const Columns& columns, Picture& out) {
  const bool other_things = things_.take(columns), other_scenery = scenery_.take(columns);  // both are told
  if (other_things || other_scenery) draw_anew();
  canvas_.read(out);
}

Gradient Module::behind(const Gradient& own) const {
  const auto& background = scenery_.background;
  return background ? Gradient{*background, scenery_.surroundings.below.value_or(*background), false} : own;
}

}  // namespace betwixt
