// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The marks of geometry: angles and dimensions. They follow the things between which they are.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/names.h"
#include "commands/command.h"
#include "commands/furnishing.h"
#include "commands/furniture_rows.h"
#include "commands/translating.h"
#include "exchange/fonts.h"
#include "exchange/formulas.h"
#include "language/values.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr double mark_em = 0.3, dimension_tip = 0.18;
constexpr int most_decimals = 6;

// A place that an author says: an object, which stands for its origin, or a point.
struct MarkPlace {
  std::string code;  // as the functions of code take it
  std::string name;  // "": a point
  std::string_view word;
};

// What an author says of a mark behind its places.
struct SaidMark {
  std::string text, tex, name, color;
  std::string_view label_at;  // the last word that tells its label
  double radius = 0.5, offset = 0.4;
  int labels = 0;     // how many words tell its label
  int decimals = -1;  // -1: none are said
  bool turning = false;
};

bool mark_place(Command& k, MarkPlace& out) {
  Cursor& c = k.cursor;
  c.space();
  const char* const start = c.at;
  if (c.peek() == '(') {
    Vec3 at;
    if (!values(k).point(at)) return false;
    out = {fmt::format("vec({}, {}, {})", write_number(at.x), write_number(at.y), write_number(at.z)), "",
           c.since(start)};
    return true;
  }
  ObjectId id;
  out.word = c.peek_word();
  if (!values(k).object(id)) return false;
  const Object& o = k.scene.objects[id.index];
  if (!placed(o.kind)) return c.fail(ErrorCode::type, fmt::format("'{}' has no place", o.name), out.word);
  out.name = o.name, out.code = "'" + o.name + "'";
  return true;
}

bool decimals_of_mark(Cursor& c, int& out) {
  c.space();
  const char* const start = c.at;
  double n = 0;
  if (!c.number(n)) return false;
  if (n < 0 || n > most_decimals || n != std::floor(n))
    return c.fail(ErrorCode::range, fmt::format("decimals are a whole number from 0 to {}", most_decimals),
                  c.since(start));
  return out = static_cast<int>(n), true;
}

// Reads the value of one of the words that both marks have.
bool common_word(Command& k, std::string_view word, SaidMark& out) {
  Cursor& c = k.cursor;
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", word));
  if (word == "color") {
    Color color;
    if (!values(k).color(color)) return false;
    return out.color = write_color(color), true;
  }
  ++out.labels, out.label_at = word;
  if (word == "decimals") return decimals_of_mark(c, out.decimals);
  if (word == "tex") return c.text(out.tex);
  const char* const written = c.at;
  if (!c.text(out.text)) return false;
  return translate_text(k.script, out.text, c.since(written)), true;
}

// Reads the words behind the places, to the end of the line. `measure`: the word of a length of this mark.
bool said_mark(Command& k, std::string_view measure, double& length, SaidMark& out) {
  Cursor& c = k.cursor;
  while (!c.at_line_end()) {
    const std::string_view word = c.next_word();
    if (word == "as") {
      out.name = c.next_word();
      if (out.name.empty())
        return c.fail_here(ErrorCode::syntax, "a name is missing here", "as in angle a b c as theta");
    } else if (word == "anticlockwise" && measure == "radius") {
      out.turning = true;
    } else if (word == measure) {
      if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", word));
      c.space();
      const char* const start = c.at;
      if (!values(k).scalar(length, Unit::metres)) return false;
      if (measure == "radius" && !(length > 0))
        return c.fail(ErrorCode::range, "a radius must be greater than 0", c.since(start));
    } else if (word == "text" || word == "tex" || word == "decimals" || word == "color") {
      if (!common_word(k, word, out)) return false;
    } else {
      return no_choice(c, word,
                       fmt::format("expected {}=…, text=\"…\", tex=\"…\", decimals=N, color=…{} or as NAME", measure,
                                   measure == "radius" ? ", anticlockwise" : ""),
                       did_you_mean(word, {"text", "tex", "decimals", "color", "anticlockwise", "radius", "offset"}));
    }
  }
  if (out.labels > 1)
    return c.fail(ErrorCode::syntax, "a mark has one label", out.label_at, "say text, tex or decimals");
  return finish(c);
}

