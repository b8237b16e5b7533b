// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests look files and configurations of colours as they are read: what they hold, and what is wrong with bad ones.
// tests/render/look_table_test.cpp compares the colours.
#include "exchange/color_table.h"

#include <algorithm>
#include <filesystem>

#include "exchange/files.h"
#include "exchange/parser_process.h"
#include "support/told.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

const MayRead all_files = [](const std::string&) { return true; };

Result<std::shared_ptr<const ColorTable>> colors(const std::string& path, const ColorQuery& query = {}) {
  return load_colors(path, query, all_files);
}
std::string wrong(const std::string& path, const ColorQuery& query = {}) {
  const auto read = colors(path, query);
  return read ? "" : read.error().message;
}
bool says(const std::string& message, std::string_view what) {
  if (message.find(what) != message.npos) return true;
  ADD_FAILURE() << "\"" << message << "\" does not say \"" << what << "\"";
  return false;
}

constexpr const char* two =
    "TITLE \"two\"\r\n# a comment\r\n\r\nLUT_3D_SIZE 2\r\nDOMAIN_MIN 0 0 0\r\nDOMAIN_MAX 2 1 1\r\n"
    "0 0 0\r\n1 0 0\r\n0 1 0\r\n1 1 0\r\n0 0 1\r\n1.5 0 1\r\n-1 1 1\r\n0.25 0.5 0.75\r\n";

TEST_F(Files, CubeHasItsColorsInItsOrder) {
  const auto t = colors(put("two.cube", two));
  ASSERT_TRUE(t) << t.error().message;
  EXPECT_TRUE((*t)->cube);
  EXPECT_EQ((*t)->size, 2);
  EXPECT_EQ((*t)->takes, ColorTable::picture);
  EXPECT_EQ((*t)->most, (std::array<float, 3>{2, 1, 1}));
  ASSERT_EQ((*t)->signals.size(), 24U);
  EXPECT_EQ((*t)->signals[3], 65535);   // red first
  EXPECT_EQ((*t)->signals[15], 65535);  // what is outside is limited
  EXPECT_EQ((*t)->signals[18], 0);
  EXPECT_EQ((*t)->signals[21], 16384);  // a quarter of 65535, rounded
  EXPECT_EQ((*colors(at("two.cube"), {.of_light = true}))->takes, ColorTable::light);
}

TEST_F(Files, CubeOfOneDimensionIsThreeCurves) {
  const auto t = colors(put("curve.cube", "LUT_1D_SIZE 3\nLUT_1D_INPUT_RANGE -1 3\n0 0 0\n0.5 0.25 0\n1 1 1\n"));
  ASSERT_TRUE(t) << t.error().message;
  EXPECT_FALSE((*t)->cube);
  EXPECT_EQ((*t)->size, 3);
  EXPECT_EQ((*t)->least[1], -1);
  EXPECT_EQ((*t)->most[2], 3);
  EXPECT_EQ((*t)->signals[4], 16384);
}

TEST_F(Files, BadCubesSayWhatIsWrong) {
  says(wrong(at("none.cube")), "none.cube");
  says(wrong(put("empty.cube", "")), "LUT_3D_SIZE");
  says(wrong(put("one.cube", "LUT_3D_SIZE 1\n0 0 0\n")), "line 1: the size of a 3D table must be from 2 to 129, not 1");
  says(wrong(put("huge.cube", "# a\nLUT_3D_SIZE 10000\n")), "line 2: the size of a 3D table");
  says(wrong(put("long.cube", "LUT_1D_SIZE 1e9\n")), "65536");
  says(wrong(put("half.cube", "LUT_3D_SIZE 2.5\n")), "2.5");
  const std::string whole = two;
  says(wrong(put("cut.cube", whole.substr(0, whole.rfind("0.25")))), "ends after 7 of 8 colors");
  says(wrong(put("more.cube", whole + "0 0 0\n")), "more than 8 colors");
  says(wrong(put("nan.cube", "LUT_1D_SIZE 2\n0 0 0\n0 nan 0\n")), "line 3: 'nan' is not a number");
  says(wrong(put("inf.cube", "LUT_1D_SIZE 2\n0 0 0\n0 0 1e999\n")), "line 3: '1e999'");
  says(wrong(put("pair.cube", "LUT_1D_SIZE 2\n0 0\n")), "line 2: 3 numbers are needed");
  says(wrong(put("four.cube", "LUT_1D_SIZE 2\n0 0 0 0\n")), "one word too many");
  says(wrong(put("twice.cube", "LUT_1D_SIZE 2\nLUT_1D_SIZE 3\n")), "given twice");
  says(wrong(put("word.cube", "LUT_4D_SIZE 2\n")), "'LUT_4D_SIZE'");
  says(wrong(put("domain.cube", "LUT_1D_SIZE 2\nDOMAIN_MAX 0 1 1\n0 0 0\n1 1 1\n")), "domain");
  says(wrong(put("picture.cube", "\x89PNG\r\n\x1a\n")), "line 1");
}

