// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/child.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "base/files.h"

extern char** environ;

namespace betwixt {

int start_child(pid_t& pid, const std::vector<std::string>& arguments, ChildFiles files) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t ways;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&ways);
  const int ours[] = {files.in, files.out, files.err};
  for (int i = 0; i < 3; ++i)
    if (ours[i] >= 0)
      posix_spawn_file_actions_adddup2(&actions, ours[i], i);
    else
      posix_spawn_file_actions_addopen(&actions, i, "/dev/null", i == 0 ? O_RDONLY : O_WRONLY, 0);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&ways, &none);
  posix_spawnattr_setsigdefault(&ways, &all);
  posix_spawnattr_setpgroup(&ways, 0);
  posix_spawnattr_setflags(&ways, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::vector<char*> words;
  for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
  words.push_back(nullptr);
  const int failed = posix_spawnp(&pid, words[0], &actions, &ways, words.data(), environ);
  posix_spawnattr_destroy(&ways);
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  for (std::string_view rest = path ? path : "/bin:/usr/bin"; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (std::string there = std::string(rest.substr(0, end)) + "/" + name; end > 0 && can_be_run(there)) return there;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return {};
}

int wait_for_child(pid_t pid) {
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::optional<int> wait_for_child(pid_t pid, std::chrono::milliseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  bool over = false;
  while (!over && std::chrono::steady_clock::now() < end) {
    siginfo_t how{};
    over = ::waitid(P_PID, static_cast<id_t>(pid), &how, WEXITED | WNOHANG | WNOWAIT) != 0 || how.si_pid == pid;
    if (!over) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ::kill(-pid, SIGKILL);  // before wait, no other process can get its number
  const int status = wait_for_child(pid);
  return over ? std::optional(status) : std::nullopt;
}

}  // namespace betwixt
