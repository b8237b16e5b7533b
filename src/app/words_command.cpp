// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt words: when the words of a recording are spoken.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "app/alignment.h"
#include "app/command.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "exchange/scratch_voice.h"
#include "exchange/words_file.h"
#include "language/captions.h"
#include "scene/document.h"

namespace betwixt {
namespace {

struct WordsCall {
  std::string file, text, say, out;
  VoiceChoice voice;
  int speed = 150;
  bool keep_old = false;
};

// Returns the name with another ending.
std::string with_ending(const std::string& path, const std::string& to) {
  const std::string old = ending(path);
  return path.substr(0, old.empty() ? path.size() : path.size() - old.size() - 1) + "." + to;
}

int say_words(const SpokenWords& words, const std::string& out) {
  fmt::print("{}: {}, {:.1f} s\n", out, counted(words.words.size(), "word"),
             words.words.empty() ? 0.0 : words.words.back().end);
  return all_done;
}

int put_words(const WordsCall& call, const SpokenWords& words, const std::string& out) {
  if (Status s = write_whole(out, write_words(words), !call.keep_old); !s) return complain(s.error(), wrong_call);
  return say_words(words, out);
}

// Shows a line on a terminal while the work takes more than a second.
class WorkLine {
 public:
  ~WorkLine() {
    if (drawn_) fmt::print(stderr, "\r\x1b[K");
  }
  bool operator()(double done, double whole) {
    if (done > 1 && done > next_ && ::isatty(STDERR_FILENO) == 1) {
      fmt::print(stderr, "\r\x1b[Kaligning: {:.0f} s of about {:.0f} s", done, std::max(done, whole));
      std::fflush(stderr);
      drawn_ = true, next_ = done + 0.5;
    }
    return !stop_requested();
  }

