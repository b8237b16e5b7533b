// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/fact_merge.h"

#include <algorithm>
#include <set>

#include "compare/events_apart.h"

namespace betwixt {
namespace {

using FactMap = std::map<FactKey, std::string>;

std::optional<std::string> said_in(const FactMap& facts, const FactKey& k) {
  const auto at = facts.find(k);
  return at == facts.end() ? std::nullopt : std::optional(at->second);
}
FactKey at_time(FactKey track, Time t) { return track.time = t, track; }

class FactMerge {
 public:
  FactMerge(const Facts& base, const Facts& mine, const Facts& theirs)
      : base_(base.said), mine_(mine.said), theirs_(theirs.said) {}

  MergedFacts merged() {
    decide_objects();
    std::set<FactKey> tracks, plain;
    for (const FactMap* facts : {&base_, &mine_, &theirs_})
      for (const auto& [key, said] : *facts) {
        if (gone_.contains(key.object) || kept_.contains(key.object)) continue;
        if (key.timed())
          tracks.insert(key.track());
        else
          plain.insert(key);
      }
    for (const auto& [key, said] : mine_)
      if (kept_.contains(key.object)) out_.said.emplace(key, said);
    for (const FactKey& key : plain) merge_plain(key);
    for (const FactKey& key : tracks) merge_track(key);
    return std::move(out_);
  }

 private:
  // Returns whether anything about an object differs.
  static bool differs(const FactMap& a, const FactMap& b, const std::string& object) {
    const auto about = [&](const auto& fact) { return fact.first.object == object; };
    return std::ranges::any_of(a, [&](const auto& f) { return about(f) && said_in(b, f.first) != f.second; }) ||
           std::ranges::any_of(b, [&](const auto& f) { return about(f) && !a.contains(f.first); });
  }

  // An object that one side removed is gone if the other left it as it was, with all below it. Otherwise mine decides.
  void decide_objects() {
    std::set<FactKey> objects;
    for (const FactMap* facts : {&base_, &mine_, &theirs_})
      for (const auto& [key, said] : *facts)
        if (key.part == FactPart::object) objects.insert(key);
    std::map<std::string, std::vector<FactKey>> removed_by_theirs;  // by the topmost object that went with them
    for (const FactKey& key : objects) {
      const auto b = said_in(base_, key), m = said_in(mine_, key), t = said_in(theirs_, key);
      if (b && !m) {
        gone_.insert(key.object);
        if (t && differs(base_, theirs_, key.object)) lose_changes_of(key.object);
      } else if (b && !t) {
        removed_by_theirs[top_of(key.object)].push_back(key);
      } else if (m && t && m != t && m != b && t != b) {
        kept_.insert(key.object);  // both made another thing of the same name
        lose_changes_of(key.object);
      }
    }
    for (const auto& [top, keys] : removed_by_theirs) {
      const bool changed =
          std::ranges::any_of(keys, [&](const FactKey& k) { return differs(base_, mine_, k.object); }) ||
          std::ranges::any_of(objects, [&](const FactKey& k) {
            return k.object.starts_with(top + "/") && !base_.contains(k) && mine_.contains(k);
          });
      for (const FactKey& k : keys) (changed ? kept_ : gone_).insert(k.object);
      if (const FactKey key{FactPart::object, top, "", "", {}}; changed)
        out_.conflicts.push_back({key, said_in(mine_, key), key, {}});
    }
  }
  // Returns the topmost object above this one, or itself, that theirs has removed.
  std::string top_of(const std::string& object) const {
    for (std::size_t slash = object.find('/'); slash != std::string::npos; slash = object.find('/', slash + 1)) {
      const FactKey above{FactPart::object, object.substr(0, slash), "", "", {}};
      if (base_.contains(above) && !theirs_.contains(above)) return above.object;
    }
    return object;
  }
  // All that theirs changed of an object is in conflict.
  void lose_changes_of(const std::string& object) {
    for (const auto& [key, said] : theirs_)
      if (key.object == object && said_in(base_, key) != said)
        out_.conflicts.push_back({key, said_in(mine_, key), key, said});
  }

