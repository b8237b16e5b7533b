// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Every error: its place, its words, its caret, its suggestion; and that the command it is about has changed nothing.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr const char* head =
    "create ball sphere radius=2\ncreate eye camera\ncreate car group\nball.position.x\n  1f 1 linear\n  5f 5\nalias "
    "all = b*\n"
    "create word text text=\"a\"\ncreate turn box\nturn.rotation\n  1f axis(z, 90deg)\ncreate soft sphere\n";
constexpr int head_lines = 12;

struct Case {
  const char* line;
  int column;
  const char* message;
  const char* hint = nullptr;  // how it begins; null: any
};

void expect_case(const Case& k) {
  const Loaded good = read(head), bad = read(std::string(head) + k.line + "\n");
  const auto said_here = errors(bad);
  ASSERT_EQ(said_here.size(), 1u) << k.line << "\n" << said(bad.diagnostics);
  EXPECT_EQ(said_here[0], fmt::format("{}:{}: {}", head_lines + 1, k.column, k.message)) << k.line;
  const Diagnostic* error = nullptr;
  for (const Diagnostic& d : bad.diagnostics)
    if (d.severity == Severity::error) error = &d;
  if (k.hint) {
    EXPECT_TRUE(error->what.hint.starts_with(k.hint)) << k.line << "\n" << said(bad.diagnostics);
  }
  EXPECT_EQ(bad.document, good.document) << k.line << " has changed something";
}

