// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads foreign files in pages. As elsewhere, a separate program does it (reader.cpp). The page loads it only if a film
// has such files, because most have none.
#include <emscripten.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <sstream>

#include "base/files.h"
#include "exchange/parser_process.h"

// Reads a file in the reader, and leaves the result in /result. Returns the files that the reader asked for, a line
// each, or null without a reader. The caller frees the text.
// clang-format off
EM_JS(char*, betwixt_read_in_reader, (int task, const char* path), {
  var needed = Module.readInReader(task, UTF8ToString(path));
  if (needed === null) return 0;
  var size = lengthBytesUTF8(needed) + 1, at = _malloc(size);
  stringToUTF8(needed, at, size);
  return at;
})
// clang-format on

namespace betwixt {

std::optional<Parsed> parse_apart(ParserTask task, const std::string& path, const MayRead& may_read, bool,
                                  std::optional<ParserCeilings>, std::string_view inside) {
  if (read_contents(path).problem != ReadProblem::none) return read_whole(path).error();
  const std::string asked = path + (inside.empty() ? "" : "\n" + std::string(inside));
  const std::unique_ptr<char, decltype(&std::free)> needed(
      betwixt_read_in_reader(static_cast<int>(task), asked.c_str()), std::free);
  if (!needed)
    return fail(ErrorCode::machine, "what reads files is not in this page yet", "await engine.prepare(files)");
  std::istringstream lines(needed.get());
  for (std::string file; std::getline(lines, file);) (void)may_read(file);
  const OpenFile result(::open("/result", O_RDONLY));
  Parsed out;
  if (!result || read_parsed(result.fd(), out) != 0)
    return fail(ErrorCode::file, fmt::format("{} cannot be read", path));
  return out;
}

// The page protects what is outside it.
std::unique_ptr<FontFace> open_own_font(std::shared_ptr<const OwnFont> font) { return open_font_bytes(font->bytes); }

// Is never called: files are read by the reader, or not at all.
Parsed parse_here(ParserTask, const std::string& path, FileSource&, bool, std::string_view) {
  return fail(ErrorCode::file, fmt::format("{} cannot be read", path));
}

}  // namespace betwixt
