// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The start of a session: loads the script, and recovers unsaved work of an earlier session.
#include <algorithm>
#include <filesystem>

#include "base/counted.h"
#include "editor/crash_recovery.h"
#include "editor/describe.h"
#include "editor/history.h"
#include "editor/session_state.h"

namespace betwixt {

namespace fs = std::filesystem;

// Starts with a text; keeps nothing of the last session.
void Session::State::start(Opening& o, const std::string& base) {
  file = o.name, known = o.print;
  tally = {};
  sheet_refused = false;
  of_text = editor.begin(base, file);
  written = {base, {}}, unwritten.clear(), journal_knows = journal_undid = 0;
  for (const Diagnostic& d : of_text)
    if (d.severity != Severity::notice) o.said += to_string(d);
}

Session::Answer Session::State::open(const std::string& name, Earlier earlier) {
  Opening o{name, {}, {}, {}};
  if (!name.empty()) {
    const auto there = read_script(name);
    if (!there) return refused(there.error());
    std::error_code ignored;
    const fs::path folder = fs::path(name).parent_path();
    if (!*there && !folder.empty() && !fs::is_directory(folder, ignored))
      return refused(fmt::format("there is no folder '{}'", folder.string()));
    if (*there) o.text = **there, o.print = fingerprint(o.text);
  }
  close(false);
  looks_only = false;
  auto opened = Journal::open(name.empty() ? nameless_journal : journal_path(name));
  if (opened) {
    journal = *std::move(opened);
    Answer found = after_earlier(std::move(o), earlier);
    if (!found.done) journal.reset();
    return found;
  }
  start(o, o.text);
  looks_only = opened.error().code == ErrorCode::name;
  if (looks_only)
    o.said += fmt::format("another shell has {} open, so this one is read-only\n", called());
  else
    o.said += fmt::format("no journal can be written here, so a crash would lose unsaved commands: {}\n",
                          opened.error().message);
  return done(o.said);
}

void Session::State::begin(std::string text, const std::string& name) {
  close(false);
  looks_only = false;
  Opening o{name, std::move(text), {}, {}};
  start(o, o.text);
}

// Keeps a journal that cannot be continued under another name beside the script.
Status Session::State::put_aside(Opening& o, bool fits) const {
  const char* why = journal->foreign() ? "the journal beside the script cannot be read"
                    : !fits && !journal->records().empty()
                        ? "the journal beside the script belongs to another text of it"
                    : journal->damaged() ? "the journal of an earlier session is damaged"
                                         : nullptr;
  if (!why) return Nothing{};
  const auto kept = journal->keep_aside();
  if (!kept) return kept.error();
  o.said += fmt::format("{}; it is kept as '{}'\n", why, *kept);
  return Nothing{};
}

// Decides by the journal how the session begins.
Session::Answer Session::State::after_earlier(Opening o, Earlier earlier) {
  if (Status s = finish_checkpoint(*journal, o.text); !s) return refused(s.error());
  const Fingerprint present = fingerprint(o.text);
  // The base of the records: the whole file, or its part before the saved commands.
  std::optional<std::string> under;
  Tally then;
  if (const auto& first = journal->base()) {
    bool fits = *first == present;
    for (const Record& r : journal->records()) {
      if (r.what != Did::save || r.text == to_string(present)) then.count(r.what);
      fits = fits || (r.what == Did::save && r.text == to_string(present));
    }
    const std::string before = o.text.substr(0, std::min<std::size_t>(first->size, o.text.size()));
    if (fits && fingerprint(before) == *first) under = before;
  }
  // After a save in place the last record is the save: the file holds everything.
  const auto& found = journal->records();
  const bool all_saved =
      !under && !found.empty() && found.back().what == Did::save && found.back().text == to_string(present);
  if (Status s = all_saved ? Status(Nothing{}) : put_aside(o, under.has_value()); !s) return refused(s.error());
  if (under && journal->torn() > 0) o.said += "the last record of the journal is incomplete and is left out\n";
  if (under && then.unsaved() > 0) {
    const auto recover = wanted(then, earlier);
    if (!recover)
      return {false, true, false,
              o.said + fmt::format("{} of an earlier session {} not saved; the journal keeps {}\n",
                                   counted(then.unsaved(), "command"), then.unsaved() == 1 ? "is" : "are",
                                   then.unsaved() == 1 ? "it" : "them")};
    if (*recover) return replay(std::move(o), *under);
  }
  start(o, o.text);
  if (Status s = journal->begin(present); !s) {
    o.said +=
        fmt::format("no journal can be written here, so a crash would lose unsaved commands: {}\n", s.error().message);
    close(false);
  }
  if (!o.name.empty() && !o.print) o.said += fmt::format("'{}' does not exist yet: this is a new film\n", o.name);
  return done(o.said);
}

// Asks whether to recover. Returns nullopt without an answer.
std::optional<bool> Session::State::wanted(const Tally& then, Earlier earlier) const {
  if (earlier != Earlier::ask) return earlier == Earlier::recover;
  Question question{{},
                    fmt::format("{} of an earlier session {} not saved", counted(then.unsaved(), "command"),
                                then.unsaved() == 1 ? "was" : "were"),
                    {"recover", "discard", "show"}};
  for (;; question.above = recorded()) {
    const auto answer = choose(question);
    if (!answer) return std::nullopt;
    if (*answer < 2) return *answer == 0;
  }
}

std::string Session::State::recorded() const {
  std::string all;
  for (const Record& r : journal->records()) {
    if (r.what == Did::command) all += fmt::format("  {}\n", fmt::join(unpacked(r.text).lines, "\n  "));
    if (r.what == Did::undo) all += "  undo\n";
    if (r.what == Did::redo) all += "  redo\n";
    if (r.what == Did::save) all += "  save\n";
  }
  return all;
}

// A command can fail now, for example if a file is missing. It is left out, with its undo and redo records.
Session::State::Replayed Session::State::carry_out(std::span<const Record> records, const Killers& killers,
                                                   const std::string& now_saved) {
  Replayed out;
  // One entry for each command, standing ones first, then undone ones; nullopt if it was carried out.
  std::vector<std::optional<SetAside>> failed;
  std::size_t standing = 0, number = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Record& r = records[i];
    const auto killer = killers.find(i);
    bool keep = killer == killers.end();
    if (r.what == Did::command) {
      std::string why = keep ? again(r.text) : fmt::format("it crashes the program ({})", killer->second);
      keep = why.empty();
      failed.resize(standing++), failed.emplace_back();
      ++number;
      if (!keep) failed.back() = {fmt::format("command {} of the journal", number), unpacked(r.text), std::move(why)};
    } else if (r.what == Did::undo && keep && standing > 0) {
      if ((keep = !failed[--standing])) (void)go_back();
    } else if (r.what == Did::redo && keep && standing < failed.size()) {
      if ((keep = !failed[standing++])) (void)go_again();
    }
    if (!keep) continue;
    out.records.push_back(r);
    if (r.what != Did::save || r.text == now_saved) tally.count(r.what);
  }
  for (std::size_t i = 0; i < standing; ++i)
    if (failed[i]) out.aside.push_back(*std::move(failed[i]));
  return out;
}

