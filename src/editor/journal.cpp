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

constexpr std::size_t longest_head = 64;  // of a record
constexpr std::size_t longest_header = 128;
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

// Reads the record at the beginning of `rest`. Returns false if it is not complete.
bool read_record(std::string_view rest, JournalText& to) {
  const std::size_t stop = rest.find('\n');
  const std::string line(
      rest.substr(0, std::min(stop, longest_head)));  // not more: sscanf looks for the end of its text
  char kind = 0;
  std::uint64_t size = 0, sum = 0, expected = to.end.sum;
  const bool said =
      stop < longest_head && std::sscanf(line.c_str(), "%c %" SCNu64 " %" SCNx64, &kind, &size, &sum) == 3;
  const std::size_t left = said ? rest.size() - stop - 1 : 0;
  const bool known = kind == 'c' || kind == 'u' || kind == 'r' || kind == 's' || kind == 'k';
  if (said && known && size < left) {
    const std::string_view text = rest.substr(stop + 1, size);
    const std::string whole = record(static_cast<Did>(kind), text, expected);
    if (rest.starts_with(whole)) {
      to.records.push_back({static_cast<Did>(kind), std::string(text)});
      to.end = {to.end.end + whole.size(), expected};
      return true;
    }
  }
  to.torn = rest.size();
  to.damaged = stop != std::string::npos && (!said || size < left);
  return false;
}

// Reads the header of a journal. Returns false if it has none.
bool read_header(std::string_view all, JournalText& to) {
  const std::size_t line = std::min(all.find('\n'), longest_header);
  const std::string first(all.substr(0, line));
  Fingerprint base;
  if (line < longest_header &&
      std::sscanf(first.c_str(), "betwixt-journal 1 %" SCNu64 " %" SCNx64, &base.size, &base.hash) == 2 &&
      header(base) == first + "\n") {
    to.base = base;
    to.end = {line + 1, fnv(all.substr(0, line + 1))};
    return true;
  }
  // A header that was cut off: no record behind it can have been acknowledged.
  const std::string_view begin = "betwixt-journal 1 ";
  const std::size_t n = std::min(begin.size(), all.size());
  to.foreign = all.find('\n') != std::string_view::npos || all.substr(0, n) != begin.substr(0, n);
  return false;
}

int read_from(int file, std::uint64_t at, std::string& text) {
  struct stat s {};
  if (::fstat(file, &s) != 0) return errno;
  const auto size = static_cast<std::uint64_t>(s.st_size);
  text.resize(size > at ? size - at : 0);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::pread(file, text.data() + done, text.size() - done, static_cast<off_t>(at + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    if (n == 0) text.resize(done);
    done += static_cast<std::size_t>(n);
  }
  return 0;
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
    if (!S_ISREG(held.st_mode)) return fail(ErrorCode::machine, fmt::format("'{}' is not a regular file", path));
    // The last owner may have removed the file between open() and flock().
    if (::stat(path.c_str(), &named) != 0 || named.st_ino != held.st_ino || named.st_dev != held.st_dev) continue;
    if (betwixt::read_more(file, journal->text_) != 0) journal->text_.foreign = true;
    return journal;
  }
}

Journal::~Journal() { ::close(file_); }

int read_more(int file, JournalText& text) {
  std::string bytes;
  if (const int reason = read_from(file, text.end.end, bytes)) return reason;
  std::string_view rest = bytes;
  text.torn = 0, text.damaged = false;
  if (!text.base) {
    if (!read_header(rest, text)) return 0;
    rest.remove_prefix(text.end.end);
  }
  while (!rest.empty()) {
    const std::uint64_t before = text.end.end;
    if (!read_record(rest, text)) break;
    rest.remove_prefix(text.end.end - before);
  }
  return 0;
}

