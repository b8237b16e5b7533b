// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds when the words of a text are spoken in a recording, with the program pocketsphinx_batch in a process of its
// own.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/result.h"
#include "scene/spoken_words.h"

namespace betwixt {

inline constexpr int speech_rate = 16'000;  // samples a second, as the model of the program needs them

// Receives the seconds of work so far, and an estimate of all. Returns false to stop.
using AlignmentProgress = std::function<bool(double done, double whole)>;

struct Alignment {
  SpokenWords words;
  std::vector<std::string> doubts;  // places where the text may not be what is spoken, for the user
};

// Errors: machine (pocketsphinx or its English model is not installed), file (an unreadable recording, a text that is
// not what is spoken), range (no words, stopped by the user).
Result<Alignment> align_words(const std::string& sound, std::string_view text, const AlignmentProgress&);

// Moves the edges of words at pauses to where the sound begins and ends. `samples`: mono, at speech_rate.
void refine_edges(std::vector<SpokenWord>& words, std::span<const float> samples);

}  // namespace betwixt
