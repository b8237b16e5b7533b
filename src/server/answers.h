// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of answers to hosts.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"
#include "language/json.h"

namespace betwixt {

// Returns the member "said" of an answer, or an empty string if the text is empty.
inline std::string said(const std::string& text) { return text.empty() ? "" : ",\"said\":" + json_text(text); }

// Returns the members "said" and "warnings" of an answer, or an empty string if there are no warnings.
inline std::string warned(const std::vector<std::string>& all) {
  std::string lines, list;
  for (const std::string& one : all) {
    lines += one + "\n";
    list += (list.empty() ? "" : ",") + json_text(one);
  }
  return all.empty() ? "" : said(lines) + ",\"warnings\":[" + list + "]";
}

inline Error one_word_too_many(const std::string& word, std::string_view usage) {
  return fail(ErrorCode::syntax, fmt::format("'{}' is not expected here", word.substr(0, 60)),
              fmt::format("usage: {}", usage));
}

// The answer to a connection that is not a host yet.
inline std::string no_room(std::size_t hosts) {
  return fmt::format(
      "{{\"line\":0,\"ok\":false,\"error\":\"the server already has {} hosts\",\"hint\":\"to allow more: betwixt serve "
      "--hosts N\"}}\n",
      hosts);
}
inline std::string wrong_token() {
  return "{\"line\":0,\"ok\":false,\"error\":\"this is not the token\",\"hint\":\"the first line must be: token "
         "TOKEN\"}\n";
}

}  // namespace betwixt
