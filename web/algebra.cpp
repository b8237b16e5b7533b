// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions that algebra.js calls. They return JSON, which src/algebra/lesson.h describes; a text is valid until
// the next call. `points` has three numbers for each place, separated by blanks.
#include <emscripten.h>

#include <cstdlib>
#include <string>

#include "algebra/lesson.h"

namespace betwixt::algebra::lesson {
namespace {

// Returns a text that is valid until the next call.
const char* returned(std::string text) {
  static std::string last;
  last = std::move(text);
  return last.c_str();
}

Places places(const char* text) {
  Places all;
  for (char* end = nullptr;; text = end) {
    Vec3 p;
    for (int i = 0; i < 3; ++i, text = end) {
      p[i] = std::strtod(text, &end);
      if (end == text) return all;
    }
    all.push_back(p);
  }
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* betwixt_string(const char* text, const char* points) {
  return returned(string_answer(text, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_frames(const char* text, double from, double to, int count, int linear) {
  return returned(frames_answer(text, from, to, count, linear != 0));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_moment(const char* text, double t) { return returned(moment_answer(text, t)); }
EMSCRIPTEN_KEEPALIVE const char* betwixt_methods(const char* text, int steps, const char* points) {
  return returned(methods_answer(text, steps, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_drift(const char* text, int method, int linear, int single,
                                               const char* points) {
  return returned(drift_answer(text, static_cast<Method>(method), linear != 0, single != 0, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_ways(const char* text, const char* points) {
  return returned(ways_answer(text, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_changed(const char* text, int factor, const char* what, double x, double y,
                                                 double z) {
  return returned(changed_answer(text, static_cast<std::size_t>(factor), what, {x, y, z}));
}

}  // extern "C"

}  // namespace betwixt::algebra::lesson
