// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A merge finds first what the merged film must say (fact_merge.h). Then it merges the lines and enters what is missing
// in the result, as a hand would in the studio. The text counts only if it makes that film.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "betwixt/compare.h"
#include "betwixt/session.h"
#include "compare/conflict_notes.h"
#include "compare/fact_merge.h"
#include "compare/line_merge.h"
#include "compare/renames.h"
#include "editor/text_rows.h"
#include "syntax/script_text.h"

namespace betwixt {
namespace {

class FilmMerge {
 public:
  FilmMerge(std::string base, std::string mine, std::string theirs, const std::string& name, const LoadOptions& options)
      : base_(std::move(base)), mine_(std::move(mine)), theirs_(std::move(theirs)), name_(name), options_(options) {}

  MergedFilm merged() {
    const std::string base = base_, mine = mine_, theirs = theirs_;
    if (mine == theirs || theirs == base) return {mine, {}, {}, false, ""};
    if (mine == base) return {theirs, {}, {}, false, ""};
    for (const auto& [text, whose] : {std::pair(&base, "the base"), {&mine, "mine"}, {&theirs, "theirs"}})
      if (const std::string wrong = error_in(*text); !wrong.empty())
        return by_lines(base, mine, theirs, fmt::format("{} has an error: {}", whose, wrong));
    std::vector<MergeConflict> conflicts = follow_renames();
    follow_rate(conflicts);
    mine_film_ = load(mine_).document, theirs_film_ = load(theirs_).document;
    base_facts_ = facts_of(load(base_).document);
    mine_facts_ = facts_of(mine_film_), theirs_facts_ = facts_of(theirs_film_);
    const MergedFacts wanted = merge_facts(base_facts_, mine_facts_, theirs_facts_);
    const auto regions = regions_of(base_, mine_, theirs_);
    const bool plain = std::ranges::none_of(regions, [](const LineRegion& r) { return r.conflict && !r.base.empty(); });
    std::set<std::string> tried;
    std::optional<Made> best;
    // The best text is right as it is. Otherwise the shortest one has no lines that others override.
    for (const InConflict how : {InConflict::mine_theirs, InConflict::theirs_mine, InConflict::mine}) {
      const std::string text = text_of(regions, how);
      if (!tried.insert(text).second) continue;
      auto made = completed(text, wanted, plain);
      if (made && made->text == text && wanted.conflicts.empty()) return finished(*std::move(made), wanted, conflicts);
      if (made && (!best || made->text.size() < best->text.size())) best = std::move(made);
    }
    // Without the lines of theirs, comments of theirs are lost, so this comes last.
    if (!best && tried.insert(mine_).second) best = completed(mine_, wanted, false);
    if (best) return finished(*std::move(best), wanted, conflicts);
    return by_lines(base, mine, theirs, "no place was found for all changes of theirs");
  }

 private:
  struct Made {
    std::string text;
    Document film;
    Facts facts;
    std::set<FactKey> together;  // what only both changes together make
  };

  Loaded load(const std::string& text) const { return load_text(text, name_, options_); }
  std::string error_in(const std::string& text) const {
    for (const Diagnostic& d : load(text).diagnostics)
      if (d.severity == Severity::error) return fmt::format("line {}: {}", d.what.place.line, d.what.message);
    return {};
  }

  Session session_on(const std::string& text) const {
    Session s({}, options_);
    s.begin(text, name_);
    s.keep_quiet();
    s.edit_in_place();
    return s;
  }
  void rename_in(std::string& text, const Renames& names) const {
    if (names.empty()) return;
    Session s = session_on(text);
    for (const auto& [name, other] : names) s.enter("rename " + name + " " + other);
    text = s.text();
  }

  // Gives all three texts the new names of both, so that nothing else of the merge needs to know of them.
  std::vector<MergeConflict> follow_renames() {
    const Facts base = facts_of(load(base_).document);
    Renames mine = renames_between(base, facts_of(load(mine_).document));
    const Renames theirs = renames_between(base, facts_of(load(theirs_).document));
    std::vector<MergeConflict> conflicts;
    Renames for_mine, for_theirs, for_base = mine;
    for (const auto& [name, other] : theirs) {
      const auto also = mine.find(name);
      if (also == mine.end()) {
        for_mine[name] = other, for_base[name] = other;
      } else if (also->second != other) {
        for_theirs[other] = also->second;
        conflicts.push_back(
            {name, "renamed to " + also->second, "renamed to " + other, "rename " + also->second + " " + other, 0});
      }
    }
    for (const auto& [name, other] : mine)
      if (!theirs.contains(name)) for_theirs[name] = other;
    rename_in(base_, for_base), rename_in(mine_, for_mine), rename_in(theirs_, for_theirs);
    return conflicts;
  }

