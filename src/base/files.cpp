// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "base/names.h"

namespace betwixt {
namespace {

Error cannot(const char* what, const std::string& path, int reason) {
  std::string words = std::generic_category().message(reason);
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  const bool machine = reason == ENOSPC || reason == EDQUOT || reason == EIO || reason == EMFILE || reason == ENFILE;
  return fail(machine ? ErrorCode::machine : ErrorCode::file, fmt::format("cannot {} {}: {}", what, path, words));
}

Error a_folder(const std::string& path) {
  return fail(ErrorCode::file, fmt::format("{} is a folder, not a file", path));
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

// The rights of a new file; `exactly`: regardless of the process's umask.
struct Rights {
  mode_t bits = 0666;
  bool exactly = false;
};

// Makes the file completely or not at all.
int make(const std::string& path, std::string_view bytes, Rights rights, bool on_disk) {
  OpenFile file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, rights.bits));
  if (!file) return errno;
  int reason = rights.exactly && ::fchmod(file.fd(), rights.bits) != 0 ? errno : 0;
  if (reason == 0) reason = write_all(file.fd(), bytes);
  if (reason == 0 && on_disk && ::fsync(file.fd()) != 0) reason = errno;
  if (reason == 0) reason = file.close();
  if (reason != 0) ::unlink(path.c_str());
  return reason;
}

int move_to(const std::string& from, const std::string& to, bool overwrite) {
  const auto done = [](int result) { return result == 0 ? 0 : errno; };
  if (!overwrite) {
    int reason = ENOSYS;
#ifdef RENAME_NOREPLACE
    reason = done(::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE));
    if (reason != EINVAL && reason != ENOSYS) return reason;
#endif
    // Some file systems cannot guarantee it. A link also fails if a file has appeared under the name in between.
    reason = done(::link(from.c_str(), to.c_str()));
    if (reason == 0) return ::unlink(from.c_str()), 0;
    if (reason == EEXIST) return reason;
  }
  return done(::rename(from.c_str(), to.c_str()));
}

// Opens a file. Sets `out` to the obstacle if there is one, and to the size of a regular file.
OpenFile open_within(const std::string& path, const ReadingLimits& limits, FileContents& out) {
  const auto hindered = [&](ReadProblem what, int reason = 0) {
    out.problem = what, out.reason = reason;
    return OpenFile(-1);
  };
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return hindered(ReadProblem::missing, errno);
  if (S_ISDIR(about.st_mode)) return hindered(ReadProblem::folder);
  const bool plain = S_ISREG(about.st_mode);
  if (!plain && !limits.special) return hindered(ReadProblem::special);
  // If it has become a pipe in between, a pipe without a writer must not block.
  OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | (plain ? O_NONBLOCK : 0)));
  if (!file) return hindered(ReadProblem::system, errno);
  out.size = plain ? static_cast<std::uint64_t>(about.st_size) : 0;
  if (out.size > limits.largest) return hindered(ReadProblem::too_large);
  return file;
}

Error hindered(const std::string& path, const FileContents& in) {
  switch (in.problem) {
    case ReadProblem::folder:
      return a_folder(path);
    case ReadProblem::special:
      return fail(ErrorCode::file, fmt::format("{} is not a regular file", path));
    case ReadProblem::too_large:
      return fail(ErrorCode::file, fmt::format("{} is larger than 1 GiB", path));
    case ReadProblem::missing:
      if (in.reason == ENOENT) return no_file(path);
      break;
    default:
      break;
  }
  return cannot("read", path, in.reason);
}

}  // namespace

Error no_file(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr std::size_t most_looked_at = 10'000;
  const fs::path wanted(path);
  const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator i(folder, failed), end; !failed && i != end && names.size() < most_looked_at;
       i.increment(failed))
    names.push_back(i->path().filename().string());
  std::sort(names.begin(), names.end());  // the order in a folder is random
  return fail(ErrorCode::file, fmt::format("there is no file '{}'", path),
              did_you_mean(wanted.filename().string(), {names.begin(), names.end()}));
}

int OpenFile::close() {
  const int fd = std::exchange(fd_, -1);
  return fd < 0 || ::close(fd) == 0 ? 0 : errno;
}

