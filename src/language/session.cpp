// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/names.h"
#include "language/help.h"
#include "language/journal.h"
#include "language/line_words.h"
#include "language/looking.h"
#include "language/reader.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

using Answer = Session::Answer;

Answer done(std::string said) { return {true, false, false, std::move(said)}; }
Answer refused(const std::string& message, const std::string& hint = {}) {
  return {false, false, true, to_string(Diagnostic{Severity::error, fail(Code::name, message, hint), {}, 0})};
}
Answer refused(const Error& e) { return refused(e.message, e.hint); }

std::string count(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string_view trimmed(std::string_view s, bool both = true) {
  while (both && !s.empty() && (blank(s.front()) || s.front() == '\n')) s.remove_prefix(1);
  while (!s.empty() && (blank(s.back()) || s.back() == '\n')) s.remove_suffix(1);
  return s;
}

// Where the first logical line of a text ends, and whether it is still open there.
struct LogicalLine {
  const char* end;
  bool open = false;
};
LogicalLine logical_line(std::string_view text) {
  Cursor c(text);
  while (c.at < c.end) {
    c.space();
    if (c.at == c.end) break;
    if (*c.at == '\n') return {c.at};
    if (*c.at == '"') {
      const char* start = c.at;
      const bool block = text.substr(static_cast<std::size_t>(start - text.data())).starts_with("\"\"\"");
      std::string ignored;
      if (!c.text(ignored)) return {line_end(start, c.end), block};
      continue;
    }
    if (*c.at == '(') ++c.depth;
    if (*c.at == ')' && c.depth > 0) --c.depth;
    if (c.depth > 200) return {line_end(c.at, c.end)};
    if (c.word().empty()) ++c.at;
  }
  return {c.end, c.depth > 0};
}

bool is_verb(std::string_view word) {
  for (const auto& [verb, usage] : Reader::words())
    if (verb == word) return true;
  return false;
}

fs::path journal_path(const std::string& file) {
  if (file.empty()) return ".betwixt.journal";
  std::error_code ignored;
  const fs::path real = fs::weakly_canonical(file, ignored);  // one journal, however the script is called
  return real.parent_path() / fmt::format(".{}.journal", real.filename().string());
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::weakly_canonical(a, ignored) == fs::weakly_canonical(b, ignored);
}

}  // namespace

struct Session::State {
  // A document and what the next line must know.
  struct Point {
    Document document;
    Reader::Carried carried;
    std::string sheet;  // the line that opened the sheet; empty: none is open
  };
  struct Step {
    std::string text;
    Point after;
  };

  Doors doors;
  LoadOptions options;
  std::string file;
  std::string base_text;  // the author's
  Point base;
  std::vector<Step> steps;
  Tally tally;
  std::optional<Fingerprint> known;  // what the file held when it was last read or written; none: there was none
  std::unique_ptr<Journal> journal;
  bool looks_only = false;
  bool sheet_refused = false;  // rows below a refused line have nowhere to go
  bool ended = false;
  int lines = 0;  // that were entered

  ~State() { close(tally.unsaved() > 0); }

  const Point& now() const { return tally.at > 0 ? steps[tally.at - 1].after : base; }
  Point& now() { return tally.at > 0 ? steps[tally.at - 1].after : base; }
  const Document& document() const { return now().document; }
  const Scene& scene() const { return document().scene(); }
  std::string called() const { return file.empty() ? "this film" : fmt::format("'{}'", file); }

  void close(bool keep) {
    if (journal && !keep) journal->remove();
    journal.reset();
  }

  std::string text() const {
    std::string out = base_text;
    if (tally.at > 0 && !out.empty() && out.back() != '\n') out += '\n';
    for (std::size_t i = 0; i < tally.at; ++i) out += steps[i].text + "\n";
    return out;
  }