TEST(Errors, Words) {
  for (const Case& k : std::vector<Case>{
           {"crate b sphere", 1, "there is no command 'crate'", "did you mean 'create'?"},
           {"ball", 1, "'ball' is an object, not a command", "a sheet opens with a target, as in ball.position"},
           {"wheels = w*", 1, "there is no command 'wheels'", "names for many objects are made by: alias wheels"},
           {"// words", 1, "a comment starts with '#' and a space", ""},
           {"set ball.position 1 0 2", 19, "a vector is wanted here, not one number", "write (1 0 2)"},
           {"#comment", 1, "a comment starts with '#' and a space"},
           {"(1 2 3)", 1, "a command begins with a verb, not with '('"},
           {"12f (1 2 3)", 1, "this looks like a row, but no sheet is open", "rows are indented"},
           {"rate", 5, "a number is missing here", "usage: rate N"},
           {"rate fast", 6, "'fast' is not a number"},
           {"rate 0", 6, "frames per second are from 0.0001 to 100000"},
           {"rate 24 25", 9, "'25' is not expected here", "usage: rate N"},
           {"rate nan", 6, "'nan' is not a number"},
           {"range 1f", 9, "a time is missing here"},
           {"range 9f 1f", 7, "the range ends before it begins"},
           {"ticks inf", 7, "'inf' is not a number"},
           {"background glod", 12, "there is no colour 'glod'", "did you mean 'gold'?"},
           {"delete ball", 8, "'ball' is a sphere, not a display list", "remove ball takes the object out"},
           {"notes maybe", 7, "notes are on or off"},
           {"policy translat", 8, "the policy is translate, ignore or ask", "did you mean 'translate'?"},
           {"create", 7, "a name is missing here"},
           {"create 2b sphere", 8, "'2b' cannot be a name", "a name starts with a letter"},
           {"create ball sphere", 8, "there is a 'ball' already"},
           {"create b", 9, "a kind is missing here"},
           {"create b spere", 10, "there is no kind 'spere'", "did you mean 'sphere'?"},
           {"create b sphere radios=1", 17, "a sphere has no 'radios'", "did you mean 'radius'?"},
           {"create b sphere radius", 17, "'radius' needs a value"},
           {"create b sphere radius=", 24, "a number is missing here"},
           {"create b sphere radius=-1", 24, "radius is at least 0"},
           {"create b sphere radius=1e400", 24, "'1e400' is too large for a number"},
           {"create b sphere radius=nan", 24, "'nan' is not a number"},
           {"create b sphere position=(1 2)", 26, "3 numbers are wanted here, not 2"},
           {"create b sphere position=(1 2 3 4)", 33, "only 3 numbers are wanted here"},
           {"create b sphere color=#ffcc0", 23, "a colour in hexadecimal has 3 or 6 digits, as in #ffcc00"},
           {"create b sphere shininess=2", 27, "shininess is at most 1"},
           {"create b camera lens=3q", 22, "'q' is not a unit of length", "units are m, cm and mm"},
           {"create b camera fov=50", 21, "an angle needs a unit", "write 50deg; units are deg, rad and turn"},
           {"create b camera fov=50grad", 23, "'grad' is not a unit of angles", "units are deg, rad and turn"},
           {"create b light shines=moon", 23, "shines is point or sun"},
           {"create b text text=hello", 20, "a text in double quotes is missing here"},
           {"create b text text=\"hello", 20, "this text is not closed on its line"},
           {"create b text text=\"a\\q\"", 22, "'\\q' means nothing in a text"},
           {"create b mesh", 10, "a mesh needs its file"},
           {"create b mesh file=\"none.obj\"", 20, "there is no file none.obj"},
           {"create b like bal", 15, "there is no object 'bal'", "did you mean 'ball'?"},
           {"create bus/wheel sphere", 8, "there is no 'bus' that 'bus/wheel' could belong to", "create bus first"},
           {"create b{1..99999999} sphere", 8, "'{1..99999999}' makes more than 1000000 names"},
           {"create b{1,1} sphere", 8, "'b1' would be made twice"},
           {"create b{1 sphere", 8, "the brace in 'b{1 sphere' is not closed"},
           {"remove bal", 8, "there is no object 'bal'", "did you mean 'ball'?"},
           {"rename ball eye", 13, "there is a 'eye' already"},
           {"rename ball", 12, "the new name is missing here"},
           {"couple ball to ball", 8, "'ball' cannot be coupled to itself"},
           {"couple ball car", 13, "'to' is missing here", "usage: couple A to B [keep-world]"},
           {"detach bus", 8, "there is no object 'bus'"},
           {"define radius number", 8, "there is a function 'radius' already"},
           {"define heat temperature", 13, "there is no type 'temperature'", "types are number"},
           {"define heat number hot", 20, "'hot' is not a number"},
           {"alias = b", 7, "a name is missing here"},
           {"alias a b", 9, "'=' is missing here"},
           {"alias a = (b)", 11, "names and patterns are wanted here"},
       })
    expect_case(k);
}

