// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display lists: make, edit, delete, start, and the rows below the first two. (Animation Imaging Model, 2.2.1, 3.3.3)
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/names.h"
#include "language/reader.h"

namespace betwixt {
namespace {

struct Word {
  std::string_view word, usage;
};
// In the order of Drawing, and behind them what is no command of a list.
constexpr Word rows[] = {
    {"point", "point (x y z) …"},
    {"vector", "vector (x y z) (x y z) …"},
    {"polygon", "polygon (x y z) (x y z) (x y z) …"},
    {"text", "text \"…\""},
    {"color", "color COLOR"},
    {"texture", "texture \"FILE\""},
    {"font", "font \"…\""},
    {"push", "push"},
    {"pop", "pop"},
    {"multiply", "multiply TRANSFORM, or the transform alone"},
    {"call", "call NAME"},
    {"begin", "begin ENV [since TIME]"},
    {"end", "end"},
    {"view", "view from (x y z) to (x y z)"},
    {"perspective", "perspective ANGLE"},
    {"orthographic", "orthographic HEIGHT"},
    {"tag", "tag NAME"},
    {"replace", "replace TAG [OFFSET]"},
};
static_assert(std::size(rows) == drawing_names.size() + 2);

constexpr std::string_view factors[] = {"translate", "rotate", "scale", "matrix"};

std::string said(const DisplayCommand& c) {
  const auto* name = std::get_if<Text>(&c.value);
  const auto word = drawing_names[static_cast<std::size_t>(c.what)];
  return name && c.what != Drawing::text ? fmt::format("{} {}", word, **name) : std::string(word);
}

// What is wrong with a command that has no other half.
std::string without_half(const DisplayCommand& c) {
  const bool closes = c.what == Drawing::pop || c.what == Drawing::end;
  const bool stack = c.what == Drawing::pop || c.what == Drawing::push;
  return closes ? fmt::format("there is no '{}' here that this '{}' could end", stack ? "push" : "begin", said(c))
                : fmt::format("this '{}' is never followed by its '{}'", said(c), stack ? "pop" : "end");
}

std::string path(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, " → ")); }

}  // namespace

std::vector<std::pair<std::string_view, std::string_view>> Reader::row_words() {
  std::vector<std::pair<std::string_view, std::string_view>> all;
  for (const Word& w : rows) all.emplace_back(w.word, w.usage);
  return all;
}

// A list that is there: at the time of the command, or at any time where it has none.
bool Reader::list_name(Cursor& c, std::string_view& word) {
  c.space();
  word = c.word();
  if (word.empty()) return c.fail_here(Code::syntax, "the name of a display list is missing here");
  if (timed_ ? list_at(s, word, time_) != nullptr : !versions(s, word).empty()) return true;
  if (const ObjectId id = s.names.find(word); id && versions(s, word).empty())
    return c.fail(Code::name, fmt::format("'{}' is {}, not a display list", word, a_kind(s.objects[id.index].kind)),
                  word, "display lists are made by make NAME; objects are there without being started");
  return c.fail(Code::name,
                fmt::format("there is no display list '{}'{}", word.substr(0, 60),
                            versions(s, word).empty() ? "" : " at that time"),
                word, did_you_mean(word, list_names(s)));
}

void Reader::open(std::string_view word) {
  Sheet& sheet = source_.sheet;
  sheet = {};
  sheet.open = true;
  sheet.list = word;
  sheet.place = word;
  if (timed_) sheet.from = time_;
  for (const Time from : timed_ ? std::vector{time_} : versions(s, word))
    sheet.versions.push_back({from, at_end, {}, {}});
  sheet.before = s.lists, sheet.later_before = s.later_lists;
}

bool Reader::make_list(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  const std::string name(word);
  if (word.empty()) return c.fail_here(Code::syntax, "the name of the new display list is missing here");
  const bool known = !versions(s, name).empty();
  if (known && !timed_)
    return c.fail(Code::name, fmt::format("there is a display list '{}' already", name), word,
                  fmt::format("edit {} opens it again", name));
  if ((!known && !free_name(c, name, word)) || !finish(c)) return false;
  const Cow<DisplayLists> before = s.lists;
  const Cow<LaterLists> later_before = s.later_lists;
  betwixt::edit_list(s, name, list_time()) = {};
  open(word);
  source_.sheet.before = before, source_.sheet.later_before = later_before;
  source_.sheet.changed = known;  // what it was before is not shown any more
  return true;
}

