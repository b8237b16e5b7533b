// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What goes wrong becomes the exception betwixt.Error, which knows all that a diagnostic knows.
#pragma once

#include <pybind11/pybind11.h>

#include <string_view>
#include <utility>

#include "betwixt/result.h"

namespace betwixt::python {

namespace py = pybind11;

struct Failure {
  Diagnostics all;
};

[[noreturn]] void raise(Diagnostics);
[[noreturn]] void raise(const Error&);
// About a word that was handed over: the caret stands below it.
[[noreturn]] void raise(const Error&, std::string_view word);

template <class T>
T value_or_raise(Result<T> result) {
  if (!result) raise(result.error());
  return *std::move(result);
}

// Says warnings as Python's own, once for each place of the caller.
void warn(const Diagnostics&);
void warn(const std::string& message);

void bind_errors(py::module_&);

// What takes a while, or waits: other threads of Python go on meanwhile.
template <class F>
auto unlocked(F f) {
  const py::gil_scoped_release released;
  return f();
}

}  // namespace betwixt::python
