// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares velocity tracks with integrals, by brute force and by hand.
#include <rapidcheck.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr double pi_ = 3.14159265358979323846;

double at(const LoadedFilm& s, std::string_view target, double seconds) {
  const auto found = find_targets(target, s.loaded.document);
  if (!found || found->size() != 1) {
    ADD_FAILURE() << target;
    return 0;
  }
  return numbers(s.program.read(found->front(), from_seconds(seconds)))[0];
}

// Integrates with Gauss' rule of three points on many short intervals between the jumps.
double integral(const std::function<double(double)>& f, const std::vector<double>& seams) {
  double sum = 0;
  constexpr int parts = 400;
  for (std::size_t k = 0; k + 1 < seams.size(); ++k) {
    const double h = (seams[k + 1] - seams[k]) / parts;
    for (int i = 0; i < parts; ++i) {
      const double middle = seams[k] + (i + 0.5) * h, off = h / 2 * std::sqrt(0.6);
      sum += h / 18 * (5 * f(middle - off) + 8 * f(middle) + 5 * f(middle + off));
    }
  }
  return sum;
}

// shows: G73 G74 R-T5
TEST(Velocity, TheExampleOfTheNotesAndItsMaskedEvent) {
  const LoadedFilm s(
      "rate 24\ncreate ball sphere\nball.position.x\n  1f 0 linear\n  24f 20\n"
      "at 1f ball.position.x.velocity 10\n");
  EXPECT_NEAR(s.numbers("ball.position.x", "24f")[0], 9.58333333333333333, 1e-14);
  EXPECT_NEAR(s.numbers("ball.position", "24f")[0], 9.58333333333333333, 1e-14);
  EXPECT_NEAR(s.numbers("ball.position.x", "49f")[0], 20, 1e-12);
  ASSERT_EQ(s.loaded.diagnostics.size(), 1U) << said(s.loaded.diagnostics);
  EXPECT_EQ(told(s.loaded.diagnostics[0]), "warning syntax 6:32 10");
  EXPECT_EQ(s.loaded.diagnostics[0].what.message, "a velocity overrides 1 event (ball.position.x at 24f)");
}

const char* const twerpers[] = {"hold", "linear", "smooth", "bspline", "hermite tangent=3", "bezier(0.3 0.1 0.6 1.2)",
                                "own"};

// Reads the same rows once as values and once as velocities.
LoadedFilm twice(const std::string& rows, const std::string& more = "") {
  return LoadedFilm(
      "rate 24\nprocedure own twerper lua \"u*u*(3-2*u)\"\ndefine slope number\ndefine total number\n"
      "create a group\nset a.total 5\na.slope\n" +
      rows + "a.total.velocity\n" + rows + more);
}

// shows: G49 G71 G24 R-T5
TEST(Velocity, EveryTwerperIsIntegratedWithItsEases) {
  for (const std::string tw : twerpers)
    for (const bool eased : {false, true}) {
      const std::string rows = fmt::format(
          "  1f 2 {0}{1}\n  9f -4 {0}{2}\n  20f 7 cut 1 {0}\n  31f 0.5 {0}{3}\n  40f 3\n", tw,
          eased ? " ease-out=3f" : "", eased ? " ease-in=5f ease-out=20f" : "", eased ? " ease-in=2f ease-out=4f" : "");
      const LoadedFilm s = twice(rows);
      const auto slope = [&](double t) { return at(s, "a.slope", t); };
      const std::vector<double> events{0, 8 / 24.0, 19 / 24.0, 30 / 24.0, 39 / 24.0};
      for (const double t : {0.0, 0.1, 8 / 24.0, 0.5, 0.79, 0.9, 1.25, 1.5, 1.625, 3.0}) {
        std::vector<double> seams;
        for (const double e : events)
          if (e < t) seams.push_back(e);
        seams.push_back(t);
        EXPECT_NEAR(at(s, "a.total", t), 5 + integral(slope, seams), 2e-6) << tw << " " << t << (eased ? " eased" : "");
        EXPECT_NEAR(at(s, "a.total.velocity", t), slope(t), 1e-12) << tw << " " << t;
      }
    }
}

