// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/sound_bars.h"

#include <fmt/format.h>

#include <algorithm>

#include "betwixt/object.h"
#include "language/values.h"
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

Time SoundBar::time_of_word(std::size_t i) const {
  return from_seconds(from.seconds() + (words->words[i].start - own));
}

std::pair<std::size_t, std::size_t> SoundBar::heard_words() const {
  if (!words) return {0, 0};
  const auto place = [&](double second) {
    const auto at = std::ranges::lower_bound(words->words, second, {}, &SpokenWord::start);
    return static_cast<std::size_t>(at - words->words.begin());
  };
  return {place(own), place(own + (to - from).seconds())};
}

std::string SoundBar::moment_of_word(std::size_t i) const {
  const std::string word = spelt(*words, {i, i}), letters = letters_of(word);
  if (letters.empty()) return {};
  const auto [first, end] = heard_words();
  std::size_t which = 0;  // the language counts those that are heard
  for (const SpokenRun& run : find_spoken(*words, letters))
    if (run.first >= first && run.first <= i) ++which;
  return fmt::format("{}:{}{}", name, write_text(word), which > 1 ? fmt::format("#{}", which) : "");
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
    const Value words = program.read(Target(id, fn::sound_words), Time{});
    if (const auto spoken = d.scene().words->find(*std::get<Text>(words)); spoken != d.scene().words->end())
      all.back().words = spoken->second;
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
