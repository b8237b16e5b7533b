// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests every error: its code, place, subject and suggestion, and that the wrong command has changed nothing. Only this
// file compares the wording of messages, each once.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr const char* head =
    "create ball sphere radius=2\ncreate eye camera\ncreate car group\nball.position.x\n  1f 1 linear\n  5f 5\nalias "
    "all = b*\n"
    "create word text text=\"a\"\ncreate turn box\nturn.rotation\n  1f axis(z, 90deg)\ncreate soft sphere\n";
constexpr int head_lines = 12;

struct Case {
  const char* lines;              // the last one is wrong
  const char* told;               // as told() has it, without the line
  const char* message = nullptr;  // null: its words are tested by another case
  const char* hint = nullptr;     // how it begins; null: any
};

void expect_case(const Case& k) {
  const std::string text = std::string(head) + k.lines + "\n";
  const auto last = text.rfind('\n', text.size() - 2) + 1;
  const Loaded good = read(text.substr(0, last)), bad = read(text);
  const auto said_here = all_told(bad);
  ASSERT_EQ(said_here.size(), 1u) << k.lines << "\n" << said(bad.diagnostics);
  const std::string_view is = k.told;
  const auto blank = is.find(' ') + 1;
  EXPECT_EQ(said_here[0],
            fmt::format("{}{}:{}", is.substr(0, blank), std::count(text.begin(), text.end(), '\n'), is.substr(blank)))
      << k.lines;
  const Diagnostic* error = nullptr;
  for (const Diagnostic& d : bad.diagnostics)
    if (d.severity == Severity::error) error = &d;
  if (k.message) {
    EXPECT_EQ(error->what.message, k.message) << k.lines;
  }
  if (k.hint) {
    EXPECT_TRUE(error->what.hint.starts_with(k.hint)) << k.lines << "\n" << said(bad.diagnostics);
  }
  EXPECT_EQ(bad.document, good.document) << k.lines << " has changed something";
}

TEST(Errors, Words) {
  for (const Case& k : std::vector<Case>{
           {"crate b sphere", "name 1 crate", "there is no command 'crate'", "did you mean 'create'?"},
           {"ball", "name 1 ball", "'ball' is an object, not a command",
            "to open a sheet, write a target, as in ball.position"},
           {"wheels = w*", "name 1 wheels", {}, "to name many objects: alias wheels"},
           {"// words", "syntax 1 //", "a comment starts with '#' and a space"},
           {"set ball.position 1 0 2", "type 19 1", "expected a vector here, not one number", "write (1 0 2)"},
           {"#comment", "syntax 1 #comment"},
           {"(1 2 3)", "syntax 1 (", "a command must begin with a verb, not with '('"},
           {"12f (1 2 3)", "syntax 1 12f", "this looks like a row, but no sheet is open", "rows are indented"},
           {"rate", "syntax 5", "a number is missing here", "usage: rate N"},
           {"rate fast", "syntax 6 fast", "'fast' is not a number"},
           {"rate 0", "range 6 0", "frames per second must be from 0.0001 to 100000"},
           {"rate 24 25", "syntax 9 25", "'25' is not expected here", "usage: rate N"},
           {"rate nan", "syntax 6 nan"},
           {"range 1f", "syntax 9", "a time is missing here"},
           {"range 9f 1f", "range 7 9f 1f", "the range ends before it begins"},
           {"ticks inf", "syntax 7 inf"},
           {"background glod", "name 12 glod", "there is no colour 'glod'", "did you mean 'gold'?"},
           {"delete ball", "name 8 ball", "'ball' is a sphere, not a display list",
            "to remove the object: remove ball"},
           {"notes maybe", "type 7 maybe", "notes must be on or off"},
           {"policy translat", "type 8 translat", "the policy must be translate, ignore or ask",
            "did you mean 'translate'?"},
           {"create", "syntax 7", "a name is missing here"},
           {"create 2b sphere", "syntax 8 2b", "'2b' cannot be a name", "a name starts with a letter"},
           {"create ball sphere", "name 8 ball", "'ball' already exists"},
           {"create b", "name 9", "a kind is missing here"},
           {"create b spere", "name 10 spere", "there is no kind 'spere'", "did you mean 'sphere'?"},
           {"create b sphere radios=1", "name 17 radios", "a sphere has no 'radios'", "did you mean 'radius'?"},
           {"create b rectangle blur=1", "name 20 blur", "a rectangle has no 'blur'",
            "a group has it: create slide group blur=…, attach ball to slide"},
           {"create b sphere opacity=1", "name 17 opacity", "a sphere has no 'opacity'",
            "transparency=0.4 is its opposite; a group has opacity, as a picture"},
           {"create b camera target=a", "name 17 target", "a camera has no 'target'",
            "look-at=ball turns the camera to an object or a place"},
           {"create b box teeth=1", "name 14 teeth", "a box has no 'teeth'", "kinds with 'teeth': gear"},
           {"create b circle radios=1", "name 17 radios", "a circle has no 'radios'", "did you mean 'radius'?"},
           {"create b sphere radius", "syntax 17 radius", "'radius' needs a value"},
           {"create b sphere radius=", "syntax 24"},
           {"create b sphere radius=-1", "range 24 -1", "radius must be at least 0"},
           {"create b sphere radius=1e400", "range 24 1e400", "'1e400' is too large for a number"},
           {"create b sphere radius=nan", "syntax 24 nan"},
           {"create b sphere scale=(1 2)", "type 23 (1 2)", "expected 3 numbers here, not 2"},
           {"create b sphere position=(1 2 3 4)", "type 33 4", "expected only 3 numbers here"},
           {"create b sphere color=#ffcc0", "syntax 23 #ffcc0",
            "a hexadecimal colour must have 3 or 6 digits, as in #ffcc00"},
           {"create b sphere shininess=2", "range 27 2", "shininess must be at most 1"},
           {"create b camera lens=3q", "type 22 3q", "'q' is not a unit of length", "units are m, cm and mm"},
           {"create b camera fov=50", "type 21 50", "an angle needs a unit",
            "write 50deg; units are deg, rad and turn"},
           {"create b camera fov=50grad", "type 23 grad", "'grad' is not a unit of angles",
            "units are deg, rad and turn"},
           {"create b light shines=moon", "type 23 moon", "shines must be point or sun"},
           {"create b light shines=spot", "type 23 spot", "shines must be point or sun", "cone=40deg"},
           {"create b light shape=area", "type 22 area", "shape must be point, disc or rectangle", "shape=rectangle"},
           {"create b text anchor=center", "type 22 center", "anchor must be baseline, top, middle or bottom",
            "anchor=middle"},
           {"create b text text=hello", "syntax 20 hello", "a text in double quotes is missing here"},
           {"create b text text=\"hello", "syntax 20 \"", "this text is not closed on the same line"},
           {"create b text text=\"a\\q\"", "syntax 22 \\q", "a text cannot contain '\\q'", "write \\\\q, or put"},
           {"create b text text=\"a\\1\"", "syntax 22 \\1", "a text cannot contain '\\1'", "a text can contain"},
           {"create b text tex=\"2 \\times 3\"", "syntax 22 \\t", {}, "write \\\\times"},
           {"create b text tex=\"x \\neq 3\"", "syntax 22 \\n", {}, "write \\\\neq"},
           {"create b text text=\"so \"so\" \"", "syntax 24 \"", "the text ends at this quote", "write \\\""},
           {"create b sphere radius=0,5", "syntax 26 5", "'5' needs a value", "numbers have a point"},
           {"create b{1-3} sphere", "syntax 8 b{1-3}", "'{1-3}' is no range", "write {1..3}"},
           {"create b rect", "name 10 rect", {}, "a rectangle: create card rectangle"},
           {"at 1f ball.position.x 1 power2.out", "name 25 power2.out", {}, "did you mean 'cubic-out'?"},
           {"at 1f ball.position.x 1 easeInOutQuad", "name 25 easeInOutQuad", {}, "did you mean 'quad-in-out'?"},
           {"at 1f ball.position.x 1 power3", "name 25 power3", {}, "did you mean 'quart-out'?"},
           {"at 1f ball.position.x 1 bounce.in", "name 25 bounce.in", {}, "did you mean 'bounce-in'?"},
           {"at 1f ball.position.x 1 cubic-bezier(0 0 1 1)", "name 25 cubic-bezier", {}, "bezier is the same"},
           {"at 1f ball.position.x 1 duration 1s", "name 25 duration", {}, "for says how long a row takes"},
           {"set ball.color #fff8", "syntax 16 #fff8", {}, "opacity is apart"},
           {"set ball.position.x 100px", "type 21 100px", "'px' is not a unit of length",
            "a film is measured in metres"},
           {"create b MathTex", "name 10 MathTex", {}, "tex= makes a text a formula"},
           {"FadeIn ball", "name 1 FadeIn", {}, "did you mean 'fade-in'?"},
           {"create b mesh", "syntax 10 mesh", "a mesh needs its file"},
           {"create b mesh file=\"none.obj\"", "file 20 \"none.obj\"", "there is no file 'none.obj'"},
           {"create b like bal", "name 15 bal", "there is no object 'bal'", "did you mean 'ball'?"},
           {"create bus/wheel sphere", "name 8 bus/wheel", "there is no 'bus' for 'bus/wheel' to belong to",
            "create bus first"},
           {"create b{1..99999999} sphere", "range 8 b{1..99999999}", "'{1..99999999}' makes more than 1000000 names"},
           {"create b{1,1} sphere", "name 8 b{1,1}", "'b1' would be created twice"},
           {"create b{1 sphere", "syntax 8 b{1 sphere", "the brace in 'b{1 sphere' is not closed"},
           {"remove bal", "name 8 bal", {}, "did you mean 'ball'?"},
           {"rename ball eye", "name 13 eye"},
           {"rename ball", "syntax 12", "the new name is missing here"},
           {"couple ball to ball", "name 8 ball", "'ball' cannot be coupled to itself"},
           {"couple ball car", "syntax 13 car", "'to' is missing here", "usage: couple A to B [keep-world]"},
           {"detach bus", "name 8 bus"},
           {"define radius number", "name 8 radius", "a function 'radius' already exists"},
           {"define heat temperature", "name 13 temperature", "there is no type 'temperature'", "types are number"},
           {"define heat number hot", "syntax 20 hot"},
           {"alias = b", "syntax 7 ="},
           {"alias a b", "syntax 9 b", "'=' is missing here"},
           {"alias a = (b)", "syntax 11 (", "expected names or patterns here"},
       })
    expect_case(k);
}

