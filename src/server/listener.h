// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where hosts connect: a Unix socket that only its owner may open, or TCP, which needs a token.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

class Listener {
 public:
  // Opens a Unix socket. Errors: range (length of the path), file (in use by another server, or no socket), machine.
  static Result<Listener> unix_socket(const std::string& path);
  // Opens a TCP port, given as "HOST:PORT" or "[::1]:0"; port 0 means any free port. Errors: range (no such address, or
  // one that other machines can reach without `anywhere`), file (in use).
  static Result<Listener> tcp(const std::string& where, bool anywhere);
  ~Listener();
  Listener(Listener&& other) noexcept;
  Listener& operator=(Listener&&) = delete;

  int file() const { return file_; }
  const std::string& name() const { return name_; }  // the address that hosts connect to
  bool asks() const { return asks_; }                // hosts must send a token
  // Returns the next connection, or -1 if there is none. Never blocks.
  int accept() const;

 private:
  Listener(int file, std::string name, bool asks) : file_(file), name_(std::move(name)), asks_(asks) {}
  int file_ = -1;
  std::string name_;
  bool asks_ = false;
  dev_t device_ = 0;  // identifies the socket file, so that the destructor removes no other
  ino_t inode_ = 0;
};

// Returns $XDG_RUNTIME_DIR/betwixt.sock, or an empty string if the variable is not set.
std::string default_socket();

// Returns a random token of 32 hexadecimal digits.
Result<std::string> new_token();
// Compares in constant time for a given length, so that timing reveals nothing.
bool same_token(std::string_view said, std::string_view token);

}  // namespace betwixt
