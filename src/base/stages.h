// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the time of a frame goes. What makes a frame says at its top which stage begins; who listens on this thread
// gets the seconds of each. Where nobody listens, a stage costs a look at a pointer.
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

// Listens on this thread while it stands; one that stands within it takes over meanwhile.
class StageTimes {
 public:
  StageTimes() : outer_(std::exchange(listening_, this)) {}
  ~StageTimes() { listening_ = outer_; }
  StageTimes(const StageTimes&) = delete;
  StageTimes& operator=(const StageTimes&) = delete;

  static bool listened() { return listening_ != nullptr; }
  // Of each stage since the last time this was asked; what belongs to none is `other`.
  StageSeconds take() {
    begin(stage_);
    return std::exchange(seconds_, {});
  }

 private:
  friend class InStage;
  using Clock = std::chrono::steady_clock;
  // The one before it.
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

// From here to the end of the scope it is this stage, but where another one begins within it.
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
