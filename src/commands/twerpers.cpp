// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a twerper's word and the arguments in brackets that follow it.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "base/names.h"
#include "commands/command.h"
#include "commands/foreign_words.h"
#include "language/values.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

// Returns the twerpers and the other words that may follow a value, for suggestions.
std::vector<std::string_view> twerper_words(const Scene& s) {
  std::vector<std::string_view> words(twerper_names.begin() + 1, twerper_names.end());
  for (const char* w :
       {"release", "ease-in", "ease-out", "tangent", "tangent-in", "tangent-out", "handle-in", "handle-out", "cut"})
    words.push_back(w);
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == Role::twerper || p.role == Role::tween) words.push_back(p.name);
  return words;
}

// Reads a percentage, if one is next. `%` between two numbers belongs to a formula.
bool percentage(Cursor& c, std::optional<double>& out) {
  const char* const start = (c.space(), c.at);
  if (!starts_like_time(c.peek())) return true;
  const char* p = start + 1;
  while (p < c.end && (starts_like_time(*p) || *p == 'e' || *p == 'E')) ++p;
  if (p == c.end || *p != '%' || (p + 1 < c.end && !blank(p[1]) && p[1] != ')')) return true;
  double place = 0;
  if (!c.literal(place)) return false;
  if (c.at != p)
    return c.fail(ErrorCode::syntax, "this is not a percentage", {start, static_cast<std::size_t>(p - start)});
  ++c.at;
  if (!(std::abs(place) <= 1e6))
    return c.fail(ErrorCode::range, "the time of a stop must be from -1000000% to 1000000%", c.since(start));
  out = place;
  return true;
}

// Reads a stop: a share of the value, then one place in time or, if the value stays for a while, two.
bool stop(Cursor& c, std::vector<SaidStop>& all, std::optional<double>& latest) {
  const char* const start = (c.space(), c.at);
  std::optional<double> place;
  if (!percentage(c, place)) return false;
  if (place)
    return c.fail(ErrorCode::syntax,
                  all.empty() ? "write the percentage after its stop" : "a stop can have at most two percentages",
                  c.since(start), "as in linear(0 0.25 25% 75% 1)");
  SaidStop said;
  if (!c.number(said.value)) return false;
  if (const auto unit = c.unit(); !unit.empty())
    return c.fail(ErrorCode::type, fmt::format("a stop must be a plain number, without '{}'", unit), c.since(start));
  if (!(std::abs(said.value) <= 1e6))
    return c.fail(ErrorCode::range, "a stop must be from -1000000 to 1000000", c.since(start));
  all.push_back(said);
  for (int i = 0; i < 2; ++i) {
    const char* const at = (c.space(), c.at);
    if (!percentage(c, place = std::nullopt)) return false;
    if (!place) break;
    if (latest && *place < *latest)
      return c.fail(ErrorCode::range,
                    fmt::format("the percentages of stops must not go back: {}% is after {}%", write_number(*place),
                                write_number(*latest)),
                    c.since(at));
    if (i == 1) all.push_back(said);
    latest = all.back().place = place;
  }
  if (!latest) latest = 0;  // the first stop is at the beginning by default
  return true;
}

// Reads (0 0.25 25% 75% 1)
bool stops(Cursor& c, std::shared_ptr<const Stops>& out) {
  constexpr std::size_t most = 1000;
  const char* const start = c.at;
  if (!c.open()) return false;
  std::vector<SaidStop> all;
  std::optional<double> latest;
  for (c.space(); c.peek() != ')'; c.space()) {
    if (!stop(c, all, latest)) return false;
    if (all.size() > most)
      return c.fail(ErrorCode::range, fmt::format("linear can have at most {} stops", most), {start, 1});
  }
  if (!c.close()) return false;
  if (all.size() < 2)
    return c.fail(ErrorCode::syntax, "linear needs at least two stops in its brackets, or no brackets", c.since(start),
                  "as in linear(0 0.3 1)");
  out = std::make_shared<const Stops>(placed(all));
  return true;
}

// Reads the arguments in brackets after a twerper.
bool twerper_arguments(Cursor& c, Twerper t, std::string_view name, TwerperArguments& out) {
  const TwerperRow& row = row_of(t);
  c.space();
  const char* const start = c.at;
  if (row.stops) return c.peek() != '(' || stops(c, out.stops);
  if (row.arguments.empty())
    return c.peek() != '(' || c.fail_here(ErrorCode::syntax, fmt::format("'{}' takes no brackets", name));
  if (c.peek() != '(')
    return c.fail(ErrorCode::syntax,
                  t == Twerper::bezier ? "bezier needs its two control points"
                                       : fmt::format("{} needs {} in brackets", name, row.arguments[0].name),
                  name, fmt::format("as in {}", row.example.substr(row.example.rfind(' ', row.example.find('(')) + 1)));
  if (!c.open()) return false;
  for (std::size_t i = 0; i < row.arguments.size(); ++i) {
    const TwerperArgument& a = row.arguments[i];
    c.space();
    const char* const at = c.at;
    if (!c.number(out[i])) return false;
    if (out[i] >= a.low && out[i] <= a.high && (!a.whole || out[i] == std::floor(out[i]))) continue;
    if (t == Twerper::bezier && a.name[0] == 'x')
      return c.fail(ErrorCode::range, "the x of a bezier's control points must be from 0 to 1", c.since(start));
    return c.fail(ErrorCode::range,
                  fmt::format("{} must be {} from {} to {}", a.name, a.whole ? "a whole number" : "a number",
                              write_number(a.low), write_number(a.high)),
                  c.since(at));
  }
  c.space();
  if (!row.words.empty()) {
    double& which = out[row.arguments.size()] = 0;
    if (const std::string_view w = c.peek_word(); !w.empty()) {
      const auto known = std::find(row.words.begin(), row.words.end(), w);
      if (known == row.words.end())
        return c.fail(ErrorCode::syntax,
                      fmt::format("'{}' is not one of {}", w.substr(0, 40), fmt::join(row.words, ", ")), w);
      which = static_cast<double>(known - row.words.begin());
      c.word();
    }
  }
  return c.close();
}

