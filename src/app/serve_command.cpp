// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <malloc.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <thread>

#include "app/command.h"
#include "app/subcommand.h"
#include "app/terminal.h"
#include "app/window.h"
#include "base/tell_user.h"
#include "editor/journal.h"
#include "server/serve.h"

namespace betwixt {
namespace {

struct ServeCall {
  std::string file, socket, tcp, token_file, to, save, rate, priority;
  PictureCall picture{{960, 540, 1}};
  Imaging::Options imaging;
  ServeOptions serve;
  bool anywhere = false, overwrite = false, stats = false;
};

// Shows pictures as characters in the server's terminal.
class TerminalScreen final : public Screen {
 public:
  TerminalScreen(std::unique_ptr<Terminal> terminal, std::unique_ptr<Renderer> renderer)
      : terminal_(std::move(terminal)), renderer_(std::move(renderer)) {}
  Status draw(const Evaluation& e) override {
    if (Status s = renderer_->render(e, picture_); !s) return s;
    const TerminalSize size = terminal_->size();
    if (!(size == size_)) text_ = "\x1b[2J", size_ = size;
    const Cells cells = largest_cells(size, size.rows, static_cast<double>(picture_.width) / picture_.height);
    text_ += "\x1b[?2026h" + characters(picture_, cells) + "\x1b[?2026l";
    return Nothing{};
  }
  Status show(const Shown&) override {
    if (!terminal_->write(std::exchange(text_, {}))) return fail(ErrorCode::machine, "the terminal was closed");
    return Nothing{};
  }

 private:
  std::unique_ptr<Terminal> terminal_;
  std::unique_ptr<Renderer> renderer_;
  TerminalSize size_{0, 0, 0};
  Picture picture_;
  std::string text_;
};

// Shows pictures in a window. If the user closes it the server still serves hosts, without showing frames.
class WindowScreen final : public Screen {
 public:
  WindowScreen(std::unique_ptr<Window> window, std::unique_ptr<Renderer> renderer)
      : window_(std::move(window)), renderer_(std::move(renderer)) {}
  Status draw(const Evaluation& e) override {
    if (window_->closed()) return Nothing{};
    if (Status s = renderer_->render(e, picture_); !s) return s;
    window_->draw(picture_);
    return Nothing{};
  }
  Status show(const Shown&) override {
    window_->show();
    return Nothing{};
  }

