// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/event_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "betwixt/language.h"
#include "betwixt/track.h"
#include "editor/made_by.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/timeline/time_words.h"
#include "studio/viewport/hand.h"
#include "track/twerpers.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

using Segments = std::vector<std::pair<Time, Time>>;

// Splits the picked events of a track into runs without other events between them.
Segments parts(const Document& d, const Picked& p) {
  Segments all;
  for (const Time t : p.times)
    if (!all.empty() && event_before(d, p.target, t) == all.back().second)
      all.back().second = t;
    else
      all.emplace_back(t, t);
  return all;
}

// Returns whether the events of a track between two times are exactly the picked ones.
bool all_between(const Document& d, const Picked& p, Time from, Time to) {
  std::size_t there = 0;
  each_event(d, p.target, from, to, [&](const EventView&) { ++there; });
  return there ==
         static_cast<std::size_t>(std::ranges::count_if(p.times, [&](Time t) { return from <= t && t <= to; }));
}

// Groups targets with the same edit: "{ball,cube}.{position,color}".
class Together {
 public:
  explicit Together(const Document& d) : d_(d) {}
  void add(const Target& t, const Segments& segments) {
    const std::string object = d_.name(t.object), all = d_.name(t);
    auto& [same, functions] = of(t, segments);
    if (functions.empty() || functions.back().object != object)
      functions.push_back({object, {}});  // targets come in order
    functions.back().functions.push_back(all.substr(object.size() + 1));
  }
  // Calls f(layer words, target words, segments).
  template <class F>
  void each(F&& f) const {
    for (const auto& [same, objects] : groups_) {
      std::vector<std::pair<std::string, std::vector<std::string>>> named;  // functions; objects with just these
      for (const Of& o : objects) {
        const std::string functions = braces(o.functions);
        auto known = std::ranges::find(named, functions, &decltype(named)::value_type::first);
        if (known == named.end()) known = named.insert(known, {functions, {}});
        known->second.push_back(o.object);
      }
      for (const auto& [functions, names] : named)
        for (const std::string& function : pieces(functions))
          f(same.first, braces(names) + "." + function, same.second);
    }
  }

 private:
  struct Of {
    std::string object;
    std::vector<std::string> functions;
  };
  using Same = std::pair<std::string, Segments>;

  std::pair<Same, std::vector<Of>>& of(const Target& t, const Segments& segments) {
    const Same same{layer_words(d_, t), segments};
    const auto known = std::ranges::find(groups_, same, &std::pair<Same, std::vector<Of>>::first);
    return known != groups_.end() ? *known : groups_.emplace_back(same, std::vector<Of>{});
  }
  // Puts plain functions into one pair of braces. Components and velocities stay separate, behind zero bytes.
  static std::string braces(const std::vector<std::string>& names) {
    std::string plain, others;
    int count = 0;
    for (const std::string& n : names)
      if (n.find('.') == std::string::npos)
        plain += (count++ > 0 ? "," : "") + n;
      else
        others += '\0' + n;
    if (count > 1) plain = "{" + plain + "}";
    return count > 0 ? plain + others : others.substr(1);
  }
  static std::vector<std::string> pieces(const std::string& functions) {
    std::vector<std::string> all(1);
    for (const char c : functions) c == '\0' ? all.emplace_back() : all.back() += c;
    return all;
  }

  const Document& d_;
  std::vector<std::pair<Same, std::vector<Of>>> groups_;
};

// A row of a motion covers a segment, so it can be moved but not rewritten.
bool is_motion(const Document& d, const Target& t) { return spec_of(d.scene(), t.function).type == Type::motion; }

std::string words(const Document& d, Time from, Time to) { return format_time(from, d) + ".." + format_time(to, d); }

// Moving a value also moves its velocity, so the velocity needs no line of its own.
bool goes_along(const std::vector<Picked>& all, const Picked& velocity, Time at) {
  Target value = velocity.target;
  value.velocity = false;
  for (const Picked& p : all)
    if (p.target == value && !p.times.empty() && p.times.front() <= at && at <= p.times.back()) return true;
  return false;
}

// Clears the events and writes them again at other times.
Lines written_again(const Document& d, const std::vector<Picked>& picked, const std::function<Time(Time)>& when) {
  Lines gone, come;
  Together away(d);
  for (const Picked& p : picked) {
    if (is_motion(d, p.target)) continue;
    away.add(p.target, parts(d, p));
    for (const Time t : p.times) {
      Event e = *find_event(d, {p.target, t});
      e.time = when(t);
      come.push_back(event_line(d, p.target, e));
    }
  }
  away.each([&](const std::string& layer, const std::string& target, const Segments& segments) {
    for (const auto& [from, to] : segments)
      gone.push_back(
          fmt::format("{}clear {} {}", layer, target, from == to ? format_time(from, d) : words(d, from, to)));
  });
  gone.insert(gone.end(), come.begin(), come.end());
  return gone;
}

}  // namespace

