// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt-parser: waits for work, and forks a process without other rights for each job. It has one thread and is never
// the author's own program, so that it can fork at any time, and quickly.
//   betwixt-parser VERSION                                            waits for work on file 3
//   betwixt-parser VERSION run MEMORY SECONDS FILE PROGRAM WORD…      becomes a program that can read that file only
//   betwixt-parser VERSION work MEMORY SECONDS FOLDER PROGRAM WORD…   becomes a program that can change that folder
//   only
//   betwixt-parser VERSION say VOICE PACE FOLDER                      says the text in that folder, where it is in a
//   jail
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "base/files.h"
#ifdef BETWIXT_OCIO
#include "exchange/color_program.h"
#endif
#include "exchange/parser_jail.h"
#include "exchange/parser_process.h"
#include "exchange/scratch_voice.h"

namespace betwixt {
namespace {

// Requests missing files from the program.
class AskingShelf final : public FileSource {
 public:
  AskingShelf(int job, std::string path, int file) : job_(job), path_(std::move(path)), file_(file) {}
  bool has(const std::string& path) override {
    if (path == path_) return true;
    const auto answer = ask(asks_has, path);
    return answer && answer->text[0] == answers_yes;
  }
  Result<std::string> read(const std::string& path) override {
    if (path == path_) return whole(file_, path);
    const auto answer = ask(asks_read, path);
    if (!answer) return fail(ErrorCode::machine, fmt::format("cannot read {}", path));
    if (answer->text[0] == answers_yes && answer->files.size() == 1) return whole(answer->files[0].fd(), path);
    const auto code = answer->text.size() > 1 ? answer->text[1] : static_cast<char>(ErrorCode::file);
    return fail(static_cast<ErrorCode>(code), answer->text.substr(std::min<std::size_t>(2, answer->text.size())));
  }
  // Returns an open file, or -1.
  int open(const std::string& path) const {
    auto answer = ask(asks_read, path);
    if (!answer || answer->text[0] != answers_yes || answer->files.size() != 1) return -1;
    return answer->files[0].release();
  }

 private:
  std::optional<ParserMessage> ask(char what, const std::string& path) const {
    if (path.size() >= longest_message || !say(job_, what + path)) return std::nullopt;
    return hear(job_);
  }
  static Result<std::string> whole(int file, const std::string& path) {
    std::string text;
    if (const int reason = read_all(file, text, largest_file)) return system_error(reason, "read", path);
    return text;
  }
  const int job_;
  const std::string path_;
  const int file_;
};

void work(const ParserMessage& message) {
  if (message.files.size() != 3 || message.text.size() <= sizeof(ParserRequest)) return;
  ParserRequest request;
  std::memcpy(&request, message.text.data(), sizeof request);
  std::string path = message.text.substr(sizeof request), line;
  if (const auto end = path.find('\0'); end != path.npos) line = path.substr(end + 1), path.resize(end);
  const int job = message.files[0].fd(), memory = message.files[1].fd();
  if (!say(job, {&says_begun, 1})) return;
  give_up_all_but_reading(request.most);
  AskingShelf files(job, path, message.files[2].fd());
#ifdef BETWIXT_OCIO
  static const AskingShelf* shelf = nullptr;
  shelf = &files;
  bake_colors = [](const std::string& asked, FileSource& from, const ColorQuery& query) {
    return colors_by_ocio(asked, from, query, [](const std::string& p) { return shelf->open(p); });
  };
#endif
  if (write_parsed(parse_here(request.task, path, files, request.any_size != 0, line), memory) == 0)
    say(job, {&says_done, 1});
}

int wait_for_work() {
  ::signal(SIGCHLD, SIG_IGN);  // children are not awaited
  while (const auto message = hear(parser_control)) {
    if (::fork() != 0) continue;
    ::close(parser_control);
    work(*message);
    ::_exit(0);
  }
  return 0;
}

// Returns only if the program cannot be started. Closes all files except standard input, output and error.
int run_in_jail(decltype(give_up_all_but_one_file)& give_up, char** words) {
  const std::string path = words[2], program = words[3];
  ::close_range(parser_control, ~0U, 0);
  give_up(path, program, {std::strtoull(words[0], nullptr, 10), std::strtoull(words[1], nullptr, 10)});
  ::execv(program.c_str(), words + 3);
  fmt::print(stderr, "{} cannot be started: {}\n", program, std::strerror(errno));
  return parser_started_nothing;
}

// Words: VOICE PACE FOLDER.
int say_there(char** words) {
  const std::string folder = words[2];
  const Status said = say_in_folder(folder, {words[0], static_cast<int>(std::strtol(words[1], nullptr, 10))});
  if (said) return 0;
  const Error& wrong = said.error();
  const std::string told = static_cast<char>(wrong.code) + wrong.message + "\n" + wrong.hint;
  return write_whole(folder + "/" + speech_error, told, true) ? 1 : 2;
}

}  // namespace
}  // namespace betwixt

int main(int count, char** words) {
  using namespace betwixt;
  if (count < 2 || std::strcmp(words[1], parser_version) != 0) return parser_of_another_version;
  if (count > 6 && std::strcmp(words[2], parser_runs) == 0) return run_in_jail(give_up_all_but_one_file, words + 3);
  if (count == 6 && std::strcmp(words[2], parser_says) == 0) return say_there(words + 3);
  if (count > 6 && std::strcmp(words[2], parser_works_in) == 0)
    return run_in_jail(give_up_all_but_one_folder, words + 3);
  if (count != 2) return parser_of_another_version;
  ::close_range(parser_control + 1, ~0U, 0);
  // Detaches from parent and terminal: a user of the library need not know of this process, and Ctrl-C does not stop
  // it.
  if (const pid_t waits = ::fork(); waits != 0) ::_exit(waits < 0 ? 1 : 0);
  ::setsid();
  [[maybe_unused]] const int root = ::chdir("/");  // the present folder may be removed
  ::_exit(wait_for_work());
}