bool Reader::edit_list(Cursor& c) {
  std::string_view word;
  if (!list_name(c, word) || !finish(c)) return false;
  open(word);
  return true;
}

bool Reader::delete_list(Cursor& c) {
  std::string_view word;
  if (!list_name(c, word) || !finish(c)) return false;
  const std::string name(word);
  betwixt::delete_list(s, name, list_time());
  std::erase_if(unfinished_,
                [&](const auto& u) { return u.first.first == name && (!timed_ || u.first.second == time_); });
  std::vector<std::string> callers;
  for (const std::string_view other : list_names(s)) {
    const DisplayList* list = list_at(s, other, list_time());
    for (std::size_t i = 0; list && i < list->commands.size(); ++i)
      if (const DisplayCommand& command = list->commands[i];
          command.what == Drawing::call && *std::get<Text>(command.value) == name) {
        callers.push_back(fmt::format("'{}'", other));
        break;
      }
  }
  const char* since = timed_ ? "from then on" : "now";
  if (!callers.empty())
    note(Severity::warning,
         fmt::format("{} still call{} '{}', which draws nothing {}", fmt::join(callers, ", "),
                     callers.size() == 1 ? "s" : "", name, since),
         word);
  const bool shown = !s.main.empty() && ever_calls(s, s.main, name);
  if (s.main == name) {
    note(Severity::warning,
         timed_ ? fmt::format("'{}' is the main object: nothing of the display lists is shown from then on", name)
                : fmt::format("'{}' was the main object: nothing of the display lists is shown now", name),
         word, timed_ ? "" : "start NAME shows another one");
    if (!timed_) s.main.clear();
  }
  if (shown) (void)expand(s);  // it has only become less
  return true;
}

// Whether nobody else has names that what a list draws may want.
bool Reader::free_below(Cursor& c, const std::string& name, std::string_view about) {
  const std::string below = name + "/";
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (const Object& o = s.objects[i]; !o.removed && !o.derived && o.name.starts_with(below))
      return c.fail(Code::name, fmt::format("'{}' has a name that what '{}' draws may want", o.name, name), about,
                    fmt::format("rename {} first", o.name));
  return true;
}

// rename OLD NEW, where the old name is a list's.
bool Reader::rename_list(Cursor& c) {
  std::string_view old;
  if (!list_name(c, old)) return false;
  c.space();
  const std::string_view word = c.word();
  if (word.empty()) return c.fail_here(Code::syntax, "the new name is missing here");
  const std::string from(old), to(word);
  if (!free_name(c, to, word) || !free_below(c, to, word) || !finish(c)) return false;
  betwixt::rename_list(s, from, to);
  std::vector<decltype(unfinished_)::value_type> open;
  for (auto& u : unfinished_)
    if (u.first.first == from) open.emplace_back(std::pair(to, u.first.second), std::move(u.second));
  std::erase_if(unfinished_, [&](const auto& u) { return u.first.first == from; });
  unfinished_.insert(open.begin(), open.end());
  return true;
}

bool Reader::start_list(Cursor& c) {
  std::string_view word;
  if (!list_name(c, word) || !finish(c)) return false;
  const std::string name(word);
  if (!free_below(c, name, word)) return false;
  const std::string before = std::exchange(s.main, name);
  const Status done = expand(s);
  if (done) {
    for (const std::string_view other : live_ ? list_names(s) : std::vector<std::string_view>())
      for (const Time from : versions(s, other)) {  // an author is told at the end
        const DisplayList& list = *list_at(s, other, from);
        const auto wrong = unbalanced(list);
        if (!wrong || !ever_calls(s, name, std::string(other))) continue;
        note(Severity::warning, fmt::format("in '{}': {}", other, without_half(list.commands[*wrong])), word);
        break;
      }
    return true;
  }
  s.main = before;
  return c.fail(done.error().code, done.error().message, word, done.error().hint);
}