// What the letters of a label cover, from its position.
struct LabelBox {
  Vec3 middle, half;
};
std::optional<LabelBox> label_box(const SaidMark& m) {
  std::vector<Contour> contours;
  if (!m.tex.empty()) {
    const auto set = set_formula_text(m.tex);
    if (!set) return std::nullopt;  // `create` tells why
    contours = (*set)->contours;
  } else {
    contours = text_outline(m.text, "DejaVu Sans").contours;
  }
  Vec3 low{1e9, 1e9, 0}, high{-1e9, -1e9, 0};
  for (const Contour& contour : contours)
    for (const Vec3 p : contour)
      low = {std::min(low.x, p.x), std::min(low.y, p.y), 0}, high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
  if (low.x > high.x) return std::nullopt;
  const Vec3 half = 0.5 * mark_em * (high - low);
  Vec3 middle = 0.5 * mark_em * (low + high);
  if (!m.tex.empty()) middle.x = 0;  // a text is centred when it is drawn, and these contours begin at 0
  return LabelBox{middle, half};
}

// Returns the lines of a label. `number`: the code of a number that it shows; "": it shows what the author says.
// `place`: the code of its middle, to which half its size is added.
std::string lines_of_label(const std::string& name, const SaidMark& m, const std::string& number,
                           const std::string& place, const std::string& color) {
  std::string out = fmt::format("create {}/label text {} size={} color={}\n", name,
                                m.tex.empty() ? "text=" + write_text(m.text) : "tex=" + write_text(m.tex),
                                write_number(mark_em), color);
  std::string half = fmt::format("{} * #{}, {}", write_metres(0.3 * mark_em), number, write_metres(0.36 * mark_em));
  Vec3 middle{0, 0.36 * mark_em, 0};
  if (!number.empty())
    out += fmt::format("set {}/label.text = \"{}\"\n", name, number);
  else if (const auto box = label_box(m))
    half = write_metres(box->half.x) + ", " + write_metres(box->half.y), middle = box->middle;
  else
    half = "0, 0";
  out += fmt::format("set {}/label.position = \"{}, {}) - vec({}, {})\"\n", name, place, half, write_metres(middle.x),
                     write_metres(middle.y));
  return out;
}

bool new_mark(Command& k, const std::string& name, std::string_view about) {
  if (k.scene.names.find(name))
    return k.cursor.fail(ErrorCode::name, fmt::format("'{}' already exists", name), about,
                         "end the line with as NAME, for another name");
  return free_name(k, name, about);
}

std::string drawn_then(const Command& k, const std::string& name) {
  return k.time ? fmt::format("at {} draw {} for 500ms\n", write_time(*k.time, k.scene.rate), name) : "";
}

bool angle(Command& k) {
  Cursor& c = k.cursor;
  std::array<MarkPlace, 3> at;
  for (MarkPlace& place : at)
    if (!mark_place(k, place)) return false;
  for (const std::size_t i : {0, 2})
    if (at[i].code == at[1].code)
      return c.fail(ErrorCode::name, "an angle is at its second place, between two others", at[i].word);
  SaidMark m;
  if (!said_mark(k, "radius", m.radius, m)) return false;
  const std::string name = !m.name.empty() ? m.name : at[1].name.empty() ? "angle" : at[1].name + "-angle";
  if (!new_mark(k, name, at[1].word)) return false;
  const std::string places = fmt::format("{}, {}, {}", at[0].code, at[1].code, at[2].code),
                    way = m.turning ? "true" : "false", radius = write_number(m.radius);
  std::string lines =
      fmt::format("create {0} polyline width=0.04 color={1}\n", name, m.color.empty() ? palette(k.scene, 1) : m.color);
  lines += fmt::format("set {0}.points = \"mark.angle({1}, {2}, {3})\"\n", name, places, way, radius);
  if (m.labels)
    lines +=
        lines_of_label(name, m, m.decimals < 0 ? "" : fmt::format("mark.degrees({}, {}, {})", places, way, m.decimals),
                       fmt::format("mark.angle_label('{}', {}, {}, {}", name, places, way, radius),
                       m.color.empty() ? theme_color(k.scene, &Theme::label) : m.color);
  return all_or_none(k, lines + drawn_then(k, name), at[1].word);
}

