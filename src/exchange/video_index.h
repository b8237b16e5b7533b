// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// When the pictures of a video begin, and from where on they can be decoded.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "betwixt/result.h"
#include "exchange/parser_messages.h"

namespace betwixt {

// In steps of the file's clock.
struct VideoIndex {
  int width = 0, height = 0;  // as its pictures are shown
  double aspect = 1;
  std::string decoder;                        // the one to use; "": the usual one
  bool vague_colors = false;                  // the file does not say how its colours are meant
  std::int64_t clock_num = 0, clock_den = 1;  // seconds a step
  std::int64_t rate_num = 0, rate_den = 1;    // pictures a second, if it says so
  std::vector<std::int64_t> times;            // of the pictures, ascending
  std::int64_t last = 0;                      // how long the last one is shown
  std::vector<std::size_t> keys;              // the pictures that need no others; empty: unknown
  std::string complaint;                      // of the program that read it
};

inline constexpr int most_video_side = 8192;
inline constexpr std::size_t most_video_pictures = 1'000'000;

// `most`: the limits of the program that reads it. Errors: file, machine, range.
Result<VideoIndex> index_video(const std::string& path, const ParserCeilings& most);
// Fills in what the lines of ffprobe say; returns false if they mention no stream of pictures.
bool take_lines(const std::string& lines, VideoIndex&);

// Flicks: when the pictures begin, from 0, and when the last one ends; and how far the times may be rounded.
struct VideoTimes {
  std::vector<std::int64_t> begins;
  std::int64_t end = 0, slack = 0;
};
VideoTimes times_of(const VideoIndex&);

}  // namespace betwixt
