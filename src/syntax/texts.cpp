// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "syntax/texts.h"

#include "syntax/tokens.h"

namespace betwixt {
namespace {

// Each letter after a backslash, and the character that it stands for.
constexpr std::string_view escapes = "nt\"\\", meanings = "\n\t\"\\";

}  // namespace

std::string write_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const std::size_t escape = meanings.find(c);
    if (escape == std::string_view::npos)
      out += c;
    else
      (out += '\\') += escapes[escape];
  }
  return out + "\"";
}

std::optional<std::size_t> read_escapes(std::string_view written, std::string& out) {
  out.clear();
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i] != '\\' || i + 1 == written.size()) {
      out += written[i];
      continue;
    }
    const std::size_t escape = escapes.find(written[++i]);
    if (escape == std::string_view::npos) return i - 1;
    out += meanings[escape];
  }
  return std::nullopt;
}

std::string as_comment(std::string_view text) {
  std::string out = "# ";
  for (const char c : text) (out += c) += c == '\n' ? "# " : "";
  return out + "\n";
}

std::optional<std::string_view> comment_in(std::string_view line) {
  Lexer lexer(without_indent(line));
  const auto token = lexer.next();
  if (!token || token->kind != TokenKind::comment) return std::nullopt;
  const std::string_view words = without_indent(lexer.of(*token).substr(1));
  return words.substr(0, words.find_last_not_of(" \t\r") + 1);
}

}  // namespace betwixt