// A row of a display list.
bool Reader::list_row(Cursor& c) {
  c.space();
  const std::string_view word = c.peek_word();
  const bool factor = std::find(std::begin(factors), std::end(factors), word) != std::end(factors);
  for (const Word& row : rows) {
    if (row.word != (factor ? "multiply" : word)) continue;
    if (!factor) c.word();
    const auto index = static_cast<std::size_t>(&row - rows);
    const bool done = row.word == "tag"       ? tag(c)
                      : row.word == "replace" ? replace(c)
                                              : drawing(c, static_cast<Drawing>(index), word);
    if (!done && c.error && c.error->hint.empty() && c.error->code == Code::syntax)
      c.error->hint = fmt::format("usage: {}", row.usage);
    return done;
  }
  std::vector<std::string_view> words(std::begin(factors), std::end(factors));
  for (const Word& row : rows) words.push_back(row.word);
  std::string hint = did_you_mean(word, words);
  if (hint.empty()) hint = "rows that draw are point, vector, polygon, text and call; for the others: help make";
  if (!versions(s, word).empty()) hint = fmt::format("call {} draws that list", word.substr(0, 40));
  for (const Verb& v : verbs())
    if (v.word == word) hint = "a command that follows a display list is not indented";
  return c.fail_here(Code::name,
                     word.empty() ? fmt::format("a row of a display list begins with a word, not with '{}'", c.peek())
                                  : fmt::format("display lists have no '{}'", word.substr(0, 40)),
                     hint);
}

bool Reader::tag(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  if (!is_name(word))
    return c.fail(Code::syntax,
                  word.empty() ? "a name is missing here" : fmt::format("'{}' cannot be a name", word.substr(0, 60)),
                  word.empty() ? std::string_view(c.at, 0) : word);
  Sheet& sheet = source_.sheet;
  for (const Sheet::Version& v : sheet.versions)
    if (!v.passed_over && list_at(s, sheet.list, v.from)->tags.contains(word))
      return c.fail(Code::name, fmt::format("there is a tag '{}' in '{}' already", word, sheet.list), word);
  if (!finish(c)) return false;
  for (const Sheet::Version& v : sheet.versions) {
    if (v.passed_over) continue;
    DisplayList& list = betwixt::edit_list(s, sheet.list, v.from);
    list.tags[std::string(word)] = std::min(v.next, list.commands.size());
  }
  return true;
}

// Versions that do not have the tag, or not so many rows behind it, are passed over.
bool Reader::replace(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  Sheet& sheet = source_.sheet;
  std::vector<Sheet::Version> versions = sheet.versions;
  long least = 0, most = -1;
  std::vector<std::string_view> known;
  for (Sheet::Version& v : versions) {
    const DisplayList& list = *list_at(s, sheet.list, v.from);
    for (const auto& tag : list.tags) known.push_back(tag.first);
    const auto at = list.tags.find(word);
    v.passed_over = at == list.tags.end();
    if (v.passed_over) continue;
    v.next = at->second;
    least = std::min(least, -static_cast<long>(v.next));
    most = std::max(most, static_cast<long>(list.commands.size()) - static_cast<long>(v.next));
  }
  if (most < 0)
    return c.fail(Code::name,
                  word.empty() ? "a tag is missing here"
                               : fmt::format("there is no tag '{}' in '{}'", word.substr(0, 60), sheet.list),
                  word.empty() ? std::string_view(c.at, 0) : word, did_you_mean(word, known));
  long offset = 0;
  if (!c.at_line_end() && (!c.whole_number(least, most, "an offset", offset) || !finish(c))) return false;
  for (Sheet::Version& v : versions) {
    if (v.passed_over) continue;
    const long next = static_cast<long>(v.next) + offset;
    v.passed_over = next < 0 || next > static_cast<long>(list_at(s, sheet.list, v.from)->commands.size());
    v.next = static_cast<std::size_t>(next);
  }
  sheet.versions = std::move(versions);
  sheet.tag = word;
  return true;
}

