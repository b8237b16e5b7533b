// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/file_watch.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>

namespace betwixt {
namespace {

void control(int epoll, int how, int file, std::uint32_t events) {
  epoll_event e{};
  e.events = events, e.data.fd = file;
  ::epoll_ctl(epoll, how, file, &e);
}

}  // namespace

FileWatch::FileWatch() : epoll_(::epoll_create1(EPOLL_CLOEXEC)), wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  add(wake_);
}
FileWatch::~FileWatch() {
  if (wake_ >= 0) ::close(wake_);
  if (epoll_ >= 0) ::close(epoll_);
}

void FileWatch::add(int file, std::uint32_t events) { control(epoll_, EPOLL_CTL_ADD, file, events); }
void FileWatch::change(int file, std::uint32_t events) { control(epoll_, EPOLL_CTL_MOD, file, events); }
void FileWatch::remove(int file) { control(epoll_, EPOLL_CTL_DEL, file, 0); }

std::span<const epoll_event> FileWatch::wait(std::span<epoll_event> room, int milliseconds) {
  const int n = ::epoll_wait(epoll_, room.data(), static_cast<int>(room.size()), milliseconds);
  const std::span<epoll_event> all = room.first(static_cast<std::size_t>(std::max(n, 0)));
  const auto woken = std::ranges::remove(all, wake_, [](const epoll_event& e) { return e.data.fd; });
  if (std::uint64_t rung; !woken.empty()) {
    [[maybe_unused]] const ssize_t ignored = ::read(wake_, &rung, sizeof rung);
  }
  return all.first(all.size() - woken.size());
}

void FileWatch::wake() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t n = ::write(wake_, &one, sizeof one);
}

}  // namespace betwixt
