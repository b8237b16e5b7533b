// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sections: parts of a film with a name, whose blocks have times of their own.
#include "scene/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/names.h"
#include "commands/command.h"

namespace betwixt {
namespace {

constexpr std::size_t most_sections = 10'000;

std::vector<std::string_view> names_of(const Scene& s, const Script& script) {
  std::vector<std::string_view> names;
  for (const Section& one : *s.sections) names.push_back(one.name);
  for (const Section& one : script.ahead.known) names.push_back(one.name);
  return names;
}

// Finds a section that is written above, or below in the reading before. In the first reading, a section that is not
// known may still come: it begins and ends at 0 until then.
Result<Section> section_of(const Scene& s, Script& script, std::string_view name) {
  if (const Section* const above = find_section(*s.sections, name)) return *above;
  if (const Section* const below = find_section(script.ahead.known, name)) return *below;
  if (!script.ahead.whole || script.ahead.readings > 0)
    return unknown_name("section", name, did_you_mean(name, names_of(s, script)));
  script.ahead.missing = true;
  return Section{std::string(name), {}, {}};
}

struct Said {
  std::string name, after;
  bool timed = false;
  Time begin;
  std::optional<Time> length;  // as it is written
  double speed = 1;
};

bool speed_of(Command& k, double& speed) {
  Cursor& c = k.cursor;
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing after speed", "as in speed=1.2");
  c.space();
  const char* const start = c.at;
  if (!c.number(speed)) return false;
  return (speed >= 0.001 && speed <= 1000) ||
         c.fail(ErrorCode::range, "a speed must be from 0.001 to 1000", c.since(start));
}

// Reads [after OTHER | at TIME] [for LENGTH] [speed=N].
bool twice(Cursor& c, std::string_view about) {
  return c.fail(ErrorCode::syntax, "a section begins at one time", about, "write either after SECTION or at TIME");
}

bool options_of(Command& k, Said& said) {
  auto& [s, c, time, layer, script] = k;
  while (!c.at_line_end()) {
    const char* const start = c.at;
    const std::string_view key = c.word();
    if (key == "after") {
      const std::string_view other = c.next_word();
      if (other.empty()) return c.fail_here(ErrorCode::syntax, "the name of a section is missing after 'after'");
      if (said.timed) return twice(c, {start, 5});
      said.after = other;
      if (const auto circle = script.ahead.circles.find(said.name); circle != script.ahead.circles.end())
        return c.fail(ErrorCode::range, "these sections wait for each other: " + circle->second, other,
                      "let one of them begin at a time: section NAME at 0s");
      if (other == said.name)
        return c.fail(ErrorCode::range, fmt::format("'{}' cannot begin after itself", other), other);
      const Result<Section> before = section_of(s, script, other);
      if (!before) return c.fail(before.error(), other);
      said.begin = before->end;
    } else if (key == "at") {
      if (said.timed || !said.after.empty()) return twice(c, {start, 2});
      said.timed = true;
      if (!c.time(said.begin)) return false;
    } else if (key == "for") {
      c.space();
      const char* const from = c.at;
      if (!c.length(said.length.emplace())) return false;
      if (*said.length <= Time{})
        return c.fail(ErrorCode::range, "the length of a section must be above 0", c.since(from));
    } else if (key == "speed") {
      if (!speed_of(k, said.speed)) return false;
    } else {
      return no_choice(c, key.empty() ? std::string_view(start, 1) : key,
                       "a section may have: after SECTION, at TIME, for LENGTH, speed=NUMBER",
                       did_you_mean(key, {"after", "at", "for", "speed"}));
    }
  }
  return true;
}

bool read_section(Command& k, Said& said) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  if (!new_name(c, word, "section's name", "./*?[]{}")) return false;
  if (find_section(*s.sections, word))
    return c.fail(ErrorCode::name, fmt::format("there is a section '{}' already", word), word,
                  "two sections cannot have one name");
  if (s.sections->size() >= most_sections)
    return c.fail(ErrorCode::range, fmt::format("a film can have at most {} sections", most_sections), word);
  said.name = word;
  return options_of(k, said);
}

// section NAME [after OTHER | at TIME] [for LENGTH] [speed=N]
bool section(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (!script.blocks.empty() || script.in_section)
    return c.fail(ErrorCode::syntax, "a section cannot contain another one", {script.verb, 7},
                  "write it at the beginning of a line; section NAME after OTHER puts it behind another one");
  if (script.options.now)
    return c.fail(ErrorCode::syntax, "a host of a server cannot open a section", {script.verb, 7},
                  "write it in the script");
  Said said;
  if (!s.sections->empty()) said.begin = s.sections->back().end;
  c.space();
  const std::string_view about = c.peek_word();
  const bool read = read_section(k, said);
  if (said.name.empty()) return false;
  // After an error too, so that the lines of its block have a place.
  OpenBlock& block = script.open_block(script.verb);
  block.clock = {said.begin, said.speed};
  if (!said.length) block.grows = s.sections->size();
  c.latest = earliest_time;
  s.sections.edit().push_back(
      {said.name, said.begin, said.begin + block.clock.film_length(said.length.value_or(Time{})), said.speed});
  script.ahead.written.push_back({said.name, said.after, said.timed});
  if (auto place = script.withheld(Severity::warning, {}, about)) script.section_places.emplace(said.name, *place);
  return read;
}

constexpr Verb sections_rows[] = {
    {"section", "section NAME [after OTHER | at TIME] [for LENGTH] [speed=NUMBER]",
     "A part of the film with a name: the times in the lines that are indented below it count from its beginning. "
     "Without `after` and `at` it begins where the section above it ends.",
     "section intro for 2s\n  at 1f hide ball\nsection proof after intro speed=1.2\n  at 12f show ball",
     Verb::opens_block, section, "NEW; after at for speed=; SECTION after at for speed=…"},
};

// Finds where each section begins, from its length and the section that it waits for.
class Ordering {
 public:
  Ordering(const Scene& s, const Script& script)
      : written_(script.ahead.written), all_(*s.sections), done_(all_.size()) {}
  void run(SectionsAhead& next) {
    for (std::size_t i = 0; i < all_.size(); ++i) visit(i, next);
    next.known = all_;
  }

