// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The named materials. A material is a point in the space of finishes, with a colour of its own.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "betwixt/finish.h"
#include "betwixt/shape.h"

namespace betwixt {

struct MaterialRow {
  std::string_view word;
  Material old = Material::plastic;  // how renderers without finishes show it
  bool plain = false;                // one of the four that have no finish of their own
  Vec3 color{1, 1, 1};               // linear; it is replaced by the object's colour, if that is set
  Finish finish;
};

// The first four are plastic, matte, metal and glow, in the order of Material.
std::span<const MaterialRow> materials();
// Returns plastic if there is none of that name.
const MaterialRow& material_row(std::string_view word);
// Returns "plastic|matte|…".
std::string material_words();
// Returns the finish of one of the four plain materials with this shininess.
Finish finish_of(Material, double shininess);

}  // namespace betwixt
