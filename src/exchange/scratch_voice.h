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
  int speed = 150;            // words a minute
  double pause = 0.4;         // seconds between paragraphs
  double longest = 4 * 3600;  // seconds
};

// Each line of the text is a paragraph. Errors: machine (espeak-ng is not installed), name (no such voice), range (no
// words, more than `longest`).
Result<ScratchVoice> say_text(std::string_view text, const VoiceChoice&);
// The bytes of a WAV file.
std::string wave_of(const ScratchVoice&);

// The files of a folder in which a text is said: the text, the voice, its words, and what was wrong: the code of the
// error, its message, and in a second line its hint.
inline constexpr const char *speech_text = "text", *speech_wave = "said.wav", *speech_words = "said.words",
                            *speech_error = "wrong";
// Errors: those of say_text, and those of files.
Status say_in_folder(const std::string& folder, VoiceChoice);

}  // namespace betwixt