TEST(Errors, ValuesAndEvents) {
  for (const Case& k : std::vector<Case>{
           {"set ball.radios 1", 10, "'ball', a sphere, has no function 'radios'", "did you mean 'radius'?"},
           {"set bal.radius 1", 5, "there is no object 'bal'", "did you mean 'ball'?"},
           {"set ball 1", 5, "'ball' is not a target", "a target is an object and a function"},
           {"set ball.position", 18, "a vector (x y z) is missing here"},
           {"set ball.position 1", 19, "a vector is wanted here, not one number", "write (1 1 1)"},
           {"set ball.position red", 19, "a vector (x y z) is wanted here"},
           {"set ball.position (1 2 inf)", 24, "'inf' is not a number"},
           {"set ball.position (1 2 3", 19, "this bracket is never closed"},
           {"set ball.position.w 1", 19, "position has no component 'w'", "components are x, y and z"},
           {"set ball.radius.x 1", 17, "radius has no components: it is a number"},
           {"set ball.world 1", 10, "'world' can be asked for, not set"},
           {"set ball.display yes", 18, "on or off is wanted here"},
           {"set ball.rotation 90deg", 19, "'90deg' is not a rotation", "rotations look like euler"},
           {"set ball.rotation euler(0 90 0)", 27, "an angle needs a unit", "write 90deg"},
           {"set ball.rotation axis(0 0 0, 90deg)", 24, "an axis needs a direction; 0 0 0 has none"},
           {"set ball.rotation quat(0 0 0 0)", 19, "this quaternion has no direction"},
           {"set ball.rotation euler 1", 19, "'euler' needs its numbers in brackets"},
           {"set ball.geometry eye", 19, "a shape is wanted here", "write shape(NAME)"},
           {"set ball.geometry shape(eye)", 25, "a camera has no geometry"},
           {"set ball.geometry shape(bus)", 25, "there is no object 'bus'"},
           {"set eye.look-at bal", 17, "there is no object 'bal'", "did you mean 'ball'?"},
           {"set word.text 5", 15, "a text in double quotes is missing here"},
           {"set ball.radius 5 linear", 19, "'linear' is not expected here"},
           {"set ball.radius 5kg", 17, "'kg' is not a unit of length"},
           {"at", 3, "a time is missing here"},
           {"at 5 ball.radius 1", 4, "a time needs a unit", "write 5f for a frame number"},
           {"at 5x ball.radius 1", 5, "'x' is not a unit of time", "units are f"},
           {"at 5f", 6, "a target or a command is missing here"},
           {"at 5f ball", 7, "a target or a command is wanted here, not 'ball'"},
           {"at 5f rate 24", 7, "'rate' has no time: it holds for the whole film"},
           {"at 5f set", 10, "a target is missing here"},
           {"at 5f set ball", 11, "'ball' is not a target", "a target is an object and a function"},
           {"at 5f ball.radius 1 ease=4f", 21, "there is no option 'ease'", "behind an event's value, ease-in=4f"},
           {"set ball.opacity 1", 10, "'ball', a sphere, has no function 'opacity'", "transparency goes the other way"},
           {"set ball.colour red", 10, "'ball', a sphere, has no function 'colour'", "did you mean 'color'?"},
           {"create b cube", 10, "there is no kind 'cube'", "box is one"},
           {"loop ball.position", 1, "there is no command 'loop'", "extend ball.position cycle repeats a track"},
           {"at 5f at 6f note \"a\"", 7, "'at' has no time: it holds for the whole film"},
           {"at 5f ball.radius", 18, "a number is missing here"},
           {"at 5f ball.radius 1 liner", 21, "there is no twerper 'liner'", "did you mean 'linear'?"},
           {"at 5f ball.radius 1 linear hold", 28, "'hold' is not expected here: this event has its twerper"},
           {"at 5f ball.radius 1 slerp", 21, "'slerp' turns orientations; this is a number"},
           {"at 5f ball.radius 1 bezier", 21, "bezier needs its two control points"},
           {"at 5f ball.radius 1 bezier(2 0 0 1)", 27, "the x of a bezier's control points is from 0 to 1"},
           {"at 5f ball.radius 1 smooth(2)", 27, "'smooth' takes nothing in brackets"},
           {"at 5f ball.radius 1 ease-in=-2f", 21, "an ease cannot be shorter than nothing"},
           {"at 5f ball.radius 1 ease-in 2f", 29, "'=' is missing behind ease-in"},
           {"at 5f ball.radius 1 ease-in=2", 29, "a length of time needs a unit", "write 2f for frames"},
           {"at 5f ball.radius keep", 23, "keep needs a twerper, as in keep linear"},
           {"at 5f ball.color red tangent=1", 22, "a colour has no tangents"},
           {"at 5f note first", 12, "a text in double quotes is missing here"},
           {"note \"a\"", 6, "a note needs a time"},
           {"at 5f look at ball", 12, "'through' is missing here"},
           {"at 5f look through ball", 20, "'ball' is a sphere, not a camera"},
           {"at 5f show bal", 12, "there is no object 'bal'", "did you mean 'ball'?"},
           {"twerper ball.radius soft", 21, "there is no twerper 'soft'"},
           {"twerper ball.radius linear in=srgb", 28, "only colours blend in light or srgb; this is a number"},
           {"extend ball.radius hodl", 20, "'hodl' is no way to extend a track", "did you mean 'hold'?"},
           {"extend ball.radius cycle during", 26, "'during' is not expected here"},
       })
    expect_case(k);
}

