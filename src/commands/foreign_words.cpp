// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/foreign_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "base/names.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr std::string_view to_reckon =
    "let gives a number a name, formulas use it: let beat = 12f, then at 1f+2*beat ball.radius 3/4";
constexpr std::string_view to_repeat =
    "extend ball.position cycle repeats a track, copy ball.position 1f..24f to 24f times 3 a part of it";
constexpr std::string_view to_ease =
    "write a twerper after a value: at 12f ball.radius 2 ease-in-out, or sine-in, back-out, bounce-out; "
    "ease-in=4f and ease-out=4f are the times to arrive and to leave";
constexpr std::string_view to_fade = "transparency goes the other way, from 0, solid, to 1: set ball.transparency 0.5";
constexpr std::string_view to_blend =
    "a twerper is how values go from an event to the next: at 12f ball.radius 2 linear";
constexpr std::string_view to_event =
    "an event is a keyframe, a value at a time: at 12f ball.radius 2, or a row of a sheet";
constexpr std::string_view to_sheet =
    "a line that is only a target, as in ball.position, opens a sheet; rows go below it: TIME VALUE [TWERPER]";
constexpr std::string_view to_track =
    "a track is the events of a target, as a channel or an F-curve is elsewhere; a line with only the target opens its "
    "sheet";
constexpr std::string_view to_function =
    "a display function is an animatable property: ball.position, ball.color; define adds one of your own";
constexpr std::string_view to_time =
    "times are 24f (frame 24; frame 1 is the beginning), 2.5s, 500ms, 90t (ticks) or 00:01:02.5; 1f..24f is a segment";
constexpr std::string_view to_color = "colours are gold, #ffcc00, #fc0, rgb(1 0.8 0) or hsv(48deg 1 1)";
constexpr std::string_view to_target =
    "a target is an object and a function, as in ball.position, or a component of it, ball.position.x";
constexpr std::string_view to_hold =
    "couple, attach and hang give an object a parent, letgo and detach end that: at 20f attach ball to hand";
constexpr std::string_view to_make = "create makes an object, create b like a makes a copy of one";
constexpr std::string_view to_compute = "a value can be computed, in Lua: set ball.radius = \"1 + 0.1 * math.sin(t)\"";
constexpr std::string_view to_show = "hide ball and show ball, from a time on with at 24f hide ball";
constexpr std::string_view to_film = "a film is made outside the shell: betwixt render film.bx -o film.mp4";
constexpr std::string_view to_turn = "rotation turns: set ball.rotation euler(0 90deg 0), or axis(y 90deg)";
constexpr std::string_view to_angle = "angles have a unit: 90deg, 1.57rad or 0.25turn";
constexpr std::string_view to_many = "a pattern names many: wheel*.position, wheel{1..4}; alias gives them one name";
constexpr std::string_view to_place =
    "position is where a thing is, measured from its parent; eval ball.world is its matrix in the world";

constexpr std::string_view to_blur =
    "a camera's shutter blurs what moves: set eye.shutter 180deg; its f-stop what is out of focus: set eye.f-stop 0.2, "
    "set eye.focus ball";
constexpr std::string_view to_clear =
    "background transparent makes the background transparent; .png .webm .mov keep that";
constexpr std::string_view to_picture =
    "a picture is on a rectangle: create photo rectangle size=(4 3) texture=\"photo.png\"";
constexpr std::string_view to_film_in =
    "a video is on a rectangle of its own, or a texture: create clip video file=\"talk.mp4\" at=48f";
constexpr std::string_view to_drawing = "a drawing is a scene: create logo scene file=\"logo.svg\"";
constexpr std::string_view to_swarm =
    "a pattern makes many: create p{1..200} sphere radius=0.05 position=(hash(i) hash(i,2) hash(i,3)); fall and noise "
    "move them";
constexpr std::string_view to_graph =
    "a graph is a curve through points: create g curve points=((0 0) (1 2) (2 1)); code can give them";
constexpr std::string_view to_change =
    "a change from one to the other is events on both: at 24f a.transparency 0 linear, at 36f a.transparency 1; at 36f "
    "look through eye2 for 12f dissolves into another camera's picture";
constexpr std::string_view to_shine =
    "set lamp.emission orange makes it shine, bloom 0.3 gives it a halo; material=glow shows a color without light";
constexpr std::string_view to_sky =
    "sky \"studio.hdr\" lights the scene with a picture of the whole sky; sky studio and sky day need no file";
constexpr std::string_view to_grade = "view agx or view filmic compresses bright light; exposure 1 doubles all light";
constexpr std::string_view to_look =
    "view \"teal.cube\" takes a look file, view \"studio.ocio\" through=\"Filmic\" an OpenColorIO configuration";
