// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors of the values that code reads.
#pragma once

#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// Returns the message of a query's error. If the error is about a name, it begins with the call: "value('bal.x'): …".
inline std::string query_error(std::string_view call, std::string_view name, const Error& e) {
  if (e.code != ErrorCode::name) return e.message;
  return std::string(call) + "('" + std::string(name.substr(0, 60)) + "'): " + e.message;
}

}  // namespace betwixt
