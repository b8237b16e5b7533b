// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Procedures and commands of the author's own.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "base/diagnostic.h"
#include "base/names.h"
#include "betwixt/program.h"
#include "commands/command.h"
#include "commands/command_parameters.h"
#include "commands/plugins.h"
#include "commands/reader.h"
#include "language/code_names.h"
#include "procedure/lua.h"
#include "program/along.h"
#include "program/asking.h"
#include "program/compiled.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr int deepest_command = 20;  // depth of the author's commands that run each other

// Compiles code, an expression or a chunk, behind declarations of local variables on its first line.
Result<std::shared_ptr<const Routine>> make_with_locals(Role role, const std::string& locals,
                                                        const std::string& source) {
  if (auto expression = make_lua(role, locals + "return " + source)) return expression;
  if (auto chunk = make_lua(role, locals + source)) return chunk;
  return make_lua(role, source);  // reports the error
}

// Reads [every LENGTH] [from TIME] [hold].
bool read_stepping(Cursor& c, Stepping& out) {
  for (;;) {
    c.space();
    const char* const start = c.at;
    if (c.accept_word("hold")) {
      out.hold = true;
    } else if (c.accept_word("from")) {
      if (!c.time(out.from)) return false;
    } else if (c.accept_word("every")) {
      if (!c.length(out.every)) return false;
      if (!(out.every > Time{})) return c.fail(ErrorCode::range, "an interval must be longer than 0", c.since(start));
    } else {
      return true;
    }
  }
}

// Returns whether code of the role gets a value by this name.
bool is_given(Role role, std::string_view word) {
  static constexpr std::string_view steps[] = {"state", "step", "dt"};
  static constexpr std::string_view tween[] = {"u", "from", "to", "before", "after", "duration"};
  const auto has = [&](const auto& words) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
  };
  return role == Role::steps ? has(steps) : role == Role::tween && has(tween);
}

bool procedure(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view name;
  if (!new_name(c, name, "procedure's name", "/.")) return false;
  Role role = Role::value;
  for (std::size_t r = 0; r < role_names.size(); ++r)
    if (c.accept_word(role_names[r])) role = static_cast<Role>(r);
  Stepping stepping;
  if (role == Role::steps && !read_stepping(c, stepping)) return false;
  NamedProcedure made{std::string(name), role, nullptr, stepping};
  c.space();
  if (role == Role::command && c.peek() == '(' && !read_parameters(k, made.parameters)) return false;
  c.space();
  if (role == Role::command && c.peek() == '"' && !c.text(made.help)) return false;
  if (!c.accept_word("lua")) {
    const char* const here = c.at;
    const std::string_view word = c.word();
    using Words = std::vector<std::string_view>;
    const Words fitting = role == Role::steps ? Words{"every", "from", "hold", "lua"}
                                              : Words{"twerper", "tween", "filter", "command", "steps", "lua"};
    if (const Hint near = did_you_mean(word, fitting); !near.text.empty())
      return c.fail(ErrorCode::syntax, fmt::format("a procedure cannot have the word '{}' here", word), word, near);
    c.at = here;
    return c.fail_here(ErrorCode::syntax, "'lua' is missing here", "as in procedure snap twerper lua \"u*u\"");
  }
  c.space();
  const char* start = c.at;
  std::string source;
  if (!c.text(source)) return false;
  const std::string_view about = c.since(start);
  if (!finish(c)) return false;
  if (const std::string_view what = taken_by(name, role); !what.empty())
    return c.fail(ErrorCode::name, fmt::format("'{}' is already {}", name, what), name);
  const bool knows_lets = role == Role::value || role == Role::steps || role == Role::tween;
  if (!made.parameters.empty())  // checks the code with its parameters
    if (const auto whole = make_with_locals(role, declared(made.parameters), source); !whole)
      return c.fail(whole.error(), about);
  auto code = knows_lets ? make_code(k, std::move(source), false, role) : make_lua(role, std::move(source));
  if (!code) return c.fail(code.error(), about);
  made.code = *std::move(code);
  made.code_at = script.source.diagnose(Severity::notice, {}, about).what.place;
  const auto& all = *s.procedures;
  const auto at = std::find_if(all.begin(), all.end(), [&](const NamedProcedure& p) { return p.name == name; });
  if (at == all.end()) {
    if (all.size() >= 200) return c.fail(ErrorCode::range, "a film can have at most 200 named procedures", name);
    s.procedures.edit().push_back(std::move(made));
    return true;
  }
  if (at->role != role)
    return c.fail(
        ErrorCode::name,
        fmt::format("'{}' is already a {}", name,
                    at->role == Role::steps ? "stepped procedure" : role_names[static_cast<std::size_t>(at->role)]),
        name);
  s.procedures.edit()[static_cast<std::size_t>(at - all.begin())] = std::move(made);
  // Filters store their code; they continue with the new one.
  if (role == Role::filter)
    for (std::size_t i = 0; i < s.objects.size(); ++i)
      for (std::size_t k = 0; k < s.objects[i].slots.size(); ++k)
        for (std::size_t f = 0; f < s.objects[i].slots[k].filters.size(); ++f)
          if (s.objects[i].slots[k].filters[f].name == name)
            s.objects.edit(i).slots[k].filters[f].code = find_procedure(s, name)->code;
  return true;
}