// shows: G49 R-T1 R-T5
TEST(Velocity, IsExtendedAsTracksAre) {
  for (const std::string how : {"hold", "linear", "cycle", "bounce"}) {
    const LoadedFilm s = twice("  1f 2 linear\n  9f -4 smooth\n  17f 6 linear\n  25f 1 cut 1\n",
                               "extend a.slope " + how + " after\nextend a.total.velocity " + how + " after\n");
    const auto slope = [&](double t) { return at(s, "a.slope", t); };
    for (const double t : {0.5, 1.0, 1.2, 2.0, 2.7, 3.9, 5.4}) {
      std::vector<double> seams;
      for (int k = 0; k / 24.0 < t; k += 8) seams.push_back(k / 24.0);
      seams.push_back(t);
      EXPECT_NEAR(at(s, "a.total", t), 5 + integral(slope, seams), 1e-6) << how << " " << t;
    }
  }
}

// shows: G72 G73 R-T5
TEST(Velocity, ReignsAndReleases) {
  const std::string head =
      "rate 24\ndefine total number\ncreate a group\nset a.total 7\n"
      "a.total.velocity\n  13f 4\n  37f release\n  97f -2 linear\n  121f 2\n  145f release\n";
  // Values at 0, 1 and 3 s. Velocities determine the value from 0.5 to 1.5 s and from 4 to 6 s.
  for (const std::string last : {"linear", "hold", "bezier(0 0 1 1)"}) {
    const LoadedFilm s(head + "a.total\n  1f 10 linear\n  25f 34 " + last + "\n  73f 100 linear\n  169f 40 linear\n");
    const auto v = [&](double t) { return at(s, "a.total", t); };
    EXPECT_NEAR(v(0.25), 16, 1e-12);
    EXPECT_NEAR(v(0.5), 22, 1e-12);
    EXPECT_NEAR(v(1), 24, 1e-12);  // the event is masked
    EXPECT_NEAR(v(1.5), 26, 1e-12);
    EXPECT_NEAR(v(2.25), last == "hold" ? 26 : 63, 1e-6) << last;
    EXPECT_NEAR(v(3), 100, 1e-12);
    EXPECT_NEAR(v(3.5), 92.5, 1e-12);
    // The value goes from 100 at 3 s towards 40 at 7 s, so it is 85 at 4 s.
    EXPECT_NEAR(v(4), 85, 1e-12);
    EXPECT_NEAR(v(5), 85, 1e-12);      // -2 to 2: nothing in all over …
    EXPECT_NEAR(v(4.5), 84.5, 1e-12);  // … the first second
    EXPECT_NEAR(v(6), 87, 1e-12);
    EXPECT_NEAR(v(6.5), 63.5, 1e-12);
    EXPECT_NEAR(v(7), 40, 1e-12);
    EXPECT_NEAR(at(s, "a.total.velocity", 1.2), 4, 1e-12);
    EXPECT_NEAR(at(s, "a.total.velocity", 6.5), -47, 1e-9);
  }
  // With an event exactly at the release, the track continues from it. The integrated value is its left limit.
  const LoadedFilm cut(head + "a.total\n  1f 10 linear\n  37f 50 linear\n  61f 74\n");
  EXPECT_NEAR(at(cut, "a.total", 1.5 - 1e-6), 10 + 0.5 * 40 / 1.5 + 4, 1e-4);
  EXPECT_NEAR(at(cut, "a.total", 1.5), 50, 1e-12);
  EXPECT_NEAR(at(cut, "a.total", 2), 62, 1e-12);
  // An event at the beginning of the velocity is the anchor: the value from which the integral begins.
  const LoadedFilm anchor(head + "a.total\n  13f 50 linear\n");
  EXPECT_NEAR(at(anchor, "a.total", 1), 52, 1e-12);
  EXPECT_NEAR(at(anchor, "a.total", 3), 54, 1e-12);  // nothing comes: what was reached stays
  EXPECT_NEAR(at(anchor, "a.total", 6), 56, 1e-12);
  // Without an event at or before it, the anchor is the set value.
  const LoadedFilm none(head + "a.total\n  25f 50 linear\n  61f 20\n");
  EXPECT_NEAR(at(none, "a.total", 0.5), 7, 1e-12);
  EXPECT_NEAR(at(none, "a.total", 1.5), 11, 1e-12);
  EXPECT_NEAR(at(none, "a.total", 2), 15.5, 1e-12);
  EXPECT_NEAR(at(LoadedFilm(head), "a.total", 1.5), 11, 1e-12);
}

