// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/parser_jail.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string_view>

#include "exchange/jail_parts.h"

namespace betwixt {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool watched = true;  // sanitizers reserve terabytes of addresses
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool watched = true;
#else
constexpr bool watched = false;
#endif
#else
constexpr bool watched = false;
#endif

// Kills the process at the end of its time, by a signal that it cannot block.
void end_after(std::uint64_t seconds) {
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGKILL;
  timer_t timer{};
  itimerspec when{};
  when.it_value.tv_sec = static_cast<time_t>(seconds);
  if (::timer_create(CLOCK_MONOTONIC, &event, &timer) == 0) ::timer_settime(timer, 0, &when, nullptr);
}

// Memory, time, and open files.
constexpr int allowed_calls[] = {
    SYS_read,          SYS_write,        SYS_readv,        SYS_writev,          SYS_pread64,      SYS_pwrite64,
    SYS_lseek,         SYS_close,        SYS_fstat,        SYS_ftruncate,       SYS_sendmsg,      SYS_recvmsg,
    SYS_mmap,          SYS_munmap,       SYS_mremap,       SYS_mprotect,        SYS_madvise,      SYS_brk,
    SYS_futex,         SYS_sched_yield,  SYS_rt_sigaction, SYS_rt_sigprocmask,  SYS_rt_sigreturn, SYS_sigaltstack,
    SYS_clock_gettime, SYS_gettimeofday, SYS_nanosleep,    SYS_clock_nanosleep, SYS_getrandom,    SYS_getpid,
    SYS_gettid,        SYS_exit,         SYS_exit_group,   SYS_restart_syscall};

// Calls that a reader of one file does not need: the network, other processes, the machine's settings, and changes to
// files that Landlock does not cover.
constexpr int refused_calls[] = {
    SYS_socket,
    SYS_socketpair,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_kill,
    SYS_tkill,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_chroot,
    SYS_unshare,
    SYS_setns,
    SYS_bpf,
    SYS_perf_event_open,
    SYS_userfaultfd,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_reboot,
    SYS_swapon,
    SYS_swapoff,
    SYS_acct,
    SYS_quotactl,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_clock_adjtime,
    SYS_adjtimex,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_personality,
    SYS_fanotify_init,
    SYS_open_by_handle_at,
    SYS_setpriority,
    SYS_ioprio_set,
    SYS_shmget,
    SYS_shmat,
    SYS_shmctl,
    SYS_msgget,
    SYS_msgsnd,
    SYS_msgctl,
    SYS_semget,
    SYS_semctl,
    SYS_mq_open,
    SYS_truncate,
    SYS_fchmod,
    SYS_fchmodat,
    SYS_fchown,
    SYS_fchownat,
    SYS_setxattr,
    SYS_lsetxattr,
    SYS_fsetxattr,
    SYS_removexattr,
    SYS_lremovexattr,
    SYS_fremovexattr,
    SYS_utimensat,
#ifdef SYS_fork  // old calls of x86-64
    SYS_fork,
    SYS_vfork,
    SYS_chmod,
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
    SYS_futimesat,
#endif
#ifdef SYS_io_uring_setup
    SYS_io_uring_setup,
    SYS_io_uring_enter,
    SYS_io_uring_register,
#endif
#ifdef SYS_pidfd_open
    SYS_pidfd_open,
    SYS_pidfd_send_signal,
#endif
#ifdef SYS_pidfd_getfd
    SYS_pidfd_getfd,
    SYS_process_madvise,
#endif
#ifdef SYS_open_tree
    SYS_open_tree,
    SYS_move_mount,
    SYS_fsopen,
    SYS_fsconfig,
    SYS_fsmount,
    SYS_fspick,
#endif
#ifdef SYS_mount_setattr
    SYS_mount_setattr,
#endif
};

// The folders of programs and libraries, and the files that the loader and the C library read.
constexpr const char* of_all_programs[] = {"/usr",
                                           "/bin",
                                           "/lib",
                                           "/lib32",
                                           "/lib64",
                                           "/opt",
                                           "/nix/store",
                                           "/gnu/store",
                                           "/etc/ld.so.cache",
                                           "/etc/ld.so.preload",
                                           "/dev/null",
                                           "/dev/urandom",
                                           "/sys/devices/system/cpu"};

// Allows the program itself and its libraries, which may be beside its folder or where the environment points.
void may_run(const Folders& folders, const std::string& program) {
  std::error_code ignored;
  const auto itself = std::filesystem::canonical(program, ignored);
  folders.may_read(itself);
  if (const auto folder = itself.parent_path(); folder.filename() == "bin")
    folders.may_read(folder.parent_path() / "lib");
  const char* path = std::getenv("LD_LIBRARY_PATH");
  for (std::string_view rest = path ? path : ""; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (end > 0) folders.may_read(std::string(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

// The settings and formats of TeX that are not below /usr.
constexpr const char* of_tex[] = {"/etc/texmf", "/var/lib/texmf"};

// Allows the trees of TeX. A TeX Live outside the system's folders has them above the folder of its programs.
void may_read_tex(const Folders& folders, const std::string& program) {
  for (const char* path : of_tex) folders.may_read(path);
  std::error_code ignored;
  for (auto up = std::filesystem::canonical(program, ignored).parent_path(); up != up.root_path();
       up = up.parent_path())
    if (std::filesystem::exists(up / "texmf-dist", ignored))
      for (const char* tree : {"texmf.cnf", "texmf-dist", "texmf-var", "texmf-config", "../texmf-local"})
        folders.may_read(up / tree);
}

bool give_up_rights() {
  ::prctl(PR_SET_DUMPABLE, 0);
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

// Leaves the rights that another author's program needs. `more` allows further files.
void give_up_for_program(const std::string& program, const ParserCeilings& most, std::uint64_t largest_file,
                         const std::function<void(const Folders&)>& more) {
  set_ceiling(RLIMIT_CORE, 0);
  set_ceiling(RLIMIT_CPU, most.seconds);
  set_ceiling(RLIMIT_FSIZE, largest_file);  // does not affect pipes
  set_ceiling(RLIMIT_NOFILE, 64);
  if (!give_up_rights()) return;
  {
    const Folders folders;
    for (const char* path : of_all_programs) folders.may_read(path);
    may_run(folders, program);
    more(folders);
    folders.close_others();
  }
  CallFilter calls;
  calls.refuse(refused_calls, EPERM);
  calls.refuse_unless_first_is(SYS_tgkill, static_cast<std::uint32_t>(::getpid()));
  calls.refuse_unless_first_is(SYS_prlimit64, 0);
  calls.refuse_without_bit(SYS_clone, CLONE_THREAD);
#ifdef SYS_clone3
  constexpr int in_memory[] = {SYS_clone3};  // its flags cannot be inspected; the C library then uses clone
  calls.refuse(in_memory, ENOSYS);
#endif
  calls.begin(true);
  set_ceiling(RLIMIT_AS, most.memory);  // last, because this process may use more than the program after exec
}

}  // namespace

void give_up_all_but_reading(const ParserCeilings& most) {
  ::signal(SIGXFSZ, SIG_IGN);
  end_after(most.wall);
  set_ceiling(RLIMIT_CORE, 0);
  set_ceiling(RLIMIT_CPU, most.seconds);
  if (!watched) set_ceiling(RLIMIT_AS, most.memory);
  set_ceiling(RLIMIT_FSIZE, most.memory);  // the result; the process can write to nothing else
  set_ceiling(RLIMIT_NOFILE, 64);
  set_ceiling(RLIMIT_NPROC, 0);
  if (!give_up_rights()) return;
  Folders().close_others();  // without a rule nothing can be opened
  CallFilter calls;
  calls.allow(allowed_calls);
  calls.allow_if_second_is(SYS_fcntl, F_GETFL);  // fdopen() asks how a file is open
  calls.begin(false);
}

void give_up_all_but_one_file(const std::string& file, const std::string& program, const ParserCeilings& most) {
  give_up_for_program(program, most, 0, [&](const Folders& folders) { folders.may_read(file); });
}

void give_up_all_but_one_folder(const std::string& folder, const std::string& program, const ParserCeilings& most) {
  constexpr std::uint64_t largest_file = std::uint64_t{64} << 20;
  give_up_for_program(program, most, largest_file, [&](const Folders& folders) {
    may_read_tex(folders, program);
    folders.may_change(folder);
  });
}

}  // namespace betwixt
