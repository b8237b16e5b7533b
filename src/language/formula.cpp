// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/names.h"
#include "language/formula_functions.h"
#include "language/moments.h"
#include "language/table_formulas.h"
#include "language/values.h"
#include "syntax/tokens.h"
#include "syntax/words.h"

namespace betwixt {
namespace {

using namespace formulas;
constexpr int deepest = 100;

class Reader {
 public:
  explicit Reader(Cursor& c) : c_(c), start_(c.at) {}

  bool whole(Quantity& out) {
    if (!sum(out)) return false;
    return finite(out);
  }
  // Reads the index after the name of a list, such as [3]. `out` counts from 0.
  bool index(std::string_view name, std::size_t count, std::size_t& out) {
    const char* const open = c_.at++;
    const Deeper deeper(*this);
    if (too_deep()) return false;
    ++inside_;
    c_.space();
    Quantity q;
    const bool read = sum(q);
    --inside_;
    if (!read) return false;
    c_.space();
    if (c_.peek() != ']') return c_.fail_here(ErrorCode::syntax, "a closing bracket ']' is missing here");
    ++c_.at;
    const std::string_view about = c_.since(open);
    if (q.of != Of::number)
      return c_.fail(ErrorCode::type, fmt::format("an index must be a number, not {}", to_string(q.of)), about);
    if (!(q.value >= 1 && q.value <= static_cast<double>(count)) || q.value != std::floor(q.value))
      return c_.fail(ErrorCode::range,
                     fmt::format("'{}' has {} value{}, counted from {}[1]; there is no {}[{}]", name, count,
                                 count == 1 ? "" : "s", name, name, write_number(q.value)),
                     about, fmt::format("{0}[(i-1)%{1}+1] starts again after the last one", name, count));
    return out = static_cast<std::size_t>(q.value) - 1, true;
  }

 private:
  std::string_view about() const { return c_.since(start_); }
  bool finite(const Quantity& q) {
    if (std::isfinite(q.value) && std::isfinite(q.frames)) return true;
    return c_.fail(ErrorCode::range, "the result of this formula is not finite", about());
  }
  // Inside brackets, an operator has blanks on both sides or on neither: (1 - 2) and (1-2) are one formula, (1 -2)
  // are two numbers.
  bool next_operator(std::string_view any, char& out) {
    const char* const before = c_.at;
    if (inside_ > 0) c_.space();
    const bool blanks = c_.at > before;
    const char op = c_.peek();
    const bool apart = c_.at + 1 < c_.end && (c_.at[1] == ' ' || c_.at[1] == '\n' || c_.at[1] == '\t');
    const bool sign = op == '+' || op == '-';
    const bool takes = c_.at < c_.end && any.find(op) != std::string_view::npos &&
                       (inside_ > 0 ? !sign || !blanks || apart : formula_goes_on(c_.at, c_.end));
    if (!takes) return c_.at = before, false;
    out = op;
    ++c_.at;
    if (op == '/' && c_.peek() == '/') out = 'q', ++c_.at;
    if (inside_ > 0) c_.space();
    return true;
  }

  bool sum(Quantity& out) {
    if (!product(out)) return false;
    for (char op; next_operator("+-", op);) {
      Quantity right;
      if (!product(right) || !add(out, right, op)) return false;
    }
    return !c_.error;
  }
  bool product(Quantity& out) {
    if (!power(out)) return false;
    for (char op; next_operator("*/%", op);) {
      Quantity right;
      if (!power(right) || !(op == '*' ? multiply(out, right) : divide(out, right, op))) return false;
    }
    return true;
  }
  // -2^2 is -4; 2^3^2 is 2^9.
  bool power(Quantity& out) {
    if (c_.peek() == '-' || c_.peek() == '+') {
      const bool minus = *c_.at++ == '-';
      const Deeper deeper(*this);
      if (too_deep() || !power(out)) return false;
      if (minus) out.value = -out.value, out.frames = -out.frames;
      return true;
    }
    if (!operand(out)) return false;
    char op;
    if (!next_operator("^", op)) return true;
    const Deeper deeper(*this);
    Quantity right;
    if (too_deep() || !power(right)) return false;
    if (out.of != Of::number || right.of != Of::number)
      return c_.fail(ErrorCode::type, "'^' needs plain numbers on both sides", about());
    out.value = std::pow(out.value, right.value);
    return true;
  }

