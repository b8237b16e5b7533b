// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "language/reader.h"

namespace betwixt {
namespace {

using enum HelpGroup;

constexpr HelpEntry entries[] = {
    {shell, "help", "Explains a word; without one, lists all words.", "help [WORD]", "help copy"},
    {shell, "list", "Lists the objects, their kinds and how many events they have.", "list [PATTERN]", "list wheel*"},
    {shell, "describe", "Says what an object is, has and hangs on; of a target, its events.", "describe NAME|TARGET",
     "describe ball"},
    {shell, "undo", "Takes back the last command, without limit.", "undo", "undo"},
    {shell, "redo", "Does again what was taken back.", "redo", "redo"},
    {shell, "notes", "Without a word, lists the notes and their times.", "notes", "notes"},
    {shell, "plot", "Draws values against time, in an SVG file.", "plot TARGET [-> FILE.svg]",
     "plot ball.position -> ball.svg"},
    {shell, "play", "Plays the film, or a part of it, in the terminal; q comes back.", "play [A..B]", "play 1f..24f"},
    {shell, "stop", "Ends the playing.", "stop", "stop"},
    {shell, "save", "Writes the author's text as it was and below it what has been done since.", "save [FILE]",
     "save film.bx"},
    {shell, "open", "Goes on with another script; asks first where something is not saved.", "open FILE",
     "open bounce.bx"},
    {shell, "load", "Loads a plug-in; its words are then used like all others.", "load FILE", "load ./swirl.so"},
    {shell, "quit", "Ends the session; asks first where something is not saved. Ctrl-D is the same.", "quit", "quit"},

    {verb, "rate", "Frames per second; the first thing to say.", "", "rate 25"},
    {verb, "range", "The part of time that is the film.", "", "range 1f 48f"},
    {verb, "ticks", "Environment ticks per second, for times such as 90t; smooth: motion between them too.", "",
     "ticks 60 smooth"},
    {verb, "animate", "An environment: all that is in it is moved by a transform again and again.", "",
     "animate spin every 1t by rotate(6deg, z)\nset ball.environments (spin)"},
    {verb, "halt", "Stops an environment where it is; animate goes on from there.", "",
     "animate spin every 1t by rotate(6deg, z)\nat 60t halt spin"},
    {verb, "kill", "Ends an environment: what was in it stays where it is, and the name is free.", "",
     "animate spin every 1t by rotate(6deg, z)\nat 60t kill spin"},
    {verb, "cancel", "Drops the starts and stops of an environment that are still to come.", "",
     "animate spin every 1t by rotate(6deg, z) until 90t\nat 60t cancel spin"},
    {verb, "background", "The color behind everything; none makes it clear again.", "", "background navy"},
    {verb, "create", "Makes an object of a kind, or one like another.", "",
     "create moon sphere radius=0.5 color=silver"},
    {verb, "remove", "Takes objects out of the film.", "", "remove wheel*"},
    {verb, "rename", "Gives an object or a display list another name; all that spoke of it goes on.", "",
     "rename ball planet"},
    {verb, "set", "The value of a function while its track has no events.", "", "set ball.color red"},
    {verb, "at", "Gives a command its time, or puts one event on a track.", "", "at 12f ball.radius 2 ease-in=4f"},
    {verb, "hang", "Hangs an object on another: it is carried along, not turned.", "", "at 20f hang ball on hand"},
    {verb, "attach", "Attaches an object to another: it is carried and turned along.", "",
     "at 20f attach ball to hand keep-world"},
    {verb, "couple", "Couples an object to another: it takes part in all it does, scaling too.", "",
     "couple ball to hand"},
    {verb, "detach", "Nothing holds the object any more: its own tracks place it in the world.", "", "detach ball"},
    {verb, "letgo", "Lets an object go: it stays where it is, without a jump.", "",
     "at 20f attach ball to hand\nat 60f letgo ball"},
    {verb, "look", "From this time on the film is seen through a camera.", "", "at 24f look through eye"},
    {verb, "note", "A remark at a time; it shows while the film plays.", "", "at 24f note \"first bounce ends\""},
    {verb, "notes", "Whether notes show while the film plays.", "", "notes off"},
    {verb, "show", "Shows objects, from a time on or for the whole film.", "", "at 12f show ball"},
    {verb, "hide", "Hides objects, from a time on or for the whole film.", "", "at 24f hide ball"},
    {verb, "twerper", "One interpolator for a whole track.", "", "twerper ball.position linear"},
    {verb, "extend", "What a track does before its first and after its last event.", "", "extend ball.position cycle"},
    {verb, "copy", "Copies a segment of a track to another time, once or many times.", "",
     "copy ball.position 1f..24f to 24f shift (8 0 0) times 2"},
    {verb, "move", "Moves the events of a segment in time.", "", "move ball.position 1f..24f by 12f"},
    {verb, "stretch", "Makes a segment longer or shorter.", "", "stretch ball.position 1f..24f by 2"},
    {verb, "reverse", "Runs a segment backwards.", "", "reverse ball.position 1f..24f"},
    {verb, "scale", "Multiplies the values of a segment.", "", "scale ball.position 1f..24f (1 -1 1)"},
    {verb, "translate", "Adds to the values of a segment.", "", "translate ball.position 1f..24f (0 1 0)"},
    {verb, "rotate", "Turns the values of a segment about an axis.", "", "rotate ball.position 1f..24f 90deg y"},
    {verb, "clear", "Takes out the events of a segment, or of one time.", "", "clear ball.position 6f..18f"},
    {verb, "stagger", "Makes many objects do the same one after another.", "", "stagger wheel*.position by 6f"},
    {verb, "spread", "Lays values evenly from one object to the last.", "",
     "spread wheel*.position from (0 0 0) to (9 0 0)"},
    {verb, "filter", "A function through time over a track: smooth, noise, delay, limit, wobble, spring.", "",
     "filter ball.position delay by=6f"},
    {verb, "layer", "A layer of motion over the objects; its weight is a target of its own.", "",
     "layer sway add weight=0.5"},
    {verb, "on", "Carries out a command on a layer.", "", "layer sway add\non sway at 12f ball.position (0 1 0)"},
    {verb, "procedure", "A function of your own in Lua: a value, a twerper, a filter or a command.", "",
     "procedure swing lua \"return math.sin(t)\""},
    {verb, "fall", "Lets objects fall and bounce; it becomes plain events.", "", "at 24f fall ball"},
    {verb, "dial", "A control of live input turns a target.", "", "dial /fader/1 to ball.radius from 0 1 to 0.5 2"},
    {verb, "record", "Whether what dials say becomes events.", "", "record on"},
    {verb, "alias", "A name for many objects; patterns inside are read at each use.", "", "alias toys = ball wheel*"},
    {verb, "define", "A function of your own that every object has.", "", "define heat number 20"},
    {verb, "policy", "What an operation gets that means nothing for a target.", "", "policy ignore"},
    {verb, "use", "Carries out another script here.", "", "use colors.bx"},

    {verb, "make", "Opens a new display list; its commands are the indented rows below.", "",
     "make star\n  color gold\n  polygon (0 1) (-0.3 0) (0.3 0)\nstart star"},
    {verb, "edit", "Opens a display list again: rows are added, or replace others.", "",
     "make star\n  tag first\n  color gold\nedit star\n  replace first\n  color red"},
    {verb, "delete", "Takes a display list out of the film.", "", "make star\n  point (0 0)\ndelete star"},
    {verb, "start", "Shows a display list with all that it calls: it is the main object.", "",
     "make star\n  point (0 0)\nstart star"},

    {row, "point", "Draws points.", "", "make list\n  point (0 0) (1 0 0)"},
    {row, "vector", "Draws a line through points.", "", "make list\n  vector (0 0 0) (1 1 1)"},
    {row, "polygon", "Draws a filled outline.", "", "make list\n  polygon (0 0) (2 0) (1 2)"},
    {row, "text", "Draws letters.", "", "make list\n  text \"Hello\""},
    {row, "color", "The color of what is drawn from here on.", "", "make list\n  color gold\n  point (0 0)"},
    {row, "texture", "The picture on what is drawn from here on; \"\" is none.", "", "make list\n  texture \"\""},
    {row, "font", "The font of letters from here on.", "", "make list\n  font \"DejaVu Sans\"\n  text \"Hello\""},
    {row, "push", "Keeps the matrix, until the pop that belongs to it.", "",
     "make list\n  push\n  translate(1 0 0)\n  point (0 0)\n  pop"},
    {row, "pop", "Goes back to the matrix of the last push.", "",
     "make list\n  push\n  scale(2)\n  point (1 0)\n  pop"},
    {row, "multiply", "Moves what is drawn from here on; what is said last is done first.", "",
     "make list\n  multiply translate(1 0 0)\n  rotate(90deg, z)\n  point (1 0)"},
    {row, "call", "Draws another list: an instance, which keeps its matrices and colors to itself.", "",
     "make star\n  point (0 0)\nmake list\n  call star\n  translate(1 0 0)\n  call star"},
    {row, "begin", "What is drawn from here on is in an environment, until its end.", "",
     "make list\n  begin wind\n  point (0 0)\n  end"},
    {row, "end", "Ends the environment that was begun last.", "", "make list\n  begin wind\n  end"},
    {row, "view", "Where the main list is seen from, and where to.", "", "make list\n  view from (0 2 9) to (0 0 0)"},
    {row, "perspective", "The horizontal angle that is seen.", "", "make list\n  perspective 50deg"},
    {row, "orthographic", "Sees without perspective, so much from bottom to top.", "", "make list\n  orthographic 10"},
    {row, "tag", "Labels the row that comes next, for replace.", "", "make list\n  tag place\n  translate(0 0 0)"},
    {row, "replace", "The rows below replace those from a tag on.", "",
     "make list\n  tag place\n  translate(0 0 0)\nedit list\n  replace place\n  translate(1 0 0)"},

    {kind, "group", "No shape; things hang on it.", "", "create hand2 group position=(0 1 0)"},
    {kind, "sphere", "A ball.", "radius=1", "create s sphere radius=2"},
    {kind, "box", "A box.", "size=(1 1 1)", "create b box size=(2 1 1)"},
    {kind, "cylinder", "A cylinder along y.", "radius=1 height=1", "create c cylinder radius=0.5 height=2"},
    {kind, "cone", "A cone along y.", "radius=1 height=1", "create c cone height=2"},
    {kind, "torus", "A ring.", "radius=1 tube=0.3", "create ring torus tube=0.1"},
    {kind, "plane", "A flat rectangle.", "size=(1 1)", "create floor plane size=(20 20)"},
    {kind, "disc", "A flat disc.", "radius=1", "create d disc radius=3"},
    {kind, "polygon", "A filled outline.", "points=((x y) …)", "create p polygon points=((0 0) (2 0) (1 2))"},
    {kind, "polyline", "A line through points.", "points=((x y) …) width=0.05",
     "create l polyline points=((0 0) (2 0) (1 2)) width=0.1"},
    {kind, "points", "A cloud of points.", "points=((x y z) …) size=0.05",
     "create stars points points=((0 0 0) (1 2 3)) size=0.1"},
    {kind, "text", "Letters, flat or with a depth.", "text=\"…\" font=\"DejaVu Sans\" size=1 depth=0",
     "create title text text=\"The end\" size=2"},
    {kind, "mesh", "A shape from a file below the script's folder.", "file=\"…\" texture=\"…\"",
     "create tree mesh file=\"tree.obj\""},
    {kind, "light", "A lamp, or the sun.", "range=20 intensity=1 shines=point|sun",
     "create sun light shines=sun intensity=2"},
    {kind, "camera", "Where the film is seen from.", "lens=35mm or fov=50deg or height=10, look-at=(x y z) or a name",
     "create side camera position=(30 0 0) look-at=ball"},
    {kind, "environment", "What the command animate makes: a matrix that moves what is in it.", "", ""},
    {kind, "layer", "What the command layer makes: motion laid over objects.", "weight=1 mode=add|mix", ""},

    {function, "position", "Where an object is, from what holds it.", "a vector", "set ball.position (0 10 0)"},
    {function, "rotation", "How it is turned: about its x, y and z axes, or an orientation.",
     "euler(x y z), axis(x y z, angle), quat(w x y z)", "set ball.rotation euler(0deg 90deg 0deg)"},
    {function, "scale", "How large it is, along each axis.", "a vector", "set ball.scale (1 2 1)"},
    {function, "pivot", "The point it turns and grows about.", "a vector", "set ball.pivot (0 -1 0)"},
    {function, "attach-position", "Where on it others are attached.", "a vector", "set ball.attach-position (0 1 0)"},
    {function, "color", "Its color.", "a name, #rrggbb, rgb(…), hsv(…)", "set ball.color gold"},
    {function, "shininess", "How sharply it shines, 0 to 1.", "a number", "set ball.shininess 0.8"},
    {function, "transparency", "How much is seen through it, 0 to 1.", "a number", "set ball.transparency 0.5"},
    {function, "geometry", "The shape it shows: its own, or another object's.", "shape(NAME) or none",
     "set ball.geometry shape(wheel1)"},
    {function, "display", "Whether it is seen.", "on or off", "set ball.display off"},
    {function, "material", "What it seems to be made of.", "\"plastic\", \"matte\", \"metal\" or \"glow\"",
     "set ball.material \"metal\""},
    {function, "texture", "A picture on it, from a file below the script's folder.", "\"FILE\"",
     "set ball.texture \"\""},
    {function, "attachment", "What holds it, and how; see hang, attach and couple.", "", ""},
    {function, "environments", "The environments it is in, the outermost first.", "(E1 E2)",
     "animate wind every 1t by translate(0.1 0 0)\nset ball.environments (wind)"},
    {function, "drive", "Environments that move it in its own space, before its own place.", "(E1 E2)",
     "animate spin every 1t by rotate(6deg, z)\nset ball.drive (spin)"},
    {function, "transform", "Moves it in its own space, before its own place.",
     "translate(…) rotate(…) scale(…) or matrix(…)", "set ball.transform scale(1 2 1) rotate(30deg, z)"},
    {function, "motion",
     "A string of translations, rotations and scalings over a segment; the leftmost is applied last.",
     "1f..48f T(6.28 0) R(-1turn @ 0 1)", "at 1f..48f ball.motion T(6.28 0) R(-1turn @ 0 1)"},
    {function, "radius", "Of spheres, discs, cylinders, cones and rings.", "a number", "set ball.radius 2"},
    {function, "size", "Of boxes, planes, letters and points.", "as many numbers as it has sides",
     "create crate box\nset crate.size (1 2 3)"},
    {function, "height", "Of cylinders and cones; of a camera without perspective, what it sees.", "a number",
     "set eye.height 10"},
    {function, "tube", "How thick a ring is.", "a number", "create ring torus\nset ring.tube 0.1"},
    {function, "points", "The points of an outline, a line or a cloud.", "((x y) …)",
     "create line polyline\nset line.points ((0 0) (1 1))"},
    {function, "width", "How thick a line is.", "a number", "create line polyline\nset line.width 0.2"},
    {function, "text", "What letters say.", "\"…\"", "create title text\nset title.text \"The end\""},
    {function, "font", "The font of letters.", "\"…\"", "create title text\nset title.font \"DejaVu Sans\""},
    {function, "depth", "How thick letters are.", "a number", "create title text\nset title.depth 0.2"},
    {function, "file", "The file of a mesh.", "\"FILE\"", ""},
    {function, "range", "How far a lamp shines.", "a number", "set lamp.range 60"},
    {function, "intensity", "How brightly a lamp shines.", "a number", "set lamp.intensity 2"},
    {function, "shines", "Whether a lamp shines from a point or like the sun.", "\"point\" or \"sun\"",
     "set lamp.shines \"sun\""},
    {function, "lens", "The lens of a camera, on a gate 36 mm wide.", "35mm", "set eye.lens 50mm"},
    {function, "fov", "The horizontal angle a camera sees.", "an angle", "set eye.fov 50deg"},
    {function, "look-at", "What a camera looks at.", "a point or a name", "set eye.look-at ball"},
    {function, "weight", "How much of a layer counts, 0 to 1.", "a number", ""},
    {function, "mode", "Whether a layer is added or mixed in.", "\"add\" or \"mix\"", ""},
    {function, "world", "Where it is in the world, a matrix; it can be asked for, not set.", "", ""},
    {function, "touching", "The names of what it touches; it can be asked for, not set.", "", ""},
    {function, "in-view", "Whether any of it is in view; it can be asked for, not set.", "", ""},

    {twerper, "hold", "Stays, then jumps at the next event.", "", "at 12f ball.radius 2 hold"},
    {twerper, "linear", "Straight to the next event.", "", "at 12f ball.radius 2 linear"},
    {twerper, "smooth", "Through all events without a corner (Catmull-Rom).", "", "at 12f ball.radius 2 smooth"},
    {twerper, "bspline", "Softer than smooth; comes near its events only.", "", "at 12f ball.radius 2 bspline"},
    {twerper, "hermite", "Through all events, by tangents of your own.", "hermite [tangent=V]",
     "at 12f ball.radius 2 hermite tangent=0"},
    {twerper, "bezier", "To the next event along a curve of speed.", "bezier(x1 y1 x2 y2)",
     "at 12f ball.radius 2 bezier(0.25 0.1 0.25 1)"},
    {twerper, "slerp", "The shortest way between two orientations.", "",
     "at 12f hand.rotation axis(0 1 0, 90deg) slerp"},
    {twerper, "squad", "Through many orientations without a corner.", "",
     "at 12f hand.rotation axis(0 1 0, 90deg) squad"},

    {filter, "smooth", "A mean over a window of time around each moment.", "width=0.5s",
     "filter ball.position smooth width=0.3s"},
    {filter, "spring", "As through a weight on a spring: comes late, and swings on.", "frequency=2 damping=0.3",
     "filter ball.position spring frequency=3"},
    {filter, "noise", "Wanders by chance, the same whenever it is asked.", "amount=1 frequency=1 seed=0",
     "filter ball.position noise amount=(0.1 0.1 0) frequency=4"},
    {filter, "wobble", "Adds a sine.", "amount=1 frequency=1 phase=0",
     "filter ball.position wobble amount=(0 0.2 0) frequency=2"},
    {filter, "delay", "Comes later; below 0 earlier.", "by=0.25s", "filter ball.position delay by=6f"},
    {filter, "steps", "Holds each value until the next step.", "rate=12", "filter ball.position steps rate=8"},
    {filter, "limit", "Never below, never above.", "low= high=", "filter ball.radius limit high=3"},
    {filter, "quantise", "Whole multiples only.", "by=0.1", "filter ball.position quantise by=0.5"},

    {option, "ease-in", "How long before its event a value slows down.", "ease-in=LENGTH",
     "at 12f ball.radius 2 ease-in=4f"},
    {option, "ease-out", "How long behind its event a value takes to come to speed.", "ease-out=LENGTH",
     "at 12f ball.radius 2 ease-out=4f"},
    {option, "cut", "A jump: the track comes to the first value and goes on from the second.", "VALUE cut VALUE",
     "at 12f ball.radius 2 cut 1"},
    {option, "keep", "The twerper changes, the value is what it would have been.", "keep TWERPER",
     "at 12f ball.radius keep linear"},
    {option, "tangent", "Where hermite comes from and goes to, per second; also tangent-in, tangent-out.",
     "tangent=VALUE", "at 12f ball.radius 2 hermite tangent=1"},
    {option, "velocity", "The speed of a target, a track beside its own; it reigns until a release.", "TARGET.velocity",
     "at 12f ball.position.velocity (1 0 0)"},
    {option, "release", "Ends the reign of a velocity; from here the track goes to its next event.",
     "at TIME TARGET.velocity release", "at 12f ball.position.velocity (1 0 0)\nat 24f ball.position.velocity release"},
    {option, "keep-world", "What is attached stays where it is in the world at that moment.",
     "attach A to B keep-world", "at 20f attach ball to hand keep-world"},
};

bool there(const HelpEntry& e) {
  if (e.group != verb) return true;
  const auto words = Reader::words();
  return std::any_of(words.begin(), words.end(), [&](const auto& w) { return w.first == e.word; });
}

std::string usage(const HelpEntry& e) {
  if (e.group == verb || e.group == row)
    for (const auto& [word, usage] : e.group == verb ? Reader::words() : Reader::row_words())
      if (word == e.word) return std::string(usage);
  return std::string(e.usage);
}

constexpr std::pair<HelpGroup, std::string_view> groups[] = {
    {shell, "Words of the shell"},
    {verb, "Commands"},
    {row, "Rows of display lists (make NAME)"},
    {kind, "Kinds of objects (create NAME KIND …)"},
    {function, "Functions (NAME.function)"},
    {twerper, "Twerpers (from one event to the next)"},
    {filter, "Filters (filter TARGET NAME …)"},
    {option, "Words of events and attachments"},
};

constexpr std::string_view what(HelpGroup g) {
  return g == shell      ? "a word of the shell"
         : g == verb     ? "a command"
         : g == row      ? "a row of a display list"
         : g == kind     ? "a kind of object"
         : g == function ? "a function"
         : g == twerper  ? "a twerper"
         : g == filter   ? "a filter"
                         : "a word of events";
}

// What a procedure is, and what whoever made it says.
std::string about(const NamedProcedure& p) {
  static constexpr std::string_view roles[] = {"A procedure", "A twerper", "A filter", "A command"};
  const bool plugin = p.code && p.code->language == "plug-in";
  std::string out = fmt::format("{} {}", roles[static_cast<std::size_t>(p.role)],
                                plugin ? fmt::format("of the plug-in {}", p.code->source) : "of this film");
  if (const std::string says = plugin ? plugin_help(p.name) : ""; !says.empty()) out += ": " + says;
  return out + ".";
}

}  // namespace

std::span<const HelpEntry> help_entries() { return entries; }

std::string help_overview(const Scene& scene, bool of_the_shell) {
  std::string out =
      "A line is a command; a line that is only a target (ball.position) opens a sheet, whose rows are indented:\n"
      "  TIME VALUE [TWERPER] [ease-in=LENGTH] [ease-out=LENGTH]\n";
  for (const auto& [group, title] : groups) {
    if (group == shell && !of_the_shell) continue;
    out += fmt::format("\n{}\n", title);
    for (const HelpEntry& e : entries)
      if (e.group == group && there(e)) out += fmt::format("  {:16} {}\n", e.word, e.sentence);
  }
  if (!scene.defined->empty() || !scene.procedures->empty()) out += "\nOf this film and of plug-ins\n";
  for (const FunctionSpec& f : *scene.defined)
    out += fmt::format("  {:16} A function: {}.\n", f.name, to_string(f.type));
  for (const NamedProcedure& p : *scene.procedures) out += fmt::format("  {:16} {}\n", p.name, about(p));
  return out + "\nhelp WORD says more and gives an example.\n";
}

std::string help_text(std::string_view word, const Scene& scene) {
  std::string out;
  static constexpr std::array<std::string_view, 2> factors[] = {
      {"T", "a way, T(6 0) or T(6 0 0)"},
      {"R", "a turn about a point, R(90deg @ 0 1), an object, R(1turn @ sun), or an axis, R(1turn @ 0 1 0 axis y)"},
      {"S", "a scaling about a point, S(2), S(2 0.5 @ 0 1), or by the linear law, S(2 2 @ 0 0 linear)"}};
  for (const auto& [letter, sentence] : factors)
    if (letter == word)
      out = fmt::format("{}, a factor of a motion: {}\n  example: at 1f..48f ball.motion T(6 0) R(-1turn @ ball)\n",
                        letter, sentence);
  for (const HelpEntry& e : entries) {
    if (e.word != word) continue;
    if (!out.empty()) out += "\n";
    out += fmt::format("{}, {}: {}\n", e.word, what(e.group), e.sentence);
    if (!there(e)) {
      out += "  It is not in this version of Betwixt.\n";
      continue;
    }
    if (const std::string how = usage(e); !how.empty())
      out += fmt::format("  {}: {}\n", e.group <= row ? "usage" : "written", how);
    if (!e.example.empty()) {
      std::string lines(e.example);
      for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 12)
        lines.insert(at + 1, 11, ' ');
      out += fmt::format("  example: {}\n", lines);
    }
  }
  // A verb without an entry of its own: its usage at least.
  if (out.empty())
    for (const auto& [verb_word, how] : Reader::words())
      if (verb_word == word) out += fmt::format("{}, a command\n  usage: {}\n", verb_word, how);
  for (const FunctionSpec& f : *scene.defined)
    if (f.name == word) out += fmt::format("{}, a function of this film: {}\n", f.name, to_string(f.type));
  for (const NamedProcedure& p : *scene.procedures) {
    if (p.name != word) continue;
    out += fmt::format("{}: {}\n", p.name, about(p));
    static constexpr std::string_view examples[] = {"set ball.radius = \"{0}()\"", "at 12f ball.radius 2 {0}",
                                                    "filter ball.radius {0}", "{0}"};
    out +=
        fmt::format("  example: {}\n", fmt::format(fmt::runtime(examples[static_cast<std::size_t>(p.role)]), p.name));
  }
  return out;
}

}  // namespace betwixt
