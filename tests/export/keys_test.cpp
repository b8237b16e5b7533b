// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/keys.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "betwixt/pose.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

Mat4 matrix_of(const ObjectKeys& k, Time t) {
  const auto way = value_at(k.translation, t), turn = value_at(k.rotation, t), growth = value_at(k.scale, t);
  Mat4 m = translation({way[0], way[1], way[2]}) * rotation(Quat{turn[3], turn[0], turn[1], turn[2]}) *
           scaling({growth[0], growth[1], growth[2]});
  if (!k.sheared) return m;
  const auto inner = value_at(k.inner, t);
  return m * rotation(Quat{inner[3], inner[0], inner[1], inner[2]});
}

double apart(const Mat4& a, const Mat4& b) {
  double most = 0;
  for (std::size_t i = 0; i < 16; ++i) most = std::max(most, std::abs(a.m[i] - b.m[i]));
  return most;
}

std::map<std::uint32_t, const ObjectKeys*> by_object(const std::vector<ObjectKeys>& all) {
  std::map<std::uint32_t, const ObjectKeys*> out;
  for (const ObjectKeys& k : all) out[k.id.index] = &k;
  return out;
}

Mat4 world_of(const std::map<std::uint32_t, const ObjectKeys*>& all, ObjectId id, Time t) {
  const ObjectKeys& k = *all.at(id.index);
  const Mat4 m = matrix_of(k, t);
  return k.parent ? world_of(all, k.parent, t) * m : m;
}

struct Compared {
  double most = 0;
  std::string where;
  std::size_t keys = 0, baked = 0;
};

// At random times, but not where something jumps, which is told of one flick too late or too early.
Compared compare(const Document& d, const KeyOptions& options, int times, double longest) {
  const Program program = Program::compile(d);
  auto [from, until] = d.range();
  until = std::min(until, from + from_seconds(longest));
  const auto all = motion_keys(program, from, until, options);
  const auto map = by_object(all);
  Compared c;
  for (const ObjectKeys& k : all)
    for (const Channel* ch : {&k.translation, &k.rotation, &k.scale}) {
      c.keys += ch->keys();
      c.baked += ch->constant() ? 1 : static_cast<std::size_t>(d.frame_count());
    }
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> any(from.flicks, until.flicks);
  for (int i = 0; i < times; ++i) {
    const Time t{any(random)};
    const auto poses = betwixt::poses(program, t);
    for (const ObjectKeys& k : all) {
      const double off = apart(world_of(map, k.id, t), poses[k.id.index].world);
      if (off > c.most) c.most = off, c.where = fmt::format("{} at {} s", d.name(k.id), t.seconds());
    }
  }
  return c;
}

struct Named {
  LoadedFilm film;
  std::vector<ObjectKeys> all;
  Named(std::string_view text, const KeyOptions& options = {})
      : film(text),
        all(motion_keys(film.program, film.loaded.document.range().first, film.loaded.document.range().second,
                        options)) {}
  const ObjectKeys& operator[](std::string_view name) const {
    const ObjectId id = film.loaded.document.find(name);
    for (const ObjectKeys& k : all)
      if (k.id == id) return k;
    ADD_FAILURE() << "no keys of " << name;
    return all.front();
  }
};

TEST(Keys, ExamplesAreWithinATenthOfAMillimetre) {
  for (const auto& [name, longest] : std::vector<std::pair<const char*, double>>{{"bounce", 3},
                                                                                 {"four-balls", 5},
                                                                                 {"grab", 3},
                                                                                 {"limp", 3},
                                                                                 {"unfold", 3},
                                                                                 {"chain", 3},
                                                                                 {"funnel", 2},
                                                                                 {"clockwork", 3},
                                                                                 {"mirror", 3},
                                                                                 {"solar", 2},
                                                                                 {"two-stars", 0.3},
                                                                                 {"walk", 0.2}}) {
    const Loaded film = load_file(fmt::format("{}/examples/{}.bx", SOURCE_DIR, name));
    ASSERT_FALSE(has_errors(film.diagnostics)) << name;
    for (const KeyStyle style : {KeyStyle::cubic, KeyStyle::linear})
      for (const bool arcs : {true, false})
        for (const bool in_floats : {true, false}) {
          if (style == KeyStyle::linear && !arcs) continue;
          KeyOptions options;
          options.style = style, options.arcs = arcs, options.in_floats = in_floats;
          const Compared c = compare(film.document, options, 25, longest);
          EXPECT_LT(c.most, 1e-4) << name << " " << c.where;
        }
  }
}

// x = 3 t^2 - 2 t^3 and on: what is a cubic is one piece an event, and the tangents are its own.
TEST(Keys, CubicsAreTakenAsTheyAre) {
  const Named n("rate 24\nrange 1f 49f\ncreate a sphere\na.position\n  1f (0 0 0)\n  25f (1 0 0)\n  49f (5 2 0)\n");
  const Channel& c = n["a"].translation;
  ASSERT_EQ(c.pieces.size(), 2u);
  EXPECT_EQ(c.pieces[0].shape, KeyPiece::cubic);
  for (int i = 0; i <= 48; ++i) {
    const Time t = Rate{24, 1}.span(i);
    const auto said = n.film.program.read(Target{n["a"].id, 0}, t);
    EXPECT_NEAR(value_at(c, t)[0], std::get<Vec3>(said).x, 1e-12) << i;
  }
  // Where both pieces meet they are as fast.
  EXPECT_NEAR(c.pieces[0].arriving[0], c.pieces[1].leaving[0], 1e-9);
}

