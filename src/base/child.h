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

// File descriptors for the child's standard input, output and error; -1: /dev/null.
struct ChildFiles {
  int in = -1, out = -1, err = -1;
};

// Starts a program. Arguments are passed one by one, without a shell. The child has a process group of its own, so a
// Ctrl-C in the terminal goes to this program, which then ends the child. Returns 0, or the errno.
int start_child(pid_t& pid, const std::vector<std::string>& arguments, ChildFiles);
// Returns the path of a program that is found in $PATH, or "".
std::string find_program(const std::string& name);
// Waits for the end of a child. Returns its status as waitpid does.
int wait_for_child(pid_t);
// Like wait_for_child(pid), with a time limit: then kills the child and all that it has started, and returns nullopt.
std::optional<int> wait_for_child(pid_t, std::chrono::milliseconds most);

}  // namespace betwixt
