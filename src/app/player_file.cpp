// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/player_file.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <filesystem>

#include "base/files.h"

namespace betwixt {
namespace {

constexpr const char* player = "betwixt-player.js";
constexpr std::string_view enders[] = {"/script", "script", "!--"};  // after '<'

bool begins_with_word(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = text[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c) != word[i]) return false;
  }
  return true;
}

// Removes a part of the player (web/put_together.py).
void leave_out(std::string& player_text, std::string_view part) {
  const std::string begin = fmt::format("// begin of the {}\n", part), end = fmt::format("// end of the {}\n", part);
  const std::size_t first = player_text.find(begin), last = player_text.find(end);
  if (first != player_text.npos && last != player_text.npos && first < last)
    player_text.erase(first, last + end.size() - first);
}

}  // namespace

Result<std::string> find_player() {
  std::error_code ignored;
  const auto missing = [](std::string words) {
    return fail(ErrorCode::machine, std::move(words),
                "./betwixt web builds it; the variable BETWIXT_PLAYER can name another one");
  };
  if (const char* said = ::secure_getenv("BETWIXT_PLAYER")) {
    if (std::filesystem::is_regular_file(said, ignored)) return std::string(said);
    return missing(std::string("BETWIXT_PLAYER is ") + said + ", but there is no such file");
  }
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const char* folder : {"../../web", "../share/betwixt/web"})
    if (const auto there = here / folder / player; std::filesystem::is_regular_file(there, ignored))
      return there.lexically_normal().string();
  return missing("the player for web pages is missing");
}

Result<std::string> read_player(PlayerParts parts) {
  const auto path = find_player();
  if (!path) return path;
  auto text = read_whole(*path);
  if (!text) return fail(ErrorCode::machine, text.error().message, text.error().hint);
  if (!parts.reader) leave_out(*text, "reader");
  if (!parts.formulas) leave_out(*text, "betwixt-formulas");
  if (!parts.code) leave_out(*text, "betwixt-code");
  // These sequences would end the script element too early.
  for (std::size_t at = text->find('<'); at != text->npos; at = text->find('<', at + 1))
    for (const std::string_view ender : {"/script", "!--"})
      if (begins_with_word(std::string_view(*text).substr(at + 1), ender))
        return fail(ErrorCode::machine, *path + " cannot be part of a page: it contains <" + std::string(ender));
  return text;
}

std::string as_script_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    out += text[at];
    if (text[at] != '<') continue;
    const std::size_t word = text.find_first_not_of('\\', at + 1);
    if (word == text.npos) continue;
    for (const std::string_view ender : enders)
      if (begins_with_word(text.substr(word), ender)) {
        out += '\\';
        break;
      }
  }
  return out;
}

}  // namespace betwixt
