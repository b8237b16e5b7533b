// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/film.h"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "betwixt/picture.h"
#include "film/output.h"
#include "film/sink.h"
#include "support/folder.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;
using Rgb = std::array<int, 3>;

Picture plain(int width, int height, Rgb c) {
  Picture p{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    for (const int v : {c[0], c[1], c[2], 255}) p.rgba.push_back(static_cast<std::uint8_t>(v));
  return p;
}

// What a program prints; the arguments are the tests' own.
std::string output_of(const std::string& command) {
  std::string all;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 65536> some;
  for (std::size_t n; (n = std::fread(some.data(), 1, some.size(), pipe)) > 0;) all.append(some.data(), n);
  ::pclose(pipe);
  return all;
}

std::string probe(const fs::path& film, const std::string& what) {
  std::string s = output_of("ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + what +
                            " -of csv=p=0 '" + film.string() + "'");
  while (!s.empty() && (s.back() == '\n' || s.back() == ',')) s.pop_back();
  return s;
}

std::string decode(const fs::path& film, const std::string& format) {
  return output_of("ffmpeg -v error -i '" + film.string() + "' -f rawvideo -pix_fmt " + format + " -");
}

class Film : public testing::Test {
 protected:
  void SetUp() override { path_ = std::getenv("PATH"); }
  void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }

  FilmOptions options(const std::string& name, int frames = 6) const {
    FilmOptions o;
    o.path = (folder_ / name).string();
    o.frames = frames, o.width = 64, o.height = 48;
    return o;
  }
  // Everything in the folder, hidden things too.
  std::vector<std::string> files() const { return own_.names(); }
  // Puts a program of that name before all others, or alone.
  void fake_ffmpeg(const std::string& script, bool alone = false) {
    const fs::path bin = folder_ / "bin";
    fs::create_directory(bin);
    std::ofstream(bin / "ffmpeg") << "#!/bin/sh\n" << script << '\n';
    ::chmod((bin / "ffmpeg").c_str(), 0755);
    ::setenv("PATH", alone ? bin.c_str() : (bin.string() + ":" + path_).c_str(), 1);
  }

  const Folder own_;
  const fs::path folder_ = own_.path();
  std::string path_;
};

std::function<Result<Painter>()> painting(std::function<Status(int, Picture&)> paint) {
  return [paint]() -> Result<Painter> { return Painter(paint); };
}
auto gray_steps(int width = 64, int height = 48) {
  return painting([=](int k, Picture& out) -> Status {
    out = plain(width, height, {20 * k, 20 * k, 20 * k});
    return Nothing{};
  });
}

const std::vector<std::string> movies{"film.mp4", "film.webm", "film.gif", "film.apng"};

// shows: G56
TEST_F(Film, EveryEndingHasAllFramesAtItsRate) {
  for (const std::string& name : movies) {
    FilmOptions o = options(name, 10);
    o.rate = {25, 1};
    const auto made = make_film(o, gray_steps());
    ASSERT_TRUE(made) << name << ": " << made.error().message;
    EXPECT_EQ(made->frames, 10);
    EXPECT_EQ(probe(o.path, "width,height,r_frame_rate,nb_read_frames"), "64,48,25/1,10") << name;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"film.apng", "film.gif", "film.mp4", "film.webm"}));
}

TEST_F(Film, RatesAreExactFractions) {
  FilmOptions o = options("ntsc.mp4");
  o.rate = {30000, 1001};
  ASSERT_TRUE(make_film(o, gray_steps()));
  EXPECT_EQ(probe(o.path, "r_frame_rate"), "30000/1001");
}

TEST_F(Film, EndingsMayBeCapitals) {
  ASSERT_TRUE(make_film(options("LOUD.MP4"), gray_steps()));
  EXPECT_EQ(files(), std::vector<std::string>{"LOUD.MP4"});
}

