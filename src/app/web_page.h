// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes one web page that plays films: their texts, their files, and the player.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/player_file.h"
#include "betwixt/language.h"
#include "betwixt/result.h"

namespace betwixt {

// File contents by the names that films use.
using PageFiles = std::map<std::string, std::string, std::less<>>;

struct PageFilm {
  std::string name;   // of the script: bounce.bx
  std::string text;   // of the script
  std::string about;  // the script's first comment
  std::pair<int, int> size{1280, 720};
  PageFiles files;
  std::vector<GivenLet> lets;
  std::optional<std::string> language;  // the name of the catalogue among the files
  std::vector<Pause> stops;             // where a speaker waits; seconds count from the film's beginning
  Time begin;
  std::vector<std::string> lost;  // features of the film that a page does not show, a sentence each
};

// Loads a script and collects its files for a page. Prints its errors and warnings; returns nullopt if the script has
// errors. Errors: file (it uses files outside its folder), type (it uses files that no page can read).
std::optional<Result<PageFilm>> film_for_page(const std::string& script);

struct PageOptions {
  std::string title;
  std::optional<std::pair<int, int>> size;  // of the pictures; nullopt fills the width of the page
  bool edit = true;                         // shows the texts beside the pictures
  std::string player;  // the text of betwixt-player.js; if empty, the page loads it and page_look() from its own folder
};
// Returns the parts of the player that the film needs.
PlayerParts needed_parts(const PageFilm&);
std::string web_page(const std::vector<PageFilm>&, const PageOptions&);
// A page that shows one film as a talk.
std::string talk_page(const PageFilm&, const PageOptions&);
std::string_view page_look();  // betwixt-page.css

}  // namespace betwixt
