// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/files.h"
#include "base/free_beside.h"

namespace betwixt {
namespace {

Error not_kept(const Error& why) {
  return fail(why.code, "the command was not run, because the history cannot be saved: " + why.message, why.hint);
}

}  // namespace

History::History(std::size_t longest, CheckpointStep step) : longest_(longest), step_(std::move(step)) {}
History::~History() { wait(); }

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
  change_ = std::make_unique<Replacement>();
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
