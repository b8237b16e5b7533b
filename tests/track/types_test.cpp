// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/types.h"

#include <gtest/gtest.h>

#include <random>

#include "track/operations.h"
#include "track/track.h"

namespace betwixt {
namespace {

constexpr int all_types = static_cast<int>(Type::motion) + 1;
Type type_at(int i) { return static_cast<Type>(i); }

// Some value of the type that is nothing special.
Value any_value(Type type, std::mt19937& dice) {
  const auto number = [&] { return std::uniform_real_distribution(-10.0, 10.0)(dice); };
  const Value like = row_of(type).example();
  if (std::holds_alternative<double>(like)) return number();
  if (std::holds_alternative<bool>(like)) return number() > 0;
  if (std::holds_alternative<Color>(like)) return Color{number(), number(), number()};
  if (std::holds_alternative<Angles>(like)) return Angles{{number(), number(), number()}};
  if (std::holds_alternative<Quat>(like)) return normalize(Quat{number(), number(), number(), number()});
  return type == Type::pair ? Vec3{number(), number(), 0} : Vec3{number(), number(), number()};
}

TEST(Types, HaveARowEachInTheirOrder) {
  for (int i = 0; i < all_types; ++i) {
    const TypeRow& row = row_of(type_at(i));
    EXPECT_EQ(row.type, type_at(i));
    EXPECT_FALSE(row.phrase.empty()) << i;
    EXPECT_TRUE(row.phrase == "on or off" || row.phrase.starts_with("a ") || row.phrase.starts_with("an "))
        << row.phrase;
    EXPECT_NE(row.example, nullptr) << row.phrase;
  }
  EXPECT_EQ(to_string(Type::points), "a list of points");
}

TEST(Types, AreFoundByTheirWords) {
  for (const std::string_view word : type_words()) {
    ASSERT_NE(find_type(word), nullptr) << word;
    EXPECT_EQ(find_type(word)->word, word);
  }
  EXPECT_EQ(type_words().size(), 9u);
  EXPECT_EQ(find_type("scalar"), find_type("number"));
  for (const char* none : {"", "pair", "aim", "Number", "numbe"}) EXPECT_EQ(find_type(none), nullptr) << none;
}

TEST(Types, NumbersMakeTheValueTheyCameFrom) {
  std::mt19937 dice(7);
  for (int i = 0; i < all_types; ++i) {
    const Type type = type_at(i);
    if (row_of(type).channels == 0) continue;
    for (int round = 0; round < 200; ++round) {
      const Value v = any_value(type, dice);
      double n[4] = {99, 99, 99, 99};
      const int count = to_numbers(v, n);
      EXPECT_EQ(value_of_numbers(type, n), v) << to_string(type);
      EXPECT_EQ(number_count(type), type == Type::pair ? 2 : count) << to_string(type);
      EXPECT_LE(count - (type == Type::pair ? 1 : 0), row_of(type).channels);
      EXPECT_TRUE(numeric(v));
      EXPECT_EQ(fitted(v, type), v) << to_string(type);
      double back[4] = {};
      to_numbers(with_numbers(row_of(type).example(), n), back);
      for (int k = 0; k < count; ++k) EXPECT_EQ(back[k], n[k]) << to_string(type);
    }
  }
  EXPECT_EQ(value_of_numbers(Type::pair, std::array{1.0, 2.0, 3.0}.data()), Value(Vec3{1, 2, 0}));
  EXPECT_EQ(value_of_numbers(Type::rotation, std::array{0.0, 1.0, 0.0, 0.0}.data(), true), Value(Quat{0, 1, 0, 0}));
  EXPECT_EQ(value_of_numbers(Type::boolean, std::array{0.25}.data()), Value(true));
  for (const Value& v : {Value(Text()), Value(ObjectId{3}), Value(Points()), Value(Matrix()), Value(Moves())})
    EXPECT_FALSE(numeric(v));
}

TEST(Types, ComponentsAreNumbersOfTheValueByName) {
  std::mt19937 dice(8);
  for (int i = 0; i < all_types; ++i) {
    const Type type = type_at(i);
    const Value v = component_count(type) > 0 ? any_value(type, dice) : Value(0.0);
    for (int k = 0; k < component_count(type); ++k) {
      EXPECT_EQ(find_component(type, component_name(type, k)), k);
      const Value changed = with_component(v, k, 99);
      EXPECT_EQ(changed.index(), v.index());
      for (int other = 0; other < component_count(type); ++other)
        EXPECT_EQ(component_of(changed, other), other == k ? 99 : component_of(v, other)) << to_string(type);
    }
    EXPECT_EQ(find_component(type, ""), -1);
    EXPECT_EQ(find_component(type, "xy"), -1);
    EXPECT_EQ(component_name(type, component_count(type)), "");
  }
  const Color c = std::get<Color>(with_component(Color{0, 0, 0}, find_component(Type::color, "g"), 0.5));
  EXPECT_EQ(c, (Color{0, 0.5, 0}));
  EXPECT_EQ(find_component(Type::color, "x"), -1);
  EXPECT_EQ(find_component(Type::pair, "z"), -1);
  EXPECT_EQ(component_type(Type::rotation), Type::angle);
  EXPECT_EQ(component_track_type(Type::rotation), Type::angle);
  EXPECT_EQ(component_track_type(Type::color), Type::color);
  EXPECT_EQ(with_component(ObjectId{5}, 1, 2), Value(Vec3{0, 2, 0}));
}

// A velocity is a difference by a time: what has one can be added up, or turns.
TEST(Types, WhatCanBeAddedUpHasAVelocity) {
  for (int i = 0; i < all_types; ++i) {
    const TypeRow& row = row_of(type_at(i));
    const Value v = row.example();
    const bool adds = add_scaled(v, v, 1).has_value(), turns = std::holds_alternative<Quat>(v);
    EXPECT_EQ(has_velocity(row.type), adds || turns) << row.phrase;
    if (!row.rate) continue;
    EXPECT_EQ(number_count(*row.rate), turns ? 3 : number_count(row.type)) << row.phrase;
    EXPECT_NE(row.changes, Changes::in_steps) << row.phrase;
  }
}

TEST(Types, TwerpersFitByWhatLiesBetweenTwoValues) {
  for (int i = 0; i < all_types; ++i) {
    const TypeRow& row = row_of(type_at(i));
    EXPECT_TRUE(fits(row.twerper, row.type)) << row.phrase;
    EXPECT_TRUE(fits(Twerper::unset, row.type) && fits(Twerper::hold, row.type));
    std::string why;
    EXPECT_EQ(fits(Twerper::linear, row.type, &why), row.changes != Changes::in_steps) << row.phrase;
    EXPECT_EQ(why, row.changes != Changes::in_steps
                       ? ""
                       : "'linear' cannot blend " + std::string(row.phrase) + ": it changes only at its events");
    EXPECT_EQ(fits(Twerper::slerp, row.type), row.changes == Changes::by_turning) << row.phrase;
    EXPECT_EQ(fits(static_cast<Twerper>(first_own_twerper), row.type), row.changes != Changes::in_steps) << row.phrase;
    EXPECT_TRUE(!row.tangents || has_velocity(row.type)) << row.phrase;
  }
}

TEST(Types, TakeWhatMeansTheSame) {
  EXPECT_EQ(fitted(Vec3{1, 2, 3}, Type::color), Value(Color{1, 2, 3}));
  EXPECT_EQ(fitted(Vec3{1, 2, 3}, Type::pair), Value(Vec3{1, 2, 0}));
  EXPECT_EQ(fitted(Vec3{1, 2, 3}, Type::rotation), Value(Angles{{1, 2, 3}}));
  EXPECT_EQ(fitted(Vec3{1, 2, 3}, Type::aim), Value(Vec3{1, 2, 3}));
  EXPECT_EQ(fitted(Angles{{0, 0, 1}}, Type::orientation), Value(from_angles({0, 0, 1})));
  EXPECT_EQ(fitted(Vec3{0, 0, 1}, Type::orientation), Value(from_angles({0, 0, 1})));
  EXPECT_EQ(fitted(Quat{0, 1, 0, 0}, Type::rotation), Value(Quat{0, 1, 0, 0}));
  EXPECT_EQ(fitted(2.0, Type::boolean), Value(true));
  EXPECT_EQ(fitted(2.5, Type::text), Value(Text(std::string("2.5"))));
  EXPECT_FALSE(fitted(true, Type::scalar));
  EXPECT_FALSE(fitted(2.0, Type::vector));
  EXPECT_FALSE(fitted(Vec3{}, Type::scalar));
  EXPECT_FALSE(fitted(Color{}, Type::vector));
  EXPECT_FALSE(fitted(Angles{}, Type::color));
  EXPECT_FALSE(fitted(Quat{}, Type::vector));
  EXPECT_FALSE(fitted(Text(std::string("ball")), Type::shape));  // takes a scene
}

}  // namespace
}  // namespace betwixt
