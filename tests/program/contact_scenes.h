// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers for tests of contacts.
#pragma once

#include <gtest/gtest.h>

#include "betwixt/contacts.h"
#include "program/programs.h"
#include "support/random.h"

namespace betwixt {

inline Frame frame(std::vector<Item> items, double seconds = 0) {
  Frame f;
  f.time = from_seconds(seconds);
  f.items = std::move(items);
  f.camera.world = translation({0, 0, 50});
  return f;
}
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
inline Pairs pairs(const std::vector<Contact>& all) {
  Pairs out;
  for (const Contact& p : all) out.emplace_back(p.a.index, p.b.index);
  return out;
}

}  // namespace betwixt
