// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of others in pages: read by a program of its own here too (reader.cpp), which comes when a film has such files.
// Most have none.
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

// The files that it asked for, a line each, for free(); null: there is no reader. What it read is in /handed.
// clang-format off
EM_JS(char*, betwixt_read_apart, (int task, const char* path), {
  var asked = Module.readApart(task, UTF8ToString(path));
  if (asked === null) return 0;
  var size = lengthBytesUTF8(asked) + 1, at = _malloc(size);
  stringToUTF8(asked, at, size);
  return at;
})
// clang-format on

namespace betwixt {

std::optional<Parsed> parse_apart(ParserTask task, const std::string& path, const MayRead& may_read, bool,
                                  std::optional<ParserCeilings>) {
  if (read_contents(path).problem != ReadProblem::none) return read_whole(path).error();
  const std::unique_ptr<char, decltype(&std::free)> asked(betwixt_read_apart(static_cast<int>(task), path.c_str()),
                                                          std::free);
  if (!asked)
    return fail(ErrorCode::machine, "what reads files is not in this page yet", "await engine.prepare(files)");
  std::istringstream lines(asked.get());
  for (std::string file; std::getline(lines, file);) (void)may_read(file);
  const OpenFile handed(::open("/handed", O_RDONLY));
  Parsed out;
  if (!handed || read_parsed(handed.fd(), out) != 0)
    return fail(ErrorCode::file, fmt::format("{} cannot be read", path));
  return out;
}

// Never: it is read apart, or there is an error.
Parsed parse_here(ParserTask, const std::string& path, FileSource&, bool) {
  return fail(ErrorCode::file, fmt::format("{} cannot be read", path));
}

}  // namespace betwixt