TEST_F(Files, PackedColorsComeBack) {
  const auto t = colors(put("two.cube", two));
  ASSERT_TRUE(t);
  const auto again = colors(put("any.ocio", packed_colors(**t)));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(**again, **t);
  const std::string packed = packed_colors(**t);
  says(wrong(put("cut.ocio", packed.substr(0, packed.size() - 1))), "damaged");
  says(wrong(put("head.ocio", "betwixt colors 1\ncube 100000 0 0 0 0 1 1 1\n")), "damaged");
}

TEST_F(Files, ColorsAreReadOnlyWhereItIsAllowed) {
  const std::string path = put("two.cube", two);
  const auto read = load_colors(path, {}, [](const std::string&) { return false; });
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::file);
}

#ifdef BETWIXT_OCIO

const std::string head =
    "ocio_profile_version: 2\nsearch_path: luts\nroles:\n  default: lin_srgb\n  scene_linear: lin_srgb\n"
    "displays:\n  sRGB:\n    - !<View> {name: Plain, colorspace: coded}\n    - !<View> {name: Filed, colorspace: "
    "filed}\n"
    "  Projector:\n    - !<View> {name: Raw, colorspace: lin_srgb}\n"
    "looks:\n  - !<Look> {name: Punchy, process_space: lin_srgb, transform: !<CDLTransform> {slope: [2, 1, 1]}}\n"
    "colorspaces:\n  - !<ColorSpace> {name: lin_srgb}\n"
    "  - !<ColorSpace> {name: coded, from_scene_reference: !<ExponentTransform> {value: 0.5}}\n"
    "  - !<ColorSpace> {name: filed, from_scene_reference: !<FileTransform> {src: ";
std::string configuration(const std::string& file) { return head + file + "}}\n"; }

TEST_F(Files, ConfigurationsSayWhatTheyLack) {
  const std::string path = put("c.ocio", configuration("two.cube"));
  const auto plain = colors(path);
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_FALSE((*plain)->cube);  // its channels do not mix
  EXPECT_EQ((*plain)->takes, ColorTable::stops);
  const auto display = colors(path, {.display = "sRGN"});
  ASSERT_FALSE(display);
  EXPECT_EQ(told(display.error()), "name sRGN");
  says(display.error().message, "sRGB, Projector");
  says(display.error().hint, "sRGB");
  says(wrong(path, {.through = "Filmic"}), "no view 'Filmic'; it has Plain, Filed");
  says(wrong(path, {.display = "Projector", .through = "Plain"}), "'Projector'");
  says(wrong(path, {.look = "punchy"}), "no look 'punchy'; it has Punchy");
  says(wrong(path, {.space = "ACEScg"}), "no color space 'ACEScg'");
  std::string unknown = configuration("two.cube");
  for (std::size_t at; (at = unknown.find("lin_srgb")) != unknown.npos;) unknown.replace(at, 8, "mine");
  put("u.ocio", unknown);
  says(wrong(at("u.ocio")), "aces_interchange");
  EXPECT_TRUE(colors(at("u.ocio"), {.space = "mine"}));
  for (const char* bad :
       {"", "hello: world\n", "\x89PNG", "ocio_profile_version: 99\n", "- [", "ocio_profile_version: 2\n"})
    EXPECT_NE(wrong(put("bad.ocio", bad)), "") << bad;
}

TEST_F(Files, ConfigurationsReadFilesInTheirFolderOnly) {
  fs::create_directories(folder_.path() / "in/luts");
  put("in/luts/two.cube", two), put("two.cube", two);
  const ColorQuery filed{.through = "Filed"};
  EXPECT_EQ(wrong(put("in/c.ocio", configuration("two.cube")), filed), "");
  says(wrong(put("in/up.ocio", configuration("../../two.cube")), filed), "outside its folder");
  says(wrong(put("in/all.ocio", configuration(at("two.cube"))), filed), "outside its folder");
  fs::create_symlink(at("two.cube"), folder_.path() / "in/luts/link.cube");
  EXPECT_NE(wrong(put("in/link.ocio", configuration("link.cube")), filed), "");
  says(wrong(put("in/gone.ocio", configuration("gone.cube")), filed), "luts/gone.cube, which cannot be read");
  EXPECT_EQ(wrong(at("in/gone.ocio")), "");  // its other view needs it not
  put("in/luts/broken.cube", "LUT_3D_SIZE 2\n0 0 0\n");
  EXPECT_NE(wrong(put("in/broken.ocio", configuration("broken.cube")), filed), "");
  std::vector<std::string> asked;
  const auto read = load_colors(at("in/c.ocio"), filed, [&](const std::string& p) { return asked.push_back(p), true; });
  EXPECT_TRUE(std::any_of(asked.begin(), asked.end(), [](const auto& p) { return p.ends_with("in/luts/two.cube"); }));
}

#endif

}  // namespace
}  // namespace betwixt
