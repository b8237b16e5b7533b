// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Kinds of the author's own (`define kind`): each has a model, which is an object with everything below it, and
// instances. An instance follows later changes of the model, except in what was changed on the instance itself. Each
// of the four aspects of a slot (see `aspect`) follows or differs by itself.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "scene/document.h"

namespace betwixt {

// The aspects of a slot, as bits.
namespace aspect {
inline constexpr std::uint8_t set = 1, track = 2, velocity = 4, filters = 8, all = 15;
}

// A slot of a part of an instance.
struct OwnSlot {
  std::uint32_t part = 0;  // the model's
  FunctionId function = 0;
  std::uint32_t layer = ObjectId::nothing;  // the instance's
  friend auto operator<=>(const OwnSlot&, const OwnSlot&) = default;
};

struct KindInstance {
  // For each part of the model, its copy; the first is the root. A copy that was removed from the instance, or for
  // which there was no room, does not exist.
  std::vector<ObjectId> parts;
  std::map<OwnSlot, std::uint8_t> own;  // the aspects that no longer follow the model
  friend bool operator==(const KindInstance&, const KindInstance&) = default;
};

struct OwnKind {
  std::string name;
  bool hidden = false;          // the model is not shown
  std::vector<ObjectId> parts;  // of the model; the first is the model itself
  std::vector<Cow<KindInstance>> instances;

  ObjectId model() const { return parts.front(); }
};

struct OwnKinds {
  std::vector<OwnKind> all;  // in the order of their definition

  const OwnKind* find(std::string_view name) const;
  // Returns the kind whose instance has this root, or null.
  const OwnKind* of(ObjectId root) const;
};

// Returns the aspects in which two slots differ; a null pointer is an empty slot.
std::uint8_t differing(const Slot* a, const Slot* b);
// Returns whether the name is below the other: man/arm is below man.
bool is_below(std::string_view name, std::string_view above);
// Returns whether an instance of `kind` is part of the model of `other`, possibly deeper inside, or both are the same.
bool contains(const Scene&, const OwnKind& other, const OwnKind& kind);
// Returns the kind that would contain itself if an instance of `kind` had this name, or null.
const OwnKind* circle(const Scene&, const OwnKind& kind, std::string_view name);

}  // namespace betwixt
