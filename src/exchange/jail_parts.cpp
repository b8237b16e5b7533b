// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/jail_parts.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace betwixt {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t this_machine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t this_machine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t this_machine = 0;
#endif
constexpr std::uint32_t other_numbering = 0x40000000;  // x32 calls on x86-64

constexpr auto head = BPF_LD | BPF_W | BPF_ABS, compare = BPF_JMP | BPF_JEQ | BPF_K, answer = BPF_RET | BPF_K;
constexpr std::size_t first_argument = offsetof(seccomp_data, args);  // its lower half on a little-endian machine
constexpr std::size_t second_argument = first_argument + sizeof(std::uint64_t);

}  // namespace

void set_ceiling(int what, std::uint64_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<__rlimit_resource>(what), &both);
}

#ifdef SYS_landlock_create_ruleset
namespace {
constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_EXECUTE;
constexpr std::uint64_t changing = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                   LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                   LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
                                   LANDLOCK_ACCESS_FS_REMOVE_DIR;
}  // namespace

Folders::Folders() {
  landlock_ruleset_attr all{};
  all.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // all rights of Landlock's first version
  rules_ = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, sizeof all, 0));
}
Folders::~Folders() {
  if (rules_ >= 0) ::close(rules_);
}
void Folders::allow(const std::string& path, std::uint64_t for_files, std::uint64_t for_folders) const {
  const int there = rules_ < 0 ? -1 : ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (there < 0) return;
  struct stat about {};
  const bool folder = ::fstat(there, &about) == 0 && S_ISDIR(about.st_mode);
  landlock_path_beneath_attr rule{};
  rule.allowed_access = folder ? for_folders : for_files;
  rule.parent_fd = there;
  ::syscall(SYS_landlock_add_rule, rules_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  ::close(there);
}
void Folders::may_read(const std::string& path) const { allow(path, reading, reading | LANDLOCK_ACCESS_FS_READ_DIR); }
void Folders::may_change(const std::string& folder) const { allow(folder, 0, changing); }
void Folders::close_others() const {
  if (rules_ >= 0) ::syscall(SYS_landlock_restrict_self, rules_, 0);
}
#else
Folders::Folders() = default;
Folders::~Folders() = default;
void Folders::may_read(const std::string&) const {}
void Folders::may_change(const std::string&) const {}
void Folders::close_others() const {}
#endif

CallFilter::CallFilter() {
  add(head, offsetof(seccomp_data, arch));
  add(compare, this_machine, 1, 0);
  add(answer, SECCOMP_RET_KILL_PROCESS);
  add(head, offsetof(seccomp_data, nr));
  add(BPF_JMP | BPF_JGE | BPF_K, other_numbering, 0, 1);
  add(answer, SECCOMP_RET_ERRNO | EPERM);
}
CallFilter::~CallFilter() = default;

void CallFilter::add(int code, std::uint32_t k, int yes, int no) {
  program_.push_back(
      {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(yes), static_cast<std::uint8_t>(no), k});
}
void CallFilter::allow(std::span<const int> calls) {
  for (const int call : calls) {
    add(compare, static_cast<std::uint32_t>(call), 0, 1);
    add(answer, SECCOMP_RET_ALLOW);
  }
}
void CallFilter::refuse(std::span<const int> calls, int error) {
  for (const int call : calls) {
    add(compare, static_cast<std::uint32_t>(call), 0, 1);
    add(answer, SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error));
  }
}
void CallFilter::allow_if_second_is(int call, std::uint32_t number) {
  add(compare, static_cast<std::uint32_t>(call), 0, 4);
  add(head, second_argument);
  add(compare, number, 0, 1);
  add(answer, SECCOMP_RET_ALLOW);
  add(answer, SECCOMP_RET_ERRNO | EPERM);
}
void CallFilter::refuse_unless_first_is(int call, std::uint32_t number) {
  add(compare, static_cast<std::uint32_t>(call), 0, 4);
  add(head, first_argument);
  add(compare, number, 1, 0);
  add(answer, SECCOMP_RET_ERRNO | EPERM);
  add(answer, SECCOMP_RET_ALLOW);
}
void CallFilter::refuse_without_bit(int call, std::uint32_t bit) {
  add(compare, static_cast<std::uint32_t>(call), 0, 4);
  add(head, first_argument);
  add(BPF_JMP | BPF_JSET | BPF_K, bit, 1, 0);
  add(answer, SECCOMP_RET_ERRNO | EPERM);
  add(answer, SECCOMP_RET_ALLOW);
}
void CallFilter::begin(bool others_allowed) {
  if (this_machine == 0) return;
  add(answer, others_allowed ? SECCOMP_RET_ALLOW : SECCOMP_RET_ERRNO | EPERM);
  const sock_fprog all{static_cast<unsigned short>(program_.size()), program_.data()};
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all);
}

}  // namespace betwixt
