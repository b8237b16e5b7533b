// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Videos from files, through the programs ffprobe and ffmpeg in a jail (parser_jail.h): they open only the given file,
// and no list of other files.
#pragma once

#include <memory>
#include <string>

#include "betwixt/result.h"
#include "scene/video.h"

namespace betwixt {

struct ReadVideo {
  std::shared_ptr<const Video> video;
  std::string warning;  // what of the file cannot be read; "" if it is whole
};
// Reads when the pictures of a video begin, and the first one. The others are read when they are asked for, and some of
// them are kept: see kept_frames.h. Errors: file (missing, unreadable, without pictures), machine (no ffmpeg), range
// (too large, too many pictures).
Result<ReadVideo> read_video(const std::string& path);

}  // namespace betwixt