  // Which of the choices is answered; none where nobody answers.
  std::optional<std::size_t> choose(const std::string& question, const std::vector<std::string_view>& choices) const {
    for (std::string q = question; doors.ask;) {
      const auto answer = doors.ask(q);
      if (!answer) break;
      if (*answer == called_off) {  // the choice that changes nothing is the last, but where no choice is
        if (choices.back() == "show") break;
        return choices.size() - 1;
      }
      const std::string_view word = trimmed(*answer);
      std::optional<std::size_t> found;
      for (std::size_t i = 0; i < choices.size(); ++i)
        if (!word.empty() && choices[i].starts_with(word)) found = i;  // no two choices begin alike, but for "s…"
      for (std::size_t i = 0; i < choices.size(); ++i)
        if (choices[i] == word) return i;
      const auto begins = [&](std::string_view c) { return !word.empty() && c.starts_with(word); };
      if (std::count_if(choices.begin(), choices.end(), begins) == 1) return found;
      q = fmt::format("please answer {}: ", fmt::join(choices, ", "));
    }
    return std::nullopt;
  }

  // ---- commands

  // The line done on a copy; where it cannot be, only what there is to say.
  std::optional<Step> carry_out(const Point& from, std::string_view line, std::string& said) {
    const bool row = !from.sheet.empty() && indented(line);
    // A line that begins the text could be taken for "#!".
    const std::string before = row ? from.sheet + "\n" : "\n";
    const int above = static_cast<int>(std::count(before.begin(), before.end(), '\n'));
    const std::string source = before + std::string(line) + "\n";
    Scene scene = from.document.scene();
    Diagnostics all;
    Reader reader(scene, all, options);
    reader.carry(from.carried, file);
    reader.read_text(source, file);
    const int first = lines - static_cast<int>(std::count(line.begin(), line.end(), '\n'));
    for (Diagnostic& d : all) {
      if (d.what.place.file == file) {
        if (d.what.place.line <= above && d.what.place.line > 0 && d.severity != Severity::error) continue;
        d.what.place.file = "line";
        d.what.place.line += std::max(first, 1) - above - 1;
      }
      if (d.what.hint.empty() && d.what.message.starts_with("there is no command")) hint_word(line, d.what.hint);
      said += to_string(d);
    }
    if (has_errors(all)) return std::nullopt;
    Step step{std::string(line), {Document(std::make_shared<const Scene>(std::move(scene))), reader.carried(), {}}};
    const bool remark = line_words(line).empty();
    step.after.sheet = remark ? from.sheet : step.after.carried.sheet;
    return step;
  }

  static void hint_word(std::string_view line, std::string& hint) {
    const auto words = line_words(line);
    std::vector<std::string_view> known;
    for (const HelpEntry& e : help_entries())
      if (e.group == HelpGroup::shell || is_verb(e.word)) known.push_back(e.word);
    if (!words.empty()) hint = did_you_mean(words[0], known);
  }

  Status note_down(Did what, std::string_view text = {}) {
    return journal ? journal->append(what, text) : Status(Nothing{});
  }

  void take(Step step) {
    steps.resize(tally.at);
    steps.push_back(std::move(step));
    tally.command();
  }

  Answer command(std::string_view line) {
    if (looks_only) return only_looks();
    const bool row = indented(line) && !now().sheet.empty();
    if (indented(line) && sheet_refused)
      return refused("this row has no sheet: the line that should open it was refused");
    if (!row) line = trimmed(line);  // what is not a row must not look like one in the file
    const LogicalLine one = logical_line(line);
    if (one.end != line.data() + line.size()) return refused("one line at a time, please");
    Answer answer;
    std::optional<Step> step = carry_out(now(), line, answer.said);
    if (!step) {
      const auto words = line_words(line);
      const auto target = [&](std::size_t i) { return first_dot(words[i]) != std::string_view::npos; };
      const std::size_t verb = !words.empty() && words[0] == "at" ? 2 : 0;
      const bool list = words.size() > verb && (words[verb] == "make" || words[verb] == "edit");
      if (!row && !words.empty())
        sheet_refused = words.size() == 1 || target(0) || (words.size() == 3 && words[0] == "on" && target(2)) || list;
      answer.refused = true;
      return answer;
    }
    if (Status s = note_down(Did::command, line); !s) return not_noted(s.error());
    sheet_refused = false;
    take(std::move(*step));
    answer.done = true;
    return answer;
  }

