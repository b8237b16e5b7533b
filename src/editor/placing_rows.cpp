// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes changed events and values into the rows that gave them before.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "betwixt/language.h"
#include "betwixt/track.h"
#include "editor/placing.h"
#include "editor/text_rows.h"
#include "language/moments.h"
#include "language/values.h"
#include "scene/document.h"

namespace betwixt {
namespace {

// An event as in its row: the time, and the text after it.
struct Said {
  Time time;
  std::string rest;
};
// The events of a target that the step removed, and those that it added.
struct Changed {
  Target target;
  std::vector<Said> gone, come;
};
struct Changes {
  std::vector<Changed> events;
  std::vector<std::pair<Target, std::string>> set;  // targets and new values
};

// Compares the events of a target in two documents. Events with a shared value are equal and are skipped.
Changed compare(const Document& before, const Document& after, const Target& t) {
  Changed c{t, {}, {}};
  const std::vector<EventView> was = events(before, t), is = events(after, t);
  const auto say = [&](const Document& d, const EventView& e, std::vector<Said>& into) {
    into.push_back({e.time, write_event(d, t, e.time)});
  };
  for (std::size_t i = 0, k = 0; i < was.size() || k < is.size();) {
    if (k == is.size() || (i < was.size() && was[i].time < is[k].time)) {
      say(before, was[i++], c.gone);
    } else if (i == was.size() || is[k].time < was[i].time) {
      say(after, is[k++], c.come);
    } else {
      const bool shared = was[i].value && was[i].value == is[k].value;
      if (!shared && write_event(before, t, was[i].time) != write_event(after, t, is[k].time))
        say(before, was[i], c.gone), say(after, is[k], c.come);
      ++i, ++k;
    }
  }
  return c;
}

// Returns nullopt if objects were created, deleted or renamed: no row can be changed for that.
std::optional<Changes> changes(const Document& before, const Document& after) {
  const Scene &was = before.scene(), &is = after.scene();
  if (was.objects.size() != is.objects.size() || !was.names.same(is.names)) return std::nullopt;
  Changes all;
  is.objects.each_changed(was.objects, [&](std::size_t i) {
    const Object &a = was.objects[i], &b = is.objects[i];
    const ObjectId id{static_cast<std::uint32_t>(i)};
    const auto tracks = [&](const Strand* x, const Strand& y, Target t) {
      if (!x || !x->track.same(y.track))
        if (Changed c = compare(before, after, t); !c.gone.empty() || !c.come.empty())
          all.events.push_back(std::move(c));
      for (std::size_t k = 0; k < y.components.size(); ++k) {
        if (x && k < x->components.size() && x->components[k].same(y.components[k])) continue;
        t.component = static_cast<int>(k);
        if (Changed c = compare(before, after, t); !c.gone.empty() || !c.come.empty())
          all.events.push_back(std::move(c));
      }
    };
    for (const Slot& slot : b.slots) {
      const Slot* old = a.find(slot.function, slot.layer);
      Target t{id, slot.function};
      t.layer = slot.layer;
      tracks(old, slot, t);
      if (slot.set && !(old && old->set == slot.set) && !std::holds_alternative<Procedure>(*slot.set)) {
        const auto name_of = [&](ObjectId o) { return after.name(o); };
        all.set.emplace_back(t, write_value(*slot.set, spec_of(is, slot.function), -1, name_of));
      }
      t.velocity = true;
      tracks(old ? &old->velocity : nullptr, slot.velocity, t);
    }
  });
  return all;
}

// The change of a row.
struct Fate {
  bool goes = false;
  std::optional<Time> time;
  std::optional<std::string> rest;
  friend bool operator==(const Fate&, const Fate&) = default;
};

class Placing {
 public:
  Placing(const std::string& text, const Document& before, const Document& after)
      : text_(text), before_(before), after_(after) {}

  std::optional<TextEdits> edits() {
    const std::optional<Changes> all = changes(before_, after_);
    if (!all || (all->events.empty() && all->set.empty())) return std::nullopt;
    std::vector<Target> targets;
    for (const Changed& c : all->events) targets.push_back(c.target);
    for (const auto& [target, value] : all->set) targets.push_back(target);
    found_ = rows_about(text_, before_, targets);
    for (const Changed& c : all->events)
      if (!settle(c)) return std::nullopt;
    for (const auto& [target, value] : all->set)
      if (!settle(target, value)) return std::nullopt;
    for (const SheetText& sheet : found_.sheets)
      if (!rewrite(sheet)) return std::nullopt;
    std::ranges::sort(edits_, [](const TextEdit& a, const TextEdit& b) { return a.at > b.at; });
    return std::move(edits_);
  }

 private:
  using Place = std::pair<SheetText*, std::size_t>;  // a row: its sheet and its index

