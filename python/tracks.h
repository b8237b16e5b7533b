// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the author wrote: tracks and the events on them.
#pragma once

#include <pybind11/pybind11.h>

#include "film.h"

namespace betwixt::python {

void bind_tracks(py::module_&, py::class_<Film>&);

}  // namespace betwixt::python
