// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/video_files.h"

#include <fmt/format.h>

#include "base/kept_results.h"
#include "exchange/videos.h"
#include "scene/memory.h"

namespace betwixt {

bool video_of_file(Command& k, FunctionId f, const std::string& path, const std::filesystem::path& where,
                   std::string_view about) {
  if (f != fn::video_file && f != fn::texture)
    return k.cursor.fail(ErrorCode::type,
                         fmt::format("{} is a video; of the pictures of a surface only the texture can be one", path),
                         about);
  if (k.scene.videos->contains(path)) return true;
  const auto read = KeptResults::get("video", where.string(), [&] { return read_video(where.string()); });
  if (!read) return k.cursor.fail(read.error(), about);
  if (!read->warning.empty()) k.script.note(Severity::warning, read->warning, about, {});
  ContentBytes bytes;
  bytes.add(read->video);
  if (!has_room(k, bytes, about)) return false;
  k.scene.videos.edit()[path] = read->video;
  return true;
}

bool complete_video(Command& k, Object& object, std::string_view about) {
  if (!object.find(fn::video_file))
    return k.cursor.fail(ErrorCode::syntax, "a video needs its file", about, "as in file=\"talk.mp4\"");
  if (!object.find(fn::material)) object.slot(fn::material).set = Text(std::string("glow"));
  if (!object.find(fn::color)) object.slot(fn::color).set = Color{1, 1, 1};
  return true;
}

}  // namespace betwixt
