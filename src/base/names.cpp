// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

#include "base/cancellation.h"

namespace betwixt {
namespace {

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool digit(char c) { return c >= '0' && c <= '9'; }

// Returns the index of the brace that closes the one at `open`, or npos.
std::size_t closing(std::string_view s, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < s.size(); ++i) {
    if (s[i] == '{') ++depth;
    if (s[i] == '}' && --depth == 0) return i;
  }
  return std::string_view::npos;
}

std::vector<std::string_view> split_top(std::string_view body) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (body[i] == '{') ++depth;
    if (body[i] == '}') --depth;
    if (body[i] == ',' && depth == 0) {
      parts.push_back(body.substr(start, i - start));
      start = i + 1;
    }
  }
  parts.push_back(body.substr(start));
  return parts;
}

bool whole_number(std::string_view s, long& out) {
  const auto r = std::from_chars(s.data(), s.data() + s.size(), out);
  return r.ec == std::errc{} && r.ptr == s.data() + s.size();
}

// The time of a match grows with the product of the pattern's and the name's lengths.
constexpr std::size_t longest_pattern = 4000;

// Returns the alternatives of one brace group: the numbers of a..b, or the parts between commas.
Result<std::vector<std::string>> alternatives(std::string_view body, std::size_t most) {
  std::vector<std::string> out;
  const auto dots = body.find("..");
  long a = 0, b = 0;
  if (dots != std::string_view::npos && whole_number(body.substr(0, dots), a) &&
      whole_number(body.substr(dots + 2), b)) {
    const auto count = static_cast<std::size_t>(std::labs(b / 2 - a / 2)) * 2;  // halved first: no overflow
    if (count > most) return fail(ErrorCode::range, fmt::format("'{{{}}}' makes more than {} names", body, most));
    // {01..10} keeps its zeros, as the shell does.
    const auto width = body[0] == '0' && dots > 1 ? dots : 1;
    if (width > 1000) return fail(ErrorCode::range, "the braces make names that are too long");
    for (long i = a;; i += a <= b ? 1 : -1) {
      Cancellation::check();
      out.push_back(fmt::format("{:0{}}", i, width));
      if (i == b) break;
    }
    return out;
  }
  for (auto part : split_top(body)) out.emplace_back(part);
  return out;
}

}  // namespace

bool is_name(std::string_view s) {
  if (s.empty() || s.size() > 1000 || !letter(s[0]) || s.back() == '/') return false;
  for (std::size_t i = 1; i < s.size(); ++i) {
    const char c = s[i];
    if (!letter(c) && !digit(c) && c != '-' && c != '_' && c != '/') return false;
    if (c == '/' && !letter(s[i + 1]) && !digit(s[i + 1])) return false;
  }
  return true;
}

bool is_pattern(std::string_view s) {
  return std::any_of(s.begin(), s.end(), [](char c) { return c == '*' || c == '?' || c == '[' || c == '{'; });
}

static bool all_digits(std::string_view s) { return !s.empty() && s.find_first_not_of("0123456789") == s.npos; }

