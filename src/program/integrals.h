// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Velocities that code computes. The value is that at the beginning of the reign plus the integral of the velocity
// since. The integral is kept in steps, like the states of a stepped procedure (steps.h). Each step is halved until
// both halves agree with the whole, so a jump of the velocity is found where it is.
#pragma once

#include <memory>
#include <vector>

#include "program/compiled.h"

namespace betwixt {

// `rates`: the part whose track is the velocity, per second, in plain numbers. `from`: the beginning of the reign.
// `spaced`: the object has a `velocity-space`, so its velocity may turn with it.
std::unique_ptr<NamedProcedure> make_integral(const Live&, LivePart rates, Time from, bool spaced, std::string name);

// Sets out to the integral from the beginning of the reign to t: numbers, or the rotation since, as four numbers.
void integral_at(const Program::Compiled&, const NamedProcedure& integral, Time t, Asking&, double* out);
// Sets out to the velocity itself.
void rate_at(const Program::Compiled&, const NamedProcedure& integral, Time t, Asking&, double* out);

}  // namespace betwixt
