// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests bundles: all commands take effect, or none.
#include "server/stage.h"

namespace betwixt {
namespace {

// shows: C125 R-E14
TEST(Imaging, BundlesAreAtomic) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  for (const char* line :
       {"bundle", "create ball sphere", "ball.radius", "  1f 2", "animate spin every 2t by rotate(9deg, y)"})
    EXPECT_EQ(s.say(a, line, tick(3)), "");
  s.refused(b, "eval ball.radius", "'ball'", tick(3));
  EXPECT_EQ(s.say(a, "end", tick(5)), "{\"line\":6,\"ok\":true,\"tick\":6}\n");
  EXPECT_EQ(s.imaging.history(),
            "create ball sphere\nball.radius\n  1f 2\nat 6t animate spin every 2t by rotate(9deg, y)\n");
  s.expect_history();

  const Document before = s.imaging.document();
  for (const char* line :
       {"bundle", "set ball.radius 3", "set ball.radius many", "create ball box", "eval ball.radius"})
    EXPECT_EQ(s.say(a, line), "");
  const std::string no = s.say(a, "end");
  EXPECT_TRUE(holds(no, "\"ok\":false") && holds(no, "\"errors\":[{\"line\":9,") && holds(no, "{\"line\":10,")) << no;
  EXPECT_TRUE(s.imaging.document() == before);
  EXPECT_EQ(s.say(a, "bundle"), "");
  EXPECT_EQ(s.say(a, "bundle"), "");
  s.refused(a, "end", "a bundle is already open");
  EXPECT_EQ(s.say(a, "bundle"), "");
  EXPECT_EQ(s.say(a, std::string(Imaging::longest_line + 1, 'x')), "");
  s.refused(a, "end", "at most 1048576 bytes");

  EXPECT_EQ(s.say(a, "bundle"), "");
  EXPECT_EQ(s.say(a, "remove ball"), "");
  s.imaging.leave(a);  // dies in the middle
  EXPECT_TRUE(s.imaging.document() == before);
  s.done(b, "undo");
  s.refused(b, "eval ball.radius", "there is no object");
  s.done(b, "redo");
  EXPECT_TRUE(s.imaging.document() == before);
}

}  // namespace
}  // namespace betwixt
