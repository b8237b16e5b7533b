// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/filter_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "betwixt/language.h"
#include "betwixt/track.h"
#include "commands/line_head.h"
#include "language/values.h"
#include "scene/document.h"
#include "track/filter.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

// Returns the place of the word `off` in a line; its size is 0 if the line does not have it.
Span off_in(std::string_view line) {
  std::string_view rest = without_comment(line);
  Span last;
  while (!rest.empty()) {
    const std::string_view piece = take_piece(rest);
    if (piece.empty()) break;
    if (piece == "off") last = {static_cast<std::size_t>(piece.data() - line.data()), piece.size()};
  }
  return last;
}

// Returns the end of what a line says, before spaces and a comment.
std::size_t end_of_words(std::string_view line) {
  std::size_t end = without_comment(line).size();
  while (end > 0 && line[end - 1] == ' ') --end;
  return end;
}

// The filters of a target that a text says, if no other line has made some.
class Search {
 public:
  Search(const Document& d, const std::string& text, const Target& on) : d_(d), on_(on), text_(text) {}

  std::vector<FilterLine> find() {
    if (text_.find("filter") == std::string::npos) return {};
    const ScriptText lines(text_);
    for (std::size_t i = 0; i < lines.count(); i = lines.behind(i)) {
      const std::string_view line = lines.line(i);
      if (line.find("filter") == std::string_view::npos || indented(line)) continue;
      const Span span{lines.start(i), line.size()};
      const bool comment = !line.empty() && line[0] == '#';
      const bool one = lines.behind(i) == i + 1;
      read(line.substr(comment_sign(line)), comment, one ? span : Span{});
    }
    return std::move(found_);
  }

 private:
  void read(std::string_view line, bool comment, Span span) {
    const LineHead head = line_head(line);
    if (!head.verb || head.verb->word != "filter" || !head.time.empty()) return;
    if (head.layer.empty() ? static_cast<bool>(on_.layer) : d_.find(head.layer) != on_.layer) return;
    const auto targets = find_targets(std::string(head.name), d_);
    if (!targets) return;
    const auto hit = std::ranges::find_if(
        *targets, [&](const Target& t) { return t.object == on_.object && t.function == on_.function && !t.velocity; });
    if (hit == targets->end()) return;
    std::string_view rest = head.rest;
    const std::string name(take_piece(rest));
    if (name == "none" && comment) return;
    if (name == "none") {
      std::erase_if(found_, [&](const FilterLine& f) { return hit->component < 0 || f.component == hit->component; });
      return;
    }
    FilterLine f;
    f.name = name, f.component = hit->component, f.comment = comment;
    f.words = std::string(without_comment(line));
    f.line = span, f.own = targets->size() == 1;
    f.off = comment || off_in(f.words).size > 0;
    if (comment && !known(name)) return;
    found_.push_back(std::move(f));
  }
  bool known(std::string_view name) const {
    return find_filter(name) || std::ranges::any_of(procedures(d_), [&](const ProcedureView& p) {
             return p.role == "filter" && p.name == name;
           });
  }

  const Document& d_;
  const Target on_;
  const std::string& text_;
  std::vector<FilterLine> found_;
};

// Returns the value of a parameter in a line; its size is 0 if the line does not have it.
Span value_of_key(std::string_view line, std::string_view key) {
  std::string_view rest = without_comment(line);
  const char* const begin = line.data();
  while (!rest.empty()) {
    const std::string_view piece = take_piece(rest);
    if (piece.empty()) break;
    const std::size_t sign = piece.find('=');
    if (sign == std::string_view::npos || piece.substr(0, sign) != key) continue;
    return {static_cast<std::size_t>(piece.data() - begin) + sign + 1, piece.size() - sign - 1};
  }
  return {};
}

// Returns the numbers of "(1 2 3)", or the text itself.
std::vector<std::string> numbers_in(std::string_view value) {
  if (!value.starts_with('(') || !value.ends_with(')')) return {std::string(value)};
  std::vector<std::string> all;
  std::string_view rest = value.substr(1, value.size() - 2);
  while (!rest.empty())
    if (const std::string_view piece = take_piece(rest); !piece.empty())
      all.emplace_back(piece);
    else
      break;
  return all;
}