  static Answer not_noted(const Error& e) {
    return refused("nothing is done, as the journal cannot keep it: " + e.message, "make room, then say it again");
  }
  Answer only_looks() const {
    return refused(fmt::format("another shell has {} open: this one may only look", called()));
  }

  Answer undo() {
    if (looks_only) return only_looks();
    if (tally.at == 0)
      return refused("there is nothing to undo", base_text.empty() ? "" : "this is the script as it was opened");
    if (Status s = note_down(Did::undo); !s) return not_noted(s.error());
    tally.undo(), sheet_refused = false;
    return done(fmt::format("undone: {}\n", trimmed(steps[tally.at].text)));
  }
  Answer redo() {
    if (looks_only) return only_looks();
    if (tally.at == tally.all) return refused("there is nothing to redo");
    if (Status s = note_down(Did::redo); !s) return not_noted(s.error());
    tally.redo(), sheet_refused = false;
    return done(fmt::format("done again: {}\n", trimmed(steps[tally.at - 1].text)));
  }

  // ---- files

  Answer save(const std::string& to) {
    if (looks_only) return only_looks();
    const std::string name = to.empty() ? file : to;
    if (name.empty()) return refused("this film has no name yet", "usage: save FILE, as in save film.bx");
    const bool own = !file.empty() && same_file(name, file);
    const auto there = read_script(name);
    if (!there) return refused(there.error());
    std::string question;
    if (*there && !own) question = fmt::format("File '{}' exists: overwrite? (yes/no) ", name);
    if (*there && own && known != fingerprint(**there))
      question = fmt::format("File '{}' has been changed by someone else: overwrite? (yes/no) ", name);
    if (!question.empty() && choose(question, {"yes", "no"}) != std::size_t{0})
      return {false, false, false, "not saved\n"};

    std::string said;
    std::unique_ptr<Journal> next;
    if (!own) {
      auto opened = Journal::open(journal_path(name).string());
      if (!opened && opened.error().code == Code::name)
        return refused(fmt::format("'{}' is open in another shell", name));
      if (!opened) said += fmt::format("no journal can be kept here: {}\n", opened.error().message);
      if (opened) next = *std::move(opened);
      if (next && (next->foreign() || !next->records().empty())) {
        const auto aside = next->keep_aside();
        if (!aside) return refused(aside.error());
        said += fmt::format("the journal of an earlier session with '{}' is kept as '{}'\n", name, *aside);
      }
    }
    const std::string all = text();
    const Fingerprint print = fingerprint(all);
    if (own) {  // the journal says first what will be in the file: a stop between the two is understood
      if (Status s = note_down(Did::save, to_string(print)); !s) return not_noted(s.error());
    }
    if (Status s = write_script(name, all); !s) {
      if (next) next->remove();
      return refused(s.error());
    }
    if (!own && next && !begin(*next, print)) {
      next->remove(), next.reset();
      said += "no journal can be kept here\n";
    }
    if (!own) close(false), journal = std::move(next), file = name;
    known = print;
    tally.save();
    if (!(load_text(all, file, options).document == document()))
      said += "warning: what was saved loads as another film; a file that it uses has changed or is not beside it\n";
    for (const std::string& path : plugins_for(all))
      said += fmt::format("words of a plug-in are in it: it is shown by betwixt play --load {} {}\n", path, name);
    return done(said + fmt::format("saved '{}'\n", name));
  }

