// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that go beyond plain tracks: layers, filters, procedures, falling, live input.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/names.h"
#include "betwixt/program.h"
#include "language/reader.h"
#include "procedure/lua.h"
#include "procedure/plugins.h"

namespace betwixt {
namespace {

constexpr int deepest_command = 20;  // commands of the author's that run each other

std::string_view since(const char* start, const Cursor& c) { return {start, static_cast<std::size_t>(c.at - start)}; }

// What plug-ins brought, for all scripts of this process.
struct Brought {
  std::mutex mutex;
  std::vector<NamedProcedure> procedures;
  std::vector<FunctionSpec> functions;
};
Brought& brought() {
  static Brought b;
  return b;
}

Value value_of_numbers(Type type, const std::vector<double>& n) {
  const auto at = [&](std::size_t i) { return i < n.size() ? n[i] : 0.0; };
  const Vec3 v{at(0), at(1), at(2)};
  switch (type) {
    case Type::vector:
      return v;
    case Type::color:
      return Color{v.x, v.y, v.z};
    case Type::boolean:
      return v.x != 0;
    case Type::rotation:
      return Angles{v};
    default:
      return v.x;
  }
}

}  // namespace

Status use_plugin(const std::string& path) {
  auto plugin = load_plugin(path);
  if (!plugin) return plugin.error();
  static constexpr std::pair<std::string_view, Type> types[] = {{"number", Type::scalar},     {"scalar", Type::scalar},
                                                                {"angle", Type::angle},       {"vector", Type::vector},
                                                                {"color", Type::color},       {"boolean", Type::boolean},
                                                                {"rotation", Type::rotation}};
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  for (PluginItem& item : plugin->items) {
    if (!is_name(item.name)) return fail(Code::name, fmt::format("{}: '{}' cannot be a name", path, item.name));
    std::erase_if(all.procedures, [&](const NamedProcedure& p) { return p.name == item.name; });
    all.procedures.push_back({item.name, item.role, item.code});
  }
  for (const PluginFunction& f : plugin->functions) {
    const auto type = std::find_if(std::begin(types), std::end(types), [&](const auto& t) { return t.first == f.type; });
    if (type == std::end(types) || !is_name(f.name))
      return fail(Code::type, fmt::format("{}: the function '{}' has no type that is known: '{}'", path, f.name, f.type));
    std::erase_if(all.functions, [&](const FunctionSpec& s) { return s.name == f.name; });
    all.functions.push_back({f.name, type->second, value_of_numbers(type->second, f.numbers), 0xffffffff, Unit::none, {}});
  }
  return Nothing{};
}

void adopt_plugins(Scene& s) {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  for (const NamedProcedure& p : all.procedures)
    if (!find_procedure(s, p.name)) s.procedures.edit().push_back(p);
  for (const FunctionSpec& f : all.functions)
    if (!find_function(s, Kind::group, f.name)) s.defined.edit().push_back(f);
}

bool Reader::layer(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  if (word.empty()) return c.fail_here(Code::syntax, "a name is missing here");
  if (!free_name(c, std::string(word), word)) return false;
  c.space();
  const std::string_view mode = c.word();
  if (mode != "add" && mode != "mix")
    return c.fail(Code::syntax, mode.empty() ? "add or mix is missing here" : "a layer adds or mixes",
                  mode.empty() ? std::string_view(c.at, 0) : mode,
                  "add lays its values on top; mix goes over to them by its weight");
  Object object;
  object.name = word;
  object.kind = Kind::layer;
  object.slot(fn::mode).set = Text(std::string(mode));
  if (!parameters(c, object)) return false;
  add_object(s, std::move(object));
  return true;
}

bool Reader::on_layer(Cursor& c) {
  ObjectId id;
  c.space();
  const std::string_view word = c.peek_word();
  if (!values(c).object(id)) return false;
  if (s.objects[id.index].kind != Kind::layer)
    return c.fail(Code::type, fmt::format("'{}' is no layer", word), word, fmt::format("layer NAME add makes one"));
  if (layer_) return c.fail(Code::syntax, "one layer is enough", word);
  c.space();
  if (c.at_line_end())
    return c.fail_here(Code::syntax, "a command is missing here", "as in on sway set ball.position (0 1 0)");
  static constexpr std::string_view allowed[] = {"set",     "at",     "copy",      "move",   "stretch",
                                                 "reverse", "scale",  "translate", "rotate", "clear",
                                                 "stagger", "spread", "twerper",   "extend", "filter"};
  const std::string_view verb = c.peek_word();
  if (verb.find('.') == std::string_view::npos &&
      std::find(std::begin(allowed), std::end(allowed), verb) == std::end(allowed))
    return c.fail(Code::syntax, fmt::format("'{}' works on no layer", verb.substr(0, 40)), verb,
                  "on a layer go events, set, filters and track operations");
  layer_ = id;
  if (timed_ && verb.find('.') != std::string_view::npos) {  // at T on LAYER TARGET VALUE
    c.space();
    const std::string_view w = c.word();
    Selected to;
    if (!targets(c, w, to)) return false;
    if (to.spec) return event(c, to, time_);
    c.at = after_line(w.data());
    if (c.at > w.data() && c.at[-1] == '\n') --c.at;
    return true;
  }
  return command(c);
}

// key=value behind a filter's name: numbers, lengths of time, vectors and texts.
bool Reader::filter(Cursor& c) {
  Selected on;
  c.space();
  const std::string_view word = c.word();
  if (!targets(c, word, on)) return false;
  if (on.velocity) return c.fail(Code::type, "filters stand on values, not on velocities", word);
  c.space();
  const std::string_view name = c.word();
  Filter made;
  made.name = name;
  const FilterSpec* spec = find_filter(name);
  const NamedProcedure* own = find_procedure(s, name);
  if (own && own->role != Role::filter) own = nullptr;
  const bool none = name == "none";
  if (!spec && !own && !none) {
    std::vector<std::string_view> words;
    std::string all = "filters are";
    for (const FilterSpec& f : built_in_filters()) words.push_back(f.name), all += " " + std::string(f.name);
    for (const NamedProcedure& p : *s.procedures)
      if (p.role == Role::filter) words.push_back(p.name);
    const std::string hint = did_you_mean(name, words);
    return c.fail(Code::name,
                  name.empty() ? "the name of a filter is missing here"
                               : fmt::format("there is no filter '{}'", name.substr(0, 40)),
                  name.empty() ? std::string_view(c.at, 0) : name, hint.empty() ? all : hint);
  }
  if (own) made.code = own->code;
  const Type type = on.spec ? on.type() : Type::vector;
  if (type == Type::attachment || type == Type::names || type == Type::points ||
      (spec && !own && on.spec && !suits(*spec, type)))
    return c.fail(Code::type, fmt::format("'{}' means nothing for {}", name, to_string(type)), word);
  while (!c.at_line_end()) {
    const char* start = c.at;
    const char ch = c.peek();
    if ((ch >= '0' && ch <= '9') || ch == '-' || ch == '+' || ch == '.') {
      Time from, to;
      if (!c.segment(from, to)) return false;
      made.segment = {from, to};
      continue;
    }
    const std::string_view key = c.word();
    if (key.empty() || !c.accept('='))
      return c.fail(Code::syntax,
                    fmt::format("'{}' is not expected here", key.empty() ? std::string_view(start, 1) : key),
                    since(start, c), "key=value, or a segment A..B");
    const FilterParameter* known = nullptr;
    if (spec && !own) {
      std::vector<std::string_view> words;
      for (const FilterParameter& p : spec->parameters) {
        words.push_back(p.name);
        if (p.name == key) known = &p;
      }
      if (!known)
        return c.fail(Code::name, fmt::format("'{}' has no '{}'", name, key.substr(0, 40)), key,
                      did_you_mean(key, words));
    }
    c.space();
    const char* at = c.at;
    Value v;
    if (c.peek() == '"') {
      std::string text;
      if (!c.text(text)) return false;
      v = Text(std::move(text));
    } else if (c.peek() == '(') {
      Vec3 three;
      if (!values(c).vector(3, three)) return false;
      v = three;
    } else if (known && known->time) {
      Time length;
      if (!c.length(length)) return false;
      v = length.seconds();
    } else {
      double d = 0;
      if (!c.number(d)) return false;
      const std::string_view unit = c.unit();
      if (!unit.empty()) {  // a length of time is seconds, an angle radians
        c.at = at;
        Time length;
        if (unit == "deg" || unit == "rad" || unit == "turn") {
          if (!c.angle(d)) return false;
        } else if (!c.length(length)) {
          return false;
        } else {
          d = length.seconds();
        }
      }
      v = d;
    }
    if (const auto* d = std::get_if<double>(&v); known && d && !(*d >= known->low && *d <= known->high))
      return c.fail(Code::range,
                    *d < known->low ? fmt::format("{} is at least {}", key, write_number(known->low))
                                    : fmt::format("{} is at most {}", key, write_number(known->high)),
                    since(at, c));
    if (known && !std::holds_alternative<double>(v) && !(key == "amount" && std::holds_alternative<Vec3>(v)))
      return c.fail(Code::type, fmt::format("{} is a number", key), since(at, c));
    made.parameters.emplace_back(std::string(key), std::move(v));
  }
  for (const Target& t : on.targets) {
    Slot& slot = s.objects.edit(t.object.index).slot(t.function, t.layer);
    made.component = t.component;
    if (!none)
      slot.filters.push_back(made);
    else
      std::erase_if(slot.filters, [&](const Filter& f) { return t.component < 0 || f.component == t.component; });
  }
  return true;
}

bool Reader::procedure(Cursor& c) {
  c.space();
  const std::string_view name = c.word();
  if (!is_name(name) || name.find('/') != std::string_view::npos || name.find('.') != std::string_view::npos)
    return c.fail(
        Code::syntax,
        name.empty() ? "a name is missing here" : fmt::format("'{}' cannot be a procedure's name", name.substr(0, 60)),
        name.empty() ? std::string_view(c.at, 0) : name);
  Role role = Role::value;
  for (const Role r : {Role::value, Role::twerper, Role::filter, Role::command})
    if (c.accept_word(role_names[static_cast<std::size_t>(r)])) role = r;
  if (!c.accept_word("lua"))
    return c.fail_here(Code::syntax, "'lua' is missing here", "as in procedure snap twerper lua \"u*u\"");
  c.space();
  const char* start = c.at;
  std::string source;
  if (!c.text(source)) return false;
  const std::string_view about = since(start, c);
  if (!finish(c)) return false;
  const auto taken = [&](const char* what) {
    return c.fail(Code::name, fmt::format("'{}' is {} already", name, what), name);
  };
  for (const Verb& v : verbs())
    if (v.word == name) return taken("a command");
  if (std::find(twerper_names.begin(), twerper_names.end(), name) != twerper_names.end()) return taken("a twerper");
  if (find_filter(name)) return taken("a filter");
  auto code = make_lua(role, std::move(source));
  if (!code) return c.fail(code.error().code, code.error().message, about, code.error().hint);
  NamedProcedure made{std::string(name), role, *std::move(code)};
  const auto& all = *s.procedures;
  const auto at = std::find_if(all.begin(), all.end(), [&](const NamedProcedure& p) { return p.name == name; });
  if (at == all.end()) {
    if (all.size() >= 200) return c.fail(Code::range, "no more than 200 procedures can have names", name);
    s.procedures.edit().push_back(std::move(made));
    return true;
  }
  if (at->role != role)
    return c.fail(Code::name, fmt::format("'{}' is a {} already", name, role_names[static_cast<std::size_t>(at->role)]),
                  name);
  s.procedures.edit()[static_cast<std::size_t>(at - all.begin())] = std::move(made);
  // Filters hold their code; they go on with the new one.
  if (role == Role::filter)
    for (std::size_t i = 0; i < s.objects.size(); ++i)
      for (std::size_t k = 0; k < s.objects[i].slots.size(); ++k)
        for (std::size_t f = 0; f < s.objects[i].slots[k].filters.size(); ++f)
          if (s.objects[i].slots[k].filters[f].name == name)
            s.objects.edit(i).slots[k].filters[f].code = find_procedure(s, name)->code;
  return true;
}

namespace {

struct Hosting : Host {
  Reader& reader;
  std::function<Status(std::string_view)> carry_out;
  Hosting(Reader& r, std::function<Status(std::string_view)> f) : reader(r), carry_out(std::move(f)) {}
  Status run(std::string_view line) override { return carry_out(line); }
  Result<Reading> value(std::string_view target, double seconds) override {
    if (!(std::abs(seconds) <= longest_seconds)) return fail(Code::range, "there is no such time");
    const auto t = find_target(reader.s, target);
    if (!t) return t.error();
    return Program::compile(Document(std::make_shared<const Scene>(reader.s))).read(*t, from_seconds(seconds));
  }
  std::vector<std::string> objects(std::string_view pattern) override {
    std::vector<std::string> names;
    for (ObjectId id : select(reader.s, pattern)) names.push_back(reader.s.objects[id.index].name);
    return names;
  }
};

}  // namespace

// A command of the author's: it runs commands of the language, all of them or none.
bool Reader::own_command(Cursor& c, const NamedProcedure& p) {
  const char* start = c.at;
  std::vector<std::string> words;
  while (!c.at_line_end()) {
    if (c.peek() == '"') {
      std::string text;
      if (!c.text(text)) return false;
      words.push_back(std::move(text));
      continue;
    }
    const char* at = c.at;
    if (c.peek() == '(') {  // a vector goes as it is written
      int depth = 0;
      while (c.at < c.end && *c.at != '\n') {
        if (*c.at == '(') ++depth;
        if (*c.at == ')' && --depth == 0) break;
        ++c.at;
      }
      if (c.at < c.end && *c.at == ')') ++c.at;
      words.emplace_back(since(at, c));
      continue;
    }
    const std::string_view w = c.word();
    if (w.empty()) ++c.at;
    words.emplace_back(since(at, c));
  }
  if (commands_deep_ >= deepest_command)
    return c.fail(Code::range, fmt::format("commands run each other more than {} deep", deepest_command),
                  {start - p.name.size(), p.name.size()});
  const Scene before = s;
  const std::string name = p.name;
  const auto code = p.code;
  Hosting host(*this, [&](std::string_view line) -> Status {
    Diagnostics said;
    LoadOptions options = options_;
    Reader inner(s, said, options);
    inner.commands_deep_ = commands_deep_ + 1;
    inner.root_ = root_;
    inner.copied_ = copied_;
    inner.read_text(line, source_.name);
    copied_ = inner.copied_;
    for (const Diagnostic& d : said)
      if (d.severity == Severity::error)
        return fail(d.what.code, fmt::format("{} (in \"{}\")", d.what.message, line.substr(0, 80)), d.what.hint);
    return Nothing{};
  });
  const Status done = code->command(host, words);
  if (done) return true;
  s = before;
  return c.fail(done.error().code, fmt::format("{}: {}", name, done.error().message),
                {start - name.size(), name.size()}, done.error().hint);
}

// dial /address to TARGET [from A B to C D]
bool Reader::dial(Cursor& c) {
  c.space();
  const char* start = c.at;
  while (c.at < c.end && !std::isspace(static_cast<unsigned char>(*c.at)) && *c.at != ',') ++c.at;
  Dial made;
  made.address = since(start, c);
  if (made.address.size() < 2 || made.address[0] != '/')
    return c.fail(Code::syntax, "an address begins with '/'", since(start, c),
                  "as in dial /fader/1 to ball.position.y");
  const auto at = [&] {
    return std::find_if(s.dials->begin(), s.dials->end(), [&](const Dial& d) { return d.address == made.address; });
  };
  if (!c.accept_word("to")) return c.fail_here(Code::syntax, "'to' is missing here");
  if (c.accept_word("none")) {
    if (!finish(c)) return false;
    if (at() != s.dials->end()) {
      const auto i = at() - s.dials->begin();
      s.dials.edit().erase(s.dials.edit().begin() + i);
    }
    return true;
  }
  Selected to;
  c.space();
  const std::string_view word = c.word();
  if (!targets(c, word, to)) return false;
  if (to.velocity) return c.fail(Code::type, "a dial turns a value, not a velocity", word);
  if (to.targets.size() != 1)
    return c.fail(Code::name, "a dial turns one target", word, "a group or a function of your own can turn many");
  made.target = to.targets[0];
  switch (to.type()) {
    case Type::scalar:
    case Type::angle:
    case Type::boolean:
    case Type::vector:
    case Type::pair:
    case Type::color:
    case Type::rotation:
    case Type::text:
      break;
    default:
      return c.fail(Code::type, fmt::format("no dial can turn {}", to_string(to.type())), word);
  }
  if (c.accept_word("from")) {
    if (!c.number(made.low) || !c.number(made.high)) return false;
    if (made.low == made.high) return c.fail_here(Code::range, "the dial's own range has no width");
    if (!c.accept_word("to")) return c.fail_here(Code::syntax, "'to' and two values are missing here");
    const FunctionSpec free = unbounded(*to.spec);
    if (!values(c).value(free, to.component, made.from) || !values(c).value(free, to.component, made.to)) return false;
    if (!add_scaled(made.from, made.to, 1))
      return c.fail(Code::type, fmt::format("{} has no range", to_string(to.type())), word);
    made.mapped = true;
  }
  if (!finish(c)) return false;
  if (at() != s.dials->end()) {
    const auto i = static_cast<std::size_t>(at() - s.dials->begin());
    s.dials.edit()[i] = std::move(made);
  } else {
    s.dials.edit().push_back(std::move(made));
  }
  return true;
}

bool Reader::record(Cursor& c) {
  c.space();
  const std::string_view w = c.word();
  if (w != "on" && w != "off") return c.fail(Code::syntax, "recording is on or off", w);
  if (!finish(c)) return false;
  s.recording = w == "on";
  return true;
}

// A fall by the laws of cartoons: the object goes on as it went for the delay, then drops, and bounces. What comes of
// it are plain events on plain tracks. (G4, G52)
bool Reader::fall(Cursor& c) {
  std::string_view word;
  std::vector<ObjectId> things;
  if (!timed_) return c.fail_here(Code::syntax, "a fall needs a time", "as in at 24f fall ball");
  if (!objects(c, word, things)) return false;
  Time delay, length{10 * flicks_per_second};
  double gravity = 9.81, ground = 0, bounce = 0;
  while (!c.at_line_end()) {
    const char* start = c.at;
    const std::string_view key = c.word();
    if (key == "for") {
      if (!c.length(length)) return false;
      if (!(length > Time{})) return c.fail(Code::range, "a fall takes some time", since(start, c));
      continue;
    }
    if (key != "delay" && key != "gravity" && key != "ground" && key != "bounce")
      return c.fail(Code::name, fmt::format("a fall has no '{}'", key.empty() ? std::string_view(start, 1) : key),
                    since(start, c), "delay= gravity= ground= bounce= and for LENGTH");
    if (!c.accept('=')) return c.fail_here(Code::syntax, fmt::format("'=' is missing behind {}", key));
    if (key == "delay") {
      if (!c.length(delay)) return false;
      if (delay < Time{}) return c.fail(Code::range, "a delay cannot be shorter than nothing", since(start, c));
      continue;
    }
    double& number = key == "gravity" ? gravity : key == "ground" ? ground : bounce;
    if (!values(c).scalar(number, key == "ground" ? Unit::metres : Unit::none)) return false;
    if (key == "gravity" && !(gravity > 0))
      return c.fail(Code::range, "gravity pulls down by more than 0", since(start, c));
    if (key == "bounce" && !(bounce >= 0 && bounce < 1))
      return c.fail(Code::range, "bounce is at least 0 and less than 1", since(start, c));
  }
  const Program program = Program::compile(Document(std::make_shared<const Scene>(s)));
  const Time begin = time_ + delay, end = begin + length;
  for (const ObjectId id : things) {
    Target where{id, fn::position}, rate = where;
    rate.velocity = true;
    const Vec3 p = std::get<Vec3>(program.read(where, time_)), v = std::get<Vec3>(program.read(rate, time_));
    // Along the ground it goes on as it went.
    struct Mark {
      Time time;
      double height, in, out;
    };
    std::vector<Mark> marks;
    if (delay > Time{}) marks.push_back({time_, p.y, 0, 0});
    double y = p.y, speed = delay > Time{} ? 0 : v.y;
    double t = begin.seconds();
    Time now = begin;
    double came = 0;
    for (int hops = 0; hops < 200; ++hops) {
      marks.push_back({now, y, came, speed});
      // y + speed·d - g/2·d² = ground
      const double root = speed * speed + 2 * gravity * (y - ground);
      if (!(root > 0) || (y <= ground && speed <= 0)) {
        marks.back().out = 0;
        break;
      }
      const double d = (speed + std::sqrt(root)) / gravity, left = end.seconds() - t;
      if (d >= left) {
        marks.push_back({end, y + speed * left - gravity / 2 * left * left, speed - gravity * left, 0});
        break;
      }
      t += d;
      now = from_seconds(t);
      came = speed - gravity * d;
      y = ground;
      speed = -came * bounce;
      if (speed * speed / (2 * gravity) < 1e-4) speed = 0;  // hops nobody sees
    }
    const Time last = marks.back().time;
    for (int axis = 0; axis < 3; ++axis) {
      Target part = where;
      part.component = axis;
      Track* track = edit_track(s, part);
      track->events.erase(time_, last);
      const auto put = [&](Time time, double value, double in, double out) {
        Event e;
        e.time = time;
        e.value = value;
        e.twerper = Twerper::hermite;
        e.detail.edit().tangent_in = in;
        e.detail.edit().tangent_out = out;
        track->events.put(std::move(e));
      };
      if (axis == 1) {
        for (const Mark& m : marks) put(m.time, m.height, m.in, m.out);
      } else {
        put(time_, p[axis], v[axis], v[axis]);
        put(last, p[axis] + v[axis] * (last - time_).seconds(), v[axis], 0);
      }
    }
  }
  return true;
}

}  // namespace betwixt
