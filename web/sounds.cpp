// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sounds of films in pages. The browser decodes their files, and engine.js hands the samples over. They stay here as
// long as the page has the file or a film uses it, so that another text of the film needs no other decoding.
#include "exchange/sounds.h"

#include <emscripten.h>
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "exchange/said_text.h"
#include "exchange/sound_meter.h"
#include "exchange/words_file.h"

namespace betwixt {
namespace {

struct Decoded {
  Sound sound;
  std::vector<float> samples;
  std::string trouble;  // why there are no samples
};

std::map<int, std::shared_ptr<const Decoded>> decoded_sounds;              // those of the page's files
std::map<std::string, std::weak_ptr<const Decoded>, std::less<>> by_path;  // those that films may use; made-up paths
std::map<std::string, int, std::less<>> given_files;                       // of the film that is opening, by path

}  // namespace

Status decode_sound(const std::string& path, const Listener& hear, double) {
  const auto found = by_path.find(path);
  const auto decoded = found == by_path.end() ? nullptr : found->second.lock();
  if (!decoded) return fail(ErrorCode::file, fmt::format("{} has not been decoded", path));
  (void)hear(decoded->samples);
  return Nothing{};
}

// Without a decoder, as in Node, a sound is silent.
Result<std::shared_ptr<const Sound>> read_sound(const std::string& path, bool) {
  const auto given = given_files.find(std::filesystem::absolute(path).lexically_normal().string());
  if (given == given_files.end()) return std::make_shared<const Sound>();
  const std::shared_ptr<const Decoded> decoded = decoded_sounds.at(given->second);
  if (!decoded->trouble.empty())
    return fail(ErrorCode::file, fmt::format("this browser cannot decode {}: {}", path, decoded->trouble),
                ".wav, .mp3, .m4a and .flac are decoded by nearly all browsers");
  return std::shared_ptr<const Sound>(decoded, &decoded->sound);
}

// The page was made with the voice and its words.
Result<std::shared_ptr<const SaidText>> say_named(const std::string& name) {
  if (const auto say = read_said_name(name); !say) return say.error();
  const std::string file = "/film/" + said_file(name);
  auto words = load_words(file + ".words");
  if (!words)
    return fail(ErrorCode::machine, "this page cannot say a new text",
                "betwixt web makes the page anew, with its voice");
  auto sound = read_sound(file + ".wav", true);
  if (!sound) return sound.error();
  return std::make_shared<const SaidText>(SaidText{file + ".wav", *std::move(sound), *std::move(words)});
}

}  // namespace betwixt

using namespace betwixt;  // NOLINT: nothing else follows

extern "C" {

// Takes decoded samples: `pairs` of left and right. With `trouble`, the file could not be decoded.
EMSCRIPTEN_KEEPALIVE void betwixt_add_sound(int number, const char* trouble, const float* stereo, int pairs) {
  auto decoded = std::make_shared<Decoded>();
  decoded->trouble = trouble;
  decoded->samples.assign(stereo, stereo + 2 * static_cast<std::ptrdiff_t>(pairs));
  SoundMeter meter;
  meter.hear(decoded->samples);
  decoded->sound = meter.sound(fmt::format("sound:{}", number));
  std::erase_if(by_path, [](const auto& one) { return one.second.expired(); });
  by_path[decoded->sound.path] = decoded;
  decoded_sounds[number] = std::move(decoded);
}
EMSCRIPTEN_KEEPALIVE void betwixt_drop_sound(int number) { decoded_sounds.erase(number); }

// The file with this path is that sound, until betwixt_give_no_sounds.
EMSCRIPTEN_KEEPALIVE void betwixt_give_sound(const char* path, int number) { given_files[path] = number; }
EMSCRIPTEN_KEEPALIVE void betwixt_give_no_sounds() { given_files.clear(); }

}  // extern "C"
