// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt lsp: a language server on standard input and output. One thread reads, so that new input can interrupt
// background checks of a text. The other one does all the work.
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <string>
#include <thread>

#include "app/command.h"
#include "app/subcommand.h"
#include "base/files.h"
#include "lsp/language_server.h"

namespace betwixt {
namespace {

// Input that has arrived but is not taken yet.
class Inbox {
 public:
  const std::atomic<bool>& any() const { return any_; }

  // Reads until the end of the input.
  void read_all() {
    std::array<char, 65536> bytes;
    for (;;) {
      const ssize_t n = ::read(STDIN_FILENO, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      const std::lock_guard lock(mutex_);
      if (n > 0) bytes_.append(bytes.data(), static_cast<std::size_t>(n));
      if (n <= 0) ended_ = true;
      if (n > 0) any_ = true;
      came_.notify_one();
      if (n <= 0) return;
    }
  }

  // Takes the input; with `wait`, waits until there is some. Returns false if it waited and the input has ended.
  bool take(std::string& out, bool wait) {
    std::unique_lock lock(mutex_);
    if (wait) came_.wait(lock, [&] { return any_ || ended_; });
    out = std::exchange(bytes_, {});
    any_ = false;  // after the end, nothing new interrupts the work on what came before
    return !wait || !ended_ || !out.empty();
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::string bytes_;
  bool ended_ = false;
  std::atomic<bool> any_ = false;
};

struct LspCall {
  bool stdio = false;
};

int lsp(const LspCall&) {
  std::signal(SIGPIPE, SIG_IGN);     // a client that stops reading ends the input too
  static Inbox& inbox = *new Inbox;  // never freed, because the thread may still wait on it at exit
  std::thread([] { inbox.read_all(); }).detach();
  LanguageServer server(load_options(), &inbox.any());
  std::string bytes;
  for (bool did = false; !server.over();) {
    if (!inbox.take(bytes, !did)) break;
    server.come(bytes);
    did = server.work();
    if (const std::string out = server.take_out(); !out.empty() && write_all(STDOUT_FILENO, out) != 0) break;
  }
  return server.exit_code();
}

const Enlisted enlisted_lsp(lsp, [](LspCall& call) -> Subcommand {
  return {.rank = 105,
          .name = "lsp",
          .sentence = "runs the language server for editors, on standard input and output",
          .takes = {{.name = "--stdio",
                     .sentence = "has no effect; some editors pass it",
                     .into = &call.stdio,
                     .hidden = true}},
          .example = "betwixt lsp",
          .manual =
              "An editor starts the server and talks to it by the Language Server Protocol. The server offers errors "
              "and warnings while you type, completion, help, definitions, references, renaming, colours, folding "
              "and tidying. It runs no other programs, and reads only the files that the scripts may read."};
});

}  // namespace
}  // namespace betwixt
