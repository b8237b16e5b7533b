// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Files: read whole, and written beside their place and then put into it, so that nobody ever sees half of one.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "betwixt/result.h"

namespace betwixt {

// ---- in words

// Errors: file (missing, a folder, not allowed, more than 1 GiB).
Result<std::string> read_whole(const std::string& path);
// For reading all of it. Errors: as those of read_whole.
class OpenFile;
Result<OpenFile> open_whole(const std::string& path);
// Beside it first, then in place: never half a file. What is no plain file (a pipe, a device) is written to as it is.
// Errors: file (there already, not allowed), machine (disk full).
Status write_whole(const std::string& path, std::string_view bytes, bool overwrite);

// Whether a file can be put at `path`. Errors: file (no such folder, a folder itself, there already), machine (not
// writable).
Status check_place(const std::string& path, bool overwrite);
// Gives a finished file its final name. Errors: file (there already), machine.
Status put_in_place(const std::string& from, const std::string& to, bool overwrite);
// "the disk is full" and the like, for what the system answered about a path.
Error system_error(int number, const std::string& doing, const std::string& path);

// Whether it is a program, for us.
bool can_be_run(const std::string& path);
// What follows the last dot of the file's name, in small letters.
std::string ending(const std::string& path);
std::span<const std::uint8_t> as_bytes(std::string_view);
std::string_view as_text(std::span<const std::uint8_t>);

// ---- with the system's reasons (numbers of errno, 0: none), for those who have words of their own

// What the system opened; closed with it.
class OpenFile {
 public:
  explicit OpenFile(int opened) : fd_(opened) {}
  OpenFile(OpenFile&& o) noexcept : fd_(std::exchange(o.fd_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  ~OpenFile() { close(); }
  explicit operator bool() const { return fd_ >= 0; }
  int fd() const { return fd_; }
  int close();                                      // 0 or the reason
  int release() { return std::exchange(fd_, -1); }  // from now on it is the caller's

 private:
  int fd_;
};

constexpr std::uint64_t largest_file = std::uint64_t{1} << 30;

// Whether a file was read, and what stood against it.
enum class Hindrance { none, missing, folder, special, too_large, system };
struct FileContents {
  Hindrance hindrance = Hindrance::none;
  int reason = 0;          // missing, system
  std::uint64_t size = 0;  // too_large
  std::string text;
};
struct ReadingLimits {
  std::uint64_t largest = largest_file;
  bool special = false;  // pipes and devices too; a pipe is waited for
};
FileContents read_contents(const std::string& path, const ReadingLimits& = {});

// From the beginning, where it has one, to the end. EFBIG where it is longer than `largest`.
int read_all(int file, std::string& text, std::uint64_t largest = UINT64_MAX);
// All of it; from `at` on, where that is said.
int write_all(int file, std::string_view bytes, std::optional<off_t> at = {});

struct Putting {
  bool overwrite = true;
  bool like_old = false;  // in place of what a link leads to, with the rights that it had
  bool on_disk = false;   // when it returns
};
// EEXIST where something is there that must not be overwritten.
int put_file(const std::string& path, std::string_view bytes, const Putting& = {});
// A file that was not there (EEXIST), on the disk.
int make_file(const std::string& path, std::string_view bytes, mode_t rights);
// A name is on the disk when its folder is.
void sync_folder_of(const std::string& path);
// A hidden name in the folder of `path` that nobody else uses.
std::string hidden_beside(const std::string& path, const std::string& tail = "");

}  // namespace betwixt
