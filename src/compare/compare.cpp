// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/counted.h"
#include "base/utf8.h"
#include "compare/events_apart.h"
#include "compare/facts.h"
#include "compare/renames.h"
#include "language/values.h"
#include "scene/document.h"

namespace betwixt {
namespace {

using What = FilmChange::What;

class Comparing {
 public:
  Comparing(const Document& old, const Document& now) : now_(now) {
    was_ = facts_of(old), is_ = facts_of(now);
    if (Renames names = renames_between(was_, is_); !names.empty()) {
      for (const auto& [name, other] : names)
        add({What::renamed, "object", name, name, other, {}, {}, fmt::format("{} renamed to {}", name, other)});
      was_ = facts_of(renamed(old, names));
    }
    if (old.rate() != now.rate()) follow_rate(old.rate());
  }

  std::vector<FilmChange> all() {
    const std::set<std::string> before(was_.objects.begin(), was_.objects.end()),
        after(is_.objects.begin(), is_.objects.end());
    std::set<FactKey> keys;
    for (const auto& [key, said] : was_.said) keys.insert(key);
    for (const auto& [key, said] : is_.said) keys.insert(key);
    const auto by_object = [](const FactKey& a, const FactKey& b) { return a.object < b.object; };
    std::vector<FactKey> sorted(keys.begin(), keys.end());
    std::ranges::stable_sort(sorted, by_object);
    for (std::size_t i = 0; i < sorted.size();) {
      const FactKey& key = sorted[i];
      const bool stays = key.object.empty() || (before.contains(key.object) && after.contains(key.object));
      if (!stays) {
        if (key.part == FactPart::object) whole(key);
        ++i;
      } else if (key.timed()) {
        std::size_t end = i + 1;
        while (end < sorted.size() && sorted[end].track() == key.track()) ++end;
        track(key.track());
        i = end;
      } else {
        plain(key), ++i;
      }
    }
    order(before, after);
    return std::move(changes_);
  }

 private:
  void add(FilmChange c) { changes_.push_back(std::move(c)); }
  static std::string said(const Facts& facts, const FactKey& k) {
    const auto at = facts.said.find(k);
    return at == facts.said.end() ? "" : at->second;
  }

  static std::size_t count_apart(const Facts& a, const Facts& b) {
    return static_cast<std::size_t>(
        std::ranges::count_if(a.said, [&](const auto& f) { return said(b, f.first) != f.second; }));
  }
  // With another rate all events that are written in frames have moved. If that explains more than it adds, compares
  // the frames of events and not their times.
  void follow_rate(Rate old) {
    Facts in_frames{{}, was_.objects};
    for (const auto& [key, said] : was_.said) {
      FactKey moved = key;
      if (key.timed() && in_reach(key.time)) moved.time = now_.rate().frame(old.frame_number(key.time));
      in_frames.said.emplace(std::move(moved), said);
    }
    if (count_apart(in_frames, is_) < count_apart(was_, is_)) was_ = std::move(in_frames);
  }

  void whole(const FactKey& k) {
    const std::string before = said(was_, k), after = said(is_, k);
    const std::string kind = before.empty() ? after : before;
    add({before.empty() ? What::added : What::removed,
         "object",
         k.object,
         before,
         after,
         {},
         {},
         fmt::format("{} {} ({})", k.object, before.empty() ? "added" : "removed", kind)});
  }

  // A fact without a time.
  void plain(const FactKey& k) {
    const std::string before = said(was_, k), after = said(is_, k);
    if (before == after) return;
    const What what = before.empty() ? What::added : after.empty() ? What::removed : What::changed;
    add({what, std::string(word_of(k.part)), k.name(), before, after, {}, {}, words(k, what, before, after)});
  }
  static std::string in_short(const std::string& said) {
    const std::string_view line = std::string_view(said).substr(0, said.find('\n'));
    const std::string_view begin = first_characters(line, 60);
    return std::string(begin) + (begin.size() < said.size() ? " …" : "");
  }
  // Returns the rest of a command after the words that the name of its fact says already.
  static std::string argument(const FactKey& k, const std::string& said) {
    if (k.part != FactPart::setting || !said.starts_with(k.about + " ")) return in_short(said);
    return in_short(said.substr(k.about.size() + 1));
  }
  static std::string words(const FactKey& k, What what, const std::string& before, const std::string& after) {
    const std::string a = argument(k, before), b = argument(k, after), layer = k.layer.empty() ? "" : " on " + k.layer;
    const auto became = [&](const std::string& head) {
      if (what == What::added) return fmt::format("{} set to {}", head, b);
      if (what == What::removed) return fmt::format("{} no longer set (it was {})", head, a);
      if (a == b) return fmt::format("{} changed", head);
      return fmt::format("{} changed from {} to {}", head, a, b);
    };
    switch (k.part) {
      case FactPart::setting:
        return became("film: " + k.about);
      case FactPart::value:
        return became(fmt::format("{}: {}{}", k.object, k.about, layer));
      case FactPart::object:
        return fmt::format("{}: kind changed from {} to {}", k.object, a, b);
      case FactPart::environment:
        return fmt::format("{}: its updates changed", k.object);
      case FactPart::definition:
      case FactPart::list: {
        const std::string name = k.part == FactPart::list ? "display list " + k.about : k.about;
        if (what != What::changed) return fmt::format("{} {}", name, to_string(what));
        return a == b ? fmt::format("{} changed", name) : fmt::format("{} changed from \"{}\" to \"{}\"", name, a, b);
      }
      default: {
        const std::string about = fmt::format("{}: {}", k.name(), k.part == FactPart::filters ? "filters" : "twerper");
        if (what == What::added) return fmt::format("{} added: {}", about, b);
        if (what == What::removed) return fmt::format("{} removed: {}", about, a);
        return fmt::format("{} changed from \"{}\" to \"{}\"", about, a, b);
      }
    }
  }

