// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes that hosts send.
#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/files.h"
#include "betwixt/picture.h"
#include "betwixt/render.h"
#include "betwixt/sent.h"
#include "exchange/shapes.h"
#include "exchange/typefaces.h"
#include "scene/document.h"
#include "server/stage.h"

namespace betwixt {
namespace {

// Does what a connection does.
std::string send(Stage& s, Imaging::Host host, const std::string& name, const std::string& bytes) {
  const std::string line = fmt::format("send {} {}", name, bytes.size());
  EXPECT_EQ(s.imaging.bytes_after(host, line), bytes.size());
  if (s.imaging.wants_bytes(host, line)) s.imaging.receive(host, bytes);
  return s.say(host, line);
}

std::string picture(const Folder& folder, std::uint8_t gray) {
  EXPECT_TRUE(write_png(folder / "made.png", Picture{8, 8, std::vector<std::uint8_t>(256, gray)}));
  return folder.get("made.png");
}

// shows: S7
TEST(Sending, APictureIsTheSameAsFromItsFile) {
  const Folder folder;
  Stage s;
  const auto host = s.imaging.arrive();
  EXPECT_TRUE(holds(send(s, host, "gray.png", picture(folder, 90)), "-gray.png\""));
  s.done(host, "create sign box texture=\"@gray.png\"");
  const auto read = [](const Document& d) { return d.scene().pictures->begin()->second; };
  const Loaded file = load_text("create sign box texture=\"made.png\"", folder / "film.bx");
  ASSERT_FALSE(has_errors(file.diagnostics));
  EXPECT_EQ(read(s.imaging.document())->rgba, read(file.document)->rgba);
  s.expect_history();
}

TEST(Sending, AFontIsTheOneOfItsFile) {
  Stage s;
  const auto host = s.imaging.arrive();
  const std::string bytes = *read_whole(font_file({"DejaVu Sans", Weight::bold}).path);
  EXPECT_TRUE(holds(send(s, host, "own.ttf", bytes), "-own.ttf\""));
  s.done(host, "create sent text text=\"Fig\" font=\"@own.ttf\"");
  s.done(host, "create bold text text=\"Fig\" weight=bold");
  const Frame frame = Program::compile(s.imaging.document()).frame(Time{0});
  ASSERT_EQ(frame.items.size(), 2U);
  const Outline sent = outline_of(*frame.items[0].shape), bold = outline_of(*frame.items[1].shape);
  ASSERT_EQ(sent.contours.size(), bold.contours.size());
  for (std::size_t i = 0; i < sent.contours.size(); ++i) EXPECT_EQ(sent.contours[i], bold.contours[i]) << i;
  s.expect_history();
}

TEST(Sending, WhatWasSetBeforeStays) {
  const Folder folder;
  Stage s;
  const auto host = s.imaging.arrive();
  send(s, host, "sign.png", picture(folder, 10));
  s.done(host, "create a box texture=\"@sign.png\"");
  send(s, host, "sign.png", picture(folder, 20));
  s.done(host, "create b box texture=\"@sign.png\"");
  EXPECT_EQ(s.imaging.document().scene().pictures->size(), 2u);
  EXPECT_FALSE(holds(s.imaging.history(), "\"@sign.png\""));
  s.expect_history();
}

TEST(Sending, AnotherServerGoesOnWithTheBytes) {
  const Folder folder;
  const std::string bytes = picture(folder, 30);
  std::string history;
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    send(s, host, "kept.png", bytes);
    send(s, host, "kept.png", bytes);
    s.done(host, "create a box texture=\"@kept.png\"");
    EXPECT_TRUE(s.imaging.sync());
    history = s.imaging.history();
  }
  const auto files = std::filesystem::directory_iterator(folder / "sent");
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
  Stage s({}, "", folder / "live.bx");
  EXPECT_EQ(s.imaging.history(), history);
  EXPECT_EQ(s.imaging.document().scene().pictures->size(), 1u);
  s.done(s.imaging.arrive(), "create b box texture=\"@kept.png\"");
}

TEST(Sending, RefusesInWords) {
  const Folder folder;
  Stage s;
  const auto host = s.imaging.arrive();
  const std::string good = picture(folder, 40);
  EXPECT_TRUE(holds(send(s, host, "cut.png", good.substr(0, good.size() / 2)), "@cut.png is broken"));
  EXPECT_TRUE(holds(send(s, host, "a.txt", "x"), "the ending of 'a.txt'"));
  EXPECT_TRUE(holds(send(s, host, "a.ttf", "x"), "@a.ttf: the font is not a font with outlines"));
  EXPECT_TRUE(holds(send(s, host, "../a.png", "x"), "cannot be the name"));
  EXPECT_FALSE(s.imaging.wants_bytes(host, "send a.png 2147483648"));
  s.refused(host, "send a.png 2147483648", "'a.png' has more than 64 MiB");
  s.refused(host, "send a.png x", "'x' is not a number of bytes");
  s.refused(host, "send", "a name and a length are missing here");
  s.refused(host, "create a box texture=\"@nothing.png\"", "nothing was sent under the name 'nothing.png'");
  s.say(host, "bundle");
  EXPECT_FALSE(s.imaging.wants_bytes(host, "send a.png 3"));
  s.say(host, "send a.png 3");
  s.refused(host, "end", "bytes cannot be sent in a bundle");
}

TEST(Sending, PromisesAreReturned) {
  Stage s;
  const std::string line = fmt::format("send a.png {}", 64 << 20);
  for (int round = 0; round < 3; ++round) {
    std::vector<Imaging::Host> hosts;
    for (int n = 0; n < 5; ++n) hosts.push_back(s.imaging.arrive());
    const auto wanted = [&](Imaging::Host h) { return s.imaging.wants_bytes(h, line); };
    EXPECT_LE(std::count_if(hosts.begin(), hosts.end(), wanted), 4);
    EXPECT_FALSE(s.imaging.wants_bytes(hosts.back(), line));
    for (const auto h : hosts) s.imaging.leave(h);
  }
  EXPECT_TRUE(s.imaging.wants_bytes(s.imaging.arrive(), line));
}

}  // namespace
}  // namespace betwixt
