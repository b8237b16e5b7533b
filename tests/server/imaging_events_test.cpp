// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the events that hosts get after a subscription.
#include "server/stage.h"

namespace betwixt {
namespace {

TEST(Imaging, TellsThoseWhoAsked) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  s.done(a, "subscribe changes notes");
  EXPECT_TRUE(s.imaging.frames_wanted());
  s.done(b, "create ball sphere");
  s.done(b, "at 1s note \"there\"");
  auto told = s.imaging.events();
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].to, a);
  EXPECT_EQ(*told[0].line, "{\"event\":\"change\",\"tick\":0,\"host\":2,\"commands\":\"create ball sphere\"}\n");
  s.imaging.shown({{1, Time{}, 0, {}}});
  EXPECT_TRUE(s.imaging.events().empty());
  s.imaging.shown({{30, from_seconds(1.2), 0, {}}});
  told = s.imaging.events();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(*told[0].line, "{\"event\":\"note\",\"seconds\":1,\"note\":\"there\"}\n");
  s.imaging.shown({{31, from_seconds(1.3), 0, {}}});
  EXPECT_TRUE(s.imaging.events().empty());
  s.done(a, "unsubscribe");
  s.done(b, "subscribe frames");
  s.imaging.shown({{31, from_seconds(1.25), 1500, {}}});
  told = s.imaging.events();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(*told[0].line, "{\"event\":\"frame\",\"frame\":31,\"seconds\":1.25,\"late\":1.5}\n");
}

// What touches is told to whoever asked, as the time goes by. (C148, C150)
// shows: C149 C150 C151
TEST(Imaging, TellsOfContacts) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  for (const char* line :
       {"create ball sphere", "create wall box position=(5 0 0)", "create eye camera position=(0 0 20)",
        "ball.position", "  0t (0 0 0)", "  30t (5 0 0) linear", "set ball.color red"})
    s.done(b, line);
  s.done(a, "subscribe contacts");
  std::string told;
  for (int t = 0; t <= 30; ++t) {
    s.imaging.shown({{t + 1, from_seconds(t / 30.0), 0, {}}});
    for (const auto& e : s.imaging.events()) {
      told += *e.line;
      EXPECT_EQ(e.to, a);
    }
  }
  EXPECT_TRUE(holds(told, "{\"event\":\"view\",\"object\":\"ball\",\"state\":\"in\",\"tick\":0}\n")) << told;
  EXPECT_TRUE(holds(told, "{\"event\":\"contact\",\"state\":\"begin\",\"a\":\"ball\",\"b\":\"wall\",")) << told;
  s.done(b, "subscribe contacts");  // is told what holds already
  s.imaging.shown({{31, from_seconds(1.0), 0, {}}});
  EXPECT_EQ(s.imaging.events().size(), 2u);
}

// While contacts are looked for the others go on: a frame may come, whoever wanted to know may leave, and somebody else
// may begin to want to.
TEST(Imaging, FramesAreToldInTheirOrderWhateverComesBetween) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  auto c = s.imaging.arrive();
  s.done(b, "create s{1..400} sphere");  // all in one place: that takes long
  s.done(b, "create eye camera position=(0 0 20)");
  s.done(a, "subscribe frames");
  s.done(c, "subscribe contacts");
  int number = 1, looked = 0;
  s.imaging.shown({{number, Time{}, 0, {}}});
  s.imaging.events();
  (void)s.imaging.program();
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim) {
    if (++looked <= 6) {
      const int next = number + 1 + looked;
      s.imaging.shown({{next, from_seconds(next / 30.0), 0, {}}});
      s.imaging.leave(c);
      c = s.imaging.arrive();
      EXPECT_TRUE(holds(s.say(c, "subscribe contacts"), "true"));
    }
    work();
    return true;
  });
  std::vector<std::string> frames;
  for (int round = 0; round < 4; ++round) {
    number = 10 * (round + 1);
    s.imaging.shown(
        {{number, from_seconds(number / 30.0), 0, {}}, {number + 1, from_seconds((number + 1) / 30.0), 0, {}}});
    for (const auto& e : s.imaging.events())
      if (e.to == a) frames.push_back(e.line->substr(0, e.line->find(",\"seconds")));
  }
  EXPECT_GT(looked, 0);
  ASSERT_GT(frames.size(), 4u);
  const auto number_of = [](const std::string& line) { return std::stoi(line.substr(line.rfind(':') + 1)); };
  for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_GT(number_of(frames[i]), number_of(frames[i - 1]));
}

}  // namespace
}  // namespace betwixt
