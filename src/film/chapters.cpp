// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a film's file says of its parts and of what is to be seen: chapters, and a track of descriptions.
#include "film/chapters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

// hours:minutes:seconds.milliseconds
std::string vtt_time(double seconds) {
  const auto ms = static_cast<std::int64_t>(std::llround(1000 * seconds));
  return fmt::format("{:02}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60, ms % 1000);
}

// The text of a cue: no blank line and no arrow may be in it, and `<` begins a tag.
std::string vtt_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '\r' || (c == '\n' && (out.empty() || out.back() == '\n')))
      continue;
    else
      out += c;
  }
  return out;
}

std::string metadata_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("=;#\\\n").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::vector<Chapter> chapters_of(const Document& d, Time from, Time until) {
  std::vector<Chapter> all;
  for (const Section& s : d.sections()) {
    const Time begin = std::max(s.begin, from), end = std::min(s.end, until);
    if (end > begin) all.push_back({s.name, (begin - from).seconds(), (end - from).seconds()});
  }
  std::stable_sort(all.begin(), all.end(), [](const Chapter& a, const Chapter& b) { return a.begin < b.begin; });
  // Chapters of a file cannot overlap.
  for (std::size_t i = 1; i < all.size(); ++i) all[i - 1].end = std::min(all[i - 1].end, all[i].begin);
  return all;
}

std::string descriptions_vtt(const Document& d, Time from, Time until) {
  constexpr double longest = 10;
  std::string out = "WEBVTT\n";
  std::vector<Description> all;
  for (Description& one : d.descriptions())
    if (one.time >= from && one.time < until) all.push_back(std::move(one));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double begin = (all[i].time - from).seconds();
    const double next = ((i + 1 < all.size() ? all[i + 1].time : until) - from).seconds();
    out += fmt::format("\n{} --> {}\n{}\n", vtt_time(begin), vtt_time(std::min(next, begin + longest)),
                       vtt_text(all[i].text));
  }
  return out;
}

std::string chapters_metadata(const std::vector<Chapter>& chapters) {
  std::string out = ";FFMETADATA1\n";
  for (const Chapter& c : chapters)
    out += fmt::format("[CHAPTER]\nTIMEBASE=1/1000000\nSTART={}\nEND={}\ntitle={}\n", std::llround(1e6 * c.begin),
                       std::llround(1e6 * c.end), metadata_text(c.title));
  return out;
}

}  // namespace betwixt
