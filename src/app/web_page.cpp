// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The page's text is in web/page.html. Everything in the page is readable; only files and the player are packed.
#include "app/web_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "app/command.h"
#include "app/markup.h"
#include "app/page_policy.h"
#include "app/page_videos.h"
#include "app/player_file.h"
#include "app/streams.h"
#include "app/web_page_parts.h"
#include "app/web_page_text.h"
#include "base/base64.h"
#include "base/files.h"
#include "base/utf8.h"
#include "betwixt/language.h"
#include "betwixt/program.h"
#include "exchange/color_table.h"
#include "exchange/said_text.h"
#include "exchange/typefaces.h"
#include "exchange/words_file.h"
#include "export/formats.h"
#include "language/json.h"
#include "scene/code_languages.h"
#include "scene/document.h"
#include "syntax/script_text.h"
#include "syntax/texts.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr int most_looks = 60;  // frames searched for fonts
// The font of every page, and the ranges of letters that it has there (web/CMakeLists.txt), first and last. As UTF-8
// they sort like their code points.
constexpr std::string_view usual_font = "DejaVu Sans";
constexpr std::pair<std::string_view, std::string_view> usual_letters[] = {
    {"\n", "ſ"}, {"Α", "ω"}, {"Ѐ", "џ"}, {"‐", "‧"}, {"←", "↙"}};
constexpr std::size_t most_packed = std::size_t{256} << 20;  // bytes; browsers fail on more

// Returns the comment at the start of a script, without the file's name.
std::string first_comment(std::string_view text) {
  std::string said;
  for (auto words = comment_in(text); words; words = comment_in(text)) {
    (said += said.empty() ? "" : " ") += *words;
    text.remove_prefix(line_at(text, 0).size());
  }
  const std::size_t word = said.find(' ');
  if (word == said.npos || !std::string_view(said).substr(0, word).ends_with(".bx")) return said;
  const std::size_t begin = said.find_first_not_of(" -:", word);
  if (begin == said.npos) return {};
  return said.substr(said.compare(begin, 3, "—") == 0 ? std::min(begin + 4, said.size()) : begin);
}

bool only_the_program_reads(const std::string& path) {
  static constexpr std::string_view endings[] = {"stl", "dae", "fbx", "3ds", "bvh"};
  return std::find(std::begin(endings), std::end(endings), ending(path)) != std::end(endings);
}

// Returns the mesh of a file as glTF.
Result<std::string> as_gltf(const std::string& script, const std::string& name) {
  LoadOptions how = load_options();
  how.asked_for = {}, how.lets.clear();
  const Loaded one = load_text("create it mesh file=" + json_text(name) + " color=white\n", script, how);
  if (has_errors(one.diagnostics)) return one.diagnostics.front().what;
  Exported made;
  return make_glb(Program::compile(one.document), {}, made);
}

// Files that only OpenColorIO reads, because a configuration names them.
bool of_a_configuration(const std::string& path) {
  static constexpr std::string_view endings[] = {"ocio",  "cube",   "3dl", "csp", "clf", "ctf", "spi1d",
                                                 "spi3d", "spimtx", "vf",  "lut", "cc",  "ccc", "cdl",
                                                 "itx",   "look",   "mga", "m3d", "hdl", "cub"};
  return std::find(std::begin(endings), std::end(endings), ending(path)) != std::end(endings);
}

Status add(PageFiles& to, const std::string& script, const std::string& name, const fs::path& path) {
  auto bytes = only_the_program_reads(name) ? as_gltf(script, name) : read_whole(path.string());
  if (!bytes) return bytes.error();
  to[name] = *std::move(bytes);
  return Nothing{};
}

bool has_only_usual_letters(std::string_view text) {
  for (std::size_t i = 0, n = 0; i < text.size(); i += std::max<std::size_t>(1, n)) {
    n = character_length(text, i);
    const std::string_view c = text.substr(i, n);
    if (n > 0 && std::none_of(std::begin(usual_letters), std::end(usual_letters),
                              [&](const auto& range) { return range.first <= c && c <= range.second; }))
      return false;
  }
  return true;
}

bool has_word(std::string_view text, std::string_view word) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  return false;
}