  // Returns all rows that give the event, in the order of the text.
  std::vector<Place> rows_of(const Target& t, Time time) {
    std::vector<Place> all;
    for (SheetText& s : found_.sheets) {
      if (std::ranges::find(s.targets, t) == s.targets.end()) continue;
      for (std::size_t i = 0; i < s.rows.size(); ++i)
        if (s.rows[i].when == time) all.emplace_back(&s, i);
    }
    return all;
  }

  bool decide(const Place& at, const Fate& fate) {
    const auto [there, fresh] = fates_.try_emplace(at, fate);
    return fresh || there->second == fate;  // all targets of a shared row must agree
  }

  // Pairs removed events with added ones, and changes their rows in order.
  bool settle(const Changed& c) {
    const std::size_t both = std::min(c.gone.size(), c.come.size());
    bool same_times = c.gone.size() == c.come.size();
    for (std::size_t i = 0; same_times && i < both; ++i) same_times = c.gone[i].time == c.come[i].time;
    std::vector<bool> used(c.come.size());
    const auto take = [&](const Said& was) -> std::optional<std::size_t> {
      const auto fits = [&](auto&& how) -> std::optional<std::size_t> {
        for (std::size_t k = 0; k < c.come.size(); ++k)
          if (!used[k] && how(c.come[k])) return k;
        return std::nullopt;
      };
      if (const auto k = fits([&](const Said& s) { return s.time == was.time && (same_times || s.rest == was.rest); }))
        return k;
      if (const auto k = fits([&](const Said& s) { return s.rest == was.rest; })) return k;
      return fits([&](const Said& s) { return s.time == was.time; });
    };
    for (const Said& was : c.gone) {
      const std::vector<Place> rows = rows_of(c.target, was.time);
      if (rows.empty()) return false;
      const Place& row = rows.back();  // the last one takes effect
      Fate fate;
      if (const auto k = take(was)) {
        used[*k] = true;
        if (c.come[*k].time != was.time) fate.time = c.come[*k].time;
        if (c.come[*k].rest != was.rest) fate.rest = c.come[*k].rest;
      } else {
        fate.goes = true;
      }
      if (!decide(row, fate)) return false;
      // Without this, the earlier rows would take effect again.
      if (fate.goes || fate.time)
        for (std::size_t i = 0; i + 1 < rows.size(); ++i)
          if (!decide(rows[i], {.goes = true, .time = {}, .rest = {}})) return false;
    }
    for (std::size_t k = 0; k < c.come.size(); ++k)
      if (!used[k] && !add(c.target, c.come[k])) return false;
    return true;
  }

  // Adds a row to the last sheet that has this target only. A single `at` line becomes a sheet.
  bool add(const Target& t, const Said& said) {
    SheetText* single = nullptr;
    for (auto s = found_.sheets.rbegin(); s != found_.sheets.rend(); ++s) {
      if (s->targets.size() != 1 || !(s->targets[0] == t)) continue;
      if (s->alone && !single) single = &*s;
      if (s->alone) continue;
      added_[&*s].push_back(said);
      return true;
    }
    if (!single) return false;
    added_[single].push_back(said);
    return true;
  }

  bool settle(const Target& t, const std::string& value) {
    for (auto v = found_.values.rbegin(); v != found_.values.rend(); ++v) {
      if (!(v->target == t)) continue;
      edits_.push_back({v->value.at, text_.substr(v->value.at, v->value.size), value});
      return true;
    }
    return false;
  }

  // Writes a time as it is in the block of the row.
  std::string written(Time film, std::string_view as, const SectionClock& clock) const {
    if (const auto later = behind_moment(film, as)) return *later;
    const Time t = clock.own_time(film);
    return as.ends_with('s') ? write_seconds(t) : format_time(t, after_);
  }
  // Returns voice:"square"+5f if the row had such a time, and whole frames lead from the word to the new time.
  std::optional<std::string> behind_moment(Time t, std::string_view as) const {
    const std::string_view moment = as.substr(0, moment_length(as));
    const auto word = moment.empty() ? Result<Time>(Time{}) : parse_time(moment, after_);
    if (moment.empty() || !word) return std::nullopt;
    const Rate rate = after_.rate();
    const double frames = std::round((t - *word).seconds() * rate.per_second());
    if (*word + rate.span(frames) != t) return std::nullopt;
    return frames == 0 ? std::string(moment) : fmt::format("{}{:+}f", moment, static_cast<std::int64_t>(frames));
  }
  std::string part(Span s) const { return text_.substr(s.at, s.size); }

  // Writes three angles without `euler`, if the author did.
  static std::string as_before(const std::string& rest, std::string_view before) {
    return before.starts_with('(') && rest.starts_with("euler(") ? rest.substr(5) : rest;
  }
  // Returns the row's line with its new time and value.
  std::string line_of(const RowText& row, const Fate& fate) const {
    std::string line = part(row.line);
    const auto put = [&](Span s, const std::string& instead) { line.replace(s.at - row.line.at, s.size, instead); };
    if (fate.rest) put(row.rest, as_before(*fate.rest, part(row.rest)));
    if (fate.time) put(row.time, written(*fate.time, part(row.time), row.clock));
    return line;
  }

