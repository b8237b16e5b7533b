// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What reads meshes, scenes, drawings and pictures for pages: the other end of apart.cpp. A program of its own with a
// memory of its own; what it read goes to /handed, as betwixt-parser hands it over.
#include <emscripten.h>
#include <fcntl.h>

#include "base/files.h"
#include "betwixt/picture.h"
#include "exchange/handed_over.h"
#include "exchange/meshes.h"
#include "exchange/parser_messages.h"
#include "exchange/pictures.h"

namespace betwixt {
namespace {

template <class T>
Parsed either(Result<T> got) {
  return got ? Parsed(std::move(*got)) : Parsed(got.error());
}

Parsed parse(ParserTask task, const std::string& path, Shelf& shelf) {
  switch (task) {
    case ParserTask::mesh:
      return either(parse_mesh(path, shelf));
    case ParserTask::picture:
      return either(parse_picture(path, shelf));
    case ParserTask::drawing:
      return either(parse_drawing(path, shelf));
    default:
      return either(parse_scene(path, shelf));
  }
}

}  // namespace
}  // namespace betwixt

// The files that were asked for, a line each; the text lives until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* betwixt_parse(int task, const char* path) {
  using namespace betwixt;  // NOLINT: of this function
  static std::string asked;
  asked.clear();
  const MayRead may_read = [](const std::string& file) { return asked += file + '\n', true; };
  MachineShelf shelf(may_read);
  const OpenFile handed(::open("/handed", O_RDWR | O_CREAT | O_TRUNC, 0600));
  if (handed) hand_over(parse(static_cast<ParserTask>(task), path, shelf), handed.fd());
  return asked.c_str();
}
