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
  const Format* format = nullptr;                     // null: numbered pictures
  std::string folder;                                 // "." where the path names none; no slash at its end
  std::string name;                                   // the last part of the path
  bool exr = false;                                   // pictures: OpenEXR; else PNG
  std::string before, after;                          // pictures: what stands around the number
  int digits = 0;                                     // pictures: at least so many
  std::string path() const;                           // of the film
  std::string path(int number) const;                 // of one picture
  std::string hidden(const std::string& tail) const;  // a hidden name beside it that no other process uses
};

// Errors: range (an ending nobody knows, not exactly one number in a picture's name).
Result<Output> read_output(const std::string& path);

}  // namespace betwixt
