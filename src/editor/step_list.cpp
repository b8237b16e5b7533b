// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/step_list.h"

#include <utility>

namespace betwixt {

void StepList::count(Did what, Step step) {
  if (what == Did::undo && standing > 0) --standing;
  if (what == Did::redo && standing < all.size()) ++standing;
  if (what != Did::command) return;
  all.resize(standing);
  all.push_back(std::move(step));
  ++standing;
}

std::size_t bytes_of_all(std::span<const Step> steps) {
  std::size_t n = 0;
  for (const Step& s : steps) n += bytes_of(s);
  return n;
}

std::vector<Record> records_of(std::span<const Step> steps, std::span<const Step> undone) {
  std::vector<Record> out;
  for (const auto part : {steps, undone})
    for (const Step& s : part) out.push_back({Did::command, packed(s)});
  out.insert(out.end(), undone.size(), {Did::undo, {}});
  return out;
}

StepList steps_of(const std::vector<Record>& records) {
  StepList all;
  for (const Record& r : records) all.count(r.what, r.what == Did::command ? unpacked(r.text) : Step{});
  return all;
}

Status copy_steps(const std::vector<Record>& records, Journal& to, std::size_t& length) {
  for (const Record& r : records) {
    if (r.what == Did::save || r.what == Did::checkpoint) continue;
    if (Status s = to.put(r.what, r.text); !s) return s;
    length += r.what == Did::command ? bytes_of(unpacked(r.text)) : 1;
  }
  return Nothing{};
}

}  // namespace betwixt