// Collects the fonts of all texts that the film shows, which the page must contain, and the effects that pages leave
// out.
void look_through(PageFilm& film, const Document& document) {
  const Program program = Program::compile(document);
  const auto [first, last] = document.range();
  std::set<std::string> paths, left;
  bool moves = false, focuses = false;
  const auto look = [&](const std::shared_ptr<const Shape>& shape) {
    if (!shape || shape->kind != Kind::text || shape->formula || shape->own_font) return;
    const Typeface face{*shape->font, shape->letters.weight, shape->letters.italic};
    if (!shape->language->empty() && face == Typeface{std::string(code_font)}) return;  // a part of the player
    if (face == Typeface{std::string(usual_font)} && has_only_usual_letters(*shape->text)) return;
    if (!find_font(face.family)) return;
    const FontFile file = font_file(face);
    if (file.index == 0 && !file.path.empty())
      paths.insert(file.path);
    else
      left.insert(face.family);
  };
  const int count = last > first ? most_looks : 1;
  for (int i = 0; i < count; ++i) {
    const Time t{first.flicks + (last.flicks - first.flicks) / count * i};
    const Frame frame = program.frame(t);
    moves |= frame.camera.shutter > 0, focuses |= frame.camera.aperture > 0;
    for (const Item& item : frame.items) look(item.shape), look(item.toward);
  }
  for (const std::string& path : paths)
    if (auto bytes = read_whole(path)) film.files["fonts/" + fs::path(path).filename().string()] = *std::move(bytes);
  if (moves) film.lost.emplace_back("pages do not show motion blur (shutter)");
  if (focuses) film.lost.emplace_back("pages do not show depth of field (f-stop)");
  for (const std::string& family : left)
    film.lost.push_back(
        fmt::format("the page uses {} instead of the font {}, which is part of a collection", usual_font, family));
}

// Adds other features that films have and pages lack.
void add_losses(PageFilm& film, const Document& document) {
  const Scene& scene = document.scene();
  std::vector<std::string> dials;
  for (const Dial& dial : *scene.dials) dials.push_back(dial.address);
  if (!dials.empty())
    film.lost.push_back(fmt::format("pages have no live input: {} ({})", dials.size() == 1 ? "a dial" : "dials",
                                    fmt::join(dials, ", ")));
}

Status add_files(PageFiles& to, const std::string& script, const Document& document,
                 const std::set<std::string>& asked) {
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(script, ignored), folder = real.parent_path();
  const Scene& scene = document.scene();
  std::size_t sum = 0;
  for (const std::string& path : asked) {
    if (path == real || !fs::is_regular_file(path, ignored)) continue;
    const std::string name = fs::path(path).lexically_relative(folder).generic_string();
    if (scene.videos->contains(name) && !scene.sounds->contains(name)) continue;  // add_videos() adds its pictures
    if (name.empty() || name == ".." || name.starts_with("../"))
      return fail(ErrorCode::file, fmt::format("'{}' is outside the folder of {}", path, script),
                  "move it into or below the folder of the script");
    // A page has no OpenColorIO, but the table that it has made.
    if (name == scene.appearance.view_file.file && scene.appearance.grade.table) {
      to[name] = packed_colors(*scene.appearance.grade.table), sum += to[name].size();
      continue;
    }
    if (of_a_configuration(name)) continue;
    if (only_the_program_reads(name) && !scene.meshes->contains(name))
      return fail(ErrorCode::type, fmt::format("pages do not support the format of the scene '{}'", name),
                  "supported: glTF (.glb .gltf) and drawings (.svg)");
    if (Status s = add(to, script, name, path); !s) return s;
    if ((sum += to[name].size()) > most_packed)
      return fail(ErrorCode::range, fmt::format("the files of {} are larger than {} MiB", script, most_packed >> 20));
  }
  return Nothing{};
}

// Adds the voices that say texts, and when they say their words: a page has no espeak-ng.
Status add_voices(PageFiles& to, const Document& document) {
  for (const auto& [name, sound] : *document.scene().sounds) {
    if (!names_said_text(name)) continue;
    const auto said = say_named(name);
    if (!said) return said.error();
    auto wave = read_whole((*said)->wave);
    if (!wave) return wave.error();
    to[said_file(name) + ".wav"] = *std::move(wave), to[said_file(name) + ".words"] = write_words(*(*said)->words);
  }
  return Nothing{};
}

}  // namespace

std::string player_markup(const PageFilm& film, const PageOptions& options, std::string_view flags) {
  const auto [width, height] = options.size.value_or(film.size);
  const std::string fixed = options.size ? " class=\"fixed\"" : "";
  const std::string alt = film.about.empty() ? "" : fmt::format(" alt=\"{}\"", escaped(film.about));
  std::string given;
  for (const GivenLet& let : film.lets)
    given += fmt::format("{}{}:{}", given.empty() ? "" : ",", json_text(let.name), json_text(let.value));
  if (!given.empty()) given = fmt::format(" data-lets=\"{}\"", escaped("{" + given + "}"));
  if (film.language) given += fmt::format(" data-language=\"{}\"", escaped(*film.language));
  // HTML drops a newline at the start of an element, so give it one to drop.
  return fmt::format(
      "<betwixt-player{}{} width=\"{}\" height=\"{}\"{}>\n"
      "<script type=\"text/betwixt\" data-name=\"{}\"{}>\n{}</script>\n</betwixt-player>\n",
      flags, fixed, width, height, alt, escaped(film.name), given, as_script_text(film.text));
}

