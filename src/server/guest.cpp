// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/guest.h"

#include <sys/socket.h>
#include <sys/uio.h>

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

bool Guest::take_bytes() {
  const std::size_t some = std::min<std::uint64_t>(awaited, in.size());
  if (wanted) sent.append(in, 0, some);
  awaited -= some, drop(some);
  return awaited == 0;
}

void Guest::say(std::string text) {
  waiting_ += text.size();
  if (open_ && open_->size() + text.size() <= chunk) {
    open_->append(text);
    return;
  }
  open_ = std::make_shared<std::string>(std::move(text));
  out_.push_back(open_);
}

void Guest::say(std::shared_ptr<const std::string> text) {
  constexpr std::size_t worth_sharing = 4096;
  if (text->size() < worth_sharing) return say(std::string(*text));
  waiting_ += text->size();
  open_.reset();
  out_.push_back(std::move(text));
}

bool Guest::send() {
  std::array<iovec, 16> pieces;
  for (std::size_t total = 0; waiting_ > 0 && total < most_sent;) {
    std::size_t count = 0, offered = total;
    for (const auto& text : out_) {
      if (count == pieces.size() || offered >= most_sent) break;
      const std::size_t from = count == 0 ? sent_ : 0, bytes = std::min(text->size() - from, most_sent - offered);
      pieces[count++] = {const_cast<char*>(text->data() + from), bytes};
      offered += bytes;
    }
    msghdr message{};
    message.msg_iov = pieces.data(), message.msg_iovlen = count;
    const ssize_t n = ::sendmsg(file, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno == EAGAIN;
    total += static_cast<std::size_t>(n), sent_ += static_cast<std::size_t>(n);
    waiting_ -= static_cast<std::size_t>(n);
    for (; !out_.empty() && sent_ >= out_.front()->size(); out_.pop_front()) sent_ -= out_.front()->size();
    if (out_.empty()) open_.reset();
  }
  return true;
}

}  // namespace betwixt