TEST(Errors, ValuesAndEvents) {
  for (const Case& k : std::vector<Case>{
           {"set ball.radios 1", "name 10 radios", "'ball', a sphere, has no function 'radios'",
            "did you mean 'radius'?"},
           {"set bal.radius 1", "name 5 bal", {}, "did you mean 'ball'?"},
           {"set ball 1", "syntax 5 ball", "'ball' is not a target", "a target is an object and a function"},
           {"set ball.position", "syntax 18", "a vector (x y z) is missing here"},
           {"set ball.position 1", "type 19 1", {}, "write (1 1 1)"},
           {"set ball.position red", "type 19 red", "expected a vector (x y z) here"},
           {"set ball.position (1 2 inf)", "syntax 24 inf"},
           {"set ball.position (1 2 3", "syntax 19 (", "this bracket is never closed"},
           {"set ball.position.w 1", "name 19 w", "position has no component 'w'", "components are x, y and z"},
           {"set ball.radius.x 1", "name 17 x", "radius has no components: it is a number"},
           {"set ball.world 1", "type 10 world", "'world' can be read, but not set"},
           {"set ball.display yes", "type 18 yes", "expected on or off here"},
           {"set ball.rotation 90deg", "type 19 90deg", "'90deg' is not a rotation", "rotations look like euler"},
           {"set ball.rotation euler(0 90 0)", "type 27 90", {}, "write 90deg"},
           {"set ball.rotation axis(0 0 0, 90deg)", "range 24 0 0 0", "the axis 0 0 0 has no direction"},
           {"set ball.rotation quat(0 0 0 0)", "range 19 quat(0 0 0 0)", "a quaternion must not be zero"},
           {"set ball.rotation euler 1", "syntax 19 euler", "'euler' needs its numbers in brackets"},
           {"set ball.geometry eye", "type 19 eye", {}, "write shape(NAME)"},
           {"set ball.geometry shape(eye)", "type 25 eye", "a camera has no geometry"},
           {"set ball.geometry shape(bus)", "name 25 bus"},
           {"set eye.look-at bal", "name 17 bal", {}, "did you mean 'ball'?"},
           {"set word.text 5deg", "type 15 5deg"},
           {"set ball.radius 5 linear", "syntax 19 linear"},
           {"set ball.radius 5kg", "type 17 5kg"},
           {"at", "syntax 3"},
           {"at 5 ball.radius 1", "type 4 5", "a time needs a unit", "write 5f for a frame number"},
           {"at 5x ball.radius 1", "type 5 x", "'x' is not a unit of time", "units are f"},
           {"at 5f", "syntax 6", "a target or a command is missing here"},
           {"at 5f ball", "syntax 7 ball", "expected a target or a command here, not 'ball'"},
           {"at 5f rate 24", "syntax 7 rate", "'rate' takes no time: it applies to the whole film"},
           {"at 5f set", "syntax 10", "a target is missing here"},
           {"at 5f set ball", "syntax 11 ball", {}, "a target is an object and a function"},
           {"at 5f ball.radius 1 ease=4f", "name 21 ease", "there is no option 'ease'", "ease-in=4f slows down before"},
           {"set ball.opacity 1", "name 10 opacity", {}, "transparency goes the other way"},
           {"set ball.colour red", "name 10 colour", {}, "did you mean 'color'?"},
           {"create b cube", "name 10 cube", {}, "box is one"},
           {"loop ball.position", "name 1 loop", {}, "extend ball.position cycle repeats a track"},
           {"at 5f at 6f note \"a\"", "syntax 7 at"},
           {"at 5f ball.radius", "syntax 18"},
           {"at 5f ball.radius 1 liner", "name 21 liner", "there is no twerper 'liner'", "did you mean 'linear'?"},
           {"at 5f ball.radius 1 linear hold", "syntax 28 hold",
            "'hold' is not expected here: this event already has a twerper"},
           {"at 5f ball.radius 1 slerp", "type 21 slerp", "'slerp' is for orientations; this is a number"},
           {"at 5f ball.radius 1 bezier", "syntax 21 bezier", "bezier needs its two control points"},
           {"at 5f ball.radius 1 bezier(2 0 0 1)", "range 27 (2",
            "the x of a bezier's control points must be from 0 to 1"},
           {"at 5f ball.radius 1 smooth(2)", "syntax 27 (", "'smooth' takes no brackets"},
           {"at 5f ball.radius 1 ease-in=-2f", "range 21 ease-in=-2f", "an ease must not be negative"},
           {"at 5f ball.radius 1 ease-in 2f", "syntax 29 2f", "'=' is missing after ease-in"},
           {"at 5f ball.radius 1 ease-in=2", "type 29 2", "a length of time needs a unit", "write 2f for frames"},
           {"at 5f ball.radius keep", "syntax 23", "'keep' needs a twerper, as in keep linear"},
           {"at 5f ball.color red tangent=1", "type 22 tangent", "a colour has no tangents"},
           {"at 5f note first", "syntax 12 first"},
           {"note \"a\"", "syntax 6 \"", "a note needs a time"},
           {"at 5f look at ball", "syntax 12 at", "'through' is missing here"},
           {"at 5f look through ball", "type 20 ball", "'ball' is a sphere, not a camera"},
           {"at 5f show bal", "name 12 bal", {}, "did you mean 'ball'?"},
           {"twerper ball.radius soft", "name 21 soft"},
           {"twerper ball.radius linear in=srgb", "type 28 in",
            "only colours can blend in light or srgb; this is a number"},
           {"extend ball.radius hodl", "type 20 hodl",
            "a track must be extended by hold, linear, cycle or bounce, not 'hodl'", "did you mean 'hold'?"},
           {"extend ball.radius cycle during", "syntax 26 during"},
       })
    expect_case(k);
}

