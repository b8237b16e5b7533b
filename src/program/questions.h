// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/compiled.h"
#include "track/procedure.h"

namespace betwixt {

// What the author's code can read of a film while a value at the time `t` is computed.
struct FilmQuestions : Questions {
  const Program::Compiled& c;
  Asking& asking;
  const Time t;
  const ObjectId object;    // the one whose value it is; none for a stepped procedure
  bool lacking = false;     // the object lacks a function that objects of other kinds have
  bool called_off = false;  // the work was cancelled; throw Cancelled after the code has returned
  FilmQuestions(const Program::Compiled& film, Asking& a, Time time, ObjectId id = {})
      : c(film), asking(a), t(time), object(id) {}

  double seconds() const override { return t.seconds(); }
  Rate rate() const override { return scene().rate; }
  std::string_view self() const override;
  const Routine* procedure(std::string_view name) override;
  Result<Value> value(std::string_view target, double seconds, std::uint64_t& cost) override;
  Result<Vec3> place(std::string_view line, double share, double seconds, std::uint64_t& cost) override;
  Status axes(std::string_view object, double seconds, AxesSpace& out, std::uint64_t& cost) override;
  Turn turn(std::string_view object) override;
  Result<State> state(std::string_view name, double seconds, std::uint64_t& cost) override;

 private:
  const Scene& scene() const { return c.document.scene(); }
  bool others_have(std::string_view target) const;
};

}  // namespace betwixt