// What a refused line would have made is missed below it; that is said once, by that line.
TEST(Errors, OfOutlinesAndLines) {
  for (const Case& k : std::vector<Case>{
           {"create r rectangle fill=2", 25, "on or off is wanted here"},
           {"create r rectangle fill=red", 25, "on or off is wanted here"},
           {"create r rectangle fill", 20, "'fill' needs a value"},
           {"create r rectangle stroke=glod", 27, "there is no colour 'glod'", "did you mean 'gold'?"},
           {"create r rectangle stroke=2f", 27, "a colour is wanted here, not a number"},
           {"create r rectangle color=none", 26, "there is no colour 'none'"},
           {"create r rectangle stroke.r=none", 29, "'none' is not a number"},
           {"create r rectangle stroke-width=-1", 33, "stroke-width is at least 0"},
           {"create r rectangle stroke-width=2deg", 33, "'deg' is not a unit of length"},
           {"create r rectangle stroke-width=1e13", 33, "stroke-width is at most 1000000000000"},
           {"create r rectangle dash=1", 25, "a vector is wanted here, not one number", "write (1 1)"},
           {"create r rectangle dash=(1)", 25, "2 numbers are wanted here, not 1"},
           {"create r rectangle dash=(1 2 3)", 30, "only 2 numbers are wanted here"},
           {"create r rectangle dash=(-1 2)", 25, "dash is at least 0"},
           {"create r rectangle dash=(1s 2)", 27, "'s' is not a unit that fits here"},
           {"create r rectangle trim=(0 1.01)", 25, "trim is at most 1"},
           {"create r rectangle trim=(-0.1 1)", 25, "trim is at least 0"},
           {"create r rectangle trim=(0 1m)", 29, "'m' is not a unit that fits here"},
           {"create r rectangle trim=(0 nan)", 28, "'nan' is not a number"},
           {"create r rectangle holes=((0 0) (1 0) (1 1))", 20, "a rectangle has no 'holes'"},
           {"create p polygon holes=1", 24, "an opening bracket '(' is missing here"},
           {"create p polygon holes=(1 2)", 25, "a point (x y) or (x y z) is wanted here"},
           {"create p polygon holes=((1 2) ((1 2)))", 35, "a closing bracket ')' is missing before '2'"},
           {"create p polygon holes=(((1 2) (3 4)) (1 2))", 40, "a point (x y) or (x y z) is wanted here"},
           {"create p polygon holes=(((1 2 3 4)))", 26, "a point has two or three numbers"},
           {"create p polygon holes=(((1 2))", 24, "this bracket is never closed"},
           {"create l line to=3", 18, "a vector is wanted here, not one number"},
           {"create l line to=(1 2)", 18, "3 numbers are wanted here, not 2"},
           {"create l line width=-1", 21, "width is at least 0"},
           {"create l line stroke=red", 15, "a line has no 'stroke'"},
           {"create l line fill=off", 15, "a line has no 'fill'"},
           {"create s sphere stroke=red", 17, "a sphere has no 'stroke'"},
           {"create s box trim=(0 1)", 14, "a box has no 'trim'"}})
    expect_case(k);
}