// What a refused line would have made is missed below it; that is said once, by that line.
TEST(Errors, OfOutlinesAndLines) {
  for (const Case& k : std::vector<Case>{
           {"create r rectangle fill=2", "type 25 2"},
           {"create r rectangle fill=red", "type 25 red"},
           {"create r rectangle fill", "syntax 20 fill"},
           {"create r rectangle stroke=glod", "name 27 glod", {}, "did you mean 'gold'?"},
           {"create r rectangle stroke=2f", "type 27 2f", "expected a colour here, not a number"},
           {"create r rectangle color=none", "name 26 none"},
           {"create r rectangle stroke.r=none", "syntax 29 none"},
           {"create r rectangle stroke-width=-1", "range 33 -1"},
           {"create r rectangle stroke-width=2deg", "type 33 2deg"},
           {"create r rectangle stroke-width=1e13", "range 33 1e13"},
           {"create r rectangle dash=1", "type 25 1", {}, "write (1 1)"},
           {"create r rectangle dash=(1)", "type 25 (1)"},
           {"create r rectangle dash=(1 2 3)", "type 30 3"},
           {"create r rectangle dash=(-1 2)", "range 25 (-1 2)"},
           {"create r rectangle dash=(1s 2)", "type 27 s", "the unit 's' does not fit here"},
           {"create r rectangle trim=(0 1.01)", "range 25 (0 1.01)"},
           {"create r rectangle trim=(-0.1 1)", "range 25 (-0.1 1)"},
           {"create r rectangle trim=(0 1m)", "type 29 m"},
           {"create r rectangle trim=(0 nan)", "syntax 28 nan"},
           {"create r rectangle holes=((0 0) (1 0) (1 1))", "name 20 holes"},
           {"create p polygon holes=1", "syntax 24 1", "an opening bracket '(' is missing here"},
           {"create p polygon holes=(1 2)", "syntax 25 1", "expected a point (x y) or (x y z) here"},
           {"create p polygon holes=((1 2) ((1 2)))", "syntax 35 2", "a closing bracket ')' is missing before '2'"},
           {"create p polygon holes=(((1 2) (3 4)) (1 2))", "syntax 40 1"},
           {"create p polygon holes=(((1 2 3 4)))", "syntax 26 (1 2 3 ", "a point must have two or three numbers"},
           {"create p polygon holes=(((1 2))", "syntax 24 ("},
           {"create l line to=3", "type 18 3"},
           {"create l line to=(1)", "type 18 (1)"},
           {"create l line width=-1", "range 21 -1"},
           {"create l line stroke=red", "name 15 stroke"},
           {"create l line fill=off", "name 15 fill"},
           {"create s sphere stroke=red", "name 17 stroke"},
           {"create s box trim=(0 1)", "name 14 trim"}})
    expect_case(k);
}

