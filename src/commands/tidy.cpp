// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a script in its canonical form: one space between words, the shortest form of numbers, and the rows of a sheet
// sorted by time and in columns. Comments and commands keep their order; a comment above a row moves with it.
#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"
#include "betwixt/language.h"
#include "commands/line_head.h"
#include "language/cursor.h"
#include "language/formula.h"
#include "language/values.h"
#include "syntax/tokens.h"
#include "track/twerpers.h"

namespace betwixt {
namespace {

// One word, bracket, text or comment, as it will be written.
struct Written {
  std::string text;
  bool comment = false, fresh_line = false;  // fresh_line: inside brackets, the author began a new line before it
  bool close = false;                        // no blank separates it from the previous one
};

struct Line {
  std::vector<std::string> lead;  // blank lines and comments above it
  std::vector<Written> tokens;    // empty if there is only a comment
  std::string comment;            // after it
  std::string_view text;          // as it is written
  Time time;                      // of a row
  bool dateless = false;          // its time is a formula with names, so that its value is unknown
};

bool looks_like_number(std::string_view w) {
  const std::size_t i = w.starts_with('-') || w.starts_with('+') ? 1 : 0;
  return i < w.size() &&
         ((w[i] >= '0' && w[i] <= '9') || (w[i] == '.' && i + 1 < w.size() && w[i + 1] >= '0' && w[i + 1] <= '9'));
}

// Returns the shortest form of a number: "4.0" is 4, "24.50f" is 24.5f, also in each half of "1.0f..24f". Returns any
// other word unchanged.
std::string shortest(std::string_view w) {
  if (!looks_like_number(w) || w.find(':') != std::string_view::npos || w.find('/') != std::string_view::npos)
    return std::string(w);
  if (const auto dots = w.find(".."); dots != std::string_view::npos && dots > 0 && dots + 2 < w.size())
    return shortest(w.substr(0, dots)) + ".." + shortest(w.substr(dots + 2));
  Cursor c(w);
  double d = 0;
  if (!c.literal(d)) return std::string(w);
  const std::string_view unit = c.unit();
  const bool later = w[0] == '+' && (unit == "f" || unit == "s" || unit == "t");  // than the row above
  return c.at == c.end ? (later ? "+" : "") + write_number(d) + std::string(unit) : std::string(w);
}

class Tidier {
 public:
  explicit Tidier(std::string_view text) : text_(text) {}

  bool run(std::string& out) {
    text_ = without_mark(text_);
    if (const std::size_t program = program_line(text_); program > 0) {
      out_ = std::string(text_.substr(0, program)) + "\n";
      text_.remove_prefix(std::min(program + 1, text_.size()));
    }
    lexer_ = Lexer(text_);
    ahead_ = lexer_.next();
    Line line;
    std::vector<std::string> lead;
    while (ahead_) {
      if (!next(line)) return false;
      if (line.tokens.empty()) {
        lead.push_back(line.comment);
        continue;
      }
      line.lead = std::move(lead);
      lead.clear();
      const Opens above = indentation_.sheet();
      const bool row = indentation_.row(line.text);
      if (row && above == Opens::list) {
        display_row(line);
        continue;
      }
      if (row) {
        if (!date(line)) return false;
        if (line.tokens[0].text[0] == '+')
          line.time = rows_.empty() ? Time{} : rows_.back().time;  // it keeps its place after that row
        one_time(line.tokens);
        rows_.push_back(std::move(line));
        continue;
      }
      flush_rows();
      settings(line);
      const std::string said = joined(line.tokens, 0);
      margin_ = std::string(2 * std::min<std::size_t>(indentation_.depth(), 40), ' ');
      depth_ = 1;
      put_lead(line.lead, margin_);
      out_ += margin_ + said + (line.comment.empty() ? "" : "  " + line.comment) + "\n";
    }
    flush_rows();
    put_lead(lead, "");
    while (out_.ends_with("\n\n")) out_.pop_back();
    out = std::move(out_);
    return true;
  }

 private:
  // Reads one logical line. Stores its comment separately. An empty line has neither tokens nor comment.
  bool next(Line& line) {
    line = {};
    const std::size_t start = ahead_->at;
    bool fresh = false;              // a new line begins here, inside brackets
    std::optional<std::size_t> end;  // of the previous token
    for (; ahead_; ahead_ = lexer_.next()) {
      const Token t = *ahead_;
      const std::string_view text = text_.substr(t.at, t.size);
      const int brackets = lexer_.state().brackets;
      if (t.kind == TokenKind::space) continue;
      if (t.kind == TokenKind::feed) {
        fresh = true;
        if (brackets > 0) continue;
        ahead_ = lexer_.next();
        line.text = text_.substr(start, t.at - start);
        return true;
      }
      if (t.kind == TokenKind::comment) {
        const std::string comment(text.substr(0, text.find_last_not_of(" \t\r") + 1));
        if (brackets > 0)
          line.tokens.push_back({comment, true, fresh});
        else
          line.comment = comment;
        continue;
      }
      if (!t.closed) return false;
      if (t.kind == TokenKind::close && open_ == 0) return false;
      if (text == "#") return false;  // not a colour; with a space after it, a comment
      const bool touches = end == t.at;
      fresh = fresh && brackets > 0;
      if (touches && goes_on_moment(line, t)) {  // voice:"the square"#2 is one word
        line.tokens.back().text += text[0] == '+' ? "+" + shortest(text.substr(1)) : text;
        fresh = false, end = t.end();
        continue;
      }
      // As in abs(i)+2, where it is no sign of a number. After = and @ it is one.
      const bool adds = touches && text[0] == '+' && line.tokens.back().text.back() == ')';
      line.tokens.push_back({(adds ? "+" + shortest(text.substr(1)) : shortest(text)), false, fresh, touches});
      open_ = brackets;
      fresh = false, end = t.end();
    }
    line.text = text_.substr(start);
    return open_ == 0;
  }

