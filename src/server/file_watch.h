// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Waits until one of many files has something to read or can be written, or until another thread wakes it.
#pragma once

#include <sys/epoll.h>

#include <cstdint>
#include <span>

namespace betwixt {

class FileWatch {
 public:
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  bool works() const { return epoll_ >= 0 && wake_ >= 0; }
  void add(int file, std::uint32_t events = EPOLLIN);
  void change(int file, std::uint32_t events);
  void remove(int file);
  // Returns what has happened, put into `room`; nothing after the milliseconds or a call of wake(). -1: waits for ever.
  std::span<const epoll_event> wait(std::span<epoll_event> room, int milliseconds);
  void wake();

 private:
  const int epoll_, wake_;
};

}  // namespace betwixt