 private:
  std::unique_ptr<Window> window_;
  std::unique_ptr<Renderer> renderer_;
  Picture picture_;
};

Result<NewScreen> screen_of(const ServeCall& call, const RenderOptions& picture, Rate rate,
                            std::function<void(const Error&)> trouble) {
  if (call.to.empty() || call.to == "nowhere") return NewScreen();
  if (call.to.starts_with("film:")) return film_screen(call.to.substr(5), picture, rate, std::move(trouble));
  if (call.to.starts_with("ring:")) return ring_screen(call.to.substr(5), picture);
  if (call.to == "terminal")
    return NewScreen([picture]() -> Result<std::unique_ptr<Screen>> {
      auto renderer = make_renderer(picture);
      if (!renderer) return renderer.error();
      auto terminal = Terminal::open();
      if (!terminal) return terminal.error();
      return std::unique_ptr<Screen>(std::make_unique<TerminalScreen>(*std::move(terminal), *std::move(renderer)));
    });
  if (call.to == "window") {
    const std::string title = call.file.empty() ? "betwixt" : call.file + " - betwixt";
    return NewScreen([picture, title]() -> Result<std::unique_ptr<Screen>> {
      auto renderer = make_renderer(picture);
      if (!renderer) return renderer.error();
      auto window = Window::open(title, picture.width, picture.height);
      if (!window) return window.error();
      return std::unique_ptr<Screen>(std::make_unique<WindowScreen>(*std::move(window), *std::move(renderer)));
    });
  }
  return fail(ErrorCode::range, fmt::format("--to: \"{}\" is not an output for frames", call.to),
              "write nowhere, window, terminal, film:OUT.mp4 or ring:NAME");
}

// "120", "30000/1001"
Result<Rate> rate_of(const std::string& text, Rate otherwise) {
  if (text.empty()) return otherwise;
  long long num = 0, den = 1;
  int used = 0;
  const bool plain = std::sscanf(text.c_str(), "%9lld%n", &num, &used) == 1 && used == static_cast<int>(text.size());
  const bool ratio = !plain && std::sscanf(text.c_str(), "%9lld/%9lld%n", &num, &den, &used) == 2 &&
                     used == static_cast<int>(text.size());
  if (!plain) den = ratio ? den : 0;
  if (num < 1 || den < 1 || num > 1000 * den)
    return fail(ErrorCode::range, fmt::format("--rate: \"{}\" is not a rate", text),
                "write frames per second, as in 120 or 30000/1001");
  return Rate{num, den};
}

Result<std::string> token_of(const ServeCall& call) {
  if (call.token_file.empty()) return new_token();
  const auto text = read_script(call.token_file);
  if (!text) return text.error();
  struct stat file {};
  if (::stat(call.token_file.c_str(), &file) == 0 && (file.st_mode & (S_IRGRP | S_IROTH)) != 0)
    return fail(ErrorCode::file, fmt::format("--token-file: other users can read '{}'", call.token_file),
                fmt::format("to protect it: chmod 600 {}", call.token_file));
  std::string token = text->value_or("");
  while (!token.empty() && (token.back() == '\n' || token.back() == '\r')) token.pop_back();
  if (token.size() < 16 || token.find('\n') != std::string::npos)
    return fail(ErrorCode::file, fmt::format("--token-file: '{}' contains no token", call.token_file),
                "write one line of at least 16 characters that are hard to guess");
  return token;
}

Result<Listener> listen(const ServeCall& call) {
  if (!call.tcp.empty()) return Listener::tcp(call.tcp, call.anywhere);
  const std::string path = call.socket.empty() ? default_socket() : call.socket;
  if (path.empty())
    return fail(ErrorCode::range, "there is no default folder for sockets", "write --socket PATH or --tcp HOST:PORT");
  return Listener::unix_socket(path);
}

// Blocks the stop signals and returns a file descriptor for them, so that none is missed. All threads inherit this.
int stops() {
  ::signal(SIGPIPE, SIG_IGN);  // the reader of our output may exit
  sigset_t set;
  ::sigemptyset(&set);
  for (const int s : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&set, s);
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  return ::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
}

int serve(ServeCall& call) {
  // The memory of the longest lines and answers goes back to the system when hosts leave. Smaller pieces stay in the
  // heaps for a while: to map or unmap one takes long while other threads do so, and frames would be late.
  ::mallopt(M_MMAP_THRESHOLD, 1 << 22);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 24);
  call.serve.stop = stops();
  call.imaging.load = load_options();
  if (const auto& size = call.picture.size)
    call.imaging.contacts.aspect = static_cast<double>(size->first) / size->second;
  std::optional<Error> no_film;  // set by the film's thread; read after that thread has ended
  // The clock starts after the document is loaded; hosts can ask for its figures before.
  std::unique_ptr<FrameClock> clock;
  call.imaging.stats = [&] { return clock ? clock->stats() : std::string(); };
  call.imaging.warn = [](const std::string& what) { tell_user(fmt::format("betwixt: warning: {}\n", what)); };
  Imaging imaging(call.imaging);
  const bool goes_on =
      call.file.empty() && !call.save.empty() && !call.overwrite && ::access(call.save.c_str(), F_OK) == 0;
  const auto begun = imaging.begin(call.file, call.save, call.overwrite, monotonic_now());
  if (!begun) return complain(begun.error(), wrong_input);
  for (const Diagnostic& d : *begun)
    if (d.severity != Severity::notice) tell_user(d);
  if (has_errors(*begun)) return wrong_input;
  if (goes_on) tell_user(fmt::format("continues '{}'\n", call.save));

  const auto rate = rate_of(call.rate, imaging.document().rate());
  if (!rate) return complain(rate.error(), wrong_call);
  auto screen =
      screen_of(call, call.picture.of(imaging.document()), *rate, [&no_film](const Error& e) { no_film = e; });
  if (!screen) return complain(screen.error(), wrong_call);
  std::vector<Listener> listeners;
  if (!call.tcp.empty()) {
    auto token = token_of(call);
    if (!token) return complain(token.error(), wrong_call);
    call.serve.token = *token;
  }
  auto listener = listen(call);
  if (!listener) return complain(listener.error(), wrong_call);
  listeners.push_back(*std::move(listener));

  FrameClock::Options options;
  options.rate = *rate;
  options.screen = *std::move(screen);
  for (const Priority p : {Priority::fifo, Priority::nice, Priority::ordinary})
    if (call.priority == to_string(p)) options.priority = p;
  auto started = FrameClock::start(std::move(options));
  if (!started) return complain(started.error(), wrong_call);
  clock = *std::move(started);

