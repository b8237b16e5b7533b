// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors that appear only when frames are evaluated: errors of the author's code, and attachments that are left out.
#pragma once

#include "app/subcommand.h"
#include "base/message_groups.h"
#include "betwixt/program.h"
#include "betwixt/result.h"

namespace betwixt {

struct Findings {
  Diagnostics errors;                 // of the author's code, with their places in the script
  std::vector<std::string> warnings;  // all others
  std::vector<Problem> placed;        // the errors before they got their places
  MessageGroups errors_said, warnings_said;
};
// Evaluates some frames from `first` to `last`, both included, for at most a second or two. Returns the errors found.
Findings look_through(const Program&, const std::string& file, Time first, Time last, int frames);
// Adds the errors of one frame, each only once.
void add_findings(Findings&, const Frame&, const std::string& file);

inline Parameter keep_going_flag(bool& into) {
  return flag("--keep-going", "if code of the script fails, uses the tracks' values without the code", into);
}
// Prints the errors. Returns true if there are any and --keep-going is not set.
bool stopped_by(const Findings&, bool keep_going);

}  // namespace betwixt