// A velocity begins from the value that the track has before its first event.
TEST(Velocity, BeginsFromWhatTheTrackHadBeforeItsFirstEvent) {
  struct Case {
    const char *target, *rows, *rate;
  };
  const Case cases[] = {{"position.x", "  49f 10\n  73f 20\n", "1"},
                        {"position.x", "  49f 10\n", "1"},
                        {"position.y", "  49f 10 cut 4\n  73f 20\n", "-2"},
                        {"position", "  49f (10 2 1) linear\n  73f (20 0 0)\n", "(1 2 3)"},
                        {"position", "  1f keep linear\n  49f (10 2 1)\n", "(1 2 3)"},
                        {"position", "  49f = \"vec(t, 2, 3)\"\n", "(1 2 3)"},
                        {"radius", "  49f 10\n  73f 20\n", "1"},
                        {"transparency", "  49f 0.5\n", "0.1"},
                        {"rotation", "  49f axis(y 40deg)\n  73f axis(x 40deg)\n", "spin(0 10deg 0)"},
                        {"rotation", "  49f euler(0 40deg 0)\n", "euler(0 10deg 20deg)"},
                        {"rotation", "  49f euler(0 40deg 0)\n", "spin(10deg 0 0)"},
                        {"color", "  49f rgb(0.2 0.5 0.1)\n", "rgb(0.1 0 0)"},
                        {"color.g", "  49f 0.5\n", "0.1"}};
  for (const char* set : {"", "set a.position (1 2 3)\nset a.radius 3\nset a.rotation euler(20deg 0 0)\n"})
    for (const char* extend : {"", "linear", "cycle"})
      for (const Case& c : cases) {
        std::string film = fmt::format("rate 24\ncreate a sphere\n{}a.{}\n{}", set, c.target, c.rows);
        if (*extend && c.target != std::string("transparency"))
          film += fmt::format("extend a.{} {} before\n", c.target, extend);
        const std::string target = fmt::format("a.{}", c.target);
        const LoadedFilm plain(film), moved(film + fmt::format("at 25f {}.velocity {}\n", target, c.rate));
        for (const char* time : {"24f", "25f"}) {
          auto want = plain.numbers(target, time), got = moved.numbers(target, time);
          // Angles become a rotation about an axis here. Quaternions of both signs are the same orientation.
          if (want.size() != got.size()) want = numbers(Value(from_angles({want[0], want[1], want[2]})));
          if (want.size() == 4 && std::inner_product(want.begin(), want.end(), got.begin(), 0.0) < 0)
            for (double& x : got) x = -x;
          ASSERT_EQ(want.size(), got.size());
          for (std::size_t i = 0; i < want.size(); ++i) EXPECT_NEAR(got[i], want[i], 1e-9) << film << target << time;
        }
      }
  // The integral continues from there.
  const LoadedFilm s("rate 24\ncreate a sphere\na.position.x\n  49f 10\n  73f 20\nat 25f a.position.x.velocity 1\n");
  expect_numbers(s, "a.position.x", "49f", {11});
}