  if (listeners[0].asks() && call.token_file.empty()) tell_user(fmt::format("token {}\n", call.serve.token));
  tell_user(fmt::format("serving at {}; frames at {:g} a second, class {}{}\n", listeners[0].name(), rate->per_second(),
                        to_string(clock->priority()), clock->why().empty() ? "" : " (" + clock->why() + ")"));
  // At the end, wait only for a film, which takes time to be completed.
  const bool film = call.to.starts_with("film:");
  const auto end_soon = [film] {
    std::thread([film] {
      std::this_thread::sleep_for(film ? std::chrono::seconds(60) : std::chrono::milliseconds(200));
      std::_Exit(all_done);
    }).detach();
  };
  call.serve.give_up = [&] {
    end_soon();
    listeners.clear(), clock.reset();
    std::_Exit(all_done);
  };
  const auto print_stats = [](const std::string& figures) { tell_user(figures + "\n"); };
  if (call.stats) call.serve.report = print_stats;
  const Status served = betwixt::serve(imaging, *clock, listeners, call.serve);
  if (const Status whole = served ? imaging.finish(monotonic_now()) : Status(Nothing{}); !whole)
    call.imaging.warn(whole.error().message + "; the journal beside it has all answered commands");
  if (served) end_soon();
  listeners.clear();  // hosts see the end at once, even if a worker takes long
  if (call.stats) print_stats(imaging.statistics(monotonic_now()));
  clock.reset();  // completes the film or picture
  ::close(call.serve.stop);
  if (!served) return complain(served.error(), machine_failed);
  return no_film ? complain(*no_film, wrong_call) : static_cast<int>(all_done);
}

// The limits for hosts.
std::vector<Parameter> ceiling_parameters(Imaging::Options& options) {
  Ceilings& most = options.ceilings;
  const auto ceiling = [](const char* name, const std::string& sentence, std::size_t& to) {
    return option(name, "N", fmt::format("{}; by default {}", sentence, to), &to);
  };
  return {ceiling("--ceiling", "the most environments", most.environments),
          ceiling("--objects", "the most objects, with environments and removed ones", most.objects),
          ceiling("--events", "the most events on tracks", most.events),
          ceiling("--values", "the most bytes of texts, points, lists of names, code and the contents of files",
                  most.values),
          ceiling("--history", "the most bytes of accepted commands", most.history),
          ceiling("--undo", "the most commands that can be undone", options.undo.steps),
          ceiling("--checkpoint", "the bytes of journal after which the script is rewritten", options.checkpoint)};
}

// The addresses for hosts.
std::vector<Parameter> door_parameters(ServeCall& call) {
  return {file_option("--socket", "PATH", "a socket for hosts; by default $XDG_RUNTIME_DIR/betwixt.sock", &call.socket),
          option("--tcp", "HOST:PORT", "an address for hosts, which need a token", &call.tcp, "--socket"),
          flag("--anywhere", "lets --tcp be an address that other machines can reach", call.anywhere),
          file_option("--token-file", "FILE", "a file with the token; by default a token is made and printed",
                      &call.token_file)};
}

std::vector<Parameter> clock_parameters(ServeCall& call) {
  return {{.name = "--class",
           .value = "CLASS",
           .sentence = "the scheduling class: fifo, nice or ordinary; by default the best that the system allows",
           .into = &call.priority,
           .words_only = true,
           .words = {"fifo", "nice", "ordinary"}},
          flag("--sweep", "finds contacts between two frames, too", call.imaging.sweep),
          flag("--wait", "waits at time 0 until a host sends start", call.imaging.wait),
          flag("--from-start", "starts at time 0, not where the history ended", call.imaging.from_start),
          {.name = "--latency",
           .value = "N",
           .sentence = "ticks from a command to its effect; by default 1",
           .into = &call.imaging.latency,
           .range = {{0, 1'000'000}}},
          file_option("--save", "FILE", "saves the history in this file, each command before its answer", &call.save),
          flag("--overwrite", "lets --save replace a file", call.overwrite),
          flag("--stats", "prints the server's figures as JSON, once a second and at the end", call.stats),
          {.name = "--hosts",
           .value = "N",
           .sentence = "the most hosts at the same time; by default 1000",
           .into = &call.serve.hosts,
           .range = {{1, 100'000}}}};
}

// The output and the rate of frames.
std::vector<Parameter> place_parameters(ServeCall& call) {
  return {
      {.name = "--to",
       .value = "PLACE",
       .sentence = "the output of frames: nowhere, window, terminal, film:OUT.mp4 or ring:NAME",
       .into = &call.to,
       .words = {"nowhere", "window", "terminal", "film:", "ring:"}},
      {.name = "--rate", .value = "N", .sentence = "frames per second; by default the script's", .into = &call.rate}};
}

const Enlisted enlisted_serve(serve, [](ServeCall& call) -> Subcommand {
  const Parameter file{
      .name = "FILE", .sentence = "the script to begin with", .into = &call.file, .offer = Offer::scripts};
  return {.rank = 110,
          .name = "serve",
          .sentence = "shows a film that other programs change while it runs",
          .takes = joined({{file},
                           door_parameters(call),
                           place_parameters(call),
                           picture_parameters(call.picture),
                           clock_parameters(call),
                           ceiling_parameters(call.imaging)}),
          .example = "betwixt serve examples/bounce.bx --socket /tmp/bounce.sock --to terminal",
          .manual = "Other programs send commands of the language over a socket, and get answers in JSON."};
});

}  // namespace
}  // namespace betwixt
