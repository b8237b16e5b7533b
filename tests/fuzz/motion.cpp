// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes the readers of motions and of lists of CSS transforms, and the input field of a lesson, with any text.
#include <cstdint>

#include "algebra/lesson.h"
#include "betwixt/css.h"
#include "fuzz.h"

using namespace betwixt;

// A motion is written so that it reads back the same, and has frames and counts.
static void motion(std::string_view text) {
  for (const auto& read : {parse_motion(text), from_css(text)}) {
    if (!read) {
      insist(!read.error().message.empty() && read.error().place.column > 0, "an error has words and a place");
      continue;
    }
    const auto again = parse_motion(to_string(*read));
    insist(again && *again == *read, "a written motion reads back the same");
    at(*read, 0.3);
    if (read->factors.size() > 12 || !check(*read)) continue;
    for (const Method m : {Method::matrix, Method::geometric, Method::differences, Method::best}) {
      const double x = 1, y = -2;
      auto steps = Steps<double>::make(*read, 3, m, {&x, 1}, {&y, 1});
      if (!steps) continue;
      steps->step(), steps->seek(-1), steps->seek(2), steps->step();
      insist(static_cast<bool>(count_operations(*read, 3, m, 10)), "what is stepped can be counted");
    }
  }
}

// Whatever stands in the field of a lesson, all answers are objects.
static void lesson_of(std::string_view text) {
  using namespace betwixt::algebra::lesson;
  const algebra::Places points{{0, 0, 0}, {1, 1.5, 0}};
  const auto shown = read(text, points);
  if (shown && shown->factors.size() > 12) return;  // it would take long
  for (const std::string& answer :
       {string_answer(text, points), frames_answer(text, 0, 1, 3, true), moment_answer(text, 0.3),
        methods_answer(text, 5, points), ways_answer(text, points), changed_answer(text, 0, "centre", {1, 2, 0})})
    insist(answer.starts_with("{\"") && answer.ends_with("}"), "an answer is an object");
}

// A list of CSS is read, mixed and accumulated, whatever it is.
static void css(std::string_view text) {
  const auto list = parse_css(text, CssPage{100, 50, 16, 16, 800, 600});
  if (!list) return insist(list.error().place.column > 0, "an error of a list has a place");
  css_between({}, *list, 0.3), css_between(*list, *list, 2);
  css_between({}, css_accumulated(*list, *list), -1);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  motion(text);
  css(text);
  lesson_of(text);
  return 0;
}
