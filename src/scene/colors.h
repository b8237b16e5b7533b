// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Named colours.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "betwixt/value.h"

namespace betwixt {

Color from_bytes(std::uint32_t rgb);                              // 0xrrggbb
std::optional<std::uint32_t> named_color(std::string_view name);  // 0xrrggbb
std::string_view name_of_color(std::uint32_t rgb);                // "" if it has none
std::vector<std::string_view> color_names();

}  // namespace betwixt
