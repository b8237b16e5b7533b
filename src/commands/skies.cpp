// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The commands sky, view, white-balance, bloom, vignette and grain.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/kept_results.h"
#include "base/names.h"
#include "betwixt/picture.h"
#include "commands/command.h"
#include "exchange/color_table.h"
#include "scene/memory.h"

namespace betwixt {
namespace {

// Reads a number within bounds.
bool bounded(Command& k, const char* what, double low, double high, double& out) {
  Cursor& c = k.cursor;
  c.space();
  const char* const start = c.at;
  if (!values(k).scalar(out)) return false;
  if (out >= low && out <= high) return true;
  return c.fail(ErrorCode::range, fmt::format("{} must be from {} to {}", what, low, high), c.since(start));
}

// Reads the key of an option and the = after it.
bool option_key(Cursor& c, std::string_view& key) {
  key = c.word();
  if (key.empty()) return finish(c) && false;
  if (c.peek() != '=')
    return c.fail(ErrorCode::syntax, fmt::format("'{}' has no value here", key), key, "as in strength=0.5");
  return ++c.at, true;
}

// Takes what a file has, if it was read and the film has room for it.
template <class Content>
bool kept(Command& k, const Result<Content>& read, std::string_view about, Content& out) {
  if (!read) return k.cursor.fail(read.error(), about);
  ContentBytes bytes;
  bytes.add(*read);
  if (!has_room(k, bytes, about)) return false;
  out = *read;
  return true;
}

// Reads a picture of the whole sky. Makes `path` relative to the first script's folder.
bool read_sky(Command& k, std::string& path, std::string_view about, std::shared_ptr<const LinearPicture>& light) {
  std::filesystem::path where;
  if (!may_use(k, path, about, where)) return false;
  const auto read = KeptResults::get("sky", where.string(), [&]() -> Result<std::shared_ptr<const LinearPicture>> {
    auto picture = read_linear_picture(where.string());
    if (!picture) return picture.error();
    return std::make_shared<const LinearPicture>(*std::move(picture));
  });
  return kept(k, read, about, light);
}

bool sky_option(Command& k, std::string_view key, Sky& sky) {
  Cursor& c = k.cursor;
  if (key == "strength") return bounded(k, "the strength of a sky", 0, 1000, sky.strength);
  if (key == "turn") return values(k).angle(sky.turn);
  if (key == "hour" && sky.kind == Sky::day) return bounded(k, "the hour", 0, 24, sky.hour);
  if (key == "hour") return c.fail(ErrorCode::syntax, "only the sky 'day' has an hour", key, "as in sky day hour=17");
  return c.fail(ErrorCode::name, fmt::format("a sky has no '{}'", key.substr(0, 40)), key,
                did_you_mean(key, {"turn", "strength", "hour"}));
}

// Reads "FILE" or the name of a sky; `plain`: `sky on`.
bool which_sky(Command& k, Sky& sky, std::string& file, bool& plain) {
  Cursor& c = k.cursor;
  c.space();
  if (c.peek() == '"') {
    sky.kind = Sky::picture;
    const char* const start = c.at;
    return c.text(file) && read_sky(k, file, c.since(start), sky.light);
  }
  const std::string_view w = c.next_word();
  plain = w == "on";
  const auto* const at = std::find(sky_names.begin(), sky_names.end() - 1, w);
  if (at == sky_names.end() - 1 && !plain)
    return no_choice(c, w, "a sky must be on, off, studio, day, overcast, sunset or a \"FILE\"",
                     w == "night" ? Hint("a night has a dark background, and lamps: background #060a14")
                                  : did_you_mean(w, {"on", "off", "studio", "day", "overcast", "sunset"}));
  sky.kind = plain ? Sky::none : static_cast<Sky::Kind>(at - sky_names.begin());
  return true;
}

bool sky(Command& k) {
  Cursor& c = k.cursor;
  Sky sky;
  std::string file;
  bool plain = false;
  if (!which_sky(k, sky, file, plain)) return false;
  while (sky.kind != Sky::none && !c.at_line_end()) {
    std::string_view key;
    if (!option_key(c, key)) return false;
    if (!sky_option(k, key, sky)) return false;
  }
  if (!finish(c)) return false;
  Appearance& a = k.scene.appearance;
  a.sky = plain, a.environment = std::move(sky), a.sky_file = std::move(file);
  return true;
}

// What `view "FILE"` says.
struct FileView {
  ViewFile names;
  Grade::View of = Grade::neutral;  // whose picture a look file takes
  bool of_light = false;
  double strength = 1;
};

bool what_it_takes(Command& k, FileView& v) {
  Cursor& c = k.cursor;
  const std::string_view w = c.word();
  const auto* const at = std::find(view_names.begin(), view_names.end(), w);
  v.of_light = w == "light";
  if (!v.of_light && at == view_names.end())
    return no_choice(c, w, "a look file takes light, or the picture of neutral, plain, filmic or agx",
                     did_you_mean(w, {"light", "neutral", "plain", "filmic", "agx"}));
  v.of = v.of_light ? Grade::plain : static_cast<Grade::View>(at - view_names.begin());
  return true;
}

bool view_option(Command& k, std::string_view key, FileView& v) {
  Cursor& c = k.cursor;
  constexpr std::pair<std::string_view, std::string ViewFile::*> texts[] = {{"display", &ViewFile::display},
                                                                            {"through", &ViewFile::through},
                                                                            {"look", &ViewFile::look},
                                                                            {"space", &ViewFile::space}};
  const bool configuration = is_configuration(v.names.file);
  const auto* const text =
      std::find_if(std::begin(texts), std::end(texts), [&](const auto& t) { return t.first == key; });
  if (text != std::end(texts) && !configuration)
    return c.fail(ErrorCode::syntax, fmt::format("a look file has no '{}'", key), key,
                  "an OpenColorIO configuration has: view \"config.ocio\" display=\"sRGB\"");
  if (text != std::end(texts)) return c.text(v.names.*text->second);
  if ((key == "takes" || key == "strength") && configuration)
    return c.fail(ErrorCode::syntax, fmt::format("an OpenColorIO configuration has no '{}'", key), key,
                  "it has display, through, look and space");
  if (key == "takes") return what_it_takes(k, v);
  if (key == "strength") return bounded(k, "the strength of a look", 0, 1, v.strength);
  return c.fail(ErrorCode::name, fmt::format("a view has no '{}'", key.substr(0, 40)), key,
                did_you_mean(key, {"takes", "strength", "display", "through", "look", "space"}));
}

// Reads the table. Makes the file's name relative to the first script's folder.
bool read_colors(Command& k, FileView& v, std::string_view about, std::shared_ptr<const ColorTable>& table) {
  std::filesystem::path where;
  ViewFile& n = v.names;
  if (!may_use(k, n.file, about, where)) return false;
  const ColorQuery query{n.display, n.through, n.look, n.space, v.of_light};
  const MayRead may_read = [&](const std::string& p) { return k.script.may_read(p); };
  const auto read = KeptResults::get("colors", where.string() + "\n" + text_of_query(query),
                                     [&] { return load_colors(where.string(), query, may_read); });
  return kept(k, read, about, table);
}

bool view_of_file(Command& k) {
  Cursor& c = k.cursor;
  const char* const start = c.at;
  FileView v;
  if (!c.text(v.names.file)) return false;
  const std::string_view about = c.since(start);
  while (!c.at_line_end()) {
    std::string_view key;
    if (!option_key(c, key)) return false;
    if (!view_option(k, key, v)) return false;
  }
  std::shared_ptr<const ColorTable> table;
  if (!finish(c) || !read_colors(k, v, about, table)) return false;
  Appearance& a = k.scene.appearance;
  a.grade.view = is_configuration(v.names.file) ? Grade::plain : v.of;
  a.grade.table = std::move(table), a.grade.table_share = v.strength, a.view_file = std::move(v.names);
  return true;
}

bool view(Command& k) {
  Cursor& c = k.cursor;
  c.space();
  if (c.peek() == '"') return view_of_file(k);
  const std::string_view w = c.next_word();
  const auto* const at = std::find(view_names.begin(), view_names.end(), w);
  if (at == view_names.end())
    return no_choice(c, w, "a view must be neutral, plain, filmic, agx or a \"FILE\"",
                     did_you_mean(w, {view_names.begin(), view_names.end()}));
  if (!finish(c)) return false;
  Appearance& a = k.scene.appearance;
  a.grade.view = static_cast<Grade::View>(at - view_names.begin());
  a.grade.table = nullptr, a.grade.table_share = 1, a.view_file = {};
  return true;
}

bool share(Command& k, const char* what, double Grade::*to) {
  double is = 0;
  if (!bounded(k, what, 0, 1, is) || !finish(k.cursor)) return false;
  k.scene.appearance.grade.*to = is;
  return true;
}
bool bloom(Command& k) { return share(k, "bloom", &Grade::bloom); }
bool vignette(Command& k) { return share(k, "vignette", &Grade::vignette); }
bool grain(Command& k) { return share(k, "grain", &Grade::grain); }

bool white_balance(Command& k) {
  double kelvin = 6500;
  if (!bounded(k, "the white balance", 1000, 40000, kelvin)) return false;
  k.cursor.accept_word("K");
  if (!finish(k.cursor)) return false;
  k.scene.appearance.grade.white_balance = kelvin;
  return true;
}

constexpr Verb skies_rows[] = {
    {"sky", "sky on|off|studio|day|overcast|sunset|\"FILE\" [turn=ANGLE] [strength=N] [hour=N]",
     "Light from all around, which things mirror: a studio, a sky, or a picture of the whole sky (.hdr or .exr). It is "
     "visible unless the script sets a `background`. `on` is a simple blue sky.",
     "sky day hour=17 turn=90deg", Verb::once | Verb::aside, sky,
     "on off studio day overcast sunset \"FILE\"; turn= strength= hour="},
    {"view",
     "view neutral|plain|filmic|agx|\"FILE\" [takes=VIEW|light] [strength=N] [display=\"NAME\"] [through=\"NAME\"] "
     "[look=\"NAME\"] [space=\"NAME\"]",
     "How light becomes a picture: `neutral`, the default, keeps colors and rolls off what is too bright; `filmic` and "
     "`agx` compress more, as a camera does; `plain` cuts off at white. A look file (.cube and others) changes the "
     "picture of the view that it `takes`. An OpenColorIO configuration (.ocio) shows light on a `display` `through` "
     "one of its views, with a `look`.",
     "view agx", Verb::once | Verb::aside, view,
     "neutral plain filmic agx \"FILE\"; takes= strength= display= through= look= space="},
    {"white-balance", "white-balance KELVIN",
     "The color temperature of the light that becomes white: 6500, the default, changes nothing; less makes the "
     "picture "
     "bluer, more makes it warmer.",
     "white-balance 5000", Verb::once | Verb::aside, white_balance, "NUMBER…"},
    {"bloom", "bloom AMOUNT", "How much bright light spreads around its place, 0 to 1.", "bloom 0.3",
     Verb::once | Verb::aside, bloom, "NUMBER…"},
    {"vignette", "vignette AMOUNT", "How much darker the corners of the picture are, 0 to 1.", "vignette 0.3",
     Verb::once | Verb::aside, vignette, "NUMBER…"},
    {"grain", "grain AMOUNT", "How strong the grain of the picture is, 0 to 1. It is the same in every run.",
     "grain 0.1", Verb::once | Verb::aside, grain, "NUMBER…"},
};

}  // namespace

std::span<const Verb> skies_verbs() { return skies_rows; }

}  // namespace betwixt
