// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt shell: an interactive session at a terminal, or a script on standard input.
#include <fmt/format.h>
#include <histedit.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cwchar>
#include <deque>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/command.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/utf8.h"
#include "betwixt/session.h"
#include "editor/completion.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

struct ShellCall {
  std::string file;
  bool recover = false, discard = false, quiet = false;
};

// The source of lines. line() and answer() return nullopt at the end of the input.
class LineSource {
 public:
  virtual ~LineSource() = default;
  virtual std::optional<std::string> line(const std::string& prompt) = 0;
  virtual std::optional<std::string> answer(const std::string& question) = 0;
  virtual void push_back(std::string) {}       // lines read too early
  virtual bool called_off() { return false; }  // whether Ctrl-C cancelled the line
  virtual bool person() const { return false; }
};

// Makes control characters visible on a terminal. Files and other programs get the text unchanged.
void put(const std::string& text, std::FILE* to) {
  std::fputs((::isatty(::fileno(to)) == 1 ? visible_lines(text) : text).c_str(), to);
}

class Pipe : public LineSource {
 public:
  std::optional<std::string> line(const std::string&) override {
    std::string line;
    if (!kept_.empty()) {
      line = std::move(kept_.front());
      kept_.pop_front();
      return line;
    }
    if (!std::getline(std::cin, line)) return std::nullopt;
    return line;
  }
  std::optional<std::string> answer(const std::string& question) override {
    put(question + "\n", stdout);
    std::fflush(stdout);
    return line("");
  }
  void push_back(std::string text) override {
    std::deque<std::string> lines;
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t stop = std::min(text.find('\n', at), text.size());
      lines.push_back(text.substr(at, stop - at));
      at = stop + 1;
    }
    kept_.insert(kept_.begin(), lines.begin(), lines.end());
  }

 private:
  std::deque<std::string> kept_;
};

volatile sig_atomic_t line_cancelled = 0;

// Makes Ctrl-C interrupt only the reading of a line.
void listen_for_cancel() {
  struct sigaction action {};
  action.sa_handler = [](int) { line_cancelled = 1; };
  ::sigaction(SIGINT, &action, nullptr);  // without SA_RESTART, so that the read ends
}

// Reads one letter from the terminal. Returns 1, 0 at the end, or -1 after Ctrl-C, which the editor's own function
// would ignore.
int read_letter(wchar_t* out) {
  std::mbstate_t state{};
  for (;;) {
    char byte = 0;
    const ssize_t n = ::read(STDIN_FILENO, &byte, 1);
    if (n < 0 && errno == EINTR && !line_cancelled) continue;
    if (n <= 0) return static_cast<int>(n);
    const std::size_t used = std::mbrtowc(out, &byte, 1, &state);
    if (used == static_cast<std::size_t>(-1)) state = {};  // skips bytes that are no letter
    if (used <= 1) return 1;
  }
}

fs::path history_file() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  if (state && *state) return fs::path(state) / "betwixt/history";
  if (home && *home) return fs::path(home) / ".local/state/betwixt/history";
  return {};
}

