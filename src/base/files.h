// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads whole files, and writes files beside their place and renames them, so that no reader ever gets half of one.
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

// ---- with errors in words

// Errors: file (missing, a folder, not allowed, more than 1 GiB).
Result<std::string> read_whole(const std::string& path);
// Opens a file to read all of it. Errors: those of read_whole.
class OpenFile;
Result<OpenFile> open_whole(const std::string& path);
// Writes a file beside its place and renames it. A file that is not regular (a pipe, a device) is written directly.
// Errors: file (it exists, not allowed), machine (disk full).
Status write_whole(const std::string& path, std::string_view bytes, bool overwrite);

// Checks whether a file can be written at `path`. Errors: file (no such folder, a folder itself, it exists), machine
// (not writable).
Status check_place(const std::string& path, bool overwrite);
// Renames a finished file to its final name. Errors: file (it exists), machine.
Status put_in_place(const std::string& from, const std::string& to, bool overwrite);
// Returns the error that there is no such file. Its hint is a file in the same folder with a similar name.
Error no_file(const std::string& path);
// Returns "the disk is full" and the like, for the system's error about a path.
Error system_error(int number, const std::string& doing, const std::string& path);

// Returns true if the path is a program that we may run.
bool can_be_run(const std::string& path);
// Returns the extension of a file's name, without the dot, in lower case.
std::string ending(const std::string& path);
std::span<const std::uint8_t> as_bytes(std::string_view);
std::string_view as_text(std::span<const std::uint8_t>);

// ---- with the system's errors (errno, 0: none), for callers with messages of their own

// A file descriptor; closes itself.
class OpenFile {
 public:
  explicit OpenFile(int opened) : fd_(opened) {}
  OpenFile(OpenFile&& o) noexcept : fd_(std::exchange(o.fd_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  ~OpenFile() { close(); }
  explicit operator bool() const { return fd_ >= 0; }
  int fd() const { return fd_; }
  int close();                                      // 0 or the errno
  int release() { return std::exchange(fd_, -1); }  // passes it to the caller

 private:
  int fd_;
};

constexpr std::uint64_t largest_file = std::uint64_t{1} << 30;

// The reason why a file could not be read, or none.
enum class ReadProblem { none, missing, folder, special, too_large, system };
struct FileContents {
  ReadProblem problem = ReadProblem::none;
  int reason = 0;          // missing, system
  std::uint64_t size = 0;  // too_large
  std::string text;
};
struct ReadingLimits {
  std::uint64_t largest = largest_file;
  bool special = false;  // allows pipes and devices too; waits for a pipe
};
FileContents read_contents(const std::string& path, const ReadingLimits& = {});

// Reads from the beginning, if the file has one, to the end. Returns EFBIG if it is longer than `largest`.
int read_all(int file, std::string& text, std::uint64_t largest = UINT64_MAX);
// Writes all bytes, at `at` if given.
int write_all(int file, std::string_view bytes, std::optional<off_t> at = {});

struct WriteOptions {
  bool overwrite = true;
  bool like_old = false;  // follow a link, and keep the rights of the old file
  bool on_disk = false;   // wait until it is on the disk
};
// Returns EEXIST if there is a file that must not be overwritten.
int put_file(const std::string& path, std::string_view bytes, const WriteOptions& = {});
// Makes a new file (EEXIST if it exists), on the disk.
int make_file(const std::string& path, std::string_view bytes, mode_t rights);
// A name is on the disk when its folder is synchronised.
void sync_folder_of(const std::string& path);
// Returns a hidden name in the folder of `path` that no other process uses.
std::string hidden_beside(const std::string& path, const std::string& tail = "");

}  // namespace betwixt
