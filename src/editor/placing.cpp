// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/placing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/names.h"
#include "commands/verbs.h"
#include "syntax/script_text.h"

namespace betwixt {
namespace {

// Reduces the edit to the part that differs.
void shorten(TextEdit& e) {
  std::size_t head = 0, tail = 0;
  const std::size_t most = std::min(e.removed.size(), e.inserted.size());
  while (head < most && e.removed[head] == e.inserted[head]) ++head;
  while (tail < most - head && e.removed[e.removed.size() - 1 - tail] == e.inserted[e.inserted.size() - 1 - tail])
    ++tail;
  e = {e.at + head, e.removed.substr(head, e.removed.size() - head - tail),
       e.inserted.substr(head, e.inserted.size() - head - tail)};
}

// Replaces the last line with the same verb, if the verb sets a property of the film once.
std::optional<TextEdits> instead_of_setting(const std::string& text, const std::string& line) {
  const std::string verb(first_word(line));
  const Verb* const known = find_verb(verb);
  if (!known || !(known->flags & Verb::once)) return std::nullopt;
  std::optional<TextEdits> last;
  for (const std::size_t at : line_starts(text)) {
    const std::string_view there = line_at(text, at);
    if (!indented(there) && first_word(there) == verb)
      last = TextEdits{{at, std::string(without_comment(there)), line}};
  }
  return last;
}

// rename OLD NEW: replaces the name in the text.
std::optional<TextEdits> renamed(const std::string& text, const std::string& line) {
  const std::vector<std::string> words = line_words(line);
  if (words.size() != 3 || words[0] != "rename" || is_pattern(words[1])) return std::nullopt;
  const auto of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
  const ScriptText lines(text);
  const auto in_comment = [&](std::size_t at) {
    const std::size_t number = lines.line_of(at);
    const auto token = lines.token_at(number, at - lines.start(number));
    return token && token->kind == TokenKind::comment;
  };
  TextEdits all;
  for (std::size_t at = text.rfind(words[1]); at != std::string::npos;
       at = at == 0 ? std::string::npos : text.rfind(words[1], at - 1)) {
    const std::size_t end = at + words[1].size();
    if (in_comment(at)) continue;
    const bool begins = at == 0 || !(of_name(text[at - 1]) || text[at - 1] == '/');
    if (begins && (end == text.size() || !of_name(text[end]))) all.push_back({at, words[1], words[2]});
  }
  return all.empty() ? std::nullopt : std::optional(std::move(all));
}

}  // namespace

namespace {

int count_lines(std::string_view text) {
  const auto feeds = std::count(text.begin(), text.end(), '\n');
  return static_cast<int>(feeds) + (text.empty() || text.back() == '\n' ? 0 : 1);
}

// Returns where the text goes on after so many lines from a place on.
std::size_t after_lines(std::string_view text, std::size_t from, int lines) {
  for (; lines > 0 && from < text.size(); --lines) from += line_at(text, from).size();
  return from;
}

// Returns how many bytes are the same at the beginning (or at the end, with `from_end`). Compares blocks first, since a
// text may have a million lines.
std::size_t same_bytes(std::string_view a, std::string_view b, bool from_end) {
  constexpr std::size_t block = 4096;
  const std::size_t most = std::min(a.size(), b.size());
  std::size_t n = 0;
  const auto same = [&](std::size_t count) {
    return from_end ? a.substr(a.size() - n - count, count) == b.substr(b.size() - n - count, count)
                    : a.substr(n, count) == b.substr(n, count);
  };
  while (n + block <= most && same(block)) n += block;
  while (n < most && same(1)) ++n;
  return n;
}

// Returns how many bytes at the beginning are whole lines that both texts have.
std::size_t same_head(std::string_view a, std::string_view b) {
  const std::size_t same = same_bytes(a, b, false);
  if (same == a.size() && same == b.size()) return same;
  const std::size_t feed = same == 0 ? std::string_view::npos : a.rfind('\n', same - 1);
  return feed == std::string_view::npos ? 0 : feed + 1;
}
// The same at the end, for the texts behind their common head.
std::size_t same_tail(std::string_view a, std::string_view b) {
  const std::size_t same = same_bytes(a, b, true);
  const auto begins_line = [&](std::string_view text) {
    return same == text.size() || text[text.size() - same - 1] == '\n';
  };
  if (begins_line(a) && begins_line(b)) return same;
  const std::size_t feed = a.find('\n', a.size() - same);
  return feed == std::string_view::npos ? 0 : a.size() - feed - 1;
}

}  // namespace

Result<TextEdit> replace_lines(std::string_view text, LineRange lines, std::string_view others) {
  const int count = count_lines(text);
  if (lines.first < 1 || lines.last < lines.first - 1 || lines.first > count + 1 || lines.last > count)
    return fail(ErrorCode::range,
                fmt::format("there are no lines {}..{}: the text has {}", lines.first, lines.last, count));
  const std::size_t from = after_lines(text, 0, lines.first - 1);
  const std::size_t to = after_lines(text, from, lines.last - lines.first + 1);
  TextEdit e{from, std::string(text.substr(from, to - from)), std::string(others)};
  if (to < text.size() && !e.inserted.empty() && e.inserted.back() != '\n') e.inserted += '\n';
  if (from == text.size() && from > 0 && text.back() != '\n' && !e.inserted.empty()) e.inserted.insert(0, "\n");
  return e;
}

TextEdit whole_lines(std::string_view text, const TextEdit& e) {
  const std::size_t before = e.at == 0 ? std::string_view::npos : text.rfind('\n', e.at - 1);
  const std::size_t from = before == std::string_view::npos ? 0 : before + 1;
  const std::size_t there = e.at + e.removed.size();
  const bool ends = there > from && text[there - 1] == '\n' && (e.inserted.empty() || e.inserted.back() == '\n');
  const std::size_t to = ends ? there : std::min(text.find('\n', there), text.size() - 1) + 1;
  const std::string head(text.substr(from, e.at - from)), tail(text.substr(there, std::max(to, there) - there));
  return {from, head + e.removed + tail, head + e.inserted + tail};
}

LineChange change_between(std::string_view before, std::string_view after) {
  const std::size_t head = same_head(before, after);
  const int above = count_lines(before.substr(0, head));
  before.remove_prefix(head), after.remove_prefix(head);
  const std::size_t tail = same_tail(before, after);
  before.remove_suffix(tail), after.remove_suffix(tail);
  return {{above + 1, above + count_lines(before)}, after};
}

TextEdits place(const std::string& text, const Step& step, const Document& before, const Document& after,
                const std::function<bool(const std::string&, const TextEdits&)>& makes) {
  const auto found = [&]() -> std::optional<TextEdits> {
    if (auto edits = place_in_rows(text, before, after)) return edits;
    if (step.lines.size() != 1 || !step.sheet.empty()) return std::nullopt;
    if (auto edits = instead_of_setting(text, step.lines[0])) return edits;
    return renamed(text, step.lines[0]);
  };
  if (auto edits = found()) {
    for (TextEdit& e : *edits) shorten(e);
    std::string placed = text;
    put_into(placed, *edits);
    if (makes(placed, *edits)) return *std::move(edits);
  }
  TextEdit end{text.size(), {}, text.empty() || text.back() == '\n' ? "" : "\n"};
  for (const std::string& line : lines_of(step, nullptr)) end.inserted += line + "\n";
  return {end};
}

std::optional<std::string> merge(std::string_view base, std::string_view ours, std::string_view theirs) {
  if (ours == theirs || theirs == base) return std::string(ours);
  if (ours == base) return std::string(theirs);
  const LineChange a = change_between(base, ours), b = change_between(base, theirs);
  const LineChange &upper = a.lines.first <= b.lines.first ? a : b, &lower = a.lines.first <= b.lines.first ? b : a;
  // Changes that touch at a line are a conflict.
  if (lower.lines.first <= std::max(upper.lines.last, upper.lines.first)) return std::nullopt;
  std::string all(base);
  for (const LineChange& c : {lower, upper}) {
    const auto e = replace_lines(all, c.lines, c.others);
    if (!e) return std::nullopt;
    put_into(all, {*e});
  }
  return all;
}

}  // namespace betwixt
