// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/scratch_voice.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/files.h"
#include "base/utf8.h"
#include "exchange/words_file.h"

namespace betwixt {
namespace {

constexpr double longest_in_folder = 24 * 60;  // seconds: as much as the process may write
constexpr std::size_t longest_paragraph = 100'000;

// What the library's header says of its interface, which is the same in all versions of libespeak-ng.so.1.
struct SpeechEvent {
  int type;  // 0: the list ends
  unsigned message;
  int text_position;  // characters, from 1
  int length, audio_position, sample;
  void* user;
  char name[8];
};
constexpr int word_event = 1, phoneme_event = 7, synchronous = 2, with_phonemes = 1, dont_exit = 0x8000, utf8_text = 1,
              rate_parameter = 1;
using Hears = int (*)(short* samples, int count, SpeechEvent* events);

// A voice, or what to look for among them.
struct SpeechVoice {
  const char *name, *languages, *identifier;  // a variant's identifier is "!v/f3"
  unsigned char gender, age, number, reserved;
  int score;
  void* spare;
};

// A word or a phoneme that begins: at which sample of its paragraph, and at which character.
struct SpeechBegins {
  std::size_t sample = 0;
  std::size_t character = 0;
  bool phoneme = false, pause = false;
};
struct SpeechHeard {
  std::vector<std::int16_t> samples;
  std::vector<SpeechBegins> events;
};
SpeechHeard* hearing = nullptr;  // where the library's callback puts what it is given

int hear_speech(short* samples, int count, SpeechEvent* events) {
  for (; events->type != 0; ++events)
    if (events->type == word_event || events->type == phoneme_event)
      hearing->events.push_back({static_cast<std::size_t>(std::max(events->sample, 0)),
                                 static_cast<std::size_t>(std::max(events->text_position, 1) - 1),
                                 events->type == phoneme_event,
                                 events->type == phoneme_event && events->name[0] == '_'});
  if (samples != nullptr && count > 0) hearing->samples.insert(hearing->samples.end(), samples, samples + count);
  return 0;
}

// The library, loaded.
class Espeak {
 public:
  Status load(const VoiceChoice& choice) {
    library_ = ::dlopen("libespeak-ng.so.1", RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr)
      return fail(ErrorCode::machine, "the scratch voice needs espeak-ng, which is not installed",
                  "sudo apt-get install espeak-ng");
    const auto initialize = find<int (*)(int, int, const char*, int)>("espeak_Initialize");
    const auto set_voice = find<int (*)(const char*)>("espeak_SetVoiceByName");
    const auto set_parameter = find<int (*)(int, int, int)>("espeak_SetParameter");
    const auto set_callback = find<void (*)(Hears)>("espeak_SetSynthCallback");
    synthesize_ =
        find<int (*)(const void*, std::size_t, unsigned, int, unsigned, unsigned, unsigned*, void*)>("espeak_Synth");
    if (!initialize || !set_voice || !set_parameter || !set_callback || !synthesize_)
      return fail(ErrorCode::machine, "the library libespeak-ng.so.1 is not the one that is expected");
    rate_ = initialize(synchronous, 0, nullptr, with_phonemes | dont_exit);
    if (rate_ <= 0) return fail(ErrorCode::machine, "espeak-ng lacks its data", "sudo apt-get install espeak-ng-data");
    if (set_voice(choice.voice.c_str()) != 0 || !has_variant(choice.voice))
      return fail(ErrorCode::name, fmt::format("espeak-ng has no voice '{}'", visible(choice.voice)),
                  "to list the voices: espeak-ng --voices");
    set_parameter(rate_parameter, choice.speed, 0);
    set_callback(hear_speech);
    return Nothing{};
  }
  int rate() const { return rate_; }
  Result<SpeechHeard> say(const std::string& text) const {
    SpeechHeard heard;
    hearing = &heard;
    const int failed = synthesize_(text.c_str(), text.size() + 1, 0, 1, 0, utf8_text, nullptr, nullptr);
    hearing = nullptr;
    if (failed != 0) return fail(ErrorCode::machine, "espeak-ng failed");
    return heard;
  }

