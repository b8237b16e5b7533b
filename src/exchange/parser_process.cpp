// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/parser_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <mutex>

extern char** environ;

namespace betwixt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t gigabyte = std::uint64_t{1} << 30, megabyte = std::uint64_t{1} << 20;
constexpr int most_asked = 10'000;  // files that one file names

// A pair of connected sockets.
struct Line {
  std::array<int, 2> ends{-1, -1};
  Line() {
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) ends = {-1, -1};
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line() { hang_up(0), hang_up(1); }
  void hang_up(std::size_t i) {
    if (ends[i] >= 0) ::close(ends[i]);
    ends[i] = -1;
  }
};

int spawn(const std::string& program, int control, pid_t& pid) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t ways;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&ways);
  // First, because one of the other files may have this number.
  posix_spawn_file_actions_adddup2(&files, control, parser_control);
  for (const int fd : {0, 1, 2}) posix_spawn_file_actions_addopen(&files, fd, "/dev/null", O_RDWR, 0);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&ways, &none);
  posix_spawnattr_setsigdefault(&ways, &all);
  posix_spawnattr_setflags(&ways, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::array<char*, 3> words{const_cast<char*>(program.c_str()), const_cast<char*>(parser_version), nullptr};
  const int failed = ::posix_spawn(&pid, program.c_str(), &files, &ways, words.data(), environ);
  posix_spawnattr_destroy(&ways);
  posix_spawn_file_actions_destroy(&files);
  return failed;
}

// The process that waits for work. Started at the first request, once for each program.
class Waiting {
 public:
  // Returns 0, ENOENT (the program is missing or of another version), or the system's error number.
  int send(const std::string& request, std::span<const int> files) {
    const std::lock_guard lock(mutex_);
    // The process may have been killed.
    for (int tries = 0; tries < 2; ++tries) {
      if (control_ < 0)
        if (const int reason = start()) return reason;
      if (say(control_, request, files)) return 0;
      ::close(std::exchange(control_, -1));
    }
    return EPIPE;
  }

 private:
  int start() {
    if (missing_) return ENOENT;
    const std::string program = find_parser();
    missing_ = program.empty();
    if (missing_) return ENOENT;
    Line line;
    if (line.ends[0] < 0) return errno;
    pid_t pid = -1;
    if (const int reason = spawn(program, line.ends[1], pid)) return reason;
    // The process continues in a child of its own. If signals of children are ignored, the exit status is unknown.
    int status = 0;
    pid_t ended = 0;
    while ((ended = ::waitpid(pid, &status, 0)) < 0 && errno == EINTR) {
    }
    missing_ = ended == pid && WIFEXITED(status) && WEXITSTATUS(status) == parser_of_another_version;
    if (missing_) return ENOENT;
    if (ended == pid && status != 0) return EAGAIN;
    control_ = std::exchange(line.ends[0], -1);
    return 0;
  }

  std::mutex mutex_;
  int control_ = -1;
  bool missing_ = false;
};

Waiting& waiting() {
  static Waiting& one = *new Waiting;  // never destroyed: other threads may still read at program exit
  return one;
}

// Answers a parser's requests until it is done. Trusts none of them.
class Conversation {
 public:
  Conversation(int job, const std::string& path, const MayRead& may_read)
      : job_(job), path_(path), may_read_(may_read), files_(may_read) {}

  // Returns the error, if there was one.
  Status listen(const ParserCeilings& most) {
    const auto begun = Clock::now();
    const auto gone = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
    bool working = false;
    for (int asked = 0; asked < most_asked;) {
      const double left = static_cast<double>(most.wall) + 1 - gone();
      const auto message = left > 0 ? hear(job_, static_cast<int>(left * 1000) + 1) : std::nullopt;
      if (!message || message->text.empty()) break;
      if (message->text[0] == says_done) return Nothing{};
      if (message->text[0] == says_begun)
        working = true;
      else if (++asked; !answer(*message))
        break;
    }
    if (!working) return fail(ErrorCode::machine, fmt::format("cannot start a process to read {}", path_));
    if (const auto seconds = std::min(most.seconds, most.wall); gone() >= static_cast<double>(seconds))
      return fail(ErrorCode::file, fmt::format("reading {} takes more than {} s", path_, seconds));
    return fail(ErrorCode::file, fmt::format("{} is damaged: the program that reads it crashed", path_));
  }

