// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares velocities that code computes, and velocities in an object's own space, with closed forms.
#include <cmath>

#include "support/any_order.h"

namespace betwixt {
namespace {

std::string at(double seconds) { return fmt::format("{}s", seconds); }

// shows: G54 G8 S2
TEST(Integrals, OfCodeAreItsIntegral) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere position=(1 0 0)\nat 1f a.position.velocity = \"vec(-sin(t), cos(t), exp(-t))\"\n"
      "create b box\nat 1f b.rotation.velocity = \"euler(0, 0, t)\"\ncreate c sphere color=black\n"
      "at 1f c.color.velocity = \"rgb(0.1, 0, t / 50)\"\ncreate d sphere\nat 1f d.radius.velocity = \"cos(t)\"\n");
  for (const double t : {0.0, 0.01, 0.5, 1.0, 1.7, 4.321, 20.0, 300.0}) {
    expect_numbers(s, "a.position", at(t), {std::cos(t), std::sin(t), 1 - std::exp(-t)}, 1e-8);
    expect_numbers(s, "a.position.velocity", at(t), {-std::sin(t), std::cos(t), std::exp(-t)}, 1e-12);
    expect_numbers(s, "b.rotation", at(t), {0, 0, t * t / 2}, 1e-8 * (1 + t));
    if (t < 7) expect_numbers(s, "c.color", at(t), {0.1 * t, 0, t * t / 100}, 1e-8);
    expect_numbers(s, "d.radius", at(t), {std::max(0.0, 1 + std::sin(t))}, 1e-8);
  }
  EXPECT_TRUE(s.frame("77f").problems.empty());
}

// A jump is found where it is. Events with values, blends between both, and the release.
TEST(Integrals, OfTracksWithJumpsAndPlainEvents) {
  const LoadedFilm s(
      "rate 24\ncreate d sphere\nd.radius.velocity\n  1f = \"t < 1.2345678 and 1 or 0.25\"\n  73f release\n"
      "create e sphere\ne.position.x.velocity\n  1f 1 linear\n  25f = \"2 * t\"\n  49f 5\n  73f release\n"
      "e.position.x\n  1f 0 hold\n  97f 100\n");
  expect_numbers(s,
                 {{"d.radius", "1s", {2}},
                  {"d.radius", "2s", {1 + 1.2345678 + 0.25 * (2 - 1.2345678)}},
                  {"d.radius", "9s", {1 + 1.2345678 + 0.25 * (3 - 1.2345678)}}},
                 1e-8);
  // From 1 to 2 in the first second, then 2 t for a second, then 5 for a second; the next event comes at 4 s.
  expect_numbers(s,
                 {{"e.position.x", "1s", {1.5}},
                  {"e.position.x", "2s", {4.5}},
                  {"e.position.x", "2.5s", {7}},
                  {"e.position.x", "3.5s", {9.5}},
                  {"e.position.x", "4s", {100}}},
                 1e-8);
}

// An angular velocity about an axis that turns: the cone that the axis describes has a closed form.
TEST(Integrals, OfAngularVelocities) {
  const LoadedFilm s(
      "rate 24\ncreate c box rotation=axis(0 0 1, 0deg)\nat 1f c.rotation.velocity = \"vec(2 * cos(3 * t), 2 * sin(3 * "
      "t), 1)\"\n");
  for (const double t : {0.2, 1.0, 2.5, 6.0}) {
    // In the frame that turns with 3 about z, the velocity is constant: (2, 0, 1 - 3).
    const Vec3 w{2, 0, -2};
    const Quat wanted = axis_angle({0, 0, 1}, 3 * t) * axis_angle(w, length(w) * t);
    const auto n = s.numbers("c.rotation", at(t));
    const double sign = n[0] * wanted.w < 0 ? -1 : 1;
    const double q[] = {wanted.w, wanted.x, wanted.y, wanted.z};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sign * n[i], q[i], 1e-6) << t;
  }
}

