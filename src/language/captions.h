// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Captions: what is spoken, in pieces of at most two lines that are cut at pauses and punctuation.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/time.h"
#include "scene/document.h"
#include "scene/spoken_words.h"

namespace betwixt {

struct Caption {
  double start = 0, end = 0;  // seconds
  std::string text;           // one line or two, with a line feed between them
};

struct CaptionStyle {
  std::size_t words = 12;    // at most, in a caption
  std::size_t letters = 42;  // at most, in a line
};

// Returns the words of a sound that are heard, with their times in the film.
std::vector<SpokenWord> words_heard(const Scene&, ObjectId sound);

std::vector<Caption> captions_of(std::span<const SpokenWord>, const CaptionStyle& = {});
// Returns the name of the text that shows those of a sound.
std::string captions_name(std::string_view sound);
// Returns those of all sounds that have words, by time: as the film shows them, if it does.
std::vector<Caption> captions_of_film(const Scene&);
// Returns those between two times, counted from the first.
std::vector<Caption> captions_between(const std::vector<Caption>&, double first, double last);

std::string write_srt(const std::vector<Caption>&);
std::string write_webvtt(const std::vector<Caption>&);

}  // namespace betwixt
