// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests large scenes. What an edit copies must not grow with the scene, and references to an object are found without a
// search through all objects.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>

#include "scene/mentions.h"
#include "support/objects.h"

namespace betwixt {
namespace {

Scene of_many(int n) {
  Scene s;
  for (int i = 0; i < n; ++i) add(s, fmt::format("o{}", i));
  return s;
}

TEST(NameIndex, IsAMap) {
  EXPECT_TRUE(rc::check("names are found as in a map, in copies too", [](std::uint32_t seed) {
    std::mt19937 random(seed);
    NameIndex index;
    std::map<std::string, std::uint32_t> map;
    const auto name = [&] { return fmt::format("{}{}", random() % 2 ? "n" : "a/n", random() % 600); };
    NameIndex kept;
    std::map<std::string, std::uint32_t> kept_map;
    for (std::uint32_t k = 0; k < 3000; ++k) {
      const std::string one = name();
      if (random() % 4 == 0)
        index.erase(one), map.erase(one);
      else
        index.put(one, {k}), map[one] = k;
      if (k == 1500) kept = index, kept_map = map;
    }
    const auto agree = [](const NameIndex& names, const std::map<std::string, std::uint32_t>& numbers) {
      for (int i = 0; i < 600; ++i)
        for (const char* before : {"n", "a/n"}) {
          const std::string one = fmt::format("{}{}", before, i);
          const auto at = numbers.find(one);
          if (names.find(one).index != (at == numbers.end() ? ObjectId::nothing : at->second)) return false;
        }
      return true;
    };
    RC_ASSERT(agree(index, map));
    RC_ASSERT(agree(kept, kept_map));
    RC_ASSERT(index.ever_above("a") && !index.ever_above("n"));
    RC_ASSERT(kept.same(NameIndex(kept)) && !kept.same(index));
  }));
}

// What one edit of a copy does not share with the scene before: about as much in one that is eight times as large.
TEST(Scene, WhatAnEditCopiesDoesNotGrow) {
  const auto apart = [](int n) {
    const Scene before = of_many(n);
    Scene after = before;
    set_value(after, {{static_cast<std::uint32_t>(n / 2)}, fn::radius}, 2.0);
    after.names.erase("o7"), after.names.put("p7", {7});
    return std::pair(before.objects.bytes_apart(after.objects), before.names.bytes_apart(after.names));
  };
  const auto small = apart(10'000), large = apart(80'000);
  EXPECT_LT(large.first, 2 * small.first);
  EXPECT_LT(large.second, 2 * small.second);
  EXPECT_LT(large.first + large.second, 32'000U);
}

TEST(Scene, ChangedObjectsAreFoundAmongMany) {
  const Scene before = of_many(40'000);
  Scene after = before;
  for (const std::uint32_t i : {0U, 127U, 128U, 16'383U, 16'384U, 39'999U}) set_value(after, {{i}, fn::radius}, 2.0);
  add(after, "more");
  std::vector<std::size_t> changed;
  after.objects.each_changed(before.objects, [&](std::size_t i) { changed.push_back(i); });
  EXPECT_EQ(changed, (std::vector<std::size_t>{0, 127, 128, 16'383, 16'384, 39'999, 40'000}));
  Scene again = of_many(40'000);
  set_value(again, {{5}, fn::radius}, 2.0);
  share(again, before);
  changed.clear();
  again.objects.each_changed(before.objects, [&](std::size_t i) { changed.push_back(i); });
  EXPECT_EQ(changed, std::vector<std::size_t>{5});
}

// What is said to many is prepared once, and comes to the same.
TEST(Environment, SharesWhatWasPreparedForOneLikeIt) {
  EnvironmentEvent::Animate a;
  a.motion = rotation(axis_angle({0, 0, 1}, 0.25));
  a.timing.interval = 3;
  Environment first, second, other;
  ASSERT_TRUE(first.add({0, 1, a}));
  ASSERT_TRUE(second.add({0, 2, a}, &first));
  EXPECT_EQ(first.span(0, 5)->motion, second.span(0, 5)->motion);
  a.timing.interval = 4;
  ASSERT_TRUE(other.add({0, 3, a}, &first));
  EXPECT_NE(first.span(0, 5)->motion, other.span(0, 5)->motion);
  for (const std::int64_t tick : {0, 3, 7, 100}) {
    EXPECT_EQ(first.at(0, tick), second.at(0, tick));
    EXPECT_EQ(other.count(0, tick), tick / 4);
  }
}

TEST(Mentions, NamesThoseWhoSpeakOfOne) {
  Scene s = of_many(1000);
  const auto id = [](std::uint32_t i) { return ObjectId{i}; };
  s.objects.edit(3).slot(fn::attachment).set = Attachment{AttachmentKind::couple, id(7), false};
  put_event(s, {id(4), fn::attachment}, event(0, Attachment{AttachmentKind::hang, id(7), false}));
  set_value(s, {id(5), fn::environments}, Names({"o7/spin", "o8"}));
  const ObjectId below = add(s, "o7/part");
  Mentions mentions;
  mentions.follow(s);
  using Numbers = std::vector<std::uint32_t>;
  EXPECT_EQ(mentions.of(s, {id(7)}), (Numbers{3, 4, 5}));
  EXPECT_EQ(mentions.of(s, {id(8)}), (Numbers{5}));
  EXPECT_EQ(mentions.of(s, {id(7), id(8)}), (Numbers{3, 4, 5}));
  EXPECT_EQ(mentions.of(s, {id(9)}), Numbers());
  EXPECT_EQ(mentions.below("o7"), Numbers{below.index});
  set_value(s, {id(6), fn::drive}, Names({"o9"}));  // what has changed since is seen
  mentions.follow(s);
  EXPECT_EQ(mentions.of(s, {id(9)}), Numbers{6});
}

}  // namespace
}  // namespace betwixt
