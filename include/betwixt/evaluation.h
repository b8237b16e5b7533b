// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A program at a time, kept from one time to the next by whoever plays it: what did not change on the way costs
// nothing. The frame comes as columns, one place a drawable (an object of a kind that can be drawn, seen or not, in the
// order of the objects), with the places that differ since the last time. What it gives for a time never depends on the
// times before. One thread at a time; any number of threads each with their own.
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

class Beside;  // src/program/beside.h

class Evaluation {
 public:
  explicit Evaluation(const Program&);
  // Each frame is ready in time: `beside` works out what may take long, and a slow value is the last one that has come.
  Evaluation(const Program&, Beside& beside);
  Evaluation(Evaluation&&) noexcept;
  Evaluation& operator=(Evaluation&&) noexcept;
  ~Evaluation();

  void to(Time);
  // Goes on with an edited program: the next `to` says what differs from what the one before gave.
  void use(const Program&);

  const Program& program() const;
  Time time() const;  // of the last `to`

  // Columns: valid until the next `to` or `use`; before the first `to` they say nothing.
  std::span<const ObjectId> drawables() const;
  std::span<const Mat4> worlds() const;  // object space to world space
  // What it looks like; nothing of it is said where it is not seen.
  struct Look {
    Vec3 color{1, 1, 1};                                        // linear light
    double transparency = 0, shininess = 0;                     // as Item's
    double blend = 0;                                           // how far it is on the way to `toward`
    std::uint32_t shape = none, toward = none, texture = none;  // numbers
    Material material = Material::plastic;
    bool visible = false;
    bool casts = true;  // keeps light from others
    static constexpr std::uint32_t none = 0xffffffff;
    friend bool operator==(const Look&, const Look&) = default;
  };
  std::span<const Look> looks() const;
  // What the numbers stand for. That of a shape that varies stays, and the shape is another one where `changed` says
  // so.
  const std::shared_ptr<const Shape>& shape(std::uint32_t number) const;
  const std::shared_ptr<const Picture>& texture(std::uint32_t number) const;
  // The drawables of which anything differs since the last `to`, in order; all after the first one, and where `use` has
  // brought other drawables.
  std::span<const std::uint32_t> changed() const;
  // For who does not see every `to`: whether `changed` is all that differs from what he saw last.
  struct Revision {
    std::uint64_t program = 0;  // another one after each `use`; no two evaluations have the same
    std::uint64_t times = 0;    // how often `to` was called since
    friend bool operator==(const Revision&, const Revision&) = default;
  };
  Revision revision() const;

  const std::vector<Light>& lights() const;
  const Camera& camera() const;
  // From now on the camera is this one, wherever the film's is; none: the film's again.
  void look_from(std::optional<Camera>);
  const std::vector<std::string>& problems() const;  // as Frame's
  const std::vector<Frame::CodeError>& errors() const;

  Frame frame() const;  // all of it as a value

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace betwixt
