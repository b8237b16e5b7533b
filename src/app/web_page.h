// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Films as one page that plays them: texts, the files that they use, and what plays.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/result.h"

namespace betwixt {

// By the names that films know them by.
using PageFiles = std::map<std::string, std::string, std::less<>>;

struct PageFilm {
  std::string name;   // of the script: bounce.bx
  std::string text;   // of it
  std::string about;  // what its first comment says
  std::pair<int, int> size{1280, 720};
  PageFiles files;
  std::vector<std::string> lost;  // what the program shows of it and no page does, a sentence each
};

// Loads a script and gathers what a page needs for it; says its errors and warnings. Errors: file (it uses files that
// lie elsewhere), type (it has what no page can show); none where the script's errors have been said.
std::optional<Result<PageFilm>> film_for_page(const std::string& script);

struct PageOptions {
  std::string title;
  std::optional<std::pair<int, int>> size;  // of the pictures; none: as wide as there is room
  bool edit = true;                         // the texts stand beside the pictures
  std::string player;  // the text of betwixt-player.js; empty: it lies beside the page, and so does page_look()
};
std::string web_page(const std::vector<PageFilm>&, const PageOptions&);
std::string_view page_look();  // betwixt-page.css

}  // namespace betwixt