// The functions with which the author's code can change the film. Its lines run as if they replaced the command.
struct Hosting : Host {
  Command& k;
  bool called_off = false;  // reported only after the code has returned, so that the code cannot catch it
  explicit Hosting(Command& command) : k(command) {}
  Status run(std::string_view line) override {
    return or_called_off([&] { return run_line(line); });
  }
  Result<Value> value(std::string_view target, double seconds) override {
    return or_called_off([&] { return value_of(target, seconds); });
  }
  std::vector<std::string> objects(std::string_view pattern) override {
    std::vector<std::string> names;
    (void)or_called_off([&]() -> Status {
      for (ObjectId id : select(k.scene, pattern)) names.push_back(k.scene.objects[id.index].name);
      return Nothing{};
    });
    return names;
  }
  Result<Vec3> place(std::string_view line, double share, double seconds) override {
    return or_called_off([&] { return place_of_line(line, share, seconds); });
  }
  Status sheet(std::string_view target, const std::vector<HostRow>& rows) override {
    return or_called_off([&] { return write_sheet(target, rows); });
  }
  std::string when(double seconds) override { return write_time(from_seconds(seconds), k.scene.rate); }

 private:
  template <class Work>
  auto or_called_off(Work&& work) -> decltype(work()) {
    try {
      return work();
    } catch (const Cancelled&) {
      called_off = true;
      return fail(ErrorCode::machine, "cancelled: a newer change replaces this one");
    }
  }
  Status run_line(std::string_view line) {
    program_.reset();
    for (const Diagnostic& d : carried_out(k, line)) {
      const std::string what = fmt::format("{} (in \"{}\")", d.what.message, line.substr(0, 80));
      if (d.severity == Severity::error) return fail(d.what.code, what, d.what.hint);
      if (d.severity == Severity::warning) k.script.note(Severity::warning, what, {k.script.verb, 0}, d.what.hint);
    }
    return Nothing{};
  }
  Result<Value> value_of(std::string_view target, double seconds) {
    if (!(std::abs(seconds) <= longest_seconds)) return fail(ErrorCode::range, "there is no such time");
    const auto t = find_target(k.scene, target);
    if (!t) return t.error();
    return program().read(*t, from_seconds(seconds));
  }
  Result<Vec3> place_of_line(std::string_view line, double share, double seconds) {
    if (!(std::abs(seconds) <= longest_seconds)) return fail(ErrorCode::range, "there is no such time");
    Asking asking;
    return place_on(program().compiled(), line, share, seconds, asking);
  }
  Status write_sheet(std::string_view target, const std::vector<HostRow>& rows) {
    const auto t = find_target(k.scene, target);
    if (!t) return t.error();
    if (t->query()) return fail(ErrorCode::type, fmt::format("'{}' can only be read", target));
    std::string lines(target);
    for (const HostRow& row : rows) {
      lines += "\n  " + when(row.from) + (row.until ? ".." + when(*row.until) : "") + " " + said(*t, row.value);
      if (!row.rest.empty()) lines += " " + row.rest;
    }
    return run_line(lines);
  }
  // Returns the value as the language writes it.
  std::string said(const Target& t, const Value& v) const {
    const FunctionSpec& spec = spec_of(k.scene, t.function);
    const auto* text = std::get_if<Text>(&v);
    if (text && spec.type != Type::text) return **text;
    return write_value(v, spec, t.component, [this](ObjectId id) { return k.scene.objects[id.index].name; });
  }
  // Returns the film as it is now. Lines that the command runs change it.
  const Program& program() {
    if (!program_) program_ = Program::compile(Document(std::make_shared<const Scene>(k.scene)));
    return *program_;
  }
  std::optional<Program> program_;
};

// Reads the words after a command without parameters: texts without their quotes, vectors as they are written.
bool arguments(Cursor& c, std::vector<std::string>& words) {
  while (!c.at_line_end()) {
    if (c.peek() == '"') {
      std::string text;
      if (!c.text(text)) return false;
      words.push_back(std::move(text));
      continue;
    }
    const char* at = c.at;
    if (c.peek() == '(') {
      const char* const behind = bracket_end(at, c.end);
      c.at = behind > at ? behind : line_end(at, c.end);
      words.emplace_back(c.since(at));
      continue;
    }
    if (c.word().empty()) ++c.at;
    words.emplace_back(c.since(at));
  }
  return true;
}

