// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts that a film says. The film names such a sound as a file: say:VOICE:PACE:TEXT.
#pragma once

#include <string>
#include <string_view>

#include "betwixt/result.h"
#include "betwixt/value.h"

namespace betwixt {

inline constexpr int slowest_pace = 80, usual_pace = 150, fastest_pace = 450;  // words a minute
inline constexpr std::string_view usual_voice = "en-us";

struct SayText {
  std::string text, voice{usual_voice};
  int pace = usual_pace;
};

// Returns whether the name of a sound's file means a text.
bool names_said_text(std::string_view name);
std::string said_name(const SayText&);
// Writes it as `create` takes it: say="TEXT", with voice= and pace= where they are not the usual ones.
std::string write_said(std::string_view name);
// Writes a value that is set at `create` as NAME=VALUE, and a text that is said as above.
std::string write_setting(const std::string& name, const Value&, const std::string& value);
// Reads such a name. Errors: syntax, range.
Result<SayText> read_said_name(std::string_view name);
// Returns the name of its files in a page, without their endings: say-3f2a…
std::string said_file(std::string_view name);

}  // namespace betwixt
