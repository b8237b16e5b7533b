// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An evaluation: the state of a program at one time, for playback. When you go to another time, it computes only what
// changes.
//
// It gives the frame as columns (arrays). A drawable is an object of a kind that can be drawn, whether it is visible or
// not. It has the same index in every column; the order is that of the objects. The evaluation also lists the drawables
// that differ since the last time. The result for a time never depends on the times before. Use an evaluation from one
// thread at a time; each thread may have its own.
//
// Room: program
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/program.h"

namespace betwixt {

class DeferredEvaluation;  // src/program/deferred_evaluation.h

class Evaluation {
 public:
  explicit Evaluation(const Program&);
  // Never waits for slow values. `deferred` computes them in other threads. The frame has the newest results that have
  // arrived.
  Evaluation(const Program&, DeferredEvaluation& deferred);
  Evaluation(Evaluation&&) noexcept;
  Evaluation& operator=(Evaluation&&) noexcept;
  ~Evaluation();

  // Evaluates the program at a time.
  void to(Time);
  // Makes the first `to` faster: evaluates the program in advance, at the given time. If the first `to` goes to a time
  // close to it, it is only an update. Call it before the first `to` only. `prepare` does not count as a `to`, and does
  // not use `deferred`. You may call it on any thread while no other thread uses this object.
  void prepare(Time);
  // Replaces the program by an edited one. The next `to` then lists what differs from the last `to` of the old program.
  void use(const Program&);

  const Program& program() const;
  Time time() const;  // of the last `to`

  // The columns are valid until the next `to` or `use`. Before the first `to` their content has no meaning.
  std::span<const ObjectId> drawables() const;  // in object order
  std::span<const Mat4> worlds() const;         // object space to world space
  // The look of a drawable. If it is not visible, the other fields have no meaning.
  struct Look {
    Vec3 color{1, 1, 1};                     // linear light
    double transparency = 0, shininess = 0;  // as in Item
    double blend = 0;                        // how far `shape` has turned into `toward`, as in Item
    // Pass them to shape(), texture(), finish() and gradients(). Without a finish, shininess and material say how it
    // looks.
    std::uint32_t shape = none, toward = none, texture = none, finish = none, gradients = none;
    Material material = Material::plastic;
    bool visible = false;
    bool casts = true;  // whether it casts shadows
    static constexpr std::uint32_t none = 0xffffffff;
    friend bool operator==(const Look&, const Look&) = default;
  };
  std::span<const Look> looks() const;
  // Return the shape or texture with this number. A shape that varies keeps its number. When the shape has changed, the
  // number gives the new shape, and `changed` lists the drawable. The texture may be a frame of a video, which is read
  // when you ask for it; null, with a problem, if it cannot be read.
  const std::shared_ptr<const Shape>& shape(std::uint32_t number) const;
  std::shared_ptr<const Picture> texture(std::uint32_t number) const;
  const std::shared_ptr<const Finish>& finish(std::uint32_t number) const;
  const std::shared_ptr<const Gradients>& gradients(std::uint32_t number) const;
  // Returns the indices, in order, of the drawables in which anything differs from the previous `to`. Returns all of
  // them after the first `to`, and if `use` has changed which drawables there are.
  std::span<const std::uint32_t> changed() const;
  // Keep the revision of the state that you saw last, and compare it with the present one. If `program` is the same and
  // `times` is greater by 1, `changed` lists everything that differs from that state.
  struct Revision {
    std::uint64_t program = 0;  // differs after each `use`; no two evaluations have the same
    std::uint64_t times = 0;    // how often `to` was called since `use`
    friend bool operator==(const Revision&, const Revision&) = default;
  };
  Revision revision() const;

  const std::vector<Light>& lights() const;
  const Camera& camera() const;
  // Replaces the film's camera from now on. Pass nullopt to return to the film's own.
  void look_from(std::optional<Camera>);
  // Returns whether the frame is composed of several pictures: it has layers, or the camera is changing. The columns
  // are not enough to draw it.
  bool composed() const;
  const std::vector<std::string>& problems() const;  // as in Frame
  const std::vector<Problem>& reports() const;

  Frame frame() const;  // the whole state as a value

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace betwixt
