// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Scripts, and the files that scripts name. A script reads only below its own folder, unless its caller allows more.
#include "base/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/kept_results.h"
#include "base/memory_budget.h"
#include "base/names.h"
#include "betwixt/picture.h"
#include "commands/command.h"
#include "commands/furnishing.h"
#include "commands/reader.h"
#include "commands/translating.h"
#include "commands/video_files.h"
#include "exchange/font_face.h"
#include "exchange/formulas.h"
#include "exchange/meshes.h"
#include "exchange/pictures.h"
#include "exchange/said_text.h"
#include "exchange/scene_file.h"
#include "exchange/sent.h"
#include "exchange/sounds.h"
#include "exchange/tex.h"
#include "exchange/typefaces.h"
#include "exchange/words_file.h"
#include "language/code_names.h"
#include "scene/memory.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr int most_included = 10'000;  // files that use files can multiply without end

Result<std::string> contents(const fs::path& path, bool special) {
  FileContents in = read_contents(path.string(), {.special = special});
  const auto failed = [&](const std::string& what) {
    return fail(ErrorCode::file, fmt::format("'{}' {}", path.string(), what));
  };
  switch (in.problem) {
    case ReadProblem::none:
      return std::move(in.text);
    case ReadProblem::missing:
      return no_file(path.string());
    case ReadProblem::folder:
      return failed("is a folder, not a script");
    case ReadProblem::special:
      return failed("is not a regular file");
    case ReadProblem::too_large:
      return failed(
          fmt::format("is too large for a script: {:.1f} GB; the limit is 1 GiB", static_cast<double>(in.size) / 1e9));
    default:
      return failed(fmt::format("cannot be read: {}", std::strerror(in.reason)));
  }
}

// Returns the path without links and dots, from any working folder. Works for a missing file, too.
fs::path real_path(const fs::path& path, std::error_code& why) {
  const fs::path whole = fs::absolute(path, why);
  return why ? path : fs::weakly_canonical(whole, why);
}

}  // namespace

bool Script::may_read(const fs::path& path) const {
  if (sent::is_ours(path)) return true;
  if (options.read_nothing) return false;
  std::error_code why;
  const fs::path real = real_path(path, why);
  const bool below = !why && std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
  if (!below && !options.read_anywhere) return false;
  if (options.asked_for) options.asked_for(why ? path.string() : real.string());
  return true;
}

// Returns the path for messages: relative to the first script's folder.
std::string Script::shown(const fs::path& path) const {
  std::error_code why;
  const fs::path real = real_path(path, why);
  const fs::path below = real.lexically_relative(root);
  return below.empty() || why ? path.string() : below.string();
}

void read_file(Scene& s, Script& script, const std::string& path) {
  auto text = contents(path, true);  // the author named it, so it may be a pipe
  if (!text) {
    script.diagnostics.push_back({Severity::error, text.error(), {}, 0});
    return;
  }
  std::error_code ignored;
  script.open_files.push_back(real_path(path, ignored));
  read_text(s, script, *text, path);
  script.open_files.pop_back();
}

bool has_room(Command& k, const ContentBytes& contents, std::string_view about) {
  try {
    MemoryBudget::charge_kept(contents.sum(), [&] { return bytes_of_values(k.scene); });
    return true;
  } catch (const OverBudget& limit) {
    const Error e = too_many_bytes(limit.most);
    return k.cursor.fail(e, about);
  }
}

