// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace betwixt {
namespace {

constexpr std::int64_t largest_file = std::int64_t{1} << 30;

std::string in_words(int error) {
  std::string words = std::generic_category().message(error);
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return words;
}

Error cannot(const char* what, const std::string& path, int error) {
  const bool machine = error == ENOSPC || error == EDQUOT || error == EIO || error == EMFILE || error == ENFILE;
  return fail(machine ? Code::machine : Code::file, fmt::format("cannot {} {}: {}", what, path, in_words(error)));
}

// An open file, closed with it.
struct Handle {
  int fd;
  explicit Handle(int opened) : fd(opened) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { close(); }
  int close() {
    const int result = fd >= 0 ? ::close(fd) : 0;
    fd = -1;
    return result;
  }
};

// 0, or what went wrong.
int write_all(Handle& file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(file.fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return file.close() == 0 ? 0 : errno;
}

// A name in the same folder that nobody else uses.
std::string beside(const std::string& path) {
  static std::atomic<unsigned> count{0};
  return fmt::format("{}.{}-{}.part", path, ::getpid(), count++);
}

}  // namespace

Result<Bytes> read_whole(const std::string& path) {
  Handle file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // a pipe without a writer must not block
  if (file.fd < 0) {
    if (errno == ENOENT) return fail(Code::file, fmt::format("there is no file {}", path));
    return cannot("read", path, errno);
  }
  struct stat about {};
  if (::fstat(file.fd, &about) != 0) return cannot("read", path, errno);
  if (S_ISDIR(about.st_mode)) return fail(Code::file, fmt::format("{} is a folder, not a file", path));
  if (!S_ISREG(about.st_mode)) return fail(Code::file, fmt::format("{} is not a plain file", path));
  if (about.st_size > largest_file) return fail(Code::file, fmt::format("{} is larger than 1 GiB", path));
  Bytes bytes(static_cast<std::size_t>(about.st_size));
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::read(file.fd, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return cannot("read", path, errno);
    if (n == 0) bytes.resize(done);  // it became shorter meanwhile
    done += static_cast<std::size_t>(n);
  }
  return bytes;
}

Status write_whole(const std::string& path, std::span<const std::uint8_t> bytes, bool overwrite) {
  struct stat about {};
  const bool there = ::stat(path.c_str(), &about) == 0;
  if (there && S_ISDIR(about.st_mode)) return fail(Code::file, fmt::format("{} is a folder, not a file", path));
  if (there && !S_ISREG(about.st_mode)) {
    Handle file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    const int error = file.fd < 0 ? errno : write_all(file, bytes);
    if (error != 0) return cannot("write", path, error);
    return Nothing{};
  }
  const auto exists = [&] { return fail(Code::file, fmt::format("{} exists already", path)); };
  if (there && !overwrite) return exists();

  const std::string part = beside(path);
  Handle file(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.fd < 0) return cannot("write", path, errno);
  int error = write_all(file, bytes);
  if (error == 0) {
    // A link, other than a renaming, fails where something has appeared under the name meanwhile.
    if (overwrite)
      error = ::rename(part.c_str(), path.c_str()) == 0 ? 0 : errno;
    else
      error = ::link(part.c_str(), path.c_str()) == 0 ? 0 : errno;
    if (!overwrite && error != 0 && error != EEXIST)  // file systems without links
      error = ::rename(part.c_str(), path.c_str()) == 0 ? 0 : errno;
  }
  ::unlink(part.c_str());  // gone already after a renaming
  if (error == EEXIST) return exists();
  if (error != 0) return cannot("write", path, error);
  return Nothing{};
}

std::string ending(const std::string& path) {
  std::string e = std::filesystem::path(path).extension().string();
  if (!e.empty()) e.erase(0, 1);
  std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return std::tolower(c); });
  return e;
}

}  // namespace betwixt
