// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "edits.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/session.h"
#include "plain.h"
#include "scenes.h"
#include "timing.h"

using namespace betwixt;

namespace {

constexpr int ball_count = 1000, frames = 1000, changed_frame = 500;

class PlainFilm {
 public:
  PlainFilm() : tracks_(ball_count), worlds_(ball_count) {
    for (int k = 0; k < ball_count; ++k) {
      for (int f = 1; f <= frames; ++f) tracks_[static_cast<std::size_t>(k)].add(f, scenes::million_key(k, f));
      tracks_[static_cast<std::size_t>(k)].compile();
    }
  }
  void change(std::size_t object, Vec3 value) {
    tracks_[object].change(changed_frame - 1, value);
    for (std::size_t k = 0; k < worlds_.size(); ++k) worlds_[k] = translation(tracks_[k].seek(changed_frame));
  }
  const std::vector<Mat4>& worlds() const { return worlds_; }

 private:
  std::vector<plain::Track> tracks_;
  std::vector<Mat4> worlds_;
};

void remove_all_of(const std::filesystem::path& script) {
  for (const auto& entry : std::filesystem::directory_iterator(script.parent_path()))
    if (entry.path().filename().string().find(script.stem().string()) != std::string::npos)
      std::filesystem::remove(entry.path());
}

}  // namespace

void edits(int rounds) {
  const auto path = std::filesystem::temp_directory_path() / fmt::format("bench-{}.bx", std::random_device{}());
  std::ofstream(path, std::ios::binary) << scenes::million("position");
  {
    PlainFilm plain;
    Session session;
    session.open(path.string());
    Program program = Program::compile(session.document());
    Evaluation e(program);
    const Time t = session.document().rate().frame(changed_frame);
    e.to(t);
    for (int k = 0; k < rounds; ++k) {
      const std::size_t object = scenes::hash(static_cast<std::uint32_t>(k)) % ball_count;
      const Vec3 value{-1, 1.0 * k, 3};
      const std::string line = fmt::format("at {}f ball{}.position (-1 {} 3)", changed_frame, object, k);
      const double command = milliseconds([&] { insist(session.enter(line).done, "a command"); });
      const double compiling = milliseconds([&] { program = Program::compile(session.document(), program); });
      const double frame = milliseconds([&] {
        e.use(program);
        e.to(t);
      });
      const double theirs = milliseconds([&] { plain.change(object, value); });
      insist(e.changed().size() == 1 && translation_of(e.worlds()[object]) == value, "what was edited");
      for (std::size_t i = 0; i < ball_count; ++i)
        insist(length(translation_of(e.worlds()[i]) - translation_of(plain.worlds()[i])) < 1e-9, "a place");
      report("command", command), report("compile", compiling), report("frame", frame);
      report("betwixt", command + compiling + frame);
      report("plain", theirs);
    }
    session.enter("quit");
  }
  remove_all_of(path);
}
