// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Frames: everything visible at a time, as items with matrices, colours and triangles.
#pragma once

#include <pybind11/pybind11.h>

#include "film.h"

namespace betwixt::python {

void bind_frames(py::module_&, py::class_<Film>&);

}  // namespace betwixt::python
