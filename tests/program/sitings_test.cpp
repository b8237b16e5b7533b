// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Objects that have been in the same environments since the same times must share the computed matrices.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>

#include "betwixt/evaluation.h"
#include "betwixt/language.h"
#include "program/compiled.h"

namespace betwixt {
namespace {

TEST(Sitings, EqualOnesAreOne) {
  const Document film =
      load_text(
          "rate 24\nanimate spin every 1t by rotate(6deg, z)\nanimate slide every 2t by translate(1 0 0)\n"
          "at 30t halt spin\ncreate a{1..40} box position=(i 0 0) environments=(spin)\n"
          "create b{1..20} box environments=(slide spin) position=(0 i 0)\n"
          "create c{1..10} box drive=(spin) position=(0 0 i)\nat 24f c*.environments (spin)\n"
          "couple a{1..5} to b1\nhang b2 on a9\ncreate still box\n",
          "")
          .document;
  const Program program = Program::compile(film);
  EXPECT_EQ(program.compiled().sitings.size(), 3U);  // (spin), (slide spin), (spin) from 24f on
  Evaluation e(program);
  for (const int frame : {1, 5, 6, 24, 25, 60, 3, 59, 25, 24}) {
    const Time t = film.rate().frame(frame);
    e.to(t);
    const Evaluation fresh = [&] {
      Evaluation other(program);
      other.to(t);
      return other;
    }();
    const auto worlds = e.worlds(), alone = fresh.worlds();
    ASSERT_EQ(worlds.size(), alone.size());
    EXPECT_EQ(std::memcmp(worlds.data(), alone.data(), worlds.size() * sizeof(Mat4)), 0) << frame;
    for (const Item& item : program.frame(t).items) {
      const Value world = program.read(Target{item.id, Query::world}, t);
      EXPECT_EQ(std::memcmp(&**std::get_if<Matrix>(&world), &item.world, sizeof(Mat4)), 0) << frame;
    }
  }
}

}  // namespace
}  // namespace betwixt
