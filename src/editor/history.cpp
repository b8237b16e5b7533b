// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/history.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/files.h"

namespace betwixt {
namespace {

Error not_kept(const Error& why) {
  return fail(why.code, "nothing is done, as the history cannot be kept: " + why.message, why.hint);
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

}  // namespace

Status finish_checkpoint(Journal& journal, const std::string& script) {
  if (!journal.base() || begins_with(script, *journal.base())) return Nothing{};
  const auto is = checkpoint_in(journal.records(), script);
  if (!is) return Nothing{};
  StepList all;
  for (const Record& r : journal.records()) all.count(r.what, r.what == Did::command ? unpacked(r.text) : Step{});
  if (is->second > all.standing) return Nothing{};
  return journal.begin_with(is->first, records_of(all.stand().subspan(is->second), all.undone()));
}

Result<ScriptBeside> write_beside(const std::string& path, std::string_view script) {
  ScriptBeside out;
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
    return fail(ErrorCode::file, fmt::format("another server keeps its history in '{}', or a shell has it open", path));
  if (!journal) return journal.error();
  path_ = path, journal_ = *std::move(journal);
  return Nothing{};
}

Result<Kept> History::found(const std::optional<std::string>& script) {
  Kept out;
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
                    : j.damaged() ? "the journal beside it is damaged; what came before the damage is gone on with"
                                  : nullptr;
  if (why) {
    const auto aside = j.keep_aside();
    if (!aside) return aside.error();
    out.remarks += fmt::format("'{}': {}; it is kept as '{}'\n", path_, why, *aside);
  } else if (j.torn() > 0) {
    out.remarks +=
        fmt::format("'{}': the last record of its journal was torn, and never answered; it is left out\n", path_);
  }
  // If the file was rewritten and the journal was not, the file holds all standing steps.
  if (!fits || !begins) return out;
  for (const Record& r : j.records()) out.steps.count(r.what, r.what == Did::command ? unpacked(r.text) : Step{});
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
    return fail(ErrorCode::range, fmt::format("the history would be longer than {} bytes", longest_),
                "undo takes commands back; betwixt serve --history N lets it grow");
  if (journal_)
    if (Status s = journal_->write(what, what == Did::command ? packed(step) : std::string()); !s)
      return not_kept(s.error());
  bytes_ = what == Did::undo ? bytes_ - more : bytes_ + more;
  length_ += what == Did::command ? more : 1;
  return Nothing{};
}

// Refuses to replace a text that another process has written.
Status History::unchanged() const {
  const auto there = read_script(path_);
  if (!there) return there.error();
  if (!*there || !known_ || fingerprint(**there) == *known_) return Nothing{};
  return fail(ErrorCode::file, fmt::format("'{}' has been changed by someone else, and is left as it is", path_),
              "what hosts did is in the journal beside it; move the file away, then save again");
}

// The journal gets a record of the new file first, so that an interruption between the two can be recognised.
Status History::write(const std::string& script) {
  if (Status s = unchanged(); !s) return s;
  const Fingerprint print = fingerprint(script);
  const bool lost = !journal_->in_place();  // moved or removed: the file will hold everything, and a new journal begins
  if (!lost)
    if (Status s = journal_->append(Did::save, to_string(print)); !s) return s;
  if (Status s = write_script(path_, script); !s) return s;
  known_ = print;
  return lost ? journal_->begin(print) : Nothing{};
}

Status History::save(const std::string& base, std::span<const Step> steps) {
  const std::string script = as_script(base, steps);
  return known_ == fingerprint(script) && (!journal_ || journal_->in_place()) ? unchanged() : write(script);
}

Status History::checkpoint(const std::optional<ScriptBeside>& to, std::size_t before, std::span<const Step> steps,
                           std::span<const Step> undone) {
  if (journal_ && to) {
    if (to->seen != known_ || to->seen_file != file_at(to->place))
      if (Status s = unchanged(); !s) return s;
    const std::string mark = fmt::format("{} {}", to_string(to->print), before);
    if (Status s = journal_->append(Did::checkpoint, mark); !s) return s;
    if (others_) ::link(path_.c_str(), (path_ + ".orig").c_str());  // fails if it exists already
    others_ = false;
    if (::rename(to->part.c_str(), to->place.c_str()) != 0) return not_put(path_);
    sync_folder_of(to->place);
    known_ = to->print;
    if (Status s = journal_->begin(to->print, records_of(steps, undone)); !s) return s;
  }
  measure(steps, undone);
  return Nothing{};
}

Status History::sync() { return journal_ ? journal_->sync() : Status(Nothing{}); }

void History::finish() {
  if (journal_) drop_beside(path_), journal_->remove();
  journal_.reset();
}

}  // namespace betwixt
