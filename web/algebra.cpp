// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a page asks of the algebra: every answer is JSON, as src/algebra/lesson.h says. algebra.js is the other half.
// Places are three numbers each, with blanks between them. A text that is given back lives until the next call.
#include <emscripten.h>

#include <cstdlib>
#include <string>

#include "algebra/lesson.h"

namespace betwixt::algebra::lesson {
namespace {

const char* keep(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return kept.c_str();
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
  return keep(string_answer(text, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_frames(const char* text, double from, double to, int count, int linear) {
  return keep(frames_answer(text, from, to, count, linear != 0));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_moment(const char* text, double t) { return keep(moment_answer(text, t)); }
EMSCRIPTEN_KEEPALIVE const char* betwixt_methods(const char* text, int steps, const char* points) {
  return keep(methods_answer(text, steps, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_drift(const char* text, int method, int linear, int single,
                                               const char* points) {
  return keep(drift_answer(text, static_cast<Method>(method), linear != 0, single != 0, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_ways(const char* text, const char* points) {
  return keep(ways_answer(text, places(points)));
}
EMSCRIPTEN_KEEPALIVE const char* betwixt_changed(const char* text, int factor, const char* what, double x, double y,
                                                 double z) {
  return keep(changed_answer(text, static_cast<std::size_t>(factor), what, {x, y, z}));
}

}  // extern "C"

}  // namespace betwixt::algebra::lesson
