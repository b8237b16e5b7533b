// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where hosts come in: a socket of the file system that only its owner may open, or TCP, which asks for a token.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

class Listener {
 public:
  // Errors: file (taken by another server, no socket in its place), machine.
  static Result<Listener> unix_socket(const std::string& path);
  // "HOST:PORT", "[::1]:0"; a port of 0 is any that is free. Errors: range (no such address; one that others can
  // reach, without `anywhere`), file (taken).
  static Result<Listener> tcp(const std::string& where, bool anywhere);
  ~Listener();
  Listener(Listener&& other) noexcept;
  Listener& operator=(Listener&&) = delete;

  int file() const { return file_; }
  const std::string& name() const { return name_; }  // what hosts connect to
  bool asks() const { return asks_; }                // for a token
  // The next connection; -1: none. Never waits.
  int accept() const;

 private:
  Listener(int file, std::string name, bool asks) : file_(file), name_(std::move(name)), asks_(asks) {}
  int file_ = -1;
  std::string name_;
  bool asks_ = false;
  dev_t device_ = 0;  // of the socket that is ours to remove
  ino_t inode_ = 0;
};

// $XDG_RUNTIME_DIR/betwixt.sock; empty where there is no such folder.
std::string default_socket();

// 32 hexadecimal digits that nobody can guess.
Result<std::string> new_token();
// Takes as long for a near miss as for any other of its length.
bool same_token(std::string_view said, std::string_view token);

}  // namespace betwixt
