// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A page with the differences of two films: the words, and pictures of both.
#pragma once

#include <string>
#include <vector>

#include "betwixt/compare.h"
#include "film/frames_apart.h"

namespace betwixt {

struct DiffPicture {
  std::string title;  // "frame 55: up to 83 of 255 in 1204 pixels"
  Picture old, now;
};
// Returns the page, whole in itself: no scripts, and no files beside it. `frames`: the sentence about all frames.
Result<std::string> diff_page(const std::string& title, const std::vector<FilmChange>&, const std::string& frames,
                              const std::vector<DiffPicture>&);

}  // namespace betwixt
