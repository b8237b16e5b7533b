// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/text_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/names.h"
#include "betwixt/language.h"
#include "editor/describe.h"
#include "editor/help.h"
#include "editor/named_objects.h"
#include "language/formula.h"
#include "language/values.h"
#include "scene/colors.h"
#include "scene/document.h"
#include "scene/names.h"
#include "syntax/texts.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr std::size_t most_named = 20;  // names of a pattern in the hover text

// Returns the token at a place.
std::optional<LinePiece> piece_at(const ScriptText& lines, std::size_t place, const Document& d) {
  const std::size_t number = lines.line_of(place), in_line = place - lines.start(number);
  LineState state = lines.state_above(number);
  std::optional<LinePiece> found;
  for (const LinePiece& p : line_pieces(lines.line(number), state, d, is_row(lines, number)))
    if (p.at <= in_line && in_line <= p.at + p.length) found = p;
  return found;
}

std::string said_of_pattern(const std::string& pattern, const Document& d) {
  const std::vector<ObjectId> all = select(d.scene(), pattern);
  std::string said = fmt::format("{}, a pattern: {}\n", pattern, counted(all.size(), "object"));
  for (std::size_t i = 0; i < std::min(all.size(), most_named); ++i) said += fmt::format("  {}\n", d.name(all[i]));
  return all.size() > most_named ? said + fmt::format("  … {} more\n", all.size() - most_named) : said;
}

std::string said_of_name(const NameAt& name, const Document& d) {
  const Scene& s = d.scene();
  if (name.pattern) return said_of_pattern(name.name, d);
  if (name.kind == NameKind::let) {
    const auto value = s.lets->find(name.name);
    return value == s.lets->end() ? "" : fmt::format("{} = {}\n", name.name, write_let(value->second));
  }
  if (name.kind != NameKind::thing) return help_text(name.name, s);
  if (const auto alias = s.aliases->find(name.name); alias != s.aliases->end())
    return fmt::format("{}, an alias: {}\n", name.name, fmt::join(alias->second, " "));
  const Result<std::string> described = describe(d, name.name);
  return described ? *described : "";
}

// Returns the word around a place; it ends where a name would.
Span word_around(std::string_view line, std::size_t place) {
  const auto ends = [](char c) { return ends_word(c) || std::string_view(".{}[]*").find(c) != std::string_view::npos; };
  std::size_t from = place, to = place;
  while (from > 0 && !ends(line[from - 1])) --from;
  while (to < line.size() && !ends(line[to])) ++to;
  return {from, to - from};
}

std::string said_of_time(std::string_view word, const Document& d) {
  const auto t = parse_time(word, d);
  if (!t) return {};
  std::vector<std::string> ways{format_time(*t, d), write_seconds(*t)};
  ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
  std::erase(ways, word);
  return ways.empty() ? "" : fmt::format("{} is {}\n", word, fmt::join(ways, ", "));
}

// Returns the line after the rows and the block below a line; trailing empty lines are not counted.
std::size_t behind_rows(const ScriptText& lines, std::size_t opener) {
  const std::size_t margin = indentation(lines.line(opener));
  std::size_t end = lines.behind(opener);
  for (std::size_t i = end; i < lines.count(); i = lines.behind(i)) {
    if (empty_line(lines.line(i))) continue;
    if (indentation(lines.line(i)) <= margin) break;
    end = lines.behind(i);
  }
  return end;
}

bool opens_any(std::string_view line) {
  const LineHead head = line_head(line);
  return opens(head) != Opens::nothing || opens_block(head);
}

}  // namespace

std::optional<Hover> hover_at(const TextNames& names, const FilmText& in, std::size_t text, std::size_t place,
                              const Document& d) {
  const ScriptText& lines = in.lines;
  if (const auto name = names.at(text, place))
    if (std::string said = said_of_name(*name, d); !said.empty()) return Hover{name->span, std::move(said)};
  const auto piece = piece_at(lines, place, d);
  if (!piece || piece->meaning == Meaning::comment || piece->meaning == Meaning::text) return std::nullopt;
  const std::size_t number = lines.line_of(place), from = lines.start(number);
  const std::string_view line = lines.line(number);
  const Span there = word_around(line, place - from);
  const std::string_view word = line.substr(there.at, there.size);
  if (piece->meaning == Meaning::time) {
    const std::string_view whole = line.substr(piece->at, piece->length);
    if (std::string said = said_of_time(whole, d); !said.empty())
      return Hover{{from + piece->at, piece->length}, std::move(said)};
    if (const auto spoken = time_at(line, place - from, d))  // of voice:"the square"
      return Hover{{from + piece->at, piece->length},
                   fmt::format("{} is at {}, {}\n", whole, write_seconds(*spoken), format_time(*spoken, d))};
  }
  const auto is_function = [&](const HelpEntry& e) { return e.word != word || e.group == HelpGroup::function; };
  if (piece->meaning == Meaning::option && std::ranges::all_of(help_entries(), is_function)) return std::nullopt;
  std::string said = help_text(word, d.scene(), kind_at(line.substr(0, there.at + there.size), d));
  if (said.empty()) return std::nullopt;
  return Hover{{from + there.at, there.size}, std::move(said)};
}

