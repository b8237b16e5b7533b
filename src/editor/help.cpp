// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "commands/list_rows.h"
#include "commands/plugins.h"
#include "commands/verbs.h"

namespace betwixt {
namespace {

using enum HelpGroup;

constexpr HelpEntry other_words[] = {
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

std::span<const HelpEntry> help_entries() {
  static const std::vector<HelpEntry> all = [] {
    std::vector<HelpEntry> entries = shell_entries();
    for (const Verb& v : verbs()) entries.push_back({verb, v.word, v.sentence, v.usage, v.example});
    for (const ListRow& r : list_rows()) entries.push_back({row, r.word, r.sentence, r.usage, r.example});
    entries.insert(entries.end(), std::begin(other_words), std::end(other_words));
    return entries;
  }();
  return all;
}

std::string help_overview(const Scene& scene, bool of_the_shell) {
  std::string out =
      "A line is a command; a line that is only a target (ball.position) opens a sheet, whose rows are indented:\n"
      "  TIME VALUE [TWERPER] [ease-in=LENGTH] [ease-out=LENGTH]\n";
  for (const auto& [group, title] : groups) {
    if (group == shell && !of_the_shell) continue;
    out += fmt::format("\n{}\n", title);
    for (const HelpEntry& e : help_entries())
      if (e.group == group) out += fmt::format("  {:16} {}\n", e.word, e.sentence);
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
  for (const HelpEntry& e : help_entries()) {
    if (e.word != word) continue;
    if (!out.empty()) out += "\n";
    out += fmt::format("{}, {}: {}\n", e.word, what(e.group), e.sentence);
    if (!e.usage.empty()) out += fmt::format("  {}: {}\n", e.group <= row ? "usage" : "written", e.usage);
    if (!e.example.empty()) {
      std::string lines(e.example);
      for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 12)
        lines.insert(at + 1, 11, ' ');
      out += fmt::format("  example: {}\n", lines);
    }
  }
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
