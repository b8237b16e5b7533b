// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is drawn of a film's objects, looked at over time.
#pragma once

#include <string>
#include <unordered_map>

#include "betwixt/evaluation.h"
#include "betwixt/export.h"
#include "export/planar_drawn.h"
#include "export/planar_order.h"

namespace betwixt {

// What is drawn of one object, as it was looked at: again where anything of it changes.
struct SeenThen {
  Time time;
  std::shared_ptr<const PlanarDrawn> drawn;  // null: nothing is seen
  bool jumps = false;                        // it may jump to it from the look before, which is just before
};
using PlanarLooks = std::vector<SeenThen>;

struct Watched {
  bool turns_out = false;  // it is drawn as it is seen, and so does not move
  ObjectId paper;          // what it is drawn on
  PlanarLooks looks;
  PlanarDepths depths;
  bool textured = false;
  std::string no_drawing;  // "a torus": why there is none
  // When something of it was seen to change last, and what it was then.
  std::shared_ptr<const Shape> shape, toward;
  double blend = 0;
};

class PlanarWatch {
 public:
  PlanarWatch(const Program& program, const ExportOptions& options) : program_(program), options_(options) {}

  void add(ObjectId, bool turns_out);
  Status run();  // errors (range): outlines change too much
  Watched& of(ObjectId id) { return all_[id.index]; }

 private:
  void look(Evaluation&, Time, bool jumps);
  void look(Evaluation&, std::uint32_t drawable, Watched&, bool jumps);
  void put(Watched&, SeenThen);

  const Program& program_;
  const ExportOptions& options_;
  Time before_;
  std::unordered_map<std::uint32_t, Watched> all_;
  std::size_t numbers_ = 0;
};

}  // namespace betwixt
