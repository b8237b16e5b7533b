// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/module.h"

namespace betwixt {

void Module::draw(const Columns& columns) {
  const bool other_things = things_.take(columns), other_scenery = scenery_.take(columns);  // both must be updated
  if (other_things || other_scenery) draw_anew();
}

Status Module::draw(const Columns& columns, Picture& out) {
  draw(columns);
  if (canvas_.linear()) {
    LinearPicture light;
    canvas_.read(light);
    to_shown(light, out);
  } else {
    canvas_.read(out);
  }
  return Nothing{};
}

Status Module::draw(const Columns& columns, Shown&) {
  draw(columns);
  return canvas_.show();
}

Status Module::draw(const Columns& columns, LinearPicture& out) {
  if (!canvas_.linear()) return fail(ErrorCode::range, "pictures of linear light need a renderer with that option");
  draw(columns);
  canvas_.read(out);
  return Nothing{};
}

Backdrop Module::behind(const Backdrop& own) const {
  if (scenery_.surroundings.clear) return {};
  const auto& background = scenery_.background;
  return background ? Backdrop{*background, scenery_.surroundings.below.value_or(*background), false} : own;
}

}  // namespace betwixt
