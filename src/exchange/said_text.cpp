// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/said_text.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>

#include "base/child.h"
#include "base/files.h"
#include "base/process_folder.h"
#include "exchange/parser_process.h"
#include "exchange/scratch_voice.h"
#include "exchange/sounds.h"
#include "exchange/words_file.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t speech_memory = std::uint64_t{1} << 30, speech_seconds = 60;
constexpr std::size_t most_kept_texts = 16;

// A voice and its folder, which goes with it.
struct SaidFiles {
  fs::path folder;
  SaidText said;
  ~SaidFiles() {
    std::error_code ignored;
    if (!folder.empty()) fs::remove_all(folder, ignored);
  }
};

struct SaidTexts {
  std::mutex mutex;
  ProcessFolder folder{"said"};
  std::uint64_t count = 0;
  std::map<std::string, std::weak_ptr<const SaidFiles>> known;
  std::deque<std::shared_ptr<const SaidFiles>> lately;
};
SaidTexts& said_texts() {
  static SaidTexts all;
  return all;
}

// Says the text of a folder in another process, whose rights end there.
Status say_apart(const std::string& jail, const SayText& say, const fs::path& folder) {
  const std::string program = fs::absolute(jail).string();
  pid_t pid = -1;
  const std::vector<std::string> words{program,
                                       parser_version,
                                       parser_works_in,
                                       std::to_string(speech_memory),
                                       std::to_string(speech_seconds),
                                       folder.string(),
                                       program,
                                       parser_version,
                                       parser_says,
                                       say.voice,
                                       std::to_string(say.pace),
                                       folder.string()};
  if (const int failed = start_child(pid, words, {})) return system_error(failed, "start", program);
  const auto status = wait_for_child(pid, std::chrono::seconds(2 * speech_seconds));
  if (!status) return fail(ErrorCode::machine, "espeak-ng takes too long to say this text");
  const int code = WIFEXITED(*status) ? WEXITSTATUS(*status) : -1;
  if (code == parser_of_another_version)
    return fail(ErrorCode::machine, "the program betwixt-parser has another version than this program");
  if (code == 0) return Nothing{};
  if (const auto wrong = read_contents((folder / speech_error).string()); wrong.text.size() > 1) {
    const std::size_t end = std::min(wrong.text.find('\n'), wrong.text.size());
    return fail(static_cast<ErrorCode>(wrong.text[0]), wrong.text.substr(1, end - 1),
                wrong.text.substr(std::min(end + 1, wrong.text.size())));
  }
  return fail(ErrorCode::machine, "espeak-ng cannot say this text");
}

Status make_said(const SayText& say, SaidFiles& to) {
  std::error_code why;
  fs::create_directory(to.folder, why);
  if (Status s = write_whole((to.folder / speech_text).string(), say.text, true); !s) return s;
  const std::string jail = find_parser();
  const Status said =
      jail.empty() ? say_in_folder(to.folder.string(), {say.voice, say.pace}) : say_apart(jail, say, to.folder);
  if (!said) return said;
  to.said.wave = (to.folder / speech_wave).string();
  auto sound = read_sound(to.said.wave, true);
  if (!sound) return sound.error();
  auto words = load_words((to.folder / speech_words).string());
  if (!words) return words.error();
  to.said.sound = *std::move(sound), to.said.words = *std::move(words);
  return Nothing{};
}

}  // namespace

Result<std::shared_ptr<const SaidText>> say_named(const std::string& name) {
  const auto say = read_said_name(name);
  if (!say) return say.error();
  SaidTexts& all = said_texts();
  const std::lock_guard lock(all.mutex);
  std::shared_ptr<const SaidFiles> made = all.known[name].lock();
  if (!made) {
    const auto within = all.folder.get();
    if (!within) return within.error();
    const auto fresh = std::make_shared<SaidFiles>();
    fresh->folder = *within / std::to_string(++all.count);
    if (Status s = make_said(*say, *fresh); !s) return s.error();
    made = fresh;
    std::erase_if(all.known, [](const auto& one) { return one.second.expired(); });
    all.known[name] = made;
    all.lately.push_back(made);
    if (all.lately.size() > most_kept_texts) all.lately.pop_front();
  }
  return std::shared_ptr<const SaidText>(made, &made->said);
}

}  // namespace betwixt
