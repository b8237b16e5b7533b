// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/sounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "exchange/jailed_reader.h"
#include "exchange/sound_meter.h"

namespace betwixt {
namespace {

constexpr std::uint64_t most_memory = std::uint64_t{4} << 30;  // of ffmpeg itself
constexpr std::size_t samples_at_once = 1 << 15;

Error no_sound(const std::string& path, std::string_view why) {
  return fail(ErrorCode::file,
              fmt::format("{} is broken or not a sound: {}", path, why.empty() ? "it has no sound" : why));
}

std::vector<std::string> ffmpeg_call(const std::string& path) {
  std::vector<std::string> words{"-hide_banner", "-nostdin", "-loglevel", "error"};
  for (std::string& word : arguments_for_reading(path)) words.push_back(std::move(word));
  for (const char* word : {"-map", "0:a:0", "-f", "f32le", "-ac", "2", "-ar"}) words.emplace_back(word);
  words.push_back(std::to_string(sound_rate)), words.emplace_back("pipe:1");
  return words;
}

// Five minutes, and a second for every 100 bytes: the best compressed speech takes 700 bytes a second.
double longest_of(std::uint64_t size, bool any_size) {
  return any_size ? longest_sound : std::min(longest_sound, 300 + static_cast<double>(size) / 100);
}
// Ten times the needs of a slow machine.
ParserCeilings ceilings_of(std::uint64_t size, double longest) {
  const auto seconds = 5 + size / (std::uint64_t{1} << 20) + static_cast<std::uint64_t>(longest / 100);
  return {most_memory, seconds, 3 * seconds};
}

}  // namespace

Status decode_sound(const std::string& path, const Listener& hear, double longest) {
  const auto size = size_of_file(path);
  if (!size) return size.error();
  JailedReader decoder;
  if (Status s = decoder.start("ffmpeg", ffmpeg_call(path), path, ceilings_of(*size, longest), "sounds"); !s) return s;
  std::vector<float> samples(samples_at_once);
  const std::span<char> bytes(reinterpret_cast<char*>(samples.data()), samples.size() * sizeof(float));
  constexpr std::size_t pair = 2 * sizeof(float);
  std::size_t have = 0;
  while (const std::size_t n = decoder.read(bytes.subspan(have))) {
    have += n;
    const std::size_t whole = have / pair;
    if (!hear(std::span(samples).first(2 * whole))) return Nothing{};
    std::memmove(bytes.data(), bytes.data() + whole * pair, have - whole * pair);
    have -= whole * pair;
  }
  return decoder.finish([&](const std::string& why) {
    return no_sound(path, decoder.said().find("matches no streams") == std::string::npos ? why : "it has no sound");
  });
}

Result<std::shared_ptr<const Sound>> read_sound(const std::string& path, bool any_size) {
  const auto size = size_of_file(path);
  if (!size) return size.error();
  const double longest = longest_of(*size, any_size);
  SoundMeter meter;
  bool too_long = false;
  const Status decoded = decode_sound(
      path,
      [&](std::span<const float> stereo) {
        meter.hear(stereo);
        too_long = meter.seconds() > longest;
        return !too_long;
      },
      longest);
  if (!decoded) return decoded.error();
  if (too_long && longest < longest_sound)
    return fail(ErrorCode::range,
                fmt::format("{} is longer than {:.0f} s, the limit for a file of {} bytes", path, longest, *size),
                Hint(Permission::read_anywhere, "to read files of any size: --read-anywhere"));
  if (too_long) return fail(ErrorCode::range, fmt::format("{} is longer than four hours", path));
  if (meter.seconds() == 0) return no_sound(path, "");
  return std::make_shared<const Sound>(meter.sound(path));
}

}  // namespace betwixt
