// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/formats.h"

#include <fmt/format.h>

#include "base/files.h"
#include "base/names.h"

namespace betwixt {
namespace {

constexpr int most_frames = 1'000'000;

constexpr ExportRow rows[] = {
    {".glb", "glTF 2.0: for three.js, Blender, Godot, web pages", make_glb, KeyStyle::linear},
    {".gltf", "the same as text", make_gltf, KeyStyle::linear},
    {".usda", "USD as text: for Houdini, Maya, Omniverse, usdview", make_usda, KeyStyle::linear},
    {".json", "Lottie: a flat film for apps and web pages", make_lottie},
    {".css", "CSS keyframes for web pages: the motion of flat objects", make_css},
    {".js", "the same for element.animate()", make_waapi},
    {".svg", "animated SVG: a flat film as a moving picture", make_svg},
};

}  // namespace

std::span<const ExportRow> export_rows() { return rows; }

std::vector<ExportFormat> export_formats() {
  std::vector<ExportFormat> all;
  for (const ExportRow& row : rows) all.push_back({row.ending, row.sentence});
  return all;
}

KeyOptions usual_keys(std::string_view path, std::optional<KeyStyle> asked) {
  const std::string end = "." + ending(std::string(path));
  KeyOptions keys;
  for (const ExportRow& row : rows)
    if (row.ending == end) keys.style = row.usual;
  keys.style = asked.value_or(keys.style);
  if (keys.style == KeyStyle::linear) keys.metres = keys.radians = 1e-3;
  return keys;
}

Result<Exported> export_film(const Program& program, const ExportOptions& options) {
  const std::string end = "." + ending(options.path);
  std::vector<std::string_view> known;
  std::string list;
  for (const ExportRow& row : rows) {
    known.push_back(row.ending);
    list += (list.empty() ? "" : " ") + std::string(row.ending);
    if (row.ending != end) continue;
    const Rate rate = program.document().rate();
    if (const double frames = rate.frame_number(options.until) - rate.frame_number(options.from); frames > most_frames)
      return fail(ErrorCode::range, fmt::format("{:.0f} frames are too many; the limit is {}", frames, most_frames),
                  "choose fewer frames: --frames 1f..240f");
    if (Status s = check_place(options.path, options.overwrite); !s) return s.error();
    Exported made;
    const Result<std::string> bytes = row.make(program, options, made);
    if (!bytes) return bytes.error();
    made.bytes = bytes->size();
    if (Status s = write_whole(options.path, *bytes, options.overwrite); !s) return s.error();
    return made;
  }
  const std::string near = did_you_mean(end, known).text;
  return fail(
      ErrorCode::range,
      end == "." ? fmt::format("\"{}\" has no file extension that says what to make", options.path)
                 : fmt::format("\"{}\" is not an export format", end),
      fmt::format(
          "{}known extensions: {}{}", near.empty() ? "" : near + "; ", list,
          end == ".mp4" || end == ".gif" || end == ".webm" || end == ".mov" ? "; to make a film: betwixt render" : ""));
}

}  // namespace betwixt