  // Returns whether a token that touches the last one belongs to the time of a word, which that one begins.
  static bool goes_on_moment(const Line& line, const Token& t) {
    if (line.tokens.empty() || (t.kind != TokenKind::text && t.kind != TokenKind::word)) return false;
    const std::string& begun = line.tokens.back().text;
    if (t.kind == TokenKind::text) return begun.ends_with(':');
    return begun[0] != '"' && begun.find(":\"") != std::string::npos;
  }

  // Follows `rate` and `ticks`, which determine f and t, to sort the rows.
  void settings(const Line& line) {
    if (line.tokens[0].text == "use") rates_known_ = false;  // that file may have changed the rates
    if (line.tokens.size() != 2 || (line.tokens[0].text != "rate" && line.tokens[0].text != "ticks")) return;
    Cursor c(line.tokens[1].text);
    if (Rate said; c.per_second(said, "") && c.at_line_end()) (line.tokens[0].text == "rate" ? rate_ : ticks_) = said;
  }

  bool date(Line& row) const {
    const std::string& text = row.tokens[0].text;
    Cursor time(text);
    time.rate = rate_, time.ticks = ticks_;
    const bool read = time.time(row.time);
    row.dateless = !read || speaks_of_place(text.data(), text.data() + text.size());
    return read || time.error->code == ErrorCode::name;
  }

  static std::string joined(const std::vector<Written>& tokens, std::size_t first) {
    std::string out;
    for (std::size_t i = first; i < tokens.size(); ++i) {
      const std::string& t = tokens[i].text;
      const std::string_view last = i > first ? std::string_view(tokens[i - 1].text) : "";
      const bool after_comment = i > first && tokens[i - 1].comment;
      if (i > first && (tokens[i].fresh_line || after_comment))
        out += "\n    ";
      else if (tokens[i].comment)
        out += "  ";
      else if (i > first && t != ")" && t != "=" && last != "(" && last != "=" && !(t == "(" && function(tokens, i)) &&
               !in_formula(tokens, i))
        out += " ";
      else if (i > first && ((t == "=" && spaced_equals(tokens, i)) || (last == "=" && spaced_equals(tokens, i - 1))))
        out += " ";
      out += t;
    }
    return out;
  }
  // Returns whether '=' has spaces around it: in alias NAME = …, and between a target or a time and its procedure.
  // After a key it has none.
  static bool spaced_equals(const std::vector<Written>& tokens, std::size_t i) {
    const Verb* const verb = find_verb(tokens[0].text);
    if (i == 0 || (verb && has_word(verb->words, "="))) return true;
    const auto& left = tokens[i - 1].text;
    return left.find('.') != std::string::npos || std::isdigit(static_cast<unsigned char>(left[0]));
  }
  // Returns whether the bracket belongs to a function, without a space: rgb(…), euler(…), shape(…). Lists the
  // functions, because verbs and keys are words, too.
  static bool function(const std::vector<Written>& tokens, std::size_t i) {
    static constexpr std::string_view names[] = {"rgb",    "hsv",   "euler",  "axis", "quat", "shape", "translate",
                                                 "rotate", "scale", "matrix", "T",    "R",    "S"};
    if (i == 0) return false;
    const auto twerper = find_twerper(tokens[i - 1].text);
    return std::find(std::begin(names), std::end(names), tokens[i - 1].text) != std::end(names) ||
           (twerper && (takes_arguments(*twerper) || row_of(*twerper).stops));
  }

  // Inside a formula brackets have no spaces: cos(i), -(1+2)*3, (1+2)^2.
  static bool in_formula(const std::vector<Written>& tokens, std::size_t i) {
    constexpr std::string_view operators = "+-*/%^";
    if (i == 0 || i >= tokens.size() || !tokens[i].close) return false;
    const std::string &left = tokens[i - 1].text, &here = tokens[i].text;
    if (left.back() == ')') return operators.find(here[0]) != std::string_view::npos;
    if (here != "(" || left == "(" || left[0] == '"') return false;
    if (operators.find(left.back()) != std::string_view::npos) return true;
    const auto name = left.find_last_of("+-*/%^");
    return is_formula_word(std::string_view(left).substr(name == std::string::npos ? 0 : name + 1));
  }

