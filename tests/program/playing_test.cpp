// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the loops of an evaluator with every instruction set of this processor. The bits must be those of the plain
// functions for one object, and the values those of polynomials that are summed in another way.
#include "program/playing.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstring>
#include <random>

#include "program/placing.h"

namespace betwixt {
namespace {

template <class F>
void on_every_machine(F&& f) {
  for (const std::int64_t kind : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(kind);
    hwy::GetChosenTarget().Update(kind);
    SCOPED_TRACE(hwy::TargetName(kind));
    f();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

struct Numbers {
  explicit Numbers(std::size_t count, double largest = 10) {
    std::uniform_real_distribution<double> any(-largest, largest);
    for (std::size_t i = 0; i < count; ++i) all.push_back(any(random));
  }
  std::mt19937_64 random{5};
  std::vector<double> all;
};

bool same_bits(const void* a, const void* b, std::size_t bytes) { return std::memcmp(a, b, bytes) == 0; }

TEST(Playing, PlacesManyAsOneIsPlaced) {
  for (const bool orientation : {false, true}) {
    Numbers n(16 * 100 + 4);
    // Angles that the library takes over, and none at all.
    for (const auto& [at, x] :
         {std::pair(3, 2e6), {3 + 16 * 9, 1e300}, {4 + 16 * 70, std::nan("")}, {20, 0.0}, {21, -0.0}})
      n.all[static_cast<std::size_t>(at)] = x;
    std::vector<playing::Offsets> offsets;
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t k = 0; k < 100; ++k) {
      offsets.push_back({16 * k, 16 * k + 3, 16 * k + 7, 16 * k + 10, orientation});
      if (k % 3 != 1) nodes.push_back(k);
    }
    nodes.resize(playing::block - 3);  // not whole lanes
    on_every_machine([&] {
      std::vector<playing::Own> owns(nodes.size());
      playing::place(offsets.data(), nodes, n.all.data(), owns.data());
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        Node node;
        const playing::Offsets& o = offsets[nodes[k]];
        node.position = o.position, node.rotation = o.rotation, node.scale = o.scale, node.pivot = o.pivot;
        node.orientation = orientation;
        const Placed want = own_place(said_by(node, n.all.data()));
        if (!(want.world == want.world)) continue;  // no number has any bits
        for (int c = 0; c < 4; ++c)
          EXPECT_TRUE(same_bits(&owns[k].m[3 * c], &want.world.m[static_cast<std::size_t>(4 * c)], 24)) << k;
        EXPECT_TRUE(same_bits(&owns[k].turn, &want.turn, sizeof(Quat))) << k;
      }
    });
  }
}

TEST(Playing, FollowsAsOneHangs) {
  Numbers n(12 * 50 + 3);
  std::vector<playing::Link> links;
  for (std::uint32_t k = 1; k < 50; ++k) links.push_back({k, (k - 1) / 3, 12 * 50, true});
  std::vector<playing::Own> owns(50);
  for (std::size_t k = 0; k < 50; ++k) std::copy_n(&n.all[12 * k], 12, owns[k].m);
  CompiledSpan coupled;
  coupled.kind = AttachmentKind::couple, coupled.parent = 0;
  std::vector<Placed> want(50);
  for (std::uint32_t k = 0; k < 50; ++k) {
    Placed own;
    for (int c = 0; c < 4; ++c)
      for (int i = 0; i < 3; ++i) own.world(i, c) = owns[k].m[3 * c + i];
    want[k] = k == 0 ? own : hang(own, vec3(&n.all[12 * 50]), &coupled, nullptr, &want[(k - 1) / 3]);
  }
  on_every_machine([&] {
    std::vector<Mat4> worlds(50);
    worlds[0] = want[0].world, worlds[7] = want[7].world;
    playing::Marks changed(50);
    playing::follow(links, n.all.data(), owns.data(), worlds.data(), changed);
    for (std::size_t k = 0; k < 50; ++k) EXPECT_TRUE(same_bits(&worlds[k], &want[k].world, sizeof(Mat4))) << k;
    EXPECT_EQ(changed.all().size(), 48u);  // all but the root and the one that was right already
    EXPECT_EQ(changed[7], 0);
  });
}

TEST(Playing, PlaysTheSegmentsThatItIsIn) {
  Numbers n(64);
  std::vector<playing::Segment> segments(6);
  std::vector<std::uint32_t> which;
  for (std::uint32_t k = 0; k < 6; ++k) {
    playing::Segment& s = segments[k];
    for (auto& power : s.c)
      for (double& c : power) c = n.all[n.random() % 64];
    s.from = 100 * k, s.until = 100 * k + 250, s.length = 250;
    s.offset = 4 * k, s.node = k / 2, s.channels = static_cast<std::uint8_t>(1 + k % 3), s.affects = 4;
    s.bounded = k == 3;
    if (k == 2) s.ease = ease_of(*find_twerper("ease-in-out"));
    which.push_back(k);
  }
  on_every_machine([&] {
    std::vector<double> numbers(32, 77.0);
    playing::Marks marks(3);
    std::vector<std::uint32_t> left(6);
    left.resize(playing::play(segments.data(), which, 310, numbers.data(), marks, left.data()));
    EXPECT_EQ(left, (std::vector<std::uint32_t>{0, 3, 4, 5}));  // over, bounded, not begun
    for (std::uint32_t k = 0; k < 6; ++k)
      for (std::uint32_t c = 0; c < 4; ++c) {
        const bool played = (k == 1 || k == 2) && c < segments[k].channels;
        const double u = k == 2 ? ease_of(*find_twerper("ease-in-out"))->at(0.44) : (310.0 - 100 * k) / 250;
        const double* at = segments[k].c[0] + c;
        const double want = played ? at[0] + at[4] * u + at[8] * u * u + at[12] * u * u * u : 77.0;
        EXPECT_NEAR(numbers[4 * k + c], want, 1e-12) << k << " " << c;
        if (played) {
          EXPECT_EQ(numbers[4 * k + c], segments[k].at(c, segments[k].share(310)));
        }
      }
    EXPECT_EQ(std::vector<std::uint32_t>(marks.all().begin(), marks.all().end()), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(marks[1], 4);
  });
}

TEST(Playing, MarksComeInOrder) {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t end : {40u, 100u, 10000u}) {
    playing::Marks marks(10000);
    for (const std::uint32_t one : {70u, 3u, 12u, 3u, 39u, 9999u}) marks.add(one, 1);
    marks.take_back(12), marks.take_back(13);
    marks.in_order(end, out);
    std::vector<std::uint32_t> want;
    for (const std::uint32_t one : {3u, 39u, 70u, 9999u})
      if (one < end) want.push_back(one);
    EXPECT_EQ(out, want) << end;
    marks.clear();
    EXPECT_TRUE(marks.all().empty());
    EXPECT_EQ(marks[3], 0);
  }
  // What nothing can be seen of, as code of a function of one's own, is no mark: there are as many places as nodes.
  playing::Marks two(2);
  for (int k = 0; k < 5; ++k) two.add(1, 0);
  EXPECT_TRUE(two.all().empty());
}

}  // namespace
}  // namespace betwixt
