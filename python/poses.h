// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The world matrices of all objects over a range of frames, as one array.
#pragma once

#include <pybind11/pybind11.h>

#include "film.h"

namespace betwixt::python {

void bind_poses(py::module_&, py::class_<Film>&);

}  // namespace betwixt::python