namespace {

// Withdraws the diagnostics of a file that has no script's header, because their quotations could reveal its contents.
// If there are errors from index `said` on, removes all diagnostics from there on and returns the line of the first
// error, or 0 if it is in another file. Otherwise returns nullopt.
std::optional<int> take_back(Script& script, std::size_t said, const std::string& file) {
  auto& all = script.diagnostics;
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(said);
  const auto bad = std::find_if(first, all.end(), [](const auto& d) { return d.severity == Severity::error; });
  if (bad == all.end()) return std::nullopt;
  const int line = bad->what.place.file == file ? bad->what.place.line : 0;
  all.erase(first, all.end());
  return line;
}

bool use(Command& k) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* start = c.at;
  std::string name;
  if (c.peek() == '"') {
    if (!c.text(name)) return false;
  } else {
    name = c.word();
  }
  const std::string_view about(start, static_cast<std::size_t>(c.at - start));
  if (name.empty()) return c.fail(ErrorCode::syntax, "the name of a file is missing here", about);
  if (!finish(c)) return false;
  const fs::path path = script.folder / name;
  if (!script.may_read(path))
    return c.fail(ErrorCode::file, fmt::format("'{}' is outside the script's folder", name), about,
                  Hint(Permission::read_anywhere, "--read-anywhere allows it"));
  std::error_code ignored;
  const fs::path real = real_path(path, ignored);
  if (std::find(script.open_files.begin(), script.open_files.end(), real) != script.open_files.end())
    return c.fail(ErrorCode::file, fmt::format("'{}' includes itself", name), about);
  if (script.open_files.size() >= 64)
    return c.fail(ErrorCode::file, "files include each other more than 64 levels deep", about);
  if (script.included >= most_included)
    return c.fail(ErrorCode::file, fmt::format("the script includes more than {} files", most_included), about);
  ++script.included;
  const auto written = script.options.written ? script.options.written(real.string()) : std::nullopt;
  auto text = written ? Result(*written) : contents(path, false);
  if (!text) return c.fail(text.error().code, text.error().message, about);
  script.open_files.push_back(real);
  const std::size_t said = script.diagnostics.size();
  const auto now = std::exchange(script.options.now, std::nullopt);  // its lines belong to the time of writing
  read_text(s, script, *text, path.string());
  script.options.now = now;
  script.open_files.pop_back();
  if (ending(path.string()) != "bx")
    if (const auto bad = take_back(script, said, path.string())) {
      const std::string where = *bad > 0 ? fmt::format(": its line {} is not a command", *bad) : "";
      return c.fail(ErrorCode::file, fmt::format("'{}' is not a script{}", name, where), about,
                    "only errors in files that end in .bx are shown in full");
    }
  // Settings that the file may have changed apply to the rest of this line.
  c.rate = s.rate, c.ticks = s.ticks;
  return true;
}

// The contents of files in a scene, by path.
template <class T>
using Contents = Cow<std::map<std::string, std::shared_ptr<const T>>>;
template <class T>
bool keep(Command& k, Contents<T>& all, const std::string& path, const Result<std::shared_ptr<const T>>& read,
          std::string_view about) {
  if (!read) return k.cursor.fail(read.error(), about);
  ContentBytes bytes;
  bytes.add(*read);
  if (!has_room(k, bytes, about)) return false;
  all.edit()[path] = *read;
  return true;
}

// Returns the piece of a quoted text, as it is written, that became these bytes of the text.
std::string_view written_piece(std::string_view quoted, std::size_t at, std::size_t length) {
  if (quoted.starts_with("\"\"\"")) return quoted.size() > 6 + at ? quoted.substr(3 + at, length) : quoted;
  if (!quoted.starts_with('"')) return quoted;
  const auto place = [&](std::size_t bytes) {
    std::size_t i = 1;
    for (std::size_t n = 0; n < bytes && i < quoted.size(); ++n) i += quoted[i] == '\\' ? 2 : 1;
    return std::min(i, quoted.size());
  };
  return quoted.substr(place(at), place(at + length) - place(at));
}

// Adds the formula of a `tex`. With --tex, LaTeX sets formulas; it knows no parts, so those with parts are set here.
bool tex_formula(Command& k, const std::string& tex, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (s.formulas->contains(tex)) return true;
  if (script.options.tex && tex.find("{{") == tex.npos)
    return keep(k, s.formulas, tex, KeptResults::get("tex", tex, [&] { return set_by_tex(tex); }), about);
  const auto made = KeptResults::get("formula", tex, [&] { return set_formula_text(tex); });
  if (made) return keep(k, s.formulas, tex, made, about);
  Error e = made.error();
  if (e.code == ErrorCode::name && e.hint.empty() && !script.options.tex)
    set_hint(e, Hint(Permission::tex, "--tex lets LaTeX typeset it"));
  if (e.place.column == 0) return c.fail(e, about);
  const auto first = static_cast<std::size_t>(e.place.column - 1);
  return c.fail(e, written_piece(about, first, static_cast<std::size_t>(e.place.length)));
}