Result<std::unique_ptr<Journal>> Journal::beside(const std::string& path, const Fingerprint& base,
                                                 std::span<const Record> records) {
  std::string all = header(base);
  std::uint64_t sum = fnv(all);
  for (const Record& r : records) all += record(r.what, r.text, sum);
  const std::string name = path + next_name;
  ::unlink(name.c_str());  // left by a process that was killed
  OpenFile file(::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  int reason = file ? 0 : errno;
  if (reason == 0 && ::flock(file.fd(), LOCK_EX | LOCK_NB) != 0) reason = errno;
  if (reason == 0) reason = write_all(file.fd(), all, 0);
  if (reason == 0 && ::fdatasync(file.fd()) != 0) reason = errno;
  if (reason != 0) {
    if (file) ::unlink(name.c_str());
    return machine(path, "written", reason);
  }
  std::unique_ptr<Journal> made(new Journal(path, file.release()));
  made->text_.base = base, made->text_.end = {all.size(), sum};
  return made;
}

Status Journal::replace() {
  if (::rename((path_ + next_name).c_str(), path_.c_str()) != 0) return machine(path_, "written");
  sync_folder_of(path_);
  return Nothing{};
}

void Journal::drop_beside(const std::string& path) { ::unlink((path + next_name).c_str()); }

Status Journal::begin(const Fingerprint& base, std::span<const Record> records) {
  auto next = beside(path_, base, records);
  if (!next) return next.error();
  if (Status s = (*next)->replace(); !s) return drop_beside(path_), s;
  std::swap(file_, (*next)->file_);
  text_ = std::move((*next)->text_), dirty_ = false;
  return Nothing{};
}

Status Journal::begin_with(const Fingerprint& base, std::vector<Record> records) {
  if (Status s = begin(base, records); !s) return s;
  text_.records = std::move(records);
  return Nothing{};
}

bool Journal::in_place() const {
  struct stat ours {
  }, there{};
  return ::fstat(file_, &ours) == 0 && ::stat(path_.c_str(), &there) == 0 && ours.st_dev == there.st_dev &&
         ours.st_ino == there.st_ino;
}

Error Journal::lost() const {
  return fail(ErrorCode::machine,
              fmt::format("the journal '{}' was moved or removed, so no more commands can be saved", path_),
              "put it back, or save, which begins a new journal");
}

Status Journal::write(Did what, std::string_view text) { return in_place() ? put(what, text) : Status(lost()); }

Status Journal::put(Did what, std::string_view text) {
  JournalPlace& at = text_.end;
  if (text_.torn > 0) {
    if (::ftruncate(file_, static_cast<off_t>(at.end)) != 0) return machine(path_, "mended");
    text_.torn = 0;
  }
  JournalPlace next = at;
  const std::string bytes = record(what, text, next.sum);
  next.end += bytes.size();
  if (const int reason = write_all(file_, bytes, static_cast<off_t>(at.end))) {
    text_.torn = bytes.size();  // perhaps: the next record overwrites those bytes
    if (::ftruncate(file_, static_cast<off_t>(at.end)) == 0) text_.torn = 0;
    return machine(path_, "written", reason);
  }
  at = next, dirty_ = true;
  return Nothing{};
}

Status Journal::sync() {
  if (dirty_ && ::fdatasync(file_) != 0) return machine(path_, "written");
  dirty_ = false;
  return Nothing{};
}

void Journal::back_to(const JournalPlace& place) {
  if (place.end == text_.end.end) return;
  text_.torn = text_.end.end - place.end, text_.end = place;
  if (::ftruncate(file_, static_cast<off_t>(place.end)) == 0) text_.torn = 0;
}

Status Journal::append(Did what, std::string_view text) {
  const JournalPlace before = text_.end;
  if (Status s = write(what, text); !s) return s;
  const Status safe = sync();
  if (safe) return safe;
  back_to(before), dirty_ = false;
  if (text_.torn == 0) ::fdatasync(file_);
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
  if (in.problem == ReadProblem::none) return std::optional<std::string>(std::move(in.text));
  if (in.problem == ReadProblem::missing && in.reason == ENOENT) return std::optional<std::string>();
  if (in.reason != 0)
    return fail(ErrorCode::file, fmt::format("'{}' cannot be read: {}", path, std::strerror(in.reason)));
  return fail(ErrorCode::file, fmt::format("'{}' is not a script: only a regular file can be opened and saved", path));
}

Status write_script(const std::string& path, std::string_view text) {
  struct stat old {};
  if (::stat(path.c_str(), &old) == 0 && !S_ISREG(old.st_mode))
    return fail(ErrorCode::file, fmt::format("'{}' is not a regular file", path));
  if (const int reason = put_file(path, text, {.like_old = true, .on_disk = true}))
    return machine(path, "written", reason);
  return Nothing{};
}

}  // namespace betwixt
