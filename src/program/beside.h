// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Questions that may take long: live values (code, filters, layers), shapes of many points or letters, and the camera
// of a film without cameras. An evaluator with a Beside takes the answers that have come, and waits for no more.
#pragma once

#include "program/compiled.h"

namespace betwixt {

struct Question {
  enum What : std::uint8_t { live, shape, camera } what = live;
  std::uint32_t index = 0;  // into Compiled::lives or Compiled::slow_shapes
};

struct Answer {
  Value value;
  std::shared_ptr<const Shape> shape;
  std::shared_ptr<const void> mesh;  // keeps the shape's mesh, so that drawing finds it
  Camera camera;
  std::vector<std::string> problems;
  std::vector<Frame::CodeError> errors;
};

// All questions of a program's frames.
std::vector<Question> questions_of(const Program::Compiled&);
// Computes the answer of the film as a pure function. Throws NotWanted if the thread's work is cancelled.
Answer work_out(const Program::Compiled&, const Question&, Time);

class Beside {
 public:
  virtual ~Beside() = default;
  // Call it before each frame. Returns whether answers have come since the frame before.
  virtual bool ask(const Program&, Time) = 0;
  // Returns the newest answer, or null before the first one.
  virtual const Answer* answer(const Question&) const = 0;
  virtual Time time() const = 0;                      // the frame's time
  virtual bool quick(const Question&) const = 0;      // true if the evaluator may compute it itself, for another time
  virtual std::vector<std::string> late() const = 0;  // sentences that name the slow values
};

}  // namespace betwixt