  // A journal that holds the whole history.
  bool begin(Journal& j, const Fingerprint& saved) const {
    if (!j.begin(fingerprint(base_text))) return false;
    for (const Step& s : steps)
      if (!j.append(Did::command, s.text)) return false;
    for (std::size_t k = tally.at; k < tally.all; ++k)
      if (!j.append(Did::undo, {})) return false;
    return static_cast<bool>(j.append(Did::save, to_string(saved)));
  }

  // Whether what is here may be left; where nobody answers, the journal keeps it.
  enum class Leave { stay, go, keep };
  Leave leave(std::string& said, bool ends) {
    const std::size_t n = tally.unsaved();
    if (n == 0 || looks_only) return Leave::go;
    const auto answer =
        choose(fmt::format("{} {} not saved: save, discard or stay? ", count(n, "command"), n == 1 ? "is" : "are"),
               {"save", "discard", "stay"});
    if (!answer && ends) {
      said += fmt::format("{} {} not saved", count(n, "command"), n == 1 ? "is" : "are");
      said += journal ? fmt::format("; the journal keeps {}: betwixt shell {}{}--recover\n", n == 1 ? "it" : "them",
                                    file, file.empty() ? "" : " ")
                      : " and lost: no journal could be kept\n";
      return Leave::keep;
    }
    if (!answer || *answer == 2) return Leave::stay;
    if (*answer == 1) return Leave::go;
    const Answer saved = save("");
    said += saved.said;
    return saved.done ? Leave::go : Leave::stay;
  }

  Answer quit() {
    std::string said;
    const Leave how = leave(said, true);
    if (how == Leave::stay) return {false, false, false, said};
    close(how == Leave::keep);
    ended = true;
    return {true, true, false, said};
  }

  // A fresh start with a text; nothing of an earlier one stays.
  void start(const std::string& name, std::string text, std::optional<Fingerprint> print, std::string& said) {
    file = name, base_text = std::move(text), known = print;
    steps.clear();
    tally = {};
    sheet_refused = false;
    Scene scene;
    Diagnostics all;
    Reader reader(scene, all, options);
    reader.carry({}, file);
    reader.read_text(base_text, file);
    for (const Diagnostic& d : all)
      if (d.severity != Severity::notice) said += to_string(d);
    base = {Document(std::make_shared<const Scene>(std::move(scene))), reader.carried(), {}};
  }

  Answer open(const std::string& name, Earlier earlier) {
    std::optional<std::string> there;
    if (!name.empty()) {
      auto read = read_script(name);
      if (!read) return refused(read.error());
      there = *std::move(read);
      std::error_code ignored;
      const fs::path folder = fs::path(name).parent_path();
      if (!there && !folder.empty() && !fs::is_directory(folder, ignored))
        return refused(fmt::format("there is no folder '{}'", folder.string()));
    }
    std::string said;
    close(false);
    looks_only = false;
    const std::string text = there.value_or("");
    std::optional<Fingerprint> print;
    if (there) print = fingerprint(text);
    auto opened = Journal::open(journal_path(name).string());
    if (opened) {
      journal = *std::move(opened);
      const Answer found = earlier_session(name, text, print, earlier);
      if (!found.done) journal.reset();
      return found;
    }
    start(name, text, print, said);
    looks_only = opened.error().code == Code::name;
    if (looks_only)
      said += fmt::format("another shell has {} open: this one may only look\n", called());
    else
      said += fmt::format("no journal can be kept here, so a crash would lose what is not saved: {}\n",
                          opened.error().message);
    return done(said);
  }

