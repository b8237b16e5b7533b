// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Starts other programs (child processes) and waits for them.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace betwixt {

// The files that become its standard input, output and error; -1: none.
struct ChildFiles {
  int in = -1, out = -1, err = -1;
};

// Starts a program. Arguments are passed one by one, without a shell. The child has a process group of its own, so a
// Ctrl-C in the terminal goes to this program, which then ends the child. Returns 0, or the errno.
int start_child(pid_t& pid, const std::vector<std::string>& arguments, ChildFiles);
// Where a program of that name lies in the folders of $PATH; empty if nowhere.
std::string find_program(const std::string& name);
// Waits for its end: its status, as of waitpid.
int wait_for_child(pid_t);
// The same with a limit: after it, kills the child and whatever it has started, and returns std::nullopt.
std::optional<int> wait_for_child(pid_t, std::chrono::milliseconds most);

}  // namespace betwixt
