// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which signs of one text go where in another.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/value.h"

namespace betwixt {

struct MatchedSign {
  std::string_view sign, part;  // `part`: the marked part of a formula that it belongs to
  Vec3 at;
};
// Pairs of indices, sorted. Only equal signs are paired, and whatever has an equal sign without a partner is paired:
// first parts with the same content, then the rest; in each the longest run of signs in order, then the nearest.
std::vector<std::pair<std::size_t, std::size_t>> match_signs(const std::vector<MatchedSign>& from,
                                                             const std::vector<MatchedSign>& to);

}  // namespace betwixt
