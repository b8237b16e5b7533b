// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/jailed_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>

#include "base/child.h"
#include "base/files.h"
#include "exchange/parser_process.h"

namespace betwixt {
namespace {

constexpr const char* kinds_of_files =
    "wav,w64,aiff,au,caf,flac,ogg,mp3,aac,mov,mp4,m4a,matroska,webm,avi,gif,ac3,amr,wv";

using SteadyClock = std::chrono::steady_clock;

std::int64_t to_ms(SteadyClock::duration d) {
  return std::max<std::int64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(d).count(), 1);
}

// The last line of what it said, without the path in the program's own form.
std::string reason_in(std::string said, const std::string& path) {
  while (!said.empty() && std::isspace(static_cast<unsigned char>(said.back()))) said.pop_back();
  said = said.substr(said.rfind('\n') + 1);
  for (std::size_t at; (at = said.find("file:" + path)) != std::string::npos;) said.replace(at, path.size() + 5, path);
  if (said.starts_with(path + ": ")) said.erase(0, path.size() + 2);
  return said;
}

}  // namespace

std::vector<std::string> arguments_for_reading(const std::string& path) {
  return {"-protocol_whitelist", "file,pipe", "-format_whitelist", kinds_of_files, "-i", "file:" + path};
}

JailedReader::~JailedReader() {
  if (pid_ > 0) ::kill(pid_, SIGKILL), wait_for_child(pid_);
  for (const int file : {out_, err_})
    if (file >= 0) ::close(file);
}

Status JailedReader::start(const std::string& program, const std::vector<std::string>& arguments,
                           const std::string& path, const ParserCeilings& most, const std::string& what) {
  path_ = path, most_ = most;
  const std::string found = find_program(program);
  if (found.empty())
    return fail(ErrorCode::machine, fmt::format("{} need the program {}, which is not installed", what, program),
                "sudo apt-get install ffmpeg");
  std::array<int, 2> out{-1, -1}, err{-1, -1};
  if (::pipe2(out.data(), O_CLOEXEC) != 0) return system_error(errno, "read", path);
  out_ = out[0];
  const OpenFile its_out(out[1]);
  if (::pipe2(err.data(), O_CLOEXEC) != 0) return system_error(errno, "read", path);
  err_ = err[0];
  const OpenFile its_err(err[1]);
  const std::string jail = find_parser();
  std::vector<std::string> words;
  if (!jail.empty())
    words = {jail, parser_version, parser_runs, std::to_string(most.memory), std::to_string(most.seconds), path};
  words.push_back(found);
  words.insert(words.end(), arguments.begin(), arguments.end());
  if (const int failed = start_child(pid_, words, {-1, its_out.fd(), its_err.fd()}))
    return system_error(failed, ("start " + program + " for").c_str(), path);
  if (jail.empty()) limit();
  return Nothing{};
}

// Sets the limits that work without betwixt-parser.
void JailedReader::limit() const {
  const rlimit memory{most_.memory, most_.memory}, work{most_.seconds, most_.seconds};
  ::prlimit(pid_, RLIMIT_AS, &memory, nullptr);
  ::prlimit(pid_, RLIMIT_CPU, &work, nullptr);
}

std::size_t JailedReader::read(std::span<char> into) {
  for (;;) {
    std::array<pollfd, 2> both{pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
    const auto begun = SteadyClock::now();
    const auto left = std::chrono::seconds(most_.wall) - waited_;
    const int ready = ::poll(both.data(), both.size(), static_cast<int>(to_ms(left)));
    waited_ += SteadyClock::now() - begun;
    if (ready == 0) return ::kill(pid_, SIGKILL), 0;
    if (both[1].revents) listen();
    if (!both[0].revents) continue;
    const ssize_t n = ::read(out_, into.data(), into.size());
    if (n < 0 && errno == EINTR) continue;
    return n > 0 ? static_cast<std::size_t>(n) : 0;
  }
}

bool JailedReader::listen() {
  if (err_ < 0) return false;
  std::array<char, 1024> words;
  const ssize_t n = ::read(err_, words.data(), words.size());
  if (n < 0 && errno == EINTR) return true;
  if (n <= 0) return ::close(std::exchange(err_, -1)), false;
  if (said_.size() < most_said_) said_.append(words.data(), static_cast<std::size_t>(n));
  return true;
}

Status JailedReader::finish(const std::function<Error(const std::string&)>& explain) {
  while (listen()) {
  }
  const int status = wait_for_child(std::exchange(pid_, -1));
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
    return fail(ErrorCode::file, fmt::format("reading {} takes more than {} s", path_, most_.seconds));
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  if (code == parser_of_another_version)
    return fail(ErrorCode::machine, "the program betwixt-parser has another version than this program");
  if (code == parser_started_nothing) return fail(ErrorCode::machine, said_.substr(0, said_.find('\n')));
  return code == 0 ? Status(Nothing{}) : Status(explain(reason_in(said_, path_)));
}

Result<std::uint64_t> size_of_file(const std::string& path) {
  const auto there = open_whole(path);
  if (!there) return there.error();
  struct stat about {};
  if (::fstat(there->fd(), &about) != 0) return system_error(errno, "read", path);
  return static_cast<std::uint64_t>(about.st_size);
}

}  // namespace betwixt
