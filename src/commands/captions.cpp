// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// captions: shows what is spoken, at the lower edge of the picture. Writes one text with an event for each caption.
#include "language/captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/names.h"
#include "commands/command.h"
#include "commands/furnishing.h"
#include "commands/furniture_rows.h"
#include "commands/translating.h"
#include "language/values.h"
#include "program/compiled.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr std::string_view passed_on[] = {"color", "font", "weight", "slant", "stroke", "stroke-width", "transparency"};

struct CaptionsCall {
  CaptionStyle style;
  double size = 0;       // of the letters, in metres; 0: what suits the picture
  std::string position;  // "": at the lower edge
  std::string look;      // other values for the text, as they are written
  bool colored = false;
};

// The camera that the film begins with, or none if it uses the usual view.
ObjectId first_camera(const Scene& s) {
  if (!s.cuts->empty()) return s.cuts->begin()->second;
  for (std::uint32_t i = 0; i < s.objects.size(); ++i)
    if (const Object* o = find_object(s, ObjectId{i}); o && o->kind == Kind::camera && !o->derived && !o->hidden)
      return ObjectId{i};
  return {};
}

// Where a text is, before a camera or in the world.
struct CaptionPlace {
  double size = 0;
  Vec3 position;
};

// The letters are 1/20 of the picture's height. Before a camera they are near it, so that nothing stands before them;
// without one they are a metre before the middle of the world, and so in front of flat drawings.
CaptionPlace place_of_captions(const Scene& s, bool before_camera, double size) {
  const Camera eye = Program::compile(Document(std::make_shared<const Scene>(s))).frame(Time{}).camera;
  const Vec3 from = transform_point(eye.world, {});
  const double far = before_camera ? 1 : from.z - 1;
  const double height = eye.orthographic ? eye.height : 2 * far * std::tan(eye.fov / 2) / eye.aspect;
  const double letters = size > 0 ? size : height / 20, low = -height / 2 + 2.4 * letters;
  return {letters, before_camera ? Vec3{0, low, -far} : from + Vec3{0, low, -far}};
}

bool captions_option(Command& k, std::string_view key, CaptionsCall& call) {
  Cursor& c = k.cursor;
  const char* const at = c.at;
  if (key == "words") {
    long most = 0;
    if (!c.whole_number(1, 100, "the number of words", most)) return false;
    return call.style.words = static_cast<std::size_t>(most), true;
  }
  if (key == "size") {
    if (!values(k).scalar(call.size, Unit::metres)) return false;
    return (call.size > 0 && call.size <= 1000) || c.fail(ErrorCode::range, "size must be above 0", c.since(at));
  }
  const bool known = std::find(std::begin(passed_on), std::end(passed_on), key) != std::end(passed_on);
  if (key != "position" && !known) {
    std::vector<std::string_view> words{"words", "size", "position"};
    words.insert(words.end(), std::begin(passed_on), std::end(passed_on));
    return c.fail(ErrorCode::name, fmt::format("captions have no '{}'", key.substr(0, 40)), key,
                  did_you_mean(key, words));
  }
  std::string_view rest = between(c.at, c.end);
  const std::string_view value = c.at < c.end && blank(*c.at) ? std::string_view() : take_piece(rest);
  if (value.empty()) return c.fail_here(ErrorCode::syntax, fmt::format("the value of {} is missing here", key));
  c.at = value.data() + value.size();
  if (key == "position") return call.position = value, true;
  call.colored |= key == "color";
  call.look += fmt::format(" {}={}", key, value);
  return true;
}

// Between two captions there is no text, and before the first one neither.
std::string rows_of_captions(const std::vector<Caption>& captions) {
  std::string rows;
  const auto row = [&](double t, std::string_view text) {
    rows += fmt::format("  {} {}\n", write_seconds(from_seconds(t)), write_text(text));
  };
  double end = std::min(0.0, captions.front().start - 1);
  row(end, "");
  for (const Caption& c : captions) {
    if (c.start > end && end > 0) row(end, "");
    row(c.start, c.text), end = c.end;
  }
  row(end, "");
  return rows;
}

bool captions(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (!c.accept_word("on")) return c.fail_here(ErrorCode::syntax, "'on' and the name of a sound are missing here");
  c.space();
  const std::string_view word = c.peek_word();
  ObjectId id;
  if (!values(k).object(id)) return false;
  if (s.objects[id.index].kind != Kind::sound)
    return c.fail(ErrorCode::type, fmt::format("'{}' is no sound, so it has no words", word), word);
  CaptionsCall call;
  while (!c.at_line_end()) {
    const std::string_view key = c.word();
    if (key.empty() || c.peek() != '=') return finish(c) && false;
    ++c.at;
    if (!captions_option(k, key, call)) return false;
  }
  std::vector<Caption> all = captions_of(words_heard(s, id), call.style);
  if (all.empty())
    return c.fail(ErrorCode::type, fmt::format("'{}' has no words that are heard", word), word,
                  "create it with words=\"FILE\"; betwixt words makes the file");
  for (Caption& one : all) translate_text(script, one.text, word);
  const std::string name = captions_name(s.objects[id.index].name);
  const ObjectId camera = first_camera(s);
  if (!camera && !s.appearance.flat && call.position.empty())  // the usual camera sees everything, the captions too
    return c.fail(ErrorCode::type, "captions need a camera above them, or a flat film", word,
                  "create eye camera position=(0 4 15) look-at=(0 1 0), or film flat");
  const CaptionPlace place = place_of_captions(s, static_cast<bool>(camera), call.size);
  const auto metres = [](double v) { return write_metres(v); };
  std::string lines =
      fmt::format("create {} text text=\"\" align=centre material=glow size={}{}", name, metres(place.size), call.look);
  if (!call.colored) lines += " color=" + theme_color(s, &Theme::ink);
  lines += " position=" + (call.position.empty() ? fmt::format("({} {} {})", metres(place.position.x),
                                                               metres(place.position.y), metres(place.position.z))
                                                 : call.position);
  lines += "\n";
  if (camera) lines += fmt::format("couple {} to {}\n", name, s.objects[camera.index].name);
  return all_or_none(k, lines + name + ".text\n" + rows_of_captions(all), word);
}

constexpr Verb captions_rows[] = {
    {"captions", "captions on SOUND [words=N] [size=L] [color=COLOR] [position=(x y z)] [font= weight= slant= stroke=]",
     "Shows what is spoken in a sound, in captions of at most two lines at the lower edge of the picture: one text, "
     "SOUND-captions, with an event for each. words= is how many words a caption has at most (12).",
     "", 0, captions,
     "on;OBJECT;words= size= color= position= font= weight= slant= stroke= stroke-width= transparency=…"},
};

}  // namespace

std::span<const Verb> captions_verbs() { return captions_rows; }

}  // namespace betwixt
