// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts values to Python: numbers, arrays of numbers and texts. A reference to an object becomes the object's name.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/math.h"

namespace betwixt::python {

namespace py = pybind11;

py::object to_python(const Value&, const Target&, const Document&);
// Converts the values of one target at many times: an array if all have equally many numbers, otherwise a list.
py::object to_python(const std::vector<Value>&, const Target&, const Document&);

py::array_t<double> array_of(Vec3);
py::array_t<double> array_of(const Mat4&);  // [row, column]
py::str name_of(ObjectId, const Document&);

// Returns a read-only array that views numbers in place. The array keeps `owner` alive.
template <class T>
py::array_t<T> view(const T* numbers, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                    py::handle owner) {
  py::array_t<T> made(std::move(shape), std::move(strides), numbers, owner);
  made.attr("setflags")(py::arg("write") = false);
  return made;
}

// Returns a capsule that keeps `what` alive: an owner for view().
template <class T>
py::capsule keep(std::shared_ptr<const T> what) {
  return py::capsule(new std::shared_ptr<const T>(std::move(what)),
                     [](void* kept) { delete static_cast<std::shared_ptr<const T>*>(kept); });
}

}  // namespace betwixt::python