// Carries out a command of the journal. Returns the reason if it fails, "" otherwise.
std::string Session::State::again(const std::string& command) {
  if (is_rewriting(command)) {
    go_in_place();
    const Answer answer = rewrite(command);
    return answer.done ? "" : why_refused(answer.why);
  }
  Step step = unpacked(command);
  CommandResult result = editor.carry_out(step);
  if (!result.done) return why_refused(result.said);
  const Status taken = take(std::move(result.after), std::move(step));
  return taken ? "" : taken.error().message;
}

Session::Answer Session::State::replay(Opening o, const std::string& base) {
  const std::string now_saved = to_string(fingerprint(o.text));
  const std::vector<Record> records = journal->records();
  Killers killers;
  Replayed replayed;
  const auto carry_out_first = [&](std::size_t n) {
    start(o, base);
    editor.keep({});  // the journal has these steps already
    replayed = carry_out(std::span(records).first(n), killers, now_saved);
    (void)Program::compile(document()).frame(document().range().first);
  };
  {
    const StartMark mark(o.name);
    while (const auto culprit = mark.found() ? find_culprit(records.size(), carry_out_first) : std::nullopt)
      if (!killers.emplace(culprit->number, culprit->how).second) break;
    carry_out_first(records.size());
  }
  if (const std::vector<SetAside>& aside = replayed.aside; !aside.empty()) {
    if (Status s = set_aside(o.name, aside); !s) return refused(s.error());
    o.said += fmt::format("warning: {}\n", set_aside_message(o.name, aside));
  }
  if (replayed.records.size() < records.size())
    if (Status s = journal->begin(fingerprint(base), replayed.records); !s) return refused(s.error());
  keep_journal();
  journal_knows = editor.steps().size(), journal_undid = editor.undone().size();
  return done(o.said + fmt::format("recovered; {} not saved yet\n", counted(tally.unsaved(), "command")));
}

}  // namespace betwixt