bool TargetOrder::operator()(const Target& a, const Target& b) const {
  const auto key = [](const Target& t) {  // no layer comes first
    return std::tuple(t.object.index, t.function, t.layer.index + 1, t.velocity, t.component);
  };
  return key(a) < key(b);
}

std::vector<Picked> by_track(std::vector<EventAt> events) {
  std::ranges::sort(events, [](const EventAt& a, const EventAt& b) {
    return a.target == b.target ? a.time < b.time : TargetOrder()(a.target, b.target);
  });
  events.erase(std::ranges::unique(events).begin(), events.end());
  std::vector<Picked> all;
  for (const EventAt& e : events) {
    if (all.empty() || all.back().target != e.target) all.push_back({e.target, {}});
    all.back().times.push_back(e.time);
  }
  return all;
}

PickedTimes::PickedTimes(const std::vector<EventAt>& events) {
  for (Picked& p : by_track(events)) of_[p.target] = std::move(p.times);
}

bool PickedTimes::any(const Target& t, Time from, Time to) const {
  const auto known = of_.find(t);
  if (known == of_.end()) return false;
  const auto first = std::ranges::lower_bound(known->second, from);
  return first != known->second.end() && *first <= to;
}

std::pair<Time, Time> span(const std::vector<EventAt>& events) {
  std::pair<Time, Time> all{latest_time, earliest_time};
  for (const EventAt& e : events) all = {std::min(all.first, e.time), std::max(all.second, e.time)};
  return all;
}

std::string layer_words(const Document& d, const Target& t) { return t.layer ? "on " + d.name(t.layer) + " " : ""; }

const Event* find_event(const Document& d, const EventAt& e) {
  for (const Track* track : tracks_of(d.scene(), e.target))
    if (const Event* found = track->events.find(e.time)) return found;
  return nullptr;
}

std::string event_line(const Document& d, const Target& t, const Event& e) {
  return fmt::format("{}at {} {} {}", layer_words(d, t), format_time(e.time, d), d.name(t), write_event(d, t, e));
}

Lines move_lines(const Document& d, const std::vector<EventAt>& events, Time by) {
  const std::vector<Picked> picked = by_track(events);
  Together all(d);
  for (const Picked& p : picked) {
    Picked own = p;
    if (p.target.velocity) std::erase_if(own.times, [&](Time t) { return goes_along(picked, p, t); });
    if (own.times.empty()) continue;
    Segments segments = parts(d, own);
    if (by > Time{}) std::ranges::reverse(segments);  // move the last one first, to make room for the one before it
    all.add(p.target, segments);
  }
  Lines lines;
  all.each([&](const std::string& layer, const std::string& target, const Segments& segments) {
    for (const auto& [from, to] : segments)
      lines.push_back(fmt::format("{}move {} {} by {}", layer, target, words(d, from, to), length_words(d, by)));
  });
  return lines;
}

Lines stretch_lines(const Document& d, const std::vector<EventAt>& events, std::pair<Time, Time> from,
                    std::pair<Time, Time> to) {
  const std::vector<Picked> picked = by_track(events);
  const double was = (from.second - from.first).seconds(), is = (to.second - to.first).seconds(), factor = is / was;
  const Time first = std::min(from.first, to.first), last = std::max(from.second, to.second);
  if (!std::ranges::all_of(picked, [&](const Picked& p) { return all_between(d, p, first, last); }))
    return written_again(d, picked, [&](Time t) {
      return to.first + Time{std::llround(static_cast<double>((t - from.first).flicks) * factor)};
    });
  Together all(d);
  for (const Picked& p : picked)
    if (!p.target.velocity || !goes_along(picked, p, p.times.front())) all.add(p.target, {from});
  Lines lines;
  all.each([&](const std::string& layer, const std::string& target, const Segments&) {
    const Time by = to.first - from.first;
    if (by != Time{})
      lines.push_back(
          fmt::format("{}move {} {} by {}", layer, target, words(d, from.first, from.second), length_words(d, by)));
    lines.push_back(fmt::format("{}stretch {} {} by {}", layer, target, words(d, from.first + by, from.second + by),
                                write_number(factor)));
  });
  return lines;
}

