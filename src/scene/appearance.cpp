// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/appearance.h"

#include <charconv>

namespace betwixt {

std::optional<std::pair<int, int>> parse_size(std::string_view text) {
  std::pair<int, int> size;
  const char *at = text.data(), *const end = at + text.size();
  for (int* side : {&size.first, &size.second}) {
    if (side == &size.second && (at == end || *at++ != 'x')) return std::nullopt;
    const auto [stop, error] = std::from_chars(at, end, *side);
    if (error != std::errc() || *side < 1 || *side > 8192) return std::nullopt;
    at = stop;
  }
  return at == end ? std::optional(size) : std::nullopt;
}

bool subframes_fit(long n) { return n >= 1 && n <= 4096; }
bool samples_fit(long samples) { return samples == 1 || samples == 4 || samples == 9 || samples == 16; }

}  // namespace betwixt