Result<std::vector<std::string>> expand_braces(std::string_view pattern, std::size_t most) {
  if (const auto set = pattern.rfind('['); set != pattern.npos && pattern.find(']', set + 2) == pattern.npos)
    return fail(ErrorCode::syntax, fmt::format("the bracket in '{}' is not closed", pattern.substr(0, 60)));
  std::vector<std::string> done{std::string(pattern)};
  // Expands the leftmost group of every string until none is left; each round keeps the order.
  constexpr std::size_t most_characters = 64'000'000;
  for (int round = 0;; ++round) {
    bool any = false;
    std::size_t characters = 0;
    std::vector<std::string> next;
    for (const auto& s : done) {
      const auto open = s.find('{');
      if (open == std::string::npos) {
        next.push_back(s);
        continue;
      }
      const auto close = closing(s, open);
      if (close == std::string_view::npos)
        return fail(ErrorCode::syntax, fmt::format("the brace in '{}' is not closed", s.substr(0, 60)));
      if (round == 100) return fail(ErrorCode::range, "a name with more than 100 braces");
      any = true;
      const std::string_view inside = std::string_view(s).substr(open + 1, close - open - 1);
      if (const auto dash = inside.find('-');
          dash > 0 && dash != inside.npos && all_digits(inside.substr(0, dash)) && all_digits(inside.substr(dash + 1)))
        return fail(ErrorCode::syntax, fmt::format("'{{{}}}' is no range", inside.substr(0, 60)),
                    fmt::format("write {{{}..{}}}", inside.substr(0, dash), inside.substr(dash + 1)));
      auto parts = alternatives(std::string_view(s).substr(open + 1, close - open - 1), most);
      if (!parts) return parts.error();
      if (next.size() + parts->size() > most)
        return fail(ErrorCode::range, fmt::format("the braces make more than {} names", most));
      for (const auto& part : *parts) {
        Cancellation::check();
        next.push_back(s.substr(0, open) + part + s.substr(close + 1));
        characters += next.back().size();
        if (characters > most_characters) return fail(ErrorCode::range, "the braces make names that are too long");
      }
    }
    done = std::move(next);
    if (!any) break;
  }
  for (const std::string& word : done)
    if (word.size() > longest_pattern && is_pattern(word))
      return fail(ErrorCode::range, fmt::format("a pattern can have at most {} characters", longest_pattern));
  return done;
}

std::vector<std::size_t> brace_ranges(std::string_view pattern) {
  std::vector<std::size_t> sizes;
  for (std::size_t open; (open = pattern.find('{')) != std::string_view::npos;) {
    const std::size_t close = closing(pattern, open);
    if (close == std::string_view::npos) return {};
    const std::string_view body = pattern.substr(open + 1, close - open - 1);
    const auto parts = alternatives(body, 1'000'000);
    if (!parts || body.find('{') != std::string_view::npos) return {};
    sizes.push_back(parts->size());
    pattern.remove_prefix(close + 1);
  }
  return sizes;
}

bool matches(std::string_view p, std::string_view s) {
  // Greedy with one backtrack to the last star: linear in practice, never exponential.
  std::size_t i = 0, j = 0, star = std::string_view::npos, mark = 0;
  while (j < s.size()) {
    const bool stop = s[j] == '/' || s[j] == '.';
    bool one = false;
    std::size_t step = 1;
    if (i < p.size() && p[i] == '*') {
      star = i++;
      mark = j;
      continue;
    }
    if (i < p.size() && p[i] == '?') {
      one = !stop;
    } else if (i < p.size() && p[i] == '[') {
      const auto end = p.find(']', i + 2);
      if (end != std::string_view::npos) {
        std::size_t k = i + 1;
        const bool negated = p[k] == '!' || p[k] == '^';
        if (negated) ++k;
        bool in = false;
        for (; k < end; ++k) {
          if (k + 2 < end && p[k + 1] == '-') {
            in = in || (s[j] >= p[k] && s[j] <= p[k + 2]);
            k += 2;
          } else {
            in = in || s[j] == p[k];
          }
        }
        one = in != negated && !stop;
        step = end - i + 1;
      }
    } else if (i < p.size()) {
      one = p[i] == s[j];
    }
    if (one) {
      i += step;
      ++j;
    } else if (star != std::string_view::npos && s[mark] != '/' && s[mark] != '.') {
      i = star + 1;
      j = ++mark;
    } else {
      return false;
    }
  }
  while (i < p.size() && p[i] == '*') ++i;
  return i == p.size();
}