 private:
  std::optional<std::size_t> index(std::string_view name) const {
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (all_[i].name == name) return i;
    return std::nullopt;
  }
  // Returns the section whose end is the beginning of another one.
  std::optional<std::size_t> before(std::size_t i) const {
    const std::string& after = written_[i].after;
    if (!after.empty()) return index(after);
    return i > 0 && !written_[i].timed ? std::optional(i - 1) : std::nullopt;
  }
  void visit(std::size_t i, SectionsAhead& next) {
    std::vector<std::size_t> way;
    for (std::optional<std::size_t> at = i; at && !done_[*at]; at = before(*at)) {
      const auto met = std::find(way.begin(), way.end(), *at);
      if (met != way.end()) return circle({met, way.end()}, next);
      way.push_back(*at);
    }
    for (auto at = way.rbegin(); at != way.rend(); ++at) {
      done_[*at] = true;
      const auto other = before(*at);
      if (!other) continue;
      const Time by = all_[*other].end - all_[*at].begin;
      all_[*at].begin = all_[*at].begin + by, all_[*at].end = all_[*at].end + by;
    }
  }
  void circle(std::vector<std::size_t> of, SectionsAhead& next) {
    for (const std::size_t first : of) {
      std::string said = all_[first].name;
      int count = 0;
      for (std::optional<std::size_t> at = before(first); at; at = before(*at)) {
        if (++count > 5) {
          said += " …";
          break;
        }
        said += " after " + all_[*at].name;
        if (*at == first) break;
      }
      if (!written_[first].after.empty()) next.circles.emplace(all_[first].name, said);
      done_[first] = true;
    }
  }

  const std::vector<SectionsAhead::Written>& written_;
  std::vector<Section> all_;
  std::vector<bool> done_;
};

// Reports sections that the film never shows.
void say_unseen_sections(const Scene& s, Script& script) {
  if (!s.range) return;
  for (const Section& one : *s.sections) {
    const bool before = one.end <= s.range->first && one.begin<s.range->first, behind = one.begin> s.range->second;
    const auto place = script.section_places.find(one.name);
    if (!(before || behind) || place == script.section_places.end()) continue;
    Diagnostic d = place->second;
    d.what.message = fmt::format("section '{}' is {} the range of the film", one.name, before ? "before" : "behind");
    d.what.hint = "range says which part of the film is shown";
    script.diagnostics.push_back(std::move(d));
  }
}

}  // namespace

Result<Time> section_time(const Scene& s, Script& script, std::string_view name, bool end) {
  const Result<Section> found = section_of(s, script, name);
  if (!found) return found.error();
  for (const OpenBlock& block : script.blocks)
    if (end && block.grows && (*s.sections)[*block.grows].name == name)
      return fail(ErrorCode::range, fmt::format("the end of '{}' is not known in its own block", name),
                  "give it a length: section NAME for LENGTH");
  return end ? found->end : found->begin;
}

Result<Time> section_edge(const std::vector<Section>& all, std::string_view name, bool end) {
  if (const Section* const found = find_section(all, name)) return end ? found->end : found->begin;
  std::vector<std::string_view> names;
  for (const Section& one : all) names.push_back(one.name);
  return unknown_name("section", name, did_you_mean(name, names));
}

void grow_section(Scene& s, const Script& script, Time latest) {
  for (const OpenBlock& block : script.blocks)
    if (block.grows && (*s.sections)[*block.grows].end < latest) s.sections.edit()[*block.grows].end = latest;
}

void say_overlaps(const Scene& s, Script& script) {
  std::vector<const Section*> all;
  for (const Section& one : *s.sections) all.push_back(&one);
  std::stable_sort(all.begin(), all.end(), [](const Section* a, const Section* b) { return a->begin < b->begin; });
  const Section* last = nullptr;  // the one that ends last until now
  for (const Section* one : all) {
    if (last && one->begin < last->end)
      if (const auto place = script.section_places.find(one->name); place != script.section_places.end()) {
        Diagnostic d = place->second;
        d.what.message = fmt::format("section '{}' begins before '{}' ends", one->name, last->name);
        script.diagnostics.push_back(std::move(d));
      }
    if (!last || one->end > last->end) last = one;
  }
  say_unseen_sections(s, script);
}

bool look_ahead(const Scene& s, Script& script, SectionsAhead& next) {
  constexpr int most_readings = 8;
  const SectionsAhead& ahead = script.ahead;
  const bool settled = ahead.readings == 0 ? !ahead.missing : ahead.known == *s.sections || !ahead.circles.empty();
  if (settled) return false;
  if (ahead.readings + 1 < most_readings) {
    Ordering(s, script).run(next);
    next.readings = ahead.readings + 1;
    return true;
  }
  for (const Section& one : *s.sections)
    if (const Section* const before = find_section(ahead.known, one.name); !before || !(*before == one)) {
      const auto place = script.section_places.find(one.name);
      if (place == script.section_places.end()) continue;
      Diagnostic d = place->second;
      d.severity = Severity::error, d.what.code = ErrorCode::range;
      d.what.message = fmt::format("the times of section '{}' depend on themselves", one.name);
      script.diagnostics.push_back(std::move(d));
      break;
    }
  return false;
}

std::span<const Verb> sections_verbs() { return sections_rows; }

}  // namespace betwixt
