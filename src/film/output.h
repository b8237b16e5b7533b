// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The output that a path requests.
#pragma once

#include <string>
#include <vector>

#include "betwixt/result.h"
#include "film/formats.h"

namespace betwixt {

struct Output {
  const Format* format = nullptr;      // null for numbered pictures
  std::string folder;                  // "." if the path has none; no slash at its end
  std::string name;                    // the last part of the path
  bool exr = false;                    // pictures: OpenEXR or else PNG
  std::string before, after;           // pictures: the text around the number
  int digits = 0;                      // pictures: the fewest digits
  std::string path() const;            // of the film
  std::string path(int number) const;  // of one picture
  // Returns a hidden name beside it that no other process uses. It has the name of the machine, since other machines
  // know neither whether the process runs nor, on many shared disks, who holds a lock.
  std::string hidden(const std::string& tail) const;
};

// Errors: range (an unknown extension, not exactly one number in a picture's name).
Result<Output> read_output(const std::string& path);

}  // namespace betwixt
