// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// SHA-256 according to FIPS 180-4.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace betwixt {

std::array<std::uint8_t, 32> sha256(std::string_view);

}  // namespace betwixt
