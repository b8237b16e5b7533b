// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests which output the path of a film selects, and paths to which no film can be written.
#include "film/output.h"

#include <unistd.h>

#include "betwixt/picture.h"
#include "film/films.h"
#include "support/told.h"

namespace betwixt {
namespace {

TEST_F(Film, EndingsMayBeCapitals) {
  ASSERT_TRUE(make_film(options("LOUD.MP4"), gray_steps()));
  EXPECT_EQ(files(), std::vector<std::string>{"LOUD.MP4"});
}

TEST_F(Film, Pictures) {
  struct Case {
    const char *name, *first, *last;
  };
  for (const Case c : {Case{"a-%04d.png", "a-0007.png", "a-0012.png"}, Case{"%d.png", "7.png", "12.png"},
                       Case{"b%05dz.PNG", "b00007z.PNG", "b00012z.PNG"}}) {
    FilmOptions o = options(c.name);
    o.first_number = 7;
    o.jobs = 3;
    const auto made = make_film(o, gray_steps());
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(files().size(), 6u);
    EXPECT_TRUE(fs::exists(folder_ / c.first)) << c.name;
    ASSERT_TRUE(fs::exists(folder_ / c.last)) << c.name;
    const auto last = read_picture((folder_ / c.last).string());
    ASSERT_TRUE(last);
    EXPECT_EQ((*last)->rgba, plain(64, 48, {100, 100, 100}).rgba);
    for (const std::string& f : files()) fs::remove(folder_ / f);
  }
}

TEST_F(Film, NamesThatLookLikeSomethingElse) {
  for (const std::string name : {"-i.mp4", "a:b.mp4", "$(touch x) 'q' \".mp4", "100% sure.mp4", "ünïcode 🎬.mp4"}) {
    FilmOptions o = options(name, 2);
    const auto made = make_film(o, gray_steps());
    ASSERT_TRUE(made) << name << ": " << made.error().message;
    EXPECT_EQ(files(), std::vector<std::string>{name});
    fs::remove(o.path);
  }
  const std::string longest(251, 'x');
  EXPECT_TRUE(make_film(options(longest + ".mp4"), gray_steps()));
}

TEST_F(Film, EndingsNobodyKnows) {
  const std::string known = ".mp4 .webm .mov .gif .apng, or numbered pictures: frame-%04d.png, frame-%04d.exr";
  const auto failure = [&](const std::string& path) {
    FilmOptions o = options("");
    o.path = path;
    const auto made = make_film(o, gray_steps());
    EXPECT_FALSE(made) << path;
    return made ? Error{} : made.error();
  };
  EXPECT_EQ(failure("a.mp5").code, ErrorCode::range);
  EXPECT_EQ(failure("a.mp5").message, "a film cannot have the extension \".mp5\"; known extensions: " + known);
  EXPECT_EQ(failure("a.mp5").hint, "did you mean '.mp4'?");
  EXPECT_EQ(failure("none").message, "\"none\" has no file extension that says what to make");
  EXPECT_EQ(failure("none").hint, known);
  EXPECT_EQ(told(failure("x/.mp4")), "range x/.mp4");
  EXPECT_EQ(failure("x/.mp4").hint, known);
  EXPECT_EQ(told(failure("")), "range");
  EXPECT_EQ(failure("").hint, known);
  for (const std::string name :
       {"a.png", "a%4d.png", "a%04d-%d.png", "a%s.png", "a%.png", "a%012d.png", "a%00d.png", "a%%.png"}) {
    const auto made = make_film(options(name), gray_steps());
    ASSERT_FALSE(made) << name;
    EXPECT_EQ(made.error().message, "the name of numbered pictures needs one number, unlike \"" + name + "\"");
    EXPECT_EQ(made.error().hint, "as in frame-%04d.png; one picture: betwixt frame FILE --at 24f -o NAME.png");
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(Film, PlacesThatAreNone) {
  const auto failure = [&](const std::string& path, bool overwrite = true) {
    FilmOptions o = options("");
    o.path = path, o.overwrite = overwrite;
    const auto made = make_film(o, gray_steps());
    EXPECT_FALSE(made) << path;
    return made ? Error{} : made.error();
  };
  const std::string at = folder_.string();
  EXPECT_EQ(failure(at + "/no/film.mp4").message, "there is no folder " + at + "/no");
  EXPECT_EQ(failure(at + "/no/film.mp4").hint, "create it first: mkdir -p " + at + "/no");
  fs::create_directory(folder_ / "taken.mp4");
  EXPECT_EQ(failure(at + "/taken.mp4").message, at + "/taken.mp4 is a folder");
  std::ofstream(folder_ / "plain");
  EXPECT_EQ(failure(at + "/plain/film.mp4").message, at + "/plain is not a folder");
  std::ofstream(folder_ / "old.mp4");
  EXPECT_EQ(failure(at + "/old.mp4", false).message, at + "/old.mp4 already exists");
  std::ofstream(folder_ / "p3.png");
  EXPECT_EQ(told(failure(at + "/p%d.png", false)), "file");
  EXPECT_TRUE(failure(at + "/p%d.png", false).message.starts_with(at + "/p3.png "));
  EXPECT_EQ(failure("/proc/film.mp4").code, ErrorCode::machine);
  if (::geteuid() != 0) {
    ::chmod((folder_ / "taken.mp4").c_str(), 0500);
    EXPECT_EQ(failure(at + "/taken.mp4/film.mp4").message, "cannot write into " + at + "/taken.mp4: Permission denied");
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"old.mp4", "p3.png", "plain", "taken.mp4"}));
}

}  // namespace
}  // namespace betwixt
