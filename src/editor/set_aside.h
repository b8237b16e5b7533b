// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands of a history that fail when they are carried out again. A file beside the script keeps them, so that nothing
// is lost and the other commands can run.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"
#include "editor/step.h"

namespace betwixt {

struct SetAside {
  std::string where;  // "command 12 of the journal"
  Step step;
  std::string why;
};

// FILE.set-aside
std::string set_aside_path(const std::string& script);
// Appends commands to that file, each below a comment with the reason. Does not add a command twice. The file is on the
// disk when this returns. Errors: file, machine.
Status set_aside(const std::string& script, std::span<const SetAside> commands);
// A text without the lines that have errors and without their rows.
struct Mended {
  std::string text;
  std::vector<SetAside> lines;
};
// Returns nullopt if one of the errors is in another file than `name`, or after the first `bytes` of the text.
std::optional<Mended> without_errors(std::string_view text, const std::string& name, std::size_t bytes,
                                     const Diagnostics& errors);
// Returns the reason of a refusal: the first error.
std::string why_refused(const Diagnostics&);
// Returns the warning for the user who starts the program. `commands` must not be empty.
std::string set_aside_message(const std::string& script, std::span<const SetAside> commands);

}  // namespace betwixt
