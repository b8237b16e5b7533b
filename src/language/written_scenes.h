// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the objects that a scene file makes, which a script need not write, and their differences from the file.
#pragma once

#include <map>

#include "scene/document.h"
#include "scene/say_text.h"

namespace betwixt {

class FilesObjects {
 public:
  explicit FilesObjects(const Scene&);

  // Returns the command that makes the object with its parts, or nullptr if there is none.
  const std::string* command(std::uint32_t object) const;
  // Returns whether a file makes the object as a part.
  bool makes(std::uint32_t object) const { return made_.contains(object); }
  bool sets(std::uint32_t object, const Slot&) const;    // whether the file sets the same value
  bool tracks(std::uint32_t object, const Slot&) const;  // whether the file makes the same events
  // Returns the first and last event that the file makes, if the track is different now.
  std::optional<std::pair<Time, Time>> outdated(std::uint32_t object, const Slot&) const;

 private:
  const Slot* made(std::uint32_t object, const Slot&) const;
  bool whole(const FromFile&) const;
  bool same(std::uint32_t object, const Value& now, const Value& then) const;

  struct Made {
    const FromFile* file;
    const Object* object;
  };
  const Scene& s_;
  std::map<std::uint32_t, const FromFile*> roots_;
  std::map<std::uint32_t, Made> made_;
};

}  // namespace betwixt
