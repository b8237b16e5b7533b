// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film that Python holds: a session of which any thread may ask, and which any thread may change. Who asks gets the
// film as it is then, a document and its program, and goes on with these whatever becomes of the film.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "betwixt/program.h"
#include "betwixt/session.h"

namespace betwixt::python {

namespace py = pybind11;

class Film {
 public:
  // Errors: all of the text's.
  Film(std::string text, const std::string& name, const LoadOptions&);

  Document document() const;
  Program program() const;
  std::string text() const;
  const std::string& name() const { return name_; }
  Diagnostics diagnostics() const;
  // Lines of the language, all of them or none; what there is to tell, as the shell says it.
  Session::Answer say(const std::string& lines);
  Session::Answer enter(const std::string& word);

 private:
  const std::string name_;
  mutable std::mutex mutex_;  // waited for without the interpreter's lock
  Session session_;
  mutable std::optional<Program> program_;  // of the last document that was asked about
};

// The value that a word names. Raises an error if there is none, or if it is a pattern that names several.
Target one_target(const std::string& name, const Document&);

// Of the film itself; what else can be asked of it the other files add.
py::class_<Film> bind_film(py::module_&);

}  // namespace betwixt::python
