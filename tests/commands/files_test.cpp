// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Scripts that read other files: from where, how deep, and what is said when one is missing.
#include <sys/stat.h>

#include <filesystem>
#include <set>

#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() { fs::create_directories(folder / "film/parts"); }
  void put(const std::string& name, std::string_view text) const { folder.put(name, text); }
  Loaded load(const LoadOptions& options = {}) const { return load_file(folder / "film/main.bx", options); }
  // With the folder taken out.
  std::vector<std::string> messages(const Loaded& l) const {
    auto all = errors(l);
    const std::string here = folder / "";
    for (auto& m : all)
      for (auto at = m.find(here); at != std::string::npos; at = m.find(here)) m.erase(at, here.size());
    return all;
  }
  const Folder folder;
};

using Lines = std::vector<std::string>;

TEST_F(Files, UseReadsBesideTheFileThatUses) {
  put("film/main.bx", "use parts/cast.bx\nuse \"parts/more.bx\"\nset ball.radius 2\n");
  put("film/parts/cast.bx", "rate 25\ncreate ball sphere\nuse deep.bx\n");
  put("film/parts/deep.bx", "create box box\n");
  put("film/parts/more.bx", "create more sphere\nbox.position\n  26f (1 0 0)\n");
  const Loaded l = load();
  EXPECT_EQ(said(l.diagnostics), "");
  EXPECT_EQ(l.document.names(), (Lines{"ball", "box", "more"}));
  EXPECT_EQ(l.document.range().second.flicks, flicks_per_second);
}

TEST_F(Files, ErrorsNameTheFileTheyAreIn) {
  put("film/main.bx", "use parts/cast.bx\nset bal.radius 2\n");
  put("film/parts/cast.bx", "create ball spere\ncreate bell sphere\n");
  const Loaded l = load();
  ASSERT_EQ(l.diagnostics.size(), 2u);
  EXPECT_TRUE(l.diagnostics[0].what.place.file.ends_with("film/parts/cast.bx"));
  EXPECT_TRUE(l.diagnostics[1].what.place.file.ends_with("film/main.bx"));
  EXPECT_EQ(messages(l), (Lines{"1:13: there is no kind 'spere'", "2:5: there is no object 'bal'"}));
}

TEST_F(Files, ASheetDoesNotGoOnThroughUse) {
  put("film/main.bx", "create ball sphere\nuse parts/a.bx\n");
  put("film/parts/a.bx", "  1f (1 2 3)\n");
  EXPECT_EQ(messages(load()), (Lines{"1:3: this looks like a row, but no sheet is open"}));
}

TEST_F(Files, ACircleIsAnErrorAtTheUse) {
  put("film/main.bx", "rate 24\nuse main.bx\n");
  EXPECT_EQ(messages(load()), (Lines{"2:5: 'main.bx' comes to include itself"}));
  put("film/main.bx", "use parts/a.bx\n");
  put("film/parts/a.bx", "\nuse \"../main.bx\"\n");
  const Loaded l = load();
  EXPECT_EQ(messages(l), (Lines{"2:5: '../main.bx' comes to include itself"}));
  EXPECT_TRUE(l.diagnostics[0].what.place.file.ends_with("parts/a.bx"));
}

TEST_F(Files, OnlyBelowTheFolderOfTheScript) {
  put("other.bx", "create other sphere\n");
  put("film/main.bx",
      "use \"../other.bx\"\nuse \"" + folder / "other.bx" + "\"\nuse link.bx\nuse parts/../../other.bx\n");
  fs::create_symlink(folder / "other.bx", folder / "film/link.bx");
  const Loaded l = load();
  ASSERT_EQ(l.diagnostics.size(), 4u) << said(l.diagnostics);
  for (const Diagnostic& d : l.diagnostics) {
    EXPECT_NE(d.what.message.find("lies outside the script's folder"), std::string::npos);
    EXPECT_EQ(d.what.hint, "--read-anywhere allows it");
  }
  EXPECT_EQ(l.document.names().size(), 0u);
  put("film/main.bx", "use link.bx\n");
  EXPECT_EQ(load({true, {}}).document.names(), (Lines{"other"}));
  // A folder whose name only begins the same is another folder.
  put("film2/x.bx", "create x sphere\n");
  put("film/main.bx", "use \"../film2/x.bx\"\n");
  EXPECT_EQ(messages(load()), (Lines{"1:5: '../film2/x.bx' lies outside the script's folder"}));
}

TEST_F(Files, ManyTimesManyEnds) {
  // Each file uses the next one twice: 2^40 readings, if nobody counted.
  for (int i = 0; i < 40; ++i)
    put(fmt::format("film/f{}.bx", i), fmt::format("use f{}.bx\nuse f{}.bx\n", i + 1, i + 1));
  put("film/f40.bx", "");
  put("film/main.bx", "use f0.bx\n");
  const auto m = messages(load());
  ASSERT_FALSE(m.empty());
  EXPECT_EQ(m[0].substr(m[0].find(' ') + 1), "more than 10000 files are included");
}

