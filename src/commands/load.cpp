// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/cancellation.h"
#include "base/names.h"
#include "commands/command.h"
#include "commands/lint.h"
#include "commands/reader.h"
#include "program/compiled.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// If a film has remarks, reads it a second time to find their places.
template <class Read>
void say_remarks(const Scene& scene, Diagnostics& out, const LoadOptions& options, const SectionsAhead& ahead,
                 const Read& read) {
  PlaceFinder watch(lint(scene));
  if (watch.remarks().empty()) return;
  Scene again = with_files_of(scene);
  Diagnostics said;
  Script script(again, said, options);
  script.options.asked_for = {}, script.options.shows = {};
  script.watch = &watch;
  script.ahead = ahead;
  read(again, script);
  for (const Remark& remark : watch.remarks()) out.push_back(remark.said);
}

template <class Read>
Loaded load(const LoadOptions& options, Read&& read, Scene scene = {}) {
  Diagnostics diagnostics;
  SectionsAhead ahead;
  read_settled(
      scene, diagnostics, ahead, [&] { return Script(scene, diagnostics, options); }, read);
  if (!has_errors(diagnostics)) say_remarks(scene, diagnostics, options, ahead, read);
  return {Document(std::make_shared<const Scene>(std::move(scene))), std::move(diagnostics)};
}

}  // namespace

Scene with_files_of(const Scene& was) {
  Scene scene;
  scene.meshes = was.meshes, scene.pictures = was.pictures, scene.sounds = was.sounds, scene.formulas = was.formulas;
  scene.fonts = was.fonts, scene.tables_read = was.tables_read, scene.words = was.words, scene.videos = was.videos;
  return scene;
}

Loaded load_file(const std::string& path, const LoadOptions& options) {
  return load(options, [&](Scene& s, Script& script) { read_file(s, script, path); });
}

Loaded load_text(std::string_view text, const std::string& name, const LoadOptions& options) {
  return load(options, [&](Scene& s, Script& script) { read_text(s, script, text, name); });
}

Loaded load_text_again(std::string_view text, const std::string& name, const LoadOptions& options,
                       const Document& before) {
  return load(
      options, [&](Scene& s, Script& script) { read_text(s, script, text, name); }, with_files_of(before.scene()));
}

namespace {

Cursor cursor(std::string_view text, const Document& d) {
  Cursor c(text);
  c.rate = d.rate();
  c.ticks = d.scene().ticks;
  c.lets = &*d.scene().lets, c.tables = &*d.scene().tables, c.moments = &d.scene();
  return c;
}

}  // namespace

Result<double> parse_shutter(std::string_view text, const Document& d) {
  Cursor c = cursor(text, d);
  double seconds = 0;
  const bool read = c.opening(seconds) && c.at_line_end() && c.at == c.end;
  if (c.error && c.error->code == ErrorCode::range) return *c.error;
  if (!read)
    return fail(ErrorCode::syntax, fmt::format("'{}' is not a shutter time", text.substr(0, 60)),
                "write 180deg (half a frame), 10ms, 0.5f or off");
  if (!(seconds >= 0 && seconds <= 60)) return fail(ErrorCode::range, "a shutter time must be from 0 to 60 s");
  return seconds;
}

Result<Time> parse_time(std::string_view text, const Document& d) {
  Cursor c = cursor(text, d);
  const SectionTimes sections = [&](std::string_view name, bool end) { return section_edge(d.sections(), name, end); };
  c.sections = &sections;
  Time t;
  if (c.time(t) && c.at_line_end() && c.at == c.end) return t;
  if (c.error) return *c.error;
  return fail(ErrorCode::syntax, fmt::format("'{}' is not a time", text.substr(0, 60)),
              "times look like 24f, 2.5s, 500ms, 90t or 00:01:02.5");
}

std::string format_time(Time t, const Document& d) { return format_time(t, d.rate()); }

Result<std::vector<Target>> find_targets(std::string_view pattern, const Document& d) {
  Scene scene = d.scene();
  Diagnostics notices;
  Script script(scene, notices, {});
  Cursor c(pattern);
  Command asking{scene, c, {}, {}, script};
  const std::string_view word = c.word();
  if (c.at != c.end || word.empty())
    return fail(ErrorCode::syntax, fmt::format("'{}' is not a target", pattern.substr(0, 60)),
                "a target is an object and a function, as in ball.position");
  Selected found;
  std::vector<Target> out;
  if (const auto objects = select(scene, word); !objects.empty()) {  // an object: all its values, and its place
    for (ObjectId id : objects) {
      Cancellation::check();
      for (const Slot& slot : scene.objects[id.index].slots)
        if (!slot.layer) out.push_back({id, slot.function, -1});
      out.push_back({id, Query::world});
    }
    return out;
  }
  if (word.find('.') == std::string_view::npos) {  // meant as an object, but there is none
    if (is_pattern(word) || scene.aliases->contains(std::string(word))) return out;
    return unknown_name("object", word, near_object(scene, word));
  }
  if (!targets(asking, word, found, Meant::asked))
    return c.error.value_or(fail(ErrorCode::name, "nothing has this name"));
  const auto turns = [&](const Target& t) {
    if (t.component < 0 || t.velocity || t.query()) return false;
    const Type type = spec_of(scene, t.function).type;
    return type == Type::rotation || type == Type::orientation;
  };
  if (std::none_of(found.targets.begin(), found.targets.end(), turns)) return found.targets;
  const Program program = Program::compile(d);
  for (const Target& t : found.targets)
    if (turns(t) && program.compiled().find(t.object.index, t.function).orientation &&
        program.compiled().find(t.object.index, t.function).live < 0)
      return fail(
          ErrorCode::type,
          fmt::format("'{}' has orientations, which have no separate angles", d.name(Target{t.object, t.function, -1})),
          "read the whole value");
  return found.targets;
}

}  // namespace betwixt