  std::string at(Time t) const { return t == earliest_time ? "the beginning" : write_time(t, now_.rate()); }
  std::string length(Time t) const {
    const double frames = now_.rate().frame_number(t) - 1;
    return frames == std::round(frames) && now_.rate().span(frames) == t ? write_number(frames) + "f"
                                                                         : write_seconds(t);
  }
  std::string times(const std::vector<EventChange>& events, bool old) const {
    constexpr std::size_t most = 6;
    std::string all;
    for (std::size_t i = 0; i < events.size() && i < most; ++i)
      all += (i > 0 ? ", " : "") + at(*(old ? events[i].was : events[i].is));
    return events.size() > most ? all + ", …" : all;
  }

  // Groups the changed events of a track by what happened to them.
  void track(const FactKey& k) {
    std::map<std::pair<What, Time>, std::vector<EventChange>> groups;
    for (EventChange& e : events_apart(events_of(was_.said, k), events_of(is_.said, k))) {
      const bool moved = e.was && e.is && *e.was != *e.is;
      const What what = !e.was ? What::added : !e.is ? What::removed : moved ? What::moved : What::changed;
      groups[{what, moved ? *e.is - *e.was : Time{}}].push_back(std::move(e));
    }
    for (auto& [how, events] : groups) {
      const std::string noun = k.part == FactPart::camera ? "camera cut" : k.part == FactPart::note ? "note" : "";
      FilmChange c{how.first, std::string(word_of(k.part)), noun.empty() ? k.name() : noun, "", "", {}, how.second, ""};
      if (events.size() == 1) c.before = events[0].before, c.after = events[0].after;
      c.words =
          words(noun.empty() ? k.name() + ": " : "", noun.empty() ? "event" : noun, how.first, how.second, events);
      c.events = std::move(events);
      add(std::move(c));
    }
  }
  std::string words(const std::string& head, const std::string& noun, What what, Time by,
                    const std::vector<EventChange>& all) const {
    const std::string some = counted(all.size(), noun);
    const EventChange& one = all.front();
    const bool alone = all.size() == 1;
    switch (what) {
      case What::moved:
        if (alone) return fmt::format("{}{} moved from {} to {}", head, noun, at(*one.was), at(*one.is));
        return fmt::format("{}{} moved by {} (from {})", head, some, length(by), times(all, true));
      case What::added:
        if (alone) return fmt::format("{}{} added at {}: {}", head, noun, at(*one.is), in_short(one.after));
        return fmt::format("{}{} added ({})", head, some, times(all, false));
      case What::removed:
        if (alone) return fmt::format("{}{} removed at {}: {}", head, noun, at(*one.was), in_short(one.before));
        return fmt::format("{}{} removed ({})", head, some, times(all, true));
      default:
        if (alone)
          return fmt::format("{}{} at {} changed from {} to {}", head, noun, at(*one.was), in_short(one.before),
                             in_short(one.after));
        return fmt::format("{}{} changed ({})", head, some, times(all, true));
    }
  }

  // The order of creation is the order in which flat films draw.
  void order(const std::set<std::string>& before, const std::set<std::string>& after) {
    std::vector<std::string> a, b;
    std::ranges::copy_if(was_.objects, std::back_inserter(a), [&](const auto& n) { return after.contains(n); });
    std::ranges::copy_if(is_.objects, std::back_inserter(b), [&](const auto& n) { return before.contains(n); });
    const auto [x, y] = std::ranges::mismatch(a, b);
    if (y == b.end()) return;
    add({What::moved,
         "order",
         *y,
         "",
         "",
         {},
         {},
         fmt::format("order of objects changed: {} is now created before {}", *y, *x)});
  }

  const Document& now_;
  Facts was_, is_;
  std::vector<FilmChange> changes_;
};

}  // namespace

std::string_view to_string(FilmChange::What what) {
  constexpr std::array<std::string_view, 5> words{"added", "removed", "changed", "moved", "renamed"};
  return words[static_cast<std::size_t>(what)];
}

std::vector<FilmChange> compare(const Document& old, const Document& now) {
  if (old == now) return {};
  std::vector<FilmChange> all = Comparing(old, now).all();
  if (all.empty())
    all.push_back({What::changed, "film", "film", "", "", {}, {}, "film: something changed that has no words here"});
  return all;
}

}  // namespace betwixt
