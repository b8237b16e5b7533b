// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <new>

#include "betwixt/picture.h"
#include "exchange/color_table.h"
#include "exchange/meshes.h"
#include "exchange/parser_process.h"
#include "exchange/pictures.h"
#include "exchange/unpacking.h"

namespace betwixt {
namespace {

template <class T>
Parsed parsed(Result<T> result) {
  return result ? Parsed(*std::move(result)) : Parsed(result.error());
}

}  // namespace

Parsed parse_here(ParserTask task, const std::string& path, FileSource& files, bool any_size, std::string_view line) {
  Unpacking unpacking(any_size);
  CountedFiles counted(files, unpacking);
  try {
    switch (task) {
      case ParserTask::mesh:
        return parsed(parse_mesh(path, counted));
      case ParserTask::picture:
        return parsed(parse_picture(path, counted));
      case ParserTask::linear_picture:
        return parsed(parse_linear_picture(path, counted));
      case ParserTask::drawing:
        return parsed(parse_drawing(path, counted));
      case ParserTask::table:
        return parsed(parse_table_text(path, counted, line));
      case ParserTask::colors:
        return parsed(parse_colors(path, counted, line));
      case ParserTask::letters: {
        auto bytes = counted.read(path);
        return bytes ? parsed(parse_letters(*std::move(bytes), path, line)) : Parsed(bytes.error());
      }
      default:
        return parsed(parse_scene(path, counted));
    }
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::file, fmt::format("{} takes too much memory to be read", path));
  } catch (const std::exception& e) {
    return fail(ErrorCode::file, fmt::format("{} is damaged: {}", path, e.what()));
  }
}

}  // namespace betwixt