  void merge_plain(const FactKey& key) {
    const auto b = said_in(base_, key), m = said_in(mine_, key), t = said_in(theirs_, key);
    const auto& result = m == b ? t : m;
    if (result) out_.said.emplace(key, *result);
    if (m != b && t != b && m != t) out_.conflicts.push_back({key, m, key, t});
  }

  // Notes do not exclude each other: those of a time are merged as sets of lines.
  void merge_notes(const FactKey& track) {
    std::set<Time> times;
    for (const FactMap* facts : {&base_, &mine_, &theirs_})
      for (const auto& [time, said] : events_of(*facts, track)) times.insert(time);
    for (const Time time : times) {
      const FactKey key = at_time(track, time);
      const auto b = notes_in(base_, key), m = notes_in(mine_, key), t = notes_in(theirs_, key);
      const auto has = [](const auto& all, const std::string& one) { return std::ranges::find(all, one) != all.end(); };
      std::string all;
      const auto add = [&](const std::string& one) { all += (all.empty() ? "" : "\n") + one; };
      for (const std::string& one : m)
        if (has(t, one) || !has(b, one)) add(one);
      for (const std::string& one : t)
        if (!has(b, one) && !has(m, one)) add(one);
      if (!all.empty()) out_.said.emplace(key, all);
    }
  }
  static std::vector<std::string> notes_in(const FactMap& facts, const FactKey& key) {
    std::vector<std::string> all;
    std::string left = said_in(facts, key).value_or("");
    while (!left.empty()) {
      const std::size_t feed = std::min(left.find('\n'), left.size());
      all.push_back(left.substr(0, feed));
      left.erase(0, feed + 1);
    }
    return all;
  }

  void merge_track(const FactKey& track) {
    if (track.part == FactPart::note) return merge_notes(track);
    const TrackEvents base = events_of(base_, track), theirs = events_of(theirs_, track);
    TrackEvents result = events_of(mine_, track);
    std::map<Time, EventChange> mine_changed;
    for (EventChange& e : events_apart(base, result))
      if (e.was) mine_changed.emplace(*e.was, std::move(e));
    std::vector<EventChange> take;
    for (EventChange& e : events_apart(base, theirs)) {
      const auto also = e.was ? mine_changed.find(*e.was) : mine_changed.end();
      if (also == mine_changed.end())
        take.push_back(std::move(e));
      else if (also->second.is != e.is || also->second.after != e.after)
        lose(track, e, also->second.is, also->second.after);
    }
    // All are taken away before the first is put: events that move together pass each other's times.
    for (const EventChange& e : take)
      if (e.was) result.erase(*e.was);
    std::map<Time, std::string> put;
    for (const EventChange& e : take) {
      if (!e.is) continue;
      const auto there = result.find(*e.is);
      if (there == result.end()) {
        result.emplace(*e.is, e.after), put.emplace(*e.is, e.after);
      } else if (there->second != e.after) {
        lose(track, e, there->first, there->second);
        if (e.was) result.emplace(*e.was, e.before);
      }
    }
    for (const auto& [time, said] : result) out_.said.emplace(at_time(track, time), said);
  }
  void lose(const FactKey& track, const EventChange& e, std::optional<Time> mine_at, const std::string& mine) {
    const Time at = mine_at.value_or(e.was.value_or(e.is.value_or(Time{})));
    const std::optional<std::string> kept = mine_at ? std::optional(mine) : std::nullopt;
    const std::optional<std::string> lost = e.is ? std::optional(e.after) : std::nullopt;
    out_.conflicts.push_back({at_time(track, at), kept, at_time(track, e.is.value_or(at)), lost});
  }

  const FactMap &base_, &mine_, &theirs_;
  MergedFacts out_;
  std::set<std::string> gone_, kept_;
};

}  // namespace

MergedFacts merge_facts(const Facts& base, const Facts& mine, const Facts& theirs) {
  return FactMerge(base, mine, theirs).merged();
}

}  // namespace betwixt
