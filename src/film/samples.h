// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sound of a film, or a text, for the encoder: an unnamed file, which is removed with its owner.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "betwixt/film.h"

namespace betwixt {

class Samples {
 public:
  Samples() = default;
  ~Samples();
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  // Fills a file in `folder` with the film's samples. Errors: machine (disk full, not writable), those of the sounds.
  Status make(const FilmOptions&, const std::string& folder);
  // Fills a file with a text for the encoder. Errors: machine.
  Status make(std::string_view text, const FilmOptions&, const std::string& folder);
  bool made() const { return file_ >= 0; }
  std::string path() const;  // for other programs, during its lifetime

 private:
  int file_ = -1;
};

}  // namespace betwixt
