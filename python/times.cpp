// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "times.h"

#include <cmath>
#include <string>

#include "betwixt/language.h"
#include "errors.h"

namespace betwixt::python {
namespace {

Time of_words(const std::string& said, const Document& document) {
  const bool bare = !said.empty() && said.find_first_not_of("0123456789.-") == std::string::npos;
  const Result<Time> time = parse_time(bare ? said + "f" : said, document);
  if (!time) raise(time.error(), said);
  return *time;
}

Time in_reach(double seconds, Time (*make)(double, Rate), double n, Rate rate) {
  if (!(std::abs(seconds) <= longest_seconds))
    raise(fail(ErrorCode::range, std::isfinite(n) ? "this time is too far from the beginning" : "that is no time",
               "a number is a frame; seconds are words: \"2.5s\""));
  return make(n, rate);
}

// Returns whether an object is a numpy.timedelta64: a length of time in any unit.
bool is_timedelta64(py::handle said) {
  return py::hasattr(said, "dtype") && said.attr("dtype").attr("kind").cast<std::string>() == "m" &&
         said.attr("ndim").cast<int>() == 0;
}
double seconds_of(py::handle timedelta64) {
  const py::object second = py::module_::import("numpy").attr("timedelta64")(1, "s");
  return (py::reinterpret_borrow<py::object>(timedelta64) / second).cast<double>();  // errors: months, and the like
}

bool is_number(py::handle said) {
  return PyFloat_Check(said.ptr()) || PyIndex_Check(said.ptr()) || py::hasattr(said, "__float__");
}

}  // namespace

bool is_one_time(py::handle said) {
  return py::isinstance<py::str>(said) || py::hasattr(said, "total_seconds") || is_timedelta64(said) ||
         (is_number(said) && !(py::hasattr(said, "__len__") && !py::hasattr(said, "ndim")) &&
          !(py::hasattr(said, "ndim") && said.attr("ndim").cast<int>() > 0));
}

Time time_of(py::handle said, const Document& document) {
  if (py::isinstance<py::str>(said)) return of_words(py::bytes(said.attr("encode")()), document);
  if (py::hasattr(said, "total_seconds") || is_timedelta64(said)) {
    const double s = is_timedelta64(said) ? seconds_of(said) : said.attr("total_seconds")().cast<double>();
    return in_reach(s, [](double n, Rate) { return from_seconds(n); }, s, {});
  }
  if (py::isinstance<py::bool_>(said) || !is_one_time(said))
    throw py::type_error("a time is a frame's number, words such as \"24f\" or \"2.5s\", or a timedelta, not " +
                         py::repr(said).cast<std::string>().substr(0, 60));
  const double n = PyFloat_AsDouble(said.ptr());
  if (n == -1 && PyErr_Occurred()) throw py::error_already_set();
  const Rate rate = document.rate();
  return in_reach((n - 1) / rate.per_second(), [](double frame, Rate r) { return r.frame(frame); }, n, rate);
}

std::vector<Time> times_of(py::handle many, const Document& document) {
  if (!py::hasattr(many, "__iter__") && !py::hasattr(many, "__getitem__"))
    return {time_of(many, document)};  // raises an error that explains it
  std::vector<Time> times;
  for (const py::handle one : many) times.push_back(time_of(one, document));
  return times;
}

double frame_of(Time t, const Document& document) { return document.rate().frame_number(t); }

}  // namespace betwixt::python
