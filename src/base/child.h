// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Other programs that run beside this one.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace betwixt {

// What become its standard input, output and error; -1: nothing.
struct ChildFiles {
  int in = -1, out = -1, err = -1;
};

// Arguments are handed over one by one; no shell reads them. It is in a process group of its own: a Ctrl-C of the
// terminal is for us, who then end it. The system's reason, or 0.
int start_child(pid_t& pid, const std::vector<std::string>& arguments, ChildFiles);
// Where a program of that name lies in the folders of $PATH; empty if nowhere.
std::string find_program(const std::string& name);
// Waits for its end: its status, as of waitpid.
int wait_for_child(pid_t);
// The same; after so long it is ended, and there is no status. What it began and left behind ends with it.
std::optional<int> wait_for_child(pid_t, std::chrono::milliseconds most);

}  // namespace betwixt