// One command of the list, at its end or in place of another, in all versions that the rows go to.
bool Reader::drawing(Cursor& c, Drawing what, std::string_view about) {
  DisplayCommand command;
  command.what = what;
  ValueReader read = values(c);
  Sheet& sheet = source_.sheet;
  const auto points = [&](std::size_t least) {
    std::vector<Vec3> list;
    while (!c.at_line_end())
      if (Vec3 p; read.point(p))
        list.push_back(p);
      else
        return false;
    if (list.size() < least)
      return c.fail_here(Code::syntax,
                         least == 1 ? "a point (x y) or (x y z) is missing here"
                                    : fmt::format("at least {} points are wanted here, not {}", least, list.size()));
    command.value = Points(std::move(list));
    return true;
  };
  const auto text = [&](FunctionId f) { return read.value(spec_of(s, f), -1, command.value, f); };
  const auto name = [&](const char* of_what) {
    c.space();
    const std::string_view word = c.word();
    if (!is_name(word))
      return c.fail(Code::syntax,
                    word.empty() ? fmt::format("the name of {} is missing here", of_what)
                                 : fmt::format("'{}' cannot be a name", word.substr(0, 60)),
                    word.empty() ? std::string_view(c.at, 0) : word);
    command.value = Text(std::string(word));
    return true;
  };
  const auto number = [&](FunctionId f) {
    c.space();
    const char* start = c.at;
    FunctionSpec spec = spec_of(s, f);
    spec.name = about;
    if (!read.value(spec, -1, command.value, f)) return false;
    return std::get<double>(command.value) > 0 || c.fail(Code::range, "this must be more than 0", c.since(start));
  };
  bool done = true;
  switch (what) {
    case Drawing::point:
      done = points(1);
      break;
    case Drawing::vector:
      done = points(2);
      break;
    case Drawing::polygon:
      done = points(3);
      break;
    case Drawing::text:
      done = text(fn::text);
      break;
    case Drawing::color: {
      Color color;
      done = read.color(color);
      command.value = color;
      break;
    }
    case Drawing::texture:
      done = text(fn::texture);
      break;
    case Drawing::font:
      done = text(fn::font);
      break;
    case Drawing::multiply: {
      Mat4 m;
      done = read.transform(m);
      command.value = Matrix(m);
      break;
    }
    case Drawing::call:
      done = name("a display list") && callable(c, *std::get<Text>(command.value));
      break;
    case Drawing::begin:
      done = name("an environment") && since(c, command);
      break;
    case Drawing::view: {
      std::vector<Vec3> ends(2);
      if (!c.accept_word("from")) return c.fail_here(Code::syntax, "'from' and a point are missing here");
      if (!read.point(ends[0])) return false;
      if (!c.accept_word("to")) return c.fail_here(Code::syntax, "'to' and a point are missing here");
      c.space();
      const char* start = c.at;
      if (!read.point(ends[1])) return false;
      if (ends[0] == ends[1])
        return c.fail(Code::range, "a view from a point to itself has no direction", c.since(start));
      command.value = Points(std::move(ends));
      break;
    }
    case Drawing::perspective:
      done = number(fn::fov);
      break;
    case Drawing::orthographic:
      done = number(fn::camera_height);
      break;
    case Drawing::push:
    case Drawing::pop:
    case Drawing::end:
      break;
  }
  if (!done || !finish(c)) return false;
  if (!in_order(c, command, about)) return false;
  for (Sheet::Version& v : sheet.versions) {
    if (v.passed_over) continue;
    DisplayCommands& commands = betwixt::edit_list(s, sheet.list, v.from).commands;
    const std::size_t place = std::min(v.next, commands.size());
    if (&v == &sheet.versions[0]) {
      if (sheet.spots.size() <= place) sheet.spots.resize(place + 1);
      sheet.spots[place] = about;
    }
    commands.put(place, command);
    if (v.next != at_end) ++v.next;
  }
  sheet.changed = true;
  return true;
}

// What comes at the end must fit what is there; what is put between may be completed later.
bool Reader::in_order(Cursor& c, const DisplayCommand& command, std::string_view about) {
  const bool closes = command.what == Drawing::pop || command.what == Drawing::end;
  const bool opens = command.what == Drawing::push || command.what == Drawing::begin;
  const Drawing opener = command.what == Drawing::pop ? Drawing::push : Drawing::begin;
  std::vector<Sheet::Version> versions = source_.sheet.versions;
  for (Sheet::Version& v : versions) {
    if (v.passed_over) continue;
    const DisplayList& list = *list_at(s, source_.sheet.list, v.from);
    if (v.next < list.commands.size()) {
      v.nested.reset();
      continue;
    }
    if (!v.nested) v.nested = nested(list);
    if (closes && (v.nested->empty() || v.nested->back() != opener))
      return c.fail(Code::syntax, without_half(command), about,
                    v.nested->empty() ? ""
                                      : fmt::format("the one begun last is a '{}'",
                                                    drawing_names[static_cast<std::size_t>(v.nested->back())]));
    if (closes) v.nested->pop_back();
    if (opens) v.nested->push_back(command.what);
  }
  source_.sheet.versions = std::move(versions);
  return true;
}

