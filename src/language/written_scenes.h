// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which objects of a document need not be written, as the file of a scene makes them, and what of them differs.
#pragma once

#include <map>

#include "scene/document.h"

namespace betwixt {

class FilesObjects {
 public:
  explicit FilesObjects(const Scene&);

  // The command that makes the object with its parts; null: there is none.
  const std::string* command(std::uint32_t object) const;
  // Whether a file makes it, as a part.
  bool makes(std::uint32_t object) const { return made_.contains(object); }
  bool sets(std::uint32_t object, const Slot&) const;    // what is set
  bool tracks(std::uint32_t object, const Slot&) const;  // its events
  // The first and last event that the file makes, where the track is another one by now.
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
