// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The fonts that the machine has, through fontconfig. Safe from any thread.
#pragma once

#include <string>
#include <tuple>

#include "betwixt/result.h"
#include "betwixt/shape.h"

namespace betwixt {

// One of a family.
struct Typeface {
  std::string family;
  Weight weight = Weight::regular;
  bool italic = false;
  friend bool operator==(const Typeface&, const Typeface&) = default;
  friend bool operator<(const Typeface& a, const Typeface& b) {
    return std::tie(a.family, a.weight, a.italic) < std::tie(b.family, b.weight, b.italic);
  }
};

// Whether the machine has a font of this family name; a near miss goes into the error's hint.
Status find_font(const std::string& family);
// Whether the family has one like this; the error's hint says which there are. Nothing is said of families that are not
// there.
Status find_style(const Typeface&);

// The file, and the face's number in it, of what comes nearest: of a family that the machine lacks, of DejaVu Sans, or
// any other it has. Empty where there are no fonts at all.
struct FontFile {
  std::string path;
  int index = 0;
};
FontFile font_file(const Typeface&);

}  // namespace betwixt
