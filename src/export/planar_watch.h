// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Samples the drawings of a film's objects over time.
#pragma once

#include <string>
#include <unordered_map>

#include "betwixt/evaluation.h"
#include "betwixt/export.h"
#include "export/planar_drawn.h"
#include "export/planar_order.h"

namespace betwixt {

// The drawing of one object at a sample; there is one whenever anything of it changes.
struct SeenThen {
  Time time;
  std::shared_ptr<const PlanarDrawn> drawn;  // null if nothing is visible
  bool jumps = false;                        // there may be a jump from the sample just before
};
using PlanarLooks = std::vector<SeenThen>;

struct Watched {
  bool turns_out = false;  // it turns out of the plane, so it is drawn as it looks and has no motion
  ObjectId paper;          // the object on which it is drawn
  PlanarLooks looks;
  PlanarDepths depths;
  bool textured = false;
  std::string no_drawing;  // why it has no drawing: "a torus"
  // The time of the last change, and the state then.
  std::shared_ptr<const Shape> shape, toward;
  std::shared_ptr<const Gradients> gradients;
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