TEST(Errors, OfARefusedLineAreSaidOnce) {
  EXPECT_EQ(all_told(read(
                "create ball sphre\nset ball.radius 2\nball.position\n  1f (0 0 0)\nattach ball to ball\n"
                "create twin like ball\nset twin.radius 1\ncreate {a,b} box size=2\nhide b\nlayer up\n"
                "on up at 3f hide ball\nset bal.radius 3\nprocedure p lua \"(\"\nalias all = \nset all.radius 1\n")),
            (std::vector<std::string>{"name 1:13 sphre", "type 8:23 2", "syntax 10:9", "name 12:5 bal",
                                      "syntax 13:17 \"(\""}));
  // What was there already stays; a later line that makes it ends the matter.
  EXPECT_EQ(all_told(read("create ball sphre\nset ball.radius 1\ncreate ball sphere\nset ball.radus 1\n")),
            (std::vector<std::string>{"name 1:13 sphre", "name 4:10 radus"}));
}

// Tools replace the marked place by this word, without reading the hint.
TEST(Errors, CorrectionsAreFields) {
  for (const auto& [line, instead] : std::vector<std::pair<std::string, std::string>>{
           {"crate b sphere", "create"},
           {"background glod", "gold"},
           {"set ball.radios 1", "radius"},
           {"set bal.radius 1", "ball"},
           {"at 5f ball.radius 1 liner", "linear"},
           {"create b sphere radius=-1", ""},
           {"set ball.position 1", ""},
       }) {
    const Loaded l = read(std::string(head) + line + "\n");
    ASSERT_EQ(l.diagnostics.size(), 1u) << line;
    EXPECT_EQ(l.diagnostics[0].what.instead, instead) << line;
  }
}

// shows: G94
TEST(Errors, Operations) {
  for (const Case& k : std::vector<Case>{
           {"copy ball.position.x 1f..5f", "syntax 28", "'to' and a time are missing here"},
           {"copy ball.position.x 1f to 5f", "syntax 22 1f", "a segment needs its end", "write 1f..END, as in 1f..24f"},
           {"copy ball.position.x 5f..1f to 9f", "range 22 5f..1f", "this segment ends before it begins"},
           {"copy ball.position.x 1f..5f to 9f times 0", "range 41 0",
            "times must be a whole number from 1 to 1000000"},
           {"copy ball.position.x 1f..5f to 9f on ball.color", "type 38 ball.color",
            "a number cannot be copied onto a colour"},
           {"copy ball.position.x 1f..5f to 9f shift (1 2 3)", "type 41 (", "expected a number here, not a vector"},
           {"copy ball.position.x 1f..5f to 9f twice", "syntax 35 twice", {}, "write on TARGET"},
           {"copy word.text 1f..5f to 9f shift \"a\"", "type 35 \"a\"", "a text cannot be shifted"},
           {"move ball.position.x 1f..5f", "syntax 28", "'by' and a length of time are missing here"},
           {"move ball.position.x 1f..5f by 4600000000s", "range 6 ball.position.x",
            "the events would be more than 146 years away"},
           {"stretch ball.position.x 1f..5f by 0", "range 35 0",
            "the factor must be greater than 0; to play backwards, use 'reverse'"},
           {"scale ball.position.x 1f..5f (1 2 3)", "type 30 (", "expected one number here: the target is a number"},
           {"scale ball.position.x 1f..5f 1e308", "range 7 ball.position.x",
            "a value would be too large if it were scaled by this"},
           {"rotate ball.position.x 1f..5f 90deg y", "type 8 ball.position.x",
            "only vectors, points and orientations can be rotated; this is a number"},
           {"rotate turn.rotation 1f..5f 90 y", "type 29 90"},
           {"rotate turn.rotation 1f..5f 90deg q", "syntax 35 q", "an axis is missing here", "axes are x, y, z"},
           {"clear ball.position.x 5f..1f", "range 23 5f..1f"},
           {"stagger b*.position by 2", "type 24 2"},
           {"spread b*.position from (0 0 0)", "syntax 32", "'to' and a value are missing here"},
           {"spread b*.display from on to off", "type 8 b*.display", "on or off cannot be spread"},
           {"use \"none.bx\"", "file 5 \"none.bx\"", "there is no file 'none.bx'"},
           {"use \"../x.bx\"", "file 5 \"../x.bx\"", "'../x.bx' is outside the script's folder", "--read-anywhere"},
       })
    expect_case(k);
}

// What later versions bring is refused in words.
TEST(Errors, OfWordsThatAreTheShells) {
  for (const Case& k : std::vector<Case>{
           {"undo", "name 1 undo", "'undo' is a shell command; a script does not need it"},
           {"play", "name 1 play"},
       })
    expect_case(k);
}

// shows: C79 C85 C98
TEST(Errors, OfEnvironments) {
  for (const Case& k : std::vector<Case>{
           {"animate", "syntax 8", "the name of an environment is missing here"},
           {"animate spin by rotate(1deg, z)", "syntax 14 by", "'every' and a length of time are missing here"},
           {"animate spin every 1.5t by rotate(1deg, z)", "range 20 1.5t", "expected a whole number of ticks here",
            "the nearest are 1t and 2t"},
           {"animate spin every 0t by rotate(1deg, z)", "range 20 0t", "an interval must be at least one tick"},
           {"animate spin every 1t", "syntax 22", "'by' and a transform are missing here"},
           {"animate spin every 1t by", "syntax 25", "expected a transform here"},
           {"animate spin every 1t by rotat(1deg, z)", "syntax 26 rotat", {}, "did you mean 'rotate'?"},
           {"animate spin every 1t by rotate(90, z)", "type 33 90"},
           {"animate spin every 1t by rotate(9deg)", "syntax 37 )"},
           {"animate spin every 1t by matrix(1 0 0 0 0 1 0 0 0 0 1 0 1 0 0 1)",
            "range 33 1 0 0 0 0 1 0 0 0 0 1 0 1 0 0 1", "the last row of a matrix must be 0 0 0 1"},
           {"animate spin every 1t by translate(1 2)", "type 35 (1 2)"},
           {"animate spin every 1t by scale(2) slowr 1t per 1s", "syntax 35 slowr", {}, "did you mean 'slower'?"},
           {"animate spin every 1t by scale(2) slower 1t", "syntax 44", "'per' and a length of time are missing here"},
           {"animate spin every 5t by scale(2) slower 1t per 1s faster 1t per 1s", "syntax 52 faster 1t per 1s",
            "an interval cannot become both slower and faster"},
           {"animate spin every 1t by scale(2) slower 0t per 1s", "range 35 slower 0t per 1s",
            "an interval must change by at least one tick"},
           {"animate spin every 1t by scale(2) from 9t until 3t", "range 9 spin",
            "'spin': an environment must halt after it starts: until 3t is not after from 9t"},
           {"animate ball every 1t by scale(2)", "name 9 ball", "'ball' is a sphere, not an environment"},
           {"halt spin", "name 6 spin", "there is no environment 'spin'"},
           {"at 3t kill ball", "name 12 ball", "'ball' is not an environment"},
           {"create spin environment", "name 13 environment", "create cannot make an environment"},
           {"set ball.environments (1x)", "syntax 24 1x"},
           {"set ball.transform 3", "syntax 20 3"},
           {"at 1f ball.transform = 1", "syntax 24 1", "expected code in quotes after '='"},
       })
    expect_case(k);
}