// After the release the value goes from the integrated one to the first event's, not to the value set before.
TEST(Velocity, ReleasedBeforeTheFirstEventItGoesToThat) {
  for (const char* set : {"", " position=(3 0 0)"})
    for (const char* target : {"position.x", "position"}) {
      const bool part = std::string(target) != "position";
      const auto of = [&](int x) { return part ? std::to_string(x) : fmt::format("({} 0 0)", x); };
      const LoadedFilm s(
          fmt::format("rate 24\ncreate a sphere{}\na.{}\n  49f {} linear\n  73f {}\n"
                      "twerper a.{} linear\nat 1f a.{}.velocity {}\nat 25f a.{}.velocity release\n",
                      set, target, of(10), of(20), target, target, of(1), target));
      const double begin = *set ? 3 : 10;
      expect_numbers(s, "a.position.x", "1f", {begin});
      expect_numbers(s, "a.position.x", "25f", {begin + 1});
      expect_numbers(s, "a.position.x", "37f", {(begin + 11) / 2});
      expect_numbers(s, "a.position.x", "48.9f", {begin + 1 + (9 - begin) * 23.9 / 24}, 1e-8);
      expect_numbers(s, "a.position.x", "49f", {10});
      expect_numbers(s, "a.position.x", "61f", {15});
    }
  // If the author gives the end value, the track reaches it.
  const LoadedFilm cut(
      "rate 24\ncreate a sphere position=(3 0 0)\na.position.x\n  49f 6 cut 10 linear\n  73f 20\n"
      "twerper a.position.x linear\nat 1f a.position.x.velocity 1\nat 25f a.position.x.velocity release\n");
  expect_numbers(cut, "a.position.x", "1f", {6});
  expect_numbers(cut, "a.position.x", "37f", {6.5});
  expect_numbers(cut, "a.position.x", "49f", {10});
}

// shows: G68 G71 G72 G73
TEST(Velocity, SevenTracksHaveOne) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere position=(1 2 3) scale=(1 1 2) transparency=0.1 shininess=0.9 color=rgb(0.2 0.4 0.6)\n"
      "create b sphere\ncouple a to b\n"
      "at 1f a.position.velocity (1 -2 0.5)\nat 1f a.scale.velocity (0.5 0 1)\n"
      "at 1f a.transparency.velocity 0.25\nat 1f a.shininess.velocity -0.5\n"
      "at 1f a.color.r.velocity 0.1\nat 1f a.color.b.velocity -0.2\n"
      "at 1f a.attach-position.velocity (0 3 0)\nat 1f a.rotation.velocity euler(90deg 0deg 45deg)\n"
      "at 1f b.position.y.velocity 5\nat 25f b.position.y.velocity release\nat 49f b.position (0 25 9)\n");
  expect_numbers(s, "a.position", "37f", {2.5, -1, 3.75});
  expect_numbers(s, "a.scale", "37f", {1.75, 1, 3.5});
  expect_numbers(s, "a.transparency", "37f", {0.475});
  expect_numbers(s, "a.transparency", "30s", {1});  // stays what it can be
  expect_numbers(s, "a.shininess", "25f", {0.4});
  expect_numbers(s, "a.shininess", "30s", {0});
  expect_numbers(s, "a.color", "25f", {0.3, 0.4, 0.4}, 1e-9);
  expect_numbers(s, "a.attach-position", "25f", {0, 3, 0});
  expect_numbers(s, "a.rotation", "25f", {pi_ / 2, 0, pi_ / 4});
  expect_numbers(s, "a.position.velocity", "25f", {1, -2, 0.5});
  expect_numbers(s, "a.position.y.velocity", "25f", {-2});
  expect_numbers(s, "b.position", "25f", {0, 30, 9});  // from what it was before its first event, on up
  expect_numbers(s, "b.position", "49f", {0, 25, 9});
  const LoadedFilm c("create a sphere color=rgb(0.2 0.4 0.6)\nat 1f a.color.velocity rgb(0.1 0.2 0.05)\n");
  expect_numbers(c, "a.color", "25f", {0.3, 0.6, 0.65}, 1e-9);
  expect_numbers(c, "a.color.velocity", "25f", {0.1, 0.2, 0.05}, 1e-9);
  for (const char* f : {"geometry", "display", "attachment", "material"})
    EXPECT_EQ(all_told(read(fmt::format("create a sphere\nat 1f a.{}.velocity 1\n", f))).size(), 1U) << f;
}

