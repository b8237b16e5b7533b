// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Docstrings with signatures. Pass `says("…")` as the last argument of def(): it makes a signature of the py::arg
// before it, in the form that inspect.signature reads. Notebooks and editors show both.
#pragma once

#include <pybind11/pybind11.h>

#include <deque>
#include <string>

namespace betwixt::python {

namespace py = pybind11;

struct Says {
  const char* words;
};
inline Says says(const char* words) { return {words}; }

// Returns a signature such as "eval(self, target, time)".
inline std::string signature_of(const py::detail::function_record& f) {
  std::string all = std::string(f.name) + "(";
  auto add = [&, first = true](const std::string& word) mutable { all += (first ? "" : ", ") + word, first = false; };
  if (f.is_method && f.args.empty()) add("self");
  for (std::size_t i = 0; i < f.args.size(); ++i) {
    if (i == f.nargs_pos) add("*");
    const py::detail::argument_record& a = f.args[i];
    add(a.value ? std::string(a.name) + "=" + py::repr(a.value).cast<std::string>() : a.name);
  }
  return all + ")";
}

}  // namespace betwixt::python

template <>
struct pybind11::detail::process_attribute<betwixt::python::Says>
    : pybind11::detail::process_attribute_default<betwixt::python::Says> {
  static void init(const betwixt::python::Says& said, function_record* f) {
    static std::deque<std::string> kept;  // pybind11 copies it later
    f->doc = kept.emplace_back(betwixt::python::signature_of(*f) + "\n--\n\n" + said.words).data();
  }
};