constexpr Verb procedures_rows[] = {
    {"procedure",
     "procedure NAME [twerper|tween|filter|command] lua \"…\", or procedure NAME command (PARAMETER TYPE [= DEFAULT] "
     "…) "
     "[\"SENTENCE\"] lua \"…\", or procedure NAME steps [every LENGTH] [from TIME] [hold] lua \"…\"",
     "Code of your own in Lua, with a name: it computes a value, or is a twerper, a filter or a command. A `tween` is "
     "a twerper that gets the values of the events around it and returns the value itself. A command can have "
     "parameters with names, types and defaults. With `steps`, the code gets "
     "the `state` of the step before and returns the next one: a law with memory.",
     "procedure swing lua \"return math.sin(t)\"\n"
     "procedure hop command (who object, at time, height number = 1) lua \"sheet(who .. '.position.y', {{at, 0}, {at + "
     "0.5, height}, {at + 1, 0}})\"\n"
     "hop ball at=1s\nprocedure chase steps lua \"(state or vec(-5, 0, 0)) * 0.9\"",
     Verb::makes_procedure, procedure, "NEW; twerper tween filter command steps lua; lua every from hold…"},
};

}  // namespace

Result<std::shared_ptr<const Routine>> make_code(const Command& k, std::string source, bool placed, Role role) {
  const Cursor& c = k.cursor;
  std::string names, values;
  for (const std::string_view word : free_names(source)) {
    const std::size_t place = placed ? place_of(word, c.place) : 0;
    const auto let = c.lets ? c.lets->find(word) : Lets::const_iterator();
    const bool let_so = c.lets && let != c.lets->end();
    if ((place == 0 && !let_so) || known_to_lua(word) || find_procedure(k.scene, word)) continue;
    if (is_given(role, word)) continue;
    const std::string value = place > 0 ? std::to_string(place) : write_code(let->second);
    if (value.empty())
      return fail(ErrorCode::type, fmt::format("'{}' is in frames, but code counts seconds", word),
                  fmt::format("write it in seconds: let {} = 0.5s; code can also use frame and rate", word));
    names += (names.empty() ? "" : ", ") + std::string(word);
    values += (values.empty() ? "" : ", ") + value;
  }
  if (names.empty()) return make_lua(role, std::move(source));
  return make_with_locals(role, fmt::format("local {} = {} ", names, values), source);
}

// Runs a command of the author's own: either all of its commands, or none.
bool own_command(Command& k, const NamedProcedure& p) {
  auto& [s, c, time, layer, script] = k;
  const char* start = c.at;
  std::vector<std::string> words, codes;
  if (p.parameters.empty() ? !arguments(c, words)
                           : !read_arguments(k, p, {start - p.name.size(), p.name.size()}, codes)) {
    if (c.error && c.error->hint.empty() && c.error->code == ErrorCode::syntax) c.error->hint = "usage: " + usage_of(p);
    return false;
  }
  if (script.depth >= deepest_command)
    return c.fail(ErrorCode::range, fmt::format("commands call each other more than {} levels deep", deepest_command),
                  {start - p.name.size(), p.name.size()});
  Rollback all(s);
  const NamedProcedure own = p;  // a copy, because its lines may replace this procedure
  Hosting host(k);
  std::shared_ptr<const Routine> code = own.code;
  if (!codes.empty()) {
    auto whole = make_with_locals(Role::command, declared(own.parameters, codes), own.code->source);
    if (!whole) return c.fail(whole.error(), {start - own.name.size(), own.name.size()});
    code = *std::move(whole);
  }
  const Status done = code->command(host, words);
  if (host.called_off) throw Cancelled{};
  if (done) return all.keep(), true;
  const Error& e = done.error();
  const std::string& file = own.code_at.file;
  const std::string what =
      file.empty() || own.code->language != "lua"
          ? with_line(e.place.line, e.message)
          : fmt::format("{}:{}: {}", file, own.code_at.line + std::max(e.place.line, 1) - 1, e.message);
  return c.fail(e.code, fmt::format("{}: {}", own.name, what), {start - own.name.size(), own.name.size()}, e.hint);
}

Diagnostics carried_out(Command& k, std::string_view lines, bool in_block) {
  Diagnostics said;
  LoadOptions options = k.script.options;
  options.now.reset();  // they have no line in a history
  options.lets.clear();
  if (options.shows)  // the place of a text is that of the command
    options.shows = [&k](const std::string& text, const Place&) {
      const Place here = k.script.source.diagnose(Severity::notice, {}, {k.cursor.at, 0}).what.place;
      k.script.options.shows(text, here);
    };
  Script inner(k.scene, said, options);
  inner.translations = k.script.translations, inner.texts_shown = k.script.texts_shown;
  inner.depth = k.script.depth + 1;
  inner.root = k.script.root;
  inner.copied = k.script.copied;
  inner.stems.swap(k.script.stems);
  if (in_block) inner.clock = k.script.clock_now(), inner.in_section = k.script.in_section || !k.script.blocks.empty();
  read_text(k.scene, inner, lines, k.script.source.name);
  k.script.copied = inner.copied;
  inner.stems.swap(k.script.stems);
  k.cursor.reaches(inner.latest);
  return said;
}

std::span<const Verb> procedures_verbs() { return procedures_rows; }

}  // namespace betwixt