// shows: G27 G65 G81
TEST(Errors, OfAttachmentsVelocitiesLayersFiltersAndProcedures) {
  for (const Case& k : std::vector<Case>{
           {"hang ball to car", "syntax 11 to", "'on' is missing here"},
           {"attach ball on car", "syntax 13 on"},
           {"attach ball to ball", "name 8 ball"},
           {"letgo ball", "syntax 7 ball", "letgo needs a time", "as in at 60f letgo ball"},
           {"set ball.attachment car", "type 5 ball.attachment", "an attachment cannot be set"},
           {"at 5f ball.attachment 5", "type 23 5"},
           {"at 5f ball.display.velocity on", "type 12 display", "display has no velocity: it is on or off"},
           {"set ball.position.velocity (1 0 0)", "type 5 ball.position.velocity", "a velocity needs a time"},
           {"at 5f ball.rotation.velocity quat(1 0 0 0)", "type 30 quat",
            "expected an angular velocity here, not an orientation"},
           {"at 5f ball.position.velocity = 5", "syntax 32 5", "expected code in quotes after '='"},
           {"layer wave", "syntax 11", "add or mix is missing here"},
           {"layer ball add", "name 7 ball"},
           {"create wave layer", "name 13 layer", "create cannot make a layer", "to make one: layer wave add"},
           {"on ball set ball.radius 1", "type 4 ball", "'ball' is not a layer"},
           {"filter ball.position smoth", "name 22 smoth", "there is no filter 'smoth'", "did you mean 'smooth'?"},
           {"filter ball.position smooth of", "syntax 29 of", "'of' is not expected here",
            "write key=value, a segment A..B, or off"},
           {"filter ball.position smooth off=on", "syntax 29 off=", "'off' has no value", "write the word alone: off"},
           {"filter ball.position none off", "syntax 27 off", "'off' is not expected here",
            "write key=value, a segment A..B, or off"},
           {"filter ball.position smooth wdth=1s", "name 29 wdth", "'smooth' has no 'wdth'", "did you mean 'width'?"},
           {"filter ball.position.velocity smooth", "type 8 ball.position.velocity",
            "a velocity cannot have filters; a value can"},
           {"procedure f \"1\"", "syntax 13 \"", "'lua' is missing here"},
           {"procedure f stepz lua \"1\"", "syntax 13 stepz", "a procedure cannot have the word 'stepz' here"},
           {"procedure f steps evry 2f lua \"1\"", "syntax 19 evry", "a procedure cannot have the word 'evry' here"},
           {"procedure f steps every 0f lua \"1\"", "range 19 every 0f", "an interval must be longer than 0"},
           {"procedure set lua \"1\"", "name 11 set", "'set' is already a command"},
           {"procedure linear twerper lua \"u\"", "name 11 linear"},
           {"fall ball", "syntax 6 ball", "fall needs a time", "as in at 24f fall ball"},
           {"at 5f fall ball gravity=0", "range 17 gravity=0", "gravity must be greater than 0"},
           {"dial fader to ball.radius", "syntax 6 fader", "an address must begin with '/'"},
           {"dial /a to ball.display.velocity", "type 17 display"},
           {"record maybe", "type 8 maybe", "recording must be on or off"},
       })
    expect_case(k);
}

// What newcomers write, and the way out that they are told.
TEST(Errors, HintsForWhatOtherToolsTaught) {
  for (const Case& k : std::vector<Case>{
           {"set ball.color = red", "syntax 18 red", "expected code in quotes after '='",
            "write a plain value without '=': red"},
           {"set ball.radius \"2\"", "type 17 \"", "expected a number here, not a text", "write it without quotes"},
           {"set ball.shininess 50%", "type 20 50", "expected a number from 0 to 1 here, not a percentage",
            "write 0.5"},
           {"create s sphere radius:2", "syntax 17 radius:2", {}, "write radius=2"},
           {"create s sphere at (0 0 0)", "syntax 17 at", {}, "write the place as position=(0 0 0)"},
           {"at 20f ball.position release", "type 22 release", "'release' needs a velocity",
            "as in at 20f ball.position.velocity release"},
           {"at 20f word.text \"b\" linear", "type 22 linear",
            "'linear' cannot blend a text: it changes only at its events",
            "to morph letters, use geometry: at 24f A.geometry shape(B)"},
           {"mirror ball.position", "name 1 mirror", {}, "scale mirrors: scale ball.position 1f..24f"},
           {"rename b* c", "syntax 8 b*", "only one object can be renamed, not a pattern", "as in rename ball planet"},
           {"rename ball all", "name 13 all", "'all' is already an alias"},
           {"create all sphere", "name 8 all"},
           {"remove b[al", "syntax 8 b[al", "the bracket in 'b[al' is not closed"},
           {"set b[al.radius 2", "syntax 5 b[al"},
           {"alias x = b[al", "syntax 11 b[al"},
           {"on swey ball.position", "name 4 swey", "there is no layer 'swey'", "to make one: layer swey add"},
       })
    expect_case(k);
  EXPECT_EQ(all_told(read("create ball sphere\nlayer sway add\non swey ball.position\n  1f (0 0 0)\n  2f (1 0 0)\n")),
            (std::vector<std::string>{"name 3:4 swey"}));
  EXPECT_EQ(
      all_told(read("create ball sphere\nlayer sway add\non sway ball.positon\n  1f (0 0 0)\nset ball.radius x\n")),
      (std::vector<std::string>{"name 3:14 positon", "syntax 5:17 x"}));
  EXPECT_EQ(all_told(read("create a sphere\nprocedure loud filter lua \"input() * my_gain\"\n"
                          "filter a.radius loud my-gain=2\nfilter a.radius loud my-gian=2\n")),
            (std::vector<std::string>{"name 4:22 my-gian"}));
}

