// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words for codes and severities of errors, as in JSON and in Python.
#pragma once

#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

inline std::string_view word_of(ErrorCode code) {
  static constexpr std::string_view words[] = {"syntax", "name", "type", "range", "file", "machine"};
  return words[static_cast<std::size_t>(code)];
}

inline std::string_view word_of(Severity severity) {
  static constexpr std::string_view words[] = {"notice", "warning", "error"};
  return words[static_cast<std::size_t>(severity)];
}

}  // namespace betwixt
