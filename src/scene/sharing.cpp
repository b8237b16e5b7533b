// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes a newly read scene share the parts that are exactly equal in another one, as if it were an edit of that one.
#include "scene/document.h"

namespace betwixt {
namespace {

bool exactly(const Strand& a, const Strand& b) {
  if (!a.track.same(b.track) && !(*a.track == *b.track)) return false;
  if (a.components.size() != b.components.size()) return false;
  for (std::size_t i = 0; i < a.components.size(); ++i)
    if (!a.components[i].same(b.components[i]) && !(*a.components[i] == *b.components[i])) return false;
  return true;
}

bool exactly(const Slot& a, const Slot& b) {
  return a.function == b.function && a.layer == b.layer && a.set == b.set &&
         exactly(static_cast<const Strand&>(a), b) && exactly(a.velocity, b.velocity) && a.filters == b.filters;
}

// Environments are never shared: their events may be equal and yet have come at other moments (their numbers differ).
bool exactly(const Object& a, const Object& b) {
  if (a.name != b.name || a.kind != b.kind || a.removed != b.removed || a.leads != b.leads || a.derived != b.derived ||
      a.hidden != b.hidden || a.environment || b.environment || a.slots.size() != b.slots.size())
    return false;
  for (std::size_t i = 0; i < a.slots.size(); ++i)
    if (!exactly(a.slots[i], b.slots[i])) return false;
  return true;
}

template <class T>
void share(Cow<T>& a, const Cow<T>& b) {
  if (!a.same(b) && *a == *b) a = b;
}

}  // namespace

void Objects::share(const Objects& before) {
  for (std::size_t n = 0; n < shelves_.size() && n < before.shelves_.size(); ++n) {
    if (shelves_[n].same(before.shelves_[n])) continue;
    FileSource& files = shelves_[n].edit();
    const FileSource& other = *before.shelves_[n];
    for (std::size_t c = 0; c < files.size() && c < other.size(); ++c) {
      if (files[c].same(other[c])) continue;
      const Chunk& theirs = *other[c];
      Chunk& ours = files[c].edit();
      bool all = ours.size() == theirs.size();
      for (std::size_t k = 0; k < ours.size() && k < theirs.size(); ++k)
        if (exactly(*ours[k], *theirs[k]))
          ours[k] = theirs[k];
        else
          all = false;
      if (all) files[c] = other[c];
    }
  }
}

void share(Scene& scene, const Scene& before) {
  scene.objects.share(before.objects);
  share(scene.defined, before.defined);
  share(scene.procedures, before.procedures);
  if (scene.kinds) scene.kinds_saw = scene.objects;  // equal, and now shared
}

}  // namespace betwixt
