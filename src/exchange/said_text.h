// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Says the texts of films with the voice of espeak-ng. The speech is made in a process without rights (parser_jail.h),
// since the text can be a stranger's. Pages have the sound and its words as files.
#pragma once

#include <memory>
#include <string>

#include "betwixt/result.h"
#include "betwixt/sound.h"
#include "scene/say_text.h"
#include "scene/spoken_words.h"

namespace betwixt {

struct SaidText {
  std::string wave;  // the path of a .wav
  std::shared_ptr<const Sound> sound;
  std::shared_ptr<const SpokenWords> words;
};
// Says a text, once in a process as long as the result is used, or was lately. Errors: those of read_said_name; machine
// (espeak-ng is not installed), name (no such voice), range (more than 24 minutes).
Result<std::shared_ptr<const SaidText>> say_named(const std::string& name);

}  // namespace betwixt
