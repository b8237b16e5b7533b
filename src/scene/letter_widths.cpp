// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/letter_widths.h"

#include <array>
#include <cstdint>

#include "base/utf8.h"

namespace betwixt {
namespace {

// Of DejaVu Sans in hundredths of an em, rounded up, from the blank to ~.
constexpr std::array<std::uint8_t, 95> ascii_widths{
    32, 41, 46, 84, 64, 96, 78, 28, 40,  40, 50, 84, 32, 37, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 54, 100, 69, 69, 70, 78, 64, 58, 78, 76, 30, 30, 66, 56, 87, 75, 79,
    61, 79, 70, 64, 62, 74, 69, 99, 69,  62, 69, 40, 34, 40, 84, 50, 50, 62, 64, 55, 64, 62, 36, 64,
    64, 28, 28, 58, 28, 98, 64, 62, 64,  64, 42, 53, 40, 64, 60, 82, 60, 60, 53, 64, 34, 64, 84};

}  // namespace

double letters_width(std::string_view text) {
  double all = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 32 && byte < 127)
      all += ascii_widths[byte - 32u] / 100.0;
    else if (begins_character(c))
      all += 1;
  }
  return all;
}

std::string shortened(const std::string& text, double most_em) {
  if (letters_width(text) <= most_em) return text;
  for (std::size_t letters = count_characters(text); letters-- > 2;) {
    std::string out(first_characters(text, letters));
    while (out.ends_with(' ')) out.pop_back();
    if (letters_width(out) + 1 <= most_em) return out + "…";
  }
  return "";
}

}  // namespace betwixt
