// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of a history in their order, and the same steps as records of a journal.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "betwixt/result.h"
#include "editor/journal.h"
#include "editor/step.h"

namespace betwixt {

// Steps without their documents.
struct StepList {
  std::vector<Step> all;     // standing steps, then the undone ones; the next redo comes first
  std::size_t standing = 0;  // the number of standing steps
  std::span<const Step> stand() const { return {all.data(), standing}; }
  std::span<const Step> undone() const { return std::span(all).subspan(standing); }
  void count(Did what, Step step = {});
};

std::size_t bytes_of_all(std::span<const Step>);

// Convert journal records to steps, and steps to records.
StepList steps_of(const std::vector<Record>&);
std::vector<Record> records_of(std::span<const Step> steps, std::span<const Step> undone);
// Appends the steps among the records to another journal. Adds their bytes to `length`.
Status copy_steps(const std::vector<Record>&, Journal& to, std::size_t& length);

}  // namespace betwixt