  bool operand(Quantity& out) {
    if (c_.peek() == '(') {
      const Deeper deeper(*this);
      if (too_deep() || !c_.open()) return false;
      ++inside_;
      c_.space();
      const bool read = sum(out);
      --inside_;
      return read && c_.close();
    }
    if (number_begins(c_.at, c_.end)) return literal(out);
    if (moment_begins(c_, c_.at)) return moment(c_, out);
    const std::string_view name = name_at(c_.at, c_.end);
    if (name.empty()) return c_.fail_here(ErrorCode::syntax, "a number or a name is missing in this formula");
    if (cell_begins(c_)) {
      LetItem item;
      return cell(c_, item) && is_number_cell(c_, item, c_.since(name.data())) && quantity(item, {}, out);
    }
    c_.at += name.size();
    if (column_function_begins(c_, name)) return column_function(c_, name, out);
    if (c_.peek() == '(') return call(name, out);
    return named(name, out);
  }

  bool literal(Quantity& out) {
    const char* const start = c_.at;
    double n = 0;
    if (!c_.literal(n)) return false;
    const std::string_view u = c_.unit();
    if (u.empty()) return out = number(n), true;
    if (u == "deg") return out = {Of::angle, n, 0, false}, true;
    if (u == "turn") return out = {Of::angle, n * 360, 0, false}, true;
    if (u == "rad") return out = degrees(n), true;
    if (u == "f") return c_.frames_read = true, out = {Of::time, 0, n, true}, true;
    if (u == "s") return out = {Of::time, n, 0, false}, true;
    if (u == "ms") return out = {Of::time, n / 1000, 0, false}, true;
    if (u == "t") {
      c_.ticks_read = true;
      if (!(std::abs(n) <= longest_seconds * c_.ticks.per_second())) n = HUGE_VAL;
      return out = {Of::time, std::isfinite(n) ? c_.ticks.span(n).seconds() : n, 0, false}, true;
    }
    const double metres = u == "m" ? 1 : u == "cm" ? 0.01 : u == "mm" ? 0.001 : 0;
    if (metres != 0) return out = {Of::length, u == "m" ? n : n / (u == "cm" ? 100 : 1000), 0, false}, true;
    return c_.fail(ErrorCode::type, fmt::format("'{}' is not a unit", u),
                   {start, static_cast<std::size_t>(c_.at - start)}, "units are deg rad turn, f s ms t, m cm mm");
  }

  bool named(std::string_view name, Quantity& out) {
    for (const auto& [word, value] : constants)
      if (word == name) return out = number(value), true;
    if (name == "i" || name == "n")
      return out = number(static_cast<double>(name == "i" ? c_.place.i : c_.place.n)), true;
    if (name.size() == 2 && name[0] == 'i' && name[1] >= '1' && name[1] <= '4') {
      const std::size_t place = c_.place.ranges[static_cast<std::size_t>(name[1] - '1')];
      if (place > 0) return out = number(static_cast<double>(place)), true;
      return c_.fail(ErrorCode::name,
                     fmt::format("the pattern has no {} range for {} to count",
                                 name[1] == '1'   ? "first"
                                 : name[1] == '2' ? "second"
                                                  : "such",
                                 name),
                     name, "ranges are {1..10} and {a,b,c}; i counts all matching objects");
    }
    const auto known = c_.lets ? c_.lets->find(name) : Lets::const_iterator();
    if (!c_.lets || known == c_.lets->end()) return unknown(name);
    LetItem item;
    if (c_.peek() == '[' || !single(known->second, item)) {
      const auto* of = std::get_if<Vec3>(&known->second);
      const auto* list = std::get_if<LetList>(&known->second);
      if (c_.peek() != '[')
        return c_.fail(ErrorCode::type, fmt::format("'{}' is a list, not a number", name), name,
                       fmt::format("{}[1] is its first value", name));
      if (!of && !list)
        return c_.fail(ErrorCode::type, fmt::format("'{}' is not a list", name), name,
                       fmt::format("as in let {} = (2 3 5 7)", name));
      std::size_t at = 0;
      if (!index(name, of ? 3 : list->size(), at)) return false;
      if (of) return out = number((*of)[static_cast<int>(at)]), true;
      item = (*list)[at];
    }
    return quantity(item, name, out);
  }
  // Takes a number, or the component of a vector that follows.
  bool quantity(const LetItem& item, std::string_view name, Quantity& out) {
    if (const auto* q = std::get_if<Quantity>(&item)) {
      if (q->counts_frames) c_.frames_read = true;
      return out = *q, true;
    }
    const auto* v = std::get_if<Vec3>(&item);
    const bool part = c_.at + 1 < c_.end && *c_.at == '.' && c_.at[1] >= 'x' && c_.at[1] <= 'z' &&
                      !(c_.at + 2 < c_.end && name_goes_on(c_.at[2]));
    if (v && part) {
      out = number((*v)[c_.at[1] - 'x']);
      return c_.at += 2, true;
    }
    const char* const what = v ? "a vector" : std::holds_alternative<Text>(item) ? "a text" : "a colour";
    return c_.fail(ErrorCode::type, fmt::format("'{}' is {}, not a number", name, what), name,
                   v ? fmt::format("{0}.x, {0}.y and {0}.z are numbers", name) : std::string());
  }
  bool unknown(std::string_view name) {
    std::vector<std::string_view> words{"i", "n"};
    for (const auto& c : constants) words.push_back(c.first);
    for (const FunctionRow& f : function_rows) words.push_back(f.name);
    if (c_.lets)
      for (const auto& let : *c_.lets) words.push_back(let.first);
    Hint hint = did_you_mean(name, words);
    if (hint.empty()) hint = fmt::format("let {} = … makes one", name);
    return c_.fail(unknown_name("number", name, hint), name);
  }

