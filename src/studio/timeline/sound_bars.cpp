// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/sound_bars.h"

#include <algorithm>

#include "betwixt/object.h"
#include "program/audible_part.h"
#include "scene/document.h"

namespace betwixt::studio {

double SoundBar::loudness(Time a, Time b) const {
  constexpr int most_looks = 16;
  double loudest = 0;
  for (int i = 0; i < most_looks; ++i) {
    const double share = (i + 0.5) / most_looks;
    const double at = (1 - share) * (a - from).seconds() + share * (b - from).seconds();
    loudest = std::max(loudest, sound->loudness(own + at));
  }
  return loudest;
}

std::vector<SoundBar> sound_bars(const Program& program) {
  std::vector<SoundBar> all;
  const Document& d = program.document();
  for (const ObjectId id : objects(d)) {
    if (kind(d, id) != Kind::sound) continue;
    const Value path = program.read(Target(id, fn::sound_file), Time{});
    const auto known = d.scene().sounds->find(*std::get<Text>(path));
    if (known == d.scene().sounds->end()) continue;
    const AudiblePart part = audible_part(
        known->second->seconds, [&](FunctionId f) { return std::get<double>(program.read(Target(id, f), Time{})); });
    const double from = part.at, to = part.at + (part.end() - part.from);
    if (!(to > from)) continue;
    all.push_back({id, d.name(id), known->second, from_seconds(from), from_seconds(to), part.from});
    for (double at = part.from; at < part.end(); at += 0.02)
      all.back().peak = std::max(all.back().peak, known->second->loudness(at));
  }
  std::ranges::stable_sort(all, {}, &SoundBar::from);
  std::vector<Time> ends;  // of the last bar in each row
  for (SoundBar& bar : all) {
    const auto free = std::ranges::find_if(ends, [&](Time end) { return end <= bar.from; });
    bar.row = static_cast<int>(free - ends.begin());
    free == ends.end() ? ends.push_back(bar.to) : void(*free = bar.to);
  }
  return all;
}

}  // namespace betwixt::studio