TEST(Errors, OfARefusedLineAreSaidOnce) {
  EXPECT_EQ(
      errors(read("create ball sphre\nset ball.radius 2\nball.position\n  1f (0 0 0)\nattach ball to ball\n"
                  "create twin like ball\nset twin.radius 1\ncreate {a,b} box size=2\nhide b\nlayer up\n"
                  "on up at 3f hide ball\nset bal.radius 3\nprocedure p lua \"(\"\nalias all = \nset all.radius 1\n")),
      (std::vector<std::string>{"1:13: there is no kind 'sphre'", "8:23: a vector is wanted here, not one number",
                                "10:9: add or mix is missing here", "12:5: there is no object 'bal'",
                                "13:17: unexpected symbol near <eof>"}));
  // What was there already stays; a later line that makes it ends the matter.
  EXPECT_EQ(
      errors(read("create ball sphre\nset ball.radius 1\ncreate ball sphere\nset ball.radus 1\n")),
      (std::vector<std::string>{"1:13: there is no kind 'sphre'", "4:10: 'ball', a sphere, has no function 'radus'"}));
}

// shows: G94
TEST(Errors, Operations) {
  for (const Case& k : std::vector<Case>{
           {"copy ball.position.x 1f..5f", 28, "'to' and a time are missing here"},
           {"copy ball.position.x 1f to 5f", 22, "a segment needs its end", "write 1f..END, as in 1f..24f"},
           {"copy ball.position.x 5f..1f to 9f", 22, "this segment ends before it begins"},
           {"copy ball.position.x 1f..5f to 9f times 0", 41, "times is a whole number from 1 to 1000000"},
           {"copy ball.position.x 1f..5f to 9f on ball.color", 38, "a number cannot be copied onto a colour"},
           {"copy ball.position.x 1f..5f to 9f shift (1 2 3)", 41, "a number is wanted here, not a vector"},
           {"copy ball.position.x 1f..5f to 9f twice", 35, "'twice' is not expected here", "copies take:"},
           {"copy word.text 1f..5f to 9f shift \"a\"", 35, "a text cannot be shifted"},
           {"move ball.position.x 1f..5f", 28, "'by' and a length of time are missing here"},
           {"move ball.position.x 1f..5f by 4600000000s", 6, "the events would end up more than 146 years away"},
           {"stretch ball.position.x 1f..5f by 0", 35, "time is stretched by more than 0; 'reverse' turns it round"},
           {"scale ball.position.x 1f..5f (1 2 3)", 30, "one number is wanted here: this is a number"},
           {"scale ball.position.x 1f..5f 1e308", 7, "a value grows beyond all numbers when it is scaled by that"},
           {"rotate ball.position.x 1f..5f 90deg y", 8,
            "only vectors and orientations can be rotated; this is a number"},
           {"rotate turn.rotation 1f..5f 90 y", 29, "an angle needs a unit"},
           {"rotate turn.rotation 1f..5f 90deg q", 35, "an axis is missing here", "axes are x, y, z"},
           {"clear ball.position.x 5f..1f", 25, "this segment ends before it begins"},
           {"stagger b*.position by 2", 24, "a length of time needs a unit"},
           {"spread b*.position from (0 0 0)", 32, "'to' and a value are missing here"},
           {"spread b*.display from on to off", 8, "on or off cannot be spread"},
           {"use \"none.bx\"", 5, "there is no file 'none.bx'"},
           {"use \"../x.bx\"", 5, "'../x.bx' lies outside the script's folder", "--read-anywhere"},
       })
    expect_case(k);
}

// What later versions bring is refused in words.
TEST(Errors, OfWordsThatAreTheShells) {
  for (const Case& k : std::vector<Case>{
           {"undo", 1, "'undo' is a word of the shell; a script does not need it"},
           {"play", 1, "'play' is a word of the shell; a script does not need it"},
       })
    expect_case(k);
}