std::optional<Usage> usage_at(const ScriptText& lines, std::size_t place) {
  const std::size_t number = lines.first_of(lines.line_of(place));
  const LineHead head = line_head(lines.line(number));
  const HelpGroup group = is_row(lines, number) ? HelpGroup::row : HelpGroup::verb;
  for (const HelpEntry& e : help_entries())
    if (e.group == group && e.word == head.word) return Usage{e.usage, e.sentence};
  return std::nullopt;
}

std::optional<std::string> used_at(const ScriptText& lines, std::size_t place) {
  const std::size_t number = lines.line_of(place);
  const std::string_view line = lines.line(number);
  if (lines.state_above(number).goes_on() || is_row(lines, number)) return std::nullopt;
  Cursor c(line);
  if (c.next_word() != "use") return std::nullopt;
  c.space();
  const char* const from = c.at;
  std::string file;
  if (c.peek() == '"' ? !c.text(file) : (file = c.word()).empty()) return std::nullopt;
  const char* const there = lines.text().data() + place;
  return there >= from && there <= c.at ? std::optional(file) : std::nullopt;
}

Completions completions_at(const ScriptText& lines, std::size_t place, const Document& d,
                           const std::filesystem::path& folder) {
  const std::size_t number = lines.line_of(place), first = lines.first_before(place), start = lines.start(first);
  const std::size_t in_line = place - lines.start(number);
  Completions out{place, {}, {}};
  const auto token = lines.token_at(number, in_line - (in_line > 0));  // of the byte before
  if (token && token->kind == TokenKind::comment) return out;
  const bool text = token && token->kind == TokenKind::text && in_line > token->at;
  const bool words = text && token->at > 0 && lines.line(number)[token->at - 1] == ':';  // voice:"the sq
  if (text && !words && (in_line < token->end() || !token->closed)) return out;
  std::string line = lines.text().substr(start, place - start);
  std::ranges::replace(line, '\n', ' ');
  LineAround around{.folder = folder};
  if (const std::size_t opener = opener_of(lines, first); opener < lines.count()) {
    const LineHead head = line_head(lines.line(opener));
    around.sheet_open = true, around.list = opens(head) == Opens::list;
    if (!around.list) around.sheet = head.word;
  }
  out.from = start + begun_word(line);
  out.words = completions(line, d, around);
  if (words && token->closed && in_line < token->end())  // the quote is there already
    for (std::string& word : out.words) word.pop_back();
  out.kind = kind_at(line, d);
  return out;
}

std::vector<TextSymbol> symbols(const ScriptText& lines) {
  std::vector<TextSymbol> all;
  Indentation indentation;
  for (std::size_t i = 0; i < lines.count(); i = lines.behind(i)) {
    const std::string_view line = lines.line(i);
    if (empty_line(line) || indentation.row(line)) continue;
    const auto made = making(line);
    const bool sheet = opens_any(line);
    if (!made && !sheet) continue;
    const std::size_t end = sheet ? behind_rows(lines, i) : lines.behind(i);
    const std::size_t stop = lines.start(end - 1) + lines.line(end - 1).size();
    TextSymbol symbol{{}, {}, {}, {}, {lines.start(i), stop - lines.start(i)}};
    std::string_view word;
    const LineHead head = line_head(line);
    if (opens_block(head)) {
      word = head.name, symbol.detail = head.word;
    } else if (made) {
      const std::string_view kind = kind_word(head);
      word = made->word, symbol.made = made->kind;
      symbol.detail = kind.empty() ? made->verb : kind;
    } else {
      word = head.word;
    }
    if (word.empty()) continue;
    symbol.name = word;
    symbol.word = {static_cast<std::size_t>(word.data() - lines.text().data()), word.size()};
    all.push_back(std::move(symbol));
  }
  return all;
}

