// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/memory.h"

#include <gtest/gtest.h>

#include "program/programs.h"

namespace betwixt {
namespace {

// What `count` more events of a function that is one number cost a program each.
double bytes_an_event(FunctionId f, int count) {
  const auto bytes = [&](int events) {
    Scene s;
    const ObjectId ball = add(s, "ball");
    for (int k = 0; k < events; ++k) put_event(s, {ball, f}, event(k, k % 7 * 0.1));
    return static_cast<double>(bytes_of(compile(s)));
  };
  return (bytes(2 * count) - bytes(count)) / count;
}

TEST(ProgramSize, HoldsForEachEventATimeANumberAndATwerper) {
  const double each = bytes_an_event(fn::radius, 16384);
  EXPECT_GE(each, sizeof(std::int64_t) + sizeof(double) + 1);
  EXPECT_LE(each, 24);
}

}  // namespace
}  // namespace betwixt