std::string lines_of_dimension(const std::string& name, const std::string& places, const SaidMark& m,
                               const std::string& color, const std::string& label) {
  const std::string offset = write_number(m.offset), tip = write_number(dimension_tip);
  std::string out = fmt::format("create {0} polyline width=0.03 color={1}\n", name, color);
  out += fmt::format("set {0}.points = \"mark.dimension({1}, {2}, {3})\"\n", name, places, offset, tip);
  out += fmt::format("create {0}/ends polyline width=0.015 color={1}\n", name, color);
  out += fmt::format("set {0}/ends.points = \"mark.dimension_ends({1}, {2})\"\n", name, places, offset);
  for (const auto& [end, first] : {std::pair{"tip", "false"}, {"tail", "true"}}) {
    out += fmt::format("create {0}/{1} polygon points=(({2} 0) (0 {3}) (0 -{3})) color={4}\n", name, end, tip,
                       write_number(dimension_tip / 3), color);
    out += fmt::format(
        "set {0}/{1}.position = \"link.tip('{0}', {2})\"\nset {0}/{1}.rotation.z = \"link.turn('{0}', {2})\"\n", name,
        end, first);
  }
  const bool live = m.text.empty() && m.tex.empty();
  const std::string number = fmt::format("mark.distance({}, {})", places, m.decimals < 0 ? 1 : m.decimals);
  return out + lines_of_label(name, m, live ? number : "",
                              fmt::format("mark.dimension_label('{}', {}, {}", name, places, offset), label);
}

bool dimension(Command& k) {
  Cursor& c = k.cursor;
  MarkPlace a, b;
  if (!mark_place(k, a)) return false;
  if (!c.accept_word("to"))
    return c.fail_here(ErrorCode::syntax, "'to' is missing here", "as in dimension a to b offset=0.4");
  if (!mark_place(k, b)) return false;
  if (a.code == b.code) return c.fail(ErrorCode::name, "a dimension needs two different places", b.word);
  SaidMark m;
  if (!said_mark(k, "offset", m.offset, m)) return false;
  std::string name = m.name;
  if (name.empty()) {
    const std::string last = b.name.substr(b.name.rfind('/') + 1);
    for (const std::string& part : {a.name, last})
      if (!part.empty()) name += part + "-";
    name += "dimension";
  }
  if (!new_mark(k, name, a.word)) return false;
  const bool own = !m.color.empty();
  const std::string lines =
      lines_of_dimension(name, a.code + ", " + b.code, m, own ? m.color : theme_color(k.scene, &Theme::muted),
                         own ? m.color : theme_color(k.scene, &Theme::label));
  return all_or_none(k, lines + drawn_then(k, name), a.word);
}

constexpr Verb dimensioning_rows[] = {
    {"angle",
     "[at TIME] angle A B C [radius=R] [text=\"…\" | tex=\"…\" | decimals=N] [anticlockwise] [color=C] [as NAME]",
     "Marks the angle at B between A and C, which are objects or points; it follows them.",
     "create a circle position=(4 0)\ncreate b circle\ncreate c circle position=(3 3)\nangle a b c radius=2 "
     "tex=\"\\\\theta\"",
     Verb::timed, angle, "OBJECT;OBJECT;OBJECT;radius text tex decimals anticlockwise color as…"},
    {"dimension", "[at TIME] dimension A to B [offset=D] [decimals=N | text=\"…\" | tex=\"…\"] [color=C] [as NAME]",
     "Draws a line beside A and B, with the distance of these objects or points; it follows them.",
     "create a circle position=(-3 0)\ncreate b circle position=(3 1)\ndimension a to b offset=1.5", Verb::timed,
     dimension, "OBJECT; to; OBJECT; offset decimals text tex color as…"},
};

}  // namespace

std::span<const Verb> dimensioning_verbs() { return dimensioning_rows; }

}  // namespace betwixt
