// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/parser_messages.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace betwixt {
namespace {

constexpr std::size_t most_files = 4;
using Attached = std::array<char, CMSG_SPACE(most_files * sizeof(int))>;

msghdr message(iovec& bytes, Attached& attached, std::size_t used) {
  msghdr m{};
  m.msg_iov = &bytes, m.msg_iovlen = 1;
  if (used > 0) m.msg_control = attached.data(), m.msg_controllen = used;
  return m;
}

}  // namespace

bool say(int socket, std::string_view text, std::span<const int> files) {
  iovec bytes{const_cast<char*>(text.data()), text.size()};
  alignas(cmsghdr) Attached attached{};
  msghdr m = message(bytes, attached, files.empty() ? 0 : CMSG_SPACE(files.size_bytes()));
  if (!files.empty()) {
    cmsghdr* head = CMSG_FIRSTHDR(&m);
    head->cmsg_level = SOL_SOCKET, head->cmsg_type = SCM_RIGHTS, head->cmsg_len = CMSG_LEN(files.size_bytes());
    std::memcpy(CMSG_DATA(head), files.data(), files.size_bytes());
  }
  ssize_t n = 0;
  do n = ::sendmsg(socket, &m, MSG_NOSIGNAL);
  while (n < 0 && errno == EINTR);
  return n == static_cast<ssize_t>(text.size());
}

std::optional<ParserMessage> hear(int socket, int wait) {
  pollfd one{socket, POLLIN, 0};
  int ready = wait < 0 ? 1 : -1;
  while (wait >= 0 && (ready = ::poll(&one, 1, wait)) < 0 && errno == EINTR) {
  }
  if (ready <= 0) return std::nullopt;
  ParserMessage out;
  out.text.resize(longest_message);
  iovec bytes{out.text.data(), out.text.size()};
  alignas(cmsghdr) Attached attached{};
  msghdr m = message(bytes, attached, attached.size());
  ssize_t n = 0;
  do n = ::recvmsg(socket, &m, MSG_CMSG_CLOEXEC);
  while (n < 0 && errno == EINTR);
  for (cmsghdr* head = n > 0 ? CMSG_FIRSTHDR(&m) : nullptr; head; head = CMSG_NXTHDR(&m, head)) {
    if (head->cmsg_level != SOL_SOCKET || head->cmsg_type != SCM_RIGHTS) continue;
    for (std::size_t at = 0; at + sizeof(int) <= head->cmsg_len - CMSG_LEN(0); at += sizeof(int)) {
      int file = -1;
      std::memcpy(&file, CMSG_DATA(head) + at, sizeof file);
      out.files.emplace_back(file);
    }
  }
  if (n <= 0 || (m.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0) return std::nullopt;
  out.text.resize(static_cast<std::size_t>(n));
  return out;
}

}  // namespace betwixt
