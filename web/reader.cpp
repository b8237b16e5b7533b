// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What reads meshes, scenes, drawings and pictures for pages: the other end of apart.cpp. A program of its own with a
// memory of its own; what it read goes to /handed, as betwixt-parser hands it over.
#include <emscripten.h>
#include <fcntl.h>

#include "base/files.h"
#include "exchange/parser_process.h"

// The files that were asked for, a line each; the text lives until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* betwixt_parse(int task, const char* path) {
  using namespace betwixt;  // NOLINT: of this function
  static std::string asked;
  asked.clear();
  const MayRead may_read = [](const std::string& file) { return asked += file + '\n', true; };
  LocalFiles files(may_read);
  const OpenFile handed(::open("/handed", O_RDWR | O_CREAT | O_TRUNC, 0600));
  if (handed) write_parsed(parse_here(static_cast<ParserTask>(task), path, files), handed.fd());
  return asked.c_str();
}
