// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the stages of a frame. Code that makes a frame opens a stage; a StageTimes on this thread gets the seconds
// of each. Without one, a stage costs the test of a pointer.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <utility>

namespace betwixt {

enum class Stage : std::uint8_t { other, tracks, procedures, environments, hierarchy, looks, gather, draw, read_back };
inline constexpr std::array<std::string_view, 9> stage_names{
    "other", "tracks", "procedures", "environments", "hierarchy", "looks", "gather", "draw", "read back"};
using StageSeconds = std::array<double, stage_names.size()>;

// Listens on this thread during its lifetime; an inner one takes over until it ends.
class StageTimes {
 public:
  StageTimes() : outer_(std::exchange(listening_, this)) {}
  ~StageTimes() { listening_ = outer_; }
  StageTimes(const StageTimes&) = delete;
  StageTimes& operator=(const StageTimes&) = delete;

  static bool listened() { return listening_ != nullptr; }
  // Returns the seconds of each stage since the last call; time outside all stages is `other`.
  StageSeconds take() {
    begin(stage_);
    return std::exchange(seconds_, {});
  }

 private:
  friend class InStage;
  using Clock = std::chrono::steady_clock;
  // Returns the previous stage.
  Stage begin(Stage next) {
    const auto now = Clock::now();
    seconds_[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - since_).count();
    since_ = now;
    return std::exchange(stage_, next);
  }

  inline static constinit thread_local StageTimes* listening_ = nullptr;
  StageTimes* const outer_;
  Stage stage_ = Stage::other;
  Clock::time_point since_ = Clock::now();
  StageSeconds seconds_{};
};

// Opens a stage to the end of the scope; inner stages interrupt it.
class InStage {
 public:
  explicit InStage(Stage stage) : times_(StageTimes::listening_), outer_(times_ ? times_->begin(stage) : stage) {}
  ~InStage() {
    if (times_) times_->begin(outer_);
  }
  InStage(const InStage&) = delete;
  InStage& operator=(const InStage&) = delete;

 private:
  StageTimes* const times_;
  const Stage outer_;
};

}  // namespace betwixt
