// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/stats.h"

#include <fmt/format.h>

#include <cstdio>
#include <numeric>

#include "base/counted.h"
#include "program/memory.h"
#include "scene/memory.h"

namespace betwixt {

void Spending::add(const StageSeconds& s) {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < s.size(); ++i) seconds_[i] += s[i];
  ++frames_;
}

void Spending::print(const std::string& title, std::initializer_list<Stage> stages,
                     std::optional<double> encoding) const {
  const auto line = [&](std::string_view name, double seconds) {
    fmt::print(stderr, "  {:<14}{:10.3f}\n", name, 1000 * seconds / std::max(frames_, 1));
  };
  fmt::print(stderr, "{}, in ms:\n", title);
  double rest = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
  for (const Stage s : stages) {
    const auto i = static_cast<std::size_t>(s);
    line(stage_names[i], seconds_[i]);
    rest -= seconds_[i];
  }
  line("other", std::max(rest, 0.0));
  if (encoding) line("encode", *encoding);
}

void print_sizes(const Program& program) {
  const SceneSize document = size_of(program.document().scene());
  const std::size_t compiled = bytes_of(program);
  const auto each = [&](std::size_t bytes) {
    if (document.events == 0) return std::string();
    return fmt::format(" ({:.1f} an event)", static_cast<double>(bytes) / static_cast<double>(document.events));
  };
  fmt::print(stderr, "{}; bytes: document {}{}, program {}{}\n", counted(document.events, "event"), document.bytes,
             each(document.bytes), compiled, each(compiled));
}

}  // namespace betwixt
