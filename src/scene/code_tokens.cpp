// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes code apart, as far as its colors need it.
#include <algorithm>
#include <cctype>

#include "base/utf8.h"
#include "scene/code_languages.h"

namespace betwixt {
namespace {

constexpr CodeLanguage no_language{};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool begins_word(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_' || c == '$' || static_cast<unsigned char>(c) >= 0x80;
}

class CodeScanner {
 public:
  CodeScanner(std::string_view text, const CodeLanguage& language) : text_(text), l_(language) {}

  std::vector<CodeToken> all() {
    while (at_ < text_.size()) step();
    return std::move(out_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool here(std::string_view s) const { return !s.empty() && text_.substr(at_, s.size()) == s; }

  void step() {
    const char c = peek();
    if (is_blank(c)) return void(++at_);
    if (comment() || (!l_.markup && quoted())) return;
    if (l_.markup && c == '<' && (begins_word(peek(1)) || peek(1) == '/' || peek(1) == '!')) return tag();
    if (l_.markup) return word();
    if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return number();
    if (c == '#' && l_.key == ':' && std::isxdigit(static_cast<unsigned char>(peek(1)))) return number();  // of CSS
    if (begins_word(c)) return word();
    if (c == '@' && begins_word(peek(1))) return put(1 + word_length(at_ + 1), CodeClass::function);
    put(1, CodeClass::sign);
  }

  bool comment() {
    const std::size_t blank = l_.block_comment.find(' ');
    if (blank != std::string_view::npos && here(l_.block_comment.substr(0, blank))) {
      const std::string_view end = l_.block_comment.substr(blank + 1);
      const std::size_t stop = text_.find(end, at_ + blank);
      return words(stop == text_.npos ? text_.size() : stop + end.size(), CodeClass::comment), true;
    }
    for (std::size_t i = 0; i < l_.line_comments.size();) {
      const std::size_t end = std::min(l_.line_comments.find(' ', i), l_.line_comments.size());
      if (here(l_.line_comments.substr(i, end - i)))
        return words(std::min(text_.find('\n', at_), text_.size()), CodeClass::comment), true;
      i = end + 1;
    }
    return false;
  }

  bool quoted() {
    const char q = peek();
    const bool is_short = l_.quotes.find(q) != std::string_view::npos;
    const bool is_long = l_.long_quotes.find(q) != std::string_view::npos;
    if (!is_short && !is_long) return false;
    const std::string three(3, q);
    std::size_t end = at_ + 1;
    if (is_short && here(three)) {
      const std::size_t stop = text_.find(three, at_ + 3);
      end = stop == text_.npos ? text_.size() : stop + 3;
    } else {
      while (end < text_.size() && text_[end] != q && (is_long || text_[end] != '\n'))
        end += text_[end] == '\\' ? 2 : 1;
      end = std::min(end + (end < text_.size() && text_[end] == q ? 1 : 0), text_.size());
    }
    return words(end, l_.key && followed_by(end, l_.key) ? CodeClass::function : CodeClass::string), true;
  }

  // Splits everything up to `end` into words and signs of one class.
  void words(std::size_t end, CodeClass is) {
    while (at_ < end) {
      if (is_blank(peek())) {
        ++at_;
        continue;
      }
      put(std::min(begins_word(peek()) || is_digit(peek()) ? word_length(at_) : 1, end - at_), is);
    }
  }

  void tag() {
    put(1, CodeClass::sign);
    while (peek() == '/' || peek() == '!') put(1, CodeClass::sign);
    if (begins_word(peek())) put(word_length(at_), CodeClass::keyword);
    while (at_ < text_.size() && peek() != '>') {
      if (is_blank(peek()))
        ++at_;
      else if (!quoted())
        begins_word(peek()) ? put(word_length(at_), CodeClass::function) : put(1, CodeClass::sign);
    }
    if (at_ < text_.size()) put(1, CodeClass::sign);
  }

  void number() {
    std::size_t n = 1;
    while (std::isalnum(static_cast<unsigned char>(peek(n))) || peek(n) == '.' || peek(n) == '_') ++n;
    put(n, CodeClass::number);
  }

  void word() {
    const std::size_t n = begins_word(peek()) ? word_length(at_) : 1;
    put(n, l_.markup ? CodeClass::name : class_of(text_.substr(at_, n), at_ + n));
  }

  CodeClass class_of(std::string_view word, std::size_t end) const {
    if (has_code_word(l_.keywords, word, l_.any_case)) return CodeClass::keyword;
    if (has_code_word(l_.types, word, l_.any_case)) return CodeClass::type;
    if (followed_by(end, '(')) return CodeClass::function;
    if (l_.key && followed_by(end, l_.key)) return CodeClass::function;
    if (l_.capitals && std::isupper(static_cast<unsigned char>(word[0]))) return CodeClass::type;
    return CodeClass::name;
  }

  // Returns whether a sign follows, after blanks of the same line.
  bool followed_by(std::size_t at, char sign) const {
    while (at < text_.size() && (text_[at] == ' ' || text_[at] == '\t')) ++at;
    return at < text_.size() && text_[at] == sign;
  }

  std::size_t word_length(std::size_t from) const {
    std::size_t n = 0;
    const auto belongs = [&](std::size_t i) {
      if (i >= text_.size()) return false;
      return begins_word(text_[i]) || is_digit(text_[i]) || (l_.dashes && text_[i] == '-');
    };
    while (belongs(from + n)) ++n;
    return std::max<std::size_t>(1, n);
  }

  void put(std::size_t size, CodeClass is) {
    if (l_.name.empty() || l_.name == "plain") is = CodeClass::name;
    out_.push_back({at_, size, is});
    at_ += size;
  }

  const std::string_view text_;
  const CodeLanguage& l_;
  std::size_t at_ = 0;
  std::vector<CodeToken> out_;
};

}  // namespace

std::vector<CodeToken> code_tokens(std::string_view text, std::string_view language) {
  const CodeLanguage* l = find_code_language(language);
  return CodeScanner(text, l ? *l : no_language).all();
}

CodeExtent code_extent(std::string_view text) {
  CodeExtent out;
  double columns = 0;
  for (const char c : text) {
    columns = c == '\n' ? 0 : columns + (begins_character(c) ? 1 : 0);
    out.lines += c == '\n' ? 1 : 0;
    out.columns = std::max(out.columns, columns);
  }
  return out;
}

}  // namespace betwixt