Lines retime_lines(const Document& d, const std::vector<EventAt>& events, const std::function<Time(Time)>& when) {
  return written_again(d, by_track(events), when);
}

Lines reverse_lines(const Document& d, const std::vector<EventAt>& events) {
  const auto [first, last] = span(events);
  Together all(d);
  for (const Picked& p : by_track(events))
    all.add(p.target, all_between(d, p, first, last) ? Segments{{first, last}} : parts(d, p));
  Lines lines;
  all.each([&](const std::string& layer, const std::string& target, const Segments& segments) {
    for (const auto& [from, to] : segments)
      if (from != to) lines.push_back(fmt::format("{}reverse {} {}", layer, target, words(d, from, to)));
  });
  return lines;
}

Lines clear_lines(const Document& d, const std::vector<EventAt>& events) {
  Together all(d);
  for (const Picked& p : by_track(events)) all.add(p.target, parts(d, p));
  Lines lines;
  all.each([&](const std::string& layer, const std::string& target, const Segments& segments) {
    for (const auto& [from, to] : segments)
      lines.push_back(
          fmt::format("{}clear {} {}", layer, target, from == to ? format_time(from, d) : words(d, from, to)));
  });
  return lines;
}

Lines copy_lines(const Document& d, const Document& source, const std::vector<EventAt>& events, Time to,
                 ObjectId onto) {
  const std::vector<Picked> picked = by_track(events);
  const auto [first, last] = span(events);
  const auto still_there = [&](const Picked& p) {
    return all_between(source, p, first, last) &&
           std::ranges::all_of(
               p.times,
               [&](Time t) {
                 const Event *was = find_event(source, {p.target, t}), *is = find_event(d, {p.target, t});
                 return was && is && *was == *is;
               }) &&
           all_between(d, p, first, last);
  };
  Lines lines;
  Together all(d);
  for (const Picked& p : picked) {
    if (still_there(p)) {
      all.add(p.target, {{first, last}});
      continue;
    }
    Target target = p.target;
    if (is_motion(d, target)) continue;
    if (onto) target.object = onto;
    for (const Time t : p.times)
      if (const Event* e = find_event(source, {p.target, t})) {
        Event copy = *e;
        copy.time = to + (t - first);
        lines.push_back(event_line(d, target, copy));
      }
  }
  all.each([&](const std::string& layer, const std::string& target, const Segments&) {
    std::string line = fmt::format("{}copy {} {} to {}", layer, target, words(d, first, last), format_time(to, d));
    if (onto) line += " on " + d.name(onto) + target.substr(target.find('.'));
    lines.push_back(line);
  });
  return lines;
}

Lines twerper_lines(const Document& d, const std::vector<EventAt>& events, std::string_view name) {
  const auto twerper = [&]() -> std::optional<Twerper> {
    if (name.empty()) return Twerper::unset;
    if (const auto own = find_own_twerper(d.scene(), name)) return own;
    return find_twerper(name);
  }();
  Lines lines;
  for (const EventAt& at : events) {
    const Event* e = find_event(d, at);
    if (!e || !twerper || e->release || (e->keep && *twerper == Twerper::unset)) continue;
    const Type type = spec_of(d.scene(), at.target.function).type;
    if (is_motion(d, at.target) || type == Type::attachment) continue;
    if (*twerper != Twerper::unset &&
        !fits(d.scene(), *twerper, at.target.component < 0 ? type : component_track_type(type)))
      continue;
    Event changed = *e;
    changed.twerper = *twerper;
    if (changed.detail) changed.detail.edit().arguments = {};
    if (name == "steps") changed.detail.edit().arguments[0] = 4, changed.detail.edit().arguments[1] = 0;
    if (!(changed == *e)) lines.push_back(event_line(d, at.target, changed));
  }
  return lines;
}

Document bare_tracks(const Document& d, const std::vector<ObjectId>& objects, ObjectId of_layer) {
  auto scene = std::make_shared<Scene>(d.scene());
  for (const ObjectId id : objects) {
    if (!find_object(*scene, id)) continue;
    std::vector<Slot>& all = scene->objects.edit(id.index).slots;
    std::vector<Slot> bare;
    for (Slot& slot : all) {
      const bool laid = of_layer && slot.layer == of_layer;
      if ((slot.layer && !laid) || slot.function == fn::obstacles) continue;
      if (laid && !bare.empty() && bare.back().function == slot.function) bare.pop_back();
      slot.layer = {}, slot.filters.clear(), slot.velocity = {};
      bare.push_back(std::move(slot));
    }
    all = std::move(bare);
  }
  return Document(std::move(scene));
}

}  // namespace betwixt::studio
