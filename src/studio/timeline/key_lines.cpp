// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/key_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "betwixt/object.h"
#include "betwixt/track.h"
#include "editor/made_by.h"
#include "scene/document.h"
#include "studio/objects/object_lines.h"
#include "studio/poses/mixed.h"

namespace betwixt::studio {
namespace {

// Reads tracks as their events make them, without filters, velocities and layers.
class BareValues {
 public:
  BareValues(const Document& d, const Program& before, const std::vector<Target>& targets) : d_(d), before_(before) {
    for (const Target& t : targets) objects_.push_back(t.object);
  }
  Value at(const Target& target, Time t) {
    auto known = of_.find(target.layer.index);
    if (known == of_.end())
      known = of_.emplace(target.layer.index, Program::compile(bare_tracks(d_, objects_, target.layer), before_)).first;
    Target bare = target;
    bare.layer = {};
    return known->second.read(bare, t);
  }

 private:
  const Document& d_;
  const Program& before_;
  std::vector<ObjectId> objects_;
  std::map<std::uint32_t, Program> of_;  // by layer
};

std::string line_of_value(const Document& d, const Target& target, Time t, const Value& value) {
  Event e;
  e.time = t;
  const Type type = spec_of(d.scene(), target.function).type;
  e.value = written_plain(value, type == Type::angle || type == Type::rotation);
  return event_line(d, target, e) + way_of_new_event(d, target, t);
}

}  // namespace

std::vector<Target> animated_tracks(const Document& d, const std::vector<ObjectId>& objects, bool or_position) {
  std::vector<Target> all;
  for (const ObjectId id : objects) {
    const std::size_t before = all.size();
    for (const TrackView& t : tracks(d, id))
      if (!t.target.velocity && t.event_count > 0) all.push_back(t.target);
    if (all.size() > before || !or_position) continue;
    for (const FunctionView& f : functions(d, id))
      if (f.name == "position") all.emplace_back(id, f.id);
  }
  std::erase_if(all, [&](const Target& t) {
    const Type type = spec_of(d.scene(), t.function).type;
    return type == Type::motion || type == Type::attachment;
  });
  return all;
}

std::vector<Target> tracks_with_transforms(const Document& d, const std::vector<ObjectId>& objects) {
  std::vector<Target> all = animated_tracks(d, objects, false);
  for (const ObjectId id : objects)
    for (const FunctionView& f : functions(d, id)) {
      if (f.name != "position" && f.name != "rotation" && f.name != "scale") continue;
      const auto is_of_it = [&](const Target& t) { return t.object == id && t.function == f.id && !t.layer; };
      if (std::ranges::none_of(all, is_of_it)) all.emplace_back(id, f.id);
    }
  return all;
}

std::vector<ObjectId> whole_characters(const Document& d, const std::vector<ObjectId>& objects, Time t) {
  std::vector<ObjectId> roots;
  for (ObjectId id : objects) {
    std::set<std::uint32_t> seen;
    for (ObjectId up = id; up && seen.insert(up.index).second; up = parent_at(d, up, t)) id = up;
    roots.push_back(id);
  }
  return all_below_at(d, roots, t);
}

std::vector<Target> changed_tracks(const Program& program, const std::vector<Target>& targets, Time t) {
  const Document& d = program.document();
  BareValues values(d, program, targets);
  std::vector<Target> all;
  for (const Target& target : targets) {
    const auto last = event_before(d, target, t);
    if (!last || written_plain(values.at(target, *last)) != written_plain(values.at(target, t))) all.push_back(target);
  }
  return all;
}

Lines insert_lines(const Document& d, const Program& before, const std::vector<Target>& targets, Time t) {
  BareValues values(d, before, targets);
  Lines lines;
  for (const Target& target : targets) lines.push_back(line_of_value(d, target, t, values.at(target, t)));
  return lines;
}

Lines breakdown_lines(const Program& program, const std::vector<Target>& targets, Time t, double share) {
  const Document& d = program.document();
  BareValues values(d, program, targets);
  Lines lines;
  for (const Target& target : targets) {
    const auto before = event_before(d, target, t), after = next_event(d, target, t + Time{1});
    if (!before || !after) continue;
    lines.push_back(line_of_value(d, target, t, mixed(values.at(target, *before), values.at(target, *after), share)));
  }
  return lines;
}

Lines hold_lines(const Program& program, const std::vector<Target>& targets, Time t) {
  const Document& d = program.document();
  BareValues values(d, program, targets);
  std::vector<EventAt> last;
  Lines inserted;
  for (const Target& target : targets) {
    const auto before = event_before(d, target, t);
    if (!before) continue;
    last.push_back({target, *before});
    inserted.push_back(line_of_value(d, target, t, values.at(target, *before)));
  }
  Lines lines = twerper_lines(d, last, "hold");
  lines.insert(lines.end(), inserted.begin(), inserted.end());
  return lines;
}

std::function<Time(Time)> retiming(const Document& d, const std::vector<EventAt>& events,
                                   const std::function<double(double)>& share) {
  const auto [first, last] = span(events);
  std::map<Time, Time> to;
  std::set<Time> taken;
  for (const EventAt& e : events) to[e.time] = e.time;
  for (auto& [from, time] : to) {
    const double part = static_cast<double>((from - first).flicks) / static_cast<double>((last - first).flicks);
    const double way = std::clamp(share(part), 0.0, 1.0);
    time = first + Time{std::llround(static_cast<double>((last - first).flicks) * way)};
    const Time frame = d.rate().frame(std::round(d.rate().frame_number(time)));
    if (d.rate().frame(std::round(d.rate().frame_number(from))) == from && !taken.contains(frame)) time = frame;
    while (!taken.insert(time).second) time = time + Time{1};
  }
  return [to = std::move(to)](Time t) {
    const auto known = to.find(t);
    return known == to.end() ? t : known->second;
  };
}

std::vector<std::string> left_behind(const Document& d, const std::vector<EventAt>& events, Time t) {
  std::set<std::string> names;
  std::set<std::uint32_t> objects;
  for (const EventAt& e : events)
    if (objects.insert(e.target.object.index).second)
      for (const FunctionView& f : functions(d, e.target.object)) {
        const Target whole(e.target.object, f.id);
        if (!made_by(d, whole, t).code.empty()) names.insert(d.name(whole));
        for (const FilterView& filter : filters(d, whole))
          if (filter.segment) names.insert(d.name(whole));
      }
  return {names.begin(), names.end()};
}

}  // namespace betwixt::studio
