// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film.h"

#include <pybind11/stl.h>

#include <vector>

#include "betwixt/language.h"
#include "errors.h"
#include "times.h"
#include "values.h"

namespace betwixt::python {

Film::Film(std::string text, const std::string& name, const LoadOptions& options) : name_(name), session_({}, options) {
  session_.begin(std::move(text), name);
  session_.keep_quiet();
  session_.keep_in_place();
}

Document Film::document() const {
  const std::lock_guard lock(mutex_);
  return session_.document();
}

Program Film::program() const {
  const std::lock_guard lock(mutex_);
  const Document& document = session_.document();
  if (!program_ || &program_->document().scene() != &document.scene())
    program_ = program_ ? Program::compile(document, *program_) : Program::compile(document);
  return *program_;
}

std::string Film::text() const {
  const std::lock_guard lock(mutex_);
  return session_.text();
}

Diagnostics Film::diagnostics() const {
  const std::lock_guard lock(mutex_);
  return session_.diagnostics();
}

namespace {

// A text as logical lines; of each, how many lines of the text stand before it.
std::pair<std::vector<std::string>, std::vector<int>> logical_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::vector<int> before;
  std::string line;
  int first = 0, n = 0;
  for (std::size_t at = 0; at <= text.size(); ++n) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    line += (line.empty() ? "" : "\n") + text.substr(at, end - at);
    at = end + 1;
    const bool blank = line.find_first_not_of(" \t\r\n") == std::string::npos;
    if (!blank && at <= text.size() && Session::needs_more(line)) continue;
    if (!blank) lines.push_back(line), before.push_back(first);
    line.clear(), first = n + 1;
  }
  return {lines, before};
}

// Words of the shell that would end the session, or put another film in its place.
bool leaves(const std::string& line) {
  const std::size_t from = line.find_first_not_of(" \t");
  const std::string word = line.substr(from, line.find_first_of(" \t", from) - from);
  return word == "quit" || word == "exit" || word == "open" || word == "save";
}

Session::Answer refused(const std::string& message, const std::string& hint) {
  return {false, false, true, {}, {{Severity::error, fail(ErrorCode::name, message, hint), {}, 0}}};
}

}  // namespace

Session::Answer Film::say(const std::string& text) {
  const auto [lines, before] = logical_lines(text);
  for (const std::string& line : lines)
    if (leaves(line)) return refused("there is no shell here to leave", "betwixt.load opens films, write keeps them");
  const std::lock_guard lock(mutex_);
  Session::Answer answer = session_.enter_together(lines);
  // Places count from the first line that was said; those before a line were counted without blank ones.
  int counted = 0;
  std::size_t k = 0;
  for (Diagnostic& d : answer.why) {
    if (!d.what.place.file.empty() || d.what.place.line == 0) continue;
    const auto length = [&](std::size_t i) { return 1 + static_cast<int>(std::ranges::count(lines[i], '\n')); };
    while (k + 1 < lines.size() && d.what.place.line > counted + length(k)) counted += length(k++);
    if (k < lines.size()) d.what.place.line += before[k] - counted;
  }
  return answer;
}

Session::Answer Film::enter(const std::string& word) {
  const std::lock_guard lock(mutex_);
  return session_.enter(word);
}

namespace {

std::string told(Session::Answer answer) {
  if (!answer.refused) {
    warn(answer.why);
    return std::move(answer.said);
  }
  raise(std::move(answer.why));
}

// A target that is one, not a pattern that names several.
Target one_target(const std::string& name, const Document& document) {
  const Result<std::vector<Target>> found = find_targets(name, document);
  if (!found) raise(found.error(), name);
  if (found->size() == 1) return found->front();
  raise(fail(ErrorCode::name, "'" + name + "' names " + (found->empty() ? "nothing" : "several values"),
             found->empty() ? "" : "values() gives all of them; one is such as ball.position"),
        name);
}

void warn_all(const std::vector<std::string>& problems) {
  for (const std::string& p : problems) warn(p);
}

py::object eval(const Film& film, const std::string& name, py::handle when) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  const Target target = one_target(name, document);
  const bool one = is_one_time(when);
  const std::vector<Time> times = one ? std::vector{time_of(when, document)} : times_of(when, document);
  std::vector<Value> values;
  std::vector<std::string> problems;
  unlocked([&] {
    for (const Time t : times) values.push_back(program.read(std::vector{target}, t, &problems).front());
  });
  warn_all(problems);
  return one ? to_python(values.front(), target, document) : to_python(values, target, document);
}

py::dict values(const Film& film, py::handle when, const std::string& pattern) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  const Time t = time_of(when, document);
  std::vector<Target> targets;
  for (const std::string& word : pattern.empty() ? document.names() : std::vector{pattern}) {
    const Result<std::vector<Target>> found = find_targets(word, document);
    if (!found) raise(found.error(), word);
    targets.insert(targets.end(), found->begin(), found->end());
  }
  std::vector<std::string> problems;
  const std::vector<Value> all = unlocked([&] { return program.read(targets, t, &problems); });
  warn_all(problems);
  py::dict made;
  for (std::size_t i = 0; i < targets.size(); ++i)
    made[py::str(document.name(targets[i]))] = to_python(all[i], targets[i], document);
  return made;
}

}  // namespace

void bind_film(py::module_& m) {
  py::class_<Film>(m, "Film")
      .def(py::init([](std::string text, const std::string& name, bool read_anywhere, bool tex) {
             const LoadOptions options{.read_anywhere = read_anywhere, .tex = tex};
             auto film = unlocked([&] { return std::make_unique<Film>(std::move(text), name, options); });
             if (const Diagnostics all = film->diagnostics(); has_errors(all)) raise(all);
             warn(film->diagnostics());
             return film;
           }),
           py::arg("text"), py::arg("name") = "", py::kw_only(), py::arg("read_anywhere") = false,
           py::arg("tex") = false)
      .def_property_readonly("name", &Film::name)
      .def_property_readonly("text", [](const Film& f) { return unlocked([&] { return f.text(); }); })
      .def_property_readonly("rate", [](const Film& f) { return f.document().rate().per_second(); })
      .def_property_readonly("objects", [](const Film& f) { return f.document().names(); })
      .def("eval", eval, py::arg("target"), py::arg("time"))
      .def("values", values, py::arg("time"), py::arg("pattern") = "")
      .def(
          "say", [](Film& f, const std::string& lines) { return told(unlocked([&] { return f.say(lines); })); },
          py::arg("lines"))
      .def("undo", [](Film& f) { return told(unlocked([&] { return f.enter("undo"); })); })
      .def("redo", [](Film& f) { return told(unlocked([&] { return f.enter("redo"); })); });
}

}  // namespace betwixt::python