constexpr std::string_view to_material =
    "material=oak, material=gold … name finishes; metalness, roughness, clearcoat and others change them";
constexpr std::string_view to_trace =
    "--style traced follows rays of light, as in betwixt frame film.bx --style traced --samples 256 --denoise on";
constexpr std::string_view to_grade_color =
    "gradient=linear, radial, circular or conic colors an object: set card.gradient-stops \"#f60, gold 40%, navy\"";
constexpr std::string_view to_wait =
    "times are absolute, so there is no wait: at 48f sets a time, range 1f 96f the length of the film";
constexpr std::string_view to_reach =
    "reach turns joints so that an object arrives: reach arm/fore/palm to ball from 12f until 36f";
constexpr std::string_view to_instance =
    "define kind makes objects that follow a model: define kind human like man; a pattern makes many of one: create "
    "p{1..1000} sphere; call draws a display list again";
constexpr std::string_view to_beyond =
    "extend sets the extrapolation, the values outside the events: extend ball.position linear";
constexpr std::string_view to_trail = "a trace is the path that an object has drawn: create t trace of=ball";
constexpr std::string_view to_join = "the joints of a mesh are objects below each other, which move its vertices";
constexpr std::string_view to_filter = "a filter changes a track and leaves its events: filter ball.position noise";
constexpr std::string_view to_caption =
    "create caption text text=\"…\" shows a text; captions on voice shows what is spoken in a sound that has words";
constexpr std::string_view to_say =
    "betwixt words --say talk.txt -o talk.wav makes a scratch voice with the times of its words; "
    "create voice sound file=\"talk.wav\" words=\"talk.words\" plays it";
constexpr std::string_view to_align =
    "betwixt words talk.wav --text talk.txt finds when each word is spoken; voice:\"the square\" is then a time";
constexpr std::string_view to_note = "a note is a text at a time: at 24f note \"first bounce ends\"";
constexpr std::string_view to_occlude = "contact on darkens corners and places where objects meet";
constexpr std::string_view to_hear = "sound plays a file: create music sound file=\"music.mp3\" at=24f gain=0.8";

constexpr std::string_view to_script =
    "a film is a script of its own, a line for each step; Python makes films with the module betwixt";
constexpr std::string_view to_formula =
    "tex= makes a text a formula: create f text tex=\"x^2\"; at 24f f.tex \"x^3\" match turns it into another";
constexpr std::string_view to_morph =
    "morph turns a thing into another: at 24f morph a into b; formulas and code do so by match";
constexpr std::string_view to_point_out =
    "highlight, circle-around and spotlight point at a thing: at 24f circle-around ball for 1s";
constexpr std::string_view to_range = "axes have their ranges and steps in brackets: create ax axes x=(-4 4 1) y=(0 2)";
constexpr std::string_view to_last =
    "for says how long a row takes: at 24f ball.radius 2 for 1s; range 1f 72f how long the film is";
constexpr std::string_view to_count =
    "code writes numbers into a text: set t.text = \"string.format('%.2f', value('ball.position.x'))\"; define adds a "
    "number of your own";
constexpr std::string_view to_points_of_axes =
    "on=ax places a thing by the numbers of axes: create p circle radius=0.06 on=ax position=(2 1)";

constexpr std::string_view to_place_of_css =
    "position is where a thing is, in metres from the middle of the picture, up is plus: at 1f box.position.x 2 for 1s";

