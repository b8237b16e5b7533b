// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/functions.h"

#include <algorithm>
#include <span>
#include <vector>

#include "scene/aiming_functions.h"
#include "scene/axes_functions.h"
#include "scene/camera_functions.h"
#include "scene/chart_functions.h"
#include "scene/collision_functions.h"
#include "scene/document.h"
#include "scene/finish_functions.h"
#include "scene/flat_functions.h"
#include "scene/gradient_functions.h"
#include "scene/kinds.h"
#include "scene/layer_functions.h"
#include "scene/materials.h"
#include "scene/own_font.h"
#include "scene/rig_functions.h"
#include "scene/sound_functions.h"
#include "scene/text_functions.h"
#include "scene/video_functions.h"

namespace betwixt {
namespace {

bool has_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const auto end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

constexpr KindBits shared = 0;  // of all kinds whose rows name it

// In the order of `fn`. Append new ones; they need a name there only if the program asks for them by name.
const FunctionSpec function_rows[] = {
    {.name = "position",
     .type = Type::vector,
     .rest = Vec3{},
     .unit = Unit::metres,
     .place = true,
     .sentence = "Where an object is, measured from its parent.",
     .written = "a vector",
     .example = "set ball.position (0 10 0)"},
    {.name = "rotation",
     .type = Type::rotation,
     .rest = Angles{},
     .place = true,
     .sentence = "Its rotation: angles about its x, y and z axes, or an orientation.",
     .written = "euler(x y z), axis(x y z, angle), quat(w x y z)",
     .example = "set ball.rotation euler(0deg 90deg 0deg)"},
    {.name = "scale",
     .type = Type::vector,
     .rest = Vec3{1, 1, 1},
     .place = true,
     .sentence = "Its scale along each axis.",
     .written = "a vector",
     .example = "set ball.scale (1 2 1)"},
    {.name = "pivot",
     .type = Type::vector,
     .rest = Vec3{},
     .unit = Unit::metres,
     .place = true,
     .sentence = "The point about which it turns and scales.",
     .written = "a vector",
     .example = "set ball.pivot (0 -1 0)"},
    {.name = "attach-position",
     .type = Type::vector,
     .rest = Vec3{},
     .unit = Unit::metres,
     .place = true,
     .sentence = "The point of its parent, in the parent's own space, from which its position counts.",
     .written = "a vector",
     .example = "set ball.attach-position (0 1 0)"},
    {.name = "color",
     .type = Type::color,
     .rest = Color{},
     .sentence = "Its color.",
     .written = "a name, #rrggbb, rgb(…), hsv(…)",
     .example = "set ball.color gold"},
    {.name = "shininess",
     .type = Type::scalar,
     .rest = 0.0,
     .low = 0,
     .high = 1,
     .sentence = "How sharp its highlights are, 0 to 1.",
     .written = "a number",
     .example = "set ball.shininess 0.8"},
    {.name = "transparency",
     .type = Type::scalar,
     .rest = 0.0,
     .low = 0,
     .high = 1,
     .sentence = "How transparent it is, 0 to 1.",
     .written = "a number",
     .example = "set ball.transparency 0.5"},
    {.name = "geometry",
     .type = Type::shape,
     .rest = ObjectId{},
     .place = true,
     .sentence = "The shape it shows: its own, or another object's.",
     .written = "shape(NAME) or none",
     .example = "set ball.geometry shape(wheel1)"},
    {.name = "display",
     .type = Type::boolean,
     .rest = true,
     .place = true,
     .sentence = "Whether it is visible.",
     .written = "on or off",
     .example = "set ball.display off"},
    {.name = "material",
     .type = Type::text,
     .rest = Text(std::string("plastic")),
     .words = material_words(),
     .sentence = "What it is made of. `glow`: its own color without light. What you set replaces parts of it.",
     .written = "plastic, gold, glass, oak …",
     .example = "set ball.material \"metal\""},
    {.name = "texture",
     .type = Type::text,
     .rest = Text(),
     .sentence = "The picture or video on its surface, from a file below the script's folder.",
     .written = "\"FILE\"",
     .example = "set ball.texture \"\""},
    measure(
        {.name = "radius",
         .rest = 1.0,
         .kinds = shared,
         .shape = put_measure<&Shape::radius>,
         .sentence =
             "The radius of a round shape; of a torus and an arc, to the middle of the ring; of a star, to its tips.",
         .example = "set ball.radius 2"}),
    measure({.name = "size",
             .type = Type::vector,
             .rest = Vec3{1, 1, 1},
             .kinds = bit(Kind::box),
             .shape = [](Shape& s, const Value& v, const Scene&) { s.size = std::get<Vec3>(v); },
             .sentence = "The lengths of a box along its x, y and z axes.",
             .written = "a vector",
             .example = "create crate box\nset crate.size (1 2 3)"}),
    measure({.name = "size",
             .type = Type::pair,
             .rest = Vec3{1, 1, 0},
             .kinds = bit(Kind::plane) | bit(Kind::rectangle),
             .shape =
                 [](Shape& s, const Value& v, const Scene&) {
                   const Vec3 p = std::get<Vec3>(v);
                   s.size = {p.x, p.y, 1};
                 },
             .sentence = "The width and the height of a plane or a rectangle.",
             .written = "(width height)",
             .example = "create floor plane\nset floor.size (20 20)"}),
    measure({.name = "size",
             .rest = 1.0,
             .kinds = letter_kinds,
             .shape =
                 [](Shape& s, const Value& v, const Scene&) {
                   s.size = {1, std::get<double>(v), 1};
                 },
             .sentence = "The size of the letters of a text: an em.",
             .example = "create title text\nset title.size 2"}),
    measure({.name = "size",
             .rest = 0.05,
             .kinds = bit(Kind::points),
             .shape = put_measure<&Shape::width>,
             .sentence = "The diameter of each point of a cloud.",
             .example = "create stars points points=((0 0 0) (1 2 3))\nset stars.size 0.1"}),
    measure({.name = "height",
             .rest = 1.0,
             .kinds = shared,
             .shape = put_measure<&Shape::height>,
             .sentence = "The height of a cylinder or a cone, along y, or of a video.",
             .example = "set wheel1.height 2"}),
    measure({.name = "tube",
             .rest = 0.3,
             .kinds = bit(Kind::torus),
             .shape = put_measure<&Shape::tube>,
             .sentence = "The radius of the tube of a torus.",
             .example = "create ring torus\nset ring.tube 0.1"}),
    {.name = "points",
     .type = Type::points,
     .rest = Points(),
     .kinds = shared,
     .unit = Unit::metres,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.points = std::get<Points>(v); },
     .sentence = "The points of an outline, a line or a cloud, in order.",
     .written = "((x y) …)",
     .example = "create line polyline\nset line.points ((0 0) (1 1))"},
    measure({.name = "width",
             .rest = 0.05,
             .kinds = line_kinds,
             .shape = put_measure<&Shape::width>,
             .sentence = "How thick a line is: its diameter.",
             .example = "create line polyline\nset line.width 0.2"}),
    {.name = "text",
     .type = Type::text,
     .rest = Text(),
     .kinds = letter_kinds,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.text = std::get<Text>(v); },
     .sentence = "The characters of a text.",
     .written = "\"…\"",
     .example = "create title text\nset title.text \"The end\""},
    {.name = "font",
     .type = Type::text,
     .rest = Text(std::string("DejaVu Sans")),
     .kinds = letter_kinds,
     .shape =
         [](Shape& s, const Value& v, const Scene& scene) {
           s.font = std::get<Text>(v), s.own_font = nullptr;
           if (!names_font_file(*s.font)) return;
           if (const auto found = scene.fonts->find(*s.font); found != scene.fonts->end()) s.own_font = found->second;
         },
     .sentence = "The font of letters: the name of an installed font, or a file (ttf or otf).",
     .written = "\"…\"",
     .example = "create title text\nset title.font \"DejaVu Sans\""},
    measure({.name = "depth",
             .rest = 0.0,
             .kinds = letter_kinds | flat_kinds,
             .shape = put_measure<&Shape::depth>,
             .sentence = "How thick letters and flat shapes are.",
             .example = "create title text\nset title.depth 0.2"}),
    {.name = "file",
     .type = Type::text,
     .rest = Text(),
     .kinds = bit(Kind::mesh),
     .shape = put_mesh,
     .sentence = "The file of a mesh.",
     .written = "\"FILE\""},
    measure({.name = "range",
             .rest = 20.0,
             .kinds = bit(Kind::light),
             .sentence = "How far a lamp shines.",
             .example = "set lamp.range 60"}),
    {.name = "intensity",
     .type = Type::scalar,
     .rest = 1.0,
     .kinds = bit(Kind::light),
     .low = 0,
     .high = 1e6,
     .sentence = "The brightness of a lamp, as a factor of its color in linear light.",
     .written = "a number",
     .example = "set lamp.intensity 2"},
    {.name = "shines",
     .type = Type::text,
     .rest = Text(std::string("point")),
     .kinds = bit(Kind::light),
     .words = "point|sun",
     .instead = {{"spot", "cone=40deg makes a lamp a spotlight"},
                 {"area", "shape=rectangle size=(2 1) makes a lamp an area"},
                 {"directional", "shines=sun"}},
     .sentence = "Whether a lamp shines from a point or like the sun.",
     .written = "\"point\" or \"sun\"",
     .example = "set lamp.shines \"sun\""},
    {.name = "lens",
     .type = Type::scalar,
     .rest = 35.0,
     .kinds = bit(Kind::camera),
     .unit = Unit::millimetres,
     .low = 0.1,
     .high = 1e6,
     .place = true,
     .sentence = "The focal length of a camera, for a sensor 36 mm wide.",
     .written = "35mm",
     .example = "set eye.lens 50mm"},
    {.name = "fov",
     .type = Type::angle,
     .rest = 0.0,
     .kinds = bit(Kind::camera),
     .low = 0,
     .high = 3.1,
     .place = true,
     .sentence = "The horizontal angle of view of a camera; 0: that of its `lens`.",
     .written = "an angle",
     .example = "set eye.fov 50deg"},
    measure({.name = "height",
             .rest = 0.0,
             .kinds = bit(Kind::camera),
             .place = true,
             .sentence = "The height of the view of a camera without perspective; 0: a camera with perspective.",
             .example = "set eye.height 10"}),
    {.name = "look-at",
     .type = Type::aim,
     .rest = ObjectId{},
     .unit = Unit::metres,
     .place = true,
     .sentence = "The point or object that a camera, or any other thing, faces with its front.",
     .written = "a point or a name",
     .example = "set eye.look-at ball"},
    {.name = "attachment",
     .type = Type::attachment,
     .rest = Attachment{},
     .place = true,
     .sentence = "Its parent, and how it follows the parent: see `hang`, `attach` and `couple`. A value in code is the "
                 "parent's name."},
    {.name = "weight",
     .type = Type::scalar,
     .rest = 1.0,
     .kinds = bit(Kind::layer),
     .low = 0,
     .high = 1,
     .sentence = "How much of a layer is applied: 0 nothing, 1 all of it.",
     .written = "a number",
     .example = "layer sway add\nset sway.weight 0.5"},
    {.name = "mode",
     .type = Type::text,
     .rest = Text(std::string("add")),
     .kinds = bit(Kind::layer),
     .words = "add|mix",
     .by_script = true,
     .sentence = "Whether a layer's values are added (`add`), or blend over the values below it (`mix`).",
     .written = "\"add\" or \"mix\""},
    {.name = "environments",
     .type = Type::names,
     .rest = Names(),
     .place = true,
     .sentence = "The environments it is in, the outermost first.",
     .written = "(E1 E2)",
     .example = "animate wind every 1t by translate(0.1 0 0)\nset ball.environments (wind)"},
    {.name = "drive",
     .type = Type::names,
     .rest = Names(),
     .place = true,
     .sentence =
         "Like `environments`, but they act in its own space, before its rotation and position: a wheel that rolls.",
     .written = "(E1 E2)",
     .example = "animate spin every 1t by rotate(6deg, z)\nset ball.drive (spin)"},
    {.name = "transform",
     .type = Type::transform,
     .rest = Matrix(),
     .place = true,
     .sentence = "A fixed transform in its own space, before its rotation and position.",
     .written = "translate(…) rotate(…) scale(…) or matrix(…)",
     .example = "set ball.transform scale(1 2 1) rotate(30deg, z)"},
    {.name = "motion",
     .type = Type::motion,
     .rest = Moves(),
     .place = true,
     .sentence =
         "A string of translations, rotations and scalings over a segment of time; the leftmost is applied last.",
     .written = "1f..48f T(6.28 0) R(-1turn @ 0 1)",
     .example = "at 1f..48f ball.motion T(6.28 0) R(-1turn @ 0 1)"},
};

