// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests charts whose entries come and go, line charts, and that labels of charts never overlap.
#include <cmath>
#include <random>

#include "betwixt/frame.h"
#include "exchange/shapes.h"
#include "scene/extent.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

Vec3 numbers_of(const LoadedFilm& s, std::string_view target, std::string_view when) {
  return std::get<Vec3>(s.read(target, when));
}

TEST(Charts, EntriesComeAndGo) {
  const LoadedFilm s(
      "create b columns of=(2 8 4) size=(6 4) gap=0\nat 1f b/2.room 1 linear\nat 25f b/2.room 0\n"
      "create p pie of=(1 2 1)\nat 1f p/2.room 1 linear\nat 25f p/2.room 0\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(numbers_of(s, "b/1.extent", "1f").x, 2, 1e-12);
  EXPECT_NEAR(numbers_of(s, "b/1.extent", "1f").y, 1, 1e-12);
  EXPECT_NEAR(numbers_of(s, "b/1.extent", "13f").x, 2.4, 1e-12);  // 6 m for two and a half columns
  EXPECT_NEAR(numbers_of(s, "b/2.extent", "13f").x, 1.2, 1e-12);
  EXPECT_NEAR(numbers_of(s, "b/1.extent", "25f").x, 3, 1e-12);
  EXPECT_NEAR(numbers_of(s, "b/1.extent", "25f").y, 2, 1e-12);  // the largest value is 4 now
  EXPECT_NEAR(numbers_of(s, "b/3.position", "25f").x, 1.5, 1e-12);
  EXPECT_NEAR(std::get<double>(s.read("p/1.to", "1f")), pi / 2 - pi / 2, 1e-12);
  EXPECT_NEAR(std::get<double>(s.read("p/1.to", "25f")), pi / 2 - pi, 1e-12);
}

TEST(Charts, RemovedPartsLeaveNoRoom) {
  const LoadedFilm s(
      "create b columns of=(2 8 4) size=(6 4) gap=0\nremove b/2\ncreate l line-chart of=((0 2) (1 10) (4 6))\nremove "
      "l/2\n");
  EXPECT_NEAR(numbers_of(s, "b/1.extent", "1f").x, 3, 1e-12);
  EXPECT_NEAR(numbers_of(s, "b/3.position", "1f").x, 1.5, 1e-12);
  EXPECT_EQ(*std::get<Points>(s.read("l/line.points", "1f")), (std::vector<Vec3>{{0, 2, 0}, {4, 6, 0}}));
}

std::vector<Vec3> line_of(const LoadedFilm& s, std::string_view when) {
  return *std::get<Points>(s.read("l/line.points", when));
}

TEST(LineCharts, HaveAxesOfTheirOwnOrAreOnAxes) {
  const LoadedFilm own(
      "create l line-chart of=(3 1 4) keys=(\"Jan\" \"Feb\" \"Mar\") size=(6 4)\nat 1f l/Feb.value 1 linear\n"
      "at 25f l/Feb.value 8\n");
  ASSERT_TRUE(own.loaded.diagnostics.empty()) << said(own.loaded.diagnostics);
  EXPECT_EQ(line_of(own, "25f"), (std::vector<Vec3>{{0.5, 3, 0}, {1.5, 8, 0}, {2.5, 4, 0}}));
  EXPECT_NEAR(length(place(own, "l/Feb", "1f") - Vec3{0, -1, 0.01}), 0, 1e-9);  // 4 m for 4, about the middle
  EXPECT_NEAR(length(place(own, "l/Feb", "25f") - Vec3{0, 2, 0.01}), 0, 1e-9);  // for 8
  EXPECT_EQ(own.text("l/axes/x/key-Mar.text", "1f"), "Mar");
  const LoadedFilm on(
      "create ax axes x=(0 10) y=(0 5) size=(10 5) position=(1 0)\ncreate l line-chart on=ax of=((0 3) (2 4)) "
      "dots=off\n");
  ASSERT_TRUE(on.loaded.diagnostics.empty()) << said(on.loaded.diagnostics);
  EXPECT_EQ(line_of(on, "1f"), (std::vector<Vec3>{{0, 3, 0}, {2, 4, 0}}));
  EXPECT_NEAR(length(place(on, "l/2", "1f") - Vec3{-2, 1.5, 0.01}), 0, 1e-9);
  EXPECT_FALSE(on.loaded.document.find("l/axes"));
  EXPECT_EQ(std::get<bool>(on.read("l/1.display", "1f")), false);
}

TEST(LineCharts, EntriesComeAndGoAlongTheLine) {
  const LoadedFilm s("create l line-chart of=((0 2) (1 10) (4 6))\nat 1f l/2.room 1 linear\nat 25f l/2.room 0\n");
  EXPECT_EQ(line_of(s, "1f"), (std::vector<Vec3>{{0, 2, 0}, {1, 10, 0}, {4, 6, 0}}));
  EXPECT_NEAR(line_of(s, "13f")[1].y, (10 + 3) / 2.0, 1e-12);  // the line from 2 to 6 has 3 there
  EXPECT_EQ(line_of(s, "25f"), (std::vector<Vec3>{{0, 2, 0}, {4, 6, 0}}));
}

TEST(LineCharts, AreWrittenWithTheirPieces) {
  const LoadedFilm s(
      "create l line-chart of=(3 1) keys=(\"a\" \"b\")\ncreate ax axes\ncreate k line-chart on=ax of=((0 1) (2 2))\n");
  const std::string text = write(s.loaded.document);
  const auto again = load_text(text, "again.bx");
  EXPECT_TRUE(again.diagnostics.empty()) << said(again.diagnostics) << text;
  EXPECT_TRUE(again.document == s.loaded.document) << text;
}

// ---- Labels

struct Label {
  std::string text;
  Vec3 low, high;
};

// The boxes of all letters that are drawn, each text as one, as the font has them.
std::vector<Label> labels_of(const Frame& frame) {
  std::vector<Label> out;
  for (const Item& item : frame.items) {
    if (item.shape->kind != Kind::text || item.shape->text->empty()) continue;
    Extent box;
    for (const auto& ring : outline_of(*item.shape).contours)
      for (const Vec3 p : ring) box.add(transform_point(item.world, p));
    out.push_back({*item.shape->text, box.low, box.high});
  }
  return out;
}

class RandomCharts {
 public:
  explicit RandomCharts(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  std::string key() {
    static const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 WWMMmm";
    std::string out(1, letters[static_cast<std::size_t>(whole(0, 51))]);
    for (int left = whole(0, 11); left > 0; --left) out += letters[static_cast<std::size_t>(whole(0, 68))];
    return out;
  }
  std::string chart() {
    static const char* const kinds[] = {"columns", "bars", "pie", "line-chart"};
    const std::string kind = kinds[whole(0, 3)];
    const int count = whole(1, whole(0, 3) == 0 ? 40 : 10);
    const bool negative = kind != "pie" && whole(0, 2) == 0;
    const double large = std::pow(10, between(-2, 7));
    std::string values, keys;
    for (int i = 0; i < count; ++i) {
      const double value = whole(0, 9) == 0 ? 0 : large * between(negative ? -1 : 0, 1) * (whole(0, 3) == 0 ? 0.01 : 1);
      values += fmt::format("{}{:.6g}", i > 0 ? " " : "", whole(0, 2) == 0 ? std::round(value) : value);
      keys += (i > 0 ? " \"" : "\"") + key() + "\"";
    }
    std::string out = "create b " + kind + " of=(" + values + ") keys=(" + keys + ")";
    if (kind == "pie") return out + fmt::format(" radius={:.2f} hole={:.2f}\n", between(0.5, 3.5), between(0, 0.4));
    return out + fmt::format(" size=({:.2f} {:.2f})\n", between(1.5, 12), between(1, 7));
  }

 private:
  std::mt19937 random_;
};

TEST(Charts, LabelsNeverOverlap) {
  RandomCharts random(37);
  std::size_t shown = 0, wanted = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string text = "film flat\nrange 1f 2f\n" + random.chart();  // without a camera that looks at all frames
    if (i % 3 == 0) {                                                // one of its parts comes
      const Names parts = std::get<Names>(LoadedFilm(text).read("b.parts", "1f"));
      const std::string& part =
          (*parts)[static_cast<std::size_t>(random.whole(0, static_cast<int>(parts->size()) - 1))];
      text += fmt::format("at 1f {0}.room {1:.2f} linear\nat 25f {0}.room 1\n", part, random.between(0, 1));
    }
    const LoadedFilm s(text);
    const auto all = labels_of(s.frame("1f"));
    shown += all.size();
    for (const char c : text) wanted += c == '"' ? 1 : 0;  // two for each key
    for (std::size_t a = 0; a < all.size(); ++a)
      for (std::size_t b = a + 1; b < all.size(); ++b) {
        const bool apart = all[a].high.x <= all[b].low.x || all[b].high.x <= all[a].low.x ||
                           all[a].high.y <= all[b].low.y || all[b].high.y <= all[a].low.y;
        ASSERT_TRUE(apart) << all[a].text << " and " << all[b].text << " in " << i << ": " << text;
      }
  }
  RecordProperty("shown", fmt::format("{} of at least {}", shown, wanted / 2));
  EXPECT_GT(shown, wanted / 2) << "labels are there";
}

TEST(Charts, LabelsAreShortenedAndShownWhereThereIsRoom) {
  const LoadedFilm s(
      "create b columns of=(3 1 -4) keys=(\"Abracadabra\" \"Bo\" \"C\") size=(2 4)\n"
      "create c columns of=(3 1 4) keys=(\"Ann\" \"Bob\" \"Cyd\")\n");
  EXPECT_EQ(s.text("c/Ann/label.text", "1f"), "Ann");
  EXPECT_NEAR(std::get<double>(s.read("c/Ann/label.size", "1f")), 0.32, 1e-12);
  EXPECT_TRUE(s.text("b/Abracadabra/label.text", "1f").ends_with("…"));
  EXPECT_LT(numbers_of(s, "b/Bo/label.position", "1f").y, 0);
  EXPECT_GT(numbers_of(s, "b/C/label.position", "1f").y, 0);  // above a column that goes down
}

TEST(LineCharts, SayWhatIsWrong) {
  EXPECT_TRUE(mentions("create l line-chart\n", "a line-chart needs its values"));
  EXPECT_TRUE(mentions("create l line-chart of=((1 2) (3))\n", "numbers, or pairs of numbers"));
  EXPECT_TRUE(mentions("create l line-chart of=((1 2) (3 red))\n", "the values of a chart are numbers"));
  EXPECT_TRUE(mentions("create l line-chart of=(1 2) keys=(\"a\")\n", "there are 2 values and 1 keys"));
  EXPECT_TRUE(mentions("create l line-chart of=(1 2) keys=(1 2)\n", "keys are texts in quotes"));
}

}  // namespace
}  // namespace betwixt
