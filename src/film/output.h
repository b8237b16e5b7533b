// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a path asks for.
#pragma once

#include <string>
#include <vector>

#include "betwixt/result.h"
#include "film/formats.h"

namespace betwixt {

struct Output {
  const Format* format = nullptr;      // null: numbered pictures
  std::string folder;                  // "." where the path names none; no slash at its end
  std::string name;                    // the last part of the path
  bool exr = false;                    // pictures: OpenEXR; else PNG
  std::string before, after;           // pictures: what stands around the number
  int digits = 0;                      // pictures: at least so many
  std::string path() const;            // of the film
  std::string path(int number) const;  // of one picture
  // A hidden name beside it that no other process uses. It says the machine, of which others know neither who lives
  // nor, on many shared disks, who holds a lock.
  std::string hidden(const std::string& tail) const;
};

// Errors: range (an ending nobody knows, not exactly one number in a picture's name).
Result<Output> read_output(const std::string& path);

}  // namespace betwixt
