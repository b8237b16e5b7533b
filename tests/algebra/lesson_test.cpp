// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the answers to the page that teaches motions.
#include "algebra/lesson.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/motions.h"

namespace betwixt::algebra::lesson {
namespace {

using Json = nlohmann::json;

const Places corners{{0, 0, 0}, {1, 0, 0}, {1, 1.5, 0}};

Json answered(const std::string& text) {
  auto json = Json::parse(text, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << text;
  return json;
}
std::string message(const std::string& text) { return answered(string_answer(text, {}))["error"]["message"]; }

TEST(Lesson, SaysWhatIsWrongAndWhere) {
  const Json wrong = answered(string_answer("T(5 3 R(1rad", {}))["error"];
  EXPECT_EQ(wrong["message"], parse_motion("T(5 3 R(1rad").error().message);
  EXPECT_EQ(wrong["column"], 7);
  EXPECT_EQ(wrong["length"], 1);
  EXPECT_EQ(message("R(1turn @ ball)"), "there is no object 'ball' here");
  EXPECT_EQ(message("T(1e12 0)"), "this motion goes too far away for a lesson");
  EXPECT_EQ(message("S(1e6) S(1e6)"), message("T(1e12 0)"));
  EXPECT_EQ(message("S(-1)"), parse_motion("S(-1)").error().message);
  std::string many;
  for (int i = 0; i < 65; ++i) many += "T(1 1) ";
  EXPECT_EQ(message(many), "65 factors are too many for a lesson");
  for (const std::string& answer :
       {frames_answer("Q", 0, 1, 2, false), moment_answer("Q", 0), methods_answer("Q", 2, corners),
        drift_answer("Q", Method::best, false, false, corners), ways_answer("Q", corners),
        changed_answer("Q", 0, "by", {})})
    EXPECT_TRUE(answered(answer).contains("error")) << answer;
}

TEST(Lesson, TellsTheString) {
  const Json told = answered(string_answer(" T(5 3)*R(1rad@1 4) ", {}));
  EXPECT_EQ(told["text"], "T(5 3) R(1rad @ 1 4)");
  EXPECT_EQ(told["planar"], true);
  EXPECT_EQ(told["factors"][0], Json::parse(R"-({"kind":"T","text":"T(5 3)","by":[5,3,0]})-"));
  EXPECT_EQ(told["factors"][1]["axis"], Json::parse("[0,0,1]"));
  EXPECT_EQ(told["symbols"]["sums"][3], "u1 + (1 - c2) x2 + s2 y2");
  EXPECT_EQ(told["symbols"]["letters"][0], Json::parse(R"({"name":"u1","factor":0,"means":"5 t"})"));
  // The factor alone, by the same letters.
  EXPECT_EQ(told["alone"][1]["sums"][3], "(1 - c2) x2 + s2 y2");
  EXPECT_EQ(answered(string_answer("R(1rad axis y)", {}))["planar"], false);
}

TEST(Lesson, TellsFramesAndMoments) {
  EXPECT_EQ(answered(frames_answer("T(2 0)", 0.5, 0.5, 0, false)),
            Json::parse(R"({"frames":[[1,0,0,1,0,1,0,0,0,0,1,0]]})"));
  const Json growth = answered(frames_answer("S(4 9)", 0, 1, 2, false))["frames"];
  EXPECT_EQ(growth.size(), 3u);
  EXPECT_EQ(growth[1], Json::parse("[2,0,0,0,0,3,0,0,0,0,1,0]"));
  EXPECT_EQ(answered(frames_answer("S(4 9)", 0, 1, 2, true))["frames"][1], Json::parse("[2.5,0,0,0,0,5,0,0,0,0,1,0]"));
  const Json moment = answered(moment_answer("T(5 0) S(4 9) R(1turn)", 0.5));
  EXPECT_EQ(moment["matrix"], Json::parse("[-2,0,0,2.5,0,-3,0,0,0,0,1,0]"));
  EXPECT_EQ(moment["parts"], Json::parse("[[2.5,0,0],[2,3,1],[180,0,0]]"));
  EXPECT_EQ(moment["letters"], Json::parse("[2.5,2,3,-1,0]"));
  EXPECT_EQ(moment["alone"][0], Json::parse("[1,0,0,2.5,0,1,0,0,0,0,1,0]"));
}

// Figures of the source's first table; ours worked out by hand.
TEST(Lesson, TellsWhatTheMethodsCost) {
  const Json told = answered(methods_answer("T(5 3) R(1rad @ 1 4)", 60, corners));
  const auto of = [&](const std::string& name) {
    for (const Json& way : told["ways"])
      if (way["name"] == name) return way;
    return Json();
  };
  EXPECT_EQ(of("matrix")["step"], "8Np + 6");
  EXPECT_EQ(of("matrix")["printed"]["step"], "8Np + 18");
  EXPECT_EQ(of("matrix")["frames"].size(), 61u);
  EXPECT_EQ(of("geometric")["step"], "8Np + 2");
  EXPECT_EQ(of("geometric")["printed"]["after"], "2Np");
  EXPECT_EQ(of("best")["step"], "6Np + 2");
  EXPECT_EQ(of("differences")["refused"].get<std::string>().substr(0, 48),
            "no single matrix makes all steps of this motion:");
  EXPECT_EQ(told["compiled"], "(1, 4) + t (5, 3) + R(1rad) (p + (-1, -4))");
  for (const char* exact : {"matrix", "geometric", "best"}) EXPECT_LE(of(exact)["gap"], 1e-12) << exact;
  const Json growing = answered(methods_answer("S(4 9)", 60, corners));
  EXPECT_EQ(growing["ways"][2]["name"], "geometric, linear law");
  EXPECT_EQ(growing["ways"][2]["step"], "2Np");
  EXPECT_EQ(growing["compiled"], "S(4 9) p");
  const Json space = answered(methods_answer("R(1turn axis y)", 60, corners));
  EXPECT_EQ(space["error"]["message"], "this motion leaves the plane");
}

TEST(Lesson, TellsOtherWaysToTheSameEnd) {
  const auto kinds = [](const std::string& text) {
    std::string all;
    const Json told = answered(ways_answer(text, corners));
    for (const Json& way : told["ways"]) all += way["kind"].get<std::string>() + " ";
    return all;
  };
  EXPECT_EQ(kinds("T(2 0)"), "");
  EXPECT_EQ(kinds("T(5 3) R(1rad @ 1 4)"), "root ");
  EXPECT_EQ(kinds("S(4 9)"), "law ");
  EXPECT_EQ(kinds("S(2 0.5 @ 1 1) R(180deg)"), "no root scheme law ");
  EXPECT_EQ(kinds("S(2) R(1turn axis y)"), "law ");
}

// docs/algebra.md: for SR it is (G - 1) k/N times the chord from where the turn is to where it ends.
TEST(Lesson, TheGeometricSchemeIsOffByTheChord) {
  const Motion motion = parsed("S(3 2 @ 5 -5 linear) R(0.9turn)");
  const std::vector<Mat4> frames = stepped(motion, Method::geometric, 50);
  ASSERT_EQ(frames.size(), 51u);
  for (const Vec3 p : corners)
    for (int k = 0; k <= 50; k += 7) {
      const Vec3 chord =
          transform_point(*frame(parsed("R(0.9turn)"), k, 50), p) - transform_point(at(parsed("R(0.9turn)"), 1), p);
      const Vec3 off =
          transform_point(*frame(motion, k, 50), p) - transform_point(frames[static_cast<std::size_t>(k)], p);
      EXPECT_NEAR(off.x, 2 * k / 50.0 * chord.x, 1e-12);
      EXPECT_NEAR(off.y, k / 50.0 * chord.y, 1e-12);
    }
}

TEST(Lesson, TellsWhatIsLost) {
  const Json told = answered(drift_answer("R(1turn) T(3 0)", Method::best, false, true, corners));
  EXPECT_EQ(told["marks"].back(), drift_steps - 1);
  EXPECT_EQ(told["alone"].size(), told["marks"].size());
  EXPECT_GT(told["alone"].back(), 100 * told["renewed"].back().get<double>());
  const Json fine = answered(drift_answer("R(1turn) T(3 0)", Method::best, false, false, corners));
  EXPECT_LT(fine["renewed"].back(), 1e-9);
  EXPECT_EQ(answered(drift_answer("R(1turn) T(3 0)", Method::differences, false, true, corners))["alone"],
            Json::array());
}

TEST(Lesson, ChangesOneThing) {
  const auto changed = [](const std::string& text, std::size_t factor, const char* what, Vec3 to) {
    const Json told = answered(changed_answer(text, factor, what, to));
    return told.contains("text") ? told["text"].get<std::string>() : told["error"]["message"].get<std::string>();
  };
  const std::string motion = "T(5 3) R(90deg @ 1 4) S(2)";
  EXPECT_EQ(changed(motion, 0, "by", {-1.5, 0, 0}), "T(-1.5 0) R(90deg @ 1 4) S(2)");
  EXPECT_EQ(changed(motion, 1, "centre", {}), "T(5 3) R(90deg) S(2)");
  EXPECT_EQ(changed(motion, 1, "angle", {-725, 0, 0}), "T(5 3) R(-725deg @ 1 4) S(2)");
  EXPECT_EQ(changed(motion, 1, "axis", {0, 1, 0}), "T(5 3) R(90deg @ 1 4 axis 0 1 0) S(2)");
  EXPECT_EQ(changed(motion, 2, "by", {3, 1, 1}), "T(5 3) R(90deg @ 1 4) S(3 1)");
  EXPECT_EQ(changed(motion, 2, "linear", {1, 0, 0}), "T(5 3) R(90deg @ 1 4) S(2 linear)");
  EXPECT_TRUE(changed(motion, 2, "by", {-1, 1, 1}).starts_with("factor 3, S: "));
  EXPECT_TRUE(changed(motion, 1, "axis", {}).starts_with("factor 2, R: "));
  EXPECT_EQ(changed(motion, 3, "by", {}), "there is no factor 4 here");
}

}  // namespace
}  // namespace betwixt::algebra::lesson
