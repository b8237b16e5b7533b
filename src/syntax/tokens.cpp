// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr std::size_t longest_logical_line = 1 << 24;  // in a longer line a bracket counts as never closed
constexpr int deepest_bracket = 200;

// The change in the number of open brackets, square ones too.
long brackets_in(const Token& token, std::string_view text) {
  if (token.kind == TokenKind::open) return 1;
  if (token.kind == TokenKind::close) return -1;
  if (token.kind != TokenKind::word) return 0;
  return std::count(text.begin(), text.end(), '[') - std::count(text.begin(), text.end(), ']');
}

}  // namespace

std::optional<Token> Lexer::next() {
  if (at_ == text_.size()) return std::nullopt;
  const char* const from = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  const auto token = [&](const char* to, TokenKind kind, bool closed = true) {
    const Token t{at_, static_cast<std::size_t>(to - from), kind, closed};
    at_ = t.end();
    return t;
  };
  if (state_.text) {
    const QuotedEnd text = block_end(from, end);
    state_.text = !text.closed;
    return token(text.at, TokenKind::text, text.closed);
  }
  if (blank(*from)) return token(std::find_if_not(from, end, blank), TokenKind::space);
  if (!ends_word(*from) && !begins_comment(from, end)) return token(word_end(from, end), TokenKind::word);
  switch (*from) {
    case '\n':
      return token(from + 1, TokenKind::feed);
    case '#':
      return token(line_end(from, end), TokenKind::comment);
    case '"': {
      const QuotedEnd text = quoted_end(from, end);
      state_.text = !text.closed && begins_block(from, end);
      return token(text.at, TokenKind::text, text.closed);
    }
    case '(':
      ++state_.brackets;
      return token(from + 1, TokenKind::open);
    case ')':
      state_.brackets -= state_.brackets > 0;
      return token(from + 1, TokenKind::close);
    default:
      return token(from + 1, TokenKind::sign);
  }
}

std::vector<Token> tokens_of(std::string_view line, LineState& state) {
  std::vector<Token> all;
  Lexer lexer(line, state);
  while (const auto token = lexer.next()) all.push_back(*token);
  state = lexer.state();
  return all;
}

void pass_line(std::string_view line, LineState& state) {
  Lexer lexer(line, state);
  while (lexer.next()) continue;
  state = lexer.state();
}

std::optional<Token> token_before(std::string_view line, std::size_t place) {
  std::optional<Token> found;
  Lexer lexer(line);
  for (auto token = lexer.next(); token && token->at < place; token = lexer.next())
    if (!is_space(*token)) found = token;
  return found;
}

LogicalLine logical_line(std::string_view text) {
  const char* const first = line_end(text.data(), text.data() + text.size());
  Lexer lexer(text);
  const LineState& state = lexer.state();
  while (const auto token = lexer.next()) {
    if (token->kind == TokenKind::feed && state.brackets == 0) return {text.data() + token->at};
    if (!token->closed) return {first, state.text, state.brackets, false};
    if (state.brackets > deepest_bracket) return {first, false, state.brackets, false};
    if (token->at >= longest_logical_line) return {first, state.brackets > 0, state.brackets, false};
  }
  if (state.brackets > 0) return {first, true, state.brackets, false};
  return {text.data() + text.size()};
}

std::vector<std::string> line_words(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  std::vector<std::string> words;
  Lexer lexer(line);
  bool joined = false;  // the previous token is a part of a word that may continue
  while (const auto token = lexer.next()) {
    const std::string_view part = lexer.of(*token);
    if (token->kind == TokenKind::comment) break;
    if (token->kind == TokenKind::space) {
      joined = false;
    } else if (joined) {
      words.back() += part;
    } else if (token->kind == TokenKind::text) {
      const std::size_t quotes = quotes_of(part);
      words.emplace_back(part.substr(quotes, part.size() - quotes - (token->closed ? quotes : 0)));
    } else {
      words.emplace_back(part), joined = true;
    }
  }
  return words;
}

std::string_view take_piece(std::string_view& rest) {
  rest = without_indent(rest);
  Lexer lexer(rest);
  std::size_t end = 0;
  long open = 0;
  while (const auto token = lexer.next()) {
    const bool stops = is_space(*token) || token->kind == TokenKind::comment;
    if (stops && (end == 0 || open <= 0)) break;
    open += brackets_in(*token, lexer.of(*token));
    end = token->end();
  }
  const std::string_view piece = rest.substr(0, end);
  rest.remove_prefix(end);
  return piece;
}

const char* bracket_end(const char* at, const char* end) {
  Lexer lexer(between(at, end));
  while (const auto token = lexer.next())
    if (lexer.state().brackets == 0) return at + token->end();
  return at;
}

std::string_view without_comment(std::string_view line) {
  std::size_t end = 0;
  Lexer lexer(line);
  while (const auto token = lexer.next())
    if (!is_space(*token) && token->kind != TokenKind::comment) end = token->end();
  return line.substr(0, end);
}

std::string_view without_indent(std::string_view line) {
  line.remove_prefix(static_cast<std::size_t>(std::find_if_not(line.begin(), line.end(), blank) - line.begin()));
  return line;
}

bool empty_line(std::string_view text) {
  const char* const end = text.data() + text.size();
  const char* const at = space_end(text.data(), end, false);
  return at == end || *at == '\n';
}

std::string as_one_word(const std::string& text) {
  const bool one = !text.empty() && std::none_of(text.begin(), text.end(), ends_word) && text[0] != '#';
  return one ? text : "\"" + text + "\"";
}

std::string_view without_mark(std::string_view script) {
  return script.starts_with("\xEF\xBB\xBF") ? script.substr(3) : script;
}

std::size_t program_line(std::string_view script) {
  return script.starts_with("#!") ? std::min(script.find('\n'), script.size()) : 0;
}

}  // namespace betwixt