 private:
  bool answer(const ParserMessage& question) {
    const std::string path = question.text.substr(1);
    if (path.find('\0') != std::string::npos) return false;
    if (question.text[0] == asks_has) return say(job_, {files_.has(path) ? &answers_yes : &answers_no, 1});
    if (question.text[0] != asks_read) return false;
    if (!may_read_(path)) return refuse(fail(ErrorCode::file, fmt::format("reading {} is not allowed", path)));
    const auto file = open_whole(path);
    if (!file) return refuse(file.error());
    const int fd = file->fd();
    return say(job_, {&answers_yes, 1}, {&fd, 1});
  }
  bool refuse(const Error& e) {
    return say(job_, std::string{answers_no, static_cast<char>(e.code)} + e.message.substr(0, longest_message - 2));
  }

  const int job_;
  const std::string& path_;
  const MayRead& may_read_;
  LocalFiles files_;
};

Error machine_error(const std::string& path, int reason) {
  return fail(ErrorCode::machine, fmt::format("cannot read {}: {}", path, std::strerror(reason)));
}

}  // namespace

ParserCeilings parser_ceilings(const std::string& path, std::uint64_t size, bool any_size) {
  const std::uint64_t seconds = 20 + size / megabyte;
  // gltf and obj files may keep their large data in other files.
  const bool alone = ending(path) != "gltf" && ending(path) != "obj";
  const std::uint64_t plenty = (alone ? 3 : 6) * gigabyte + 32 * size;
  const std::uint64_t becomes = gigabyte + 200 * std::min(size, gigabyte);  // twice: also for the data it is made from
  return {any_size || !alone ? plenty : std::min(plenty, becomes), seconds, 3 * seconds};
}

namespace {

// `line`: behind the path in the message.
std::optional<Parsed> converse(const ParserRequest& request, const std::string& path, std::string_view line, int file,
                               const MayRead& may_read) {
  const OpenFile memory(::memfd_create("betwixt-parsed", MFD_CLOEXEC));
  if (!memory) return machine_error(path, errno);
  Line talk;
  if (talk.ends[0] < 0) return machine_error(path, errno);
  std::string text(reinterpret_cast<const char*>(&request), sizeof request);
  text += path;
  if (!line.empty()) (text += '\0') += line;
  if (text.size() > longest_message) return machine_error(path, ENAMETOOLONG);
  const std::array files{talk.ends[1], memory.fd(), file};
  const int reason = waiting().send(text, files);
  if (reason == ENOENT) return std::nullopt;
  if (reason != 0) return machine_error(path, reason);
  talk.hang_up(1);
  if (const Status done = Conversation(talk.ends[0], path, may_read).listen(request.most); !done) return done.error();
  Parsed parsed;
  if (const int why = read_parsed(memory.fd(), parsed); why == EBADMSG)
    return fail(ErrorCode::file, fmt::format("{} is damaged: the program that reads it gave a wrong answer", path));
  else if (why != 0)
    return machine_error(path, why);
  return parsed;
}

}  // namespace

std::optional<Parsed> parse_apart(ParserTask task, const std::string& path, const MayRead& may_read, bool any_size,
                                  std::optional<ParserCeilings> most, std::string_view inside) {
  const auto file = open_whole(path);
  if (!file) return file.error();
  struct stat about {};
  if (::fstat(file->fd(), &about) != 0) return machine_error(path, errno);
  const auto size = static_cast<std::uint64_t>(about.st_size);
  return converse({task, any_size, most.value_or(parser_ceilings(path, size, any_size))}, path, inside, file->fd(),
                  may_read);
}

std::optional<Parsed> shape_apart(const std::string& name, int file, std::string_view line,
                                  const ParserCeilings& most) {
  const MayRead nothing = [](const std::string&) { return false; };
  if (::lseek(file, 0, SEEK_SET) != 0) return machine_error(name, errno);
  return converse({ParserTask::letters, 1, most}, name, line, file, nothing);
}

}  // namespace betwixt
