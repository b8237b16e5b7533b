// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/speaker_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/utf8.h"
#include "betwixt/language.h"
#include "betwixt/program.h"
#include "syntax/texts.h"

namespace betwixt {
namespace {

// Puts a picture into a box of another one, as large as fits.
void put_in(const Picture& small, Picture& page, int left, int top, int width, int height) {
  if (small.width <= 0 || small.height <= 0) return;
  const double scale = std::min(static_cast<double>(width) / small.width, static_cast<double>(height) / small.height);
  const int w = std::max(1, static_cast<int>(small.width * scale)),
            h = std::max(1, static_cast<int>(small.height * scale));
  for (int y = 0; y < h && top + y < page.height; ++y)
    for (int x = 0; x < w && left + x < page.width; ++x) {
      const int from_x = std::min(small.width - 1, static_cast<int>((x + 0.5) / scale));
      const int from_y = std::min(small.height - 1, static_cast<int>((y + 0.5) / scale));
      const auto from = 4 * (static_cast<std::size_t>(from_y) * static_cast<std::size_t>(small.width) +
                             static_cast<std::size_t>(from_x));
      const auto to = 4 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(page.width) +
                           static_cast<std::size_t>(left + x));
      std::copy_n(&small.rgba[from], 4, &page.rgba[to]);
    }
}

constexpr int most_note = 900;  // letters of a note that fit

}  // namespace

std::string in_lines(std::string_view text, std::size_t letters) {
  std::string out;
  std::size_t line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    const std::size_t long_is = count_characters(word);
    if (line > 0 && line + 1 + long_is > letters) out += '\n', line = 0;
    if (line > 0) out += ' ', ++line;
    out += word, line += long_is;
    if (end < text.size() && text[end] == '\n') out += '\n', line = 0;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

Status SpeakerPage::draw_words(const SpeakerView& v, int width, int height) {
  const double wide = 9.0 * width / height, left = -wide / 2 + 0.3;  // a flat film is 9 m high
  std::string note(v.note);
  if (count_characters(note) > most_note) note = std::string(first_characters(note, most_note)) + "…";
  const auto letters = static_cast<std::size_t>(std::max(10.0, (wide - 0.6) / 0.19));
  const std::string script = fmt::format(
      "film flat\nsize {}x{}\nbackground #14181d\n"
      "create clock text text={} size=0.6 align=left color=#ffffff position=({} 3.75 0)\n"
      "create count text text={} size=0.35 align=left color=#9aa7b4 position=({} 3.75 0)\n"
      "create title text text={} size=0.4 align=left color=#ffd166 position=({} -1.35 0)\n"
      "create notes text text={} size=0.32 align=left color=#e6edf3 position=({} -2 0)\n",
      width, height, write_text(v.clock), left, write_text(v.count), left + 2.6,
      write_text(std::string(first_characters(v.title, 60))), left, write_text(in_lines(note, letters)), left);
  if (script == drawn_) return Nothing{};
  const Loaded page = load_text(script, "notes.bx");
  if (has_errors(page.diagnostics)) return page.diagnostics.front().what;
  auto renderer = make_renderer({.width = width, .height = height});
  if (!renderer) return renderer.error();
  if (Status s = (*renderer)->render(Program::compile(page.document).frame({}), words_); !s) return s;
  drawn_ = script;
  return Nothing{};
}

Status SpeakerPage::draw(const SpeakerView& v, int width, int height, Picture& out) {
  if (Status s = draw_words(v, width, height); !s) return s;
  out = words_;
  const int margin = width / 50, top = height / 7, high = height * 46 / 100;
  if (v.now) put_in(*v.now, out, margin, top, width * 55 / 100, high);
  if (v.next) put_in(*v.next, out, width * 58 / 100 + margin, top, width * 38 / 100, high);
  return Nothing{};
}

}  // namespace betwixt