constexpr ForeignWord all_foreign_words[] = {
    {"rect", "a rectangle: create card rectangle size=(3 2) corner=0.2", "rectangle"},
    {"div", "a rectangle: create card rectangle size=(3 2) corner=0.2", "rectangle"},
    {"translate-x", to_place_of_css, "position"},
    {"translate-y", to_place_of_css, "position"},
    {"left", to_place_of_css, "position"},
    {"border-radius", "corner rounds a rectangle: set card.corner 0.2", "corner"},
    {"background-color", "color is the colour of a thing, background that of the film: set card.color red",
     "color background"},
    {"z-index", "in a flat film, what is created later, or has a larger position.z, is in front", "position"},
    {"import", to_script, "create use"},
    {"class", to_script, "define create"},
    {"def", to_script, "procedure"},
    {"self", to_script, "at create"},
    {"mathtex", to_formula, "text tex"},
    {"latex", to_formula, "text tex"},
    {"replacement-transform", to_morph, "morph match"},
    {"indicate", to_point_out, "highlight circle-around spotlight"},
    {"circumscribe", to_point_out, "circle-around"},
    {"x-range", to_range, "axes"},
    {"y-range", to_range, "axes"},
    {"number-plane", "plane-grid is a grid of lines: create g plane-grid", "plane-grid axes"},
    {"run-time", to_last, "at"},
    {"decimal-number", to_count, "text define"},
    {"value-tracker", to_count, "define text"},
    {"c2p", to_points_of_axes, "axes"},
    {"gsap", to_event, "at"},
    {"along", "a motion along a path needs a segment: at 1f..48f ball.position along road", "motion"},
    {"image", to_picture, "rectangle texture"},
    {"photo", to_picture, "rectangle texture"},
    {"movie", to_film_in, "video texture"},
    {"footage", to_film_in, "video texture"},
    {"svg", to_drawing, "create"},
    {"drawing", to_drawing, "create"},
    {"particle", to_swarm, "create fall noise"},
    {"particles", to_swarm, "create fall noise"},
    {"caption", to_caption, "captions words"},
    {"subtitle", to_caption, "captions words"},
    {"subtitles", to_caption, "captions words"},
    {"say", to_say, "words sound"},
    {"speak", to_say, "words sound"},
    {"voiceover", to_say, "words sound"},
    {"transcribe", to_align, "words"},
    {"align-words", to_align, "words"},
    {"graph", to_graph, "curve polyline"},
    {"chart", to_graph, "curve polyline"},
    {"transition", to_change, "transparency look"},
    {"crossfade", to_change, "transparency look"},
    {"emissive", to_shine, "emission bloom"},
    {"hdri", to_sky, "sky"},
    {"environment-map", to_sky, "sky"},
    {"tone-mapping", to_grade, "view exposure"},
    {"tonemap", to_grade, "view exposure"},
    {"lut", to_look, "view"},
    {"ocio", to_look, "view"},
    {"color-management", to_look, "view"},
    {"pbr", to_material, "metalness roughness material"},
    {"shader", to_material, "metalness roughness material"},
    {"traced", to_trace, "samples"},
    {"ray-tracing", to_trace, "samples"},
    {"path-tracing", to_trace, "samples"},
    {"denoise", to_trace, "samples"},
    {"capsule", "a cylinder between two spheres of its radius is one; a box has round edges by corner=0.1",
     "cylinder box"},
    {"lathe", "a surface of revolution is a mesh of another program: create vase mesh file=\"vase.glb\"", "mesh"},
    {"bevel", "corner makes the edges of a box round: create b box corner=0.05", "corner box"},
    {"ambient-occlusion", to_occlude, "contact"},
    {"linear-gradient", to_grade_color, "gradient gradient-stops"},
    {"radial-gradient", to_grade_color, "gradient gradient-stops"},
    {"conic-gradient", to_grade_color, "gradient gradient-stops"},
    {"wait", to_wait, "at range"},
    {"sleep", to_wait, "at range"},
    {"motion-blur", to_blur, "shutter subframes"},
    {"dof", to_blur, "f-stop focus"},
    {"depth-of-field", to_blur, "f-stop focus"},
    {"bokeh", to_blur, "f-stop focus"},
    {"aperture", to_blur, "f-stop focus"},
    {"focus-distance", to_blur, "focus f-stop"},
    {"transparent", to_clear, "background transparency"},
    {"music", to_hear, "sound"},
    {"audio", to_hear, "sound"},
    {"volume", "gain sets the volume of a sound: set music.gain 0.5", "gain"},
    {"loop", to_repeat, "extend copy"},
    {"repeat", to_repeat, "extend copy"},
    {"cycle", to_repeat, "extend copy"},
    {"yoyo", to_repeat, "extend copy"},
    {"extrapolation", to_beyond, "extend"},
    {"bounce", "extend ball.position bounce plays a track back and forth; at 12f fall ball lets it fall and bounce",
     "extend fall"},
    {"easing", to_ease, "ease-in ease-out sine-in-out"},
    {"steps-end", to_ease, "steps"},
    {"path", "a path is a track of positions: at 1f ball.position (0 0 0) smooth, and so on; smooth goes through all",
     "smooth bspline motion"},
    {"spline", "smooth goes through its events, bspline past them, hermite has tangents", "smooth bspline hermite"},
    {"formula", to_reckon, "let"},
    {"variable", to_reckon, "let"},
    {"var", to_reckon, "let"},
    {"const", to_reckon, "let"},
    {"for", "a pattern takes the place of a loop: create b{1..10} box position=(i*2 0 0); i is the place, n how many",
     "let create"},
    {"foreach",
     "a pattern takes the place of a loop: create b{1..10} box position=(i*2 0 0); i is the place, n how many",
     "let create"},
    {"random",
     "hash(i) is 0 to 1, the same each time: set b*.position.y hash(i)*3; noise and wobble are filters; stagger … "
     "random 7 shuffles",
     "let noise wobble stagger"},
    {"alpha", to_fade, "transparency"},
    {"fade", to_fade, "transparency"},
    {"visible", to_show, "show hide display"},
    {"visibility", to_show, "show hide display"},
    {"invisible", to_show, "show hide display"},
    {"interpolate", to_blend, "twerper linear smooth"},
    {"interpolation", to_blend, "twerper linear smooth"},
    {"interpolator", to_blend, "twerper linear smooth"},
    {"tween", to_blend, "twerper linear smooth"},
    {"event", to_event, "at"},
    {"keyframe", to_event, "at"},
    {"keyframes", to_event, "at"},
    {"timeline", to_time, "at rate ticks"},
    {"times", to_time, "at rate ticks"},
    {"units", "lengths are metres, angles 90deg, rad or turn, times 24f, 2s, 90t; a lens 35mm", "rate"},
    {"key", to_event, "at"},
    {"sheet", to_sheet, "at"},
    {"row", to_sheet, "at"},
    {"dope-sheet", to_sheet, "at"},
    {"exposure-sheet", to_sheet, "at"},
    {"track", to_track, "at twerper extend"},
    {"channel", to_track, "at twerper extend"},
    {"f-curve", to_track, "fcurve twerper extend"},
    {"property", to_function, "set define"},
    {"attribute", to_function, "set define"},
    {"target", to_target, "set at"},
    {"component", to_target, "set at"},
    {"object", to_make, "create"},
    {"clone", to_make, "create"},
    {"duplicate", to_make, "create"},
    {"like", to_make, "create"},
    {"time", to_time, "at rate ticks"},
    {"frames", to_time, "at rate ticks"},
    {"second", to_time, "at rate ticks"},
    {"seconds", to_time, "at rate ticks"},
    {"segment", to_time, "range copy"},
    {"fps", "rate sets the frames per second: rate 25", "rate"},
    {"duration", to_last, "range at"},
    {"over", to_last, "at"},
    {"during", to_last, "at"},
    {"cubic-bezier", "bezier is the same: at 12f ball.radius 2 bezier(0.4 0 0.2 1)", "bezier"},
    {"colour", to_color, "color"},
    {"colours", to_color, "color"},
    {"colors", to_color, "color"},
    {"rgb", to_color, "color"},
    {"hsv", to_color, "color"},
    {"parent", to_hold, "couple attach hang letgo"},
    {"child", to_hold, "couple attach hang letgo"},
    {"unparent", to_hold, "detach letgo"},
    {"ik", to_reach, "reach"},
    {"inverse-kinematics", to_reach, "reach"},
    {"skin", to_join, "joints"},
    {"skeleton", to_join, "joints"},
    {"rig", to_join, "joints reach"},
    {"instance", to_instance, "define create call"},
    {"prefab", to_instance, "define unlink"},
    {"symbol", to_instance, "define unlink call"},
    {"override", to_instance, "define revert unlink"},
    {"trail", to_trail, "trace"},
    {"modifier", to_filter, "filter noise spring"},
    {"mirror", "scale mirrors: scale ball.position 1f..24f (1 -1 1), or set ball.scale (1 -1 1)", "scale"},
    {"ball", "sphere is a ball: create ball sphere", "sphere"},
    {"cube", "box is one: create b box", "box"},
    {"model", "mesh shows a file: create cow mesh file=\"cow.obj\"", "mesh"},
    {"drop", "fall makes an object fall: at 12f fall ball ground=0.5", "fall"},
    {"physics", "fall makes objects fall and bounce; betwixt contacts prints collisions; spring and wobble are filters",
     "fall spring wobble"},
    {"catch", to_hold, "couple attach hang letgo"},
    {"constraint", to_hold, "couple attach hang letgo"},
    {"hierarchy", to_hold, "couple attach hang letgo"},
    {"speed",
     "a velocity is a speed per second: at 12f ball.position.x.velocity 2; a stretch changes the speed of a part",
     "stretch at"},
    {"offset", "move shifts a part of a track in time, translate its values", "move translate"},
    {"paste", "copy copies a part of a track to another time: copy ball.position 1f..24f to 24f", "copy"},
    {"marker", to_note, "note"},
    {"cue", to_note, "note"},
    {"comment", "a comment begins with # and a blank; a note shows while the film plays", "note"},
    {"expression", to_compute, "procedure"},
    {"driver", to_compute, "procedure"},
    {"zoom", "a camera's lens zooms: at 24f eye.lens 80mm", "lens fov"},
    {"squash", "scale squashes: at 12f ball.scale (1.2 0.7 1.2)", "scale"},
    {"gravity", "fall makes an object fall: at 12f fall ball ground=0.5", "fall"},
    {"shake", "noise and wobble are filters: filter ball.position noise", "noise wobble"},
    {"turn", to_turn, "rotation rotate"},
    {"euler", to_turn, "rotation"},
    {"axis", to_turn, "rotation"},
    {"quat", to_turn, "rotation"},
    {"deg", to_angle, "rotation"},
    {"rad", to_angle, "rotation"},
    {"if", to_compute, "procedure"},
    {"while", to_compute, "procedure"},
    {"lua", to_compute, "procedure"},
    {"pattern", to_many, "alias"},
    {"where", to_place, "position world eval"},
    {"render", to_film, "play"},
    {"export", to_film, "play"},
    {"print", "eval prints values at times: eval ball.position at 13f", "eval"},
    {"font-size", "size of a text is its em in metres: set title.size 2", "size"},
};

