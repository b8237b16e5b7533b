// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What only frames tell: what the author's code does wrong, attachments that are left out.
#pragma once

#include "app/subcommand.h"
#include "base/likewise.h"
#include "betwixt/program.h"
#include "betwixt/result.h"

namespace betwixt {

struct Findings {
  Diagnostics errors;                 // of the author's code, with its place in the script
  std::vector<std::string> warnings;  // all else
  std::vector<std::string> placed;    // what the errors said before they had their places
  Likewise errors_said, warnings_said;
};
// Of some of the frames from `first` to `last`, both among them, for a second or two at most.
Findings look_through(const Program&, const std::string& file, Time first, Time last, int frames);
// Of one frame, each once.
void add_findings(Findings&, const Frame&, const std::string& file);

inline Parameter keep_going_flag(bool& into) {
  return flag("--keep-going", "where code of the script errs, use what the tracks say without it", into);
}
// Says the errors; whether there are any and nobody said --keep-going.
bool stopped_by(const Findings&, bool keep_going);

}  // namespace betwixt
