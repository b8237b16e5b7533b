// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests scripts that read other files: from which folders, how deep, and the error if one is missing.
#include <sys/stat.h>

#include <atomic>
#include <filesystem>
#include <set>

#include "base/memory_budget.h"
#include "betwixt/picture.h"
#include "scene/document.h"
#include "scene/memory.h"
#include "support/folder.h"
#include "support/loaded_film.h"
#include "support/waves.h"

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
    auto all = all_told(l);
    const std::string here = folder / "";
    for (auto& m : all)
      for (auto at = m.find(here); at != std::string::npos; at = m.find(here)) m.erase(at, here.size());
    return all;
  }
  // The words, with the folder taken out too.
  bool says(const Loaded& l, std::string_view words) const {
    for (const Diagnostic& d : l.diagnostics) {
      std::string m = d.what.message;
      if (const auto at = m.find(folder / ""); at != std::string::npos) m.erase(at, (folder / "").size());
      if (m == words) return true;
    }
    return false;
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
  EXPECT_EQ(messages(l), (Lines{"name 1:13 spere", "name 2:5 bal"}));
}

TEST_F(Files, ASheetDoesNotGoOnThroughUse) {
  put("film/main.bx", "create ball sphere\nuse parts/a.bx\n");
  put("film/parts/a.bx", "  1f (1 2 3)\n");
  EXPECT_EQ(messages(load()), (Lines{"syntax 1:3 1f"}));
}

TEST_F(Files, ACircleIsAnErrorAtTheUse) {
  put("film/main.bx", "rate 24\nuse main.bx\n");
  EXPECT_EQ(messages(load()), (Lines{"file 2:5 main.bx"}));
  EXPECT_TRUE(says(load(), "'main.bx' includes itself"));
  put("film/main.bx", "use parts/a.bx\n");
  put("film/parts/a.bx", "\nuse \"../main.bx\"\n");
  const Loaded l = load();
  EXPECT_EQ(messages(l), (Lines{"file 2:5 \"../main.bx\""}));
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
    EXPECT_TRUE(told(d).starts_with("file ")) << told(d);
    EXPECT_EQ(d.what.hint, "--read-anywhere allows it");
  }
  EXPECT_EQ(l.document.names().size(), 0u);
  put("film/main.bx", "use link.bx\n");
  EXPECT_EQ(load({true, {}}).document.names(), (Lines{"other"}));
  // A folder whose name only begins the same is another folder.
  put("film2/x.bx", "create x sphere\n");
  put("film/main.bx", "use \"../film2/x.bx\"\n");
  EXPECT_EQ(messages(load()), (Lines{"file 1:5 \"../film2/x.bx\""}));
}

TEST_F(Files, ManyTimesManyEnds) {
  // Each file uses the next one twice: 2^40 readings, if nobody counted.
  for (int i = 0; i < 40; ++i)
    put(fmt::format("film/f{}.bx", i), fmt::format("use f{}.bx\nuse f{}.bx\n", i + 1, i + 1));
  put("film/f40.bx", "");
  put("film/main.bx", "use f0.bx\n");
  const Loaded l = load();
  const auto m = messages(l);
  ASSERT_FALSE(m.empty());
  EXPECT_EQ(m[0], "file 1:5 f39.bx");
  EXPECT_EQ(l.diagnostics[0].what.message, "the script includes more than 10000 files");
}

TEST_F(Files, WhatCannotBeRead) {
  put("film/main.bx", "use parts\nuse none.bx\nuse \"\"\nuse\n");
  EXPECT_EQ(messages(load()), (Lines{"file 1:5 parts", "file 2:5 none.bx", "syntax 3:5 \"\"", "syntax 4:4"}));
  EXPECT_EQ(messages(load_file(folder / "film")), (Lines{"file film"}));
  EXPECT_TRUE(says(load_file(folder / "film"), "'film' is a folder, not a script"));
  EXPECT_EQ(messages(load_file(folder / "none.bx")), (Lines{"file none.bx"}));
  put("film/main.bx",
      "create a mesh file=\"none.obj\"\ncreate b mesh file=\"bad.obj\"\ncreate c mesh file=\"bad.glb\"\n"
      "create d sphere texture=\"bad.png\"\ncreate e mesh file=\"../x.obj\"\nset e.file \"x\"\n");
  for (const char* bad : {"film/bad.obj", "film/bad.glb", "film/bad.png"}) put(bad, "\x01\x02 not a mesh");
  const Loaded l = load();
  const auto m = messages(l);
  ASSERT_EQ(m.size(), 5u) << said(l.diagnostics);  // the last line is about what the one before it should have made
  for (int i = 0; i < 5; ++i)
    EXPECT_TRUE(m[static_cast<std::size_t>(i)].starts_with(fmt::format("file {}:", i + 1))) << said(l.diagnostics);
  EXPECT_EQ(l.document.names().size(), 0u);
}

