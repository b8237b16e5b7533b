// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A server for the Language Server Protocol: answers an editor's requests about scripts. Bytes in, bytes out: it knows
// neither pipes nor threads.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include "betwixt/language.h"

namespace betwixt {

class LanguageServer {
 public:
  struct State;
  // `called_off` is a cancellation token: while it is set, work() stops publishing diagnostics and does so later.
  explicit LanguageServer(const LoadOptions& = {}, const std::atomic<bool>* called_off = nullptr);
  ~LanguageServer();

  void come(std::string_view bytes);  // from the editor
  // Answers the oldest request. If none waits, publishes the diagnostics of one text. Returns false if that was
  // cancelled or there is nothing to do.
  bool work();
  bool idle() const;  // no message waits
  // Returns the bytes to send to the editor, and forgets them.
  std::string take_out();

  bool over() const;  // the editor has sent `exit`
  int exit_code() const;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace betwixt
