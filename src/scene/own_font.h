// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A font that a film brings along as a file, in place of one that the machine has.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace betwixt {

struct OwnFont {
  std::string bytes;
  std::string digest;  // SHA-256 of the bytes: two files with the same bytes are one font
};

// Whether a font's name is that of a file: fonts/Own.ttf, Own.OTF, or @logo.ttf for one that a host has sent.
inline bool names_font_file(std::string_view name) {
  std::string end(name.substr(name.size() - std::min<std::size_t>(name.size(), 4)));
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.starts_with('@') || end == ".ttf" || end == ".otf";
}

}  // namespace betwixt
