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

bool Reader::list_name(Cursor& c, std::string_view& word) {
  c.space();
  word = c.word();
  if (word.empty()) return c.fail_here(Code::syntax, "the name of a display list is missing here");
  if (s.lists->contains(word)) return true;
  std::vector<std::string_view> known;
  for (const auto& list : *s.lists) known.push_back(list.first);
  return c.fail(Code::name, fmt::format("there is no display list '{}'", word.substr(0, 60)), word,
                did_you_mean(word, known));
}

void Reader::open(std::string_view word) {
  Sheet& sheet = source_.sheet;
  sheet = {};
  sheet.open = true;
  sheet.list = word;
  sheet.place = word;
  sheet.next = at_end;
  sheet.before = s.lists;
}

bool Reader::make_list(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  const std::string name(word);
  if (word.empty()) return c.fail_here(Code::syntax, "the name of the new display list is missing here");
  if (s.lists->contains(name))
    return c.fail(Code::name, fmt::format("there is a display list '{}' already", name), word,
                  fmt::format("edit {} opens it again", name));
  if (!free_name(c, name, word) || !finish(c)) return false;
  open(word);
  s.lists.edit()[name] = Cow<DisplayList>(DisplayList{});
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
  const bool shown = !s.main.empty() && !calls(s, s.main, name).empty();
  s.lists.edit().erase(name);
  unfinished_.erase(name);
  std::vector<std::string> callers;
  for (const auto& [other, list] : *s.lists)
    for (std::size_t i = 0; i < list->commands.size(); ++i)
      if (const DisplayCommand& command = list->commands[i];
          command.what == Drawing::call && *std::get<Text>(command.value) == name) {
        callers.push_back("'" + other + "'");
        break;
      }
  if (!callers.empty())
    note(Severity::warning,
         fmt::format("{} still call{} '{}', which draws nothing now", fmt::join(callers, ", "),
                     callers.size() == 1 ? "s" : "", name),
         word);
  if (s.main == name) {
    note(Severity::warning, fmt::format("'{}' was the main object: nothing of the display lists is shown now", name),
         word, "start NAME shows another one");
    s.main.clear();
  }
  if (shown) (void)expand(s);  // it has only become less
  return true;
}

bool Reader::start_list(Cursor& c) {
  std::string_view word;
  if (!list_name(c, word) || !finish(c)) return false;
  const std::string name(word), below = name + "/";
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (const Object& o = s.objects[i]; !o.removed && !o.derived && o.name.starts_with(below))
      return c.fail(Code::name, fmt::format("'{}' has a name that what '{}' draws may want", o.name, name), word,
                    fmt::format("rename {} first", o.name));
  const std::string before = std::exchange(s.main, name);
  const Status done = expand(s);
  if (done) {
    for (const auto& [other, list] : *s.lists)  // an author is told at the end
      if (const auto wrong = live_ ? unbalanced(*list) : std::nullopt; wrong && !calls(s, name, other).empty())
        note(Severity::warning, fmt::format("in '{}': {}", other, without_half(list->commands[*wrong])), word);
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
  const DisplayList& list = *s.lists->find(sheet.list)->second;
  if (list.tags.contains(word))
    return c.fail(Code::name, fmt::format("there is a tag '{}' in '{}' already", word, sheet.list), word);
  if (!finish(c)) return false;
  s.lists.edit()[sheet.list].edit().tags[std::string(word)] = std::min(sheet.next, list.commands.size());
  return true;
}

bool Reader::replace(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  Sheet& sheet = source_.sheet;
  const DisplayList& list = *s.lists->find(sheet.list)->second;
  const auto at = list.tags.find(word);
  if (at == list.tags.end()) {
    std::vector<std::string_view> known;
    for (const auto& tag : list.tags) known.push_back(tag.first);
    return c.fail(Code::name,
                  word.empty() ? "a tag is missing here"
                               : fmt::format("there is no tag '{}' in '{}'", word.substr(0, 60), sheet.list),
                  word.empty() ? std::string_view(c.at, 0) : word, did_you_mean(word, known));
  }
  long offset = 0;
  if (!c.at_line_end()) {
    const long most = static_cast<long>(list.commands.size()) - static_cast<long>(at->second);
    if (!c.whole_number(-static_cast<long>(at->second), most, "an offset", offset) || !finish(c)) return false;
  }
  sheet.next = static_cast<std::size_t>(static_cast<long>(at->second) + offset);
  sheet.tag = word;
  return true;
}

// One command of the list, at its end or in place of another.
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
    if (!read.value(spec_of(s, f), -1, command.value, f)) return false;
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
  const std::size_t size = s.lists->find(sheet.list)->second->commands.size();
  const std::size_t place = std::min(sheet.next, size);
  if (place == size) {  // what comes at the end must fit what is there; what is put between may be completed later
    if (!sheet.nested) nest(sheet);
    const bool closes = what == Drawing::pop || what == Drawing::end;
    const Drawing opener = what == Drawing::pop ? Drawing::push : Drawing::begin;
    if (closes && (sheet.nested->empty() || sheet.nested->back() != opener))
      return c.fail(Code::syntax, without_half(command), about,
                    sheet.nested->empty() ? ""
                                          : fmt::format("the one begun last is a '{}'",
                                                        drawing_names[static_cast<std::size_t>(sheet.nested->back())]));
    if (closes) sheet.nested->pop_back();
    if (what == Drawing::push || what == Drawing::begin) sheet.nested->push_back(what);
  } else {
    sheet.nested.reset();
  }
  if (sheet.spots.size() <= place) sheet.spots.resize(place + 1);
  sheet.spots[place] = about;
  sheet.changed = true;
  s.lists.edit()[sheet.list].edit().commands.put(place, std::move(command));
  if (sheet.next != at_end) ++sheet.next;
  return true;
}