// The velocity of a car that steers: it drives on a circle.
// shows: S9
TEST(Integrals, InOwnSpaceTurnWithTheObject) {
  const LoadedFilm s(
      "rate 24\ncreate car box velocity-space=own\nat 1f car.position.velocity (2 0 0)\n"
      "at 1f car.rotation.velocity euler(0 0 0.5rad)\ncreate plain box\nat 1f plain.position.velocity (2 0 0)\n"
      "at 1f plain.rotation.velocity euler(0 0 0.5rad)\n");
  for (const double t : {0.3, 1.0, 5.0, 12.0}) {
    expect_numbers(s, "car.position", at(t), {4 * std::sin(t / 2), 4 - 4 * std::cos(t / 2), 0}, 1e-8);
    expect_numbers(s, "car.position.velocity", at(t), {2 * std::cos(t / 2), 2 * std::sin(t / 2), 0}, 1e-8);
    expect_numbers(s, "plain.position", at(t), {2 * t, 0, 0}, 1e-9);
  }
}

// The space is a track like others: the car drives sideways until 1 s, then forward.
TEST(Integrals, TheSpaceCanChange) {
  const LoadedFilm s(
      "rate 24\ncreate car box rotation=euler(0 0 90deg)\nat 1f car.position.velocity (2 0 0)\n"
      "car.velocity-space\n  1f parent\n  25f own\n");
  expect_numbers(s, "car.position", "0.5s", {1, 0, 0}, 1e-8);
  expect_numbers(s, "car.position", "3s", {2, 4, 0}, 1e-7);
  const auto said =
      betwixt::said(read("create car box velocity-space=own\nat 1f car.position.velocity.x 2\n").diagnostics);
  EXPECT_NE(said.find("car has velocities of components, which velocity-space does not turn"), std::string::npos);
}

TEST(Integrals, ReadLawsWithMemoryAndOtherValues) {
  const LoadedFilm s(
      "rate 24\nprocedure swing steps lua \"step\"\ncreate g sphere\nat 1f g.position.velocity = \"vec(24 * swing(), "
      "value('h.position.x'), 0)\"\ncreate h sphere\nh.position\n  1f (0 0 0) linear\n  49f (4 0 0)\n");
  // Whole states hold until the next step: a staircase.
  expect_numbers(s, "g.position", "25f", {24 * 23.0 / 2, 1, 0}, 1e-6);
}

TEST(Integrals, DoNotDependOnTheOrderOfQuestions) {
  const std::string text =
      "rate 24\ncreate a sphere\nat 1f a.position.velocity = \"vec(noise(t), t < 2.2 and 1 or -1, sin(t * t))\"\n"
      "create echo sphere\nset echo.position = \"value('a.position', t - 0.37)\"\n";
  expect_same_in_any_order(text, "a.position", {4.31, 0.2, 7.77, 1.001, 3.3333, 4.3, 0.9});
}

TEST(Integrals, FailInPlainWords) {
  const auto problem = [](const std::string& code) {
    const Frame f = LoadedFilm("rate 24\ncreate a sphere\nat 1f a.position.velocity = \"" + code + "\"\n").frame("13f");
    return f.problems.empty() ? std::string() : f.problems[0];
  };
  EXPECT_NE(problem("-value('.position')").find("its code depends on the value that it moves"), std::string::npos);
  EXPECT_NE(problem("value('.position', t - 0.001)").find("its code depends on the value that it moves"),
            std::string::npos);
  EXPECT_EQ(problem("value('.position', t - 0.1) * -1 + vec(1, 0, 0)"), "");
  EXPECT_NE(problem("'fast'").find("a.position.velocity: "), std::string::npos) << problem("'fast'");
  EXPECT_NE(problem("vec(1 / 0, 0, 0)").find("not finite"), std::string::npos);
  EXPECT_NE(problem("nosuch").find("a.position.velocity"), std::string::npos);
}

TEST(Integrals, AreWrittenAndReadAgain) {
  const LoadedFilm s("rate 24\ncreate a sphere velocity-space=own\nat 1f a.position.velocity = \"vec(t, 0, 0)\"\n");
  const LoadedFilm again(write(s.loaded.document));
  EXPECT_EQ(again.read("a.position", "30f"), s.read("a.position", "30f"));
}

}  // namespace
}  // namespace betwixt