// A terminal with line editing, history and completion.
class Keyboard : public LineSource {
 public:
  explicit Keyboard(const Session& session) : session_(session), past_(history_file()) {
    const char* locale = std::setlocale(LC_CTYPE, "");  // for letters of several bytes
    if (!locale || std::strcmp(locale, "C") == 0 || std::strcmp(locale, "POSIX") == 0)
      std::setlocale(LC_CTYPE, "C.UTF-8");
    edit_ = el_init("betwixt", stdin, stdout, stderr);
    history_ = history_init();
    HistEvent event;
    history(history_, &event, H_SETSIZE, 2000);
    history(history_, &event, H_SETUNIQUE, 1);
    std::error_code why;
    if (!past_.empty()) {
      fs::create_directories(past_.parent_path(), why);
      history(history_, &event, H_LOAD, past_.c_str());
    }
    el_set(edit_, EL_CLIENTDATA, this);
    el_set(
        edit_, EL_PROMPT, +[](EditLine* e) { return at(e).prompt_.data(); });
    el_set(
        edit_, EL_GETCFN, +[](EditLine*, wchar_t* out) { return read_letter(out); });
    el_set(edit_, EL_EDITOR, "emacs");
    el_set(edit_, EL_HIST, history, history_);
    el_set(
        edit_, EL_ADDFN, "betwixt-complete", "completes the word",
        +[](EditLine* e, int) { return static_cast<int>(at(e).complete()); });
    el_set(edit_, EL_BIND, "^I", "betwixt-complete", nullptr);
    el_set(edit_, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    el_source(edit_, nullptr);  // ~/.editrc
  }
  ~Keyboard() override {
    history_end(history_);
    el_end(edit_);
  }

  std::optional<std::string> line(const std::string& prompt) override {
    std::optional<std::string> got = read(prompt);
    if (got && !got->empty()) {
      HistEvent event;
      history(history_, &event, H_ENTER, got->c_str());
      if (!past_.empty()) history(history_, &event, H_SAVE, past_.c_str());
    }
    return got;
  }
  std::optional<std::string> answer(const std::string& question) override {
    std::optional<std::string> got = read(question);
    return called_off() ? std::string(Session::called_off) : got;
  }
  bool called_off() override { return std::exchange(cancelled_, false); }
  bool person() const override { return true; }

 private:
  static Keyboard& at(EditLine* e) {
    void* self = nullptr;
    el_get(e, EL_CLIENTDATA, &self);
    return *static_cast<Keyboard*>(self);
  }

  std::optional<std::string> read(const std::string& asked) {
    const std::string prompt = visible_lines(asked);
    // The editor's prompt has one line; print the lines above it first.
    const std::size_t nl = prompt.rfind('\n');
    if (nl != std::string::npos) fmt::print("{}", prompt.substr(0, nl + 1));
    std::fflush(stdout);
    prompt_ = nl == std::string::npos ? prompt : prompt.substr(nl + 1);
    listen_for_cancel();
    line_cancelled = 0;
    int n = 0;
    const char* got = el_gets(edit_, &n);
    if (got && n > 0) return std::string(got, static_cast<std::size_t>(n - (got[n - 1] == '\n')));
    fmt::print("\n");
    if (line_cancelled) {
      el_reset(edit_);
      cancelled_ = true;
      return std::string();
    }
    return std::nullopt;
  }

  unsigned char complete() {
    const LineInfo* line = el_line(edit_);
    const std::string before(line->buffer, line->cursor);
    const std::vector<std::string> all = session_.complete(before);
    if (all.empty()) return CC_REFRESH_BEEP;
    const std::size_t typed = before.size() - begun_word(before);
    std::string common = all.front();
    for (const std::string& w : all) {
      std::size_t n = 0;
      while (n < std::min(common.size(), w.size()) && common[n] == w[n]) ++n;
      common.resize(n);
    }
    std::string more = common.substr(std::min(typed, common.size()));
    const bool inside = line->cursor < line->lastchar && *line->cursor != ' ';  // the cursor is inside the word
    const bool open = common.ends_with('=');                                    // a value follows
    const bool dot = session_.document().find(common) && takes_target(before);
    if (all.size() == 1 && !inside && !open && !dot) more += ' ';
    if (!more.empty()) return el_insertstr(edit_, more.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    constexpr std::size_t shown = 200;
    const auto end = all.begin() + static_cast<long>(std::min(shown, all.size()));
    fmt::print("\n{}{}\n", visible(fmt::format("{}", fmt::join(all.begin(), end, "  "))),
               all.size() > shown ? fmt::format("  … {} more", all.size() - shown) : "");
    std::fflush(stdout);
    return CC_REDISPLAY;
  }

  const Session& session_;
  const fs::path past_;
  EditLine* edit_ = nullptr;
  ::History* history_ = nullptr;
  std::string prompt_;
  bool cancelled_ = false;
};

// Waits for a key. Returns 0 at the end of the input.
char pressed_key() {
  termios before{};
  if (::tcgetattr(STDIN_FILENO, &before) != 0) return 0;
  termios t = before;
  t.c_lflag &= static_cast<tcflag_t>(~(ECHO | ICANON));
  ::tcsetattr(STDIN_FILENO, TCSADRAIN, &t);
  char key = 0;
  listen_for_cancel();
  if (::read(STDIN_FILENO, &key, 1) != 1) key = 0;
  ::tcsetattr(STDIN_FILENO, TCSADRAIN, &before);
  return key;
}

// Prints text for a person, page by page if it is longer than the terminal.
void page(std::string_view text) {
  winsize w{};
  const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &w) == 0 && w.ws_row > 2;
  const std::size_t rows = known ? w.ws_row - 1 : 23;
  const auto lines = [](std::string_view s) { return static_cast<std::size_t>(std::count(s.begin(), s.end(), '\n')); };
  while (lines(text) > rows) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < rows; ++i) end = text.find('\n', end) + 1;
    std::fwrite(text.data(), 1, end, stdout);
    text.remove_prefix(end);
    fmt::print("-- {} more: space: next page, q: end --", counted(lines(text), "line"));
    std::fflush(stdout);
    const char key = pressed_key();
    fmt::print("\r\x1b[K");
    if (key == 0 || key == 'q' || key == 'Q') return;
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
}

