// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/numbered.h"

#include <fmt/format.h>

#include "betwixt/picture.h"
#include "films.h"

namespace betwixt {
namespace {

TEST(Runs, AreAsPeopleWriteThem) {
  EXPECT_EQ(runs({}), "");
  EXPECT_EQ(runs({3}), "3");
  EXPECT_EQ(runs({3, 7, 8, 9, 12, 13}), "3, 7-9, 12-13");
  std::vector<int> odd;
  for (int n = 1; n < 100; n += 2) odd.push_back(n);
  EXPECT_TRUE(runs(odd).ends_with("37, 39, …")) << runs(odd);
}

TEST_F(Film, NumbersAreOfPicturesOfThatNameOnly) {
  for (const char* name : {"frame-0007.png", "frame-0012.png", "frame-12345.png", "frame-7.png", "frame-0008.jpg",
                           "frame-00x9.png", "frame-.png", "a-frame-0003.png", "frame-99999999999.png"})
    std::ofstream(folder_ / name) << "x";
  const auto there = numbers_there(*read_output((folder_ / "frame-%04d.png").string()));
  ASSERT_TRUE(there);
  EXPECT_EQ(*there, (std::set{7, 12, 12345}));
  const auto nowhere = numbers_there(*read_output((folder_ / "no/frame-%04d.png").string()));
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ErrorCode::file);
}

// Each is in its place as soon as it is made, even where the film fails later.
TEST_F(Film, OfWhatIsMissingEachPictureIsPutInPlaceAtOnce) {
  FilmOptions o = options("f-%d.png", 9);
  o.only_missing = true, o.jobs = 1;
  std::vector<int> painted;
  const auto paint = [&](int last) {
    painted.clear();
    return make_film(o, painting([&, last](int k, Picture& out) -> Status {
                       if (k == last) return fail(ErrorCode::machine, "power cut");
                       painted.push_back(k);
                       out = plain(64, 48, {k, 0, 0});
                       return Nothing{};
                     }));
  };
  EXPECT_FALSE(paint(4));
  EXPECT_EQ(painted, (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(files(), (std::vector<std::string>{"f-1.png", "f-2.png", "f-3.png", "f-4.png"}));
  // What was made otherwise is not made anew, but said.
  ASSERT_TRUE(write_png((folder_ / "f-2.png").string(), plain(32, 48, {9, 9, 9})));
  const auto other = paint(-1);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::range);
  EXPECT_NE(other.error().message.find("f-2.png has 32x48 pixels, not 64x48"), std::string::npos);
  std::ofstream(folder_ / "f-2.png") << "x";
  fs::resize_file(folder_ / "f-3.png", fs::file_size(folder_ / "f-3.png") - 1);
  const auto made = paint(-1);
  ASSERT_TRUE(made);
  EXPECT_EQ(painted, (std::vector{1, 2, 4, 5, 6, 7, 8}));
  EXPECT_EQ(made->found, 2);
  EXPECT_EQ(made->frames, 9);
  for (int k = 0; k < 9; ++k) {
    const auto picture = read_picture((folder_ / fmt::format("f-{}.png", k + 1)).string());
    ASSERT_TRUE(picture) << k;
    EXPECT_EQ((*picture)->rgba[0], k);
  }
}

}  // namespace
}  // namespace betwixt
