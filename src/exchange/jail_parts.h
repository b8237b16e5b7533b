// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What jails are built of: ceilings of the system, Landlock's rules for files, and the kernel's filter of calls. Where
// the kernel lacks one of them, it does nothing.
#pragma once

#include <sys/resource.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

struct sock_filter;

namespace betwixt {

// Both the soft and the hard one. It uses the number that the system's header has for it (RLIMIT_…).
void set_ceiling(int what, std::uint64_t most);

// Files that may be opened afterwards; all others may not.
class Folders {
 public:
  Folders();
  ~Folders();
  Folders(const Folders&) = delete;
  Folders& operator=(const Folders&) = delete;
  // A file, or a folder and all below it, may be read and run. A path that does not exist is skipped.
  void may_read(const std::string& path) const;
  // From now on, for this process and all that it starts.
  void close_others() const;

 private:
  int rules_ = -1;
};

// A program of the kernel's that looks at each call of the system. Refused calls fail with an error.
class CallFilter {
 public:
  CallFilter();
  ~CallFilter();
  CallFilter(const CallFilter&) = delete;
  CallFilter& operator=(const CallFilter&) = delete;
  void allow(std::span<const int> calls);
  void refuse(std::span<const int> calls, int error);
  // The call if its first argument is another number.
  void refuse_unless_first_is(int call, std::uint32_t number);
  // The call if its first argument lacks this bit.
  void refuse_without_bit(int call, std::uint32_t bit);
  // From now on, for this process and all that it starts. Calls without a rule are allowed or refused.
  void begin(bool others_allowed);

 private:
  void add(int code, std::uint32_t k, int yes = 0, int no = 0);
  std::vector<sock_filter> program_;
};

}  // namespace betwixt