  // Turns `at 1f ball.position (0 0 0)` and the added events into a sheet.
  bool make_sheet(const SheetText& sheet, SheetText* key, const std::vector<Said>& more) {
    const RowText& row = sheet.rows[0];
    const auto f = fates_.find({key, 0});
    const Fate fate = f == fates_.end() ? Fate{} : f->second;
    const std::string line = part(sheet.opener);
    const std::size_t end = row.rest.end() - row.line.at;
    const std::string remark = line.substr(end, line.find('\n', end) - end);
    struct Event {
      Time when;
      std::string text;
    };
    std::vector<Event> events;
    const std::string as = part(row.time);
    const std::string margin = line.substr(0, indentation(line));
    if (!fate.goes) {
      const Time when = fate.time.value_or(row.when);
      events.push_back({when, fmt::format("{}  {} {}{}\n", margin, fate.time ? written(when, as, row.clock) : as,
                                          fate.rest ? *fate.rest : part(row.rest), remark)});
    }
    for (const Said& s : more)
      events.push_back({s.time, fmt::format("{}  {} {}\n", margin, written(s.time, as, row.clock), s.rest)});
    std::ranges::stable_sort(events, [](const Event& a, const Event& b) { return a.when < b.when; });
    const Target& t = sheet.targets[0];
    std::string all = margin + (t.layer ? "on " + after_.name(t.layer) + " " : "") + after_.name(t) + "\n";
    for (const Event& e : events) all += e.text;
    edits_.push_back({sheet.opener.at, line, std::move(all)});
    return true;
  }

  bool rewrite(const SheetText& sheet) {
    struct Line {
      Time when;
      std::string text;
    };
    SheetText* const key = const_cast<SheetText*>(&sheet);
    const auto adds = added_.find(key);
    bool touched = adds != added_.end(), moved = touched;
    for (std::size_t i = 0; i < sheet.rows.size(); ++i)
      if (const auto f = fates_.find({key, i}); f != fates_.end())
        touched = true, moved |= f->second.goes || f->second.time;
    if (!touched) return true;
    if (sheet.alone && adds != added_.end()) return make_sheet(sheet, key, adds->second);
    if (sheet.alone) {
      const Fate& fate = fates_.at({key, 0});
      edits_.push_back({sheet.opener.at, part(sheet.opener), fate.goes ? "" : line_of(sheet.rows[0], fate)});
      return true;
    }
    if (moved && std::ranges::any_of(sheet.rows, &RowText::relative)) return false;
    const auto by_time = [](const Line& a, const Line& b) { return a.when < b.when; };
    std::vector<Line> lines;
    std::size_t from = sheet.opener.end();
    bool sorted = true;
    for (std::size_t i = 0; i < sheet.rows.size(); ++i) {
      const RowText& row = sheet.rows[i];
      const auto f = fates_.find({key, i});
      const Fate fate = f == fates_.end() ? Fate{} : f->second;
      // Comments and empty lines above a row move with it.
      std::string text = part({from, row.line.at - from});
      from = row.line.end();
      if (!fate.goes) text += line_of(row, fate);
      if (i > 0 && sheet.rows[i - 1].when > row.when) sorted = false;
      lines.push_back({fate.time.value_or(row.when), std::move(text)});
    }
    const std::string margin =
        sheet.rows.empty() ? text_.substr(sheet.opener.at, indentation(part(sheet.opener))) + "  "
                           : part({sheet.rows.back().line.at, sheet.rows.back().time.at - sheet.rows.back().line.at});
    if (adds != added_.end())
      for (const Said& s : adds->second) {
        const std::string like = sheet.rows.empty() ? "f" : part(sheet.rows.back().time);
        Line line{s.time, fmt::format("{}{} {}\n", margin, written(s.time, like, sheet.clock), s.rest)};
        if (!lines.empty() && !lines.back().text.empty() && lines.back().text.back() != '\n') lines.back().text += '\n';
        lines.insert(sorted ? std::ranges::upper_bound(lines, line, by_time) : lines.end(), std::move(line));
      }
    if (sorted && moved) std::ranges::stable_sort(lines, by_time);
    const std::size_t begin = sheet.opener.end();
    std::string all = !lines.empty() && sheet.opener.size > 0 && text_[begin - 1] != '\n' ? "\n" : "";
    for (Line& line : lines) {
      if (!all.empty() && all.back() != '\n') all += '\n';
      all += line.text;
    }
    edits_.push_back({begin, part({begin, from - begin}), std::move(all)});
    return true;
  }

  const std::string& text_;
  const Document &before_, &after_;
  TextRows found_;
  std::map<Place, Fate> fates_;
  std::map<SheetText*, std::vector<Said>> added_;
  TextEdits edits_;
};

}  // namespace

std::optional<TextEdits> place_in_rows(const std::string& text, const Document& before, const Document& after) {
  return Placing(text, before, after).edits();
}

}  // namespace betwixt
