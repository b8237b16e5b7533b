// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "base/files.h"

namespace betwixt {
namespace {

constexpr std::size_t longest_head = 64;   // of a record
constexpr const char* next_name = ".new";  // appended to the journal's name: its replacement

constexpr std::uint64_t fnv_basis = 0xcbf29ce484222325;  // FNV-1a, 64 bits
std::uint64_t fnv(std::string_view bytes, std::uint64_t h = fnv_basis) {
  for (const char c : bytes) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

Error machine(const std::string& path, const char* what, int reason = errno) {
  return fail(ErrorCode::machine, fmt::format("'{}' cannot be {}: {}", path, what, std::strerror(reason)));
}

Result<std::string> text_of(int file, const std::string& path) {
  std::string text;
  if (const int reason = read_all(file, text)) return machine(path, "read", reason);
  return text;
}

std::string header(const Fingerprint& base) {
  const std::string said = "betwixt-journal 1 " + to_string(base);
  return fmt::format("{} {:016x}\n", said, fnv(said));
}

std::string record(Did what, std::string_view text, std::uint64_t& sum) {
  const char kind = static_cast<char>(what);
  sum = fnv(text, fnv({&kind, 1}, sum));
  return fmt::format("{} {} {:016x}\n{}\n", kind, text.size(), sum, text);
}

}  // namespace

Fingerprint fingerprint(std::string_view text) { return {text.size(), fnv(text)}; }

std::string to_string(const Fingerprint& f) { return fmt::format("{} {:016x}", f.size, f.hash); }

std::string journal_path(const std::string& script) {
  if (script.empty()) return ".betwixt.journal";
  std::error_code ignored;
  const std::filesystem::path real =
      std::filesystem::weakly_canonical(script, ignored);  // one journal for all names of the script
  return (real.parent_path() / fmt::format(".{}.journal", real.filename().string())).string();
}

Result<std::unique_ptr<Journal>> Journal::open(const std::string& path) {
  for (;;) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file < 0) return machine(path, "made");
    std::unique_ptr<Journal> journal(new Journal(path, file));
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK) return fail(ErrorCode::name, "another process has it open");
      return machine(path, "locked");
    }
    struct stat held {};
    struct stat named {};
    if (::fstat(file, &held) != 0) return machine(path, "read");
    if (!S_ISREG(held.st_mode)) return fail(ErrorCode::machine, fmt::format("'{}' is no file", path));
    // The last owner may have removed the file between open() and flock().
    if (::stat(path.c_str(), &named) != 0 || named.st_ino != held.st_ino || named.st_dev != held.st_dev) continue;
    journal->read();
    return journal;
  }
}

Journal::~Journal() { ::close(file_); }

void Journal::read() {
  const auto read = text_of(file_, path_);
  if (!read) {
    foreign_ = true;
    return;
  }
  const std::string& all = *read;
  const std::size_t line = all.find('\n');
  Fingerprint base;
  if (line == std::string::npos ||
      std::sscanf(all.c_str(), "betwixt-journal 1 %" SCNu64 " %" SCNx64, &base.size, &base.hash) != 2 ||
      header(base) != all.substr(0, line + 1)) {
    // A header that was cut off: no record behind it can have been acknowledged.
    const std::string_view begin = "betwixt-journal 1 ";
    const std::size_t n = std::min(begin.size(), all.size());
    foreign_ = line != std::string::npos || all.compare(0, n, begin.substr(0, n)) != 0;
    return;
  }
  base_ = base;
  std::size_t at = line + 1;
  sum_ = fnv({all.data(), at});
  while (at < all.size() && read_record(all, at)) continue;
  end_ = at;
}

// Returns false if there is no complete record at `at`.
bool Journal::read_record(const std::string& all, std::size_t& at) {
  const std::string_view rest = std::string_view(all).substr(at);
  const std::size_t stop = rest.find('\n');
  const std::string line(
      rest.substr(0, std::min(stop, longest_head)));  // not more: sscanf looks for the end of its text
  char kind = 0;
  std::uint64_t size = 0, sum = 0, expected = sum_;
  const bool said =
      stop < longest_head && std::sscanf(line.c_str(), "%c %" SCNu64 " %" SCNx64, &kind, &size, &sum) == 3;
  const std::size_t left = said ? rest.size() - stop - 1 : 0;
  const bool known = kind == 'c' || kind == 'u' || kind == 'r' || kind == 's' || kind == 'k';
  if (said && known && size < left) {
    const std::string_view text = rest.substr(stop + 1, size);
    const std::string whole = record(static_cast<Did>(kind), text, expected);
    if (rest.starts_with(whole)) {
      records_.push_back({static_cast<Did>(kind), std::string(text)});
      sum_ = expected;
      at += whole.size();
      return true;
    }
  }
  torn_ = rest.size();
  damaged_ = stop != std::string::npos && (!said || size < left);
  return false;
}

