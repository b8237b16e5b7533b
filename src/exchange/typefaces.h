// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The fonts that the machine has, through fontconfig. Safe from any thread.
#pragma once

#include <string>
#include <string_view>
#include <tuple>

#include "betwixt/result.h"
#include "betwixt/shape.h"

namespace betwixt {

// One font of a family.
struct Typeface {
  std::string family;
  Weight weight = Weight::regular;
  bool italic = false;
  friend bool operator==(const Typeface&, const Typeface&) = default;
  friend bool operator<(const Typeface& a, const Typeface& b) {
    return std::tie(a.family, a.weight, a.italic) < std::tie(b.family, b.weight, b.italic);
  }
};

// Fails if the machine has no font of this family; the error's hint suggests similar names.
Status find_font(const std::string& family);
// Fails if the family has no such style; the error's hint lists its styles. Succeeds for a missing family.
Status find_style(const Typeface&);

// The best match: its file, and the face's index in the file. For a missing family, DejaVu Sans or any other font.
// Empty if the machine has no fonts.
struct FontFile {
  std::string path;
  int index = 0;
};
FontFile font_file(const Typeface&);
// Returns the first letter of a text that this best match lacks, or "". Blanks and signs that are never drawn do not
// count.
std::string missing_letter(const Typeface&, std::string_view text);

}  // namespace betwixt