  // What the journal holds decides how the session begins.
  Answer earlier_session(const std::string& name, const std::string& text, std::optional<Fingerprint> print,
                         Earlier earlier) {
    std::string said;
    const Fingerprint present = fingerprint(text);
    // The text that the records follow: all of the file, or what stands in it before the commands that were saved.
    std::optional<std::string> under;
    Tally then;
    if (const auto& first = journal->base()) {
      bool fits = *first == present;
      for (const Record& r : journal->records()) {
        if (r.what == Did::command) then.command();
        if (r.what == Did::undo) then.undo();
        if (r.what == Did::redo) then.redo();
        if (r.what == Did::save && r.text == to_string(present)) then.save(), fits = true;
      }
      const std::string before = text.substr(0, std::min<std::size_t>(first->size, text.size()));
      if (fits && fingerprint(before) == *first) under = before;
    }
    const auto aside = [&](const char* why) -> Status {
      const auto kept = journal->keep_aside();
      if (!kept) return kept.error();
      said += fmt::format("{}; it is kept as '{}'\n", why, *kept);
      return Nothing{};
    };
    if (journal->foreign() || (!under && !journal->records().empty())) {
      if (Status s = aside(journal->foreign() ? "the journal beside the script cannot be read"
                                              : "the journal beside the script belongs to another text of it");
          !s)
        return refused(s.error());
    } else if (journal->damaged()) {
      if (Status s = aside("the journal of an earlier session is damaged"); !s) return refused(s.error());
    }
    if (under && journal->torn() > 0) said += "the last record of the journal was torn and is left out\n";
    if (under && then.unsaved() > 0) {
      const auto recover = wanted(then, earlier);
      if (!recover)
        return {false, true, false,
                said + fmt::format("{} of an earlier session {} not saved; the journal keeps {}\n",
                                   count(then.unsaved(), "command"), then.unsaved() == 1 ? "is" : "are",
                                   then.unsaved() == 1 ? "it" : "them")};
      if (*recover) return replay(name, *under, print, text, std::move(said));
    }
    start(name, text, print, said);
    if (Status s = journal->begin(present); !s) {
      said +=
          fmt::format("no journal can be kept here, so a crash would lose what is not saved: {}\n", s.error().message);
      close(false);
    }
    if (!name.empty() && !print) said += fmt::format("'{}' is not there yet: a new film\n", name);
    return done(said);
  }

  // Recover or not; none where nobody answers.
  std::optional<bool> wanted(const Tally& then, Earlier earlier) const {
    if (earlier != Earlier::ask) return earlier == Earlier::recover;
    std::string question = fmt::format("{} of an earlier session {} not saved: recover, discard or show? ",
                                       count(then.unsaved(), "command"), then.unsaved() == 1 ? "was" : "were");
    const std::string short_question = question;
    for (;;) {
      const auto answer = choose(question, {"recover", "discard", "show"});
      if (!answer) return std::nullopt;
      if (*answer < 2) return *answer == 0;
      question.clear();
      for (const Record& r : journal->records()) {
        if (r.what == Did::command) question += "  " + r.text + "\n";
        if (r.what == Did::undo) question += "  undo\n";
        if (r.what == Did::redo) question += "  redo\n";
        if (r.what == Did::save) question += "  save\n";
      }
      question += short_question;
    }
  }

  Answer replay(const std::string& name, const std::string& under, std::optional<Fingerprint> print,
                const std::string& present, std::string said) {
    std::string ignored;
    start(name, under, print, said);
    const std::string now_saved = to_string(fingerprint(present));
    for (std::size_t i = 0; i < journal->records().size(); ++i) {
      const Record& r = journal->records()[i];
      if (r.what == Did::undo) tally.undo();
      if (r.what == Did::redo) tally.redo();
      if (r.what == Did::save && r.text == now_saved) tally.save();
      if (r.what != Did::command) continue;
      std::string why;
      if (auto step = carry_out(now(), r.text, why)) {
        take(std::move(*step));
        continue;
      }
      // A file that it needs is not there any more, say. What came before it stands; the rest is kept.
      const auto kept = journal->keep_aside();
      if (!kept) return refused(kept.error());
      said += why + fmt::format(
                        "this command of the journal cannot be carried out any more: {}\nwhat came before it is "
                        "recovered; the whole journal is kept as '{}'\n",
                        trimmed(r.text), *kept);
      if (!rewrite(i)) return refused("the journal cannot be written");
      break;
    }
    return done(said + fmt::format("recovered; {} not saved yet\n", count(tally.unsaved(), "command")));
  }

