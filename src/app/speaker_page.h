// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a speaker sees: the picture, the next one, the notes and the time. It is a picture that Betwixt draws of a film.
#pragma once

#include <string>

#include "betwixt/render.h"

namespace betwixt {

struct SpeakerView {
  std::string title, note, clock, count;  // of the step; "12:03", "3 / 7"
  const Picture* now = nullptr;
  const Picture* next = nullptr;  // null after the last step
};

class SpeakerPage {
 public:
  // Errors: those of the renderer.
  Status draw(const SpeakerView&, int width, int height, Picture& out);

 private:
  Status draw_words(const SpeakerView&, int width, int height);

  Picture words_;
  std::string drawn_;  // the script of `words_`
};

// Breaks a text into lines of at most so many letters.
std::string in_lines(std::string_view text, std::size_t letters);

}  // namespace betwixt