TEST_F(Film, GifAndApngLoopForEver) {
  for (const std::string name : {"film.gif", "film.apng"}) ASSERT_TRUE(make_film(options(name), gray_steps()));
  // GIF: the application extension with a count of 0. APNG: acTL with num_plays 0.
  EXPECT_NE(own_.get("film.gif").find(std::string("NETSCAPE2.0\x03\x01\0\0", 15)), std::string::npos);
  const std::string apng = own_.get("film.apng");
  const std::size_t at = apng.find("acTL");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(apng.substr(at + 4, 8), std::string("\0\0\0\6\0\0\0\0", 8));
}

TEST_F(Film, Mp4StartsWithItsIndex) {
  ASSERT_TRUE(make_film(options("film.mp4"), gray_steps()));
  const std::string all = own_.get("film.mp4");
  EXPECT_LT(all.find("moov"), all.find("mdat"));
}

// BT.709 by its definition, from the decoded planes: what comes back is what was painted.
TEST_F(Film, PureColorsComeBack) {
  const std::vector<Rgb> colors{{255, 0, 0},   {0, 255, 0},     {0, 0, 255}, {255, 255, 0},   {0, 255, 255},
                                {255, 0, 255}, {255, 255, 255}, {0, 0, 0},   {128, 128, 128}, {255, 215, 0}};
  for (const std::string name : {"film.mp4", "film.webm"}) {
    FilmOptions o = options(name, static_cast<int>(colors.size()));
    ASSERT_TRUE(make_film(o, painting([&](int k, Picture& out) -> Status {
                            out = plain(64, 48, colors[static_cast<std::size_t>(k)]);
                            return Nothing{};
                          })));
    EXPECT_EQ(probe(o.path, "color_space,color_range"), "tv,bt709") << name;
    const std::string yuv = decode(o.path, "yuv420p");
    const std::size_t size = 64 * 48 * 3 / 2;
    ASSERT_EQ(yuv.size(), size * colors.size()) << name;
    for (std::size_t k = 0; k < colors.size(); ++k) {
      const auto at = [&](std::size_t i) { return static_cast<double>(static_cast<unsigned char>(yuv[k * size + i])); };
      const double y = (at(64 * 24 + 32) - 16) / 219;
      const double cb = (at(64 * 48 + 32 * 12 + 16) - 128) / 224, cr = (at(64 * 60 + 32 * 12 + 16) - 128) / 224;
      const double r = y + 2 * (1 - 0.2126) * cr, b = y + 2 * (1 - 0.0722) * cb;
      const double g = (y - 0.2126 * r - 0.0722 * b) / 0.7152;
      EXPECT_NEAR(255 * r, colors[k][0], 5) << name << " " << k;
      EXPECT_NEAR(255 * g, colors[k][1], 5) << name << " " << k;
      EXPECT_NEAR(255 * b, colors[k][2], 5) << name << " " << k;
    }
    // A player that looks at the tags gets the same.
    const std::string rgb = decode(o.path, "rgb24");
    for (std::size_t k = 0; k < colors.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<unsigned char>(rgb[(k * 64 * 48 + 64 * 24 + 32) * 3 + c]), colors[k][c], 8)
            << name << " " << k;
  }
}

TEST_F(Film, ApngKeepsEveryBit) {
  std::mt19937 random(7);
  Picture noise{64, 48, {}};
  for (int i = 0; i < 64 * 48 * 4; ++i)
    noise.rgba.push_back(static_cast<std::uint8_t>(i % 4 == 3 ? 255 : random() & 255));
  FilmOptions o = options("film.apng", 1);
  ASSERT_TRUE(make_film(o, painting([&](int, Picture& out) -> Status { return out = noise, Nothing{}; })));
  EXPECT_EQ(decode(o.path, "rgba"), std::string(noise.rgba.begin(), noise.rgba.end()));
}

TEST_F(Film, OddSizesBecomeEvenByRepeatingTheEdge) {
  for (const std::string name : {"odd.mp4", "odd.webm"}) {
    FilmOptions o = options(name, 2);
    o.width = 33, o.height = 17;
    ASSERT_TRUE(make_film(o, painting([](int, Picture& out) -> Status {
                            out = plain(33, 17, {255, 255, 255});
                            return Nothing{};
                          })));
    EXPECT_EQ(probe(o.path, "width,height"), "34,18") << name;
    const std::string gray = decode(o.path, "gray");
    EXPECT_GT(static_cast<unsigned char>(gray[34 * 18 - 1]), 230) << name;  // the corner that was added
  }
}

