// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/plugins.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "base/names.h"
#include "commands/verbs.h"
#include "procedure/lua.h"
#include "procedure/plugins.h"
#include "scene/styles.h"

namespace betwixt {
namespace {

constexpr std::size_t most_words = 100;       // of all plug-ins
constexpr std::size_t most_procedures = 230;  // of a film: a twerper stores the place among them in one byte

// The words for all scripts of this process.
struct Word {
  std::string name, help, path;
};
struct Brought {
  std::mutex mutex;
  std::vector<Word> words;
  std::vector<NamedProcedure> procedures;
  std::vector<FunctionSpec> functions;
  std::vector<PluginKind> kinds;
  std::vector<PluginRenderer> renderers;
};
Brought& brought() {
  static Brought b;
  return b;
}

// Returns the type of this name if its values are numbers, otherwise nullptr.
const TypeRow* type_of_numbers(std::string_view word) {
  const TypeRow* row = find_type(word);
  return row && row->dials && row->channels > 0 ? row : nullptr;
}

bool is_function(std::string_view name) {
  const auto all = built_in_functions();
  if (std::any_of(all.begin(), all.end(), [&](const FunctionSpec& f) { return f.name == name; })) return true;
  return name == "world" || name == "velocity";
}

}  // namespace

std::string_view taken_by(std::string_view name, Role role) {
  if (find_verb(name)) return "a command";
  if (name == name_of(Twerper::unset) || find_twerper(name)) return "a twerper";
  if (find_filter(name)) return "a filter";
  if (role == Role::value && known_to_lua(name)) return "a word of Lua code";
  const auto shell = reserved_words();
  if (role == Role::command && std::find(shell.begin(), shell.end(), name) != shell.end()) return "a shell command";
  return {};
}

Status use_plugin(const std::string& path) {
  auto plugin = load_plugin(path);
  if (!plugin) return plugin.error();
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  const auto refuse = [&](ErrorCode code, std::string why) { return fail(code, fmt::format("{}: {}", path, why)); };
  std::vector<Word> words;
  const auto free = [&](const std::string& name, std::string_view taken) -> Status {
    if (!is_name(name)) return refuse(ErrorCode::name, fmt::format("'{}' cannot be a name", name));
    if (!taken.empty())
      return refuse(ErrorCode::name, fmt::format("it registers '{}', which is already {}", name, taken));
    for (const Word& w : words)
      if (w.name == name) return refuse(ErrorCode::name, fmt::format("it registers '{}' twice", name));
    for (const Word& w : all.words)
      if (w.name == name && w.path != path)
        return refuse(ErrorCode::name, fmt::format("it registers '{}', which {} has already registered", name, w.path));
    return Nothing{};
  };
  std::vector<FunctionSpec> functions;
  for (const PluginItem& item : plugin->items) {
    if (const Status s = free(item.name, taken_by(item.name, item.role)); !s) return s;
    words.push_back({item.name, item.help, path});
  }
  for (const PluginFunction& f : plugin->functions) {
    if (const Status s = free(f.name, is_function(f.name) ? "a function" : ""); !s) return s;
    const TypeRow* row = type_of_numbers(f.type);
    if (!row)
      return refuse(ErrorCode::type, fmt::format("the function '{}' has an unknown type: '{}'", f.name, f.type));
    words.push_back({f.name, {}, path});
    double n[4] = {};
    std::copy_n(f.numbers.begin(), std::min<std::size_t>(f.numbers.size(), 4), n);
    functions.push_back(
        {.name = f.name, .type = row->type, .rest = value_of_numbers(row->type, n), .kinds = 0xffffffff});
  }
  for (const PluginKind& kind : plugin->kinds) {
    if (const Status s = free(kind.name, find_kind(kind.name) ? "a kind of objects" : ""); !s) return s;
    words.push_back({kind.name, kind.help, path});
  }
  for (const PluginRenderer& renderer : plugin->renderers) {
    const bool taken = std::find(style_names.begin(), style_names.end(), renderer.name) != style_names.end();
    if (const Status s = free(renderer.name, taken ? "a style" : ""); !s) return s;
    words.push_back({renderer.name, renderer.help, path});
  }
  const auto others = static_cast<std::size_t>(
      std::count_if(all.words.begin(), all.words.end(), [&](const Word& w) { return w.path != path; }));
  if (others + words.size() > most_words)
    return refuse(ErrorCode::range, fmt::format("plug-ins can have at most {} words", most_words));
  // If the same file is loaded again, its words are replaced.
  std::erase_if(all.procedures, [&](const NamedProcedure& p) { return p.code->source == path; });
  const auto replaced = [&](const auto& one) {
    return std::any_of(all.words.begin(), all.words.end(),
                       [&](const Word& w) { return w.path == path && w.name == one.name; });
  };
  std::erase_if(all.functions, replaced), std::erase_if(all.kinds, replaced);
  std::erase_if(all.renderers, replaced);
  std::erase_if(all.words, [&](const Word& w) { return w.path == path; });
  for (const PluginItem& item : plugin->items) all.procedures.push_back({item.name, item.role, item.code});
  all.functions.insert(all.functions.end(), functions.begin(), functions.end());
  all.renderers.insert(all.renderers.end(), plugin->renderers.begin(), plugin->renderers.end());
  all.kinds.insert(all.kinds.end(), plugin->kinds.begin(), plugin->kinds.end());
  all.words.insert(all.words.end(), words.begin(), words.end());
  return Nothing{};
}

void adopt_plugins(Scene& s) {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  for (const NamedProcedure& p : all.procedures)
    if (!find_procedure(s, p.name) && s.procedures->size() < most_procedures) s.procedures.edit().push_back(p);
  for (const FunctionSpec& f : all.functions)
    if (!find_function(s, Kind::group, f.name)) s.defined.edit().push_back(f);
}

std::optional<std::string> plugin_kind(std::string_view name) {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  for (const PluginKind& kind : all.kinds)
    if (kind.name == name) return kind.lines;
  return std::nullopt;
}

std::vector<std::string> plugin_kinds() {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  std::vector<std::string> names;
  for (const PluginKind& kind : all.kinds) names.push_back(kind.name);
  return names;
}

std::optional<PluginRenderer> plugin_renderer(std::string_view name) {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  for (const PluginRenderer& renderer : all.renderers)
    if (renderer.name == name) return renderer;
  return std::nullopt;
}

std::vector<PluginRenderer> plugin_renderers() {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  return all.renderers;
}

std::string plugin_help(std::string_view word) {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  for (const Word& w : all.words)
    if (w.name == word) return w.help;
  return {};
}

namespace {
template <class Fits>
std::vector<std::string> plugins_whose(Fits&& fits) {
  Brought& all = brought();
  const std::lock_guard lock(all.mutex);
  std::vector<std::string> paths;
  for (const Word& w : all.words)
    if (std::find(paths.begin(), paths.end(), w.path) == paths.end() && fits(w)) paths.push_back(w.path);
  return paths;
}
}  // namespace

std::vector<std::string> plugins_for(std::string_view script) {
  return plugins_whose([&](const Word& w) { return stands_in(script, w.name); });
}
std::vector<std::string> plugins_loaded() {
  return plugins_whose([](const Word&) { return true; });
}

}  // namespace betwixt
