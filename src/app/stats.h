// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What --stats says, on standard error.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "base/stages.h"
#include "betwixt/program.h"

namespace betwixt {

// Gathers where the time goes, from any thread.
class Spending {
 public:
  // Of the making of one frame, on one thread.
  class Listening {
   public:
    explicit Listening(Spending* to) : to_(to) {  // null: nobody wants to know
      if (to_) times_.emplace();
    }
    ~Listening() {
      if (to_) to_->add(times_->take());
    }
    Listening(const Listening&) = delete;
    Listening& operator=(const Listening&) = delete;

   private:
    Spending* const to_;
    std::optional<StageTimes> times_;
  };
  // Prints the milliseconds a frame of some stages, of what `encoding` seconds took besides, and of all else.
  void print(const std::string& title, std::initializer_list<Stage> stages,
             std::optional<double> encoding = std::nullopt) const;

 private:
  void add(const StageSeconds&);
  std::mutex mutex_;
  StageSeconds seconds_{};
  int frames_ = 0;
};

// How many bytes document and program take.
void print_sizes(const Program&);

}  // namespace betwixt
