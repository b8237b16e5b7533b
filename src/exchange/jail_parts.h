// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a jail: the system's resource limits, Landlock's rules for files, and seccomp's filter of system calls.
// Each has no effect if the kernel lacks it.
#pragma once

#include <sys/resource.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

struct sock_filter;

namespace betwixt {

// Sets both the soft and the hard limit. `what`: RLIMIT_… of the system's header.
void set_ceiling(int what, std::uint64_t most);

// The files that may be opened afterwards. All others are closed off.
class Folders {
 public:
  Folders();
  ~Folders();
  Folders(const Folders&) = delete;
  Folders& operator=(const Folders&) = delete;
  // Both ignore a missing path. may_read(): allows reading and running a file, or a folder and everything below it.
  void may_read(const std::string& path) const;
  // Allows reading, writing, making and removing files and folders below a folder.
  void may_change(const std::string& folder) const;
  // Applies the rules to this process, and to all that it starts.
  void close_others() const;

 private:
  void allow(const std::string& path, std::uint64_t for_files, std::uint64_t for_folders) const;
  int rules_ = -1;
};

// A seccomp program that checks each system call. Refused calls fail with an error.
class CallFilter {
 public:
  CallFilter();
  ~CallFilter();
  CallFilter(const CallFilter&) = delete;
  CallFilter& operator=(const CallFilter&) = delete;
  void allow(std::span<const int> calls);
  void refuse(std::span<const int> calls, int error);
  // Allows the call if its second argument is this number; otherwise refuses it.
  void allow_if_second_is(int call, std::uint32_t number);
  // Refuses the call unless its first argument is this number.
  void refuse_unless_first_is(int call, std::uint32_t number);
  // Refuses the call unless its first argument has this bit.
  void refuse_without_bit(int call, std::uint32_t bit);
  // Applies the filter to this process, and to all that it starts. `others_allowed` decides about all other calls.
  void begin(bool others_allowed);

 private:
  void add(int code, std::uint32_t k, int yes = 0, int no = 0);
  std::vector<sock_filter> program_;
};

}  // namespace betwixt