  // Returns the first line of a text that sets the rate; without its line feed. Empty if there is none.
  static std::string_view rate_line(const std::string& text) {
    for (const std::size_t at : line_starts(text))
      if (std::string_view line = line_at(text, at); !indented(line) && first_word(line) == "rate")
        return without_comment(line.ends_with('\n') ? line.substr(0, line.size() - 1) : line);
    return {};
  }
  // Gives all three texts the same rate, if they all set one. Otherwise all events in frames would have moved.
  void follow_rate(std::vector<MergeConflict>& conflicts) {
    const std::string base(rate_line(base_)), mine(rate_line(mine_)), theirs(rate_line(theirs_));
    if (base.empty() || mine.empty() || theirs.empty() || (mine == base && theirs == base)) return;
    const std::string& rate = mine == base ? theirs : mine;
    if (mine != base && theirs != base && mine != theirs) conflicts.push_back({"rate", mine, theirs, theirs, 0});
    for (std::string* text : {&base_, &mine_, &theirs_}) {
      const std::string_view line = rate_line(*text);
      text->replace(static_cast<std::size_t>(line.data() - text->data()), line.size(), rate);
    }
  }

  // Returns whether a row of one of the two texts makes this event. Otherwise it follows from commands such as `copy`.
  bool written(const FactKey& k) const {
    if (k.about == "attachment") return true;  // by commands such as `couple`
    for (const auto& [text, film] : {std::pair(&mine_, &mine_film_), {&theirs_, &theirs_film_}}) {
      auto found = find_targets(k.object + "." + k.about, *film);
      if (!found || found->size() != 1) continue;
      Target& t = found->front();
      if (!k.layer.empty()) t.layer = film->find(k.layer);
      for (const SheetText& sheet : rows_about(*text, *film, *found).sheets)
        if (std::ranges::find(sheet.targets, t) != sheet.targets.end() &&
            std::ranges::find(sheet.rows, k.time, &RowText::when) != sheet.rows.end())
          return true;
    }
    return false;
  }

  static const std::string* find(const std::map<FactKey, std::string>& facts, const FactKey& k) {
    const auto at = facts.find(k);
    return at == facts.end() ? nullptr : &at->second;
  }
  static bool same(const std::string* a, const std::string* b) { return a && b ? *a == *b : a == b; }
  // Returns the facts in which a film differs from the wanted one, without those that follow from both changes together
  // (one changed a row, the other copies it): these are in none of the three films, or no row makes them.
  std::vector<FactKey> missing(const Facts& facts, const MergedFacts& wanted, bool plain,
                               std::set<FactKey>& together) const {
    constexpr std::size_t most_looked_up = 200;
    std::set<FactKey> keys;
    for (const auto& [key, said] : facts.said) keys.insert(key);
    for (const auto& [key, said] : wanted.said) keys.insert(key);
    std::vector<FactKey> all;
    for (const FactKey& k : keys) {
      const std::string *is = find(facts.said, k), *should = find(wanted.said, k);
      if (same(is, should)) continue;
      const std::string *b = find(base_facts_.said, k), *m = find(mine_facts_.said, k),
                        *t = find(theirs_facts_.said, k);
      if (is && !same(m, t) && !same(is, b) && !same(is, m) && !same(is, t)) {
        together.insert(k);
      } else if (plain && k.part == FactPart::event && !(is && should) &&
                 all.size() + together.size() < most_looked_up && !written(k)) {
        together.insert(k);
      } else {
        all.push_back(k);
      }
    }
    return all;
  }

