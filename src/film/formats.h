// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a film can be made as, by the ending of its name. Each is a row; what is said of endings follows from the rows.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/film.h"

namespace betwixt {

// A way of coding films, and how much it may lose: ffmpeg's -crf.
struct Codec {
  std::string_view name;
  int worst = 0, usual = 0;
  std::vector<std::string> (*arguments)(const FilmOptions&, const std::string& crf) = nullptr;
  bool alpha = false;  // it keeps what is clear
};

struct Format {
  std::string_view ending;  // ".mp4"
  bool yuv = true;          // ffmpeg gets BT.709 in 4:2:0; else RGBA
  // What ffmpeg is told of what it makes: everything but the file.
  std::vector<std::string> (*arguments)(const FilmOptions&) = nullptr;
  std::string_view sound = {};         // the same of its sound, with blanks between; empty: it has none
  bool alpha = true;                   // it keeps what is clear
  bool deep = false;                   // ffmpeg gets 16 bits a channel
  std::span<const Codec> codecs = {};  // the usual one first; empty: there is nothing to choose, nor a quality
};

std::span<const Format> formats();
// What ffmpeg is told of the film; its options have been checked.
std::vector<std::string> arguments_of(const Format&, const FilmOptions&);
const Format* find_format(std::string_view ending);  // null: there is none such
std::string film_endings();                          // ".mp4 .webm …"

}  // namespace betwixt
