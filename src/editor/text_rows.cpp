// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/text_rows.h"

#include <algorithm>
#include <set>

#include "base/names.h"
#include "betwixt/language.h"
#include "commands/line_head.h"
#include "language/cursor.h"
#include "scene/document.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

class Finder {
 public:
  Finder(const std::string& text, const Document& d, std::span<const Target> targets)
      : text_(text), document_(d), targets_(targets) {
    for (const Target& t : targets) objects_.insert(t.object.index);
  }

  TextRows find() {
    const char* const end = text_.data() + text_.size();
    for (const char* at = text_.data(); at < end;) {
      const LogicalLine one = logical_line({at, end});
      const Span line{place(at), static_cast<std::size_t>(one.next(end) - at)};
      read(line, {at, one.end});
      at = one.next(end);
    }
    return std::move(found_);
  }

 private:
  std::size_t place(const char* at) const { return static_cast<std::size_t>(at - text_.data()); }
  Cursor cursor(std::string_view line) const {
    Cursor c(line);
    c.rate = document_.rate(), c.ticks = document_.ticks(), c.moments = &document_.scene(), c.clock = clock_;
    return c;
  }

  Span span(std::string_view part) const { return {place(part.data()), part.size()}; }
  // The text up to a comment or the end of the line.
  Span rest_of(std::string_view rest) const { return span(without_comment(without_indent(rest))); }

  void read(Span line, std::string_view text) {
    if (empty_line(text)) return;
    if (indentation_.row(text)) {
      if (open_) add_row(found_.sheets.back(), line, cursor(text));
      return;
    }
    open_ = false;
    clock_ = clock_in_block();
    command(line, text);
  }

  // Returns the clock of the block that the line is in.
  SectionClock clock_in_block() const {
    const Section* const section =
        indentation_.depth() > 0 ? find_section(document_.sections(), line_head(indentation_.block()).name) : nullptr;
    return section ? clock_of(*section) : SectionClock{};
  }

  void command(Span line, std::string_view text) {
    const LineHead head = line_head(text);
    ObjectId layer;
    if (!head.layer.empty() && !(layer = document_.find(head.layer))) return;
    RowText row;
    row.line = line, row.clock = clock_;
    const bool timed = !head.time.empty();
    if (timed) {
      Cursor c = cursor(head.time);
      if (!c.time(row.when) || !c.at_line_end()) return;
      row.time = span(head.time);
    }
    if (head.word == "set" && !timed) return set_line(head, layer);
    const std::string_view behind = between(head.name.data(), text.data() + text.size());
    if (head.word == "create") return create_line(Cursor(behind));
    if (first_dot(head.word) == std::string_view::npos) return;
    std::vector<Target> targets = targets_of(head.word, layer);
    if (targets.empty()) return;
    row.rest = rest_of(behind);
    if (!timed && row.rest.size > 0) return;
    open_ = !timed;
    found_.sheets.push_back({std::move(targets), line, {}, timed, clock_});
    if (timed) found_.sheets.back().rows.push_back(row);
  }

  void add_row(SheetText& sheet, Span line, Cursor c) {
    RowText row;
    row.line = line, row.clock = clock_;
    if (c.at_line_end()) return;
    const char* const from = c.at;
    row.relative = c.peek() == '+';
    const bool read = row.relative ? (++c.at, c.length(row.when)) : c.time(row.when);
    if (!read || (row.relative && sheet.rows.empty())) {
      sheet.targets.clear(), open_ = false;  // this sheet cannot be attributed
      return;
    }
    if (row.relative) row.when = sheet.rows.back().when + row.when;
    row.time = {place(from), static_cast<std::size_t>(c.at - from)};
    row.rest = rest_of(between(c.at, c.end));
    sheet.rows.push_back(row);
  }

  void set_line(const LineHead& head, ObjectId layer) {
    const std::vector<Target> targets = targets_of(head.name, layer);
    if (targets.size() == 1) found_.values.push_back({targets[0], rest_of(head.rest)});
  }

  // create NAME KIND key=value …
  void create_line(Cursor c) {
    const ObjectId id = document_.find(c.next_word());
    if (!id || !objects_.contains(id.index)) return;
    for (const Target& t : targets_) {
      if (t.object != id || t.layer || t.component >= 0 || t.velocity) continue;
      Cursor p = c;
      const std::string key = document_.name(t).substr(document_.name(id).size() + 1);
      for (p.space(); !p.at_line_end();) {
        const std::string_view word = p.word();
        if (p.peek() != '=') {
          if (word.empty()) ++p.at;
          p.space();
          continue;
        }
        ++p.at;
        const char* const from = p.at;
        std::string_view rest = between(from, p.end);
        const std::string_view value = blank(p.peek()) ? rest.substr(0, 0) : take_piece(rest);
        p.at = from + value.size();
        if (word == key) found_.values.push_back({t, {place(from), value.size()}});
        p.space();
      }
    }
  }
  // Returns the targets of a word if it names one of the objects in question.
  std::vector<Target> targets_of(std::string_view word, ObjectId layer) {
    const std::size_t dot = first_dot(word);
    if (dot == std::string_view::npos) return {};
    const std::string_view name = word.substr(0, dot);
    if (!is_pattern(name) && !document_.aliases().contains(name)) {
      const ObjectId id = document_.find(name);
      if (id && !objects_.contains(id.index)) return {};
    }
    auto targets = find_targets(word, document_);
    if (!targets) return {};
    for (Target& t : *targets) t.layer = layer;
    const bool any = std::ranges::any_of(*targets, [&](const Target& t) { return objects_.contains(t.object.index); });
    return any ? *std::move(targets) : std::vector<Target>();
  }

  const std::string& text_;
  const Document& document_;
  const std::span<const Target> targets_;
  std::set<std::uint32_t> objects_;
  TextRows found_;
  Indentation indentation_;
  SectionClock clock_;  // of the line
  bool open_ = false;   // following rows belong to the last sheet
};

}  // namespace

TextRows rows_about(const std::string& text, const Document& d, std::span<const Target> targets) {
  return Finder(text, d, targets).find();
}

}  // namespace betwixt
