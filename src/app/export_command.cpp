// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt export: writes a film's motion for other programs.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "app/command.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/tell_user.h"
#include "betwixt/export.h"
#include "betwixt/object.h"

namespace betwixt {
namespace {

struct ExportCall {
  std::string file, out, frames, keys;
  std::vector<std::string> targets;
  std::optional<double> tolerance;
  bool keep_old = false;
};

// Returns the objects that words name, without duplicates.
Result<std::vector<ObjectId>> named(const std::vector<std::string>& words, const Document& d) {
  std::vector<ObjectId> all;
  for (const std::string& word : words) {
    const std::vector<ObjectId> found = objects(d, word);
    if (found.empty()) {
      const auto target = find_targets(word, d);
      if (!target) return target.error();
      return fail(ErrorCode::name, fmt::format("'{}' is not an object", word));
    }
    for (const ObjectId id : found)
      if (std::find(all.begin(), all.end(), id) == all.end()) all.push_back(id);
  }
  return all;
}

// Prints the progress on a terminal.
class Percent {
 public:
  bool operator()(double done) {
    const int now = static_cast<int>(100 * done);
    if (::isatty(STDERR_FILENO) == 1 && now != shown_) {
      fmt::print(stderr, "\r\x1b[K{} %", shown_ = now);
      std::fflush(stderr);
    }
    return !stop_requested();
  }
  ~Percent() {
    if (shown_ >= 0) fmt::print(stderr, "\r\x1b[K");
  }

 private:
  int shown_ = -1;
};

std::optional<KeyStyle> style_of(std::string_view word) {
  if (word == "cubic") return KeyStyle::cubic;
  if (word == "linear") return KeyStyle::linear;
  if (word == "baked") return KeyStyle::baked;
  return std::nullopt;
}

int export_motion(ExportCall& call) {
  const Result<Outgoing> outgoing = Outgoing::begin(call.out, "");
  if (!outgoing) return complain(outgoing.error(), wrong_call);
  const auto document = open_script(call.file);
  if (!document) return wrong_input;
  const auto frames = read_frames(call.frames, *document);
  if (!frames) return complain(frames.error(), wrong_call);
  const auto chosen = named(call.targets, *document);
  if (!chosen) return complain(chosen.error(), wrong_input);
  ExportOptions options;
  options.path = call.out, options.from = frames->first, options.until = frames->last;
  options.objects = *chosen, options.overwrite = !call.keep_old;
  options.keys = usual_keys(call.out, style_of(call.keys));
  if (call.tolerance) options.keys.metres = options.keys.radians = *call.tolerance;
  catch_stops();
  const Result<Exported> made = [&] {
    Percent percent;
    options.keys.go_on = std::ref(percent);
    return export_film(Program::compile(*document), options);
  }();
  if (stop_requested() && !made) {
    tell_user(fmt::format("betwixt: stopped; {} was not made\n", *outgoing ? "the file" : call.out));
    return interrupted;
  }
  if (!made) return complain(made.error(), wrong_call);
  if (const Status sent = outgoing->send(); !sent) return complain(sent.error(), machine_failed);
  for (const std::string& sentence : made->left_out) tell_user(fmt::format("betwixt: notice: {}\n", sentence));
  fmt::print(stderr, "{}, {}", counted(made->objects, "object"), counted(made->keys, "key"));
  if (made->baked > 0)
    fmt::print(stderr, " ({:.0f} % of one a frame)",
               100.0 * static_cast<double>(made->keys) / static_cast<double>(made->baked));
  tell_user(fmt::format(", {:.0f} kB, {}\n", std::ceil(static_cast<double>(made->bytes) / 1000),
                        *outgoing ? "standard output" : call.out));
  return all_done;
}

std::string endings() {
  std::string all;
  for (const ExportFormat& f : export_formats())
    all += fmt::format("{}{} ({})", all.empty() ? "" : ", ", f.ending, f.sentence);
  return all;
}

const Enlisted enlisted_export(export_motion, [](ExportCall& call) -> Subcommand {
  return {
      .rank = 17,
      .name = "export",
      .sentence = "writes a film's motion for other programs",
      .takes = {script_parameter(call.file),
                targets_parameter(call.targets, "the objects to write; by default all"),
                output_parameter(call.out, "FILE",
                                 "the file; its ending chooses the format: " + endings() + "; -.glb: standard output"),
                frames_parameter(call.frames),
                section_parameter(call.frames),
                {.name = "--keys",
                 .value = "WORD",
                 .sentence =
                     "linear: straight keys, which all programs play alike (the default for .glb, .gltf and .usda); "
                     "cubic: as few keys as possible, for programs that keep tangents (Blender and assimp do "
                     "not); baked: one key a frame",
                 .into = &call.keys,
                 .words_only = true,
                 .words = {"cubic", "linear", "baked"}},
                {.name = "--tolerance",
                 .value = "NUMBER",
                 .sentence = "the largest error, in metres and radians; by default 0.001 for straight keys, otherwise "
                             "0.0001",
                 .into = ReadValue([&call](const std::string& text) -> Status {
                   std::size_t read = 0;
                   try {
                     call.tolerance = std::stod(text, &read);
                   } catch (...) {
                     read = 0;
                   }
                   if (read != text.size() || !(call.tolerance >= 1e-9 && call.tolerance <= 1))
                     return fail(ErrorCode::range, fmt::format("it is a number from 1e-9 to 1, not \"{}\"", text));
                   return Nothing{};
                 })},
                flag("--no-overwrite", "keeps an existing file", call.keep_old)},
      .example = "betwixt export examples/bounce.bx -o bounce.glb",
      .manual =
          "Objects keep their names and parents. Motion becomes as many keys as the tolerance needs. Lottie and SVG "
          "files hold flat films, with outlines that change, lines that are drawn by trim, and cameras that move. "
          "The command leaves out what the format cannot hold, and prints a notice for each loss."};
});

}  // namespace
}  // namespace betwixt
