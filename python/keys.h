// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion as channels of keys, which other programs can play.
#pragma once

#include <pybind11/pybind11.h>

#include "film.h"

namespace betwixt::python {

void bind_keys(py::module_&, py::class_<Film>&);

}  // namespace betwixt::python
