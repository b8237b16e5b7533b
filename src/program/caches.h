// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the queries of a compiled film keep for later ones. Each kind has its own lock, so any thread may ask. What is
// kept saves time, and changes no answer.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "betwixt/frame.h"
#include "betwixt/program.h"
#include "program/environment_set.h"
#include "program/filter_inputs.h"
#include "program/steps.h"

namespace betwixt {

class Tracer;
struct Whole;

// With many environments, all step from tick to tick together (SIMD). Each evaluator has its own copy; queries for
// single values share this set. Few environments are evaluated one by one, and the set is empty.
struct SharedEnvironments {
  std::mutex in_use;
  std::optional<EnvironmentSet> set;

  std::optional<EnvironmentSet> copy() {
    const std::lock_guard lock(in_use);
    return set;
  }
  Mat4 matrix(std::size_t member, std::int64_t tick) {
    const std::lock_guard lock(in_use);
    if (set->tick() != tick) set->advance(tick);
    return set->matrix(member);
  }
};

// The camera of a film without cameras: see own_camera() in stage.h.
struct OwnCamera {
  std::once_flag once;
  Camera made;
};

// The lines that objects have drawn, by the object of the trace: see traces.h.
struct Tracers {
  std::recursive_mutex drawing;  // held while lines are drawn; recursive, as a trace may follow a trace
  std::mutex in_use;
  std::map<std::uint32_t, std::shared_ptr<Tracer>> all;

  Tracer& of(const Program::Compiled&, std::uint32_t object);
};

// Unused evaluations, for requests of whole frames.
struct IdleEvaluations {
  std::mutex in_use;
  std::vector<std::unique_ptr<Whole>> all;

  std::unique_ptr<Whole> take();  // null if there is none
  void put(std::unique_ptr<Whole>);
};

struct Caches {
  SharedEnvironments environments;
  OwnCamera camera;
  Tracers tracers;
  IdleEvaluations idle;
  StepRuns steps;
  FilterInputs filter_inputs;
};

}  // namespace betwixt