int read_all(int file, std::string& text, std::uint64_t largest) {
  ::lseek(file, 0, SEEK_SET);  // a file without a beginning is read from its position
  char block[1 << 16];
  for (;;) {
    const ssize_t n = ::read(file, block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n == 0 ? 0 : errno;
    text.append(block, static_cast<std::size_t>(n));
    if (text.size() > largest) return EFBIG;
  }
}

int write_all(int file, std::string_view bytes, std::optional<off_t> at) {
  while (!bytes.empty()) {
    const ssize_t n = at ? ::pwrite(file, bytes.data(), bytes.size(), *at) : ::write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n < 0 ? errno : EIO;
    bytes.remove_prefix(static_cast<std::size_t>(n));
    if (at) *at += n;
  }
  return 0;
}

FileContents read_contents(const std::string& path, const ReadingLimits& limits) {
  FileContents out;
  const OpenFile file = open_within(path, limits, out);
  if (out.problem != ReadProblem::none) return out;
  out.text.reserve(out.size);
  const int reason = read_all(file.fd(), out.text, limits.largest);
  if (reason == 0) return out;
  out.size = out.text.size(), out.reason = reason;
  out.problem = reason == EFBIG ? ReadProblem::too_large : ReadProblem::system;
  return out;
}

int put_file(const std::string& path, std::string_view bytes, const WriteOptions& how) {
  std::string place = path;
  Rights rights;
  if (how.like_old) {
    std::error_code why;
    const std::filesystem::path real = std::filesystem::canonical(path, why);
    if (!why) place = real.string();
    struct stat old {};
    if (::stat(place.c_str(), &old) == 0) rights = {old.st_mode & 07777, true};
  }
  std::string part;
  int reason = EEXIST;  // a file left by an earlier process with the same number is no obstacle
  while (reason == EEXIST) reason = make(part = hidden_beside(place), bytes, rights, how.on_disk);
  if (reason != 0) return reason;
  reason = move_to(part, place, how.overwrite);
  if (reason != 0)
    ::unlink(part.c_str());
  else if (how.on_disk)
    sync_folder_of(place);
  return reason;
}

int make_file(const std::string& path, std::string_view bytes, mode_t rights) {
  const int reason = make(path, bytes, {rights, false}, true);
  if (reason == 0) sync_folder_of(path);
  return reason;
}

void sync_folder_of(const std::string& path) {
  const OpenFile folder(::open(folder_of(path).c_str(), O_RDONLY | O_CLOEXEC));
  if (folder) ::fsync(folder.fd());
}

std::string hidden_beside(const std::string& path, const std::string& tail) {
  static std::atomic<unsigned> count{0};
  const std::size_t slash = path.rfind('/');
  const std::string folder = path.substr(0, slash == std::string::npos ? 0 : slash + 1);
  const std::string name = path.substr(folder.size(), 100);  // keeps the name within the limit
  return fmt::format("{}.{}.{}-{}.partial{}", folder, name, ::getpid(), count++, tail);
}

Result<std::string> read_whole(const std::string& path) {
  FileContents in = read_contents(path);
  if (in.problem != ReadProblem::none) return hindered(path, in);
  return std::move(in.text);
}

Result<OpenFile> open_whole(const std::string& path) {
  FileContents in;
  OpenFile file = open_within(path, {}, in);
  if (in.problem != ReadProblem::none) return hindered(path, in);
  return file;
}

Status write_whole(const std::string& path, std::string_view bytes, bool overwrite) {
  struct stat about {};
  const bool there = ::stat(path.c_str(), &about) == 0;
  if (there && S_ISDIR(about.st_mode)) return a_folder(path);
  int reason = 0;
  if (there && !S_ISREG(about.st_mode)) {
    OpenFile file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    reason = file ? write_all(file.fd(), bytes) : errno;
    if (reason == 0) reason = file.close();
  } else {
    reason = there && !overwrite ? EEXIST : put_file(path, bytes, {.overwrite = overwrite});
    if (reason == EEXIST) return fail(ErrorCode::file, fmt::format("{} already exists", path));
  }
  if (reason != 0) return cannot("write", path, reason);
  return Nothing{};
}

Error system_error(int number, const std::string& doing, const std::string& path) {
  if (number == ENOSPC || number == EDQUOT)
    return fail(ErrorCode::machine, fmt::format("the disk is full: cannot {} {}", doing, path));
  return fail(ErrorCode::machine, fmt::format("cannot {} {}: {}", doing, path, std::strerror(number)));
}

Status check_place(const std::string& path, bool overwrite) {
  const std::string folder = folder_of(path);
  struct stat what {};
  if (path.empty() || path.back() == '/') return fail(ErrorCode::file, fmt::format("\"{}\" is not a file name", path));
  if (::stat(folder.c_str(), &what) != 0) {
    if (errno == ENOENT)
      return fail(ErrorCode::file, "there is no folder " + folder, "create it first: mkdir -p " + folder);
    return system_error(errno, "write into", folder);
  }
  if (!S_ISDIR(what.st_mode)) return fail(ErrorCode::file, folder + " is not a folder");
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return system_error(errno, "write into", folder);
  if (::stat(path.c_str(), &what) != 0) return Nothing{};
  if (S_ISDIR(what.st_mode)) return fail(ErrorCode::file, path + " is a folder");
  if (!overwrite) return fail(ErrorCode::file, path + " already exists");
  return Nothing{};
}

Status put_in_place(const std::string& from, const std::string& to, bool overwrite) {
  const int reason = move_to(from, to, overwrite);
  if (reason == 0) return Nothing{};
  if (reason == EEXIST && !overwrite) return fail(ErrorCode::file, to + " already exists");
  return system_error(reason, "write", to);
}

bool can_be_run(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

std::string ending(const std::string& path) {
  std::string e = std::filesystem::path(path).extension().string();
  if (!e.empty()) e.erase(0, 1);
  std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return std::tolower(c); });
  return e;
}

std::span<const std::uint8_t> as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace betwixt
