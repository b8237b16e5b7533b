// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/history.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "base/files.h"
#include "base/free_beside.h"

namespace betwixt {
namespace {

Error not_kept(const Error& why) {
  return fail(why.code, "the command was not run, because the history cannot be saved: " + why.message, why.hint);
}

std::size_t bytes_of_all(std::span<const Step> steps) {
  std::size_t n = 0;
  for (const Step& s : steps) n += bytes_of(s);
  return n;
}

// Converts steps to journal records.
std::vector<Record> records_of(std::span<const Step> steps, std::span<const Step> undone) {
  std::vector<Record> out;
  for (const auto part : {steps, undone})
    for (const Step& s : part) out.push_back({Did::command, packed(s)});
  out.insert(out.end(), undone.size(), {Did::undo, {}});
  return out;
}

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

// Refuses to replace a text that another process has written.
Status unchanged(const std::string& path, const std::optional<Fingerprint>& known) {
  const auto there = read_script(path);
  if (!there) return there.error();
  if (!*there || !known || fingerprint(**there) == *known) return Nothing{};
  return fail(ErrorCode::file, fmt::format("'{}' was changed by another program, so it was not saved", path),
              "the commands of the hosts are in the journal beside it; move the file away, then save again");
}

StepList steps_of(const std::vector<Record>& records) {
  StepList all;
  for (const Record& r : records) all.count(r.what, r.what == Did::command ? unpacked(r.text) : Step{});
  return all;
}

// Appends the steps among the records to another journal. Adds their bytes to `length`.
Status copy_steps(const std::vector<Record>& records, Journal& to, std::size_t& length) {
  for (const Record& r : records) {
    if (r.what == Did::save || r.what == Did::checkpoint) continue;
    if (Status s = to.put(r.what, r.text); !s) return s;
    length += r.what == Did::command ? bytes_of(unpacked(r.text)) : 1;
  }
  return Nothing{};
}

}  // namespace

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

// The files of a checkpoint, and the thread that puts them in place.
struct History::Change {
  NextHistory next;
  std::string path;
  std::optional<Fingerprint> known;
  bool others = false;
  CheckpointStep step;
  std::thread thread;
  bool started = false;
  std::atomic<bool> done{false};
  bool script_there = false;  // this and the result are valid once `done` is set
  Status result = Nothing{};

