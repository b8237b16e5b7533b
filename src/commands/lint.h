// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Warnings that need the whole film: settings without any visible effect, settings that are probably mistakes, and
// their places in the script.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "language/lines.h"
#include "scene/document.h"

namespace betwixt {

// The subject of a remark: an event of a track, a setting of the whole film, or the notes at a time.
struct Subject {
  Target target;
  std::optional<Time> time;
  bool notes = false;
};
struct Remark {
  Diagnostic said;
  std::optional<Subject> about;
};
std::vector<Remark> lint(const Scene&);

// Finds the places of remarks while the film is read a second time: the place of a remark is the last line that changed
// its subject. A document stores no places, so films without remarks cost nothing extra.
class PlaceFinder {
 public:
  explicit PlaceFinder(std::vector<Remark> remarks);
  void look(const Scene&, Source&, std::string_view line);
  const std::vector<Remark>& remarks() const { return remarks_; }

 private:
  std::vector<Remark> remarks_;
  std::vector<std::optional<Event>> states_;
};

}  // namespace betwixt
