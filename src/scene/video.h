// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Videos: when each of their pictures begins, and which of them is shown at a time of the film.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

// A file of pictures that follow each other. The pictures are read when they are needed.
class Video {
 public:
  virtual ~Video() = default;

  int width = 0, height = 0;         // of its pictures, as they are shown
  double aspect = 1;                 // width / height as it is shown; pixels need not be squares
  std::vector<std::int64_t> begins;  // the flick at which each picture begins, ascending from 0
  std::int64_t end = 0;              // the flick at which the last one ends
  std::int64_t slack = 0;            // flicks: half a step of the file's clock, to which its times are rounded

  double seconds() const;
  // Returns the last picture that has begun at this second of the file, or the first one.
  std::size_t picture_at(double second) const;
  // Returns a picture, never null. Errors: file, machine.
  virtual Result<std::shared_ptr<const Picture>> picture(std::size_t number) const = 0;
};

// Which part of a video is shown, and how. `at`: seconds of the film; `from` and `until`: of the file.
struct VideoPart {
  double at = 0, from = 0, until = 0, speed = 1;
  bool loop = false;
};
// Returns the number of the picture that is shown at a second of the film. Before `at` it is that of `at`; after the
// end, the last one.
std::size_t picture_shown(const Video&, const VideoPart&, double film);
// Returns the number of the picture at a second of the file; a loop has no end.
std::size_t picture_at_time(const Video&, double second, bool loop);

// Returns whether a file is taken for a video and not for a picture, by its ending.
bool names_video(const std::string& path);

}  // namespace betwixt
