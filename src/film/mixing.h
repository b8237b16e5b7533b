// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds which samples of which sounds play in a part of a film. Samples are pairs, left and right.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "betwixt/program.h"
#include "betwixt/sound.h"
#include "program/audible_part.h"

namespace betwixt {

struct HeardSound {
  ObjectId id;
  std::shared_ptr<const Sound> sound;
  AudiblePart part;
  std::int64_t offset = 0;           // the sample of the file for the first sample of the part
  std::int64_t first = 0, last = 0;  // samples first … last - 1 of the file play
};
std::vector<HeardSound> sounds_heard(const Program&, Time from, std::int64_t pairs);
// Adds samples of the file, from its sample `own` on. All must be in the range first … last - 1.
void add_sound(const Program&, const HeardSound&, std::int64_t own, std::span<const float> samples, Time from,
               std::span<float> stereo);

}  // namespace betwixt
