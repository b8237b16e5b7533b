// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What can be told of a film only when the whole of it has been read: what it says and nobody will see, or nobody will
// have meant; and where it says so.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "language/lines.h"
#include "scene/document.h"

namespace betwixt {

// What a remark is about: an event of a track, or what holds for the whole film; or the notes at a time.
struct Subject {
  Target target;
  std::optional<Time> time;
  bool notes = false;
};
struct Remark {
  Diagnostic said;
  std::optional<Subject> about;
};
std::vector<Remark> look_over(const Scene&);

// Reads along when a film with remarks is read once more: the last line that changed what a remark is about is its
// place. A document keeps no places, so films without remarks pay nothing for them.
class Watch {
 public:
  explicit Watch(std::vector<Remark> remarks);
  void look(const Scene&, Source&, std::string_view line);
  const std::vector<Remark>& remarks() const { return remarks_; }

 private:
  std::vector<Remark> remarks_;
  std::vector<std::optional<Event>> states_;
};

}  // namespace betwixt
