// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits of the parts of a value, as lines.
#include <fmt/format.h>

#include <algorithm>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "betwixt/session.h"
#include "commands/line_head.h"
#include "editor/made_by.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/panels/filter_lines.h"
#include "studio/panels/value_parts.h"
#include "syntax/texts.h"

namespace betwixt::studio {
namespace {

using What = ValuePart::What;

// "0.5", "(1 2 3)"
std::string together(const std::vector<std::string>& numbers) {
  return numbers.size() == 1 ? numbers[0] : fmt::format("({})", fmt::join(numbers, " "));
}

std::string part_of_text(const std::string& text, Span s) { return text.substr(s.at, s.size); }

// A whole line with its line feed.
Span whole_line(const std::string& text, Span line) {
  const std::size_t before = line.at == 0 ? std::string::npos : text.rfind('\n', line.at - 1);
  const std::size_t from = before == std::string::npos ? 0 : before + 1;
  const std::size_t feed = text.find('\n', line.end() > from ? line.end() - 1 : from);
  return {from, (feed == std::string::npos ? text.size() : feed + 1) - from};
}

// Writes all filters of a target anew, at the end of the script: `change` gets each line and its index.
template <class F>
Lines filters_anew(const Document& d, Target on, F&& change) {
  on.component = -1;
  Lines lines{fmt::format("{}filter {} none", layer_words(d, on), d.name(on))};
  const std::vector<std::string> all = own_filter_lines(d, on);
  for (std::size_t i = 0; i < all.size(); ++i) change(all[i], i, lines);
  return lines;
}

std::string value_words(const Document& d, const Target& t, const std::vector<std::string>& numbers) {
  const bool angles = spec_of(d.scene(), t.function).type == Type::rotation && numbers.size() == 3;
  return (angles ? "euler" : "") + together(numbers);
}

// A layer whose tracks are all of one function of one object.
bool only_here(const Document& d, const Target& on) {
  for (const ObjectId id : objects(d))
    for (const Slot& slot : d.scene().objects[id.index].slots)
      if (slot.layer == on.layer && (id != on.object || slot.function != on.function)) return false;
  return true;
}

// Returns the line that takes everything about a layer out of a text.
std::string without_layer(const std::string& text, const std::string& name) {
  const ScriptText lines(text);
  std::string kept;
  std::size_t first = text.size(), last = 0;
  bool below = false;  // the rows of a sheet about it follow
  for (std::size_t i = 0; i < lines.count(); i = lines.behind(i)) {
    const std::size_t at = lines.start(i);
    const std::size_t end = lines.behind(i) < lines.count() ? lines.start(lines.behind(i)) : text.size();
    const std::string_view line = std::string_view(text).substr(at, end - at);
    const LineHead head = line_head(line);
    if (!indented(line) && !empty_line(line)) {
      const auto is_of = [&](std::string_view word) { return word.starts_with(name + "."); };
      const bool makes = head.verb && head.verb->word == "layer" && head.name == name;
      below = makes || head.layer == name || is_of(head.word) || (head.verb && is_of(head.name));
      if (below) first = std::min(first, at), last = end;
    } else if (below && indented(line)) {
      last = end;
    }
    const bool goes = below && (indented(line) || !empty_line(line));
    if (first < text.size() && !goes) kept += line;
  }
  if (first >= last) return {};
  kept.resize(kept.size() - (text.size() - last));  // what is behind the last line stays as it is
  return Session::rewrite_line(line_number(text, first), line_number(text, last - 1), kept);
}

Lines remove_layer(const Document& d, const std::string& text, const ValuePart& part) {
  if (only_here(d, part.target)) {
    const std::string name = d.name(part.target.layer);
    const std::string line = without_layer(text, name);
    return {line.empty() ? "remove " + name : line};
  }
  Lines lines;
  for (const TrackView& t : tracks_on(d, part.target.layer))
    if (t.target.object == part.target.object && t.target.function == part.target.function && t.event_count > 0)
      lines.push_back(fmt::format("{}clear {} {}..{}", layer_words(d, t.target), d.name(t.target),
                                  format_time(t.first, d), format_time(t.last, d)));
  if (!filters(d, part.target).empty())
    lines.push_back(fmt::format("{}filter {} none", layer_words(d, part.target), d.name(part.target)));
  return lines;
}

}  // namespace

int line_number(const std::string& text, std::size_t place) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

std::string rewriting_line(const std::string& text, Span span, std::string_view by) {
  const Span lines = whole_line(text, span);
  std::string others = text.substr(lines.at, span.at - lines.at);
  others += by;
  others += text.substr(span.end(), lines.end() - span.end());
  // Between other lines, `rewrite` ends the last line itself.
  if (lines.end() < text.size() && others.size() > 1) others.pop_back();
  const int first = line_number(text, span.at);
  return Session::rewrite_line(first, line_number(text, span.size > 0 ? span.end() - 1 : span.at), others);
}

Lines change_part(const Document& d, const std::string& text, const ValuePart& part, const PartField& field,
                  std::size_t number, const std::string& typed, Time at) {
  if (number >= field.numbers.size() || (typed.empty() && !field.text)) return {};
  std::vector<std::string> numbers = field.numbers;
  numbers[number] = typed;
  const Target& t = part.target;
  switch (part.what) {
    case What::set:
      return {"set " + d.name(t) + " " + value_words(d, t, numbers)};
    case What::code:
      if (!part.keys.empty())
        return {fmt::format("at {} {} = {}", format_time(part.keys[0].time, d), d.name(t), write_text(typed))};
      if (part.own) return {rewriting_line(text, part.lines, "= " + write_text(typed))};
      return {"set " + d.name(t) + " = " + write_text(typed)};
    case What::events:
      return {};
    case What::velocity:
      return {line_of_event(d, t, at, value_words(d, t, numbers))};
    case What::layer: {
      if (field.key.empty()) return {layer_words(d, t) + line_of_event(d, t, at, value_words(d, t, numbers))};
      for (const LayerView& l : layers(d))
        if (l.id == t.layer) return {line_that_sets(d, l.weight, at, typed)};
      return {};
    }
    case What::filter: {
      const std::string value = field.text ? write_text(typed) : together(numbers);
      if (part.own)
        return {rewriting_line(text, part.lines, with_parameter(part_of_text(text, part.lines), field.key, value))};
      return filters_anew(d, t, [&](const std::string& line, std::size_t i, Lines& lines) {
        lines.push_back(i == part.index ? with_parameter(line, field.key, value) : line);
      });
    }
  }
  return {};
}

Lines remove_part(const Document& d, const std::string& text, const ValuePart& part) {
  const auto clear = [&]() -> Lines {
    if (part.keys.empty()) return {};
    const std::string first = format_time(part.keys.front().time, d), last = format_time(part.keys.back().time, d);
    return {fmt::format("clear {} {}", d.name(part.target), first == last ? first : first + ".." + last)};
  };
  switch (part.what) {
    case What::set:
    case What::code: {
      if (!part.keys.empty()) return clear();
      if (!part.own) return {};
      const Span line = whole_line(text, part.lines);
      const bool alone = line_head(std::string_view(text).substr(line.at, line.size)).word == "set";
      return alone ? Lines{rewriting_line(text, line, "")} : Lines();
    }
    case What::events:
    case What::velocity:
      return clear();
    case What::layer:
      return remove_layer(d, text, part);
    case What::filter:
      if (part.own) return {rewriting_line(text, whole_line(text, part.lines), "")};
      return filters_anew(d, part.target, [&](const std::string& line, std::size_t i, Lines& lines) {
        if (i != part.index) lines.push_back(line);
      });
  }
  return {};
}

Lines switch_part(const Document& d, const std::string& text, const ValuePart& part) {
  if (part.what != What::filter || (part.comment && !part.own)) return {};
  if (!part.own)
    return filters_anew(d, part.target, [&](const std::string& line, std::size_t i, Lines& lines) {
      lines.push_back(i == part.index ? with_off(line, !part.off) : line);
    });
  const std::string line = part_of_text(text, part.lines);
  return {rewriting_line(text, part.lines, part.comment ? line.substr(comment_sign(line)) : with_off(line, !part.off))};
}

// The filters between both places keep their order and move by one. Their lines exchange places; what is between the
// lines stays there.
Lines move_part(const Document& d, const std::string& text, const std::vector<ValuePart>& parts, std::size_t from,
                std::size_t to) {
  const auto [first, last] = std::minmax(from, to);
  if (first == last || last >= parts.size()) return {};
  const std::vector<ValuePart> there(parts.begin() + static_cast<std::ptrdiff_t>(first),
                                     parts.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  for (const ValuePart& p : there)
    if (p.what != What::filter || p.target.layer != there[0].target.layer) return {};
  std::vector<ValuePart> then = there;
  from < to ? std::ranges::rotate(then, then.begin() + 1) : std::ranges::rotate(then, then.end() - 1);
  const auto any = [&](auto is) { return std::ranges::any_of(there, is); };
  if (any([](const ValuePart& p) { return !p.own; })) {
    if (any(&ValuePart::comment)) return {};
    const std::vector<std::string> all = own_filter_lines(d, there[0].target);
    return filters_anew(d, there[0].target, [&](const std::string& line, std::size_t i, Lines& lines) {
      const std::size_t k = i - there[0].index;  // beyond the end if it stays
      lines.push_back(k < then.size() ? all[then[k].index] : line);
    });
  }
  std::string anew;
  for (std::size_t i = 0; i < there.size(); ++i) {
    anew += part_of_text(text, then[i].lines);
    if (i + 1 < there.size()) anew += text.substr(there[i].lines.end(), there[i + 1].lines.at - there[i].lines.end());
  }
  return {rewriting_line(text, {there[0].lines.at, there.back().lines.end() - there[0].lines.at}, anew)};
}

}  // namespace betwixt::studio
