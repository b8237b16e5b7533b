// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/encoder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "base/child.h"

namespace betwixt {
namespace {

constexpr int beat = 50;              // milliseconds between two calls of KeepGoing
constexpr std::size_t memory = 4096;  // bytes of the program's messages that are kept
constexpr int buffer = 1 << 20;       // bytes on the way to the program

void shut(int& fd) {
  if (fd >= 0) ::close(fd);
  fd = -1;
}

// Returns the last three lines, joined.
std::string last_words(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  std::size_t from = text.size();
  for (int lines = 0; lines < 3 && from != std::string::npos && from > 0; ++lines) from = text.rfind('\n', from - 1);
  text = from == std::string::npos ? text : text.substr(from == 0 ? 0 : from + 1);
  for (std::size_t at; (at = text.find('\n')) != std::string::npos;) text.replace(at, 1, "; ");
  return text;
}

// Returns true if the messages report a file that could not be written.
bool names_failure(const std::string& said) {
  for (const int reason : {ENOSPC, EIO, EDQUOT, EFBIG})
    if (said.find(std::strerror(reason)) != std::string::npos) return true;
  return false;
}

}  // namespace

Error stopped() { return fail(ErrorCode::machine, "the film was stopped"); }

Result<std::unique_ptr<Encoder>> Encoder::start(const std::vector<std::string>& arguments) {
  // A socket in place of a pipe: a write to one whose reader has died is an error, not a signal to the whole process.
  std::array<int, 2> in{-1, -1}, err{-1, -1};
  const auto give_up = [&](int why) {
    for (int* fd : {&in[0], &in[1], &err[0], &err[1]}) shut(*fd);
    if (why == ENOENT)
      return fail(ErrorCode::machine, arguments[0] + " is not installed", "sudo apt-get install " + arguments[0]);
    return fail(ErrorCode::machine, fmt::format("cannot start {}: {}", arguments[0], std::strerror(why)));
  };
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in.data()) != 0) return give_up(errno);
  if (::pipe2(err.data(), O_CLOEXEC) != 0) return give_up(errno);
  ::setsockopt(in[0], SOL_SOCKET, SO_SNDBUF, &buffer, sizeof buffer);
  ::fcntl(err[0], F_SETFL, O_NONBLOCK);
  pid_t pid = -1;
  if (const int failed = start_child(pid, arguments, {in[1], -1, err[1]})) return give_up(failed);
  shut(in[1]);
  shut(err[1]);
  return std::unique_ptr<Encoder>(new Encoder(pid, in[0], err[0]));
}

Encoder::~Encoder() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    wait_for_child(pid_);
  }
  shut(in_);
  shut(err_);
}

bool Encoder::listen() {
  std::array<char, 1024> words;
  for (;;) {
    const ssize_t n = ::read(err_, words.data(), words.size());
    if (n < 0) return errno == EAGAIN || errno == EINTR;
    if (n == 0) return false;
    said_.append(words.data(), static_cast<std::size_t>(n));
    if (said_.size() > memory) said_.erase(0, said_.size() - memory);
  }
}

Status Encoder::write(const std::vector<std::uint8_t>& bytes, const KeepGoing& keep_going) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const ssize_t n = ::send(in_, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n >= 0) {
      at += static_cast<std::size_t>(n);
      continue;
    }
    if (errno == EINTR) continue;
    if (errno != EAGAIN) {  // it has closed its input: read why
      Status how = end(keep_going);
      return how ? Status(fail(ErrorCode::machine, "ffmpeg stopped before the end of the film")) : how;
    }
    std::array<pollfd, 2> both{pollfd{in_, POLLOUT, 0}, pollfd{err_, POLLIN, 0}};
    ::poll(both.data(), both.size(), beat);
    // If standard error is closed, poll returns at once, again and again; but then standard input is closed as well.
    if (both[1].revents) listen();
    if (!keep_going()) return stopped();
  }
  return Nothing{};
}

Status Encoder::finish(const KeepGoing& keep_going) { return end(keep_going); }

Status Encoder::end(const KeepGoing& keep_going) {
  shut(in_);
  for (bool open = true; open;) {
    pollfd mouth{err_, POLLIN, 0};
    ::poll(&mouth, 1, beat);
    if (mouth.revents) open = listen();
    if (!keep_going()) return stopped();
  }
  const int status = wait_for_child(pid_);
  pid_ = -1;
  // If closing its file fails, ffmpeg prints that and ends as if it had succeeded.
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && !names_failure(said_)) return Nothing{};
  return complaint(status);
}

Error Encoder::wrote_nothing() const {
  const std::string words = last_words(said_);
  return fail(ErrorCode::machine, fmt::format("ffmpeg wrote nothing: {}", words.empty() ? "it gave no reason" : words));
}

Error Encoder::complaint(int status) const {
  const std::string words = last_words(said_);
  if (said_.find(std::strerror(ENOSPC)) != std::string::npos)
    return fail(ErrorCode::machine, "the disk is full (ffmpeg said: " + words + ")");
  if (WIFSIGNALED(status))
    return fail(
        ErrorCode::machine,
        fmt::format("another program ended ffmpeg by signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status))),
        words);
  return fail(ErrorCode::machine, fmt::format("ffmpeg failed: {}", words.empty() ? "it gave no reason" : words));
}

}  // namespace betwixt
