// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The target of a film's pictures.
#pragma once

#include <memory>

#include "betwixt/film.h"
#include "film/encoder.h"
#include "film/output.h"

namespace betwixt {

// One picture on its way from a painter to the film.
struct Parcel {
  Picture picture;
  LinearPicture linear;             // in place of the picture, for painters that make these
  std::vector<std::uint8_t> bytes;  // in the encoder's form; if empty, the encoder takes the picture's
};

// Until finish() succeeds there is no file under the film's name; all other files are removed with the sink.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual Status pack(int k, Parcel&) = 0;                   // from the painters' threads, in any order
  virtual Status take(const Parcel&, const KeepGoing&) = 0;  // from one thread, in the order of the film
  virtual Status finish(const KeepGoing&) = 0;
  // Returns true if the picture exists and need not be made. Called from the painters' threads, in any order.
  virtual bool stands(int /*k*/) const { return false; }
  virtual bool single_pictures() const { return false; }
};

Result<std::unique_ptr<Sink>> make_sink(const FilmOptions&);

// Files of what a film has besides its pictures; "" if it has none.
struct EncoderFiles {
  std::string samples, captions, chapters;
};
// Returns ffmpeg's arguments to make `file`. For tests.
std::vector<std::string> encoder_arguments(const FilmOptions&, const Format&, const std::string& file,
                                           const EncoderFiles& = {});

}  // namespace betwixt