  bool call(std::string_view name, Quantity& out) {
    const FunctionRow* const f = find_function(name);
    if (!f) {
      std::vector<std::string_view> words;
      for (const FunctionRow& row : function_rows) words.push_back(row.name);
      Hint hint = did_you_mean(name, words);
      if (hint.empty()) hint = fmt::format("functions are {}", fmt::join(words, " "));
      return c_.fail(ErrorCode::name, fmt::format("there is no function '{}' in formulas", name.substr(0, 40)), name,
                     hint);
    }
    const Deeper deeper(*this);
    if (too_deep() || !c_.open()) return false;
    ++inside_;
    Quantity a[most_arguments];
    std::size_t n = 0;
    for (c_.space(); c_.at < c_.end && c_.peek() != ')' && n < most_arguments; c_.space())
      if (!sum(a[n++])) return --inside_, false;
    --inside_;
    if (!c_.close()) return false;
    const std::string_view about(name.data(), static_cast<std::size_t>(c_.at - name.data()));
    if (n < f->least || n > f->most)
      return c_.fail(ErrorCode::type,
                     f->least == f->most
                         ? fmt::format("{} takes {} number{}, not {}", name, f->least, f->least == 1 ? "" : "s", n)
                         : fmt::format("{} takes {} to {} numbers, not {}", name, f->least, f->most, n),
                     about);
    return fits(*f, a, n, about) && (out = f->of(a, n), true);
  }
  bool fits(const FunctionRow& f, Quantity* a, std::size_t n, std::string_view about) {
    for (std::size_t i = 0; i < n; ++i) {
      if (a[i].of == Of::time) a[i] = in_seconds(a[i]);
      const bool share = f.name == "mix" && i == 2;
      const bool right = f.takes == FunctionRow::numbers || share ? a[i].of == Of::number
                         : f.takes == FunctionRow::turns          ? a[i].of == Of::number || a[i].of == Of::angle
                                                                  : a[i].of == a[0].of;
      if (right) continue;
      return c_.fail(
          ErrorCode::type,
          f.takes == FunctionRow::alike && !share
              ? fmt::format("{} takes numbers of one kind, not {} and {}", f.name, to_string(a[i].of),
                            to_string(a[0].of))
              : fmt::format("{} takes {}, not {}", f.name, f.takes == FunctionRow::turns ? "an angle" : "plain numbers",
                            to_string(a[i].of)),
          about);
    }
    return true;
  }