// What is open at the end of the list, as far as it is in order.
std::vector<Drawing> Reader::nested(const DisplayList& list) const {
  std::vector<Drawing> open;
  for (std::size_t i = 0; i < list.commands.size(); ++i) {
    const Drawing what = list.commands[i].what;
    if (what == Drawing::push || what == Drawing::begin) open.push_back(what);
    if ((what == Drawing::pop || what == Drawing::end) && !open.empty()) open.pop_back();
  }
  return open;
}

bool Reader::callable(Cursor& c, const std::string& name) {
  const std::string& self = source_.sheet.list;
  const std::string_view about(c.at - name.size(), name.size());
  std::vector<Time> into;
  for (const Sheet::Version& v : source_.sheet.versions)
    if (!v.passed_over) into.push_back(v.from);
  if (const auto way = calls(s, name, self, into); !way.empty())
    return c.fail(Code::name,
                  name == self ? fmt::format("'{}' cannot call itself", self)
                               : fmt::format("this would go round in a circle: {} → {}", self, path(way)),
                  about);
  if (!versions(s, name).empty()) return true;
  if (s.names.find(name))
    return c.fail(Code::type, fmt::format("'{}' is an object of the film, not a display list", name), about);
  note(Severity::warning, fmt::format("there is no display list '{}' yet: until it is made this draws nothing", name),
       about, did_you_mean(name, list_names(s)));
  return true;
}

// A begin of a live host, or of an edit at a time, belongs to the environment that has the name then, or will have it
// next (R-E9).
bool Reader::since(Cursor& c, DisplayCommand& command) {
  if (c.accept_word("since")) {
    Time t;
    if (!c.time(t)) return false;
    c.ticks_read = true;
    command.since = s.ticks.whole(t);
  } else if (source_.sheet.from) {
    command.since = s.ticks.whole(*source_.sheet.from);
  } else if (options_.now) {
    c.ticks_read = true;
    command.since = tick();
  }
  return true;
}

// The lines that rows stand below that come by themselves.
std::string Reader::opener(const Sheet& sheet) const {
  if (sheet.list.empty()) return sheet.opener;
  const std::string edit = (sheet.from ? "at " + write_seconds(*sheet.from) + " " : "") + "edit " + sheet.list;
  const auto v = std::find_if(sheet.versions.begin(), sheet.versions.end(),
                              [](const Sheet::Version& each) { return !each.passed_over; });
  if (v->next == at_end) return edit;
  const auto offset =
      static_cast<long>(v->next) - static_cast<long>(list_at(s, sheet.list, v->from)->tags.find(sheet.tag)->second);
  return fmt::format("{}\n  replace {} {}", edit, sheet.tag, offset);
}

// The rows of a display list are over: what shows it must show it as it is now.
void Reader::close_list() {
  Sheet& sheet = source_.sheet;
  if (sheet.list.empty()) return;
  const std::string name = std::exchange(sheet.list, {});
  for (const Sheet::Version& v : sheet.versions) {
    unfinished_.erase({name, v.from});
    const DisplayList& list = *list_at(s, name, v.from);
    const auto wrong = live_ ? std::nullopt : unbalanced(list);
    if (!wrong) continue;
    const DisplayCommand& command = list.commands[*wrong];
    const bool here = &v == &sheet.versions[0] && *wrong < sheet.spots.size();
    const std::string_view spot = here ? sheet.spots[*wrong] : std::string_view();
    const std::size_t said = diagnostics_.size();
    note(Severity::error, spot.data() ? without_half(command) : fmt::format("in '{}': {}", name, without_half(command)),
         spot.data() ? spot : sheet.place);
    if (diagnostics_.size() > said && !given_up_) {  // it may still be completed
      unfinished_[{name, v.from}] = std::move(diagnostics_.back());
      diagnostics_.pop_back();
      --errors_;
    }
  }
  if (!sheet.changed || s.main.empty() || !ever_calls(s, s.main, name)) return;
  if (const Status done = expand(s); !done) {
    s.lists = sheet.before, s.later_lists = sheet.later_before;
    report(Severity::error, done.error(), sheet.place);
  }
}

void Reader::unfinished_lists() {
  std::vector<Diagnostic> all;
  for (auto& [name, what] : unfinished_) all.push_back(std::move(what));
  unfinished_.clear();
  std::stable_sort(all.begin(), all.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.what.place.line < b.what.place.line; });
  for (Diagnostic& d : all) diagnostics_.push_back(std::move(d));
}

}  // namespace betwixt
