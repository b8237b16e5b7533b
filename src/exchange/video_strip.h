// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The pictures of a video that a page shows, as one file of JPEGs, because a page cannot decode videos by itself
// exactly.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

struct VideoStrip {
  int width = 0, height = 0;
  double aspect = 1;
  std::int64_t end = 0, slack = 0;    // as in Video
  std::vector<std::int64_t> begins;   // of the pictures, ascending
  std::vector<std::string> pictures;  // as many JPEGs
};

inline constexpr std::string_view strip_ending = ".pictures";  // behind the name of the video's file

std::string write_strip(const VideoStrip&);
// Errors: file.
Result<VideoStrip> read_strip(std::string_view bytes, const std::string& name);

}  // namespace betwixt
