// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures and films.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "betwixt/mesh.h"
#include "film.h"

namespace betwixt::python {

struct Pixels {
  std::shared_ptr<const Picture> picture;
};

void bind_pictures(py::module_&, py::class_<Film>&);

}  // namespace betwixt::python