TEST(Errors, WhatWouldFillTheMachineIsRefused) {
  const std::string head_of_all = "create b{1..100} sphere\nb1.radius\n  1f 1\n  2f 2\n";
  EXPECT_EQ(all_told(read(head_of_all + "copy b1.radius 1f..2f to 2f on b*.radius times 100000\n")),
            (std::vector<std::string>{"range 5:6 b1.radius"}));
  EXPECT_EQ(all_told(read("create a{1..1000000} sphere\ncreate b sphere\n")),
            (std::vector<std::string>{"range 2:8 b"}));
}

// The words of what needs a film of its own; its code, place and subject are tested where the command is.
void expect_words(const std::string& film, const std::string& line, const std::string& message) {
  const Loaded l = read(film + line + "\n");
  EXPECT_TRUE(std::any_of(l.diagnostics.begin(), l.diagnostics.end(),
                          [&](const Diagnostic& d) { return d.what.message == message; }))
      << line << "\n"
      << message << "\n"
      << said(l.diagnostics);
}

TEST(Errors, WordsOfWhatNeedsAFilmOfItsOwn) {
  for (const auto& [film, message] : std::vector<std::pair<const char*, const char*>>{
           {"create a box\ncreate b box\nlayer up add\narrange", "the name of an object is missing here"},
           {"create road curve points=((0 0) (6 0))\ncreate a box\na.position\n  1f..9f along a",
            "'a' is a box; objects cannot move along it"},
           {"create road curve points=((0 0) (6 0))\ncreate a box\nroad.position\n  1f..9f along road",
            "'road' cannot move along itself"},
           {"create road curve points=((0 0) (6 0))\ncreate a box\na.position.x\n  1f..9f along road",
            "one component cannot follow a line; a whole position can"},
           {"create road curve points=((0 0) (6 0))\ncreate a box\na.scale\n  1f..9f along road",
            "scale cannot follow a line; a position can"},
           {"samples 4m", "expected a plain number here, without 'm'"},
           {"create road curve points=((0 0) (6 0))\ncreate a box\na.position\n  1f..1f along road",
            "a move along a line needs a segment longer than 0"},
           {"create road curve points=((0 0) (6 0))\ncreate a box\na.position.velocity\n  1f along road 0",
            "a velocity cannot follow a line; a position can"},
           {"create road curve points=((0 0) (6 0))\ncreate a box\nset a.position along road 1e9",
            "the share of a line must be from -1000000 to 1000000"},
           {"size", "a size is missing here"},
           {"size 1920", "'1920' is not a size: expected WIDTHxHEIGHT, each from 1 to 8192"},
           {"samples 5", "the number of samples must be 1, 4, 9, 16 or auto, not '5'"},
           {"ground material=grass", "the ground has a color and no material"},
           {"ground asphalt", "the ground has a color and no material"},
           {"sky night", "a sky must be on, off, studio, day, overcast, sunset or a \"FILE\""},
           {"film", "a film must be flat or solid"},
           {"fog", "a colour is missing here"},
           {"exposure 21", "an exposure must be from -20 to 20"},
           {"fog white", "'from' and a distance are missing here"},
           {"fog white from 3 to 3", "the fog ends before it begins"},
           {"fog white from -1 to 3", "a distance must be from 0 to 1e12 m"},
           {"sky", "a sky must be on, off, studio, day, overcast, sunset or a \"FILE\""},
           {"contact", "contact shading must be on or off"},
           {"create a box\ncreate b box\nlayer up add\narrange a", "'in' is missing here"},
           {"create a box\ncreate b box\nlayer up add\narrange a in",
            "the arrangement must be row, column, grid or circle"},
           {"create a box\ncreate b box\nlayer up add\narrange a in row columns=2",
            "arrange … in row has no 'columns'"},
           {"create a box\ncreate b box\nlayer up add\narrange a in circle radius=-1",
            "the radius must be greater than 0"},
           {"create a box\ncreate b box\nlayer up add\nplace a", "'next-to' is missing here"},
           {"create a box\ncreate b box\nlayer up add\nplace a next-to a", "'a' cannot be placed next to itself"},
           {"create a box\ncreate b box\nlayer up add\nplace a next-to up", "objects cannot be placed next to a layer"},
           {"create a box\ncreate b box\nlayer up add\nplace a next-to b side=left align=right",
            "an object at the left side cannot be aligned to the right"},
           {"create a box\ncreate b box\nlayer up add\nplace a next-to b size=2", "place … next-to has no 'size'"},
           {"create a box\nframe a", "the film has no camera yet"},
           {"create a box\ncreate e camera\nframe a margin=-1", "a margin must be from 0 to 100"},
           {"create a sphere\ncreate b sphere\ncreate c sphere\nat 1f couple a to b\nat 5f hang b on c\nat 9f attach c "
            "to a",
            "this would make a cycle: c → b → a → c"},
           {"create a sphere\nlayer up add\non up set a.radius 1\nbake a.position 1f..9f every 0f",
            "an interval must be longer than 0"},
           {"create a sphere\nlayer up add\non up set a.radius 1\nbake a.position 1f..9f within -1",
            "a tolerance must be at least 0"},
           {"create a sphere\nlayer up add\non up set a.radius 1\nbake a.position 1f..9f every 1e-8s",
            "this would read more than 1000000 values"},
           {"create a sphere\nlayer up add\non up set a.radius 1\nbake a.position.x 1f..9f",
            "components and velocities cannot be baked; whole values can"},
           {"create a sphere\nlayer up add\non up set a.radius 1\nbake a.radius 1f..9f",
            "the layer up is on top of a.radius and would count twice"},
           {"create a sphere\nlayer up add\non up set a.radius 1\nbake a.attachment 1f..9f",
            "an attachment cannot be baked"},
           {"animate a/b every 1t by translate(1 0 0)\nmake b\n  point (0 0)\nrename b a",
            "the display list 'a' may need the name of the object 'a/b'"},
           {"make a\n  polygon (0 0) (1 0)", "expected at least 3 points here, not 2"},
           {"make a\n  point", "a point (x y) or (x y z) is missing here"},
           {"make a\n  pop", "this 'pop' has no 'push' before it"},
           {"make a\n  call a", "'a' cannot call itself"},
           {"make a\n  spin", "there is no row 'spin' in display lists"},
           {"make a\n  replace x", "there is no tag 'x' in 'a'"},
           {"make a\n  tag x\n  tag x", "the tag 'x' already exists in 'a'"},
           {"make a\n  view from (0 0) to (0 0)", "a view needs two different points"},
           {"make a\n  orthographic 0", "this must be greater than 0"},
           {"make a\nmake a", "a display list 'a' already exists"},
           {"make a\ncreate a/b group", "names that begin with 'a/' are reserved for the objects of that display list"},
           {"edit star", "there is no display list 'star'"},
           {"create b group\nmake a\n  call b", "'b' is an object of the film, not a display list"},
           {"make\n  point (0 0)", "the name of the new display list is missing here"},
           {"create b box\nb.rotation\n  1f axis(x, 50deg) hermite tangent=(1 2 3)",
            "the tangent of an orientation must be an angular velocity or quat(…)"},
           {"create b box\nb.rotation\n  1f euler(0 0 0) hermite tangent=axis(y, 90deg)",
            "the tangent of angles must be angles"},
           {"create g group\ncreate b box\nset g.geometry shape(b)", "'g' is a group, which has no visible geometry"},
           {"create b sphere\nb.position\n  1f (0 0 0)\nfilter b.position wobble amount=0.1 frequency=3f",
            "frequency must be a plain number, without a unit"},
           {"create a{1..3} box\na*.scale\n  1f (1 1 1)\nstagger a*.scale by 2f from midle",
            "the order must be first, last, centre, edges or random N"},
           {"create a{1..3} box\na*.scale\n  1f (1 1 1)\nstagger a*.scale by 2f per 0m from (0 0 0)",
            "the distance must be greater than 0"},
           {"create a{1..3} box\na*.scale\n  1f (1 1 1)\nstagger a*.scale by 2f per 1m",
            "'from' and a point or an object are missing here"},
           {"create b sphere\ncreate eye camera\nlayer over mix\non over at 5f look through eye",
            "'look' cannot be used on a layer"},
           {"create a sphere\nlayer up add\nlayer up add", "a layer 'up' already exists"},
           {"create a sphere\nlayer up add\nlayer down sum", "the mode of a layer must be add or mix"},
           {"create a sphere\nlayer up add\nfilter a.display noise", "'noise' cannot filter on or off"},
           {"create a sphere\na.motion\n  1f..24f", "expected a motion here"},
           {"create a sphere\na.motion\n  24f..24f T(1 0)", "a motion needs a segment longer than 0"},
           {"create a sphere\na.motion\n  1f..24f T(1 0)\n  12f..36f T(1 0)",
            "'a.motion' is already in motion from 1f by T(1 0)"},
           {"create m box\nset m.motion = \"'m'\"", "a motion cannot be set: it needs a segment of time"},
           {"create m text\nset m.tex = \"'m'\"", "tex cannot be computed"},
           {"create a sphere\na.position\n  1f..24f (0 0 0)",
            "expected one time here; only motions and moves along a line take a segment"},
           {"create a sphere\nset a.motion T(1 0)", "a motion cannot be set: it needs a segment of time"},
           {"create a sphere\nlayer up add\non up a.motion\n  1f..3f T(1 0)",
            "a layer cannot have a motion: motions are always added to the tracks"},
           {"create a sphere\na.motion\n  1f..24f T(1 0)\nreverse a.motion 1f..24f", "a motion cannot be reversed"},
           {"animate spin every 1t by rotate(3deg, z)\ncreate ball sphere\ncouple ball to spin",
            "'spin' is an environment, so it cannot be a parent"},
           {"animate spin every 1t by rotate(3deg, z)\ncreate ball sphere\nset ball.transform rotate 90deg z",
            "an opening bracket '(' is missing after 'rotate'"},
           {"at 5f note \"b\"\nstretch notes 1f..9f by 1e300", "the notes would be more than 146 years away"},
           {"at 5f note \"b\"\ncopy notes 5f..5f to 9f times 1000000", "a film can have at most 1000000 notes"},
           {"load swirl.so", "'load' is not a script command: a script may not start programs such as plug-ins"},
           {"create a text text=\"\"\"open\ncreate b sphere", "this text is never closed by \"\"\""},
           {"create a sphere\na.radius\n  12f 1\na.radius\n  +12f 1", "a time with '+' needs a row above it"},
           {"create a sphere\nset a.{radius,position} 2",
            "these functions have different types: radius is a number, position is a vector"},
           {"create t text text=\"ab\"\nsplit t", "'into' is missing here"},
           {"create t text text=\"ab\"\nsplit t into", "a text can be split into letters, words or lines"},
           {"create b box\nsplit b into letters", "'b' is a box; only texts can be split"},
           {"create t text text=\" \\n\"\nsplit t into lines", "'t' has no letters that could be split"},
           {"create a sphere\ncreate b box\nat 1f attach a to b\nextend a.attachment cycle",
            "an attachment cannot be extended by cycle"},
           {"create b sphere\nb.radius\n  1f 1\n  9f 2\nset b.radius 3",
            "this track has events from the beginning, so 'set' has no effect"},
           {"create b sphere\nb.position.x\n  1f 0 linear()",
            "linear needs at least two stops in its brackets, or no brackets"},
           {"create b sphere\nb.position.x\n  1f 0 linear(25% 1)", "write the percentage after its stop"},
           {"create b sphere\nb.position.x\n  1f 0 linear(0 10% 20% 30% 1)", "a stop can have at most two percentages"},
           {"create b sphere\nb.position.x\n  1f 0 linear(0 50% 0.5 20% 1)",
            "the percentages of stops must not go back: 20% is after 50%"},
           {"create b sphere\nb.position.x\n  1f 0 linear(0 2f 1)", "a stop must be a plain number, without 'f'"},
           {"create b sphere\nb.position.x\n  1f 0 linear(0 2000000 1)", "a stop must be from -1000000 to 1000000"},
           {"create b sphere\nb.position.x\n  1f 0 linear(0 1 2000000%)",
            "the time of a stop must be from -1000000% to 1000000%"},
           {"create b sphere\nb.position.x\n  1f 0 fcurve handle-out=4f",
            "handle-out must be a length of time and a difference of value"},
           {"create b sphere\nb.position.x\n  1f 0 fcurve handle-in=(-4f 1)", "a handle must not be negative"},
           {"create c box\nc.color\n  1f red fcurve handle-in=(4f red)", "a colour has no handles"},
           {"create c box\nc.rotation\n  1f axis(x, 1deg) fcurve handle-in=(4f (0 0 0))",
            "an orientation has no handles"},
           {"create c box\nc.rotation\n  1f (0 0 0) fcurve handle-in=(4f axis(x, 1deg))",
            "the handle of angles must be angles"},
           {"create b box\nset b.position = \"vec(1, 2)\"\nset b.position.x = \"t\"",
            "code computes the whole value, so its components cannot be set"},
           {"rate 24\ncreate a box position=(1 0 0)\ncreate b box position=(2 0 0)\nlayer sway add\non sway set "
            "b.attachment = \"'a'\"",
            "a layer cannot have attachments"},
           {"rate 24\ncreate a box position=(1 0 0)\ncreate b box position=(2 0 0)\nlayer sway add\ncreate c box "
            "attachment=\"'a'\"",
            "attachment is an attachment, not a text"},
           {"create b sphere\nb.radius\n  x 1", "a row must begin with a time, not with 'x'"},
           {"rate\x80", "this is not a text file: it is not UTF-8 (byte 0x80)"},
           {"make a\n  vector (0 0) (1 1)\nstart a\nset a/vector-1.color red",
            "'a/vector-1' belongs to a display list, so only its rows can change it"},
           {"set nobody*.color red", "nothing is named 'nobody*'"},
           {"use \"\"", "the name of a file is missing here"},
           {"create b box\nset b.rotation euler(0 0 3*2)", "expected an angle here, not a number"},
           {"create b box\nat 2*3 hide b", "expected a time here, not a number"},
           {"let a = 1\nlet a = 2", "'let a' already exists"},
           {"let again a = 2", "there is no 'let a' above this line"},
           {"let sin = 2", "'sin' already has a meaning in formulas"},
           {"let 2x = 2", "'2x' cannot be a name in formulas"},
           {"let a =", "a formula, a vector, a colour, a text or a list is missing here"},
           {"let a = [2 3 5 7]", "a list has round brackets, and blanks between its values"},
           {"let a = ;", "there is no colour ';'"},
           {"let beat = 12f\ncreate b sphere\nset b.radius = \"beat\"", "'beat' is in frames, but code counts seconds"},
           {"create l light\nset l.shadow softt", "shadow must be auto, on, off or soft"},
           {"create t text weight=0.5",
            "weight must be thin, extralight, light, regular, medium, semibold, bold, extrabold or black"},
           {"create {a,b} box\nplace a next-to b side=centre",
            "the side must be left, right, bottom, top, back, front"},
           {"procedure value lua \"1\"", "'value' is already a word of Lua code"}})
    expect_words("", film, message);
}

