// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts times of Python. A number is a frame, as on the command line. A text is written as in the language ("24f",
// "2.5s"). A datetime.timedelta or numpy's timedelta64 is the time since the beginning.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "betwixt/document.h"

namespace betwixt::python {

namespace py = pybind11;

Time time_of(py::handle said, const Document&);
// Returns whether the argument is one time and not a list or an array of times.
bool is_one_time(py::handle said);
std::vector<Time> times_of(py::handle many, const Document&);
// Returns the frame number of a time: an integer at a frame, a fraction between two frames.
double frame_of(Time, const Document&);

}  // namespace betwixt::python
