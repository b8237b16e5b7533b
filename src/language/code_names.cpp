// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/code_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "language/cursor.h"
#include "language/values.h"
#include "procedure/lua.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

bool code_name_begins(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool code_name_goes_on(char c) { return code_name_begins(c) || (c >= '0' && c <= '9'); }

// Iterates over the words of Lua code, skipping texts and comments.
class Words {
 public:
  explicit Words(std::string_view code) : rest_(code) {}

  std::string_view text;  // the last one, with its quotes

  // Returns the next name or single character, or "" at the end. For a text, returns a quotation mark.
  std::string_view next() {
    while (!rest_.empty()) {
      const char c = rest_[0];
      if (rest_.starts_with("--")) {
        rest_.remove_prefix(2);
        const std::size_t brackets = long_text();
        rest_.remove_prefix(brackets > 0 ? brackets : std::min(rest_.find('\n'), rest_.size()));
      } else if (const std::size_t brackets = long_text(); brackets > 0) {
        rest_.remove_prefix(brackets);
      } else if (c == '\'' || c == '"') {
        text = take(text_size());
        return "\"";
      } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
        rest_.remove_prefix(1);
      } else {
        return take(code_name_begins(c) || (c >= '0' && c <= '9') ? name() : rest_.starts_with("..") ? 2 : 1);
      }
    }
    return {};
  }

 private:
  std::string_view take(std::size_t length) {
    const std::string_view out = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return out;
  }
  std::size_t name() const {
    return static_cast<std::size_t>(std::find_if_not(rest_.begin(), rest_.end(), code_name_goes_on) - rest_.begin());
  }
  std::size_t text_size() const {
    std::size_t at = 1;
    while (at < rest_.size() && rest_[at] != rest_[0]) at += rest_[at] == '\\' ? 2 : 1;
    return std::min(at + 1, rest_.size());
  }
  // Returns the length of [[…]] or [=[…]=], or 0 if none begins here.
  std::size_t long_text() const {
    if (rest_.empty() || rest_[0] != '[') return 0;
    const std::size_t second = rest_.find_first_not_of('=', 1);
    if (second == std::string_view::npos || rest_[second] != '[') return 0;
    const std::size_t end = rest_.find("]" + std::string(second - 1, '=') + "]", second + 1);
    return end == std::string_view::npos ? rest_.size() : end + second + 1;
  }

  std::string_view rest_;
};

}  // namespace

std::vector<std::string_view> free_names(std::string_view code) {
  std::vector<std::string_view> used;
  std::unordered_set<std::string_view> seen, made;
  enum { nothing, list, head, parameters } makes = nothing;
  std::string_view before;
  Words words(code);
  for (std::string_view w = words.next(); !w.empty(); before = w, w = words.next()) {
    if (w == "local" || w == "for") {
      makes = list;
    } else if (w == "function") {
      makes = head;
    } else if (code_name_begins(w[0])) {
      if (makes == list && before != "," && before != "local" && before != "for") makes = nothing;
      if (makes != nothing) made.insert(w);
      if (makes == nothing && before != "." && before != ":" && seen.insert(w).second) used.push_back(w);
    } else if (makes == head) {
      makes = w == "(" ? parameters : head;
    } else if (makes == list ? w != "," : w == ")") {
      makes = nothing;
    }
  }
  std::erase_if(used, [&](std::string_view w) { return made.contains(w); });
  return used;
}

std::string with_values(const std::string& formula, const Lets* lets, const PatternPlace& place) {
  constexpr std::string_view own[] = {"x", "y", "u", "t", "e"};
  std::vector<std::pair<std::string_view, std::string>> values;
  for (const std::string_view name : free_names(formula)) {
    if (known_to_lua(name) || std::find(std::begin(own), std::end(own), name) != std::end(own)) continue;
    if (const std::size_t number = place_of(name, place); number > 0) {
      values.emplace_back(name, std::to_string(number));
      continue;
    }
    if (!lets) continue;
    const auto let = lets->find(name);
    if (let == lets->end()) continue;
    if (std::string value = write_code(let->second); !value.empty()) values.emplace_back(name, "(" + value + ")");
  }
  std::string out;
  std::size_t copied = 0;
  std::string_view before;
  Words words(formula);
  for (std::string_view w = words.next(); !w.empty() && !values.empty(); before = w, w = words.next()) {
    const auto value = std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == w; });
    if (value == values.end() || before == "." || before == ":") continue;
    const auto at = static_cast<std::size_t>(w.data() - formula.data());
    out += formula.substr(copied, at - copied) + value->second;
    copied = at + w.size();
  }
  return out + formula.substr(copied);
}

std::vector<std::string> quoted_texts(std::string_view code) {
  std::vector<std::string> all;
  Words words(code);
  for (std::string_view w = words.next(); !w.empty(); w = words.next())
    if (w == "\"" && words.text.size() >= 2) all.emplace_back(words.text.substr(1, words.text.size() - 2));
  return all;
}

bool code_speaks_of_place(const char* at, const char* end, bool formula) {
  if (!may_hold_text(between(at, line_end(at, end)))) return false;
  Lexer lexer(between(at, end));
  bool sign = formula;  // the text is code or a formula
  auto token = lexer.next();
  for (; token && token->kind != TokenKind::feed && token->kind != TokenKind::text; token = lexer.next())
    if (!is_space(*token)) sign = formula || lexer.of(*token) == "=" || lexer.of(*token).ends_with(".of");
  if (!token || token->kind != TokenKind::text || !sign) return false;
  Cursor c(between(at + token->at, end));
  std::string code;
  if (!c.text(code)) return false;
  const auto names = free_names(code);
  return std::any_of(names.begin(), names.end(), [](std::string_view w) {
    return w == "i" || w == "n" || (w.size() == 2 && w[0] == 'i' && w[1] >= '1' && w[1] <= '4');
  });
}

std::size_t place_of(std::string_view word, const PatternPlace& place) {
  if (word == "i" || word == "n") return word == "i" ? place.i : place.n;
  if (word.size() != 2 || word[0] != 'i' || word[1] < '1' || word[1] > '4') return 0;
  return place.ranges[static_cast<std::size_t>(word[1] - '1')];
}

static std::string write_code(const LetItem& let) {
  if (const auto* t = std::get_if<Text>(&let)) return write_text(**t);
  if (const auto* v = std::get_if<Vec3>(&let))
    return fmt::format("vec({}, {}, {})", write_number(v->x), write_number(v->y), write_number(v->z));
  if (const auto* c = std::get_if<Color>(&let))
    return fmt::format("rgb({}, {}, {})", write_number(c->r), write_number(c->g), write_number(c->b));
  const auto& q = std::get<Quantity>(let);
  const bool from_beginning = q.frames == 1 && q.value != 0;  // a time in seconds, such as that of a word
  if (q.counts_frames && !from_beginning) return {};
  return write_number(q.of == Quantity::Of::angle ? q.value * (pi / 180) : q.value);
}

std::string write_code(const Let& let) {
  const auto* list = std::get_if<LetList>(&let);
  if (!list) {
    LetItem item;
    std::visit(
        [&](const auto& value) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, LetList>) item = value;
        },
        let);
    return write_code(item);
  }
  std::string out;
  for (const LetItem& item : *list) {
    const std::string one = write_code(item);
    if (one.empty()) return {};
    out += (out.empty() ? "{" : ", ") + one;
  }
  return out + "}";
}

}  // namespace betwixt