TEST(Errors, WordsOfWhatIsTooMuchOrNotUsed) {
  expect_words("create b{1..100} sphere\nb1.radius\n  1f 1\n  2f 2\n",
               "copy b1.radius 1f..2f to 2f on b*.radius times 100000",
               "the copies would have more than 10000000 events");
  expect_words("create a{1..1000000} sphere\n", "create b sphere", "a film can have at most 1000000 objects");
  expect_words("create a sphere\nprocedure loud filter lua \"input() * my_gain\"\n", "filter a.radius loud my-gian=2",
               "'loud' does not use 'my-gian'");
  expect_words("", "procedure p lua \"(\"", "unexpected symbol near <eof>");
}

TEST(Errors, Gradients) {
  constexpr const char* looks = "stops look like \"#f60, gold 40%, first/50%, transparent\"";
  const std::string many = "set ball.gradient-stops \"red" + [] {
    std::string all;
    for (int i = 0; i < 16; ++i) all += ",red";
    return all;
  }() + "\"";
  for (const Case& k : std::vector<Case>{
           {"set ball.gradient diamond", "type 19 diamond", "gradient must be none, linear, radial, circular or conic",
            ""},
           {"set ball.gradient-spread mirror", "type 26 mirror", "gradient-spread must be pad, repeat or reflect"},
           {"set ball.gradient-stops \"red\"", "range 26 red", "a gradient needs two stops or more", looks},
           {"set ball.gradient-stops \"red, gren\"", "name 31 gren", "there is no colour 'gren'",
            "did you mean 'green'?"},
           {"set ball.gradient-stops \"red, blue/2\"", "range 31 blue/2",
            "the opacity of a stop must be from 0 to 1, or 0% to 100%", looks},
           {"set ball.gradient-stops \"red,, blue\"", "syntax 30 ,", "a colour is missing between the commas", looks},
           {"set ball.gradient-stops \"#12345, blue\"", "syntax 26 #12345",
            "a hexadecimal colour of a stop must have 3, 4, 6 or 8 digits", looks},
           {"set ball.gradient-stops \"red 1%, red 101%\"", "range 34 red 101%",
            "the place of a stop must be from 0% to 100%", looks},
           {"set ball.gradient-stops \"red 60%, blue 40%\"", "range 35 blue 40%",
            "the places of stops must not go back"},
           {many.c_str(), "range 90 red", "a gradient can have at most 16 stops"},
           {"set ball.gradient-size 0", "range 24 0", "gradient-size must be at least 0.001"},
           {"set eye.gradient linear", "name 9 gradient"},
           {"set ball.stroke-gradient linear", "name 10 stroke-gradient"},
           {"set ball.color linear(red, blue)", "name 16 linear", "there is no colour 'linear'",
            "gradient=linear makes a gradient"}})
    expect_case(k);
}

