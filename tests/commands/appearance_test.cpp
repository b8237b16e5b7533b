// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the commands for the look of a film.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

double light(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

TEST(Appearance, IsInTheFrame) {
  const LoadedFilm s(
      "let far = 40m\nlet dusk = rgb(0.2 0.4 0.6)\nbackground navy to #ff8000\nambient dusk\nexposure 2/4\n"
      "fog white from 50cm to far\nground #808080\nsky on\ncontact on\n");
  const Surroundings a = s.frame("1f").surroundings;
  EXPECT_NEAR(s.frame("1f").background->z, light(128 / 255.0), 1e-12);
  EXPECT_NEAR(a.below->y, light(128 / 255.0), 1e-12);
  EXPECT_NEAR(a.ambient->x, light(0.2), 1e-12);
  EXPECT_EQ(a.exposure, 0.5);
  EXPECT_EQ(a.fog, (Surroundings::Fog{{1, 1, 1}, 0.5, 40}));
  EXPECT_NEAR(a.ground->x, light(128 / 255.0), 1e-12);
  EXPECT_TRUE(a.sky);
  EXPECT_TRUE(a.contact);
  EXPECT_FALSE(a.flat);
  EXPECT_EQ(LoadedFilm("").frame("1f").surroundings, Surroundings{});
}

TEST(Appearance, TheLastWordCounts) {
  const std::string all =
      "background navy to red\nambient off\nexposure 3\nfog red from 1 to 2\nground red\nsky on\ncontact on\nfilm "
      "flat\n";
  const LoadedFilm s(all + "background none\nexposure 0\nfog off\nground off\nsky off\ncontact off\nfilm solid\n");
  Surroundings rest;
  rest.ambient = Vec3{};  // off is no light from everywhere; nothing else is said of it
  EXPECT_EQ(s.frame("1f").surroundings, rest);
  EXPECT_FALSE(s.frame("1f").background);
}

TEST(Appearance, SizeAndSamplesAreTheScriptsToSay) {
  const Document d = LoadedFilm("size 320x200\nsamples 9\n").loaded.document;
  EXPECT_EQ(d.size(), std::pair(320, 200));
  EXPECT_EQ(d.samples(), 9);
  EXPECT_FALSE(Document().size());
  EXPECT_FALSE(Document().samples());
}

// The view of a drawing: what is 4.5 m above the middle is at the upper border, wherever along z it is.
TEST(Appearance, AFlatFilmIsADrawing) {
  const LoadedFilm s("film flat\ncreate b box position=(3 2 -40)\ncreate lamp light\n");
  EXPECT_EQ(s.loaded.document.size(), std::pair(1920, 1080));
  EXPECT_EQ(LoadedFilm("size 64x64\nfilm flat\n").loaded.document.size(), std::pair(64, 64));
  const Frame f = s.frame("1f");
  EXPECT_TRUE(f.surroundings.flat);
  EXPECT_TRUE(f.camera.orthographic);
  EXPECT_EQ(f.camera.height, 9);
  const Vec3 back = transform_vector(f.camera.world, {0, 0, 1}), up = transform_vector(f.camera.world, {0, 1, 0});
  EXPECT_EQ(back, (Vec3{0, 0, 1}));
  EXPECT_EQ(up, (Vec3{0, 1, 0}));
  EXPECT_EQ(translation_of(f.camera.world).x, 0);
  EXPECT_EQ(translation_of(f.camera.world).y, 0);
  ASSERT_TRUE(f.background);
  EXPECT_LT(f.background->x + f.background->y + f.background->z, 0.05);
  EXPECT_EQ(LoadedFilm("film flat\nbackground white\n").frame("1f").background, (Vec3{1, 1, 1}));
  EXPECT_EQ(LoadedFilm("film flat\ncreate eye camera height=3\n").frame("1f").camera.height, 3);
}

// What is outside the drawing's view is so for contacts too: its box ends 16 m wide of 9 m high pictures.
TEST(Appearance, AFlatFilmsViewEnds) {
  const LoadedFilm s("film flat\ncreate in box position=(7.4 0 0)\ncreate out box position=(8.6 0 0)\n");
  expect_numbers(s, "in.in-view", "1f", {1});
  expect_numbers(s, "out.in-view", "1f", {0});
}

// What is in view follows the size that the script says: pictures 10 m high are as much wider as their pixels say.
TEST(Appearance, TheSizeSaysWhatIsInView) {
  const auto seen = [](const char* size, const char* place, const char* eye) {
    return LoadedFilm(std::string(size) + "\n" + eye + "\ncreate a box size=(0.2 0.2 0.2) position=" + place)
        .numbers("a.in-view", "1f");
  };
  const char* flat = "create eye camera position=(0 0 10) height=10";
  const auto in = std::vector{1.0}, out = std::vector{0.0};
  EXPECT_EQ(seen("size 400x200", "(9.8 0 0)", flat), in);
  EXPECT_EQ(seen("", "(9.8 0 0)", flat), out);  // 16:9: 8.89
  EXPECT_EQ(seen("size 100x200", "(2.7 0 0)", flat), out);
  // A lens says how wide; half as high a picture is half as high at 10 m: 5 m of 20 m, or 10.
  const char* lens = "create eye camera position=(0 0 10) fov=90deg";
  EXPECT_EQ(seen("size 400x200", "(0 4.8 0)", lens), in);
  EXPECT_EQ(seen("size 400x200", "(0 5.3 0)", lens), out);
  EXPECT_EQ(seen("size 200x200", "(0 5.3 0)", lens), in);
  EXPECT_EQ(seen("film flat\nsize 300x900", "(1.7 0 0)", ""), out);
  EXPECT_EQ(seen("film flat\nsize 300x900", "(1.4 4 0)", ""), in);
}

// A film without a camera shows all of its things in the widest pictures, too.
TEST(Appearance, TheOwnCameraFitsWidePictures) {
  for (const char* size : {"", "size 3000x300\n", "size 300x3000\n"}) {
    const LoadedFilm s(std::string(size) + "create a box size=(2 8 2)\ncreate b box position=(0 9 3)\n");
    const Contacts c = contacts(s.frame("1f"));
    for (const ContactBox& b : c.boxes) EXPECT_EQ(b.sight, Sight::in) << size;
    EXPECT_EQ(c.boxes.size(), 2u);
  }
}

TEST(Appearance, FogIsTheBackgroundWhereNoneIsSaid) {
  EXPECT_EQ(LoadedFilm("fog white from 1 to 2\n").frame("1f").background, (Vec3{1, 1, 1}));
  EXPECT_EQ(LoadedFilm("fog white from 1 to 2\nbackground black\n").frame("1f").background, Vec3{});
  for (const char* sky : {"sky on", "sky day", "sky sunset", "sky overcast"})
    EXPECT_FALSE(LoadedFilm(std::string("fog white from 1 to 2\n") + sky + "\n").frame("1f").background) << sky;
  for (const char* unseen : {"sky studio", "sky day\nfilm flat"})
    EXPECT_EQ(LoadedFilm(std::string("fog white from 1 to 2\n") + unseen + "\n").frame("1f").background,
              (Vec3{1, 1, 1}))
        << unseen;
}

// The last one that is said counts, whatever else would be behind things.
TEST(Appearance, NothingBehindThingsIsABackgroundToo) {
  const auto clear = [](const std::string& script) { return LoadedFilm(script).loaded.document.transparent(); };
  EXPECT_FALSE(clear(""));
  EXPECT_TRUE(clear("background transparent\n"));
  EXPECT_TRUE(clear("background navy to red\nbackground transparent\n"));
  for (const char* other : {"none", "red", "navy to red"})
    EXPECT_FALSE(clear(std::string("background transparent\nbackground ") + other + "\n")) << other;
  for (const char* else_behind : {"fog white from 1 to 2\n", "sky on\n", "film flat\n", "background red to blue\n"}) {
    const Frame f = LoadedFilm(std::string(else_behind) + "background transparent\n").frame("1f");
    EXPECT_TRUE(f.surroundings.clear) << else_behind;
    EXPECT_EQ(f.background, Vec3{}) << else_behind;  // where it cannot be clear
    EXPECT_FALSE(f.surroundings.below) << else_behind;
  }
  EXPECT_EQ(read("background transparant\n").diagnostics.at(0).what.hint, "did you mean 'transparent'?");
}

TEST(Appearance, IsWrittenAndCompared) {
  const Document nothing;
  for (const char* line :
       {"size 320x200", "samples 16", "samples auto", "pixel-filter mitchell", "film flat", "background red to #010203",
        "background transparent", "ambient off", "ambient #123456", "exposure -1.25", "fog gold from 0.1 to 1000",
        "ground on", "ground navy", "sky on", "contact on"}) {
    const Document d = LoadedFilm(std::string(line) + "\n").loaded.document;
    EXPECT_FALSE(d == nothing) << line;
    const Loaded again = read(write(d));
    EXPECT_TRUE(again.diagnostics.empty()) << write(d) << said(again.diagnostics);
    EXPECT_TRUE(again.document == d) << write(d);
  }
}

TEST(Appearance, MistakesAreSaidWhereTheyAre) {
  for (const auto& [line, what] : std::vector<std::pair<std::string, std::string>>{
           {"size", "syntax 1:5"},
           {"size 1920", "range 1:6 1920"},
           {"size 0x5", "range 1:6 0x5"},
           {"size 64x9000", "range 1:6 64x9000"},
           {"size 99999999999999999999x1", "range 1:6 99999999999999999999x1"},
           {"size 64x48x3", "range 1:6 64x48x3"},
           {"size 64 48", "range 1:6 64"},
           {"size 64x48 9", "syntax 1:12 9"},
           {"size -64x48", "range 1:6 -64x48"},
           {"samples", "syntax 1:8"},
           {"samples 5", "range 1:9 5"},
           {"pixel-filter", "syntax 1:13"},
           {"pixel-filter mitchel", "type 1:14 mitchel"},
           {"pixel-filter box tent", "syntax 1:18 tent"},
           {"samples -4", "range 1:9 -4"},
           {"samples 4.5", "range 1:9 4.5"},
           {"samples 4m", "type 1:9 4m"},
           {"samples many", "syntax 1:9 many"},
           {"film", "syntax 1:5"},
           {"film flatt", "type 1:6 flatt"},
           {"film flat 3", "syntax 1:11 3"},
           {"background red to", "syntax 1:18"},
           {"background red too blue", "syntax 1:16 too"},
           {"background none to red", "syntax 1:17 to"},
           {"background transparent to red", "syntax 1:24 to"},
           {"background transparant", "name 1:12 transparant"},
           {"background", "syntax 1:11"},
           {"ambient", "syntax 1:8"},
           {"ambient of", "name 1:9 of"},
           {"exposure", "syntax 1:9"},
           {"exposure bright", "syntax 1:10 bright"},
           {"exposure 21", "range 1:10 21"},
           {"exposure 2deg", "type 1:10 2deg"},
           {"fog", "syntax 1:4"},
           {"fog white", "syntax 1:10"},
           {"fog white 3 to 4", "syntax 1:11 3"},
           {"fog white from 3", "syntax 1:17"},
           {"fog white from 3 to 3", "range 1:21 3"},
           {"fog white from -1 to 3", "range 1:16 -1"},
           {"fog white from 1 to 1e13", "range 1:21 1e13"},
           {"fog white from 1f to 3", "type 1:16 1f"},
           {"ground onn", "name 1:8 onn"},
           {"ground", "syntax 1:7"},
           {"ground on red", "syntax 1:11 red"},
           {"sky", "syntax 1:4"},
           {"sky blue", "type 1:5 blue"},
           {"contact", "syntax 1:8"},
           {"contact 3", "type 1:9 3"},
           {"contact on the floor", "syntax 1:12 the"},
           {"at 3f contact on", "syntax 1:7 contact"},
           {"at 3f sky on", "syntax 1:7 sky"},
           {"at 3f size 3x3", "syntax 1:7 size"}}) {
    const Loaded l = read(line + "\n");
    EXPECT_EQ(all_told(l), std::vector<std::string>{what}) << line;
    EXPECT_TRUE(l.document == read("").document) << line;
  }
}

TEST(Appearance, NearMisses) {
  for (const auto& [line, hint] :
       std::vector<std::pair<std::string, std::string>>{{"film flatt", "did you mean 'flat'?"},
                                                        {"ground onn", "did you mean 'on'?"},
                                                        {"ambient of", "did you mean 'off'?"},
                                                        {"fogg white from 1 to 2", "did you mean 'fog'?"},
                                                        {"exposur 1", "did you mean 'exposure'?"},
                                                        {"size 64x", "as in size 1920x1080"}}) {
    const Loaded l = read(line + "\n");
    ASSERT_EQ(l.diagnostics.size(), 1u) << line;
    EXPECT_EQ(l.diagnostics[0].what.hint, hint) << line;
  }
}

// `shadow` is on or off of things, and of lights some more.
TEST(Appearance, ShadowsAreOfThingsAndOfLights) {
  const LoadedFilm s(
      "create b sphere shadow=off\ncreate c box\ncreate l light shadow=soft\ncreate m light\nat 2f m.shadow on\n"
      "at 3f {b,c}.shadow off\nat 3f {l,m}.shadow off\nat 5f l.shadow \"auto\"\nat 5f c.shadow on\n");
  const auto casts = [&](const char* time) {
    const Frame f = s.frame(time);
    return std::vector<int>{f.items[0].casts, f.items[1].casts, static_cast<int>(f.lights[0].casting),
                            static_cast<int>(f.lights[1].casting)};
  };
  const int strongest = static_cast<int>(Casting::strongest), off = static_cast<int>(Casting::off);
  EXPECT_EQ(casts("1f"), (std::vector<int>{0, 1, static_cast<int>(Casting::soft), strongest}));
  EXPECT_EQ(casts("3f"), (std::vector<int>{0, 0, off, off}));
  EXPECT_EQ(casts("5f"), (std::vector<int>{0, 1, strongest, off}));
  const Loaded again = read(write(s.loaded.document));
  EXPECT_TRUE(again.document == s.loaded.document) << write(s.loaded.document);
}

TEST(Appearance, MistakesAboutShadowsAreSaid) {
  const std::string before = "create b sphere\ncreate l light\n";
  for (const auto& [line, what] :
       std::vector<std::pair<std::string, std::string>>{{"set b.shadow soft", "type 3:14 soft"},
                                                        {"set b.shadow", "type 3:13"},
                                                        {"set b.shadow 3", "type 3:14 3"},
                                                        {"set l.shadow softt", "type 3:14 softt"},
                                                        {"set l.shadow", "type 3:13"},
                                                        {"set l.shadow 2m", "type 3:14 2m"},
                                                        {"set l.shadow (1 2 3)", "type 3:14 ("},
                                                        {"create x light shadow=yes", "type 3:23 yes"},
                                                        {"create x box shadow=auto", "type 3:21 auto"}}) {
    const Loaded l = read(before + line + "\n");
    EXPECT_EQ(all_told(l), std::vector<std::string>{what}) << line;
    EXPECT_TRUE(l.document == read(before).document) << line;
  }
}

}  // namespace
}  // namespace betwixt
