// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Questions that may take long: live values (code, filters, layers), tracks with twerpers written in code, shapes of
// many points or letters, skins of large meshes, blends between large shapes, and the camera of a film without cameras.
// An evaluator with a DeferredEvaluation takes the answers that have come, and waits for no more.
#pragma once

#include "program/compiled.h"

namespace betwixt {

struct Question {
  // track: the blend of a track with coded twerpers. blend: between the shapes of `geometry`.
  enum What : std::uint8_t { live, track, shape, blend, camera } what = live;
  std::uint32_t index = 0;  // into lives, Schedule::coded, slow_shapes or slow_blends
  static constexpr std::size_t kinds = camera + 1;
};

struct Answer {
  Value value;
  std::array<double, 4> numbers{};  // of a track of numbers
  Between between;                  // of a track of other values
  std::optional<Mat4> motion;       // of a track of motions
  std::shared_ptr<const Shape> shape, toward;
  double blend = 0;                  // from `shape` to `toward`
  std::shared_ptr<const void> mesh;  // keeps the shape's mesh, so that drawing finds it
  Camera camera;
  std::vector<std::uint32_t> read;  // objects that its code has read, sorted
  std::vector<Problem> problems;
};

// All questions of a program's frames, in the order of their kinds.
std::vector<Question> questions_of(const CompiledFilm&);
// Returns the object and the function that a question is about. Function 0 for a shape; object 0 too for the camera.
std::pair<std::uint32_t, FunctionId> subject_of(const CompiledFilm&, const Question&);
// Returns true if the value may take long at this time; otherwise the evaluator computes it itself.
bool may_take_long(const CompiledFilm&, const Question&, Time);
// Computes the answer of the film as a pure function. Throws Cancelled if the thread's work is cancelled.
Answer work_out(const Program::Compiled&, const Question&, Time);

class DeferredEvaluation {
 public:
  virtual ~DeferredEvaluation() = default;
  // Call it before each frame. Returns whether answers have come since the frame before.
  virtual bool ask(const Program&, Time) = 0;
  // Returns the newest answer, or null before the first one.
  virtual const Answer* answer(const Question&) const = 0;
  virtual Time time() const = 0;                      // the frame's time
  virtual bool quick(const Question&) const = 0;      // true if the evaluator may compute it itself, for another time
  virtual std::vector<std::string> late() const = 0;  // sentences that name the slow values
};

// Returns what a track with coded twerpers gives at t: the part of its answer that `known` points to, if the answer is
// deferred; the result of `compute` otherwise. Without an answer, the coded twerpers count as linear.
template <class Known, class Compute>
auto coded_value(const Program::Compiled& c, const Binding& b, Time t, Asking& asking, Known&& known,
                 Compute&& compute) {
  if (b.coded < 0) return compute();
  const Question question{Question::track, static_cast<std::uint32_t>(b.coded)};
  const Asking::Deferred deferred = asking.deferred_answer(question, t);
  if (!deferred.yes || !may_take_long(c, question, t)) return compute();
  if (deferred.answer) {
    asking.say_all(*deferred.answer);
    if (const auto* there = known(*deferred.answer)) return *there;
  }
  const LinearTwerpers plain;
  return compute();
}

}  // namespace betwixt
