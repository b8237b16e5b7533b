// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An evaluation: a program at one time, kept from one time to the next, for playback. Going to a new time computes
// only the things that change.
//
// The frame comes as columns. Each drawable has one place in every column; drawables are the objects of a kind that can
// be drawn, visible or not, in object order. The evaluation also lists the places that differ since the last time. The
// result for a time never depends on the times before. Use an evaluation from one thread at a time; each thread may
// have its own.
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
  // Each frame is ready in time: `deferred` works out what may take long, and a slow value is the last one that has
  // come.
  Evaluation(const Program&, DeferredEvaluation& deferred);
  Evaluation(Evaluation&&) noexcept;
  Evaluation& operator=(Evaluation&&) noexcept;
  ~Evaluation();

  // Evaluates the program at a time.
  void to(Time);
  // Evaluates the program at a time in advance, on any thread that has this object to itself, so that the first `to` at
  // a time close to it is only an update. Asks `deferred` nothing. It does not count as a `to`.
  void prepare(Time);
  // Replaces the program by an edited one. The next `to` then lists what differs from the last time of the old one.
  void use(const Program&);

  const Program& program() const;
  Time time() const;  // that of the last `to`

  // The columns are valid until the next `to` or `use`. Before the first `to` their content has no meaning.
  std::span<const ObjectId> drawables() const;  // in object order
  std::span<const Mat4> worlds() const;         // object space to world space
  // The look of a drawable. If it is not visible, the other fields have no meaning.
  struct Look {
    Vec3 color{1, 1, 1};                                        // linear light
    double transparency = 0, shininess = 0;                     // as in Item
    double blend = 0;                                           // how far it is on the way to `toward`
    std::uint32_t shape = none, toward = none, texture = none;  // pass them to shape() and texture()
    Material material = Material::plastic;
    bool visible = false;
    bool casts = true;  // whether it casts shadows
    static constexpr std::uint32_t none = 0xffffffff;
    friend bool operator==(const Look&, const Look&) = default;
  };
  std::span<const Look> looks() const;
  // Return the shape or texture of a number. A shape that varies keeps its number; when `changed` lists its drawable,
  // the number gives another shape.
  const std::shared_ptr<const Shape>& shape(std::uint32_t number) const;
  const std::shared_ptr<const Picture>& texture(std::uint32_t number) const;
  // Returns the drawables that differ in anything since the last `to`, in order. Returns all of them after the first
  // `to`, and if `use` has changed which drawables there are.
  std::span<const std::uint32_t> changed() const;
  // Tells a caller who misses some calls of `to` whether `changed` lists all that differs from the state it saw last.
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
  const std::vector<std::string>& problems() const;  // as in Frame
  const std::vector<Problem>& reports() const;

  Frame frame() const;  // the whole state as a value

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace betwixt