  void start() {
    started = true;
    try {
      thread = std::thread([this] { run(); });
    } catch (const std::system_error&) {  // no thread could be started
      run();
    }
  }
  void run() {
    try {
      result = put_in_place();
    } catch (const std::exception& e) {  // out of memory
      result = fail(ErrorCode::machine, e.what());
    }
    done = true;
  }
  Status put_in_place() {
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
};

History::History(std::size_t longest, CheckpointStep step) : longest_(longest), step_(std::move(step)) {}
History::~History() { wait(); }

void StepList::count(Did what, Step step) {
  if (what == Did::undo && standing > 0) --standing;
  if (what == Did::redo && standing < all.size()) ++standing;
  if (what != Did::command) return;
  all.resize(standing);
  all.push_back(std::move(step));
  ++standing;
}

Status History::hold(const std::string& path) {
  auto journal = Journal::open(journal_path(path));
  if (!journal && journal.error().code == ErrorCode::name)
    return fail(ErrorCode::file, fmt::format("'{}' is in use by another server or shell", path));
  if (!journal) return journal.error();
  path_ = path, journal_ = *std::move(journal);
  return Nothing{};
}

Result<StoredHistory> History::found(const std::optional<std::string>& script) {
  StoredHistory out;
  if (Status s = finish_checkpoint(*journal_, script.value_or("")); !s) return s.error();
  out.base = out.script = script.value_or("");
  const Journal& j = *journal_;
  const Fingerprint present = fingerprint(out.base);
  const std::string now = to_string(present);
  const bool fits = j.base() == present || std::any_of(j.records().begin(), j.records().end(), [&](const Record& r) {
                      return r.what == Did::save && r.text == now;
                    });
  const std::string before = j.base() ? out.base.substr(0, j.base()->size) : "";
  const bool begins = j.base() && fingerprint(before) == *j.base();
  const char* why = j.foreign()                     ? "the journal beside it cannot be read"
                    : !j.records().empty() && !fits ? "the journal beside it belongs to another text of it"
                    : j.damaged() ? "the journal beside it is damaged; the commands before the damage are restored"
                                  : nullptr;
  if (why) {
    const auto aside = j.keep_aside();
    if (!aside) return aside.error();
    out.remarks += fmt::format("'{}': {}; it is kept as '{}'\n", path_, why, *aside);
  } else if (j.torn() > 0) {
    out.remarks += fmt::format(
        "'{}': the last record of its journal is incomplete and was never answered, so it is left out\n", path_);
  }
  // If the file was rewritten and the journal was not, the file holds all standing steps.
  if (!fits || !begins) return out;
  out.steps = steps_of(j.records());
  out.base = before, out.goes_on = true;
  return out;
}

void History::measure(std::span<const Step> steps, std::span<const Step> undone) {
  bytes_ = bytes_of_all(steps);
  length_ = bytes_ + bytes_of_all(undone);
}

Status History::keep(const std::string& base) {
  const auto there = read_script(path_);
  if (!there) return there.error();
  others_ = *there == base;
  if (!others_)
    if (Status s = write_script(path_, base); !s) return s;
  known_ = fingerprint(base);
  measure({}, {});
  return journal_->begin(*known_);
}

void History::go_on(std::span<const Step> steps, std::span<const Step> undone, const std::string& script) {
  journal_->forget();
  known_ = fingerprint(script), others_ = true;
  measure(steps, undone);
}

Status History::go_on_with(const std::string& base, std::span<const Step> steps, std::span<const Step> undone,
                           const std::string& script) {
  std::vector<Record> records = records_of(steps, undone);
  // The file holds more than the base. This record comes before the steps, so that a shell counts them as unsaved.
  if (script != base) records.insert(records.begin(), {Did::save, to_string(fingerprint(script))});
  if (Status s = journal_->begin(fingerprint(base), records); !s) return s;
  go_on(steps, undone, script);
  return Nothing{};
}

Status History::note(Did what, const Step& step) {
  const std::size_t more = bytes_of(step);
  if (what != Did::undo && bytes_ + more > longest_)
    return fail(ErrorCode::range, fmt::format("the history cannot be longer than {} bytes", longest_),
                "undo some commands, or set a higher limit: betwixt serve --history N");
  if (journal_) {
    const std::string text = what == Did::command ? packed(step) : std::string();
    const JournalPlace before = journal_->place();
    Status kept = in_place() ? journal_->put(what, text) : Status(journal_->lost());
    if (kept && change_) {
      kept = change_->next.journal->put(what, text);
      if (!kept) journal_->back_to(before);
    }
    if (!kept) return not_kept(kept.error());
  }
  bytes_ = what == Did::undo ? bytes_ - more : bytes_ + more;
  length_ += what == Did::command ? more : 1;
  if (change_) change_->next.length += what == Did::command ? more : 1;
  return Nothing{};
}

// The order matters: the thread may replace the one by the other in between.
bool History::in_place() const { return journal_->in_place() || (change_ && change_->next.journal->in_place()); }

// The journal gets a record of the new file first, so that an interruption between the two can be recognised.
Status History::save(const std::string& base, std::span<const Step> steps, std::span<const Step> undone) {
  const std::string script = as_script(base, steps);
  const Fingerprint print = fingerprint(script);
  const bool lost = journal_ && !journal_->in_place();  // moved or removed: a new journal begins
  if (Status s = unchanged(path_, known_); !s || (known_ == print && !lost)) return s;
  if (!lost)
    if (Status s = journal_->append(Did::save, to_string(print)); !s) return s;
  if (Status s = write_script(path_, script); !s) return s;
  known_ = print;
  if (!lost) return Nothing{};
  std::vector<Record> records = records_of(steps, undone);
  records.push_back({Did::save, to_string(print)});
  return journal_->begin(fingerprint(base), records);
}

Status History::go_over_to(NextHistory next) {
  const auto failed = [&](Status why) {
    next.journal.reset();
    Journal::drop_beside(journal()), betwixt::drop_beside(path_);
    return why;
  };
  if (!in_place()) return failed(journal_->lost());
  if (journal_->read_more(next.copied) != 0 || next.copied.end.end != journal_->size())
    return failed(fail(ErrorCode::machine, fmt::format("'{}' cannot be read", journal())));
  if (Status s = copy_steps(std::exchange(next.copied.records, {}), *next.journal, next.length); !s) return failed(s);
  const std::string mark = fmt::format("{} {}", to_string(next.script.print), next.before);
  if (Status s = journal_->put(Did::checkpoint, mark); !s) return failed(s);
  change_ = std::make_unique<Change>();
  change_->next = std::move(next), change_->path = path_, change_->step = step_;
  change_->known = known_, change_->others = others_;
  if (step_) step_("both journals take commands");
  return Nothing{};
}

void History::wait() {
  if (change_ && change_->thread.joinable()) change_->thread.join();
}

std::optional<Status> History::gone_over() {
  if (!change_ || !change_->done) return std::nullopt;
  wait();
  const auto change = std::exchange(change_, nullptr);
  if (change->script_there) known_ = change->next.script.print, others_ = false;
  if (!change->result) {
    if (!change->script_there) betwixt::drop_beside(path_);
    Journal::drop_beside(journal());
    return change->result;
  }
  free_beside(std::exchange(journal_, std::move(change->next.journal)));
  bytes_ -= change->next.gone, length_ = change->next.length;
  return Nothing{};
}

Status History::replace(const PendingScript& script, std::span<const Step> steps, std::span<const Step> undone) {
  NextHistory next;
  next.script = script;
  auto made = Journal::beside(journal(), script.print, records_of(steps, undone));
  if (!made) return made.error();
  next.journal = *std::move(made);
  next.copied.base = journal_->base(), next.copied.end = journal_->place();
  next.length = bytes_of_all(steps) + bytes_of_all(undone);
  if (Status s = go_over_to(std::move(next)); !s) return s;
  if (Status s = sync(); !s) return s;
  wait();
  return gone_over().value_or(Nothing{});
}

Status History::sync() {
  if (!journal_) return Nothing{};
  if (Status s = journal_->sync(); !s || !change_) return s;
  if (Status s = change_->next.journal->sync(); !s) return s;
  if (!change_->started) change_->start();
  return Nothing{};
}

void History::finish() {
  if (journal_) drop_beside(path_), Journal::drop_beside(journal()), journal_->remove();
  journal_.reset();
}

}  // namespace betwixt
