// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads untrusted files, in a separate process if possible.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "betwixt/picture.h"
#include "exchange/color_table.h"
#include "exchange/drawing.h"
#include "exchange/meshes.h"
#include "exchange/parser_process.h"
#include "exchange/pictures.h"
#include "exchange/scene_file.h"
#include "exchange/table_file.h"

namespace betwixt {
namespace {

template <class T>
Result<std::shared_ptr<const T>> parsed(ParserTask task, const std::string& path, const MayRead& may_read,
                                        bool any_size, std::string_view inside = {}) {
  using Wanted = std::shared_ptr<const T>;
  auto read = parse_apart(task, path, may_read, any_size, {}, inside);
  if (!read) {
    LocalFiles files(may_read);
    read = parse_here(task, path, files, any_size, inside);
  }
  if (auto* wanted = std::get_if<Wanted>(&*read)) return std::move(*wanted);
  if (auto* error = std::get_if<Error>(&*read)) return std::move(*error);
  return fail(ErrorCode::file, fmt::format("the content of {} does not match its format", path));
}

}  // namespace

Result<std::shared_ptr<const Mesh>> load_mesh(const std::string& path, const MayRead& may_read, bool any_size) {
  if (!may_read(path)) return fail(ErrorCode::file, fmt::format("reading {} is not allowed", path));
  return parsed<Mesh>(ParserTask::mesh, path, may_read, any_size);
}

Result<std::shared_ptr<const SceneFile>> load_scene(const std::string& path, const MayRead& may_read, bool any_size) {
  if (!may_read(path)) return fail(ErrorCode::file, fmt::format("reading {} is not allowed", path));
  return parsed<SceneFile>(ParserTask::scene, path, may_read, any_size);
}

Result<std::shared_ptr<const DrawingFile>> load_drawing(const std::string& path, const MayRead& may_read,
                                                        bool any_size) {
  if (!may_read(path)) return fail(ErrorCode::file, fmt::format("reading {} is not allowed", path));
  return parsed<DrawingFile>(ParserTask::drawing, path, may_read, any_size);
}

Result<std::shared_ptr<const TableText>> parsed_table(const std::string& path, const std::string& inside) {
  const MayRead nothing_else = [&](const std::string& p) { return p == path; };
  return parsed<TableText>(ParserTask::table, path, nothing_else, true, inside);
}

Result<std::shared_ptr<const ColorTable>> load_colors(const std::string& path, const ColorQuery& query,
                                                      const MayRead& may_read) {
  if (!may_read(path)) return fail(ErrorCode::file, fmt::format("reading {} is not allowed", path));
  namespace fs = std::filesystem;
  std::error_code ignored;
  // Whole: the reader has another working folder, and finds the files that a configuration names from its path.
  const fs::path whole = fs::absolute(path, ignored).lexically_normal();
  const fs::path folder = fs::weakly_canonical(whole.parent_path(), ignored);
  const MayRead in_its_folder = [&](const std::string& p) {
    std::error_code why;
    const fs::path real = fs::weakly_canonical(p, why);
    const bool below =
        !why && std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
    return (below || p == whole.string()) && may_read(p);
  };
  return parsed<ColorTable>(ParserTask::colors, whole.string(), in_its_folder, false, text_of_query(query));
}

Result<std::shared_ptr<const Picture>> load_picture(const std::string& path, bool any_size) {
  const MayRead nothing_else = [&](const std::string& p) { return p == path; };
  return parsed<Picture>(ParserTask::picture, path, nothing_else, any_size);
}
Result<std::shared_ptr<const Picture>> read_picture(const std::string& path) { return load_picture(path, true); }

Result<LinearPicture> read_linear_picture(const std::string& path) {
  const MayRead nothing_else = [&](const std::string& p) { return p == path; };
  const auto read = parsed<LinearPicture>(ParserTask::linear_picture, path, nothing_else, true);
  if (!read) return read.error();
  return **read;
}

}  // namespace betwixt
