// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words that people bring along from elsewhere and that are none here: each is a road to what there is.
#pragma once

#include <span>
#include <string_view>

namespace betwixt {

struct Road {
  std::string_view word;
  std::string_view leads;  // to what, in words, as a hint says it
  std::string_view see;    // the words of the language that say more, with blanks between
};

std::span<const Road> roads();
// Where the word leads; empty where it is no road.
std::string_view road(std::string_view word);

}  // namespace betwixt
