// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/names.h"
#include "language/formula_functions.h"
#include "language/values.h"

namespace betwixt {
namespace {

using namespace formulas;
constexpr int deepest = 100;

bool name_begins(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool name_goes_on(char c) { return name_begins(c) || (c >= '0' && c <= '9') || c == '_'; }
bool number_begins(const char* at, const char* end) {
  const auto digit = [&](const char* p) { return p < end && *p >= '0' && *p <= '9'; };
  return digit(at) || (at < end && *at == '.' && digit(at + 1));
}
std::string_view name_at(const char* at, const char* end) {
  const char* p = at;
  if (p < end && name_begins(*p))
    while (p < end && name_goes_on(*p)) ++p;
  return {at, static_cast<std::size_t>(p - at)};
}

// Sets `out` to the value of the name. Returns false if it is a list.
bool single(const Let& let, LetItem& out) {
  if (const auto* q = std::get_if<Quantity>(&let)) return out = *q, true;
  if (const auto* v = std::get_if<Vec3>(&let)) return out = *v, true;
  if (const auto* c = std::get_if<Color>(&let)) return out = *c, true;
  if (const auto* t = std::get_if<Text>(&let)) return out = *t, true;
  return false;
}

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
      return c_.fail(ErrorCode::type, fmt::format("a place in a list is a number, not {}", to_string(q.of)), about);
    if (!(q.value >= 1 && q.value <= static_cast<double>(count)) || q.value != std::floor(q.value))
      return c_.fail(ErrorCode::range,
                     fmt::format("'{}' has {} value{}: {}[1] is the first, there is no {}[{}]", name, count,
                                 count == 1 ? "" : "s", name, name, write_number(q.value)),
                     about, fmt::format("{0}[(i-1)%{1}+1] begins anew behind the last", name, count));
    return out = static_cast<std::size_t>(q.value) - 1, true;
  }

 private:
  std::string_view about() const { return c_.since(start_); }
  bool finite(const Quantity& q) {
    if (std::isfinite(q.value) && std::isfinite(q.frames)) return true;
    return c_.fail(ErrorCode::range, "this formula has no finite value", about());
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
      return c_.fail(ErrorCode::type, "only numbers are raised to a power, and by numbers", about());
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
    const std::string_view name = name_at(c_.at, c_.end);
    if (name.empty()) return c_.fail_here(ErrorCode::syntax, "a number or a name is missing in this formula");
    c_.at += name.size();
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
                     fmt::format("the pattern has no {} range that {} could count",
                                 name[1] == '1'   ? "first"
                                 : name[1] == '2' ? "second"
                                                  : "such",
                                 name),
                     name, "ranges are {1..10} and {a,b,c}; i counts all that a pattern names");
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
        return c_.fail(ErrorCode::type, fmt::format("'{}' is no list", name), name,
                       fmt::format("as in let {} = (2 3 5 7)", name));
      std::size_t at = 0;
      if (!index(name, of ? 3 : list->size(), at)) return false;
      if (of) return out = number((*of)[static_cast<int>(at)]), true;
      item = (*list)[at];
    }
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
                   v ? fmt::format("{0}.x, {0}.y and {0}.z are", name) : std::string());
  }
  bool unknown(std::string_view name) {
    std::vector<std::string_view> words{"i", "n"};
    for (const auto& c : constants) words.push_back(c.first);
    for (const FunctionRow& f : function_rows) words.push_back(f.name);
    if (c_.lets)
      for (const auto& let : *c_.lets) words.push_back(let.first);
    std::string hint = did_you_mean(name, words);
    if (hint.empty()) hint = fmt::format("let {} = … makes one", name);
    return c_.fail(ErrorCode::name, fmt::format("there is no number '{}'", name.substr(0, 40)), name, hint);
  }

  bool call(std::string_view name, Quantity& out) {
    const FunctionRow* const f = find_function(name);
    if (!f) {
      std::vector<std::string_view> words;
      for (const FunctionRow& row : function_rows) words.push_back(row.name);
      std::string hint = did_you_mean(name, words);
      if (hint.empty()) hint = fmt::format("functions are {}", fmt::join(words, " "));
      return c_.fail(ErrorCode::name, fmt::format("formulas have no function '{}'", name.substr(0, 40)), name, hint);
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
              ? fmt::format("{} takes numbers of one kind, not {} beside {}", f.name, to_string(a[i].of),
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
           !c_.fail(ErrorCode::range, fmt::format("formulas go at most {} deep", deepest), {start_, 1});
  }

  Cursor& c_;
  const char* const start_;
  int inside_ = 0, depth_ = 0;
};

// Returns whether the body of braces is one formula, such as {i} or {n-i+1}, and not a list.
bool formula_in_braces(std::string_view body) {
  return body.find(',') == body.npos && body.find("..") == body.npos &&
         speaks_of_place(body.data(), body.data() + body.size());
}

// A word including its braces, and whether it has a dot outside them, like a target.
struct BraceWord {
  std::string_view text;
  bool braces = false, dotted = false;
};
BraceWord brace_word(std::string_view rest) {
  BraceWord out;
  int depth = 0;
  std::size_t at = 0;
  for (; at < rest.size() && (depth > 0 || std::string_view(" \t\r\n,()=\"@").find(rest[at]) == rest.npos); ++at) {
    if (rest[at] == '\n') break;
    if (rest[at] == '{') ++depth, out.braces = true;
    if (rest[at] == '}') --depth;
    out.dotted = out.dotted || (rest[at] == '.' && depth == 0);
  }
  out.text = rest.substr(0, at);
  return out;
}

}  // namespace

