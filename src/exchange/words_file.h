// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that say when the words of a recording are spoken: lines `start end word`, WebVTT, SRT, Whisper's JSON, Praat's
// TextGrid, Audacity's labels. If a file has times of sentences only, each word gets a part of the time that is
// proportional to its letters.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "betwixt/result.h"
#include "scene/spoken_words.h"

namespace betwixt {

// `name`: its ending chooses the format where the content does not, and messages name it. Errors: file (what is wrong,
// with its line and column), range (too many words).
Result<std::shared_ptr<const SpokenWords>> read_words(std::string_view text, const std::string& name);
// Errors: those, and file (missing, unreadable, above 64 MiB).
Result<std::shared_ptr<const SpokenWords>> load_words(const std::string& path);

// Returns a time as seconds with three digits, as these files have them.
std::string write_words(const SpokenWords&);  // lines `start end word`

}  // namespace betwixt