 private:
  double next_ = 0;
  bool drawn_ = false;
};

int align_call(const WordsCall& call) {
  const std::string out = call.out.empty() ? with_ending(call.file, "words") : call.out;
  if (out == call.text || out == call.file)
    return complain(fail(ErrorCode::range, fmt::format("{} would overwrite what is read", out)), wrong_call);
  if (Status s = check_place(out, !call.keep_old); !s) return complain(s.error(), wrong_call);
  const auto text = read_whole(call.text);
  if (!text) return complain(text.error(), wrong_input);
  catch_stops();
  const Result<Alignment> found = [&] {
    WorkLine line;
    return align_words(call.file, *text, std::ref(line));
  }();
  if (stop_requested()) return interrupted;
  if (!found) return complain(found.error(), wrong_input);
  if (!found->doubts.empty())
    tell_user(
        fmt::format("betwixt: warning: perhaps the text is not what is spoken: {}\n", fmt::join(found->doubts, "; ")));
  return put_words(call, found->words, out);
}

// Writes the sound and its words. The words come last, so that a sound never has those of another.
int say_call(WordsCall& call) {
  const std::string out = call.out.empty() ? with_ending(call.say, "wav") : call.out;
  if (ending(out) != "wav")
    return complain(fail(ErrorCode::range, fmt::format("a scratch voice is a .wav, not \"{}\"", out)), wrong_call);
  const std::string words_out = with_ending(out, "words");
  for (const std::string& path : {out, words_out})
    if (Status s = check_place(path, !call.keep_old); !s) return complain(s.error(), wrong_call);
  const auto text = read_whole(call.say);
  if (!text) return complain(text.error(), wrong_input);
  call.voice.speed = call.speed;
  const Result<ScratchVoice> voice = say_text(*text, call.voice);
  if (!voice) return complain(voice.error(), voice.error().code == ErrorCode::name ? wrong_call : wrong_input);
  if (Status s = write_whole(out, wave_of(*voice), !call.keep_old); !s) return complain(s.error(), wrong_call);
  fmt::print("{}: {:.1f} s\n", out, static_cast<double>(voice->samples.size()) / voice->rate);
  return put_words(call, voice->words, words_out);
}

// Rewrites a file of another format as lines of words.
int convert_words(const WordsCall& call) {
  const auto words = load_words(call.file);
  if (!words) return complain(words.error(), wrong_input);
  if (!call.out.empty()) return put_words(call, **words, call.out);
  fmt::print("{}", write_words(**words));
  return all_done;
}

// Writes what is spoken in a film as captions.
int caption_film(const WordsCall& call) {
  const std::string out = call.out.empty() ? with_ending(call.file, "srt") : call.out, kind = ending(out);
  if (kind != "vtt" && kind != "srt")
    return complain(fail(ErrorCode::range, fmt::format("captions of a film are a .vtt or a .srt, not \"{}\"", out)),
                    wrong_call);
  const std::optional<Document> film = open_script(call.file);
  if (!film) return wrong_input;
  const std::vector<Caption> all = captions_of_film(film->scene());
  if (all.empty())
    return complain(fail(ErrorCode::file, fmt::format("no sound of {} has words", call.file),
                         "create voice sound file=\"talk.wav\" words=\"talk.words\""),
                    wrong_input);
  const Status s = write_whole(out, kind == "vtt" ? write_webvtt(all) : write_srt(all), !call.keep_old);
  if (!s) return complain(s.error(), wrong_call);
  fmt::print("{}: {}\n", out, counted(all.size(), "caption"));
  return all_done;
}

int words_command(WordsCall& call) {
  const std::string kind = ending(call.file);
  const VoiceChoice usual;
  if (!call.say.empty()) return say_call(call);
  if (call.file.empty())
    return complain(fail(ErrorCode::syntax, "a recording is missing",
                         "as in betwixt words talk.wav --text talk.txt, or betwixt words --say talk.txt -o talk.wav"),
                    wrong_call);
  if (call.voice.voice != usual.voice || call.speed != usual.speed)
    return complain(fail(ErrorCode::syntax, "--voice and --speed are for a voice that is made", "add --say TEXT.txt"),
                    wrong_call);
  if (!call.text.empty()) return align_call(call);
  if (kind == "bx") return caption_film(call);
  if (kind == "vtt" || kind == "srt" || kind == "json" || kind == "textgrid" || kind == "txt" || kind == "words")
    return convert_words(call);
  return complain(fail(ErrorCode::syntax, fmt::format("the text of {} is missing", call.file),
                       "--text FILE: all that is spoken, in English"),
                  wrong_call);
}

const Enlisted enlisted_words(words_command, [](WordsCall& call) -> Subcommand {
  Parameter recording{
      .name = "FILE",
      .sentence =
          "a recording; words in another format (.vtt .srt .json .TextGrid .txt) to rewrite; or a film, for captions",
      .into = &call.file,
      .offer = Offer::files};
  Parameter speed =
      option("--speed", "N", "words a minute of the voice of --say, 80 to 450; by default 150", &call.speed);
  speed.range = {{80, 450}};
  Parameter out = output_parameter(
      call.out, "OUT",
      "the file of words, the .wav of --say, or captions of a film, .srt or .vtt; by default beside FILE");
  out.required = false;
  return {
      .rank = 17,
      .name = "words",
      .sentence = "finds when the words of a recording are spoken, or makes a scratch voice",
      .takes = {recording,
                file_option("--text", "FILE", "the text of the recording: all that is spoken, in English", &call.text),
                file_option("--say", "FILE", "makes a voice that reads this text, OUT.wav, and OUT.words", &call.say,
                            "--text"),
                speed, option("--voice", "NAME", "a voice of espeak-ng; by default en-us", &call.voice.voice), out,
                flag("--no-overwrite", "keeps existing files", call.keep_old)},
      .example = "betwixt words talk.wav --text talk.txt -o talk.words",
      .manual =
          "A script names both files: create voice sound file=\"talk.wav\" words=\"talk.words\". Then "
          "voice:\"the square\" is a time. Alignment needs the packages pocketsphinx and pocketsphinx-en-us, a "
          "scratch voice the package espeak-ng; films need neither."};
});

}  // namespace
}  // namespace betwixt
