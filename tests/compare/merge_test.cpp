// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Merges random pairs of edits, and compares films by brute force.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <tuple>

#include "betwixt/compare.h"
#include "betwixt/object.h"
#include "betwixt/session.h"
#include "betwixt/track.h"
#include "editor/plain_values.h"
#include "scene/document.h"
#include "support/loaded_film.h"
#include "support/plain_film.h"

namespace betwixt {
namespace {

// All that a film says, asked for piece by piece.
using Pieces = std::map<std::string, std::string>;

std::string event_text(const Document& d, const Target& t, const EventView& e) {
  std::string out =
      fmt::format("{} {} {} {}", static_cast<int>(e.what), e.twerper, e.ease_in.flicks, e.ease_out.flicks);
  for (const Value* v : {e.value, e.cut_from, e.tangent_in, e.tangent_out})
    out += v ? " " + plain_value(*v, t, d) : "-";
  for (const double a : e.arguments) out += fmt::format(" {}", a);
  return out;
}

Pieces pieces_of(const Document& d) {
  Pieces all;
  all["setting|rate"] = fmt::format("{}/{}", d.rate().num, d.rate().den);
  all["setting|range"] = d.scene().range ? fmt::format("{} {}", d.range().first.flicks, d.range().second.flicks) : "";
  if (const auto b = d.scene().background) all["setting|background"] = fmt::format("{} {} {}", b->r, b->g, b->b);
  for (const Note& n : d.notes(earliest_time, latest_time))
    all[fmt::format("note|note|{}", n.time.flicks)] += n.text + "\n";
  for (const auto& [time, camera] : d.cuts()) all[fmt::format("camera|camera cut|{}", time.flicks)] = d.name(camera);
  for (const ObjectId o : objects(d)) {
    all["object|" + d.name(o)] = name_of(kind(d, o));
    for (const FunctionView& f : functions(d, o)) {
      const Target whole{o, f.id};
      if (const Value* v = value_set(d, whole)) all["value|" + d.name(whole)] = plain_value(*v, whole, d);
      for (const TrackView& track : tracks(d, whole))
        for (const EventView& e : events(d, track.target))
          all[fmt::format("event|{}|{}", d.name(track.target), e.time.flicks)] = event_text(d, track.target, e);
    }
  }
  return all;
}
std::string object_of(const std::string& piece) {
  const std::size_t bar = piece.find('|') + 1;
  return piece.substr(bar, piece.find_first_of(".|", bar) - bar);
}

// Returns the pieces that differ. Those of an object that came or went are one.
std::set<std::string> apart(const Document& old, const Document& now) {
  const Pieces a = pieces_of(old), b = pieces_of(now);
  std::set<std::string> all;
  const auto look = [&](const Pieces& x, const Pieces& y) {
    for (const auto& [key, said] : x) {
      const auto there = y.find(key);
      if (there != y.end() && there->second == said) continue;
      const std::string object = "object|" + object_of(key);
      const bool whole = a.contains(object) != b.contains(object);
      all.insert(whole ? object : key);
    }
  };
  look(a, b), look(b, a);
  return all;
}
// The same, as compare() says it.
std::set<std::string> said_apart(const Document& old, const Document& now) {
  std::set<std::string> all;
  for (const FilmChange& c : compare(old, now)) {
    if (c.events.empty()) all.insert(c.part + "|" + c.name);
    for (const EventChange& e : c.events)
      for (const auto& t : {e.was, e.is})
        if (t) all.insert(fmt::format("{}|{}|{}", c.part, c.name, t->flicks));
  }
  return all;
}

class Edits {
 public:
  explicit Edits(std::uint64_t seed) : random_(seed) {}
  int below(std::size_t n) { return static_cast<int>(random_() % n); }