std::optional<LetItem> let_here(Cursor& c) {
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

bool one_name(Cursor& c, std::string_view word, std::string& out) {
  out = word;
  if (word.find('{') == word.npos) return true;
  // Formulas are replaced first, and then the lists are written out: rocket{i}-{1..3}.
  for (std::size_t open = 0; (open = out.find('{', open)) != out.npos;) {
    const std::size_t close = out.find('}', open);
    const std::string_view body = std::string_view(out).substr(open + 1, close == out.npos ? close : close - open - 1);
    if (close == out.npos || !formula_in_braces(body)) {
      ++open;
      continue;
    }
    const std::string kept(body);
    Cursor inner = c;
    inner.at = kept.data(), inner.end = kept.data() + kept.size();
    inner.error.reset();
    Quantity q;
    if (!formula(inner, q) || inner.at != inner.end)
      return c.fail(inner.error ? inner.error->code : ErrorCode::syntax,
                    inner.error ? inner.error->message : fmt::format("'{}' is no formula", kept), word,
                    inner.error ? inner.error->hint : std::string());
    if (q.of != Of::number || q.value != std::floor(q.value) || std::abs(q.value) > 1e15)
      return c.fail(q.of == Of::number ? ErrorCode::range : ErrorCode::type,
                    fmt::format("{{{}}} in a name is a whole number, not {}", kept, write_quantity(q)), word);
    out.replace(open, close - open + 1, write_number(q.value));
  }
  if (out.find('{') == out.npos) return true;
  const auto names = expand_braces(out);
  if (!names) return c.fail(names.error().code, names.error().message, word, names.error().hint);
  if (names->size() != c.place.n)
    return c.fail(ErrorCode::range,
                  fmt::format("'{}' names {}, and the command is about {}: one for one they are as many",
                              word.substr(0, 60), names->size(), c.place.n),
                  word, "one name serves all; {i} is the place among what the command is about, 1, 2 …");
  out = (*names)[c.place.i - 1];
  return true;
}

bool writes_out_names(std::string_view line) {
  if (line.substr(0, line.find('\n')).find('{') == line.npos) return false;
  bool quoted = false;
  for (std::size_t at = 0; at < line.size() && line[at] != '\n';) {
    if (line[at] == '"' && (at == 0 || line[at - 1] != '\\')) quoted = !quoted;
    const bool comment = line[at] == '#' && (at + 1 == line.size() || line[at + 1] == ' ' || line[at + 1] == '\t');
    if (comment && !quoted) return false;
    const BraceWord word = quoted ? BraceWord() : brace_word(line.substr(at));
    if (word.braces && !word.dotted) return true;
    at += std::max<std::size_t>(word.text.size(), 1);
  }
  return false;
}

std::string_view to_string(Of of) {
  static constexpr std::string_view words[] = {"a number", "an angle", "a length", "a time"};
  return words[static_cast<std::size_t>(of)];
}

bool formula_goes_on(const char* at, const char* end) {
  if (at >= end || std::string_view("+-*/%^").find(*at) == std::string_view::npos) return false;
  if (++at < end && at[-1] == '/' && *at == '/') ++at;
  while (at < end && (*at == '-' || *at == '+')) ++at;
  return at < end && (*at == '(' || name_begins(*at) || number_begins(at, end));
}

bool formula_begins(const Cursor& c) {
  const char* at = c.at;
  while (at < c.end && (*at == '-' || *at == '+')) ++at;
  if (at < c.end && *at == '(') return true;
  const std::string_view name = name_at(at, c.end);
  if (name.empty()) return false;
  const char* const behind = name.data() + name.size();
  return is_formula_word(name) || (c.lets && c.lets->contains(name)) || (behind < c.end && *behind == '(') ||
         formula_goes_on(behind, c.end);
}

bool formula(Cursor& c, Quantity& out) { return Reader(c).whole(out); }

bool speaks_of_place(const char* at, const char* end) {
  static constexpr auto in_name = [] {
    std::array<bool, 256> all{};
    for (int c = 0; c < 256; ++c)
      all[static_cast<std::size_t>(c)] =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    return all;
  }();
  const auto part = [](char c) { return in_name[static_cast<unsigned char>(c)]; };
  const char* const from = at;
  bool quoted = false;
  int depth = 0;
  for (; at < end; ++at) {
    if (*at == '"' && (at == from || at[-1] != '\\')) quoted = !quoted;
    if (*at == '\n' && depth <= 0 && !quoted) break;
    if (quoted) continue;
    depth += (*at == '(') - (*at == ')');
    if (!part(*at)) continue;
    const char* const word = at;
    while (at + 1 < end && part(at[1])) ++at;
    const std::size_t length = static_cast<std::size_t>(at + 1 - word);
    if (length > 2 || (*word != 'i' && *word != 'n')) continue;
    if (length == 2 && (*word != 'i' || word[1] < '1' || word[1] > '4')) continue;
    const char before = word > from ? word[-1] : ' ', behind = at + 1 < end ? at[1] : ' ';
    // Two dots belong to a segment; a single one separates an object from its function.
    const bool one_before = before == '.' && !(word - from > 1 && word[-2] == '.');
    const bool one_behind = behind == '.' && !(end - at > 2 && at[2] == '.');
    if (!one_before && !one_behind && std::string_view(" \t,=([{+-*/%^.").find(before) != std::string_view::npos &&
        std::string_view(" \t\r\n,)]}+-*/%^.").find(behind) != std::string_view::npos)
      return true;
  }
  return false;
}

std::string near_name(const Cursor& c, std::string_view word) {
  std::vector<std::string_view> names;
  if (c.lets)
    for (const auto& let : *c.lets) names.push_back(let.first);
  return did_you_mean(word, names);
}

bool is_formula_word(std::string_view word) {
  const bool place =
      word == "i" || word == "n" || (word.size() == 2 && word[0] == 'i' && word[1] >= '1' && word[1] <= '9');
  return place || find_function(word) ||
         std::any_of(std::begin(constants), std::end(constants), [&](const auto& c) { return c.first == word; });
}

std::string write_let(const LetItem& item) {
  if (const auto* q = std::get_if<Quantity>(&item)) return write_quantity(*q);
  if (const auto* v = std::get_if<Vec3>(&item)) return write_vector(*v);
  if (const auto* t = std::get_if<Text>(&item)) return write_text(**t);
  return write_color(std::get<Color>(item));
}

std::string write_let(const Let& let) {
  if (LetItem item; single(let, item)) return write_let(item);
  std::string out;
  for (const LetItem& item : std::get<LetList>(let)) out += (out.empty() ? "(" : " ") + write_let(item);
  return out + ")";
}

std::string write_quantity(const Quantity& q) {
  if (q.of != Of::time) {
    static constexpr std::string_view units[] = {"", "deg", "m"};
    return write_number(q.value) + std::string(units[static_cast<std::size_t>(q.of)]);
  }
  if (!q.counts_frames) return write_number(q.value) + "s";
  std::string out = write_number(q.frames) + "f";
  if (q.value != 0) out += (q.value > 0 ? "+" : "") + write_number(q.value) + "s";
  return out;
}

}  // namespace betwixt
