// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// References to objects, by number or by name, and their update when objects are renamed or copied.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "scene/document.h"

namespace betwixt {

class Following {
 public:
  // Renames `from`, and everything below it, to `to`. With `known`, names in lists change only if that scene has an
  // object of the new name; with nullptr they always change.
  Following(std::string from, std::string to, const Scene* known = nullptr)
      : from_(std::move(from)), to_(std::move(to)), known_(known) {}
  // Replaces references to one object by references to the other.
  void instead(ObjectId of, ObjectId now) { ids_[of.index] = now; }

  std::string name(const std::string&) const;  // unchanged if it is outside `from`
  ObjectId id(ObjectId of) const;
  // Returns the code with its quoted texts renamed, or nullptr if nothing changes.
  std::shared_ptr<const Routine> code(Role, const std::shared_ptr<const Routine>&) const;
  // Returns nullopt if nothing in the value changes.
  std::optional<Value> value(const Value&) const;
  bool concerns(const Object&) const;  // whether any of its values change
  void apply(Object&) const;

 private:
  std::string source(const std::string&) const;
  bool concerns(const Track&) const;
  void apply(Cow<Track>&) const;

  std::string from_, to_;
  const Scene* known_;
  std::unordered_map<std::uint32_t, ObjectId> ids_;
};

}  // namespace betwixt
