// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the pictures of two films, byte by byte.
#pragma once

#include <functional>
#include <vector>

#include "betwixt/film.h"

namespace betwixt {

// How far two pictures are apart.
struct PictureDifference {
  int most = 0;            // the largest difference of a channel, of 255
  std::size_t pixels = 0;  // how many pixels differ
};
// Pictures of different sizes differ everywhere.
PictureDifference difference(const Picture&, const Picture&);
// Returns a picture of the differences: black where both are equal, brighter where they are further apart.
Picture picture_of_difference(const Picture&, const Picture&);

struct FrameApart {
  int index = 0;  // of the frame, from 0
  PictureDifference by;
};
// Draws all frames of both films with several threads, and returns those whose pictures differ in any byte. `done` is
// called for each frame, by any thread; it returns false to stop. Errors: those of make_renderer, machine (stopped).
Result<std::vector<FrameApart>> frames_apart(const Program& old, const Program& now, const FrameList&,
                                             const RenderOptions&, const std::function<bool()>& done = {});
// Draws one frame of a film, as frames_apart() does.
Result<Picture> picture_at(const Program&, Time, const RenderOptions&);

}  // namespace betwixt
