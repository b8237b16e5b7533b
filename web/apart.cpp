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
#include <sstream>

#include "base/files.h"
#include "betwixt/picture.h"
#include "exchange/handed_over.h"
#include "exchange/meshes.h"
#include "exchange/parser_messages.h"

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
namespace {

Parsed read_apart(ParserTask task, const std::string& path, const MayRead& may_read) {
  const std::unique_ptr<char, decltype(&std::free)> asked(betwixt_read_apart(static_cast<int>(task), path.c_str()),
                                                          std::free);
  if (!asked)
    return fail(ErrorCode::machine, "what reads files is not in this page yet", "await engine.prepare(files)");
  std::istringstream lines(asked.get());
  for (std::string file; std::getline(lines, file);) (void)may_read(file);
  const OpenFile handed(::open("/handed", O_RDONLY));
  Parsed out;
  if (!handed || take_over(handed.fd(), out) != 0) return fail(ErrorCode::file, fmt::format("{} cannot be read", path));
  return out;
}

template <class T>
Result<std::shared_ptr<const T>> parsed(ParserTask task, const std::string& path, const MayRead& may_read) {
  using Wanted = std::shared_ptr<const T>;
  if (!may_read(path)) return fail(ErrorCode::file, fmt::format("{} may not be read", path));
  if (const auto bytes = read_contents(path); bytes.hindrance != Hindrance::none) return read_whole(path).error();
  Parsed got = read_apart(task, path, may_read);
  if (auto* wanted = std::get_if<Wanted>(&got)) return std::move(*wanted);
  if (auto* error = std::get_if<Error>(&got)) return std::move(*error);
  return fail(ErrorCode::file, fmt::format("{} is something else than it was read as", path));
}

}  // namespace

Result<std::shared_ptr<const Mesh>> load_mesh(const std::string& path, const MayRead& may_read) {
  return parsed<Mesh>(ParserTask::mesh, path, may_read);
}
Result<std::shared_ptr<const SceneFile>> load_scene(const std::string& path, const MayRead& may_read) {
  return parsed<SceneFile>(ParserTask::scene, path, may_read);
}
Result<std::shared_ptr<const DrawingFile>> load_drawing(const std::string& path, const MayRead& may_read) {
  return parsed<DrawingFile>(ParserTask::drawing, path, may_read);
}
Result<std::shared_ptr<const Picture>> read_picture(const std::string& path) {
  return parsed<Picture>(ParserTask::picture, path, [&](const std::string& p) { return p == path; });
}

}  // namespace betwixt