TEST_F(Film, ASinglePixelIsAFilmToo) {
  for (const std::string& name : movies) {
    FilmOptions o = options(name, 2);
    o.width = o.height = 1;
    const auto made = make_film(o, gray_steps(1, 1));
    EXPECT_TRUE(made) << name << ": " << made.error().message;
  }
}

TEST_F(Film, ManyPaintersKeepTheOrder) {
  FilmOptions o = options("order.apng", 60);
  o.width = o.height = 4;
  o.jobs = 4;
  std::atomic<int> seed{1};
  const auto lazy = [&]() -> Result<Painter> {
    auto random = std::make_shared<std::mt19937>(seed++);
    return Painter([random](int k, Picture& out) -> Status {
      std::this_thread::sleep_for(std::chrono::microseconds((*random)() % 8000));
      out = plain(4, 4, {k, 255 - k, 3 * k});
      return Nothing{};
    });
  };
  ASSERT_TRUE(make_film(o, lazy));
  EXPECT_EQ(seed, 5);  // every job has a painter of its own
  const std::string rgb = decode(o.path, "rgb24");
  ASSERT_EQ(rgb.size(), 60u * 16 * 3);
  for (int k = 0; k < 60; ++k) EXPECT_EQ(static_cast<unsigned char>(rgb[static_cast<std::size_t>(k) * 48]), k);
}

TEST_F(Film, PaintersDoNotRunAheadOfTheEncoder) {
  fake_ffmpeg("exec sleep 1000");  // reads nothing
  FilmOptions o = options("film.mp4", 1000);
  o.width = o.height = 2048;  // 6 MiB a frame: more than the way to the encoder holds
  o.jobs = 3;
  std::atomic<int> painted{0};
  int calls = 0;
  const auto made = make_film(o, painting([&](int, Picture& out) -> Status {
                                ++painted;
                                out = plain(2048, 2048, {1, 2, 3});
                                return Nothing{};
                              }),
                              [&](int done, int, double) {
                                EXPECT_EQ(done, 0);
                                return ++calls < 10;
                              });
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "the film was stopped");
  EXPECT_LE(painted, 6);
  EXPECT_EQ(files(), std::vector<std::string>{"bin"});
}

TEST_F(Film, StoppingLeavesNothing) {
  for (const std::string name : {"film.mp4", "film.gif", "frame-%04d.png"}) {
    FilmOptions o = options(name, 100000);
    const auto made = make_film(o, gray_steps(), [](int done, int, double) { return done < 3; });
    ASSERT_FALSE(made) << name;
    EXPECT_EQ(files(), std::vector<std::string>{}) << name;
  }
}

TEST_F(Film, AnOldFilmStaysWhenTheNewOneFails) {
  FilmOptions o = options("film.mp4");
  std::ofstream(o.path) << "old";
  const auto broken = painting([](int k, Picture& out) -> Status {
    if (k == 4) return fail(ErrorCode::name, "no such color", "did you mean gold?");
    out = plain(64, 48, {0, 0, 0});
    return Nothing{};
  });
  const auto made = make_film(o, broken);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::name);
  EXPECT_EQ(made.error().message, "no such color");
  EXPECT_EQ(made.error().hint, "did you mean gold?");
  std::string word;
  std::ifstream(o.path) >> word;
  EXPECT_EQ(word, "old");
  EXPECT_EQ(files(), std::vector<std::string>{"film.mp4"});
}

TEST_F(Film, OfSeveralFailuresTheFirstInTheFilmIsTold) {
  FilmOptions o = options("film.mp4", 40);
  o.jobs = 4;
  const auto made = make_film(o, painting([](int k, Picture& out) -> Status {
                                if (k < 5) std::this_thread::sleep_for(std::chrono::milliseconds(3));
                                if (k >= 4) return fail(ErrorCode::range, "frame " + std::to_string(k));
                                out = plain(64, 48, {0, 0, 0});
                                return Nothing{};
                              }));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "frame 4");
}

