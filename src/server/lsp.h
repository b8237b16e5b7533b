// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What an editor asks of scripts that somebody writes, in the Language Server Protocol. Bytes in, bytes out: it knows
// no pipe and no thread.
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
  // What is said of texts when nothing else is to do is left off, for later, where `called_off` is raised meanwhile.
  explicit LanguageServer(const LoadOptions& = {}, const std::atomic<bool>* called_off = nullptr);
  ~LanguageServer();

  void come(std::string_view bytes);  // of the editor
  // Answers what has waited longest, or, where nothing waits, says what there is to say of a text. False: it was left
  // off, or there is nothing to do.
  bool work();
  bool idle() const;  // nothing waits
  // What the editor is to be told by now.
  std::string take_out();

  bool over() const;  // the editor has said `exit`
  int exit_code() const;

 private:
  std::unique_ptr<State> state_;
};

}  // namespace betwixt
