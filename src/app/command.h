// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the subcommands share.
#pragma once

#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "betwixt/film.h"
#include "betwixt/language.h"
#include "betwixt/render.h"

namespace betwixt {

enum Exit { all_done = 0, wrong_input = 1, wrong_call = 2, machine_failed = 3, interrupted = 130 };

// Says an error on standard error. The exit code: machine_failed where the machine is to blame, else `otherwise`.
int complain(const Error&, int otherwise);

// Says a remark on a script on standard error. One without a place begins with the program's name.
void tell_user(const Diagnostic&);

// What --read-anywhere and --tex say.
LoadOptions& load_options();

// Loads a script, from standard input where it is "-".
Loaded load_script(const std::string& file);
// The same, saying its errors and warnings on standard error; none where it has errors.
std::optional<Document> open_script(const std::string& file);

// A time of the command line; a bare number is a frame. Errors name the option.
Result<Time> read_time(const std::string& text, const Document&, const std::string& option);

// `text`: "A..B", "A.." to the end of the film, or empty for the document's own range. Errors name what was said.
Result<FrameList> read_frames(const std::string& text, const Document&, const std::string& option = "--frames");

// Says on standard error what procedures did wrong, each thing once. From any thread.
class Problems {
 public:
  void say(const std::vector<std::string>&);
  void known(const std::string& problem) { said_.insert(problem); }  // it has been said

 private:
  std::mutex mutex_;
  std::set<std::string> said_;
};

// From here on Ctrl-C and friends only ask the program to stop.
void catch_stops();
bool stop_requested();
void release_stops();  // they end the program again

struct PictureCall;

// What the shell does with a document. `frames`: "A..B", or empty for all.
Status plot_document(const Document&, const std::vector<std::string>& targets, const std::string& frames,
                     const std::string& out);
// What keys have changed of how it is drawn stays in `picture`.
Status play_document(const Document&, const std::string& frames, PictureCall& picture);
// Sets a style, a number of samples or a size, and says what it is then. Errors: range, name.
Result<std::string> change_picture(PictureCall&, const Document&, const std::string& what, const std::string& value);

}  // namespace betwixt
