// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Films of plain pictures in a temporary folder, and the output of other programs about them.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "betwixt/film.h"
#include "support/folder.h"

namespace betwixt {

namespace fs = std::filesystem;
using Rgb = std::array<int, 3>;

inline Picture plain(int width, int height, Rgb c) {
  Picture p{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    for (const int v : {c[0], c[1], c[2], 255}) p.rgba.push_back(static_cast<std::uint8_t>(v));
  return p;
}

// Runs a command in a shell and returns its output. The arguments must come from the tests.
inline std::string output_of(const std::string& command) {
  std::string all;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 65536> some;
  for (std::size_t n; (n = std::fread(some.data(), 1, some.size(), pipe)) > 0;) all.append(some.data(), n);
  ::pclose(pipe);
  return all;
}

inline std::string probe(const fs::path& film, const std::string& what) {
  std::string s = output_of("ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + what +
                            " -of csv=p=0 '" + film.string() + "'");
  while (!s.empty() && (s.back() == '\n' || s.back() == ',')) s.pop_back();
  return s;
}

inline std::string decode(const fs::path& film, const std::string& format, const std::string& by = "") {
  return output_of("ffmpeg -v error " + by + " -i '" + film.string() + "' -f rawvideo -pix_fmt " + format + " -");
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
  // Returns the names of all files in the folder, hidden ones too.
  std::vector<std::string> files() const { return own_.names(); }
  // Puts a fake ffmpeg with this script first in PATH, or makes it the only program in PATH.
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

inline std::function<Result<Painter>()> painting(std::function<Status(int, Picture&)> paint) {
  return [paint]() -> Result<Painter> { return Painter(paint); };
}
inline auto gray_steps(int width = 64, int height = 48) {
  return painting([=](int k, Picture& out) -> Status {
    out = plain(width, height, {20 * k, 20 * k, 20 * k});
    return Nothing{};
  });
}

inline const std::vector<std::string> movies{"film.mp4", "film.webm", "film.mov", "film.gif", "film.apng"};

}  // namespace betwixt