// Returns our word for an easing of GSAP or CSS, such as power2.out or easeInOutQuad, or "".
std::string own_easing(std::string_view theirs, const std::vector<std::string_view>& ours) {
  constexpr std::pair<std::string_view, std::string_view> powers[] = {
      {"power1", "quad"}, {"power2", "cubic"}, {"power3", "quart"}, {"power4", "quint"}};
  std::string word(theirs.starts_with("ease") ? theirs.substr(4) : theirs);
  std::replace(word.begin(), word.end(), '.', '-');
  for (const auto& [power, family] : powers)
    if (word.starts_with(power)) {
      word.replace(0, power.size(), family);
      if (word == family) word += "-out";  // the usual way there
    }
  for (const std::string_view one : ours) {
    const std::size_t dash = one.find('-');
    if (dash == one.npos) continue;
    const std::string turned = std::string(one.substr(dash + 1)) + std::string(one.substr(0, dash));
    if (same_letters(word, one) || same_letters(word, turned)) return std::string(one);
  }
  return "";
}

}  // namespace

// Reads a twerper's word and the arguments in brackets that follow it.
bool twerper(Command& k, const Selected& to, Twerper& out, TwerperArguments& arguments) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view w = c.next_word();
  const auto found = find_twerper(w);
  const auto own = find_own_twerper(s, w);
  if (!found && own) {
    out = *own;
    std::string why;
    if (to.velocity && tween(s, out))
      return c.fail(ErrorCode::type, "a velocity cannot have a tween; its value can", w);
    return fits(s, out, to.type(), &why) || c.fail(ErrorCode::type, why, w);
  }
  if (!found) {
    if (w.empty()) return c.fail_here(ErrorCode::name, "a twerper is missing here");
    const std::vector<std::string_view> words = twerper_words(s);
    const std::string_view leads = foreign_word_hint(w);
    const std::string easing = own_easing(w, words);
    const Hint near = !easing.empty() ? correction(easing)
                      : leads.empty() ? did_you_mean(w, words)
                                      : Hint(std::string(leads));
    return c.fail(unknown_name("twerper", w, near.empty() && is_name(w) ? "if a plug-in has it: --load PLUGIN" : near),
                  w);
  }
  out = *found;
  std::string why;
  if (row_of(out).matches && to.type() == Type::text && to.spec->name != "text" && to.spec->name != "tex")
    return c.fail(ErrorCode::type, fmt::format("'match' is for text and tex, not for {}", to.spec->name), w);
  if (!fits(out, to.type(), &why))
    return c.fail(
        ErrorCode::type, why, w,
        to.type() == Type::text ? "to morph letters, use geometry: at 24f A.geometry shape(B) …; or write match" : "");
  return twerper_arguments(c, out, w, arguments);
}

// Reads an event's interpolation: [TWERPER] [ease-in=L] [ease-out=L] [tangent…=V] [handle…=(L V)] [for L].
bool way(Command& k, const Selected& to, Event& e, std::optional<Time>* lasts) {
  auto& [s, c, time, layer, script] = k;
  bool chosen = false;
  while (!c.at_line_end()) {
    const char* start = c.at;
    const std::string_view w = c.peek_word();
    const bool ease = w == "ease-in" || w == "ease-out";  // an option if a length follows, otherwise a twerper
    if (ease) {
      c.word(), c.space();
      if (starts_like_time(c.peek()))
        return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", w), fmt::format("as in {}=4f", w));
    }
    if (ease && c.peek() != '=') c.at = start;
    if (w == "ease" && c.at + w.size() < c.end && c.at[w.size()] == '=')
      return c.fail(ErrorCode::name, "there is no option 'ease'", w,
                    "ease-in=4f slows down before an event; ease-out=4f starts slowly after it");
    if (ease && c.accept('=')) {
      Time length;
      if (!c.length(length)) return false;
      if (length < Time{}) return c.fail(ErrorCode::range, "an ease must not be negative", c.since(start));
      (w == "ease-in" ? e.detail.edit().ease_in : e.detail.edit().ease_out) = length;
      continue;
    }
    if (w == "tangent" || w == "tangent-in" || w == "tangent-out") {
      c.word();
      if (!tangent(k, to, w, e)) return false;
      continue;
    }
    if (w == "handle-in" || w == "handle-out") {
      c.word();
      if (!handle(k, to, w, e)) return false;
      continue;
    }
    if (lasts && w == "for") {
      c.word();
      c.space();
      start = c.at;
      if (!c.lasting(lasts->emplace())) return false;
      if (**lasts <= Time{}) return c.fail(ErrorCode::range, "the length must be above 0", c.since(start));
      if (!chosen) e.twerper = *find_twerper(to.type() == Type::text ? "match" : "ease-in-out");
      return finish(c);
    }
    if (chosen)
      return c.fail_here(ErrorCode::syntax,
                         fmt::format("'{}' is not expected here: this event already has a twerper", w.substr(0, 40)));
    TwerperArguments arguments;
    if (!twerper(k, to, e.twerper, arguments)) return false;
    if (arguments != TwerperArguments{}) e.detail.edit().arguments = arguments;
    chosen = true;
  }
  return !e.keep || chosen || c.fail_here(ErrorCode::syntax, "'keep' needs a twerper, as in keep linear");
}

}  // namespace betwixt
