// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/written_scenes.h"

#include <algorithm>

namespace betwixt {

FilesObjects::FilesObjects(const Scene& s) : s_(s) {
  for (const FromFile& file : *s.from_files) {
    if (!whole(file)) continue;
    roots_[file.root.index] = &file;
    for (std::uint32_t n = 0; n < file.parts.size(); ++n) made_[file.root.index + 1 + n] = {&file, &file.parts[n]};
  }
}

// Returns whether all parts still exist below the root, and every value that the file sets is set, possibly to another
// value.
bool FilesObjects::whole(const FromFile& file) const {
  const auto there = [&](std::uint32_t i) {
    const Object* o = find_object(s_, {i});
    return o && !o->derived ? o : nullptr;
  };
  const Object* root = there(file.root.index);
  if (!root || root->kind != Kind::group) return false;
  for (std::uint32_t n = 0; n < file.parts.size(); ++n) {
    const Object &then = file.parts[n], *now = there(file.root.index + 1 + n);
    if (!now || now->kind != then.kind || now->name != root->name + then.name.substr(file.name.size())) return false;
    for (const Slot& slot : then.slots) {
      const Slot* is = now->find(slot.function);
      if (!is || is->set.has_value() < slot.set.has_value()) return false;
    }
  }
  return true;
}

const std::string* FilesObjects::command(std::uint32_t object) const {
  const auto at = roots_.find(object);
  return at == roots_.end() ? nullptr : &at->second->command;
}

const Slot* FilesObjects::made(std::uint32_t object, const Slot& slot) const {
  const auto at = made_.find(object);
  return at == made_.end() || slot.layer ? nullptr : at->second.object->find(slot.function);
}

// Returns whether the values are equal, apart from the root's name in names below it.
bool FilesObjects::same(std::uint32_t object, const Value& now, const Value& then) const {
  const auto *is = std::get_if<Names>(&now), *was = std::get_if<Names>(&then);
  if (!is || !was) return now == then;
  const FromFile& file = *made_.at(object).file;
  const std::string& root = s_.objects[file.root.index].name;
  return std::equal((*is)->begin(), (*is)->end(), (*was)->begin(), (*was)->end(),
                    [&](const std::string& a, const std::string& b) { return a == root + b.substr(file.name.size()); });
}

bool FilesObjects::sets(std::uint32_t object, const Slot& slot) const {
  const Slot* then = made(object, slot);
  return then && then->set && slot.set && same(object, *slot.set, *then->set);
}

bool FilesObjects::tracks(std::uint32_t object, const Slot& slot) const {
  const Slot* then = made(object, slot);
  return then && slot.components.empty() && slot.track == then->track;
}

std::optional<std::pair<Time, Time>> FilesObjects::outdated(std::uint32_t object, const Slot& slot) const {
  const Slot* then = made(object, slot);
  if (!then || then->track->events.empty() || tracks(object, slot)) return std::nullopt;
  return std::pair(then->track->events.front().time, then->track->events.back().time);
}

}  // namespace betwixt