std::string key_word(std::string_view text) {
  // The letters of U+00C0 to U+017F without their accents; * for what is no letter of this kind.
  constexpr std::string_view plain =
      "AAAAAAACEEEEIIIIDNOOOOO*OUUUUYTsaaaaaaaceeeeiiiidnooooo*ouuuuyty"
      "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUu"
      "UuUuUuWwYyYZzZzZzs";
  static_assert(plain.size() == 0x180 - 0xC0);
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (letter(c) || digit(c) || c == '_' || c == '-') {
      out += c;
    } else if (c == ' ' && !out.empty()) {
      out += '-';
    } else if (const auto byte = static_cast<unsigned char>(c); byte >= 0xC3 && byte <= 0xC5 && i + 1 < text.size()) {
      const std::size_t at = (byte - 0xC3) * 64 + (static_cast<unsigned char>(text[++i]) & 0x3F);
      if (plain[at] != '*') out += plain[at];
    }
  }
  while (out.ends_with('-')) out.pop_back();
  return out;
}

bool natural_less(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      const auto run = [](std::string_view s, std::size_t& k) {
        while (k < s.size() && s[k] == '0') ++k;
        const auto start = k;
        while (k < s.size() && digit(s[k])) ++k;
        return s.substr(start, k - start);
      };
      const auto x = run(a, i), y = run(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else if (a[i] != b[j]) {
      return a[i] < b[j];
    } else {
      ++i, ++j;
    }
  }
  if (i == a.size() && j == b.size()) return a < b;  // a01 and a1: some order, always the same
  return i == a.size();
}

Hint correction(const std::string& word) { return {fmt::format("did you mean '{}'?", word), word}; }

bool same_letters(std::string_view a, std::string_view b) {
  const auto next = [](std::string_view s, std::size_t& i) {
    while (i < s.size() && (s[i] == '-' || s[i] == '_')) ++i;
    return i < s.size() ? std::tolower(static_cast<unsigned char>(s[i++])) : -1;
  };
  std::size_t i = 0, j = 0;
  for (;;) {
    const int x = next(a, i), y = next(b, j);
    if (x != y || x < 0) return x == y;
  }
}

Hint did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates) {
  if (word.empty() || word.size() > 64) return {};
  std::size_t best = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::string_view found;
  for (auto c : candidates)
    if (c != word && same_letters(c, word)) return correction(std::string(c));
  std::vector<std::size_t> before, row, next;  // optimal string alignment, three rows
  for (auto c : candidates) {
    Cancellation::check();
    if (c == word || c.size() > word.size() + best || word.size() > c.size() + best) continue;
    row.assign(c.size() + 1, 0);
    before = next = row;
    for (std::size_t j = 0; j <= c.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= word.size(); ++i) {
      next[0] = i;
      for (std::size_t j = 1; j <= c.size(); ++j) {
        next[j] = std::min({row[j] + 1, next[j - 1] + 1, row[j - 1] + (word[i - 1] == c[j - 1] ? 0u : 1u)});
        if (i > 1 && j > 1 && word[i - 1] == c[j - 2] && word[i - 2] == c[j - 1])
          next[j] = std::min(next[j], before[j - 2] + 1);
      }
      std::swap(before, row);
      std::swap(row, next);
    }
    // Of two equally near words, prefer the one with the same first letter.
    const bool begins = !c.empty() && c[0] == word[0] && !found.empty() && found[0] != word[0];
    if (row[c.size()] < best || (row[c.size()] == best && begins)) {
      best = row[c.size()];
      found = c;
    }
  }
  return found.empty() ? Hint() : correction(std::string(found));
}

Error unknown_name(std::string_view kind, std::string_view name, Hint hint) {
  Error e = fail(ErrorCode::name, fmt::format("there is no {} '{}'", kind, name.substr(0, 60)), std::move(hint));
  e.subject = name;
  return e;
}

Error nothing_named(std::string_view pattern) {
  Error e = fail(ErrorCode::name, fmt::format("nothing is named '{}'", pattern));
  e.subject = pattern;
  return e;
}

}  // namespace betwixt
