// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests look files and configurations of colours in scripts: what the film has, its text, and errors with their place.
#include "scene/document.h"
#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

class ViewFiles : public testing::Test {
 protected:
  ViewFiles() {
    folder_.put("film/looks/two.cube", "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    folder_.put("film/bad.cube", "LUT_3D_SIZE 10000\n");
    folder_.put("two.cube", "LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
    folder_.put(
        "film/c.ocio",
        "ocio_profile_version: 2\nroles: {default: lin_srgb}\ndisplays:\n  sRGB:\n"
        "    - !<View> {name: Filmic, colorspace: lin_srgb}\ncolorspaces:\n  - !<ColorSpace> {name: lin_srgb}\n");
  }
  Loaded load(const std::string& script, const LoadOptions& options = {}) const {
    folder_.put("film/main.bx", script);
    return load_file(folder_ / "film/main.bx", options);
  }
  std::string first_error(const std::string& script) const {
    const auto all = all_told(load(script));
    return all.empty() ? "" : all.front();
  }
  static const Appearance& look_of(const Loaded& l) { return l.document.scene().appearance; }
  const Folder folder_;
};

TEST_F(ViewFiles, AreInTheFilmAndInItsText) {
  for (const char* line : {"view \"looks/two.cube\"\n", "view \"looks/two.cube\" takes=agx strength=0.5\n",
                           "view \"looks/two.cube\" takes=light\n"}) {
    const Loaded l = load(line);
    EXPECT_EQ(said(l.diagnostics), "");
    EXPECT_TRUE(look_of(l).grade.table) << line;
    EXPECT_NE(write(l.document).find(line), std::string::npos) << write(l.document);
    const Loaded again = load(write(l.document));
    EXPECT_EQ(look_of(again).grade.view, look_of(l).grade.view);
    EXPECT_EQ(*look_of(again).grade.table, *look_of(l).grade.table);
    EXPECT_EQ(look_of(again).grade.table_share, look_of(l).grade.table_share);
  }
  EXPECT_FALSE(look_of(load("view \"looks/two.cube\"\nview neutral\n")).grade.table);
  EXPECT_EQ(write(load("view \"looks/two.cube\" strength=0\nview neutral\n").document).find("view"), std::string::npos);
}

TEST_F(ViewFiles, BadWordsAreToldWithTheirPlace) {
  EXPECT_EQ(first_error("view \"none.cube\"\n"), "file 1:6 \"none.cube\"");
  EXPECT_EQ(first_error("view \"bad.cube\"\n"), "range 1:6 \"bad.cube\"");
  EXPECT_EQ(first_error("view \"../two.cube\"\n"), "file 1:6 \"../two.cube\"");
  EXPECT_EQ(first_error("view \"looks/two.cube\" takes=agz\n"), "type 1:29 agz");
  EXPECT_EQ(first_error("view \"looks/two.cube\" strength=2\n"), "range 1:32 2");
  EXPECT_EQ(first_error("view \"looks/two.cube\" display=\"sRGB\"\n"), "syntax 1:23 display");
  EXPECT_EQ(first_error("view \"c.ocio\" takes=agx\n"), "syntax 1:15 takes");
  EXPECT_EQ(first_error("view \"c.ocio\" dizplay=\"sRGB\"\n"), "name 1:15 dizplay");
  EXPECT_EQ(first_error("view \"looks/two.cube\" light\n"), "syntax 1:23 light");
}

#ifdef BETWIXT_OCIO
TEST_F(ViewFiles, ConfigurationsTakeNames) {
  const char* const line = "view \"c.ocio\" display=\"sRGB\" through=\"Filmic\" space=\"lin_srgb\"\n";
  const Loaded l = load(line);
  EXPECT_EQ(said(l.diagnostics), "");
  EXPECT_NE(write(l.document).find(line), std::string::npos) << write(l.document);
  EXPECT_EQ(first_error("view \"c.ocio\" through=\"Filmik\"\n"), "name 1:6 \"c.ocio\"");
  std::vector<std::string> asked;
  LoadOptions options;
  options.asked_for = [&](const std::string& path) { asked.push_back(path); };
  (void)load(line, options);
  EXPECT_EQ(std::count_if(asked.begin(), asked.end(), [](const auto& p) { return p.ends_with("film/c.ocio"); }) > 0,
            true);
}
#endif

}  // namespace
}  // namespace betwixt