std::vector<FunctionSpec> make_functions() {
  std::vector<FunctionSpec> made(std::begin(function_rows), std::end(function_rows));
  const auto add = [&](const auto& rows) { made.insert(made.end(), std::begin(rows), std::end(rows)); };
  add(aiming_functions), add(sound_functions), add(camera_functions), add(rig_functions), add(collision_functions);
  constexpr std::size_t named = 3;  // of the rows of axes, those that `fn` has
  const std::span axes(axes_functions);
  add(axes.first(named)), add(finish_functions), add(layer_functions), add(gradient_functions);
  add_video_functions(made);
  add(axes.subspan(named)), add(chart_functions), add(flat_functions), add(text_functions);
  for (FunctionSpec& f : made) {
    const bool everywhere = f.kinds == all_kinds, by_kinds = f.kinds == shared;
    const auto id = static_cast<FunctionId>(&f - made.data());
    const bool drawn = is_of_finish(id) || is_of_gradient(id);
    for (const KindRow& row : kinds()) {
      if (everywhere && (!row.placed || (drawn && row.fill == Fill::nothing))) f.kinds &= ~bit(row.kind);
      if (by_kinds && has_word(row.functions, f.name)) f.kinds |= bit(row.kind);
    }
  }
  return made;
}

const std::vector<FunctionSpec>& table() {
  static const std::vector<FunctionSpec> t = make_functions();
  return t;
}

}  // namespace

std::vector<std::string_view> choices(const FunctionSpec& spec) {
  std::vector<std::string_view> words;
  for (std::string_view rest = spec.words; !rest.empty();) {
    const auto bar = rest.find('|');
    words.push_back(rest.substr(0, bar));
    rest = bar == std::string_view::npos ? std::string_view() : rest.substr(bar + 1);
  }
  return words;
}

std::span<const FunctionSpec> built_in_functions() { return table(); }

std::optional<FunctionId> find_built_in(Kind kind, std::string_view name) {
  const auto& t = table();
  for (std::size_t i = 0; i < t.size(); ++i)
    if (t[i].name == name && (t[i].kinds & bit(kind))) return static_cast<FunctionId>(i);
  return std::nullopt;
}

}  // namespace betwixt