  // The journal with its first records only.
  bool rewrite(std::size_t n) {
    std::vector<Record> records = journal->records();
    records.resize(n);
    if (!journal->begin(fingerprint(base_text))) return false;
    return std::all_of(records.begin(), records.end(),
                       [&](const Record& r) { return static_cast<bool>(journal->append(r.what, r.text)); });
  }

  // ---- looking

  static Answer told(const Result<std::string>& said) { return said ? done(*said) : refused(said.error()); }

  Answer plot(std::vector<std::string> words) {
    std::string to;
    if (words.size() >= 2 && words[words.size() - 2] == "->") {
      to = words.back();
      words.resize(words.size() - 2);
    }
    if (words.size() != 1) return refused("plot draws one target or pattern", "usage: plot TARGET [-> FILE.svg]");
    if (!doors.plot) return refused("nothing can be drawn here");
    if (to.empty()) {
      std::string name = words[0];
      for (char& c : name)
        if (c == '/' || c == '*' || c == '?') c = '_';
      to = (fs::path(file).parent_path() / (name + ".svg")).string();
    }
    std::error_code ignored;
    if (fs::exists(to, ignored) && std::find(drawn.begin(), drawn.end(), to) == drawn.end() &&
        choose(fmt::format("File '{}' exists: overwrite? (yes/no) ", to), {"yes", "no"}) != std::size_t{0})
      return {false, false, false, "nothing is drawn\n"};
    if (Status s = doors.plot(document(), words[0], to); !s) return refused(s.error());
    drawn.push_back(to);
    return done(fmt::format("drawn in '{}'\n", to));
  }
  std::vector<std::string> drawn;  // own files are replaced without a question

  Answer shell_word(const std::vector<std::string>& words) {
    const std::string& w = words[0];
    const std::string argument = words.size() > 1 ? words[1] : "";
    if (w == "plot") return plot({words.begin() + 1, words.end()});
    if (words.size() > 2) return refused(fmt::format("'{}' is one word too many", words[2]));
    if (w == "help") return told(look_up(document(), argument));
    if (w == "list") return told(list_objects(document(), argument));
    if (w == "describe") return told(describe(document(), argument));
    if (w == "save") return save(argument);
    if (w == "open") return reopen(argument);
    if (w == "play") {
      if (!doors.play) return refused("nothing can be played here");
      const Status s = doors.play(document(), argument);
      return s ? done("") : refused(s.error());
    }
    if (w == "load") {
      if (argument.empty()) return refused("which plug-in?", "usage: load FILE");
      if (!doors.load) return refused("plug-ins cannot be loaded here");
      const Status s = doors.load(argument);
      return s ? done("") : refused(s.error());
    }
    if (words.size() > 1) return refused(fmt::format("'{}' is one word too many", words[1]));
    if (w == "undo") return undo();
    if (w == "redo") return redo();
    if (w == "notes") return told(list_notes(document()));
    if (w == "stop") return refused("nothing is playing", "while a film plays, q stops it");
    return quit();
  }

  Answer reopen(const std::string& name) {
    if (name.empty()) return refused("which file?", "usage: open FILE");
    const auto there = read_script(name);  // before anything is asked
    if (!there) return refused(there.error());
    if (!*there)
      return refused(fmt::format("there is no file '{}'", name), "a new film begins with: betwixt shell FILE");
    std::string said;
    if (leave(said, false) == Leave::stay) return {false, false, false, said + "not opened\n"};
    Answer answer = open(name, Earlier::ask);
    answer.said = said + answer.said;
    return answer;
  }
};

Session::Session(Doors doors, const LoadOptions& options) : state_(std::make_unique<State>()) {
  state_->doors = std::move(doors);
  state_->options = options;
}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Session::Answer Session::open(const std::string& file, Earlier earlier) { return state_->open(file, earlier); }

