// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the output to a host: texts stay in order, and long ones are sent in pieces without a copy.
#include "server/guest.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <vector>

namespace betwixt {
namespace {

class Line {  // a guest, and the other end of its socket
 public:
  Line() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    guest.file = ends[0], there = ends[1];
  }
  ~Line() { ::close(guest.file), hang_up(); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  void hang_up() {
    if (there >= 0) ::close(there);
    there = -1;
  }
  // Sends and reads until all has come.
  std::string all() {
    std::string text;
    std::vector<char> some(1 << 16);
    while (guest.waiting() > 0) {
      EXPECT_TRUE(guest.send());
      for (ssize_t n; (n = ::recv(there, some.data(), some.size(), MSG_DONTWAIT)) > 0;)
        text.append(some.data(), static_cast<std::size_t>(n));
    }
    return text;
  }
  Guest guest;
  int there = -1;
};

TEST(Guest, HearsAllInItsOrder) {
  Line line;
  std::string said;
  const auto shared = std::make_shared<const std::string>(3 << 20, 's');
  for (int i = 0; i < 500; ++i) {
    std::string text = std::to_string(i) + "\n";
    if (i % 50 == 7) text.insert(0, 100'000, static_cast<char>('a' + i / 50));
    said += text;
    line.guest.say(std::move(text));
    if (i % 100 == 9) line.guest.say(shared), said += *shared;
    if (i % 3 == 0) {
      EXPECT_TRUE(line.guest.send());
    }
  }
  EXPECT_EQ(line.guest.full(), line.guest.waiting() > Guest::most_waiting);
  const std::string heard = line.all();
  EXPECT_EQ(heard.size(), said.size());
  EXPECT_TRUE(heard == said);
  EXPECT_EQ(line.guest.waiting(), 0u);
  EXPECT_EQ(shared.use_count(), 1);  // the guest holds no copy
}

TEST(Guest, ATextThatManyHearIsNotCopied) {
  std::array<Line, 3> lines;
  const auto text = std::make_shared<const std::string>(1 << 20, 'x');
  for (Line& line : lines) line.guest.say(text);
  EXPECT_EQ(text.use_count(), 4);
}

TEST(Guest, WhoHasGoneIsNoticed) {
  Line line;
  line.hang_up();
  line.guest.say(std::string("are you there?"));
  EXPECT_FALSE(line.guest.send());
}

}  // namespace
}  // namespace betwixt
