// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Mixes the sounds of a film.
#include "film/mixing.h"

#include <algorithm>
#include <cmath>

#include "betwixt/film.h"
#include "exchange/sounds.h"
#include "scene/document.h"

namespace betwixt {
namespace {

constexpr std::int64_t block = 64;  // samples over which gain is linear: 1.3 ms
constexpr std::int64_t flicks_of_sample = flicks_per_second / sound_rate;

std::vector<ObjectId> sounds_of(const Scene& scene) {
  std::vector<ObjectId> all;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    if (const Object* o = find_object(scene, ObjectId{i}); o && o->kind == Kind::sound && !o->hidden)
      all.push_back(ObjectId{i});
  return all;
}

Status decode(const Program& program, const HeardSound& h, Time from, std::span<float> stereo) {
  std::int64_t next = 0;  // the next sample of the file
  return decode_sound(
      h.sound->path,
      [&](std::span<const float> samples) {
        const std::int64_t begins = next, left_out = std::max<std::int64_t>(h.first - begins, 0);
        next += static_cast<std::int64_t>(samples.size() / 2);
        const std::int64_t count = std::min(next, h.last) - begins - left_out;
        if (count > 0)
          add_sound(program, h, begins + left_out,
                    samples.subspan(2 * static_cast<std::size_t>(left_out), 2 * static_cast<std::size_t>(count)), from,
                    stereo);
        return next < h.last;
      },
      h.sound->seconds);
}

}  // namespace

std::vector<HeardSound> sounds_heard(const Program& program, Time from, std::int64_t pairs) {
  // Whole samples first, so that positions that are whole samples apart agree.
  const std::int64_t whole = from.flicks / flicks_of_sample;
  const double rest = Time{from.flicks % flicks_of_sample}.seconds();
  std::vector<HeardSound> all;
  const Scene& scene = program.document().scene();
  for (const ObjectId id : sounds_of(scene)) {
    const std::string& name = *std::get<Text>(program.read(Target(id, fn::sound_file), Time{}));
    const auto known = scene.sounds->find(name);
    if (known == scene.sounds->end()) continue;
    const auto number = [&](FunctionId f) { return std::get<double>(program.read(Target(id, f), Time{})); };
    HeardSound h{id, known->second, audible_part(known->second->seconds, number)};
    h.offset = whole + std::llround(h.part.own_time(rest) * sound_rate);
    const double most = h.part.length * sound_rate + 1;
    h.first = std::max(h.offset, static_cast<std::int64_t>(std::clamp(h.part.from * sound_rate, 0.0, most)));
    h.last =
        std::min(h.offset + pairs, static_cast<std::int64_t>(std::clamp(h.part.end() * sound_rate + 1, 0.0, most)));
    if (h.first < h.last) all.push_back(std::move(h));
  }
  return all;
}

void add_sound(const Program& program, const HeardSound& h, std::int64_t own, std::span<const float> samples, Time from,
               std::span<float> stereo) {
  const auto gain = [&](std::int64_t of) {
    return std::get<double>(program.read(Target(h.id, fn::gain), from + Time{(of - h.offset) * flicks_of_sample}));
  };
  // Blocks are aligned with the sound, so that the result does not depend on where mixing starts.
  std::int64_t first = 0, last = 0;
  double begins = 0, ends = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2, ++own) {
    if (own >= last) {
      first = own / block * block, last = first + block;
      begins = gain(first), ends = gain(last);
    }
    const double share = h.part.share(static_cast<double>(own) / sound_rate) *
                         std::lerp(begins, ends, static_cast<double>(own - first) / block);
    const auto at = 2 * static_cast<std::size_t>(own - h.offset);
    stereo[at] += static_cast<float>(share * samples[i]);
    stereo[at + 1] += static_cast<float>(share * samples[i + 1]);
  }
}

bool has_sounds(const Document& document) { return !sounds_of(document.scene()).empty(); }

Status mix_sounds(const Program& program, Time from, std::span<float> stereo) {
  for (const HeardSound& h : sounds_heard(program, from, static_cast<std::int64_t>(stereo.size() / 2)))
    if (Status s = decode(program, h, from, stereo); !s) return s;
  return Nothing{};
}

}  // namespace betwixt
