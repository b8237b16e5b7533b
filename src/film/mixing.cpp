// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sounds of a film, put together.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "betwixt/film.h"
#include "exchange/sounds.h"
#include "program/hearing.h"
#include "scene/document.h"

namespace betwixt {
namespace {

constexpr std::size_t block = 64;  // samples over which gain is straight: 1.3 ms

std::vector<ObjectId> sounds_of(const Scene& scene) {
  std::vector<ObjectId> all;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    if (const Object* o = find_object(scene, ObjectId{i}); o && o->kind == Kind::sound) all.push_back(ObjectId{i});
  return all;
}

Status add(const Program& program, ObjectId id, const std::string& path, double length, Time from,
           std::span<float> stereo) {
  const auto number = [&](FunctionId f) { return std::get<double>(program.read(Target(id, f), Time{})); };
  const HeardPart part = heard_part(length, number);
  // The sample of the sound that is heard with the film's first one.
  const auto offset = std::llround(part.own_time(from.seconds()) * sound_rate);
  const auto pairs = static_cast<std::int64_t>(stereo.size() / 2);
  const auto gain = [&](std::int64_t at) {
    const Time then = from + Time{at * (flicks_per_second / sound_rate)};
    return std::get<double>(program.read(Target(id, fn::gain), then));
  };
  std::int64_t next = -offset;  // where in the film what comes next from the file is heard
  std::int64_t first = 0, last = -1;
  double begins = 0, ends = 0;
  return decode_sound(path, [&](std::span<const float> samples) {
    for (std::size_t i = 0; i + 1 < samples.size(); i += 2, ++next) {
      if (next >= pairs) return false;
      if (next < 0) continue;
      if (next > last) {
        first = next, last = next + static_cast<std::int64_t>(block);
        begins = gain(first), ends = gain(last);
      }
      const double share = part.share(static_cast<double>(next + offset) / sound_rate) *
                           std::lerp(begins, ends, static_cast<double>(next - first) / block);
      const auto at = 2 * static_cast<std::size_t>(next);
      stereo[at] += static_cast<float>(share * samples[i]);
      stereo[at + 1] += static_cast<float>(share * samples[i + 1]);
    }
    return true;
  });
}

}  // namespace

bool has_sounds(const Document& document) { return !sounds_of(document.scene()).empty(); }

Status mix_sounds(const Program& program, Time from, std::span<float> stereo) {
  const Scene& scene = program.document().scene();
  for (const ObjectId id : sounds_of(scene)) {
    const std::string& name = *std::get<Text>(program.read(Target(id, fn::sound_file), Time{}));
    const auto known = scene.sounds->find(name);
    if (known == scene.sounds->end()) continue;
    if (Status s = add(program, id, known->second->path, known->second->seconds, from, stereo); !s) return s;
  }
  return Nothing{};
}

}  // namespace betwixt