// What parameters of other programs are called here. A kind of "" is any kind.
struct ForeignParameter {
  std::string_view kind, word, leads;
};
constexpr ForeignParameter all_foreign_parameters[] = {
    {"light", "type", "shines=sun makes it the sun, shape=disc or shape=rectangle an area, cone=40deg a spotlight"},
    {"light", "target", "look-at=ball turns it to an object, as a camera"},
    {"light", "angle", "cone=40deg makes it a spotlight, cone-edge=0.2 softens its edge"},
    {"light", "power", "intensity is how bright it is; range how far it reaches"},
    {"light", "energy", "intensity is how bright it is; range how far it reaches"},
    {"camera", "target", "look-at=ball turns the camera to an object or a place"},
    {"camera", "type", "height=10 makes it orthographic: the height of the view in metres"},
    {"camera", "projection", "height=10 makes it orthographic: the height of the view in metres"},
    {"camera", "zoom", "lens=80mm or fov=20deg shows less"},
    {"text", "bevel",
     "letters with a depth have sharp edges; a lamp beside them, or `sky studio`, gives these a highlight"},
    {"", "subsurface", "material=wax and material=skin are soft to light"},
    {"box", "bevel", "corner=0.05 makes the edges round"},
    {"box", "radius", "corner=0.05 makes the edges round"},
    {"text", "width", "wrap=6 breaks lines at that width; size is that of the letters"},
    {"text", "max-width", "wrap=6 breaks lines at that width"},
    {"text", "maxWidth", "wrap=6 breaks lines at that width"},
    {"text", "line-width", "wrap=6 breaks lines at that width"},
    {"text", "textWrap", "wrap=6 breaks lines at that width"},
    {"text", "valign", "anchor=top|middle|bottom: what of the text is at its place"},
    {"text", "vertical-align", "anchor=top|middle|bottom: what of the text is at its place"},
    {"", "opacity", "transparency=0.4 is its opposite; a group has opacity, as a picture"},
    {"", "roundness", "corner=0.05 makes corners round: of a rectangle, and of a box"},
    {"", "rotate", "rotation=euler(0 90deg 0) turns it"},
};

}  // namespace