std::vector<Fold> folds(const ScriptText& lines) {
  std::vector<Fold> all;
  const auto put = [&](std::size_t first, std::size_t end, bool remark) {
    if (end > first + 1) all.push_back({first, end - 1, remark});
  };
  for (std::size_t i = 0; i < lines.count();) {
    const std::string_view line = lines.line(i);
    std::size_t end = lines.behind(i);
    const bool remark = lines.only_comment(i);
    if (remark)
      while (end < lines.count() && lines.only_comment(end)) ++end;
    else if (opens_any(line))
      end = behind_rows(lines, i);
    put(i, end, remark);
    i = opens_block(line) ? lines.behind(i) : end;  // its lines may have rows of their own
  }
  return all;
}

std::string tidied_in(const ScriptText& lines, Span part) {
  // Where a block is touched, it is tidied as a whole.
  const auto sheet_or_line = [&](std::size_t line) {
    std::size_t opener = block_of(lines, line);
    if (opener == lines.count()) opener = opener_of(lines, line);
    while (opener < lines.count() && block_of(lines, opener) < lines.count()) opener = block_of(lines, opener);
    return opener < lines.count() ? opener : lines.first_of(line);
  };
  const std::size_t last = lines.line_of(part.size > 0 ? part.end() - 1 : part.at);
  const std::size_t first = sheet_or_line(lines.line_of(part.at));
  std::size_t end = behind_rows(lines, sheet_or_line(last));
  end = std::max(end, lines.behind(last));
  while (end > first && empty_line(lines.line(end - 1)) && !lines.only_comment(end - 1)) --end;
  // Rows are sorted by time, so tidy needs the frame rate and the ticks from above.
  std::string above = as_comment("");
  for (std::size_t i = 0; i < first; ++i) {
    const std::string_view word = first_word(lines.line(i));
    if (word == "rate" || word == "ticks" || word == "use") above += std::string(lines.line(i)) + "\n";
  }
  const std::string& text = lines.text();
  const std::size_t from = lines.start(first), to = end < lines.count() ? lines.start(end) : text.size();
  const std::string known = tidy(above), both = tidy(above + text.substr(from, std::max(from, to) - from));
  if (!both.starts_with(known)) return text;
  return text.substr(0, from) + both.substr(known.size()) + text.substr(std::max(from, to));
}

std::vector<ColorAt> colors_in(const ScriptText& lines, const Document& d) {
  const auto may_begin = [](std::string_view line) {
    if (line.find('#') != std::string_view::npos || line.find("rgb") != std::string_view::npos ||
        line.find("hsv") != std::string_view::npos)
      return true;
    for (std::size_t i = 0; i < line.size();) {
      const std::size_t from = i;
      while (i < line.size() && line[i] >= 'a' && line[i] <= 'z') ++i;
      if (i > from + 2 && named_color(line.substr(from, i - from))) return true;
      if (i == from) ++i;
    }
    return false;
  };
  std::vector<ColorAt> all;
  for (std::size_t i = 0; i < lines.count(); ++i) {
    const std::string_view line = lines.line(i);
    if (!may_begin(line)) continue;
    LineState state = lines.state_above(i);
    const auto made = state.goes_on() ? std::nullopt : making(line);
    for (const LinePiece& p : line_pieces(line, state, d, is_row(lines, i))) {
      const std::string_view word = line.substr(p.at, p.length);
      if (p.meaning != Meaning::color && word != "rgb" && word != "hsv") continue;
      if (made && made->word.data() == word.data()) continue;  // an object can be called gold
      Cursor c(line.substr(p.at));
      Color color;
      if (ValueReader{c, d.scene(), {}, {}, {}}.color(color))
        all.push_back({{lines.start(i) + p.at, c.since(word.data()).size()}, color});
    }
  }
  return all;
}

std::vector<std::string> ways_to_write(Color c) {
  const auto byte = [](double v) { return static_cast<unsigned>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); };
  const unsigned r = byte(c.r), g = byte(c.g), b = byte(c.b);
  const auto share = [](double v) { return write_number(std::round(v * 1000) / 1000); };
  std::vector<std::string> all;
  if (const std::string_view name = name_of_color(r << 16 | g << 8 | b); !name.empty()) all.emplace_back(name);
  all.push_back(fmt::format("#{:02x}{:02x}{:02x}", r, g, b));
  all.push_back(fmt::format("rgb({} {} {})", share(c.r), share(c.g), share(c.b)));
  return all;
}

}  // namespace betwixt