std::string files_markup(const PageFiles& files) {
  if (files.empty()) return {};
  std::string all;
  for (const auto& [name, bytes] : files)
    all += fmt::format("{}{}: \"{}\"", all.empty() ? "" : ",\n", json_text(name), base64(bytes));
  return "<script type=\"application/json\" data-betwixt-files>\n{" + as_script_text(all) + "}</script>\n";
}

namespace {

std::string film_markup(const PageFilm& film, const PageOptions& options, bool alone) {
  std::string out;
  if (!alone) out += fmt::format("<h2>{}</h2>\n", escaped(fs::path(film.name).stem().string()));
  if (!film.about.empty()) out += fmt::format("<p>{}</p>\n", escaped(film.about));
  const std::string player = player_markup(film, options, alone ? " controls loop autoplay" : " controls loop");
  return out + (options.edit ? "<betwixt-editor>\n" + player + "</betwixt-editor>\n" : player);
}

}  // namespace

std::optional<Result<PageFilm>> film_for_page(const std::string& script) {
  std::set<std::string> asked;
  load_options().asked_for = [&](const std::string& path) { asked.insert(path); };
  const auto document = open_script(script);
  load_options().asked_for = {};
  if (!document) return std::nullopt;
  const auto text = script_text(script);
  if (!text) return text.error();
  PageFilm film;
  film.name = is_stream(script) ? "film.bx" : fs::path(script).filename().string();
  film.text = *text + (text->ends_with('\n') ? "" : "\n");
  film.about = first_comment(*text);
  film.size = document->size().value_or(film.size);
  film.lets = load_options().lets, film.language = load_options().language;
  if (film.language && !film.language->empty()) {
    auto catalogue = read_whole(*film.language);
    if (!catalogue) return catalogue.error();
    film.language = fs::path(*film.language).filename().string();
    film.files[*film.language] = *std::move(catalogue);
  }
  film.begin = document->range().first;
  for (Pause& pause : document->pauses())
    if (pause.time >= film.begin) film.stops.push_back(std::move(pause));
  if (Status s = add_files(film.files, script, *document, asked); !s) return s.error();
  if (Status s = add_voices(film.files, *document); !s) return s.error();
  if (Status s = add_videos(film, *document); !s) return s.error();
  look_through(film, *document);
  add_losses(film, *document);
  return film;
}

// The same files and texts for which engine.js loads them.
PlayerParts needed_parts(const PageFilm& film) {
  // Scripts, fonts, catalogues, tables and words; and sounds, which the browser decodes.
  static constexpr std::string_view without[] = {"bx",  "po",   "ttf",  "otf", "ttc", "csv",  "tsv", "txt", "words",
                                                 "vtt", "srt",  "wav",  "w64", "aif", "aiff", "au",  "caf", "flac",
                                                 "ogg", "oga",  "opus", "mp3", "aac", "mov",  "mp4", "m4a", "mka",
                                                 "mkv", "webm", "avi",  "ac3", "amr", "wv"};
  PlayerParts parts;
  const auto look_at = [&](const std::string& script) {
    parts.formulas |= has_word(script, "tex"), parts.code |= has_word(script, "code");
  };
  look_at(film.text);
  for (const auto& [name, bytes] : film.files) {
    const std::string kind = ending(name);
    parts.reader |= std::find(std::begin(without), std::end(without), kind) == std::end(without);
    if (kind == "bx") look_at(bytes);
  }
  return parts;
}

std::string_view page_look() { return page_css; }

std::string web_page(const std::vector<PageFilm>& films, const PageOptions& options) {
  const bool alone = films.size() == 1;
  std::string all;
  PageFiles files;
  for (const PageFilm& film : films) {
    all += film_markup(film, options, alone);
    files.insert(film.files.begin(), film.files.end());
  }
  PagePolicy policy;
  const bool beside = options.player.empty();
  const std::string player = beside ? policy.script_beside("betwixt-player.js") : policy.script("\n" + options.player);
  std::string look = beside ? policy.style_beside("betwixt-page.css") : policy.style("\n" + std::string(page_css));
  // If a server's policy forbids styles in a page, the player keeps the page's width and the film's aspect ratio.
  if (options.size)
    look += "\n" + policy.style(fmt::format(".fixed {{ width: {}px; height: {}px; }}", options.size->first,
                                            options.size->second));
  return filled(page_html, {{"policy", policy.said()},
                            {"version", BETWIXT_VERSION},
                            {"title", escaped(options.title)},
                            {"look", look},
                            {"class", options.edit ? "edited" : "alone"},
                            {"films", std::move(all)},
                            {"files", files_markup(files)},
                            {"player", player}});
}

}  // namespace betwixt
