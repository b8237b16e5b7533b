// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/row_change.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "betwixt/language.h"
#include "betwixt/track.h"
#include "commands/line_head.h"
#include "commands/verbs.h"
#include "language/cursor.h"
#include "scene/document.h"
#include "syntax/script_text.h"

namespace betwixt {
namespace {

struct Row {
  Time time;
  std::string_view rest;
};

// Reads one line that is a row with an absolute time and without code.
std::optional<Row> read_row(std::string_view line, const Document& d) {
  if (line.empty() || line.back() != '\n' || !indented(line)) return std::nullopt;
  line.remove_suffix(1);
  LineState open;
  for (const Token& t : tokens_of(line, open))
    if (t.kind == TokenKind::feed || t.kind == TokenKind::text || line[t.at] == '=') return std::nullopt;
  if (open.goes_on()) return std::nullopt;
  Cursor c(line);
  c.rate = d.rate(), c.ticks = d.ticks();
  c.space();
  Row row;
  if (c.peek() < '0' || c.peek() > '9' || !c.time(row.time) || c.peek() == '.') return std::nullopt;
  row.rest = line.substr(static_cast<std::size_t>(c.at - line.data()));
  return row;
}

class Looking {
 public:
  Looking(std::string_view text, const TextEdit& edit, const Document& d) : text_(text), edit_(edit), document_(d) {}

  std::optional<std::vector<std::string>> commands() {
    const auto was = read_row(edit_.removed, document_), is = read_row(edit_.inserted, document_);
    if (!was || !is || may_hold_block(text_) || !find_sheet()) return std::nullopt;
    was_ = was->time, is_ = is->time;
    if (!alone_in_sheet() || !alone_in_text()) return std::nullopt;
    const std::string name(opener_);
    std::vector<std::string> all;
    if (was_ != is_) all.push_back(fmt::format("clear {} {}", name, exact(was_)));
    all.push_back(fmt::format("at {} {} {}", exact(is_), name, is->rest));
    return all;
  }

 private:
  // Formats the time; reads_back() checks that the text is exact.
  std::string exact(Time t) const { return format_time(t, document_); }
  bool reads_back(Time t) const {
    const auto again = parse_time(exact(t), document_);
    return again && *again == t;
  }

  // Finds the line above the rows; it must be a single track.
  bool find_sheet() {
    for (std::size_t at = edit_.at; at > 0;) {
      const std::size_t before = at < 2 ? std::string_view::npos : text_.rfind('\n', at - 2);
      at = before == std::string_view::npos ? 0 : before + 1;
      const std::string_view line = line_at(text_, at);
      if (below_opener(line)) continue;
      sheet_ = at;
      break;
    }
    Cursor c(line_at(text_, sheet_));
    opener_ = c.word();
    if (!c.at_line_end() || is_pattern(opener_) || first_dot(opener_) == std::string_view::npos) return false;
    const auto targets = find_targets(opener_, document_);
    if (!targets || targets->size() != 1) return false;
    target_ = (*targets)[0];
    const auto f = target_.function;
    if (f == fn::sound_at || f == fn::sound_from || f == fn::sound_until) return false;  // words' times depend on it
    const auto view = track(document_, target_);
    return !target_.velocity && !target_.query() && view && !target_.layer;
  }

  bool alone_in_sheet() {
    if (!reads_back(was_) || !reads_back(is_)) return false;
    for (std::size_t at = sheet_ + line_at(text_, sheet_).size(); at < text_.size(); at += line_at(text_, at).size()) {
      const std::string_view line = line_at(text_, at);
      if (!below_opener(line)) break;
      if (at == edit_.at) continue;
      Cursor c(line);
      if (c.at_line_end()) continue;
      const auto row = read_row(line.back() == '\n' ? std::string(line) : std::string(line) + "\n", document_);
      if (!row || row->time == was_ || row->time == is_) return false;
    }
    return true;
  }

  // Returns true if the effect of every other line is known and none affects this track.
  bool alone_in_text() {
    for (std::size_t at = 0; at < text_.size();) {
      const std::string_view line = line_at(text_, at);
      if (at != sheet_ && !below_opener(line) && !has_nothing_to_do(line, at)) return false;
      at += line.size();
    }
    return true;
  }

  bool has_nothing_to_do(std::string_view line, std::size_t at) {
    const LineHead head = line_head(line);
    if (!head.layer.empty() || (!head.time.empty() && !parse_time(head.time, document_))) return false;
    if (head.word == "rate" || head.word == "ticks") return at < sheet_;
    if (head.word == "create") return first_word(head.rest) != "like";
    if (head.verb && head.verb->flags & Verb::aside) return head.word != "set" || speaks_of_others(head.name);
    return speaks_of_others(head.word);
  }
  // Returns true for NAME.FUNCTION of another single object, or for another function of the same one.
  bool speaks_of_others(std::string_view word) const {
    const std::size_t dot = first_dot(word), mine = first_dot(opener_);
    if (dot == std::string_view::npos || is_pattern(word) || document_.aliases().contains(word.substr(0, dot)))
      return false;
    const auto function = [](std::string_view w, std::size_t d) { return w.substr(d + 1, w.find('.', d + 1) - d - 1); };
    return word.substr(0, dot) != opener_.substr(0, mine) || function(word, dot) != function(opener_, mine);
  }

  const std::string_view text_;
  const TextEdit& edit_;
  const Document& document_;
  std::size_t sheet_ = 0;
  std::string_view opener_;
  Target target_;
  Time was_, is_;
};

}  // namespace

std::optional<std::vector<std::string>> commands_of(std::string_view text, const TextEdit& edit, const Document& d) {
  if (edit.at >= text.size()) return std::nullopt;
  return Looking(text, edit, d).commands();
}

}  // namespace betwixt
