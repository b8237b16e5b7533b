// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film's sound on its way to the encoder: in a file without a name, which goes with whoever made it.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "betwixt/film.h"

namespace betwixt {

class Samples {
 public:
  Samples() = default;
  ~Samples();
  Samples(const Samples&) = delete;
  Samples& operator=(const Samples&) = delete;

  // As many as the film is long, in its folder. Errors: machine (disk full, not writable), those of the sounds.
  Status make(const FilmOptions&, const std::string& folder);
  bool made() const { return file_ >= 0; }
  std::string path() const;  // for other programs, while this lives

 private:
  int file_ = -1;
};

}  // namespace betwixt