// Loads one mesh of a scene, truck.glb#Wheels, or a picture of one, truck.glb#Wheels/normals.
bool part_of_scene(Command& k, FunctionId f, std::string& path, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  const std::string part = path.substr(path.find('#'));
  path = scene_of(path);
  fs::path where;
  if (!may_use(k, path, about, where)) return false;
  const std::string file = std::exchange(path, path + part);
  const auto has = [&] { return f == fn::file ? k.scene.meshes->contains(path) : k.scene.pictures->contains(path); };
  if (has()) return true;
  const auto scene = scene_of_file(k, where);
  if (!scene) return c.fail(scene.error(), about);
  if (!keep_meshes(k, file, **scene, about)) return false;
  if (has()) return true;
  if (is_picture(f))
    return c.fail(ErrorCode::name, fmt::format("{} has no picture '{}'", file, part.substr(1, 60)), about,
                  "as in helmet.glb#Helmet/normals; others are roughness, metalness, occlusion and emission");
  std::vector<std::string_view> names;
  for (const SceneMesh& m : (*scene)->meshes) names.push_back(m.name);
  return c.fail(ErrorCode::name, fmt::format("{} has no mesh '{}'", file, part.substr(1, 60)), about,
                did_you_mean(part.substr(1), names));
}

// Loads the file that `file` (of a mesh, a sound or a video), `texture` or `font` names into the scene. Makes `path`
// relative to the first script's folder.
bool asset(Command& k, FunctionId f, std::string& path, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (is_read_by_people(f)) return translate_text(script, path, about), true;
  if (f == fn::font && !names_font_file(path)) {
    const Status known = find_font(path);
    if (!known) script.note(Severity::warning, known.error().message, about, known.error().hint);
    return true;
  }
  static const FunctionId tex = *find_built_in(Kind::text, "tex");
  if (f == tex) return path.empty() || tex_formula(k, path, about);
  const bool named = f == fn::file || is_picture(f) || f == fn::sound_file || f == fn::sound_words ||
                     f == fn::video_file || f == fn::font;
  if (!named || path.empty()) return true;
  if (f == fn::sound_file && names_said_text(path)) return load_said_text(k, path, about, about);
  if ((f == fn::file || is_picture(f)) && path.find('#') != path.npos) return part_of_scene(k, f, path, about);
  fs::path where;
  if (!may_use(k, path, about, where)) return false;
  const bool any_size = script.options.read_anywhere;
  const MayRead may_read = [&](const std::string& p) { return k.script.may_read(p); };
  // Reads the file once, even if the command is carried out again.
  const auto add = [&](auto& all, const char* what, const auto& read) {
    return all->contains(path) || keep(k, all, path, KeptResults::get(what, where.string(), read), about);
  };
  if (f == fn::file) return add(s.meshes, "mesh", [&] { return load_mesh(where.string(), may_read, any_size); });
  if (f == fn::sound_file) return add(s.sounds, "sound", [&] { return read_sound(where.string(), any_size); });
  if (f == fn::video_file || (is_picture(f) && names_video(path))) return video_of_file(k, f, path, where, about);
  if (f == fn::sound_words) return add(s.words, "words", [&] { return load_words(where.string()); });
  if (f == fn::font) return add(s.fonts, "font", [&] { return load_font(where.string()); });
  return add(s.pictures, "picture", [&] { return load_picture(where.string(), any_size); });
}

// Finds bytes that a host has sent. A line that is kept gets the full name, so that it means these bytes for ever.
bool find_sent(Command& k, std::string& path, std::string_view about, fs::path& where) {
  const std::string name = path.substr(1);
  const auto full = sent::full_name(name);
  if (!full) return k.cursor.fail(full.error(), about);
  std::string instead(about);
  const auto at = instead.find(path);
  if (*full != name && k.script.live) {
    if (at == instead.npos || !k.script.in_line(about))
      return k.cursor.fail(ErrorCode::name,
                           fmt::format("'{}' can mean other bytes later, so it cannot stand here", path), about,
                           fmt::format("write the full name: @{}", *full));
    k.script.respell_live(about, instead.replace(at, path.size(), "@" + *full));
  }
  path = "@" + *full;
  where = sent::file_of(*full).value_or(fs::path());
  std::error_code ignored;
  if (!where.empty() && fs::exists(where, ignored)) return true;
  where = k.script.root / sent::folder_name / *full;
  if (k.script.may_read(where) && fs::exists(where, ignored)) return true;
  return k.cursor.fail(ErrorCode::file, fmt::format("the bytes that were sent as '{}' are not here", path), about,
                       fmt::format("they belong in the file {}/{}, beside the script", sent::folder_name, *full));
}

}  // namespace

bool may_use(Command& k, std::string& path, std::string_view about, fs::path& where) {
  if (path.starts_with('@')) return find_sent(k, path, about, where);
  where = k.script.folder / path;
  if (!k.script.may_read(where))
    return k.cursor.fail(ErrorCode::file, fmt::format("'{}' is outside the script's folder", path), about,
                         Hint(Permission::read_anywhere, "--read-anywhere allows it"));
  path = k.script.shown(where);
  return true;
}