// Writes the new journal under another name, then renames it.
Status Journal::begin(const Fingerprint& base, std::span<const Record> records) {
  std::string all = header(base);
  std::uint64_t sum = fnv(all);
  for (const Record& r : records) all += record(r.what, r.text, sum);
  const std::string beside = path_ + next_name;
  ::unlink(beside.c_str());  // left by a process that was killed
  OpenFile file(::open(beside.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  int reason = file ? 0 : errno;
  if (reason == 0 && ::flock(file.fd(), LOCK_EX | LOCK_NB) != 0) reason = errno;
  if (reason == 0) reason = write_all(file.fd(), all, 0);
  if (reason == 0 && ::fdatasync(file.fd()) != 0) reason = errno;
  if (reason == 0 && ::rename(beside.c_str(), path_.c_str()) != 0) reason = errno;
  if (reason != 0) {
    if (file) ::unlink(beside.c_str());
    return machine(path_, "written", reason);
  }
  sync_folder_of(path_);
  ::close(std::exchange(file_, file.release()));
  base_ = base, sum_ = sum, end_ = all.size(), torn_ = 0;
  foreign_ = damaged_ = dirty_ = false;
  records_.clear();
  return Nothing{};
}

Status Journal::begin_with(const Fingerprint& base, std::vector<Record> records) {
  if (Status s = begin(base, records); !s) return s;
  records_ = std::move(records);
  return Nothing{};
}

bool Journal::in_place() const {
  struct stat ours {
  }, there{};
  return ::fstat(file_, &ours) == 0 && ::stat(path_.c_str(), &there) == 0 && ours.st_dev == there.st_dev &&
         ours.st_ino == there.st_ino;
}

Status Journal::write(Did what, std::string_view text) {
  if (!in_place())
    return fail(ErrorCode::machine,
                fmt::format("the journal '{}' was moved or removed, so nothing more is kept", path_),
                "put it back, or save: that begins a new one");
  if (torn_ > 0) {
    if (::ftruncate(file_, static_cast<off_t>(end_)) != 0) return machine(path_, "mended");
    torn_ = 0;
  }
  std::uint64_t sum = sum_;
  const std::string bytes = record(what, text, sum);
  if (const int reason = write_all(file_, bytes, static_cast<off_t>(end_))) {
    torn_ = bytes.size();  // perhaps: the next record overwrites those bytes
    if (::ftruncate(file_, static_cast<off_t>(end_)) == 0) torn_ = 0;
    return machine(path_, "written", reason);
  }
  sum_ = sum, end_ += bytes.size(), dirty_ = true;
  return Nothing{};
}

Status Journal::sync() {
  if (dirty_ && ::fdatasync(file_) != 0) return machine(path_, "written");
  dirty_ = false;
  return Nothing{};
}

Status Journal::append(Did what, std::string_view text) {
  const std::uint64_t sum = sum_, end = end_;
  if (Status s = write(what, text); !s) return s;
  const Status safe = sync();
  if (safe) return safe;
  torn_ = end_ - end, sum_ = sum, end_ = end, dirty_ = false;
  if (::ftruncate(file_, static_cast<off_t>(end_)) == 0) torn_ = 0, ::fdatasync(file_);
  return safe;
}

Result<std::string> Journal::keep_aside() const {
  const auto all = text_of(file_, path_);
  if (!all) return all.error();
  for (int k = 1; k < 10000; ++k) {
    const std::string name = fmt::format("{}.{}", path_, k);
    const int reason = make_file(name, *all, 0600);
    if (reason == EEXIST) continue;
    if (reason != 0) return machine(name, "written", reason);
    return name;
  }
  return fail(ErrorCode::file, fmt::format("there are too many journals beside '{}'", path_));
}

void Journal::remove() { ::unlink(path_.c_str()); }

Result<std::optional<std::string>> read_script(const std::string& path) {
  FileContents in = read_contents(path, {.largest = UINT64_MAX});
  if (in.hindrance == Hindrance::none) return std::optional<std::string>(std::move(in.text));
  if (in.hindrance == Hindrance::missing && in.reason == ENOENT) return std::optional<std::string>();
  if (in.reason != 0)
    return fail(ErrorCode::file, fmt::format("'{}' cannot be read: {}", path, std::strerror(in.reason)));
  return fail(ErrorCode::file, fmt::format("'{}' is no script: only a file can be opened and saved", path));
}

Status write_script(const std::string& path, std::string_view text) {
  struct stat old {};
  if (::stat(path.c_str(), &old) == 0 && !S_ISREG(old.st_mode))
    return fail(ErrorCode::file, fmt::format("'{}' is no file", path));
  if (const int reason = put_file(path, text, {.like_old = true, .on_disk = true}))
    return machine(path, "written", reason);
  return Nothing{};
}

}  // namespace betwixt
