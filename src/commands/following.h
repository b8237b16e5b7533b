// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What speaks of objects, by number or by name, and follows where these get other names or copies of their own.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "scene/document.h"

namespace betwixt {

class Following {
 public:
  // What was called `from` is called `to`, and so is all below it. `known`: names in lists follow only where this scene
  // has what they would name then; none: they always do.
  Following(std::string from, std::string to, const Scene* known = nullptr)
      : from_(std::move(from)), to_(std::move(to)), known_(known) {}
  // What spoke of the one speaks of the other.
  void instead(ObjectId of, ObjectId now) { ids_[of.index] = now; }

  std::string name(const std::string&) const;  // the same where it is outside
  ObjectId id(ObjectId of) const;
  // The code with texts in quotes that begin with the name; null: there are none.
  std::shared_ptr<const Routine> code(Role, const std::shared_ptr<const Routine>&) const;
  // None: nothing of the value follows.
  std::optional<Value> value(const Value&) const;
  bool concerns(const Object&) const;  // whether any of its values do
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
