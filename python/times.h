// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Times as Python says them: a number is a frame, as on the command line; a word is the language's ("24f", "2.5s"); a
// datetime.timedelta, or numpy's timedelta64, is a length since the beginning.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "betwixt/document.h"

namespace betwixt::python {

namespace py = pybind11;

Time time_of(py::handle said, const Document&);
// Whether it is one time and not many.
bool is_one_time(py::handle said);
std::vector<Time> times_of(py::handle many, const Document&);
// The frame's number, whole at frames.
double frame_of(Time, const Document&);

}  // namespace betwixt::python