std::string written_number(double v, const FilterParameter& p, bool angles) {
  return !std::isfinite(v) ? std::string()
         : p.time          ? write_seconds(from_seconds(v))
         : angles          ? write_angle(v)
                           : write_number(v);
}

}  // namespace

std::size_t comment_sign(std::string_view line) {
  std::size_t at = 0;
  while (at < line.size() && (line[at] == '#' || (at > 0 && line[at] == ' '))) ++at;
  return at;
}

std::vector<std::string> own_filter_lines(const Document& d, const Target& on) {
  const std::string all = write_besides(d, Target(on.object, on.function));
  const std::string head = layer_words(d, on) + "filter ";
  std::vector<std::string> lines;
  for (const std::size_t at : line_starts(all)) {
    std::string_view line = line_at(all, at);
    if (line.ends_with('\n')) line.remove_suffix(1);
    if (line.starts_with(head)) lines.emplace_back(line);
  }
  return lines;
}

std::vector<FilterLine> filter_lines(const Document& d, const std::string& text, const Target& on) {
  std::vector<FilterLine> found = Search(d, text, on).find();
  const std::vector<FilterView> there = filters(d, on);
  std::size_t k = 0;
  bool same = true;
  for (FilterLine& f : found) {
    f.index = k;
    if (f.comment) continue;
    same = same && k < there.size() && there[k].name == f.name && there[k].component == f.component &&
           there[k].off == f.off;
    ++k;
  }
  if (same && k == there.size()) return found;
  // The script makes them in another way: they have no lines of their own.
  found.clear();
  for (std::string& words : own_filter_lines(d, on)) {
    FilterLine f;
    f.index = found.size(), f.words = std::move(words);
    f.name = there[f.index].name, f.component = there[f.index].component, f.off = there[f.index].off;
    found.push_back(std::move(f));
  }
  return found;
}

std::vector<PartField> fields_of(const FilterLine& f, const FunctionSpec& of) {
  std::vector<PartField> fields;
  if (const FilterSpec* spec = find_filter(f.name)) {
    for (const FilterParameter& p : spec->parameters) {
      PartField field{.key = std::string(p.name), .numbers = {}, .unit = {}, .low = p.low, .high = p.high};
      const bool angles = p.value && row_of(f.component < 0 ? of.type : component_type(of.type)).angles;
      const Span value = value_of_key(f.words, p.name);
      field.numbers = value.size > 0 ? numbers_in(std::string_view(f.words).substr(value.at, value.size))
                                     : std::vector{written_number(p.rest, p, angles)};
      field.unit = p.time ? "s" : angles ? "deg" : "";
      if (angles || p.time) field.low = -1e300, field.high = 1e300;  // the field counts in another unit
      fields.push_back(std::move(field));
    }
    return fields;
  }
  std::string_view rest = without_comment(f.words);
  while (!rest.empty()) {
    const std::string_view piece = take_piece(rest);
    if (piece.empty()) break;
    const std::size_t sign = piece.find('=');
    if (sign == std::string_view::npos) continue;
    PartField field{.key = std::string(piece.substr(0, sign)), .numbers = numbers_in(piece.substr(sign + 1))};
    field.text = piece.substr(sign + 1).starts_with('"');
    fields.push_back(std::move(field));
  }
  return fields;
}

std::string with_parameter(std::string_view line, const std::string& key, const std::string& value) {
  const std::size_t sign = comment_sign(line);
  if (sign > 0) return std::string(line.substr(0, sign)) + with_parameter(line.substr(sign), key, value);
  std::string all(line);
  if (const Span there = value_of_key(line, key); there.size > 0) return all.replace(there.at, there.size, value);
  const Span off = off_in(line);
  return all.insert(off.size > 0 ? off.at - 1 : end_of_words(line), " " + key + "=" + value);
}

std::string with_off(std::string_view line, bool off) {
  std::string all(line);
  const Span there = off_in(line);
  if (off == (there.size > 0)) return all;
  return off ? all.insert(end_of_words(line), " off") : all.erase(there.at - 1, there.size + 1);
}

}  // namespace betwixt::studio
