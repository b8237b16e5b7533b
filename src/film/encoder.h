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

// Called several times a second during a wait; return false to give up.
using KeepGoing = std::function<bool()>;

// The error of a film that was stopped from outside.
Error stopped();

class Encoder {
 public:
  // Starts the program. Arguments are passed one by one, without a shell. Errors: machine (no such program).
  static Result<std::unique_ptr<Encoder>> start(const std::vector<std::string>& arguments);
  ~Encoder();  // kills the program if it still runs
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  Status write(const std::vector<std::uint8_t>& bytes, const KeepGoing&);
  Status finish(const KeepGoing&);  // after the last frame: waits until the file is complete
  Error wrote_nothing() const;  // for a file that is empty although ffmpeg reports success; with the program's message

 private:
  Encoder(pid_t pid, int in, int err) : pid_(pid), in_(in), err_(err) {}
  bool listen();                 // stores the program's messages; returns false once it has closed standard error
  Status end(const KeepGoing&);  // waits for the end; returns how it ended
  Error complaint(int status) const;

  pid_t pid_ = -1;
  int in_ = -1, err_ = -1;  // our ends: of its standard input and of its standard error
  std::string said_;        // the last of its messages
};

}  // namespace betwixt
