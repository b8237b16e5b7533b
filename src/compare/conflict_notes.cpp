// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/conflict_notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "betwixt/language.h"
#include "commands/line_head.h"
#include "editor/text_rows.h"
#include "language/values.h"

namespace betwixt {
namespace {

struct Remark {
  std::size_t at = 0;  // the place in the text where it is inserted
  std::string indent, line;
  std::size_t conflict = 0;
};

class ConflictNotes {
 public:
  ConflictNotes(std::string& text, const Document& film, const Document& theirs)
      : text_(text), film_(film), theirs_(theirs) {}

  void add(const std::vector<FactConflict>& all, std::vector<MergeConflict>& said) {
    std::vector<Remark> remarks;
    for (const FactConflict& c : all) {
      MergeConflict m{c.key.name(), words(c.key, c.mine), words(c.theirs_key, c.theirs), line_of(c), 0};
      if (m.name.empty()) m.name = word_of(c.key.part);
      Remark r = place(c);
      r.line = r.indent.empty() ? m.line : row_of(c, m.line);
      r.conflict = said.size();
      remarks.push_back(std::move(r));
      said.push_back(std::move(m));
    }
    std::ranges::stable_sort(remarks, {}, &Remark::at);
    std::size_t shift = 0;
    for (const Remark& r : remarks) {
      std::string comment = commented(r);
      const std::size_t at = r.at + shift;
      if (at > 0 && text_[at - 1] != '\n') comment.insert(0, "\n");
      text_.insert(at, comment);
      shift += comment.size();
      const std::size_t line = text_.find_first_not_of('\n', at);
      said[r.conflict].place =
          1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(line), '\n'));
    }
  }

 private:
  std::string words(const FactKey& k, const std::optional<std::string>& said) const {
    if (!said) return k.timed() ? "removed at " + time(k.time) : "removed";
    return k.timed() ? time(k.time) + " " + *said : *said;
  }
  std::string time(Time t) const { return t == earliest_time ? "the beginning" : write_time(t, theirs_.rate()); }

  // Returns the lines that would carry out theirs.
  std::string line_of(const FactConflict& c) const {
    const auto lines = c.theirs ? commands_for(c.theirs_key, *c.theirs, theirs_) : commands_without(c.key, film_);
    if (lines.empty()) return c.key.name() + " is not set";
    // A command that only clears what the next one sets is not worth a line.
    std::string all;
    for (const std::string& line : lines)
      if (lines.size() == 1 || (!line.ends_with(" none") && !line.ends_with(" hold")))
        all += (all.empty() ? "" : "\n") + line;
    return all.empty() ? lines.front() : all;
  }
  // Returns an event of theirs as a row of its sheet.
  std::string row_of(const FactConflict& c, const std::string& line) const {
    if (!c.theirs) return line;
    const std::string& said = *c.theirs;
    const bool segment = said.substr(0, said.find(' ')).find("..") != std::string::npos;
    return segment ? said : write_time(c.theirs_key.time, theirs_.rate()) + " " + said;
  }
  static std::string commented(const Remark& r) {
    std::string all, left = r.line;
    for (bool first = true; first || !left.empty(); first = false) {
      const std::size_t feed = std::min(left.find('\n'), left.size());
      all += r.indent + (first ? "# conflict: theirs: " : "# ") + left.substr(0, feed) + "\n";
      left.erase(0, feed + 1);
    }
    return all;
  }

  std::optional<Target> target_of(const FactKey& k) const {
    const auto found = find_targets(k.object + "." + k.about, film_);
    if (!found || found->size() != 1) return std::nullopt;
    Target t = found->front();
    if (!k.layer.empty()) t.layer = film_.find(k.layer);
    return t;
  }
  std::size_t line_after(std::size_t at) const { return std::min(text_.find('\n', at), text_.size() - 1) + 1; }

  Remark place(const FactConflict& c) const {
    const Remark end{text_.size(), "", "", 0};
    if (c.key.part == FactPart::setting || c.key.part == FactPart::definition) return below_command(c.key, end);
    if (c.key.part == FactPart::object) return below_object(c.key, end);
    if (c.key.part != FactPart::event && c.key.part != FactPart::value) return end;
    const auto target = target_of(c.key);
    if (!target) return end;
    const TextRows rows = rows_about(text_, film_, std::span(&*target, 1));
    if (c.key.part == FactPart::value) {
      if (rows.values.empty()) return below_object(c.key, end);
      return {line_after(rows.values.back().value.at), "", "", 0};
    }
    for (auto s = rows.sheets.rbegin(); s != rows.sheets.rend(); ++s) {
      if (std::ranges::find(s->targets, *target) == s->targets.end() || s->rows.empty()) continue;
      const RowText* row = nullptr;
      for (const RowText& r : s->rows)
        if (r.when <= c.key.time || !row) row = &r;
      if (s->alone && row->when != c.key.time) continue;
      const std::string indent = s->alone ? "" : text_.substr(row->line.at, row->time.at - row->line.at);
      return {row->line.end(), indent, "", 0};
    }
    return end;
  }
  // Below the last command that says the fact: `rate 24`, `let n = 3`, `define kind toy …`.
  Remark below_command(const FactKey& k, Remark end) const {
    const ScriptText lines(text_);
    for (std::size_t i = 0; i < lines.count(); i = lines.behind(i)) {
      const std::string_view line = lines.line(i);
      if (empty_line(line) || is_row(lines, i)) continue;
      const LineHead head = line_head(line);
      const std::string said = fmt::format("{} {}", head.word == "define" ? "function" : head.word, head.name);
      if (head.word == k.about || said == k.about || (said == "function kind" && k.about.starts_with("kind ")))
        end.at = lines.behind(i) < lines.count() ? lines.start(lines.behind(i)) : text_.size();
    }
    return end;
  }
  Remark below_object(const FactKey& k, Remark end) const {
    const ScriptText lines(text_);
    for (std::size_t i = 0; i < lines.count(); i = lines.behind(i)) {
      const LineHead head = line_head(lines.line(i));
      if (head.word == "create" && head.name == k.object)
        end.at = lines.behind(i) < lines.count() ? lines.start(lines.behind(i)) : text_.size();
    }
    return end;
  }

  std::string& text_;
  const Document &film_, &theirs_;
};

}  // namespace

void note_conflicts(std::string& text, const Document& film, const Document& theirs,
                    const std::vector<FactConflict>& conflicts, std::vector<MergeConflict>& said) {
  ConflictNotes(text, film, theirs).add(conflicts, said);
}

}  // namespace betwixt
