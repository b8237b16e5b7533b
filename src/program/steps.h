// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Stepped procedures: laws with memory. Step 0 is at the time `from`, and each further step gets the state of the step
// before. A state depends on the document alone, so threads that compute the same step get the same bits, whichever is
// first; no lock is held while code runs.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "betwixt/program.h"
#include "program/asking.h"
#include "scene/document.h"
#include "track/state.h"

namespace betwixt {

// The states that one procedure is known to have: checkpoints, and those computed last, which procedures that read each
// other's past need again and again.
class StepRun {
 public:
  struct Point {
    std::int64_t step = -1;  // -1: before the first step
    std::shared_ptr<const State> state;
    std::uint64_t cost = 0;  // of all steps until here
  };
  struct Failure {
    std::int64_t step = 0;
    Problem why;
  };
  // Returns the last known point that is not after the step.
  Point nearest(std::int64_t step);
  void put(Point);
  void fail_at(Failure);
  // Returns the failure if it happened at or before the step.
  std::optional<Failure> failed(std::int64_t step);
  // Keeps what a step read, and its problems.
  void note(std::int64_t step, const Asking&);
  // Passes on what the steps until this one read, and their problems: not those of later steps, which may be known or
  // not.
  void tell(std::int64_t step, Asking& caller);

 private:
  static constexpr std::size_t most_bytes = 64 << 20, most_recent_bytes = 16 << 20, most_recent = 64;
  static constexpr std::size_t most_noted = 1000;
  std::mutex in_use_;
  Point newest_;
  std::vector<Point> kept_;  // every stride_ steps
  std::deque<Point> recent_;
  std::int64_t stride_ = 1;
  std::size_t bytes_ = 0, recent_bytes_ = 0;
  std::optional<Failure> failure_;
  // With the first step that had it.
  std::vector<std::pair<std::int64_t, Target>> read_;
  std::vector<std::pair<std::int64_t, Problem>> problems_;
};

// The runs of a film, by their procedure.
class StepRuns {
 public:
  StepRun& of(const NamedProcedure&);

 private:
  std::mutex in_use_;
  std::map<const NamedProcedure*, std::unique_ptr<StepRun>> all_;
};

// A step that is being computed, inside another one or not.
struct OpenStep {
  const StepRun* run = nullptr;
  std::int64_t step = 0;
  OpenStep* outer = nullptr;
  bool circle = false;  // it is needed for its own result
};

// Paths among obstacles (collisions.h) and integrals (integrals.h) go from step to step too. Their states are vectors.
State state_of(std::vector<Vec3>);
std::span<const Vec3> vectors_of(const State&);  // empty for any other state

// Returns whether a step of the procedure, or a part of one, is being computed.
bool is_computing(const Program::Compiled&, const NamedProcedure&, const Asking&);

// Marks that the part of a step up to a time between two steps is being computed, beside the steps themselves.
class PartOfStep {
 public:
  PartOfStep(const Program::Compiled&, const NamedProcedure&, Time, Asking&);
  ~PartOfStep();
  PartOfStep(const PartOfStep&) = delete;
  PartOfStep& operator=(const PartOfStep&) = delete;

 private:
  Asking& asking_;
  OpenStep open_;
};

// Returns the state of a procedure of role `steps` at a time; between two steps, the blend of their states. After a
// step that failed, returns the last good state and reports the error to `asking`. Errors: range (a step would depend
// on itself), type (the first step failed).
Result<State> state_at(const Program::Compiled&, const NamedProcedure&, Time, Asking&);

}  // namespace betwixt
