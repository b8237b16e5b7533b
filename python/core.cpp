// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The module betwixt._core. betwixt/__init__.py imports its names for users, and betwixt/_core.pyi has their types.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "errors.h"
#include "film.h"
#include "frames.h"
#include "keys.h"
#include "pictures.h"
#include "poses.h"
#include "tracks.h"

namespace {

// Refuses objects that __new__ has made without __init__: pybind11 would use their uninitialised memory.
void refuse_what_was_never_made(const pybind11::module_& m) {
  for (const auto& [name, what] : m.attr("__dict__").cast<pybind11::dict>())
    if (PyType_Check(what.ptr()))
      if (auto* type = pybind11::detail::get_type_info(reinterpret_cast<PyTypeObject*>(what.ptr())))
        type->operator_new = [](std::size_t) -> void* {
          throw pybind11::type_error(
              "this object was made by __new__ alone and is empty: use betwixt.load for films, and "
              "films for the rest");
        };
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  pybind11::options options;
  options.disable_function_signatures();  // says() writes better ones
  m.attr("version") = BETWIXT_VERSION;
  // Imports numpy now, in one thread. If several threads imported it with their first arrays, they would deadlock.
  try {
    pybind11::module_::import("numpy");
    pybind11::detail::npy_api::get();
  } catch (pybind11::error_already_set& e) {
    if (!e.matches(PyExc_ImportError)) throw;
    throw pybind11::import_error("betwixt needs numpy: pip install numpy (on Debian: apt-get install python3-numpy)");
  }
  betwixt::python::bind_errors(m);
  auto film = betwixt::python::bind_film(m);
  betwixt::python::bind_tracks(m, film);
  betwixt::python::bind_poses(m, film);
  betwixt::python::bind_frames(m, film);
  betwixt::python::bind_keys(m, film);
  betwixt::python::bind_pictures(m, film);
  refuse_what_was_never_made(m);
}