Result<std::shared_ptr<const SceneFile>> scene_of_file(const Command& k, const fs::path& where) {
  return KeptResults::get("scene", where.string(), [&] {
    return load_scene(
        where.string(), [&](const std::string& p) { return k.script.may_read(p); }, k.script.options.read_anywhere);
  });
}

bool keep_meshes(Command& k, const std::string& path, const SceneFile& scene, std::string_view about) {
  Scene& s = k.scene;
  std::vector<const SceneMesh*> fresh;
  std::vector<std::pair<std::string, std::shared_ptr<const Picture>>> pictures;
  ContentBytes bytes;
  for (const SceneMesh& m : scene.meshes) {
    if (!s.meshes->contains(path + "#" + m.name)) fresh.push_back(&m), bytes.add(m.mesh);
    for (const NamedPicture& p : pictures_of_finish())
      if (const auto picture = m.finish ? (*m.finish).*p.is : nullptr)
        if (std::string name = fmt::format("{}#{}/{}", path, m.name, p.name); !s.pictures->contains(name))
          bytes.add(picture), pictures.emplace_back(std::move(name), picture);
  }
  if (!has_room(k, bytes, about)) return false;
  for (const SceneMesh* m : fresh) s.meshes.edit()[path + "#" + m->name] = m->mesh;
  for (auto& [name, picture] : pictures) s.pictures.edit()[name] = picture;
  return true;
}

ValueReader values(Command& k) {
  return {k.cursor, k.scene,
          [&k](FunctionId f, std::string& path, std::string_view about) { return asset(k, f, path, about); },
          [&k](std::string message, std::string_view about, std::string hint) {
            k.script.note(Severity::warning, std::move(message), about, std::move(hint));
          },
          [&k](std::string_view place, std::string instead) { k.script.respell(place, std::move(instead)); }};
}

namespace {
constexpr Verb files_rows[] = {
    {"use", "use FILE", "Includes another script here.", "use colors.bx", 0, use, "FILE"},
};
}  // namespace

std::span<const Verb> files_verbs() { return files_rows; }

namespace {

// Returns the files below the script's folder that "walk%03d.png" stands for, or the name itself if it has no such
// place for a number.
std::vector<std::string> files_like(const Script& script, const std::string& name) {
  constexpr std::size_t most = 10'000;
  const auto percent = name.find('%'), end = name.find_first_not_of("0123456789", percent + 1);
  if (percent == name.npos || end == name.npos || name[end] != 'd') return {name};
  const auto slash = name.rfind('/', percent);
  const std::string before = slash == name.npos ? "" : name.substr(0, slash + 1);
  const std::string begin = name.substr(before.size(), percent - before.size()), behind = name.substr(end + 1);
  std::vector<std::string> all;
  const fs::path folder = script.folder / before;
  if (!script.may_read(folder)) return {};
  std::error_code why;
  for (const auto& e : fs::directory_iterator(folder, why)) {
    const std::string is = e.path().filename().string();
    if (is.size() <= begin.size() + behind.size() || !is.starts_with(begin) || !is.ends_with(behind)) continue;
    const std::string_view number = std::string_view(is).substr(begin.size(), is.size() - begin.size() - behind.size());
    if (number.find_first_not_of("0123456789") == number.npos) all.push_back(before + is);
    if (all.size() == most) break;
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

template <class Contents>
void name_again(Contents& all, const std::string& path, const std::string& name) {
  if (const auto found = all->find(path); found != all->end()) all.edit()[name] = found->second;
}

bool files_in_code(Command& k, FunctionId f, const std::string& source, std::string_view about) {
  if (!is_picture(f) && f != fn::file && f != fn::video_file && f != fn::font) return true;
  for (const std::string& text : quoted_texts(source))
    for (const std::string& name : files_like(k.script, text)) {
      const fs::path where = k.script.folder / name.substr(0, name.find('#'));
      std::error_code why;
      if (name.empty() || !k.script.may_read(where) || !fs::is_regular_file(where, why)) continue;
      std::string path = name;
      if (!asset(k, f, path, about)) return false;
      if (path == name) continue;  // else the code of an included script uses a name of its own
      name_again(k.scene.fonts, path, name), name_again(k.scene.videos, path, name);
      name_again(k.scene.pictures, path, name), name_again(k.scene.meshes, path, name);
    }
  return true;
}

}  // namespace betwixt
