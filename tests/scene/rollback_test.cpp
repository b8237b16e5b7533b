// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/rollback.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

Scene one_ball() {
  Scene s;
  Object o;
  o.name = "ball";
  o.kind = Kind::sphere;
  set_value(s, {add_object(s, std::move(o)), fn::radius}, 2.0);
  return s;
}

// Changes that reach an object, its track, a table that all share, and the numbers of the film.
bool change(Scene& s, bool succeed, bool* as_it_was = nullptr) {
  Rollback whole(s);
  Event e;
  e.value = Vec3{1, 2, 3};
  put_event(s, {s.names.find("ball"), fn::position}, e);
  s.aliases.edit()["all"] = {"b*"};
  s.rate = {30, 1};
  if (as_it_was) *as_it_was = same(whole.before(), one_ball());
  if (!succeed) return false;
  whole.keep();
  return true;
}

TEST(Rollback, WhatIsNotKeptIsPutBack) {
  Scene s = one_ball();
  EXPECT_FALSE(change(s, false));
  EXPECT_TRUE(same(s, one_ball()));
}

TEST(Rollback, WhatIsKeptStays) {
  Scene s = one_ball();
  bool as_it_was = false;
  EXPECT_TRUE(change(s, true, &as_it_was));
  EXPECT_TRUE(as_it_was);
  EXPECT_EQ(s.rate, (Rate{30, 1}));
  EXPECT_TRUE(s.aliases->contains("all"));
  EXPECT_EQ(tracks_of(s, {s.names.find("ball"), fn::position})[0]->events.size(), 1U);
}

TEST(Rollback, AnInnerOneThatIsKeptGoesBackWithTheOuterOne) {
  Scene s = one_ball();
  {
    Rollback outer(s);
    EXPECT_TRUE(change(s, true));
  }
  EXPECT_TRUE(same(s, one_ball()));
}

}  // namespace
}  // namespace betwixt
