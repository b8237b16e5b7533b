// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The programs ffmpeg and ffprobe in a jail (parser_jail.h), reading one file.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/result.h"
#include "exchange/parser_messages.h"

namespace betwixt {

// The arguments with which both open a file: only this one, and only in a format that, unlike playlists, does not refer
// to other files.
std::vector<std::string> arguments_for_reading(const std::string& path);

class JailedReader {
 public:
  JailedReader() = default;
  JailedReader(const JailedReader&) = delete;
  JailedReader& operator=(const JailedReader&) = delete;
  ~JailedReader();

  // `what`: what needs it, in the plural, for the message if it is not installed. Errors: machine.
  Status start(const std::string& program, const std::vector<std::string>& arguments, const std::string& path,
               const ParserCeilings&, const std::string& what);
  // Reads more of its output. Returns 0 at the end, or if it took too long. Counts only the time spent waiting for it.
  std::size_t read(std::span<char> into);
  // Waits for more of what it writes to standard error, as far as that is kept. Returns false at the end.
  bool listen();
  // What it has written to standard error, as far as that is kept; you may take some away.
  std::string& said() { return said_; }
  void keep_of_said(std::size_t bytes) { most_said_ = bytes; }
  // Waits for its end. If it has failed by itself, returns what `explain` makes of the last line that it said, or of
  // "". Errors: also machine, file (it took too long).
  Status finish(const std::function<Error(const std::string& why)>& explain);

 private:
  void limit() const;

  std::string path_;
  ParserCeilings most_;
  std::chrono::steady_clock::duration waited_{};
  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;
  std::string said_;
  std::size_t most_said_ = 4096;
};

// Returns the size of a file in bytes. Errors, in our own words: file.
Result<std::uint64_t> size_of_file(const std::string& path);

}  // namespace betwixt