TEST_F(Film, APainterThatCannotBeMadeIsTold) {
  const auto made =
      make_film(options("film.mp4"), []() -> Result<Painter> { return fail(ErrorCode::machine, "no graphics"); });
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "no graphics");
  EXPECT_TRUE(files().empty());
}

TEST_F(Film, APictureOfAnotherSizeIsRefused) {
  const auto made = make_film(options("film.mp4"), gray_steps(32, 48));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "a painter made a picture of 32x48 for a film of 64x48");
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
  const std::string known = ".mp4 .webm .gif .apng, or numbered pictures: frame-%04d.png";
  const auto failure = [&](const std::string& path) {
    FilmOptions o = options("");
    o.path = path;
    const auto made = make_film(o, gray_steps());
    EXPECT_FALSE(made) << path;
    return made ? Error{} : made.error();
  };
  EXPECT_EQ(failure("a.mp5").code, ErrorCode::range);
  EXPECT_EQ(failure("a.mp5").message, "a film cannot end in \".mp5\"; known endings: " + known);
  EXPECT_EQ(failure("a.mp5").hint, "did you mean '.mp4'?");
  EXPECT_EQ(failure("none").message, "\"none\" has no ending that says what to make");
  EXPECT_EQ(failure("none").hint, known);
  EXPECT_EQ(failure("x/.mp4").message, "\"x/.mp4\" has no ending that says what to make");
  EXPECT_EQ(failure("").message, "\"\" has no ending that says what to make");
  for (const std::string name :
       {"a.png", "a%4d.png", "a%04d-%d.png", "a%s.png", "a%.png", "a%012d.png", "a%00d.png", "a%%.png"}) {
    const auto made = make_film(options(name), gray_steps());
    ASSERT_FALSE(made) << name;
    EXPECT_EQ(made.error().message, "a film as pictures needs one number in its name, not \"" + name + "\"");
    EXPECT_EQ(made.error().hint, "such as frame-%04d.png");
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(Film, NumbersOutOfBounds) {
  const auto message = [&](auto change) {
    FilmOptions o = options("film.mp4");
    change(o);
    const auto made = make_film(o, gray_steps());
    EXPECT_FALSE(made);
    return made ? "" : made.error().message;
  };
  EXPECT_EQ(message([](FilmOptions& o) { o.frames = 0; }), "a film needs at least one frame");
  EXPECT_EQ(message([](FilmOptions& o) { o.width = 0; }), "a picture of 0x48 is not possible: 1 to 8192 pixels a side");
  EXPECT_EQ(message([](FilmOptions& o) { o.height = 9000; }),
            "a picture of 64x9000 is not possible: 1 to 8192 pixels a side");
  EXPECT_EQ(message([](FilmOptions& o) { o.rate = {0, 1}; }), "a film needs a rate above 0");
  EXPECT_EQ(message([](FilmOptions& o) { o.jobs = -1; }), "jobs are 1 to 256");
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
  EXPECT_EQ(failure(at + "/no/film.mp4").hint, "make it first: mkdir -p " + at + "/no");
  fs::create_directory(folder_ / "taken.mp4");
  EXPECT_EQ(failure(at + "/taken.mp4").message, at + "/taken.mp4 is a folder");
  std::ofstream(folder_ / "plain");
  EXPECT_EQ(failure(at + "/plain/film.mp4").message, at + "/plain is no folder");
  std::ofstream(folder_ / "old.mp4");
  EXPECT_EQ(failure(at + "/old.mp4", false).message, at + "/old.mp4 is there already");
  std::ofstream(folder_ / "p3.png");
  EXPECT_EQ(failure(at + "/p%d.png", false).message, at + "/p3.png is there already");
  EXPECT_EQ(failure("/proc/film.mp4").code, ErrorCode::machine);
  if (::geteuid() != 0) {
    ::chmod((folder_ / "taken.mp4").c_str(), 0500);
    EXPECT_EQ(failure(at + "/taken.mp4/film.mp4").message, "cannot write into " + at + "/taken.mp4: Permission denied");
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"old.mp4", "p3.png", "plain", "taken.mp4"}));
}

