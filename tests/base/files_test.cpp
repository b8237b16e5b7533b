// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

#include "support/folder.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

std::string message(const Status& s) { return s ? "" : s.error().message; }

TEST(Files, AreReadWhole) {
  const Folder folder;
  const std::string all("words\0\xff\n", 8);
  EXPECT_EQ(*read_whole(folder.put("a.bin", all)), all);
  EXPECT_EQ(*read_whole(folder.put("empty", "")), "");
  const std::string long_one(300'000, 'x');  // more than is read at once
  EXPECT_EQ(*read_whole(folder.put("long", long_one)), long_one);
  EXPECT_FALSE(read_whole("/proc/self/status")->empty()) << "a file whose size is known at its end";
}

TEST(Files, WhatCannotBeReadIsSaid) {
  const Folder folder;
  const auto why = [](const std::string& path) { return read_whole(path).error().message; };
  EXPECT_EQ(why(folder / "none"), "there is no file '" + folder / "none'");
  folder.put("f", "");
  EXPECT_EQ(why(folder / "f/x"), "cannot read " + (folder / "f/x") + ": not a directory");
  EXPECT_EQ(why(folder.path()), folder.path().string() + " is a folder, not a file");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(why(folder / "pipe"), (folder / "pipe") + " is not a regular file") << "and nobody waits for a writer";
  fs::resize_file(folder.put("large", ""), largest_file + 1);  // it takes no room
  EXPECT_EQ(why(folder / "large"), (folder / "large") + " is larger than 1 GiB");
}

TEST(Files, LimitsHoldForPipesToo) {
  const Folder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const auto read = [&](std::uint64_t largest) {
    std::thread writer([&] { std::ofstream(folder / "pipe") << std::string(1000, 'x'); });
    const FileContents in = read_contents(folder / "pipe", {.largest = largest, .special = true});
    writer.join();
    return in;
  };
  EXPECT_EQ(read(1000).text.size(), 1000U);
  EXPECT_EQ(read(1000).problem, ReadProblem::none);
  EXPECT_EQ(read(999).problem, ReadProblem::too_large);
}

TEST(Files, AreNeverHalfWritten) {
  const Folder folder;
  EXPECT_TRUE(write_whole(folder / "a", "first", false));
  EXPECT_EQ(message(write_whole(folder / "a", "second", false)), (folder / "a") + " already exists");
  EXPECT_EQ(folder.get("a"), "first");
  EXPECT_TRUE(write_whole(folder / "a", "second", true));
  EXPECT_EQ(folder.get("a"), "second");
  EXPECT_EQ(message(write_whole(folder / "no/a", "", true)),
            "cannot write " + (folder / "no/a") + ": no such file or directory");
  const Status full = write_whole("/dev/full", "words", true);
  EXPECT_EQ(message(full), "cannot write /dev/full: no space left on device");
  EXPECT_EQ(full.error().code, ErrorCode::machine);
  EXPECT_EQ(folder.names(), Names{"a"});
}

TEST(Files, KeepTheirRightsAndTheirLinks) {
  const Folder folder;
  ASSERT_EQ(::chmod(folder.put("real", "old").c_str(), 0640), 0);
  fs::create_symlink("real", folder / "link");
  EXPECT_EQ(put_file(folder / "link", "new", {.like_old = true, .on_disk = true}), 0);
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(folder.get("real"), "new");
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder / "real").permissions()), 0640U);
  EXPECT_EQ(put_file(folder / "link", "other"), 0);
  EXPECT_FALSE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(folder.get("real"), "new");
  EXPECT_EQ(folder.names(), (Names{"link", "real"}));
}

TEST(Files, GiveWayToWhatIsThere) {
  const Folder folder;
  folder.put("from", "new"), folder.put("to", "old");
  EXPECT_EQ(put_file(folder / "to", "x", {.overwrite = false}), EEXIST);
  EXPECT_EQ(make_file(folder / "to", "x", 0600), EEXIST);
  EXPECT_EQ(message(put_in_place(folder / "from", folder / "to", false)), (folder / "to") + " already exists");
  EXPECT_EQ(folder.get("to"), "old");
  EXPECT_TRUE(put_in_place(folder / "from", folder / "to", true));
  EXPECT_EQ(folder.get("to"), "new");
  EXPECT_EQ(make_file(folder / "own", "x", 0600), 0);
  EXPECT_EQ(static_cast<unsigned>(fs::status(folder / "own").permissions()), 0600U);
  EXPECT_EQ(folder.names(), (Names{"own", "to"}));
}

TEST(Files, PlacesAreLookedAtBefore) {
  const Folder folder;
  folder.put("f", "");
  EXPECT_TRUE(check_place(folder / "new", false));
  EXPECT_TRUE(check_place(folder / "f", true));
  EXPECT_EQ(message(check_place(folder / "f", false)), (folder / "f") + " already exists");
  EXPECT_EQ(message(check_place(folder / "no/f", true)), "there is no folder " + folder / "no");
  EXPECT_EQ(message(check_place(folder / "f/x", true)), (folder / "f") + " is not a folder");
  EXPECT_EQ(message(check_place(folder.path(), true)), folder.path().string() + " is a folder");
  EXPECT_EQ(message(check_place("", true)), "\"\" is not a file name");
  EXPECT_EQ(message(check_place("x/", true)), "\"x/\" is not a file name");
}

TEST(Files, HiddenNamesAreNobodyElses) {
  const std::string one = hidden_beside("some/film.mp4", ".mp4"), other = hidden_beside("some/film.mp4", ".mp4");
  EXPECT_NE(one, other);
  EXPECT_TRUE(one.starts_with("some/.film.mp4.")) << one;
  EXPECT_TRUE(one.ends_with(".partial.mp4")) << one;
  EXPECT_LT(hidden_beside(std::string(250, 'n')).size(), 200U);
}

TEST(Files, WritingGoesOnWhereItIsSaid) {
  const Folder folder;
  const OpenFile file(::open(folder.put("f", "abcdef").c_str(), O_RDWR));
  EXPECT_EQ(write_all(file.fd(), "XY", 2), 0);
  std::string text;
  EXPECT_EQ(read_all(file.fd(), text), 0);
  EXPECT_EQ(text, "abXYef");
  EXPECT_EQ(read_all(file.fd(), text), 0) << "from the beginning again";
  EXPECT_EQ(text, "abXYefabXYef");
  EXPECT_EQ(write_all(-1, "x"), EBADF);
  EXPECT_EQ(write_all(-1, ""), 0);
}

TEST(Files, Endings) {
  for (const auto& [path, end] : {std::pair{"a/b.OBJ", "obj"}, {"a.b/c", ""}, {"x.tar.Gz", "gz"}, {".hidden", ""}})
    EXPECT_EQ(ending(path), end) << path;
}

}  // namespace
}  // namespace betwixt
