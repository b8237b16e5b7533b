// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Turns errors into the exception betwixt.Error, which has everything that a diagnostic has.
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
// Raises an error about a word of the caller's argument. The caret is below the word.
[[noreturn]] void raise(const Error&, std::string_view word);

template <class T>
T value_or_raise(Result<T> result) {
  if (!result) raise(result.error());
  return *std::move(result);
}

// Issues the warnings among the diagnostics as Python warnings, once for each place of the caller.
void warn(const Diagnostics&);
void warn(const std::string& message);

void bind_errors(py::module_&);

// Calls f without the interpreter's lock, so that other Python threads run while it works or waits.
template <class F>
auto unlocked(F f) {
  const py::gil_scoped_release released;
  return f();
}

}  // namespace betwixt::python
