// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/say_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/sha256.h"
#include "base/utf8.h"
#include "scene/spoken_words.h"
#include "syntax/texts.h"

namespace betwixt {
namespace {

constexpr std::string_view begins_said = "say:";
constexpr std::size_t most_said = 20'000, longest_voice_name = 60;  // characters

bool of_voice(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '+' || c == '/' || c == ' ';
}

}  // namespace

bool names_said_text(std::string_view name) { return name.starts_with(begins_said); }

std::string said_name(const SayText& say) { return fmt::format("say:{}:{}:{}", say.voice, say.pace, say.text); }

std::string write_said(std::string_view name) {
  const auto say = read_said_name(name);
  if (!say) return "file=" + write_text(name);
  std::string out = "say=" + write_text(say->text);
  if (say->voice != usual_voice) out += " voice=" + write_text(say->voice);
  if (say->pace != usual_pace) out += fmt::format(" pace={}", say->pace);
  return out;
}

std::string write_setting(const std::string& name, const Value& v, const std::string& value) {
  const Text* const text = name == "file" ? std::get_if<Text>(&v) : nullptr;
  return text && names_said_text(**text) ? write_said(**text) : name + "=" + value;
}

Result<SayText> read_said_name(std::string_view name) {
  SayText say;
  std::string_view rest = name.substr(std::min(begins_said.size(), name.size()));
  const std::size_t voice = rest.find(':'), pace = voice == rest.npos ? rest.npos : rest.find(':', voice + 1);
  if (pace == rest.npos)
    return fail(ErrorCode::syntax, "the name of a said text is say:VOICE:PACE:TEXT", "write say=\"TEXT\" instead");
  say.voice = rest.substr(0, voice), say.text = rest.substr(pace + 1);
  say.pace = 0;
  for (const char c : rest.substr(voice + 1, pace - voice - 1))
    say.pace = c >= '0' && c <= '9' && say.pace < 1000 ? 10 * say.pace + (c - '0') : 1000;
  if (say.pace < slowest_pace || say.pace > fastest_pace)
    return fail(ErrorCode::range, fmt::format("a pace is from {} to {} words a minute", slowest_pace, fastest_pace));
  if (say.voice.empty() || say.voice.size() > longest_voice_name ||
      !std::all_of(say.voice.begin(), say.voice.end(), of_voice))
    return fail(ErrorCode::name, fmt::format("'{}' cannot be a voice", visible(first_characters(say.voice, 40))),
                "to list the voices: espeak-ng --voices");
  if (letters_of(say.text).empty()) return fail(ErrorCode::range, "the text to say has no words");
  if (const std::size_t count = count_characters(say.text); count > most_said)
    return fail(ErrorCode::range,
                fmt::format("a text to say can have at most {} characters; this one has {}", most_said, count),
                "make several sounds, each with its at=");
  return say;
}

std::string said_file(std::string_view name) {
  std::string out = "say-";
  const auto hash = sha256(name);
  for (std::size_t i = 0; i < 8; ++i) out += fmt::format("{:02x}", hash[i]);
  return out;
}

}  // namespace betwixt
