// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include <pybind11/stl.h>

#include <string>

#include "base/error_words.h"
#include "base/utf8.h"
#include "says.h"

namespace betwixt::python {
namespace {

// Returns a text of a file for Python. Bytes that are not UTF-8 become U+FFFD.
py::str shown(std::string_view text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

py::object classes() { return py::module_::import("betwixt._errors"); }

std::string_view without_newline(const std::string& text) {
  return std::string_view(text).substr(0, text.find_last_not_of('\n') + 1);
}

}  // namespace

void raise(Diagnostics all) { throw Failure{std::move(all)}; }
void raise(const Error& e) { raise(Diagnostics{{Severity::error, e, {}, 0}}); }
void raise(const Error& e, std::string_view word) {
  Diagnostic d{Severity::error, e, std::string(word), 0};
  if (d.what.place.line == 0) d.what.place = {{}, 1, 1, static_cast<int>(word.size())};
  d.caret = d.what.place.column - 1;
  raise(Diagnostics{std::move(d)});
}

void warn(const std::string& message) {
  const py::object category = classes().attr("Warning");
  const std::string shown_lines = visible_lines(message);
  const std::string_view text = without_newline(shown_lines);
  if (PyErr_WarnEx(category.ptr(), py::str(shown(text)).cast<std::string>().c_str(), 2) < 0)
    throw py::error_already_set();
}

void warn(const Diagnostics& all) {
  for (const Diagnostic& d : all)
    if (d.severity == Severity::warning) warn(to_string(d));
}

void bind_errors(py::module_& m) {
  py::class_<Diagnostic>(m, "Diagnostic", "An error, a warning or a notice about a script.")
      .def_property_readonly(
          "severity", [](const Diagnostic& d) { return word_of(d.severity); }, "\"notice\", \"warning\" or \"error\".")
      .def_property_readonly(
          "code", [](const Diagnostic& d) { return word_of(d.what.code); },
          "Its sort: \"syntax\", \"name\", \"type\", \"range\", \"file\" or \"machine\".")
      .def_property_readonly(
          "message", [](const Diagnostic& d) { return shown(d.what.message); }, "The message.")
      .def_property_readonly(
          "hint", [](const Diagnostic& d) { return shown(d.what.hint); }, "A suggestion; may be empty.")
      .def_property_readonly(
          "file", [](const Diagnostic& d) { return shown(d.what.place.file); }, "The file; may be empty.")
      .def_property_readonly(
          "line", [](const Diagnostic& d) { return d.what.place.line; }, "The line, from 1; 0 if the place is unknown.")
      .def_property_readonly(
          "column", [](const Diagnostic& d) { return d.what.place.column; }, "The column, from 1, in characters.")
      .def_property_readonly(
          "length", [](const Diagnostic& d) { return d.what.place.length; }, "The length of the place, in characters.")
      .def_property_readonly(
          "text", [](const Diagnostic& d) { return shown(d.line); }, "The text of the line.")
      .def(
          "__str__", [](const Diagnostic& d) { return shown(without_newline(to_string(d))); },
          says("Formats the diagnostic as the program does: the line, a caret below the place, a hint."))
      .def(
          "__repr__",
          [](const Diagnostic& d) {
            return py::str("<Diagnostic {}>")
                .format(shown(without_newline(to_string(d))).attr("splitlines")().attr("__getitem__")(0));
          },
          says("Its first line."));
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const Failure& f) {
      const py::object type = classes().attr("Error");
      PyErr_SetObject(type.ptr(), type(py::cast(f.all)).ptr());
    }
  });
}

}  // namespace betwixt::python
