// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/tell_user.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "base/utf8.h"

namespace betwixt {
namespace {

std::atomic<ColorMode> chosen{ColorMode::automatic};

bool set(const char* name) {
  const char* value = std::getenv(name);
  return value && *value;
}

bool colours_wanted() {
  if (chosen != ColorMode::automatic) return chosen == ColorMode::always;
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && !set("NO_COLOR") && terminal && std::string_view(terminal) != "dumb";
}

struct Kind {
  std::string_view word, begin;
};
constexpr Kind kinds[] = {{"error: ", "\x1b[1;31m"}, {"warning: ", "\x1b[1;35m"}, {"notice: ", "\x1b[1;36m"}};
constexpr std::string_view bold = "\x1b[1m", green = "\x1b[1;32m", end = "\x1b[0m";

// For "film.bx:3:1: error: …": the text before the word has no blanks except after colons.
bool in_front(std::string_view before) { return before.empty() || before.ends_with(": "); }

std::string painted_line(std::string_view line) {
  std::string out;
  if (const auto caret = line.find_first_not_of(" \t");
      caret != line.npos && caret > 0 && line[caret] == '^' && line.find_first_not_of('~', caret + 1) == line.npos)
    return out.append(line.substr(0, caret)).append(green).append(line.substr(caret)).append(end);
  std::size_t first = line.npos;
  const Kind* kind = nullptr;
  for (const Kind& k : kinds)
    if (const auto at = line.find(k.word); at < first && in_front(line.substr(0, at))) first = at, kind = &k;
  if (!kind) return std::string(line);
  const std::size_t word = kind->word.size() - 1;
  return out.append(bold)
      .append(line.substr(0, first))
      .append(end)
      .append(kind->begin)
      .append(line.substr(first, word))
      .append(end)
      .append(line.substr(first + word));
}

}  // namespace

std::string with_color_codes(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t stop = std::min(text.find('\n'), text.size());
    out += painted_line(text.substr(0, stop));
    if (stop < text.size()) out += '\n';
    text.remove_prefix(std::min(stop + 1, text.size()));
  }
  return out;
}

void choose_color_mode(ColorMode how) { chosen = how; }

void tell_user(std::string_view said) {
  const std::string text = visible_lines(said);
  if (!colours_wanted()) return (void)std::fwrite(text.data(), 1, text.size(), stderr);
  const std::string painted = with_color_codes(text);
  (void)std::fwrite(painted.data(), 1, painted.size(), stderr);
}

}  // namespace betwixt
