// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The files of a session: the saved script, and the journal of the unsaved steps.
#include <algorithm>
#include <filesystem>

#include "base/counted.h"
#include "commands/plugins.h"
#include "editor/describe.h"
#include "editor/session_state.h"

namespace betwixt {
namespace {

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored);
}

}  // namespace

void Session::State::close(bool keep) {
  if (journal && !keep) journal->remove();
  journal.reset();
}

Status Session::State::write_down(Did what, std::string_view text) {
  const Status s = journal ? journal->append(what, text) : Status(Nothing{});
  if (s) return s;
  return fail(s.error().code, "the command was not run, because the journal cannot be written: " + s.error().message,
              s.error().hint.empty() ? "free some disk space, then repeat the command" : s.error().hint);
}

// From here on, the journal gets each step before it is taken.
void Session::State::keep_journal() {
  editor.keep([this](Did what, const Step& step) { return write_step(what, step); });
}

// After a save in place, the file is no longer the base of the older steps. So an undo or redo of one of them is
// recorded as the lines that it changes.
Status Session::State::write_step(Did what, const Step& step) {
  const auto say = [&](Did did, const std::string& text) { return write_down(did, text); };
  const auto text_of_it = [&] { return journal && what == Did::command ? packed(step) : ""; };
  if (!in_place) return say(what, text_of_it());
  std::size_t& from = what == Did::undo ? journal_knows : journal_undid;
  std::size_t& to = what == Did::undo ? journal_undid : journal_knows;
  if (what == Did::command) {
    if (Status s = say(what, text_of_it()); !s) return s;
    ++journal_knows, journal_undid = 0;
    return Nothing{};
  }
  if (from > 0) {
    if (Status s = say(what, ""); !s) return s;
    --from, ++to;
    return Nothing{};
  }
  std::string after = placed().text;
  const std::size_t stand = editor.steps().size();
  what == Did::undo ? take_back(after, placed().edits[stand - 1]) : put_into(after, placed().edits[stand]);
  const LineChange c = change_between(placed().text, after);
  if (Status s = say(Did::command, rewrite_line(c.lines.first, c.lines.last, c.others)); !s) return s;
  journal_knows = journal_undid = 0;
  return Nothing{};
}

// Opens the journal of a file that becomes this session's file. Renames an old journal that still has records.
Result<std::unique_ptr<Journal>> Session::State::journal_beside(const std::string& name, std::string& said) const {
  auto opened = Journal::open(journal_path(name));
  if (!opened && opened.error().code == ErrorCode::name)
    return fail(ErrorCode::name, fmt::format("'{}' is open in another shell", name));
  if (!opened) {
    said += fmt::format("no journal can be written here: {}\n", opened.error().message);
    return std::unique_ptr<Journal>();
  }
  Journal& next = **opened;
  if (next.foreign() || !next.records().empty()) {
    const auto aside = next.keep_aside();
    if (!aside) return aside.error();
    said += fmt::format("the journal of an earlier session with '{}' is kept as '{}'\n", name, *aside);
  }
  return opened;
}

Session::Answer Session::State::save(const std::string& to) {
  if (looks_only) return only_looks();
  const std::string name = to.empty() ? file : to;
  if (name.empty()) return refused("this film has no file name yet", "usage: save FILE, as in save film.bx");
  const bool own = !file.empty() && same_file(name, file);
  const auto there = read_script(name);
  if (!there) return refused(there.error());
  std::string question;
  if (*there && !own) question = fmt::format("File '{}' already exists; overwrite it", name);
  if (*there && own && known != fingerprint(**there))
    question = fmt::format("File '{}' was changed by another program; overwrite it", name);
  if (!question.empty() && choose({{}, question, {"yes", "no"}}) != std::size_t{0})
    return {false, false, false, "not saved\n"};

  std::string said;
  std::unique_ptr<Journal> next;
  if (!own) {
    auto beside = journal_beside(name, said);
    if (!beside) return refused(beside.error());
    next = *std::move(beside);
  }
  const std::string all = text();
  const Fingerprint print = fingerprint(all);
  const bool lost = own && journal && !journal->in_place();  // moved or removed: a new one begins
  if (own && !lost) {  // the journal gets its record first, so that an interruption between the two can be recognised
    if (Status s = write_down(Did::save, to_string(print)); !s) return refused(s.error());
  }
  if (Status s = write_script(name, all); !s) {
    if (next) next->remove();
    return refused(s.error());
  }
  if (!own && next && !begin(*next, print)) {
    next->remove(), next.reset();
    said += "no journal can be written here\n";
  }
  if (!own) close(false), journal = std::move(next), file = name, editor.rename(name);
  if (own && (in_place || lost) && journal && !journal->begin(print))
    said += "no journal can be written here\n", close(false);
  if (in_place) journal_knows = journal_undid = 0, editor.rename(name), read_text_again();
  known = print;
  tally.save();
  if (!(load_text(all, file, options).document == document()))
    said +=
        "warning: the saved script loads as a different film, because a file that it uses is missing or has changed\n";
  for (const std::string& path : plugins_for(all))
    said += fmt::format("it uses a plug-in; to show it: betwixt play --load {} {}\n", path, name);
  return done(said + fmt::format("saved '{}'\n", name));
}

// Writes the whole history into a new journal.
bool Session::State::begin(Journal& j, const Fingerprint& saved) const {
  if (in_place) return static_cast<bool>(j.begin(saved));
  std::vector<Record> all;
  for (const auto steps : {editor.steps(), editor.undone()})
    for (const Step& s : steps) all.push_back({Did::command, packed(s)});
  all.insert(all.end(), editor.undone().size(), {Did::undo, {}});
  all.push_back({Did::save, to_string(saved)});
  return static_cast<bool>(j.begin(fingerprint(editor.base()), all));
}

// Asks whether unsaved work may be left; without an answer, the journal keeps it.
Session::State::Leave Session::State::leave(std::string& said, bool ends) {
  const std::size_t n = tally.unsaved();
  if (n == 0 || looks_only) return Leave::go;
  const auto answer = choose(
      {{}, fmt::format("{} {} not saved", counted(n, "command"), n == 1 ? "is" : "are"), {"save", "discard", "stay"}});
  if (!answer && ends) {
    said += fmt::format("{} {} not saved", counted(n, "command"), n == 1 ? "is" : "are");
    said += journal ? fmt::format("; the journal keeps {}: betwixt shell {}{}--recover\n", n == 1 ? "it" : "them", file,
                                  file.empty() ? "" : " ")
                    : " and lost, because no journal could be written\n";
    return Leave::keep;
  }
  if (!answer || *answer == 2) return Leave::stay;
  if (*answer == 1) return Leave::go;
  const Answer saved = save("");
  said += saved.said;
  return saved.done ? Leave::go : Leave::stay;
}

Session::Answer Session::State::quit(const Words&) {
  std::string said;
  const Leave how = leave(said, true);
  if (how == Leave::stay) return {false, false, false, said};
  close(how == Leave::keep);
  ended = true;
  return {true, true, false, said};
}

Session::Answer Session::State::reopen(const Words& w) {
  if (w.size() < 2) return refused("a file name is missing here", "usage: open FILE");
  const auto there = read_script(w[1]);  // read it before asking questions
  if (!there) return refused(there.error());
  if (!*there) return refused(fmt::format("there is no file '{}'", w[1]), "to begin a new film: betwixt shell FILE");
  std::string said;
  if (leave(said, false) == Leave::stay) return {false, false, false, said + "not opened\n"};
  Answer answer = open(w[1], Earlier::ask);
  answer.said = said + answer.said;
  return answer;
}

}  // namespace betwixt
