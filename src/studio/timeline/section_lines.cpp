// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/section_lines.h"

#include <fmt/format.h>

#include <vector>

#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

using Pieces = std::vector<std::string_view>;

Pieces pieces_of(std::string_view line) {
  Pieces all;
  for (std::string_view piece = take_piece(line); !piece.empty(); piece = take_piece(line)) all.push_back(piece);
  return all;
}

// Returns the words of an option and its value, or an empty text behind the name. The first two pieces are `section`
// and the name.
std::string_view option_of(const Pieces& pieces, std::initializer_list<std::string_view> keys) {
  for (std::size_t i = 2; i + 1 < pieces.size(); ++i)
    for (const std::string_view key : keys)
      if (pieces[i] == key) return {pieces[i].data(), pieces[i + 1].data() + pieces[i + 1].size()};
  return {pieces[1].data() + pieces[1].size(), pieces[1].data() + pieces[1].size()};
}

// The same for speed=NUMBER, which may have blanks in it.
std::string_view speed_of_pieces(const Pieces& pieces) {
  for (std::size_t i = 2; i < pieces.size(); ++i) {
    if (!pieces[i].starts_with("speed")) continue;
    std::size_t last = i;
    while (last + 1 < pieces.size() && (pieces[last] == "speed" || pieces[last].ends_with('='))) ++last;
    return {pieces[i].data(), pieces[last].data() + pieces[last].size()};
  }
  return {pieces.back().data() + pieces.back().size(), pieces.back().data() + pieces.back().size()};
}

std::string put(std::string_view line, std::string_view place, const std::string& words) {
  const auto at = static_cast<std::size_t>(place.data() - line.data());
  return fmt::format("{}{}{}{}", line.substr(0, at), place.empty() ? " " : "", words, line.substr(at + place.size()));
}

}  // namespace

std::optional<SectionLine> section_line(std::string_view script, std::string_view name) {
  LineState state;
  for (int number = 1; !script.empty(); ++number) {
    const std::string_view line = script.substr(0, script.find('\n'));
    script.remove_prefix(std::min(script.size(), line.size() + 1));
    if (!state.goes_on() && line.starts_with("section"))
      if (const Pieces pieces = pieces_of(line); pieces.size() > 1 && pieces[0] == "section" && pieces[1] == name)
        return SectionLine{number, std::string(line)};
    pass_line(line, state);
  }
  return std::nullopt;
}

std::string section_at(std::string_view line, std::string_view time) {
  return put(line, option_of(pieces_of(line), {"after", "at"}), fmt::format("at {}", time));
}

bool section_has_length(std::string_view line) { return !option_of(pieces_of(line), {"for"}).empty(); }

std::string section_for(std::string_view line, std::string_view length) {
  return put(line, option_of(pieces_of(line), {"for"}), fmt::format("for {}", length));
}

std::string section_speed(std::string_view line, double speed) {
  return put(line, speed_of_pieces(pieces_of(line)), fmt::format("speed={:.6g}", speed));
}

}  // namespace betwixt::studio
