// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats of films, by extension. Each is a row, and everything about an extension follows from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/film.h"

namespace betwixt {

// A codec, and the range of its quality (ffmpeg's -crf).
struct Codec {
  std::string_view name;
  int worst = 0, usual = 0;
  std::vector<std::string> (*arguments)(const FilmOptions&, const std::string& crf) = nullptr;
  bool alpha = false;  // keeps transparency
  bool deep = false;   // has 10 bits, for other colours than those of sRGB
};

struct Format {
  std::string_view ending;  // ".mp4"
  bool yuv = true;          // ffmpeg gets BT.709 in 4:2:0; otherwise RGBA
  // The arguments of ffmpeg for the pictures, without the file.
  std::vector<std::string> (*arguments)(const FilmOptions&) = nullptr;
  std::string_view sound = {};         // the arguments for the sound, with blanks between; "": it has none
  bool alpha = true;                   // keeps transparency
  bool sixteen_bits = false;           // ffmpeg gets 16 bits a channel
  std::string_view captions = {};      // the codec of a text track; "": it has none
  bool wide = false;                   // can have other colours than those of sRGB
  std::span<const Codec> codecs = {};  // the default first; if empty, the film has no codecs and no quality to choose
};

std::span<const Format> formats();
// Returns the arguments of ffmpeg for a film whose options have been checked.
std::vector<std::string> arguments_of(const Format&, const FilmOptions&);
const Format* find_format(std::string_view ending);  // null if there is none
// Returns the arguments that say how the colours are coded, before or after the input.
std::vector<std::string> color_tags(ColorCoding);
// Errors: range (a kind of file without such colours).
Status check_colors(const std::string& path, ColorCoding, bool alpha);
std::string film_endings();  // ".mp4 .webm …"

}  // namespace betwixt
