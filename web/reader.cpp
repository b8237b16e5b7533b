// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The reader of meshes, scenes, drawings and pictures in pages, which apart.cpp calls. It is a separate program with
// its own memory. It writes the result to /result, in the format of betwixt-parser.
#include <emscripten.h>
#include <fcntl.h>

#include "base/files.h"
#include "exchange/parser_process.h"

// Returns the files that the file refers to, a line each. The text is valid until the next call.
// What is inside a table may follow the path, on a line of its own.
extern "C" EMSCRIPTEN_KEEPALIVE const char* betwixt_parse(int task, const char* asked) {
  using namespace betwixt;  // NOLINT: of this function
  static std::string needed;
  needed.clear();
  std::string path = asked, inside;
  if (const auto end = path.find('\n'); end != path.npos) inside = path.substr(end + 1), path.resize(end);
  const MayRead may_read = [](const std::string& file) { return needed += file + '\n', true; };
  LocalFiles files(may_read);
  const OpenFile result(::open("/result", O_RDWR | O_CREAT | O_TRUNC, 0600));
  if (result) write_parsed(parse_here(static_cast<ParserTask>(task), path, files, false, inside), result.fd());
  return needed.c_str();
}
