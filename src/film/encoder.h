// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The ffmpeg program as a child that reads raw frames.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

// Asked several times a second while something is waited for; false: give up.
using KeepGoing = std::function<bool()>;

// What a film that was stopped from outside ends with.
Error stopped();

class Encoder {
 public:
  // Arguments are handed over one by one; no shell reads them. Errors: machine (no such program).
  static Result<std::unique_ptr<Encoder>> start(const std::vector<std::string>& arguments);
  ~Encoder();  // ends the program if it still runs
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  Status write(const std::vector<std::uint8_t>& bytes, const KeepGoing&);
  Status finish(const KeepGoing&);  // no more frames: waits until the file is whole
  Error wrote_nothing() const;      // for a file that is empty although all went well; with the program's words

 private:
  Encoder(pid_t pid, int in, int err) : pid_(pid), in_(in), err_(err) {}
  bool listen();                 // keeps what the program says; false once it has closed its mouth
  Status end(const KeepGoing&);  // waits for the end; how it went
  Error complaint(int status) const;

  pid_t pid_ = -1;
  int in_ = -1, err_ = -1;  // our ends: of its standard input and of its standard error
  std::string said_;        // the last of what it said
};

}  // namespace betwixt
