// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How English words sound, in the phones of the CMU dictionary, for the alignment of a text to a recording.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

// The ways to say each word, in phones with blanks between them: "S K W EH R".
using Pronunciations = std::map<std::string, std::vector<std::string>>;

// Returns pronunciations for each of these words. A word that the dictionary lacks gets one from the program espeak-ng,
// or by rules for letters if that is not installed. `folder` is for temporary files. Errors: those of the dictionary.
Result<Pronunciations> pronunciations(const std::vector<std::string>& words, const std::string& dictionary,
                                      const std::string& folder);
// Returns the phones of what espeak-ng says of a word of American English: "skw'e@" is S K W EH R.
std::string phones_of_espeak(std::string_view said);
// Returns phones by rules for letters and digits. Never empty.
std::string phones_of_letters(std::string_view word);

}  // namespace betwixt
