// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A voice that reads a text aloud, with the exact time of each word, by the library of espeak-ng. The library is loaded
// when it is needed, so that the program runs without it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"
#include "scene/spoken_words.h"

namespace betwixt {

struct ScratchVoice {
  int rate = 0;                       // samples a second
  std::vector<std::int16_t> samples;  // mono
  SpokenWords words;
};

struct VoiceChoice {
  std::string voice = "en-us";
  int speed = 150;     // words a minute
  double pause = 0.4;  // seconds between paragraphs
};

// Each line of the text is a paragraph. Errors: machine (espeak-ng is not installed), name (no such voice), range (no
// words, more than four hours).
Result<ScratchVoice> say_text(std::string_view text, const VoiceChoice&);
// The bytes of a WAV file.
std::string wave_of(const ScratchVoice&);

}  // namespace betwixt