  // Returns a line that changes the film.
  std::string line(const Document& d, const std::string& author) {
    std::vector<ObjectId> all;
    for (const ObjectId o : objects(d))
      if (!derived(d, o) && has_position(d, o)) all.push_back(o);
    if (all.empty()) return fmt::format("create {}{} box", author, below(1000));
    // Authors often meet at the first objects.
    const std::string o =
        d.name(all[static_cast<std::size_t>(below(below(3) == 0 ? all.size() : std::min<std::size_t>(2, all.size())))]);
    const Target position = find_targets(o + ".position", d)->front();
    switch (below(12)) {
      case 0:
        return fmt::format("create {}{} box position=({} 2 3)", author, below(1000), below(9));
      case 1:
        return fmt::format("set {}.visible {}", o, below(2) ? "on" : "off");
      case 2:
        return fmt::format("set {}.scale ({} 1 1)", o, 1 + below(5));
      case 3:
        return fmt::format("at {}f note \"{} {}\"", 1 + below(90), author, below(100));
      case 4:
        return below(4) ? "" : "remove " + o;
      case 5:
        return below(3) ? "" : "background navy";
      default:
        break;
    }
    const auto there = events(d, position);
    if (there.empty() || below(3) == 0)
      return fmt::format("at {}f {}.position ({} {} 1)", 1 + below(90), o, below(20), below(20));
    const EventView& e = there[static_cast<std::size_t>(below(there.size()))];
    const std::string at = format_time(e.time, d);
    return below(3) == 0 ? fmt::format("clear {}.position {}", o, at)
                         : fmt::format("at {} {}.position ({} {} {}){}", at, o, below(20), below(20), below(20),
                                       below(2) ? " linear" : "");
  }

 private:
  static bool has_position(const Document& d, ObjectId o) {
    const auto found = find_targets(d.name(o) + ".position", d);
    return found && found->size() == 1 && tracks(d, Target{o, found->front().function, 0}).size() < 2;
  }
  std::mt19937_64 random_;
};

struct Edited {
  std::string text;
  Document film;
  std::vector<std::string> lines;
  std::string remark;
  std::set<std::string> touched;  // pieces that any of the lines changed, even if a later one changed them back
};
Session session_on(const std::string& text, const std::string& name) {
  Session s;
  s.begin(text, name);
  s.keep_quiet();
  s.edit_in_place();
  return s;
}
Edited edited(const std::string& text, const std::string& name, Edits& edits, const std::string& author) {
  Session s = session_on(text, name);
  Edited made;
  for (int n = 1 + edits.below(3); n > 0; --n) {
    const std::string line = edits.line(s.document(), author);
    const Document before = s.document();
    if (line.empty() || !s.enter(line).done) continue;
    made.lines.push_back(line);
    made.touched.merge(apart(before, s.document()));
  }
  made.text = s.text(), made.film = s.document();
  // Authors write remarks too.
  if (edits.below(3) == 0) made.remark = "# " + author + " was here\n";
  made.text.insert(made.text.find('\n') + 1, made.remark);
  return made;
}

// The films that random edits begin with: random ones, and examples.
std::pair<std::string, std::string> film_number(int i) {
  static const std::vector<std::string> examples{"bounce", "grab", "four-balls", "mirror", "chain", "gears"};
  for (int seed = i; i % 4 != 0; seed += 1000)
    if (const std::string text = PlainFilm(static_cast<std::uint64_t>(seed)).script();
        !has_errors(load_text(text, "test.bx").diagnostics))
      return {text, "test.bx"};
  const std::string name =
      std::string(SOURCE_DIR) + "/examples/" + examples[static_cast<std::size_t>(i / 4) % examples.size()] + ".bx";
  std::ostringstream text;
  text << std::ifstream(name).rdbuf();
  return {text.str(), name};
}

bool touch(const std::set<std::string>& a, const std::set<std::string>& b) {
  const auto meets = [](const std::set<std::string>& x, const std::set<std::string>& y) {
    return std::ranges::any_of(x, [&](const std::string& piece) {
      return y.contains(piece) ||
             (piece.starts_with("object|") &&
              std::ranges::any_of(y, [&](const std::string& other) { return object_of(other) == object_of(piece); }));
    });
  };
  return meets(a, b) || meets(b, a);
}

// One pair of edits of one film.
struct Pair {
  explicit Pair(int i) {
    std::tie(base, name) = film_number(i);
    Edits edits(static_cast<std::uint64_t>(1000 + i));
    film = load_text(base, name).document;
    mine = edited(base, name, edits, "mine"), theirs = edited(base, name, edits, "theirs");
    of_mine = apart(film, mine.film), of_theirs = apart(film, theirs.film);
    merged = merge_films(base, mine.text, theirs.text, name);
    loaded = load_text(merged.text, name);
  }
  bool meet() const { return touch(mine.touched, theirs.touched); }