TEST(Keys, WhatStandsStillHasOneKeyAndWhatIsStraightTwo) {
  const Named n(
      "rate 24\nrange 1f 49f\ncreate still box\ncreate a sphere\ncreate b sphere\n"
      "a.position\n  1f (0 0 0) linear\n  13f (1 0 0) linear\n  25f (2 0 0) linear\n  49f (4 0 0)\n"
      "b.position\n  1f (0 0 0) hold\n  25f (1 0 0) hold\n");
  EXPECT_EQ(n["still"].translation.keys(), 1u);
  EXPECT_EQ(n["a"].translation.keys(), 2u);  // events on one line are one piece
  EXPECT_EQ(n["b"].translation.pieces.size(), 2u);
  EXPECT_TRUE(n["b"].translation.jumps_behind(0));
  EXPECT_EQ(n["b"].translation.pieces[1].from, (Rate{24, 1}.frame(25)));
}

TEST(Keys, AJumpTakesOneStepOfWhatAFileCanKeep) {
  KeyOptions options;
  options.in_floats = true;
  const Named n(
      "rate 24\nrange 1f 480f\ncreate b sphere\nb.position\n  1f (0 0 0) linear\n  304f (3 0 0) cut (7 0 0) linear\n  "
      "480f (9 0 0)\n",
      options);
  const auto& pieces = n["b"].translation.pieces;
  ASSERT_EQ(pieces.size(), 3u);
  const auto seconds = [](Time t) { return static_cast<float>(t.seconds()); };
  EXPECT_EQ(seconds(pieces[1].until), std::nextafter(seconds(pieces[1].from), 1e9F));
  EXPECT_LE(pieces[1].until, (Rate{24, 1}.frame(304)));  // whoever asks at the frame sees what is new
  EXPECT_LT((Rate{24, 1}.frame(304) - pieces[1].until).seconds(), 1e-6);
  EXPECT_NEAR(pieces[1].begin[0], 3, 1e-6);
  EXPECT_NEAR(pieces[1].end[0], 7, 1e-6);
}

TEST(Keys, WheelsKeepTheirTurns) {
  const Named n(
      "rate 24\nrange 1f 97f\ncreate w cylinder\nw.rotation\n  1f euler(0 0 0) linear\n  97f euler(0 0 5turn)\n");
  const Channel& c = n["w"].rotation;
  EXPECT_LT(c.keys(), 20u);
  for (int i = 0; i < 97; ++i) {
    const Time t = Rate{24, 1}.span(i);
    const double half = i / 96.0 * 5 * pi;  // of the angle
    const auto q = value_at(c, t);
    EXPECT_NEAR(std::abs(q[2] * std::sin(half) + q[3] * std::cos(half)), 1, 1e-9) << i;
  }
}

// A box that is stretched along a slanted axis: no translation, rotation and scale make it.
TEST(Keys, WhatIsShearedTurnsTwice) {
  const Named n("rate 24\nrange 1f 49f\ncreate a box\na.motion\n  1f..49f R(45deg) S(3 1 1) R(-45deg) T(2 0 0)\n");
  EXPECT_TRUE(n["a"].sheared);
  const Compared c = compare(n.film.loaded.document, {}, 50, 10);
  EXPECT_LT(c.most, 1e-4) << c.where;
}

TEST(Keys, ParentsAreKeptWhereTheyStay) {
  const Named n(
      "rate 24\nrange 1f 49f\ncreate hand group\ncreate finger box\ncreate ball sphere\n"
      "couple finger to hand\nhand.position\n  1f (0 0 0)\n  49f (3 0 0)\n"
      "ball.attachment\n  10f couple to hand keep-world\n  20f letgo\n");
  EXPECT_EQ(n["finger"].parent, n["hand"].id);
  EXPECT_EQ(n["finger"].translation.keys(), 1u);
  EXPECT_FALSE(n["ball"].parent);
}

TEST(Keys, BakedIsAKeyAFrame) {
  KeyOptions options;
  options.style = KeyStyle::baked;
  const Named n("rate 24\nrange 1f 49f\ncreate a sphere\na.position\n  1f (0 0 0)\n  49f (1 0 0)\n", options);
  EXPECT_EQ(n["a"].translation.keys(), 49u);
}

TEST(Keys, ColoursAreLight) {
  const LoadedFilm f("rate 24\nrange 1f 49f\ncreate a sphere\na.color\n  1f black linear\n  49f white\n");
  const Target color = find_targets("a.color", f.loaded.document)->front();
  const Channel c = value_keys(f.program, color, {}, from_seconds(2));
  ASSERT_EQ(c.pieces.size(), 1u);
  EXPECT_EQ(c.pieces[0].shape, KeyPiece::straight);
  EXPECT_NEAR(value_at(c, from_seconds(0.5))[1], 0.25, 1e-4);
}

}  // namespace
}  // namespace betwixt
