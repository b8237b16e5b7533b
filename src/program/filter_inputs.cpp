// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/filter_inputs.h"

#include <utility>

namespace betwixt {
namespace {

constexpr std::size_t most_entries = 1'000'000;  // some 30 MB
constexpr std::uint64_t least_cost = 100;        // steps; reading a plain track is faster than looking it up here

}  // namespace

std::size_t FilterInputs::Hash::operator()(const Key& k) const {
  std::uint64_t h = static_cast<std::uint64_t>(k.time) * 0x9e3779b97f4a7c15;
  for (const std::int32_t part : {k.live, k.strand})
    h = (h ^ (h >> 29) ^ static_cast<std::uint32_t>(part)) * 0xbf58476d1ce4e5b9;
  return static_cast<std::size_t>(h ^ (h >> 32));
}

std::optional<Value> FilterInputs::find(const Key& key, Asking& asking) {
  const std::lock_guard lock(in_use_);
  const auto known = all_.find(key);
  if (known == all_.end() || asking.is_open(known->second.taken)) return std::nullopt;
  asking.take(known->second.taken);
  for (const Target& t : known->second.read) asking.note_read(t);
  return known->second.value;
}

void FilterInputs::keep(const Key& key, Kept kept) {
  if (kept.taken.cost < least_cost) return;
  const std::size_t entries = 4 + kept.taken.asked.size() + kept.read.size();
  const std::lock_guard lock(in_use_);
  if (entries_ + entries > most_entries) all_.clear(), entries_ = 0;
  if (all_.emplace(key, std::move(kept)).second) entries_ += entries;
}

void FilterInputs::clear() {
  const std::lock_guard lock(in_use_);
  all_.clear(), entries_ = 0;
}

}  // namespace betwixt
