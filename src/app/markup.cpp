// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/markup.h"

#include "base/utf8.h"

namespace betwixt {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : visible(text)) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string filled(std::string_view page, std::initializer_list<std::pair<std::string_view, std::string>> parts) {
  std::string out;
  while (!page.empty()) {
    const std::size_t open = page.find("{{"), close = page.find("}}", open);
    const bool found = open != page.npos && close != page.npos;
    out += page.substr(0, found ? open : page.npos);
    if (!found) break;
    for (const auto& [name, text] : parts)
      if (page.substr(open + 2, close - open - 2) == name) out += text;
    page.remove_prefix(close + 2);
  }
  return out;
}

}  // namespace betwixt
