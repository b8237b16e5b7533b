// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests long scripts. A line must find its objects without a search through all objects, with the same result. A row
// for many objects must take little memory.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/resource.h>

#include "base/work_progress.h"
#include "betwixt/language.h"
#include "commands/reader.h"
#include "support/dice.h"

namespace betwixt {
namespace {

class Busy : Dice {
 public:
  explicit Busy(std::uint64_t seed) : Dice(seed) {}
  std::vector<std::string> lines() {
    std::vector<std::string> all{"animate spin every 1t by rotate(6deg, z)",
                                 "layer sway add",
                                 "create road curve points=((0 0) (2 1) (4 0))",
                                 "create a{0..9} sphere",
                                 "create a{0..4}/b sphere",
                                 "create a0/b/c sphere",
                                 "alias some = a* road a1/*"};
    for (int i = 0; i < 60; ++i) all.push_back(line());
    return all;
  }

 private:
  std::string name() {
    const std::string root = fmt::format("{}{}", chance(4) ? "n" : "a", below(10));
    return chance(3) ? root + "/b" : root;
  }
  std::string line() {
    switch (below(14)) {
      case 0:
      case 1:
        return fmt::format("rename {} {}", name(), name());
      case 2:
      case 3:
        return fmt::format("remove {}", chance(8) ? std::string("road") : name());
      case 4:
        return fmt::format("couple {} to {}", name(), name());
      case 5:
        return fmt::format("at {}f hang {} on {}", below(50), name(), name());
      case 6:
        return fmt::format("set {}.position = \"return value('{}.position')\"", name(), name());
      case 7:
        return fmt::format("at {}f {}.position = \"return value(\\\"{}.scale\\\")\"", below(50), name(), name());
      case 8:
        return fmt::format("at {}f..{}f {}.motion R(90deg @ {})", below(20), 20 + below(20), name(), name());
      case 9:
        return fmt::format("at 1f..24f {}.position along road", name());
      case 10:
        return fmt::format("set {}.environments (spin {})", name(), name());
      case 11:
        return fmt::format("on sway at {}f {}.position (0 1 0)", below(50), name());
      case 12:
        return fmt::format("create {} sphere", name());
      default:
        return fmt::format("create {} like {}", name(), name());
    }
  }
};

// What lines say of those that follow from them.
std::vector<std::string> remarks(const Diagnostics& all) {
  std::vector<std::string> out;
  for (const Diagnostic& d : all)
    if (d.severity == Severity::notice && d.what.message.find('\'') != std::string::npos) out.push_back(d.what.message);
  return out;
}

TEST(Growing, LinesOfAScriptDoWhatLinesThatComeOneByOneDo) {
  EXPECT_TRUE(rc::check("who speaks of whom is found, whichever way", [](std::uint32_t seed) {
    const std::vector<std::string> lines = Busy(seed).lines();
    std::string text;
    Scene scene;  // each line looks at everybody
    Diagnostics said;
    ReaderState so_far;
    for (const std::string& line : lines) {
      text += line + "\n";
      Script script(scene, said, {}, so_far, Home());
      read_line(scene, script, line, "");
      so_far = script;
    }
    Scene at_once;
    Diagnostics said_at_once;
    {
      Script script(at_once, said_at_once, {});
      read_text(at_once, script, text, "");
    }
    RC_ASSERT(same(at_once, scene));
    RC_ASSERT(write(Document(std::make_shared<const Scene>(at_once))) ==
              write(Document(std::make_shared<const Scene>(scene))));
    RC_ASSERT(remarks(said_at_once) == remarks(said));
  }));
}

// Each of the row's objects is carried out alone: that must not take a list of all for each.
TEST(Growing, ARowOfManyPlacesTakesLittleMemory) {
  const auto most = [] {
    rusage r{};
    getrusage(RUSAGE_SELF, &r);
    return r.ru_maxrss;  // kB
  };
  const auto row = [](int n) {
    return load_text(fmt::format("create o{{1..{}}} sphere\no*.position\n  1f (i 0 0)\n  +1f (0 i 0)\n", n), "");
  };
  row(10);
  const long before = most();
  const Loaded film = row(5000);
  EXPECT_TRUE(film.diagnostics.empty());
  EXPECT_LT(most() - before, 200'000);
}

TEST(Growing, PlacesAreThoseOfTheBracesWhereSomeAreMissing) {
  const Loaded film = load_text("create o{2,3,5} sphere\nset o{1..5}.position (i1 i 0)\n", "");
  const Scene& s = film.document.scene();
  const auto position = [&](const char* name) {
    return std::get<Vec3>(*s.objects[s.names.find(name).index].find(fn::position)->set);
  };
  EXPECT_EQ(position("o2"), (Vec3{2, 1, 0}));
  EXPECT_EQ(position("o3"), (Vec3{3, 2, 0}));
  EXPECT_EQ(position("o5"), (Vec3{5, 3, 0}));
}

TEST(Growing, ReadingTellsHowFarItIs) {
  std::string text = "create ball sphere\n";
  while (text.size() < 1000) text += "set ball.radius 2\n";
  text += "use \"none.bx\"\n";
  const WorkProgress how_far;
  EXPECT_EQ(how_far.share(), 0);
  load_text(text, "");
  EXPECT_GT(how_far.share(), 0.9F);
  EXPECT_LE(how_far.share(), 1);
}

}  // namespace
}  // namespace betwixt