TEST_F(Film, WithoutFfmpeg) {
  ::setenv("PATH", folder_.c_str(), 1);
  const auto made = make_film(options("film.mp4"), gray_steps());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::machine);
  EXPECT_EQ(made.error().message, "ffmpeg is not installed");
  EXPECT_EQ(made.error().hint, "sudo apt-get install ffmpeg");
  EXPECT_TRUE(files().empty());
  EXPECT_TRUE(make_film(options("frame%d.png"), gray_steps()));  // pictures do not need it
}

TEST_F(Film, FfmpegDiesHalfWay) {
  struct Case {
    const char *script, *message;
  };
  for (const Case c :
       {Case{"head -c 20000 >/dev/null; kill -9 $$", "ffmpeg was ended from outside by signal 9 (Killed)"},
        Case{"echo one >&2; echo two >&2; echo three >&2; echo four >&2; exit 1", "ffmpeg failed: two; three; four"},
        Case{"cat >/dev/null; echo 'late trouble' >&2; exit 1", "ffmpeg failed: late trouble"},
        Case{"exit 1", "ffmpeg failed: it did not say why"},
        Case{"head -c 20000 >/dev/null", "ffmpeg stopped before the end of the film"},
        Case{"cat >/dev/null; echo 'Error: No space left on device' >&2; exit 1",
             "the disk is full (ffmpeg said: Error: No space left on device)"}}) {
    fake_ffmpeg(c.script);
    const auto made = make_film(options("film.mp4", 2000), gray_steps());
    ASSERT_FALSE(made) << c.script;
    EXPECT_EQ(made.error().code, ErrorCode::machine);
    EXPECT_EQ(made.error().message, c.message);
    EXPECT_EQ(files(), std::vector<std::string>{"bin"});
  }
}

TEST_F(Film, AFullDisk) {
  const fs::path disk = folder_ / "disk";
  fs::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0) GTEST_SKIP() << "only root can make a small disk";
  const auto noise = painting([](int k, Picture& out) -> Status {
    std::mt19937 random(static_cast<unsigned>(k));
    out = plain(64, 48, {0, 0, 0});
    for (std::size_t i = 0; i < out.rgba.size(); ++i) out.rgba[i] = static_cast<std::uint8_t>(random() & 255);
    return Nothing{};
  });
  for (const std::string name : {"film.mp4", "film.webm", "film.gif", "film.apng", "frame%d.png"}) {
    const auto made = make_film(options("disk/" + name, 200), noise);
    EXPECT_FALSE(made) << name;
    if (made) continue;
    EXPECT_EQ(made.error().code, ErrorCode::machine) << name;
    EXPECT_TRUE(made.error().message.find("the disk is full") != std::string::npos ||
                made.error().message.find("no space left") != std::string::npos)
        << name << ": " << made.error().message;
    EXPECT_TRUE(fs::is_empty(disk)) << name;
  }
  ::umount(disk.c_str());
}

TEST_F(Film, ProgressEndsWithAllFrames) {
  int last = -1;
  FilmOptions o = options("film.mp4", 20);
  const auto made = make_film(o, gray_steps(), [&](int done, int frames, double) {
    EXPECT_GE(done, last);
    EXPECT_EQ(frames, 20);
    return last = done, true;
  });
  ASSERT_TRUE(made);
  EXPECT_EQ(last, 20);
  EXPECT_LE(made->encoding, made->seconds + 1);
}

TEST(FilmArguments, LongGifsDoNotKeepAllTheirPictures) {
  FilmOptions o;
  o.frames = 100000;
  const auto all = encoder_arguments(o, *find_format(".gif"), "x.gif");
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const auto& a) { return a.find("stats_mode=single") != std::string::npos; }));
  EXPECT_EQ(all.back(), "file:x.gif");
}

}  // namespace
}  // namespace betwixt