Hint missing_parameter_hint(const Scene& s, Kind kind, std::string_view name) {
  const KindRow& own = row_of(kind);
  for (const ForeignParameter& p : all_foreign_parameters)
    if ((p.kind.empty() || p.kind == own.name) && same_letters(p.word, name)) return std::string(p.leads);
  if (Hint near = did_you_mean(name, function_names(s, kind)); !near.text.empty()) return near;
  std::vector<std::string_view> others;
  for (const KindRow& row : kinds())
    if (find_function(s, row.kind, name)) others.push_back(row.name);
  if (others.size() == 1 && others.front() == row_of(Kind::group).name)
    return fmt::format("a group has it: create slide group {}=…, attach ball to slide", name);
  if (others.empty() || others.size() > 6) return std::string(foreign_word_hint(name));
  return fmt::format("kinds with '{}': {}", name, fmt::join(others, ", "));
}

std::span<const ForeignWord> foreign_words() { return all_foreign_words; }

std::string_view foreign_word_hint(std::string_view word) {
  word = word.substr(0, word.find_first_of(".("));  // self.play(…)
  const auto at = std::find_if(std::begin(all_foreign_words), std::end(all_foreign_words),
                               [&](const ForeignWord& r) { return same_letters(r.word, word); });
  return at == std::end(all_foreign_words) ? std::string_view() : at->leads;
}

}  // namespace betwixt