// shows: C79 C85 C98
TEST(Errors, OfEnvironments) {
  for (const Case& k : std::vector<Case>{
           {"animate", 8, "the name of an environment is missing here"},
           {"animate spin by rotate(1deg, z)", 14, "'every' and a length of time are missing here"},
           {"animate spin every 1.5t by rotate(1deg, z)", 20, "this is not a whole number of ticks",
            "the nearest are 1t and 2t"},
           {"animate spin every 0t by rotate(1deg, z)", 20, "an interval is at least one tick"},
           {"animate spin every 1t", 22, "'by' and a transform are missing here"},
           {"animate spin every 1t by", 25, "a transform is wanted here"},
           {"animate spin every 1t by rotat(1deg, z)", 26, "a transform is wanted here", "did you mean 'rotate'?"},
           {"animate spin every 1t by rotate(90, z)", 33, "an angle needs a unit"},
           {"animate spin every 1t by rotate(9deg)", 37, "an axis is missing here"},
           {"animate spin every 1t by matrix(1 0 0 0 0 1 0 0 0 0 1 0 1 0 0 1)", 33,
            "the last row of a matrix is 0 0 0 1"},
           {"animate spin every 1t by translate(1 2)", 39, "3 numbers are wanted here, not 2"},
           {"animate spin every 1t by scale(2) slowr 1t per 1s", 35, "'slowr' is not expected here",
            "did you mean 'slower'?"},
           {"animate spin every 1t by scale(2) slower 1t", 44, "'per' and a length of time are missing here"},
           {"animate spin every 5t by scale(2) slower 1t per 1s faster 1t per 1s", 52,
            "an interval grows or shrinks, not both"},
           {"animate spin every 1t by scale(2) slower 0t per 1s", 35,
            "an interval changes by whole ticks, at least one"},
           {"animate spin every 1t by scale(2) from 9t until 3t", 9,
            "'spin': an environment has to halt after it starts: until 3t is not after from 9t"},
           {"animate ball every 1t by scale(2)", 9, "'ball' is a sphere, not an environment"},
           {"halt spin", 6, "there is no environment 'spin'"},
           {"at 3t kill ball", 12, "'ball' is no environment"},
           {"create spin environment", 13, "an environment is made by a command of its own"},
           {"set ball.environments (1x)", 24, "'1x' cannot be a name"},
           {"set ball.transform 3", 20, "a transform is wanted here"},
           {"at 1f ball.transform = \"1\"", 24, "a transform cannot be computed"},
       })
    expect_case(k);
}

// shows: G27 G65 G81
TEST(Errors, OfAttachmentsVelocitiesLayersFiltersAndProcedures) {
  for (const Case& k : std::vector<Case>{
           {"hang ball to car", 11, "'on' is missing here"},
           {"attach ball on car", 13, "'to' is missing here"},
           {"attach ball to ball", 8, "'ball' cannot be attached to itself"},
           {"letgo ball", 7, "letting go needs a time", "as in at 60f letgo ball"},
           {"set ball.attachment car", 5, "an attachment is not set"},
           {"at 5f ball.attachment 5", 23, "an attachment is wanted here"},
           {"at 5f ball.display.velocity on", 12, "display has no velocity: it is on or off"},
           {"set ball.position.velocity (1 0 0)", 5, "a velocity holds from a time on"},
           {"at 5f ball.rotation.velocity quat(1 0 0 0)", 30, "a turning speed is wanted here, not an orientation"},
           {"at 5f ball.position.velocity = \"t\"", 30, "a velocity cannot be computed; compute the value itself"},
           {"layer wave", 11, "add or mix is missing here"},
           {"layer ball add", 7, "there is a 'ball' already"},
           {"create wave layer", 13, "a layer is made by a command of its own", "layer wave add"},
           {"on ball set ball.radius 1", 4, "'ball' is no layer"},
           {"filter ball.position smoth", 22, "there is no filter 'smoth'", "did you mean 'smooth'?"},
           {"filter ball.position smooth wdth=1s", 29, "'smooth' has no 'wdth'", "did you mean 'width'?"},
           {"filter ball.position.velocity smooth", 8, "filters stand on values, not on velocities"},
           {"procedure f \"1\"", 13, "'lua' is missing here"},
           {"procedure set lua \"1\"", 11, "'set' is a command already"},
           {"procedure linear twerper lua \"u\"", 11, "'linear' is a twerper already"},
           {"fall ball", 6, "a fall needs a time", "as in at 24f fall ball"},
           {"at 5f fall ball gravity=0", 17, "gravity pulls down by more than 0"},
           {"dial fader to ball.radius", 6, "an address begins with '/'"},
           {"dial /a to ball.display.velocity", 17, "display has no velocity: it is on or off"},
           {"record maybe", 8, "recording is on or off"},
       })
    expect_case(k);
}

