// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The Film of Python: a session that any thread may read and change. A reader gets the current document and its
// program, and can use them even if the film changes later.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "betwixt/program.h"
#include "betwixt/session.h"

namespace betwixt::python {

namespace py = pybind11;

class Film {
 public:
  // Raises all errors of the text.
  Film(std::string text, const std::string& name, const LoadOptions&);

  Document document() const;
  Program program() const;
  std::string text() const;
  const std::string& name() const { return name_; }
  Diagnostics diagnostics() const;
  // Carries out lines of the language, all or none. Returns the answers of the shell.
  Session::Answer say(const std::string& lines);
  Session::Answer enter(const std::string& word);
  Session::Answer set_track(const std::string& target, std::span<const Time> times, std::span<const double> numbers,
                            const std::string& twerper);

 private:
  const std::string name_;
  mutable std::mutex mutex_;  // lock it only without the interpreter's lock
  Session session_;
  mutable std::optional<Program> program_;  // compiled for the last document that was needed
};

// Returns the target that a word names. Raises an error if it names none, or if it is a pattern that names several.
Target one_target(const std::string& name, const Document&);

// Defines the class Film. The other files add methods to it.
py::class_<Film> bind_film(py::module_&);

}  // namespace betwixt::python
