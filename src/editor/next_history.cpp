// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/next_history.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "editor/step_list.h"

namespace betwixt {
namespace {

Error not_put(const std::string& path) {
  return fail(ErrorCode::machine, fmt::format("'{}' cannot be written: {}", path, std::strerror(errno)));
}

// Returns the path of a script with its links resolved; part_of(): the path of a new script until it replaces that one.
std::string place_of(const std::string& path) {
  std::error_code none;
  const std::filesystem::path real = std::filesystem::canonical(path, none);
  return none ? path : real.string();
}
std::string part_of(const std::string& place) {
  const std::filesystem::path p(place);
  return (p.parent_path() / fmt::format(".{}.checkpoint", p.filename().string())).string();
}

// Returns the identity of the file, which changes with every write; "" if the file does not exist.
std::string file_at(const std::string& place) {
  struct stat s {};
  if (::stat(place.c_str(), &s) != 0) return {};
  return fmt::format("{} {} {} {} {}", s.st_dev, s.st_ino, s.st_size, s.st_mtim.tv_sec, s.st_mtim.tv_nsec);
}

bool begins_with(std::string_view script, const Fingerprint& text) {
  return script.size() >= text.size && fingerprint(script.substr(0, text.size)) == text;
}

// Returns the last checkpoint whose text the script begins with, and the number of commands in it.
std::optional<std::pair<Fingerprint, std::size_t>> checkpoint_in(const std::vector<Record>& records,
                                                                 std::string_view script) {
  for (auto r = records.rbegin(); r != records.rend(); ++r) {
    Fingerprint print;
    std::size_t commands = 0;
    if (r->what == Did::checkpoint &&
        std::sscanf(r->text.c_str(), "%" SCNu64 " %" SCNx64 " %zu", &print.size, &print.hash, &commands) == 3 &&
        begins_with(script, print))
      return std::pair(print, commands);
  }
  return std::nullopt;
}

}  // namespace

Status unchanged(const std::string& path, const std::optional<Fingerprint>& known) {
  const auto there = read_script(path);
  if (!there) return there.error();
  if (!*there || !known || fingerprint(**there) == *known) return Nothing{};
  return fail(ErrorCode::file, fmt::format("'{}' was changed by another program, so it was not saved", path),
              "the commands of the hosts are in the journal beside it; move the file away, then save again");
}

Result<NextHistory> write_next(const std::string& path, std::string_view script, std::size_t before,
                               const CheckpointStep& done) {
  constexpr std::uint64_t few = 1 << 16;  // bytes that are left to the thread that notes steps
  NextHistory next;
  next.before = before;
  auto beside = write_beside(path, script);
  if (!beside) return beside.error();
  next.script = *std::move(beside);
  if (done) done("the script is written");
  const std::string there = journal_path(path);
  const auto unreadable = [&](int reason) {
    return fail(ErrorCode::machine, fmt::format("'{}' cannot be read: {}", there, std::strerror(reason)));
  };
  const OpenFile file(::open(there.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return unreadable(errno);
  JournalText& copied = next.copied;
  if (const int reason = read_more(file.fd(), copied)) return unreadable(reason);
  const StepList all = steps_of(std::exchange(copied.records, {}));
  if (!copied.base || before > all.standing)
    return fail(ErrorCode::machine, fmt::format("'{}' lacks commands that were written to it", there));
  const auto rest = all.stand().subspan(before);
  next.gone = bytes_of_all(all.stand().first(before));
  next.length = bytes_of_all(rest) + bytes_of_all(all.undone());
  auto journal = Journal::beside(there, next.script.print, records_of(rest, all.undone()));
  if (!journal) return journal.error();
  next.journal = *std::move(journal);
  for (std::uint64_t more = few; more >= few;) {
    const std::uint64_t from = copied.end.end;
    if (const int reason = read_more(file.fd(), copied)) return unreadable(reason);
    if (Status s = copy_steps(std::exchange(copied.records, {}), *next.journal, next.length); !s) return s.error();
    if (Status s = next.journal->sync(); !s) return s.error();
    more = copied.end.end - from;
  }
  if (done) done("the journal is written");
  return next;
}

Status finish_checkpoint(Journal& journal, const std::string& script) {
  if (!journal.base() || begins_with(script, *journal.base())) return Nothing{};
  const auto is = checkpoint_in(journal.records(), script);
  if (!is) return Nothing{};
  const StepList all = steps_of(journal.records());
  if (is->second > all.standing) return Nothing{};
  return journal.begin_with(is->first, records_of(all.stand().subspan(is->second), all.undone()));
}

Result<PendingScript> write_beside(const std::string& path, std::string_view script) {
  PendingScript out;
  out.place = place_of(path), out.part = part_of(out.place), out.print = fingerprint(script);
  out.seen_file = file_at(out.place);
  const auto there = read_script(path);
  if (!there) return there.error();
  if (*there) out.seen = fingerprint(**there);
  struct stat old {};
  const mode_t rights = ::stat(out.place.c_str(), &old) == 0 ? old.st_mode & 07777 : 0600;
  drop_beside(path);
  int reason = make_file(out.part, script, rights);
  if (reason == 0 && ::chmod(out.part.c_str(), rights) != 0) reason = errno;
  if (reason != 0) return errno = reason, not_put(path);
  return out;
}

void drop_beside(const std::string& path) { ::unlink(part_of(place_of(path)).c_str()); }

void Replacement::start() {
  started = true;
  try {
    thread = std::thread([this] { run(); });
  } catch (const std::system_error&) {  // no thread could be started
    run();
  }
}

void Replacement::run() {
  try {
    result = put_in_place();
  } catch (const std::exception& e) {  // out of memory
    result = fail(ErrorCode::machine, e.what());
  }
  done = true;
}

Status Replacement::put_in_place() {
  const PendingScript& to = next.script;
  if (to.seen != known || to.seen_file != file_at(to.place))
    if (Status s = unchanged(path, known); !s) return s;
  if (others) ::link(path.c_str(), (path + ".orig").c_str());  // fails if it exists already
  if (::rename(to.part.c_str(), to.place.c_str()) != 0) return not_put(path);
  sync_folder_of(to.place);
  script_there = true;
  if (step) step("the script is in place");
  if (Status s = next.journal->replace(); !s) return s;
  if (step) step("the journal is in place");
  return Nothing{};
}

}  // namespace betwixt