// Reads one logical line: as long as a bracket or a """ is open, it reads more lines.
std::optional<std::string> read_line(LineSource& in, const std::string& prompt) {
  std::optional<std::string> line = in.line(prompt);
  if (!line || in.called_off()) return line ? std::optional<std::string>("") : std::nullopt;
  std::string whole = *std::move(line);
  while (Session::needs_more(whole)) {
    const std::optional<std::string> more = in.line("... ");
    if (in.called_off()) return "";
    if (!more) {  // never closed: only the first line is wrong, so push back the others
      const std::size_t nl = whole.find('\n');
      if (nl == std::string::npos) break;
      in.push_back(whole.substr(nl + 1));
      return whole.substr(0, nl);
    }
    whole += "\n" + *more;
  }
  return whole;
}

int shell(const ShellCall& call) {
  if (is_stream(call.file))
    return complain(fail(ErrorCode::range, "the shell needs a file, not standard input",
                         "to read commands from standard input: betwixt shell film.bx < lines.txt"),
                    wrong_call);
  std::unique_ptr<LineSource> in;
  Session::Callbacks callbacks;
  callbacks.ask = [&in](const Session::Question& question) { return in->answer(to_string(question)); };
  callbacks.plot = [](const Document& d, const std::string& target, const std::string& to) {
    return plot_document(d, {target}, "", to);
  };
  callbacks.load_plugin = [](const std::string& file) { return use_plugin(file); };
  PictureCall picture{{960, 540, 1}};
  const Session* open = nullptr;
  callbacks.play = [&picture](const Document& d, const std::string& frames) {
    const Status played = play_document(d, frames, picture);
    release_stops();
    return played;
  };
  callbacks.set_play_option = [&](const std::string& what, const std::string& value) {
    return change_picture(picture, open->document(), what, value);
  };
  for (const Style& s : styles()) callbacks.styles.emplace_back(s.name);
  const bool terminal = isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
  if (terminal) callbacks.ask_about_line = callbacks.ask;
  Session session(std::move(callbacks), load_options());
  open = &session;
  if (call.quiet) session.keep_quiet();
  if (terminal)
    in = std::make_unique<Keyboard>(session);
  else
    in = std::make_unique<Pipe>();
  const bool person = in->person();

  bool wrong = false;
  const auto say = [&](const Session::Answer& a, bool acknowledge) {
    wrong = wrong || a.refused;
    if (person)
      page(visible_lines(a.said));
    else
      put(a.said, a.refused ? stderr : stdout);
    if (a.done && acknowledge && !person) std::fputs("ok\n", stdout);
    std::fflush(stdout);
  };
  const Session::Answer begun = session.open(call.file, call.recover   ? Session::Earlier::recover
                                                        : call.discard ? Session::Earlier::discard
                                                                       : Session::Earlier::ask);
  say(begun, false);
  if (!begun.done) return begun.refused ? wrong_input : all_done;
  if (person) fmt::print("help lists all words, quit ends; Tab completes.\n");
  for (;;) {
    const std::string name = session.file().empty() ? "betwixt" : fs::path(session.file()).filename().string();
    const std::optional<std::string> line =
        read_line(*in, fmt::format("{}{}> ", name, session.unsaved() > 0 ? "*" : ""));
    const Session::Answer answer = session.enter(line.value_or("quit"));
    say(answer, line.has_value());
    if (answer.quit) break;
    if (!line && !person) break;  // a script has ended
  }
  return wrong && !person ? wrong_input : all_done;
}

const Enlisted enlisted_shell(shell, [](ShellCall& call) -> Subcommand {
  return {.rank = 100,
          .name = "shell",
          .sentence = "makes a film line by line, with help, undo and a journal",
          .takes = {{.name = "FILE",
                     .sentence = "the script; a new one if it does not exist",
                     .into = &call.file,
                     .offer = Offer::scripts},
                    flag("--recover", "recovers the unsaved commands of an earlier session", call.recover),
                    {.name = "--discard",
                     .sentence = "discards the unsaved commands of an earlier session",
                     .into = &call.discard,
                     .excludes = "--recover"},
                    flag("-q,--quiet", "does not print how many objects a pattern matched", call.quiet)},
          .example = "betwixt shell examples/bounce.bx",
          .manual =
              "The shell reads from a terminal, or from standard input. help lists all words. undo has no limit. "
              "save keeps your text and writes your commands below it. The shell writes each command to a journal in "
              "the folder of the script (.FILE.journal) before it answers. After a crash the next start offers to "
              "recover the commands."};
});

}  // namespace
}  // namespace betwixt