TEST_F(Files, WhatCannotBeRead) {
  put("film/main.bx", "use parts\nuse none.bx\nuse \"\"\nuse\n");
  EXPECT_EQ(messages(load()),
            (Lines{"1:5: 'film/parts' is a folder, not a script", "2:5: there is no file 'film/none.bx'",
                   "3:5: the name of a file is missing here", "4:4: the name of a file is missing here"}));
  EXPECT_EQ(messages(load_file(folder / "film")), (Lines{"0:0: 'film' is a folder, not a script"}));
  EXPECT_EQ(messages(load_file(folder / "none.bx")), (Lines{"0:0: there is no file 'none.bx'"}));
  put("film/main.bx",
      "create a mesh file=\"none.obj\"\ncreate b mesh file=\"bad.obj\"\ncreate c mesh file=\"bad.glb\"\n"
      "create d sphere texture=\"bad.png\"\ncreate e mesh file=\"../x.obj\"\nset e.file \"x\"\n");
  for (const char* bad : {"film/bad.obj", "film/bad.glb", "film/bad.png"}) put(bad, "\x01\x02 not a mesh");
  const Loaded l = load();
  const auto m = messages(l);
  ASSERT_EQ(m.size(), 5u) << said(l.diagnostics);  // the last line is about what the one before it should have made
  for (int i = 0; i < 5; ++i)
    EXPECT_TRUE(m[static_cast<std::size_t>(i)].starts_with(fmt::format("{}:", i + 1))) << said(l.diagnostics);
  EXPECT_EQ(l.document.names().size(), 0u);
}

TEST_F(Files, ThatAreNoScriptsAreNotQuoted) {
  put("film/secret", "user: me\npassword = hunter2 and-more\n");
  put("film/key.pem", "-----BEGIN\nrate 24\nAbCdEf==\n");
  put("film/colors.txt", "create ball sphere\n");
  put("film/main.bx", "use secret\nuse key.pem\nuse colors.txt\nset ball.radius 2\n");
  const Loaded l = load();
  EXPECT_EQ(messages(l), (Lines{"1:5: 'secret' is no script: its line 1 means nothing",
                                "2:5: 'key.pem' is no script: its line 1 means nothing"}));
  for (const char* word : {"user", "hunter", "BEGIN", "AbC", "password"})
    EXPECT_EQ(said(l.diagnostics).find(word), std::string::npos) << word;
  // Through another one, too.
  put("film/main.bx", "use list.txt\n");
  put("film/list.txt", "# all\nuse parts/a.bx\n");
  put("film/parts/a.bx", "use ../secret\n");
  EXPECT_EQ(messages(load()), (Lines{"1:5: 'list.txt' is no script"}));
}

TEST_F(Files, ThatAreNotPlainAreNeverOpened) {
  ASSERT_EQ(::mkfifo((folder / "film/pipe").c_str(), 0600), 0);
  fs::create_symlink(folder / "film/pipe", folder / "film/pipe.obj");
  fs::create_symlink("/dev/zero", folder / "film/zero.png");
  fs::create_symlink(folder / "film/pipe", folder / "film/pipe.bx");
  put("film/main.bx",
      "use pipe\nuse pipe.bx\nuse /dev/zero\ncreate m mesh file=\"pipe.obj\"\ncreate s sphere texture=\"zero.png\"\n"
      "create t sphere texture=\"pipe\"\n");
  EXPECT_EQ(messages(load({true, {}})),
            (Lines{"1:5: 'film/pipe' is no plain file", "2:5: 'film/pipe.bx' is no plain file",
                   "3:5: '/dev/zero' is no plain file", "4:20: film/pipe.obj is not a plain file",
                   "5:25: film/zero.png is not a plain file", "6:25: film/pipe is not a plain file"}));
}

TEST_F(Files, MeshesArePathsFromTheScript) {
  put("film/parts/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  put("film/parts/cast.bx", "create tri mesh file=\"t.obj\"\n");
  put("film/main.bx", "use parts/cast.bx\ncreate two mesh file=\"parts/t.obj\"\n");
  const Loaded l = load();
  EXPECT_EQ(said(l.diagnostics), "");
  const Frame f = Program::compile(l.document).frame({});
  ASSERT_EQ(f.items.size(), 2u);
  EXPECT_EQ(f.items[0].shape->mesh, f.items[1].shape->mesh);
  ASSERT_TRUE(f.items[0].shape->mesh);
}

// Those that others name too, and those that are not there; none that may not be read.
TEST_F(Files, ThatAreAskedForAreTold) {
  const std::string triangle = "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  put("film/parts/t.obj", triangle);
  put("film/parts/t.mtl", "newmtl a\n");
  put("film/parts/cast.bx", "create tri mesh file=\"t.obj\"\n");
  put("film/main.bx", "use parts/cast.bx\ncreate m mesh file=\"none.ply\"\ncreate n mesh file=\"../out.ply\"\n");
  put("out.ply", "ply");
  std::set<std::string> asked;
  LoadOptions options;
  options.asked_for = [&](const std::string& path) { asked.insert(fs::relative(path, folder.path()).string()); };
  EXPECT_EQ(messages(load(options)),
            (Lines{"2:20: there is no file film/none.ply", "3:20: '../out.ply' lies outside the script's folder"}));
  for (const char* name : {"film/parts/cast.bx", "film/parts/t.obj", "film/parts/t.mtl", "film/none.ply"})
    EXPECT_TRUE(asked.contains(name)) << name;
  EXPECT_FALSE(asked.contains("out.ply"));
}

}  // namespace
}  // namespace betwixt