  // Enters what a text lacks. Returns nullopt if the result is not the wanted film.
  // `plain`: the lines merged without a conflict.
  std::optional<Made> completed(const std::string& text, const MergedFacts& wanted, bool plain) const {
    Loaded loaded = load(text);
    if (has_errors(loaded.diagnostics)) return std::nullopt;
    Made made{text, std::move(loaded.document), {}, {}};
    made.facts = facts_of(made.film);
    for (int round = 0; round < 2; ++round) {
      made.together.clear();
      const std::vector<FactKey> lacks = missing(made.facts, wanted, plain, made.together);
      if (lacks.empty()) return made;
      Session s = session_on(made.text);
      enter(s, lacks, made.facts, wanted);
      made.text = s.text();
      loaded = load(made.text);
      if (has_errors(loaded.diagnostics)) return std::nullopt;
      made.film = std::move(loaded.document), made.facts = facts_of(made.film);
    }
    made.together.clear();
    if (!missing(made.facts, wanted, plain, made.together).empty()) return std::nullopt;
    return made;
  }

  static void enter(Session& s, const std::vector<FactKey>& lacks, const Facts& facts, const MergedFacts& wanted) {
    for (const FactKey& k : lacks)
      if (k.part == FactPart::object && !find(wanted.said, k) && s.document().find(k.object))
        s.enter("remove " + k.object);
    // The changes of a track are one step, so that rows move with their comments.
    for (std::size_t i = 0; i < lacks.size();) {
      std::size_t end = i + 1;
      while (end < lacks.size() && lacks[end].track() == lacks[i].track()) ++end;
      std::vector<std::string> without, with;
      for (; i < end; ++i) {
        const FactKey& k = lacks[i];
        if (!k.object.empty() && !s.document().find(k.object) && k.part > FactPart::environment) continue;
        const std::string* said = find(wanted.said, k);
        if (find(facts.said, k) && (!said || k.part == FactPart::note))
          append(without, commands_without(k, s.document()));
        if (said) append(with, commands_for(k, *said, s.document()));
      }
      append(without, with);
      if (without.size() > 1 && s.enter_together(without).done) continue;
      for (const std::string& line : without) s.enter(line);
    }
  }
  static void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
    all.insert(all.end(), more.begin(), more.end());
  }

  MergedFilm finished(Made made, const MergedFacts& wanted, const std::vector<MergeConflict>& of_names) const {
    MergedFilm out{std::move(made.text), {}, {}, false, ""};
    std::vector<FactConflict> left;
    for (const FactConflict& c : wanted.conflicts)
      if (!made.together.contains(c.key)) left.push_back(c);
    if (!left.empty()) note_conflicts(out.text, made.film, theirs_film_, left, out.conflicts);
    for (MergeConflict c : of_names) {
      if (!out.text.empty() && out.text.back() != '\n') out.text += '\n';
      c.place = 1 + static_cast<int>(std::ranges::count(out.text, '\n'));
      out.text += "# conflict: theirs: " + c.line + "\n";
      out.conflicts.push_back(std::move(c));
    }
    std::set<std::string> names;
    for (const FactKey& k : made.together) names.insert(k.name());
    for (const std::string& name : names)
      out.notices.push_back(fmt::format("{} has values that follow from both changes together", name));
    return out;
  }

  // Merges lines, whatever they mean.
  MergedFilm by_lines(const std::string& base, const std::string& mine, const std::string& theirs,
                      std::string why) const {
    const auto regions = regions_of(base, mine, theirs);
    MergedFilm out{text_of(regions, InConflict::marks), {}, {}, true, std::move(why)};
    int line = 1;
    std::size_t at = 0;
    while ((at = out.text.find("<<<<<<< mine\n", at)) != std::string::npos) {
      line =
          1 + static_cast<int>(std::count(out.text.begin(), out.text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      out.conflicts.push_back({"lines", "see <<<<<<<", "see =======", "", line});
      ++at;
    }
    // Lines that merged without a mark can still make no film.
    if (out.conflicts.empty())
      if (const std::string wrong = error_in(out.text); !wrong.empty() && error_in(mine).empty())
        out.conflicts.push_back({"lines", "a film without errors", "merged lines with an error: " + wrong, "", 1});
    return out;
  }

  std::string base_, mine_, theirs_, name_;
  LoadOptions options_;
  Document mine_film_, theirs_film_;
  Facts base_facts_, mine_facts_, theirs_facts_;
};

}  // namespace

MergedFilm merge_films(const std::string& base, const std::string& mine, const std::string& theirs,
                       const std::string& name, const LoadOptions& options) {
  return FilmMerge(base, mine, theirs, name, options).merged();
}

}  // namespace betwixt
