// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/partial.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/files.h"

namespace betwixt {
namespace {

// Returns true if both are hidden names of one film, which differ in the process numbers only.
bool alike(const std::string& a, const std::string& b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::size_t mark = a.rfind(".partial");
  if (mark == std::string::npos) return false;
  std::size_t number = mark;  // where "PROCESS-COUNT" begins
  while (number > 0 && (digit(a[number - 1]) || a[number - 1] == '-')) --number;
  const std::size_t rest = a.size() - mark;
  if (b.size() <= number + rest || b.compare(0, number, a, 0, number) != 0) return false;
  if (b.compare(b.size() - rest, rest, a, mark, rest) != 0) return false;
  return std::all_of(b.begin() + static_cast<std::ptrdiff_t>(number), b.end() - static_cast<std::ptrdiff_t>(rest),
                     [&](char c) { return digit(c) || c == '-'; });
}

std::string name_in(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// Returns true if the locked file still has that name, and was not removed in between.
bool stands(int file, const std::string& path) {
  struct stat own {
  }, there{};
  return ::fstat(file, &own) == 0 && ::lstat(path.c_str(), &there) == 0 && own.st_ino == there.st_ino &&
         own.st_dev == there.st_dev;
}

}  // namespace

Partial::Partial(const Output& place, What what)
    : place_(place), what_(what), tail_(what == What::file ? place.name.substr(place.name.rfind('.')) : "") {}

Partial::~Partial() {
  if (made_) {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  if (lock_ >= 0) ::close(lock_);
}

int Partial::try_to_make() {
  path_ = place_.hidden(tail_);
  if (what_ == What::folder && ::mkdir(path_.c_str(), 0777) != 0) return errno;
  const int how = what_ == What::folder ? O_RDONLY | O_DIRECTORY : O_RDWR | O_CREAT | O_EXCL;
  lock_ = ::open(path_.c_str(), how | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (lock_ < 0) return errno;
  made_ = true;
  // On a file system without locks, no one can tell which processes run; nothing is ever removed there.
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 || stands(lock_, path_)) return 0;
  ::close(lock_);
  made_ = false;
  return EEXIST;
}

Status Partial::make() {
  clear_left();
  int reason = EEXIST;
  for (int tries = 0; tries < 100 && reason == EEXIST; ++tries) reason = try_to_make();
  if (reason != 0) return system_error(reason, "write", place_.format ? place_.path() : place_.folder);
  return Nothing{};
}

void Partial::clear_left() const {
  const std::string ours = name_in(place_.hidden(tail_));
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(place_.folder, ignored)) {
    if (!alike(ours, entry.path().filename().string())) continue;
    const std::string path = entry.path().string();
    const int kind = what_ == What::folder ? O_DIRECTORY : O_NONBLOCK;
    const OpenFile left(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | kind));
    struct stat about {};
    if (!left || ::fstat(left.fd(), &about) != 0) continue;
    if (what_ == What::file && !S_ISREG(about.st_mode)) continue;
    if (::flock(left.fd(), LOCK_EX | LOCK_NB) == 0) std::filesystem::remove_all(path, ignored);
  }
}

Status Partial::written() const {
  // Some file systems report only now that the disk is full.
  if (::fsync(lock_) == 0 || errno == EINVAL || errno == ENOSYS) return Nothing{};
  return system_error(errno, "write", place_.path());
}

std::uint64_t Partial::size() const {
  struct stat about {};
  return ::fstat(lock_, &about) == 0 ? static_cast<std::uint64_t>(about.st_size) : 0;
}

}  // namespace betwixt