TEST(Errors, WordsOfWhatCannotBeReached) {
  const std::string arm =
      "create arm group\ncreate arm/fore group position=(1 0 0)\ncreate arm/fore/palm sphere position=(1 0 0)\n"
      "create ball sphere position=(1 1 0)\ncreate leg{1..3} group\ncouple leg2 to leg1\ncouple leg3 to leg2\n";
  for (const auto& [line, message] : std::vector<std::pair<const char*, const char*>>{
           {"reach arm/fore/palm to arm/fore/palm", "'arm/fore/palm' cannot reach itself"},
           {"reach arm/fore/palm to arm", "'arm/fore/palm' cannot reach 'arm', because they move together"},
           {"reach ball to arm", "'ball' has no parents that could bend"},
           {"reach arm/fore to ball", "'arm/fore' has only 1 joint above it, but 2 must bend"},
           {"reach arm/fore/palm to ball chain=1", "a chain's number of joints must be a whole number from 2 to 64"},
           {"reach arm/fore/palm to ball from 9f until 9f", "a reach must end after it begins"},
           {"at 5f reach arm/fore/palm to ball from 9f",
            "'from' is not needed here: the reach begins at the time of the command"},
           {"reach arm/fore/palm to ball blend=5f", "a reach without times cannot be blended"},
           {"reach arm/fore/palm to ball from 5f blend=-5f", "a blend must not be negative"},
           {"reach leg3 to arm/fore/palm\nreach arm/fore/palm to leg3",
            "'arm/fore/palm' cannot reach 'leg3', because 'leg3' reaches an object that moves with 'arm/fore/palm'"}})
    expect_words(arm, line, message);
}

}  // namespace
}  // namespace betwixt