Quat product(Quat a, Quat b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
void expect_turn(const LoadedFilm& s, const char* target, double seconds, Quat wanted, double within) {
  const auto found = find_targets(target, s.loaded.document);
  ASSERT_TRUE(found && found->size() == 1);
  const auto n = numbers(s.program.read(found->front(), from_seconds(seconds)));
  ASSERT_EQ(n.size(), 4U);
  const double sign = n[0] * wanted.w + n[1] * wanted.x + n[2] * wanted.y + n[3] * wanted.z < 0 ? -1 : 1;
  const double q[] = {wanted.w, wanted.x, wanted.y, wanted.z};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(n[i], sign * q[i], within) << target << " " << seconds << " " << i;
}

// shows: G70 G71 R-T5b
TEST(AngularVelocity, AboutOneAxisIsTheExactExponential) {
  const LoadedFilm s(
      "rate 24\ncreate a box rotation=axis(1 0 0, 30deg)\na.rotation.velocity\n"
      "  1f axis(0 1 0, 90deg) linear\n  25f axis(0 1 0, 270deg)\n");
  const Quat anchor{std::cos(pi_ / 12), std::sin(pi_ / 12), 0, 0};
  for (const double t : {0.0, 0.3, 1.0, 2.5, 400.0}) {
    const double turns = t < 1 ? pi_ / 2 * t + pi_ / 2 * t * t : pi_ + 1.5 * pi_ * (t - 1);
    expect_turn(s, "a.rotation", t, product({std::cos(turns / 2), 0, std::sin(turns / 2), 0}, anchor), 1e-10);
  }
  expect_numbers(s, "a.rotation.velocity", "13f", {0, pi_, 0});
}

// shows: G70 G71 R-T5b
TEST(AngularVelocity, ThatWandersAgreesWithAFineIntegration) {
  const auto rows = [](bool spin) {
    const char* form = spin ? "spin({}rad {}rad {}rad)" : "({} {} {})";
    std::string out;
    const double w[4][3] = {{1, 0, 0}, {0, 2, 1}, {-3, 1, 0.5}, {0, 0, 4}};
    const char* tails[] = {"linear", "smooth ease-in=3f", "linear", ""};
    for (int k = 0; k < 4; ++k)
      out += fmt::format("  {}f {} {}\n", 1 + 16 * k, fmt::format(fmt::runtime(form), w[k][0], w[k][1], w[k][2]),
                         tails[k]);
    return out;
  };
  const LoadedFilm s("rate 24\ndefine w vector\ncreate a box rotation=axis(0 0 1, 40deg)\na.rotation.velocity\n" +
                     rows(true) + "a.w\n" + rows(false));
  const auto target = find_targets("a.w", s.loaded.document)->front();
  Quat q{std::cos(pi_ / 9), 0, 0, std::sin(pi_ / 9)};
  const int steps = 4800;  // to three seconds
  const double h = 3.0 / steps;
  const auto slope = [&](double t, Quat x) {
    const auto n = numbers(s.program.read(target, from_seconds(t)));
    return product({0, n[0] / 2, n[1] / 2, n[2] / 2}, x);
  };
  const auto step = [](Quat x, double k, Quat d) {
    return Quat{x.w + k * d.w, x.x + k * d.x, x.y + k * d.y, x.z + k * d.z};
  };
  for (int i = 0; i <= steps; ++i) {
    const double t = i * h;
    if (i % 400 == 0) expect_turn(s, "a.rotation", t, q, 2e-5);
    const Quat a = slope(t, q), b = slope(t + h / 2, step(q, h / 2, a)), c = slope(t + h / 2, step(q, h / 2, b)),
               d = slope(t + h, step(q, h, c));
    q = step(step(step(step(q, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }
}

// shows: G70 R-T5b R-T1
TEST(AngularVelocity, ThatWandersIsExtendedToo) {
  for (const std::string how : {"hold", "linear", "cycle", "bounce"}) {
    const LoadedFilm s(
        "rate 24\ndefine w vector\ncreate a box rotation=axis(0 0 1, 40deg)\na.rotation.velocity\n"
        "  1f spin(1rad 0 0) linear\n  25f spin(0 1rad 0) linear\na.w\n  1f (1 0 0) linear\n  25f (0 1 0)"
        " linear\nextend a.rotation.velocity " +
        how + " after\nextend a.w " + how + " after\n");
    const auto target = find_targets("a.w", s.loaded.document)->front();
    Quat q{std::cos(pi_ / 9), 0, 0, std::sin(pi_ / 9)};
    const int steps = 4000;
    const double h = 4.0 / steps;
    for (int i = 0; i <= steps; ++i) {
      if (i % 500 == 0) expect_turn(s, "a.rotation", i * h, q, 1e-5);
      const auto n = numbers(s.program.read(target, from_seconds((i + 0.5) * h)));  // the middle's turn
      const double l = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), k = l > 0 ? std::sin(l * h / 2) / l : 0;
      q = product({std::cos(l * h / 2), k * n[0], k * n[1], k * n[2]}, q);
    }
  }
}

// shows: G36 G72
TEST(Velocity, OfPlainTracksIsTheirDerivative) {
  const LoadedFilm s(
      "rate 24\ndefine n number\ncreate a sphere\ncreate b sphere\n"
      "a.position\n  1f (0 0 0) smooth\n  13f (0.25 1 0) smooth\n  37f (2.25 3 0) smooth\n  49f (4 4 0)\n"
      "a.radius\n  1f 1 linear\n  25f 3\n"
      "a.n\n  1f 0 hermite tangent=2\n  25f 1 hermite tangent=-1\n"
      "a.rotation\n  1f axis(0 1 0, 0deg) linear\n  25f axis(0 1 0, 90deg)\n"
      "b.rotation\n  1f euler(0deg 0deg 0deg) linear\n  25f euler(90deg 0deg 720deg)\n"
      "a.color\n  1f rgb(0 0 0) linear\n  25f rgb(1 1 1)\n");
  for (const double t : {0.5, 0.8, 1.4}) {  // t² and 2t
    EXPECT_NEAR(at(s, "a.position.x.velocity", t), 2 * t, 1e-9);
    EXPECT_NEAR(at(s, "a.position.y.velocity", t), 2, 1e-9);
  }
  EXPECT_NEAR(at(s, "a.radius.velocity", 0.7), 2, 1e-12);
  EXPECT_NEAR(at(s, "a.radius.velocity", 1.7), 0, 1e-12);
  // Hermite: 2h₁₀ + h₀₁ - h₁₁ and its derivative.
  for (const double t : {0.0, 0.3, 0.8})
    EXPECT_NEAR(at(s, "a.n.velocity", t), 2 * (3 * t * t - 4 * t + 1) + (6 * t - 6 * t * t) - (3 * t * t - 2 * t),
                1e-9);
  expect_numbers(s, "a.rotation.velocity", "13f", {0, pi_ / 2, 0}, 1e-6);
  expect_numbers(s, "b.rotation.velocity", "13f", {pi_ / 2, 0, 4 * pi_}, 1e-9);
  // In linear light x = t; in sRGB 1.055 t^(1/2.4) - 0.055.
  EXPECT_NEAR(at(s, "a.color.r.velocity", 0.5), 1.055 / 2.4 * std::pow(0.5, 1 / 2.4 - 1), 1e-5);
}

// shows: G92 G40 R-T10
TEST(Velocity, GoesAlongWithOperationsOnSegments) {
  const std::string head =
      "rate 24\ncreate a sphere\na.position.velocity\n  1f (2 1 0) linear\n  13f (4 0 0)\n  25f release\n";
  const auto v = [&](const std::string& more, const char* time) {
    return LoadedFilm(head + more).numbers("a.position", time);
  };
  const auto near = [](const std::vector<double>& is, const std::vector<double>& wanted) {
    ASSERT_EQ(is.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(is[i], wanted[i], 1e-12) << i;
  };
  near(v("", "13f"), {1.5, 0.25, 0});
  near(v("", "49f"), {3.5, 0.25, 0});
  // The path is the same, at half the speed.
  near(v("stretch a.position 1f..25f by 2\n", "25f"), {1.5, 0.25, 0});
  near(v("stretch a.position 1f..25f by 2\n", "49f"), {3.5, 0.25, 0});
  near(v("scale a.position 1f..25f (2 -1 1)\n", "25f"), {7, -0.25, 0});
  near(v("rotate a.position 1f..25f 90deg z\n", "25f"), {-0.25, 3.5, 0});
  near(v("rotate a.position 1f..25f 90deg z @ (9 9 9)\n", "25f"), {-0.25, 3.5, 0});
  near(v("translate a.position 1f..25f (5 5 5)\n", "25f"), {3.5, 0.25, 0});  // moves values, not velocities
  near(v("move a.position 1f..25f by 24f\n", "25f"), {0, 0, 0});
  near(v("move a.position 1f..25f by 24f\n", "37f"), {1.5, 0.25, 0});
  near(v("clear a.position 1f..25f\n", "37f"), {3.5, 0.25, 0});  // the velocity is cleared by its own name
  near(v("clear a.position.velocity 1f..25f\n", "37f"), {0, 0, 0});
  near(v("scale a.position.velocity 1f..25f (2 -1 1)\n", "25f"), {7, -0.25, 0});
}

// shows: G34 G98 G99
TEST(Velocity, RandomDocumentsAreWrittenAndReadBack) {
  EXPECT_TRUE(rc::check([] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto number = [&] { return fmt::format("{}", (below(2000) - 1000) / 64.0); };
    const auto vector = [&] { return "(" + number() + " " + number() + " " + number() + ")"; };
    std::string text = "define heat number\ncreate a sphere\ncreate b sphere\n";
    for (int i = below(10) + 1; i > 0; --i) {
      const std::string o = below(2) ? "a" : "b";
      struct Kind {
        const char* target;
        std::function<std::string()> value;
      };
      const Kind kinds[] = {
          {"position", vector},
          {"scale.y", number},
          {"position.x", number},
          {"heat", number},
          {"color.g", number},
          {"rotation", [&] { return fmt::format("axis({} 1 0, {}deg)", number(), number()); }},
          {"rotation", [&] { return fmt::format("euler({}deg 0 {}deg)", number(), number()); }},
          {"color", [&] { return fmt::format("rgb(0.{} 0 1)", below(99)); }},
      };
      const Kind& k = kinds[below(8)];
      text += o + "." + k.target + ".velocity\n";
      for (int rows = below(5); rows >= 0; --rows) {
        static const char* tails[] = {"", " linear", " hold", " smooth ease-in=4f", " bspline", " bezier(0.1 0 0.5 1)"};
        text += fmt::format("  {}f {}\n", 1 + below(200) / 2.0,
                            below(4) == 0   ? "release"
                            : below(7) == 0 ? k.value() + " cut " + k.value()
                                            : k.value() + tails[below(6)]);
      }
      if (below(3) == 0) text += fmt::format("extend {}.{}.velocity cycle\n", o, k.target);
      if (below(3) == 0) text += fmt::format("twerper {}.{}.velocity linear\n", o, k.target);
      if (below(3) == 0) text += fmt::format("stretch {}.position 1f..30f by 1.5\n", o);
    }
    const Loaded one = read(text);
    if (has_errors(one.diagnostics)) RC_FAIL(text + said(one.diagnostics));
    const Loaded two = load_text(write(one.document), "written.bx");
    if (!(one.document == two.document)) RC_FAIL(text + "\n-- written:\n" + write(one.document));
    const Program p = Program::compile(one.document), q = Program::compile(two.document);
    for (const char* object : {"a", "b"})
      for (int k = 0; k < 5; ++k) {
        const Target world{one.document.find(object), Query::world};
        const Time t = from_seconds(below(600) / 100.0);
        RC_ASSERT(*std::get<Matrix>(p.read(world, t)) == *std::get<Matrix>(q.read(world, t)));
      }
  }));
}

// shows: G74 R-T5
TEST(Velocity, AReleaseWithoutAReignIsNoticed) {
  const auto notices = [](const char* rows) {
    std::string out;
    for (const Diagnostic& d : read(fmt::format("rate 24\ncreate a sphere\na.radius.velocity\n{}", rows)).diagnostics)
      out += fmt::format("{}: {}\n", d.what.place.line, d.what.message);
    return out;
  };
  EXPECT_EQ(notices("  9f release\n"), "4: no velocity is active at 9f, so there is nothing to release\n");
  EXPECT_EQ(notices("  9f release\n  1f 2\n"), "");  // rows come in any order
  EXPECT_EQ(remarks_told("rate 24\ncreate a sphere\na.radius.velocity\n  1f 2\n  5f release\n  9f release\n"),
            std::vector<std::string>{"notice syntax 6:6 release"});
}

}  // namespace
}  // namespace betwixt
