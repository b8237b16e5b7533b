// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The contents of files in shapes; functions of videos, and of videos as textures. Only src/scene/functions.cpp
// includes this; its rows come after those of src/scene/layer_functions.h.
#pragma once

#include <string>

#include "scene/document.h"

namespace betwixt {

inline void put_mesh(Shape& s, const Value& v, const Scene& scene) {
  const auto found = scene.meshes->find(*std::get<Text>(v));
  if (found != scene.meshes->end()) s.mesh = found->second;
}
inline void put_video(Shape& s, const Value& v, const Scene& scene) {
  const auto found = scene.videos->find(*std::get<Text>(v));
  const double aspect = found == scene.videos->end() ? 16.0 / 9 : found->second->aspect;
  s.size = {aspect, 1, 1};
}

inline constexpr double fastest_video = 1000;

// The rows that say which time of a file is shown: those of the kind, or those of textures.
struct TimeRow {
  std::string_view name, of_kind, of_textures, written;
  Type type = Type::scalar;
  Value rest = 0.0;
  Unit unit = Unit::none;
  double low = 0, high = longest_seconds;
};
inline const TimeRow time_rows[] = {
    {"at",
     "The time of the film at which a video begins; by default the film's first frame. Its first picture stands still "
     "before.",
     "The time of the film at which the video on its surface begins; by default the film's first frame.", "a time",
     Type::scalar, 0.0, Unit::moment, -longest_seconds},
    {"from", "The second of its file with which a video begins.",
     "The second of its file with which the video on its surface begins.", "a length of time", Type::scalar, 0.0,
     Unit::seconds},
    {"until", "The second of its file with which a video ends; by default it ends with the file.",
     "The second of its file with which the video on its surface ends; by default it ends with the file.",
     "a length of time", Type::scalar, longest_seconds, Unit::seconds},
    {"speed", "How fast a video plays, as a factor; below 0 it plays backwards, from its end.",
     "How fast the video on its surface plays, as a factor; below 0 it plays backwards, from its end.", "a number",
     Type::scalar, 1.0, Unit::none, -fastest_video, fastest_video},
    {"loop", "Whether a video begins anew after its end; otherwise its last picture stays.",
     "Whether the video on its surface begins anew after its end; otherwise its last picture stays.", "on or off",
     Type::boolean, false},
    {"time",
     "The second of its file that a video shows. If you give it a value or events, they say it alone; if not, it "
     "follows from `at`, `from`, `until`, `speed` and `loop`.",
     "The second of its file that the video on its surface shows. If you give it a value or events, they say it alone; "
     "if not, it follows from `texture-at`, `texture-from` and so on.",
     "a length of time", Type::scalar, 0.0, Unit::seconds},
};

// An example in which a function of the clip, or of a ball with a texture, has a value.
inline std::string_view video_example(std::string_view name, bool texture) {
  static const std::pair<std::string_view, std::pair<std::string_view, std::string_view>> all[] = {
      {"at", {"create clip video file=\"talk.mp4\"\nset clip.at 48f", "set ball.texture-at 48f"}},
      {"from", {"create clip video file=\"talk.mp4\"\nset clip.from 10s", "set ball.texture-from 10s"}},
      {"until", {"create clip video file=\"talk.mp4\"\nset clip.until 70s", "set ball.texture-until 70s"}},
      {"speed", {"create clip video file=\"talk.mp4\"\nset clip.speed 0.5", "set ball.texture-speed 0.5"}},
      {"loop", {"create clip video file=\"talk.mp4\"\nset clip.loop on", "set ball.texture-loop on"}},
      {"time", {"create clip video file=\"talk.mp4\"\nat 48f clip.time 2s", "at 48f ball.texture-time 2s"}},
  };
  for (const auto& [is, examples] : all)
    if (is == name) return texture ? examples.second : examples.first;
  return {};
}

inline void add_video_functions(std::vector<FunctionSpec>& made) {
  made.push_back({.name = "file",
                  .type = Type::text,
                  .rest = Text(),
                  .kinds = bit(Kind::video),
                  .shape = put_video,
                  .sentence = "The file of a video.",
                  .written = "\"FILE\""});
  KindBits drawn = 0;
  for (const KindRow& row : kinds())
    if (row.fill != Fill::nothing && row.kind != Kind::video) drawn |= bit(row.kind);
  for (const bool texture : {false, true})
    for (const TimeRow& row : time_rows)
      made.push_back({.name = (texture ? "texture-" : "") + std::string(row.name),
                      .type = row.type,
                      .rest = row.rest,
                      .kinds = texture ? drawn : bit(Kind::video),
                      .unit = row.unit,
                      .low = row.low,
                      .high = row.high,
                      .sentence = texture ? row.of_textures : row.of_kind,
                      .written = row.written,
                      .example = video_example(row.name, texture)});
}

}  // namespace betwixt
