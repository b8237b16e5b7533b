// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The output of --stats, on standard error.
#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "base/stages.h"
#include "betwixt/program.h"

namespace betwixt {

// Sums up where the time goes. Any thread may add to it.
class Spending {
 public:
  // Measures one frame on one thread.
  class Listening {
   public:
    explicit Listening(Spending* to) : to_(to) {  // null measures nothing
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
  // Prints the milliseconds a frame of some stages, of `encoding` if given, and of all the rest.
  void print(const std::string& title, std::initializer_list<Stage> stages,
             std::optional<double> encoding = std::nullopt) const;

 private:
  void add(const StageSeconds&);
  std::mutex mutex_;
  StageSeconds seconds_{};
  int frames_ = 0;
};

// Prints the sizes of document and program in bytes.
void print_sizes(const Program&);

}  // namespace betwixt
