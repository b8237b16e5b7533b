// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Declarations that the subcommands share.
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

// Prints an error to standard error. Returns the exit code: machine_failed for errors of the machine, otherwise the
// given one.
int complain(const Error&, int otherwise);

// Prints a diagnostic of a script to standard error. One without a place begins with the program's name.
void tell_user(const Diagnostic&);

// The options --read-anywhere and --tex.
LoadOptions& load_options();

// Loads a script; "-" is standard input.
Loaded load_script(const std::string& file);
// The same, and prints its errors and warnings to standard error. Returns nullopt if it has errors.
std::optional<Document> open_script(const std::string& file);

// Reads a time from the command line; a bare number is a frame. Errors name the option.
Result<Time> read_time(const std::string& text, const Document&, const std::string& option);

// `text`: "A..B", "A.." to the end of the film, or "" for the document's own range. Errors quote the text.
Result<FrameList> read_frames(const std::string& text, const Document&, const std::string& option = "--frames");

// The frames of a section, for read_frames().
std::string section_frames(const std::string& name);

// Prints errors of procedures to standard error, each only once. Any thread may call it.
class Problems {
 public:
  void say(const std::vector<std::string>&);
  void known(const std::string& problem) { said_.insert(problem); }  // already printed

 private:
  std::mutex mutex_;
  std::set<std::string> said_;
};

// After this call Ctrl-C, SIGTERM and SIGHUP only set stop_requested().
void catch_stops();
bool stop_requested();
void release_stops();  // the signals end the program again

struct PictureCall;

// Commands of the shell that need a document. `frames`: "A..B", or "" for all.
Status plot_document(const Document&, const std::vector<std::string>& targets, const std::string& frames,
                     const std::string& out);
// Stores changes that the user makes by keys in `picture`.
Status play_document(const Document&, const std::string& frames, PictureCall& picture);
// Sets a style, a number of samples or a size, and returns a text with the new value. Errors: range, name.
Result<std::string> change_picture(PictureCall&, const Document&, const std::string& what, const std::string& value);

}  // namespace betwixt