// What newcomers write, and the way out that they are told.
TEST(Errors, HintsForWhatOtherToolsTaught) {
  for (const Case& k : std::vector<Case>{
           {"set ball.color = red", 18, "behind '=' stands a procedure, in quotes",
            "a plain value stands without '=': red"},
           {"set ball.radius \"2\"", 17, "a number is wanted here, not a text", "without quotes"},
           {"set ball.shininess 50%", 20, "a part of 1 is wanted here, not a percentage", "write 0.5"},
           {"create s sphere radius:2", 17, "'radius' needs a value", "write radius=2"},
           {"create s sphere at (0 0 0)", 17, "'at' needs a value", "a place is said by position=(0 0 0)"},
           {"at 20f ball.position release", 22, "release ends the reign of a velocity; this is no velocity",
            "as in at 20f ball.position.velocity release"},
           {"at 20f word.text \"b\" linear", 22, "'linear' cannot blend a text: it changes at its events only",
            "letters turn into others by geometry: at 24f A.geometry shape(B)"},
           {"mirror ball.position", 1, "there is no command 'mirror'", "scale mirrors: scale ball.position 1f..24f"},
           {"rename b* c", 8, "one object gets another name: a pattern is none", "as in rename ball planet"},
           {"rename ball all", 13, "'all' is an alias already"},
           {"create all sphere", 8, "'all' is an alias already"},
           {"remove b[al", 8, "the bracket in 'b[al' is not closed"},
           {"set b[al.radius 2", 5, "the bracket in 'b[al' is not closed"},
           {"alias x = b[al", 11, "the bracket in 'b[al' is not closed"},
           {"on swey ball.position", 4, "there is no layer 'swey'", "layer swey add makes one"},
       })
    expect_case(k);
  EXPECT_EQ(errors(read("create ball sphere\nlayer sway add\non swey ball.position\n  1f (0 0 0)\n  2f (1 0 0)\n")),
            (std::vector<std::string>{"3:4: there is no layer 'swey'"}));
  EXPECT_EQ(
      errors(read("create ball sphere\nlayer sway add\non sway ball.positon\n  1f (0 0 0)\nset ball.radius x\n")),
      (std::vector<std::string>{"3:14: 'ball', a sphere, has no function 'positon'", "5:17: 'x' is not a number"}));
  EXPECT_EQ(errors(read("create a sphere\nprocedure loud filter lua \"input() * my_gain\"\n"
                        "filter a.radius loud my-gain=2\nfilter a.radius loud my-gian=2\n")),
            (std::vector<std::string>{"4:22: 'loud' makes no use of 'my-gian'"}));
}

TEST(Errors, WhatWouldFillTheMachineIsRefused) {
  const std::string head_of_all = "create b{1..100} sphere\nb1.radius\n  1f 1\n  2f 2\n";
  EXPECT_EQ(errors(read(head_of_all + "copy b1.radius 1f..2f to 2f on b*.radius times 100000\n")),
            (std::vector<std::string>{"5:6: copying would make more than 10000000 events"}));
  EXPECT_EQ(errors(read("create a{1..1000000} sphere\ncreate b sphere\n")),
            (std::vector<std::string>{"2:8: a film has at most 1000000 objects"}));
}

}  // namespace
}  // namespace betwixt