 private:
  // The library ignores an unknown variant: that behind the '+' of en-us+f3.
  bool has_variant(const std::string& voice) const {
    const std::size_t plus = voice.find('+');
    const auto list = find<const SpeechVoice** (*)(const SpeechVoice*)>("espeak_ListVoices");
    if (plus == std::string::npos || !list) return true;
    const SpeechVoice variants{nullptr, "variant", nullptr, 0, 0, 0, 0, 0, nullptr};
    for (const SpeechVoice** one = list(&variants); one && *one; ++one)
      if ((*one)->identifier == "!v/" + voice.substr(plus + 1)) return true;
    return false;
  }
  template <class F>
  F find(const char* name) const {
    return reinterpret_cast<F>(::dlsym(library_, name));
  }
  void* library_ = nullptr;  // never closed: its data stay in use until the program ends
  int rate_ = 0;
  int (*synthesize_)(const void*, std::size_t, unsigned, int, unsigned, unsigned, unsigned*, void*) = nullptr;
};

// A word of a paragraph, and the sample at which it begins and ends, where the voice tells.
struct SaidWord {
  std::string text;
  std::size_t from = 0, to = 0;  // characters
  std::optional<std::size_t> begins, ends;
};

std::vector<SaidWord> words_in(const std::string& paragraph) {
  std::vector<SaidWord> all;
  std::size_t at = 0;
  for (const std::string& word : words_of_text(paragraph)) {
    at = paragraph.find(word, at);
    const std::size_t from = count_characters(std::string_view(paragraph).substr(0, at));
    all.push_back({word, from, from + count_characters(word), {}, {}});
    at += word.size();
  }
  return all;
}

// The event of a word comes before its first phoneme: it includes the closure before a stop, and sometimes the end of
// the word before, which a phoneme of that word shows.
void set_times(std::vector<SaidWord>& words, const SpeechHeard& heard) {
  const std::vector<SpeechBegins>& events = heard.events;
  const auto word_at = [&](std::size_t character) {
    return std::find_if(words.begin(), words.end(),
                        [&](const SaidWord& w) { return w.from <= character && character < w.to; });
  };
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto word = word_at(events[i].character);
    if (events[i].phoneme || word == words.end() || word->begins) continue;
    const auto mine = [&](const SpeechBegins& e) { return e.phoneme && !e.pause && word_at(e.character) == word; };
    const auto first = std::find_if(events.begin() + static_cast<std::ptrdiff_t>(i), events.end(), mine);
    if (first == events.end()) continue;
    const bool of_another = std::any_of(events.begin(), events.end(), [&](const SpeechBegins& e) {
      return e.phoneme && !e.pause && e.sample >= events[i].sample && e.sample < first->sample;
    });
    word->begins = of_another ? first->sample : events[i].sample;
  }
  for (SaidWord& word : words) {
    if (!word.begins) continue;
    word.ends = heard.samples.size();
    for (const SpeechBegins& e : events) {
      const auto of = word_at(e.character);
      const bool other = e.pause || (of != words.end() && &*of != &word);
      if (other && e.sample > *word.begins) word.ends = std::min(*word.ends, e.sample);
    }
    for (const SaidWord& next : words)
      if (next.begins && *next.begins > *word.begins) word.ends = std::min(*word.ends, *next.begins);
  }
}

// Adds the words. The voice says some words as one, as "of the"; they share its time in proportion to their letters.
void add_said(SpokenWords& to, const std::vector<SaidWord>& words, double from, int rate) {
  double last = from;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t behind = i + 1, letters = words[i].text.size();
    while (behind < words.size() && !words[behind].begins) letters += words[behind++].text.size();
    const auto seconds = [&](const std::optional<std::size_t>& sample) {
      return sample ? from + static_cast<double>(*sample) / rate : last;
    };
    const double begin = std::max(last, seconds(words[i].begins)), end = std::max(begin, seconds(words[i].ends));
    std::size_t said = 0;
    for (; i < behind; ++i) {
      const auto at = [&](std::size_t n) {
        return begin + (end - begin) * static_cast<double>(n) / static_cast<double>(letters);
      };
      const double starts = at(said);
      said += words[i].text.size();
      to.add({starts, at(said), words[i].text});
    }
    last = end;
  }
}

}  // namespace

Result<ScratchVoice> say_text(std::string_view text, const VoiceChoice& choice) {
  Espeak espeak;
  if (Status s = espeak.load(choice); !s) return s.error();
  ScratchVoice all;
  all.rate = espeak.rate();
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string paragraph(text.substr(at, end - at));
    at = end + 1;
    std::vector<SaidWord> words = words_in(paragraph);
    if (words.empty()) continue;
    if (paragraph.size() > longest_paragraph)
      return fail(ErrorCode::range, fmt::format("a line of the text can have at most {} bytes", longest_paragraph));
    if (!all.samples.empty())
      all.samples.resize(all.samples.size() + static_cast<std::size_t>(choice.pause * all.rate));
    const Result<SpeechHeard> heard = espeak.say(paragraph);
    if (!heard) return heard.error();
    set_times(words, *heard);
    add_said(all.words, words, static_cast<double>(all.samples.size()) / all.rate, all.rate);
    all.samples.insert(all.samples.end(), heard->samples.begin(), heard->samples.end());
    if (static_cast<double>(all.samples.size()) > choice.longest * all.rate)
      return fail(ErrorCode::range, fmt::format("the text takes more than {:.0f} minutes to say", choice.longest / 60));
  }
  if (all.words.words.empty()) return fail(ErrorCode::range, "the text has no words");
  return all;
}

std::string wave_of(const ScratchVoice& voice) {
  std::string bytes;
  const auto put = [&](std::uint32_t number, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> 8 * i & 0xFF);
  };
  const auto size = static_cast<std::uint32_t>(2 * voice.samples.size()), rate = static_cast<std::uint32_t>(voice.rate);
  bytes += "RIFF", put(size + 36, 4), bytes += "WAVEfmt ", put(16, 4), put(1, 2), put(1, 2), put(rate, 4);
  put(2 * rate, 4), put(2, 2), put(16, 2), bytes += "data", put(size, 4);
  for (const std::int16_t sample : voice.samples) put(static_cast<std::uint16_t>(sample), 2);
  return bytes;
}

Status say_in_folder(const std::string& folder, VoiceChoice choice) {
  choice.longest = std::min(choice.longest, longest_in_folder);
  const auto text = read_whole(folder + "/" + speech_text);
  if (!text) return text.error();
  const auto voice = say_text(*text, choice);
  if (!voice) return voice.error();
  if (Status s = write_whole(folder + "/" + speech_words, write_words(voice->words), true); !s) return s;
  return write_whole(folder + "/" + speech_wave, wave_of(*voice), true);
}

}  // namespace betwixt