Session::Answer Session::enter(std::string_view line) {
  State& s = *state_;
  s.lines += 1 + static_cast<int>(std::count(line.begin(), line.end(), '\n'));
  line = trimmed(line, false);
  if (s.ended) return refused("the session is over");
  if (trimmed(line).empty()) return {};
  std::string shifted;  // a person need not indent
  if (!s.now().sheet.empty() && starts_like_time(line[0])) line = shifted = "  " + std::string(line);
  const bool row = indented(line) && (!s.now().sheet.empty() || s.sheet_refused);
  const auto words = row ? std::vector<std::string>() : line_words(trimmed(line));
  if (words.empty() || (is_verb(words[0]) && (words[0] != "notes" || words.size() > 1))) return s.command(line);
  for (const HelpEntry& e : help_entries())
    if (e.group == HelpGroup::shell && e.word == words[0]) return s.shell_word(words);
  return s.command(line);
}

bool Session::needs_more(std::string_view line) { return logical_line(line).open; }

std::vector<std::string> Session::complete(std::string_view line) const {
  const Document& d = document();
  const std::size_t blank_at = line.find_last_of(" \t,(=");
  const std::string_view last = blank_at == std::string_view::npos ? line : line.substr(blank_at + 1);
  const auto words = line_words(line.substr(0, line.size() - last.size()));
  const bool row = !state_->now().sheet.empty() && !line.empty() && (indented(line) || starts_like_time(line[0]));
  std::vector<std::string> all;
  if (const std::size_t dot = last.find('.'); dot != std::string_view::npos) {
    for (const ObjectId id : select(d.scene(), last.substr(0, dot)))
      for (const auto f : function_names(d.scene(), d.scene().objects[id.index].kind))
        all.push_back(fmt::format("{}.{}", last.substr(0, dot), f));
  } else {
    const bool first = words.empty() && !row;
    const std::string verb = words.empty() ? "" : words[0];
    for (const HelpEntry& e : help_entries()) {
      const bool verb_word = e.group == HelpGroup::shell || (e.group == HelpGroup::verb && is_verb(e.word));
      const bool in_list = row && (state_->now().sheet.starts_with("edit ") || state_->now().sheet.starts_with("at "));
      const bool fits = in_list            ? e.group == HelpGroup::row && words.empty()
                        : verb == "help"   ? e.group != HelpGroup::verb || is_verb(e.word)
                        : first            ? verb_word
                        : verb == "create" ? e.group == HelpGroup::kind && words.size() == 2
                        : row || verb == "at" || verb == "twerper"
                            ? e.group == HelpGroup::twerper || (verb == "at" && words.size() == 2 && verb_word)
                            : false;
      if (fits) all.emplace_back(e.word);
    }
    if (verb != "help" && !(verb == "create" && words.size() < 3))
      for (const std::string& name : d.names()) all.push_back(name);
    const auto own = [&](Role role) {
      for (const NamedProcedure& p : *d.scene().procedures)
        if (p.role == role) all.push_back(p.name);
    };
    if (row || verb == "at" || verb == "twerper") own(Role::twerper);
    if (verb == "filter" && words.size() == 2) {
      all = {"none"};
      for (const FilterSpec& f : built_in_filters()) all.emplace_back(f.name);
      own(Role::filter);
    }
    if (verb == "save" || verb == "open" || verb == "use" || verb == "load") {
      all.clear();
      std::error_code why;
      for (const auto& e : fs::directory_iterator(".", why)) all.push_back(e.path().filename().string());
    }
  }
  std::erase_if(all, [&](const std::string& w) { return !w.starts_with(last); });
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

const Document& Session::document() const { return state_->document(); }
const std::string& Session::file() const { return state_->file; }
std::size_t Session::unsaved() const { return state_->tally.unsaved(); }
bool Session::may_change() const { return !state_->looks_only; }
std::string Session::text() const { return state_->text(); }

}  // namespace betwixt
