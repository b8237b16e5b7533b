// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/guest.h"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace betwixt {

bool Guest::read() {
  std::array<char, chunk> bytes;
  const ssize_t n = ::recv(file, bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (n < 0) return errno == EAGAIN || errno == EINTR;
  if (n == 0) {
    half_closed = true;
    return true;
  }
  const char* from = bytes.data();
  const char* const end = from + n;
  if (skipping) {
    from = std::find(from, end, '\n');
    if (from == end) return true;
    skipping = false, ++from;
  }
  in.append(from, end);
  return true;
}

void Guest::drop(std::size_t bytes) {
  in.erase(0, bytes), seen = 0;
  if (in.empty() && in.capacity() > 2 * chunk) in = {};
}

}  // namespace betwixt
