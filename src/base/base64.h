// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Base64: encodes bytes as letters, for text files.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

std::string base64(std::string_view bytes);

}  // namespace betwixt
