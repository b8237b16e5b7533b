// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tracks of the script and their events, as the author wrote them.
#pragma once

#include <pybind11/pybind11.h>

#include "film.h"

namespace betwixt::python {

void bind_tracks(py::module_&, py::class_<Film>&);

}  // namespace betwixt::python