  Quantity in_seconds(Quantity q) const {
    q.value += q.frames / c_.rate.per_second();
    q.frames = 0;
    return q;
  }
  bool add(Quantity& a, const Quantity& b, char op) {
    if (a.of != b.of)
      return c_.fail(
          ErrorCode::type,
          fmt::format("{} and {} cannot be {}", to_string(a.of), to_string(b.of), op == '+' ? "added" : "subtracted"),
          about());
    const double sign = op == '+' ? 1 : -1;
    a.value += sign * b.value, a.frames += sign * b.frames;
    a.counts_frames = a.counts_frames || b.counts_frames;
    return true;
  }
  bool multiply(Quantity& a, Quantity b) {
    if (a.of == Of::number) std::swap(a, b);
    if (b.of != Of::number)
      return c_.fail(ErrorCode::type, fmt::format("{} cannot be multiplied by {}", to_string(a.of), to_string(b.of)),
                     about());
    a.value *= b.value, a.frames *= b.value;
    return true;
  }
  bool divide(Quantity& a, Quantity b, char op) {
    if (b.of == Of::time) {  // times can only be compared in seconds
      if (a.of == Of::time && a.value == 0 && b.value == 0)
        a.value = a.frames, b.value = b.frames, a.frames = b.frames = 0;  // both in frames
      else
        a = a.of == Of::time ? in_seconds(a) : a, b = in_seconds(b);
    }
    if (b.of != Of::number && a.of != b.of)
      return c_.fail(ErrorCode::type, fmt::format("{} cannot be divided by {}", to_string(a.of), to_string(b.of)),
                     about());
    if (b.value == 0) return c_.fail(ErrorCode::range, "this formula divides by zero", about());
    const bool share = b.of != Of::number;
    if (op == '%') {
      if (a.of == Of::time && !share) a = in_seconds(a);
      a.value = std::fmod(a.value, b.value);  // like Lua, to the last bit
      if (a.value * b.value < 0) a.value += b.value;
      return true;
    }
    a.value /= b.value, a.frames /= b.value;
    if (share) a = number(a.value);
    if (op == 'q') a.value = std::floor(a.value), a.frames = std::floor(a.frames);
    return true;
  }

  struct Deeper {
    Reader& r;
    explicit Deeper(Reader& reader) : r(reader) { ++r.depth_; }
    ~Deeper() { --r.depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
  };
  bool too_deep() {
    return depth_ > deepest &&
           !c_.fail(ErrorCode::range, fmt::format("a formula can be at most {} brackets deep", deepest), {start_, 1});
  }

  Cursor& c_;
  const char* const start_;
  int inside_ = 0, depth_ = 0;
};

}  // namespace

// Takes a cell of a table unless a formula continues.
static std::optional<LetItem> cell_here(Cursor& c) {
  Cursor ahead = c;
  LetItem item;
  if (!cell(ahead, item)) return c.error = ahead.error, c.where = ahead.where, std::nullopt;
  if (formula_goes_on(ahead.at, ahead.end)) return std::nullopt;
  c.at = ahead.at, c.cell_missing |= ahead.cell_missing;
  return item;
}

std::optional<LetItem> let_here(Cursor& c) {
  if (cell_begins(c)) return cell_here(c);
  if (!c.lets || c.lets->empty()) return std::nullopt;
  const std::string_view name = name_at(c.at, c.end);
  const auto known = name.empty() ? c.lets->end() : c.lets->find(name);
  if (known == c.lets->end()) return std::nullopt;
  Cursor ahead = c;
  ahead.at += name.size();
  LetItem item;
  if (ahead.peek() == '[') {
    const auto* list = std::get_if<LetList>(&known->second);
    std::size_t at = 0;
    if (!list) return std::nullopt;  // an index into a vector gives a number
    if (!Reader(ahead).index(name, list->size(), at)) {
      c.error = ahead.error, c.where = ahead.where;
      return std::nullopt;
    }
    item = (*list)[at];
  } else if (!single(known->second, item)) {
    return std::nullopt;
  }
  if (ahead.peek() == '.' || formula_goes_on(ahead.at, ahead.end) || name_goes_on(ahead.peek()) || ahead.peek() == '-')
    return std::nullopt;
  c.at = ahead.at;
  return item;
}

bool formula(Cursor& c, Quantity& out) { return Reader(c).whole(out); }

}  // namespace betwixt
