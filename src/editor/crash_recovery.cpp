// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/crash_recovery.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "base/files.h"
#include "editor/journal.h"

namespace betwixt {
namespace {

// The copy has only this thread: it would wait forever for a lock that another thread holds.
bool one_thread() {
  std::error_code none;
  const std::filesystem::directory_iterator all("/proc/self/task", none);
  return !none && std::distance(begin(all), end(all)) == 1;
}

// The copy prints nothing, holds no lock of ours, leaves no core dump, and ends with its parent.
[[noreturn]] void work_in_copy(const std::function<void()>& work, pid_t parent) noexcept {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);
  ::close_range(3, ~0U, 0);
  for (const int f : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, f), ::close(nothing);
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  for (const int s : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) ::signal(s, SIG_DFL);
  work();
  ::_exit(0);
}

}  // namespace

std::optional<std::string> dies_of(const std::function<void()>& work) {
  if (!one_thread()) return std::nullopt;
  const pid_t parent = ::getpid(), copy = ::fork();
  if (copy < 0) return std::nullopt;
  if (copy == 0) work_in_copy(work, parent);
  int how = 0;
  while (::waitpid(copy, &how, 0) < 0)
    if (errno != EINTR) return std::nullopt;
  if (WIFSIGNALED(how)) return fmt::format("signal {}", WTERMSIG(how));
  if (WEXITSTATUS(how) != 0) return fmt::format("exit code {}", WEXITSTATUS(how));
  return std::nullopt;
}

std::optional<Culprit> find_culprit(std::size_t commands, const std::function<void(std::size_t)>& carry_out) {
  const auto dies = [&](std::size_t n) { return dies_of([&] { carry_out(n); }); };
  auto how = dies(commands);
  if (!how || dies(0)) return std::nullopt;
  std::size_t lives = 0, ends = commands;
  while (ends - lives > 1) {
    const std::size_t half = lives + (ends - lives) / 2;
    if (auto then = dies(half))
      ends = half, how = std::move(then);
    else
      lives = half;
  }
  return Culprit{lives, *how};
}

StartMark::StartMark(const std::string& script) : path_(journal_path(script)) {
  path_.replace(path_.rfind(".journal"), std::string::npos, ".starting");
  found_ = ::access(path_.c_str(), F_OK) == 0;
  const OpenFile made(::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
}

StartMark::~StartMark() { ::unlink(path_.c_str()); }

}  // namespace betwixt