  // Returns what is wrong with the merge of edits that do not touch the same things.
  std::string wrong_apart(bool frames) const {
    if (!merged.clean()) return "conflict: " + merged.conflicts.front().name;
    if (has_errors(loaded.diagnostics)) return "errors: " + said(loaded.diagnostics);
    Session both = session_on(base, name);
    for (const auto& lines : {mine.lines, theirs.lines})
      for (const std::string& line : lines)
        if (!both.enter(line).done) return "";  // one edit forbids the other
    if (pieces_of(loaded.document) != pieces_of(both.document())) return "other pieces";
    if (loaded.document != both.document()) return "another document";
    if (!frames) return "";
    const Program x = Program::compile(loaded.document), y = Program::compile(both.document());
    for (int k = 0; k < 40; ++k)
      if (const Time t = film.rate().frame(k * 2.5 - 3); !same_frame(x.frame(t), y.frame(t)))
        return fmt::format("frame {}", k);
    return "";
  }
  // Returns what is wrong with the merge of other edits: what mine changed must be there, and what theirs changed must
  // be there too, or be named by a conflict.
  std::string wrong_meeting() const {
    if (has_errors(loaded.diagnostics)) return "errors: " + said(loaded.diagnostics);
    const Pieces is = pieces_of(loaded.document), m = pieces_of(mine.film), t = pieces_of(theirs.film);
    const auto has = [&](const Pieces& all, const std::string& piece) {
      const auto a = all.find(piece), b = is.find(piece);
      if (piece.starts_with("note") && a != all.end() && b != is.end())
        return b->second.find(a->second) != std::string::npos;
      return a == all.end() ? b == is.end() : b != is.end() && a->second == b->second;
    };
    for (const std::string& piece : of_mine)
      if (!has(m, piece)) return "lost of mine: " + piece;
    for (const std::string& piece : of_theirs)
      if (!has(t, piece) && !conflict_about(piece)) return "lost of theirs: " + piece;
    return "";
  }
  bool conflict_about(const std::string& piece) const {
    return std::ranges::any_of(merged.conflicts, [&](const MergeConflict& c) {
      const std::size_t bar = piece.find('|') + 1;
      const std::string thing = piece.substr(bar, piece.find('|', bar) - bar);
      return c.place > 0 && (c.name == thing || c.name == object_of(piece));
    });
  }
  std::string told(const std::string& wrong) const {
    return fmt::format("{}\n  mine: {}\n  theirs: {}\n  {}", wrong, fmt::join(mine.lines, " | "),
                       fmt::join(theirs.lines, " | "), merged.why);
  }

  std::string base, name;
  Document film;
  Edited mine, theirs;
  std::set<std::string> of_mine, of_theirs;
  MergedFilm merged;
  Loaded loaded;
};

// A sanitizer has an allocator of its own, and takes ten times as long.
bool watched() {
  const auto all = mallinfo2();
  return all.uordblks + all.hblkhd == 0;
}

// Tries every fourth of a thousand pairs.
void try_pairs(int first) {
  int met = 0, by_lines = 0;
  std::vector<std::string> wrong;
  for (int i = first; i < (watched() ? 100 : 1000); i += 4) {
    const Pair p(i);
    const auto tell = [&](const std::string& why) { wrong.push_back(fmt::format("pair {}: {}", i, p.told(why))); };
    if (said_apart(p.film, p.mine.film) != p.of_mine) tell("the differences of mine");
    if (said_apart(p.film, p.theirs.film) != p.of_theirs) tell("the differences of theirs");
    for (const Edited* e : {&p.mine, &p.theirs})
      if (!e->remark.empty() && p.merged.text.find(e->remark) == std::string::npos) tell("lost: " + e->remark);
    met += p.meet(), by_lines += p.merged.by_lines;
    if (const std::string why = p.meet() ? p.wrong_meeting() : p.wrong_apart(i % 5 == 0); !why.empty()) tell(why);
  }
  for (std::size_t k = 0; k < std::min<std::size_t>(wrong.size(), 5); ++k) ADD_FAILURE() << wrong[k];
  EXPECT_EQ(wrong.size(), 0u);
  EXPECT_EQ(by_lines, 0);
  if (!watched()) EXPECT_GT(met, 2);
}

TEST(MergeOfRandomPairs, OfExamples) { try_pairs(0); }
TEST(MergeOfRandomPairs, First) { try_pairs(1); }
TEST(MergeOfRandomPairs, Second) { try_pairs(2); }
TEST(MergeOfRandomPairs, Third) { try_pairs(3); }

}  // namespace
}  // namespace betwixt
