// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a path asks for, and whether it can be had.
#pragma once

#include <string>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

enum class Ending { mp4, webm, gif, apng, pictures };

struct Output {
  Ending ending = Ending::mp4;
  std::string folder;                                 // "." where the path names none; no slash at its end
  std::string name;                                   // the last part of the path
  std::string before, after;                          // pictures: what stands around the number
  int digits = 0;                                     // pictures: at least so many
  std::string path() const;                           // of the film
  std::string path(int number) const;                 // of one picture
  std::string hidden(const std::string& tail) const;  // a hidden name beside it that no other process uses
};

// Errors: range (an ending nobody knows, not exactly one number in a picture's name).
Result<Output> read_output(const std::string& path);

// Whether a file can be put at `path`. Errors: file (no such folder, a folder itself, there already), machine (not
// writable).
Status check_place(const std::string& path, bool overwrite);

// Gives a finished file its final name. Errors: file (there already), machine.
Status put_in_place(const std::string& from, const std::string& to, bool overwrite);

// "the disk is full" and the like, for what the system answered about a path.
Error system_error(int number, const std::string& doing, const std::string& path);

}  // namespace betwixt
