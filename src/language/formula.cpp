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

class Reader {
 public:
  explicit Reader(Cursor& c) : c_(c), start_(c.at) {}

  bool whole(Quantity& out) {
    if (!sum(out)) return false;
    return finite(out);
  }

 private:
  std::string_view about() const { return c_.since(start_); }
  bool finite(const Quantity& q) {
    if (std::isfinite(q.value) && std::isfinite(q.frames)) return true;
    return c_.fail(ErrorCode::range, "this formula has no finite value", about());
  }
  // Inside brackets blanks may stand on both sides of an operator, or on neither: (1 - 2), (1-2), but (1 -2) are two.
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
    if (const auto* q = std::get_if<Quantity>(&known->second)) {
      if (q->counts_frames) c_.frames_read = true;
      return out = *q, true;
    }
    const auto* v = std::get_if<Vec3>(&known->second);
    const bool part = c_.at + 1 < c_.end && *c_.at == '.' && c_.at[1] >= 'x' && c_.at[1] <= 'z' &&
                      !(c_.at + 2 < c_.end && name_goes_on(c_.at[2]));
    if (v && part) {
      out = number((*v)[c_.at[1] - 'x']);
      return c_.at += 2, true;
    }
    return c_.fail(ErrorCode::type, fmt::format("'{}' is {}, not a number", name, v ? "a vector" : "a colour"), name,
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
    if (b.of == Of::time) {  // only seconds can be compared
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
      a.value = std::fmod(a.value, b.value);  // as Lua does, to the last bit
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

}  // namespace

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
    // Two dots are a segment's, one is between an object and its function.
    const bool one_before = before == '.' && !(word - from > 1 && word[-2] == '.');
    const bool one_behind = behind == '.' && !(end - at > 2 && at[2] == '.');
    if (!one_before && !one_behind && std::string_view(" \t,=(+-*/%^.").find(before) != std::string_view::npos &&
        std::string_view(" \t\r\n,)+-*/%^.").find(behind) != std::string_view::npos)
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

std::string write_let(const Let& let) {
  if (const auto* q = std::get_if<Quantity>(&let)) return write_quantity(*q);
  if (const auto* v = std::get_if<Vec3>(&let)) return write_vector(*v);
  return write_color(std::get<Color>(let));
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