TEST_F(Files, ThatAreNoScriptsAreNotQuoted) {
  put("film/secret", "user: me\npassword = hunter2 and-more\n");
  put("film/key.pem", "-----BEGIN\nrate 24\nAbCdEf==\n");
  put("film/colors.txt", "create ball sphere\n");
  put("film/main.bx", "use secret\nuse key.pem\nuse colors.txt\nset ball.radius 2\n");
  const Loaded l = load();
  EXPECT_EQ(messages(l), (Lines{"file 1:5 secret", "file 2:5 key.pem"}));
  EXPECT_TRUE(says(l, "'secret' is not a script: its line 1 is not a command"));
  for (const char* word : {"user", "hunter", "BEGIN", "AbC", "password"})
    EXPECT_EQ(said(l.diagnostics).find(word), std::string::npos) << word;
  // Through another one, too.
  put("film/main.bx", "use list.txt\n");
  put("film/list.txt", "# all\nuse parts/a.bx\n");
  put("film/parts/a.bx", "use ../secret\n");
  EXPECT_EQ(messages(load()), (Lines{"file 1:5 list.txt"}));
  EXPECT_TRUE(says(load(), "'list.txt' is not a script"));
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
            (Lines{"file 1:5 pipe", "file 2:5 pipe.bx", "file 3:5 /dev/zero", "file 4:20 \"pipe.obj\"",
                   "file 5:25 \"zero.png\"", "file 6:25 \"pipe\""}));
  EXPECT_TRUE(says(load({true, {}}), "'film/pipe' is not a regular file"));
  EXPECT_TRUE(says(load({true, {}}), "film/pipe.obj is not a regular file"));
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
  EXPECT_EQ(messages(load(options)), (Lines{"file 2:20 \"none.ply\"", "file 3:20 \"../out.ply\""}));
  for (const char* name : {"film/parts/cast.bx", "film/parts/t.obj", "film/parts/t.mtl", "film/none.ply"})
    EXPECT_TRUE(asked.contains(name)) << name;
  EXPECT_FALSE(asked.contains("out.ply"));
}

// What a command may make includes the contents of its files. They are refused before the document has them.
class FilesWithin : public Files {
 protected:
  FilesWithin() { EXPECT_TRUE(write_png(folder / "film/a.png", Picture{10, 10, std::vector<std::uint8_t>(400, 9)})); }
  Lines told_within(std::size_t most, const std::string& text) const {
    put("film/main.bx", text);
    std::atomic<std::size_t> all{0};
    const MemoryBudget limit(all, most);
    return messages(load());
  }
};

TEST_F(FilesWithin, APictureCountsUnpackedAndOnce) {
  const std::string two = "create s sphere texture=\"a.png\"\ncreate t sphere texture=\"a.png\"\n";
  EXPECT_EQ(told_within(410, two), Lines{});  // with twice the five letters of its name
  EXPECT_EQ(told_within(409, two), Lines{"range 2:1 create"});
  EXPECT_EQ(told_within(399, two), (Lines{"range 1:25 \"a.png\"", "range 2:25 \"a.png\""}));
  put("film/parts/b.bx", "\n  create s sphere texture=\"../a.png\"\n");
  const Lines used = told_within(399, "use parts/b.bx\n");
  EXPECT_EQ(used, Lines{"range 2:27 \"../a.png\""}) << "in the file that names it";
}

TEST_F(FilesWithin, SoDoMeshesScenesAndSounds) {
  write_wave(folder / "film/a.wav", std::vector<float>(96'000));
  put("film/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  fs::copy(SOURCE_DIR "/examples/meshes/figure.glb", folder / "film/a.glb");
  for (const auto& [line, about] : {std::pair("create s sound file=\"a.wav\"\n", "1:21 \"a.wav\""),
                                    {"create m mesh file=\"a.obj\"\n", "1:20 \"a.obj\""},
                                    {"create f scene file=\"a.glb\"\n", "1:8 f"}}) {
    put("film/main.bx", line);
    const Loaded l = load();
    ASSERT_EQ(said(l.diagnostics), "");
    ContentBytes contents;
    for (const auto& [path, mesh] : *l.document.scene().meshes) contents.add(mesh);
    for (const auto& [path, sound] : *l.document.scene().sounds) contents.add(sound);
    const std::size_t names = bytes_of_values(l.document.scene()) - contents.sum();
    EXPECT_GT(contents.sum(), 50U) << line;
    EXPECT_EQ(told_within(contents.sum() + names, line), Lines{}) << line;
    EXPECT_EQ(told_within(contents.sum() - 1, line), Lines{fmt::format("range {}", about)}) << line;
  }
}

}  // namespace
}  // namespace betwixt