  // Joins a row's time, with its brackets, to one token.
  static void one_time(std::vector<Written>& tokens) {
    while (in_formula(tokens, 1)) {
      std::size_t end = 2;
      for (int depth = tokens[1].text == "("; depth > 0 && end < tokens.size(); ++end)
        depth += (tokens[end].text == "(") - (tokens[end].text == ")");
      const std::vector<Written> part(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(end));
      tokens[0].text = joined(part, 0);
      tokens.erase(tokens.begin() + 1, tokens.begin() + static_cast<std::ptrdiff_t>(end));
    }
  }

  void put_lead(const std::vector<std::string>& lead, std::string_view indent) {
    for (const auto& l : lead) {
      if (!l.empty()) {
        (out_ += indent) += l + "\n";
      } else if (!out_.empty() && !out_.ends_with("\n\n")) {
        out_ += "\n";
      }
    }
  }

  // Returns the index after a row's value, where its options begin.
  static std::size_t end_of_value(const std::vector<Written>& tokens) {
    int depth = 0;
    for (std::size_t i = 1; i < tokens.size(); ++i) {
      if (tokens[i].text == "(") ++depth;
      if (tokens[i].text == ")") --depth;
      if (depth > 0 || in_formula(tokens, i + 1) ||
          (i + 1 < tokens.size() && tokens[i + 1].text == "(" && function(tokens, i + 1)))
        continue;
      const bool goes_on = i + 2 < tokens.size() && tokens[i + 2].text == "(" && tokens[i + 1].text.size() == 1;
      if (!goes_on) return i + 1;  // a motion has several factors: T(…) R(…)
    }
    return tokens.size();
  }

  // The rows of a display list keep their order. Rows between a `begin` and its `end` are indented further.
  void display_row(const Line& row) {
    const std::string& word = row.tokens[0].text;
    if ((word == "end" || word == "pop") && depth_ > 1) --depth_;
    const std::string indent = margin_ + std::string(2 * std::min<std::size_t>(depth_, 40), ' ');
    put_lead(row.lead, indent);
    out_ += indent + joined(row.tokens, 0) + (row.comment.empty() ? "" : "  " + row.comment) + "\n";
    if (word == "begin" || word == "push") ++depth_;
  }

  void flush_rows() {
    // Sorts frames and seconds together only if the rates are known, and formulas only if they have no names: of two
    // rows at the same time the last one is used.
    const auto unit = [](const Line& row) { return row.tokens[0].text.back(); };
    const bool dated = std::none_of(rows_.begin(), rows_.end(), [](const Line& r) { return r.dateless; });
    // A change that lasts (`for 24f`) begins with the value that the rows before it have given.
    const bool lasting = std::any_of(rows_.begin(), rows_.end(), [](const Line& r) {
      return std::any_of(r.tokens.begin(), r.tokens.end(), [](const Written& t) { return t.text == "for"; });
    });
    if (dated && !lasting && (rates_known_ || std::all_of(rows_.begin(), rows_.end(), [&](const Line& r) {
                                return unit(r) == unit(rows_[0]);
                              })))
      std::stable_sort(rows_.begin(), rows_.end(), [](const Line& a, const Line& b) { return a.time < b.time; });
    std::size_t time_width = 0, value_width = 0;
    std::vector<std::array<std::string, 3>> cells;
    for (const Line& row : rows_) {
      const std::size_t end = end_of_value(row.tokens);
      const std::vector<Written> value(row.tokens.begin(), row.tokens.begin() + static_cast<std::ptrdiff_t>(end));
      cells.push_back({row.tokens[0].text, joined(value, 1), end < row.tokens.size() ? joined(row.tokens, end) : ""});
      time_width = std::max(time_width, count_characters(cells.back()[0]));
      if (count_characters(cells.back()[1]) <= 60)
        value_width =
            std::max(value_width, count_characters(cells.back()[1]));  // a long value does not widen the column
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      put_lead(rows_[i].lead, margin_ + "  ");
      std::string text =
          margin_ + "  " + cells[i][0] + std::string(time_width + 2 - count_characters(cells[i][0]), ' ') + cells[i][1];
      const std::size_t value = count_characters(cells[i][1]);
      if (!cells[i][2].empty())
        text += std::string(value < value_width ? value_width + 2 - value : 2, ' ') + cells[i][2];
      while (text.back() == ' ') text.pop_back();
      if (!rows_[i].comment.empty()) text += "  " + rows_[i].comment;
      out_ += text + "\n";
    }
    rows_.clear();
  }

  std::string_view text_;
  Lexer lexer_{{}};
  std::optional<Token> ahead_;
  int open_ = 0;  // brackets after the last token
  std::string out_;
  std::vector<Line> rows_;
  Indentation indentation_;
  std::string margin_;  // of the last command
  std::size_t depth_ = 1;
  bool rates_known_ = true;
  Rate rate_, ticks_{30, 1};
};

}  // namespace

std::string tidy(std::string_view text) {
  std::string out;
  return Tidier(text).run(out) ? out : std::string(text);
}

}  // namespace betwixt