// What is open at the end of the list, as far as it is in order.
void Reader::nest(Sheet& sheet) const {
  const DisplayCommands& commands = s.lists->find(sheet.list)->second->commands;
  sheet.nested.emplace();
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Drawing what = commands[i].what;
    if (what == Drawing::push || what == Drawing::begin) sheet.nested->push_back(what);
    if ((what == Drawing::pop || what == Drawing::end) && !sheet.nested->empty()) sheet.nested->pop_back();
  }
}

bool Reader::callable(Cursor& c, const std::string& name) {
  const std::string& self = source_.sheet.list;
  const std::string_view about(c.at - name.size(), name.size());
  if (const auto way = calls(s, name, self); !way.empty())
    return c.fail(Code::name,
                  name == self ? fmt::format("'{}' cannot call itself", self)
                               : fmt::format("this would go round in a circle: {} → {}", self, path(way)),
                  about);
  if (s.lists->contains(name)) return true;
  std::vector<std::string_view> known;
  for (const auto& list : *s.lists) known.push_back(list.first);
  if (s.names.find(name))
    return c.fail(Code::type, fmt::format("'{}' is an object of the film, not a display list", name), about);
  note(Severity::warning, fmt::format("there is no display list '{}' yet: until it is made this draws nothing", name),
       about, did_you_mean(name, known));
  return true;
}

// A live host's begin belongs to the environment that has the name now, or will have it next (R-E9).
bool Reader::since(Cursor& c, DisplayCommand& command) {
  if (c.accept_word("since")) {
    Time t;
    if (!c.time(t)) return false;
    c.ticks_read = true;
    command.since = s.ticks.whole(t);
  } else if (options_.now) {
    c.ticks_read = true;
    command.since = tick();
  }
  return true;
}

// The lines that rows stand below that come by themselves.
std::string Reader::opener(const Sheet& sheet) const {
  if (sheet.list.empty()) return sheet.opener;
  const std::string edit = "edit " + sheet.list;
  if (sheet.next == at_end) return edit;
  const auto offset = static_cast<long>(sheet.next) -
                      static_cast<long>(s.lists->find(sheet.list)->second->tags.find(sheet.tag)->second);
  return fmt::format("{}\n  replace {} {}", edit, sheet.tag, offset);
}

// The rows of a display list are over: what shows it must show it as it is now.
void Reader::close_list() {
  Sheet& sheet = source_.sheet;
  if (sheet.list.empty()) return;
  const std::string name = std::exchange(sheet.list, {});
  unfinished_.erase(name);
  if (const auto wrong = live_ ? std::nullopt : unbalanced(*s.lists->find(name)->second)) {
    const DisplayCommand& command = s.lists->find(name)->second->commands[*wrong];
    const std::string_view spot = *wrong < sheet.spots.size() ? sheet.spots[*wrong] : std::string_view();
    const std::size_t said = diagnostics_.size();
    note(Severity::error, spot.data() ? without_half(command) : fmt::format("in '{}': {}", name, without_half(command)),
         spot.data() ? spot : sheet.place);
    if (diagnostics_.size() > said && !given_up_) {  // it may still be completed
      unfinished_[name] = std::move(diagnostics_.back());
      diagnostics_.pop_back();
      --errors_;
    }
  }
  if (!sheet.changed || s.main.empty() || calls(s, s.main, name).empty()) return;
  if (const Status done = expand(s); !done) {
    s.lists = sheet.before;
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
