// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/parser_jail.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <vector>

namespace betwixt {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool watched = true;  // takes terabytes of addresses
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool watched = true;
#else
constexpr bool watched = false;
#endif
#else
constexpr bool watched = false;
#endif

void limit(__rlimit_resource what, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(what, &both);
}

// The end of all its time comes as a signal that nobody can put off.
void end_after(std::uint64_t seconds) {
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGKILL;
  timer_t timer{};
  itimerspec when{};
  when.it_value.tv_sec = static_cast<time_t>(seconds);
  if (::timer_create(CLOCK_MONOTONIC, &event, &timer) == 0) ::timer_settime(timer, 0, &when, nullptr);
}

void lock_folders() {
#ifdef SYS_landlock_create_ruleset
  landlock_ruleset_attr all{};
  all.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // whatever the first version knows
  const auto rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, sizeof all, 0));
  if (rules < 0) return;
  ::syscall(SYS_landlock_restrict_self, rules, 0);  // no rule: nothing may be opened
  ::close(rules);
#endif
}

#if defined(__x86_64__)
constexpr std::uint32_t machine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t machine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t machine = 0;
#endif

// Memory, time, and what is open already.
constexpr int allowed_calls[] = {
    SYS_read,          SYS_write,        SYS_readv,        SYS_writev,          SYS_pread64,      SYS_pwrite64,
    SYS_lseek,         SYS_close,        SYS_fstat,        SYS_ftruncate,       SYS_sendmsg,      SYS_recvmsg,
    SYS_mmap,          SYS_munmap,       SYS_mremap,       SYS_mprotect,        SYS_madvise,      SYS_brk,
    SYS_futex,         SYS_sched_yield,  SYS_rt_sigaction, SYS_rt_sigprocmask,  SYS_rt_sigreturn, SYS_sigaltstack,
    SYS_clock_gettime, SYS_gettimeofday, SYS_nanosleep,    SYS_clock_nanosleep, SYS_getrandom,    SYS_getpid,
    SYS_gettid,        SYS_exit,         SYS_exit_group,   SYS_restart_syscall};

void filter_calls() {
  if (machine == 0) return;
  std::vector<sock_filter> program;
  const auto add = [&](int code, std::uint32_t k, int yes = 0, int no = 0) {
    program.push_back(
        {static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(yes), static_cast<std::uint8_t>(no), k});
  };
  add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch));
  add(BPF_JMP | BPF_JEQ | BPF_K, machine, 1, 0);
  add(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
  add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr));
  for (const int call : allowed_calls) {
    add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1);
    add(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  }
  add(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
  const sock_fprog all{static_cast<unsigned short>(program.size()), program.data()};
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all);
}

}  // namespace

void give_up_all_but_reading(const ParserCeilings& most) {
  ::signal(SIGXFSZ, SIG_IGN);
  end_after(most.wall);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, most.seconds);
  if (!watched) limit(RLIMIT_AS, most.memory);
  limit(RLIMIT_FSIZE, most.memory);  // what is handed over; there is nothing else to write to
  limit(RLIMIT_NOFILE, 64);
  limit(RLIMIT_NPROC, 0);
  ::prctl(PR_SET_DUMPABLE, 0);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
  lock_folders();
  filter_calls();
}

}  // namespace betwixt
