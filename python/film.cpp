// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "base/names.h"
#include "betwixt/compare.h"
#include "betwixt/kind.h"
#include "betwixt/language.h"
#include "betwixt/object.h"
#include "betwixt/track.h"
#include "errors.h"
#include "says.h"
#include "syntax/texts.h"
#include "times.h"
#include "values.h"

namespace betwixt::python {

Film::Film(std::string text, const std::string& name, const LoadOptions& options) : name_(name), session_({}, options) {
  session_.begin(std::move(text), name);
  session_.keep_quiet();
  session_.edit_in_place();
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

// Splits a text into logical lines. Each has the number of lines of the text before it.
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

// Commands of the shell that would end the session or replace its film.
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
  // Makes line numbers count from the first line of the call. The session counted without blank lines.
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

Target one_target(const std::string& name, const Document& document) {
  const Result<std::vector<Target>> found = find_targets(name, document);
  if (!found) raise(found.error(), name);
  if (found->size() == 1) return found->front();
  raise(found->empty() ? nothing_named(name)
                       : fail(ErrorCode::name, "'" + name + "' names several values",
                              "use values() for all of them, or name one, such as ball.position"),
        name);
}

Session::Answer Film::set_track(const std::string& target, std::span<const Time> times, std::span<const double> numbers,
                                const std::string& twerper) {
  const std::lock_guard lock(mutex_);
  return session_.set_track(target, times, numbers, twerper);
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

std::string set_track(Film& film, const std::string& target, py::handle times, py::handle values,
                      const std::string& twerper) {
  using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const Document document = film.document();
  std::vector<Time> when;
  const bool plain =
      py::hasattr(times, "dtype") && py::str(times.attr("dtype").attr("kind")).cast<std::string>() != "m";
  if (plain) {
    const auto frames = Numbers::ensure(times);
    if (!frames || frames.ndim() != 1) throw py::type_error("times are a list or an array of one dimension");
    const Rate rate = document.rate();
    when.reserve(static_cast<std::size_t>(frames.size()));
    for (const double frame : std::span(frames.data(), static_cast<std::size_t>(frames.size()))) {
      if (!(std::abs((frame - 1) / rate.per_second()) <= longest_seconds)) (void)time_of(py::float_(frame), document);
      when.push_back(rate.frame(frame));
    }
  } else {
    when = times_of(times, document);
  }
  const auto numbers = Numbers::ensure(values);
  if (!numbers) throw py::type_error("values are numbers: a list or an array with a number or a row for each time");
  const std::span<const double> all(numbers.data(), static_cast<std::size_t>(numbers.size()));
  return told(unlocked([&] { return film.set_track(target, when, all, twerper); }));
}

py::tuple numbers_of_track(const Film& film, const std::string& target) {
  const Document document = film.document();
  Result<TrackNumbers> found = unlocked([&] { return track_numbers(document, target); });
  if (!found) raise(found.error(), target);
  py::array_t<double> frames(static_cast<py::ssize_t>(found->times.size()));
  double* to = frames.mutable_data();
  for (const Time t : found->times) *to++ = frame_of(t, document);
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(found->times.size())};
  if (found->width > 1) shape.push_back(static_cast<py::ssize_t>(found->width));
  py::array_t<double> values(shape);
  std::copy(found->numbers.begin(), found->numbers.end(), values.mutable_data());
  return py::make_tuple(frames, values);
}

void warn_all(const std::vector<std::string>& problems) {
  for (const std::string& p : problems) warn(p);
}

py::object eval(const Film& film, const std::string& name, py::handle when) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  const Target target = one_target(name, document);
  const bool one = is_one_time(when);
  std::vector<Time> times = one ? std::vector{time_of(when, document)} : times_of(when, document);
  const bool none = times.empty();
  if (none) times = {document.range().first};  // an empty list of times gives an empty array of the usual width
  std::vector<Value> values;
  std::vector<std::string> problems;
  unlocked([&] {
    for (const Time t : times) values.push_back(program.read(std::vector{target}, t, &problems).front());
  });
  if (!none) warn_all(problems);
  if (one) return to_python(values.front(), target, document);
  py::object all = to_python(values, target, document);
  return none ? all[py::slice(0, 0, 1)] : all;
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

// Calls f with the current document.
auto in_document(const Film& film, const auto& f) {
  return f(unlocked([&] { return film.document(); }));
}
auto of_document(auto f) {
  return [f](const Film& film) { return in_document(film, f); };
}

std::vector<std::pair<double, std::string>> notes(const Document& document) {
  std::vector<std::pair<double, std::string>> all;
  for (const Note& n : document.notes(earliest_time, latest_time)) all.emplace_back(frame_of(n.time, document), n.text);
  return all;
}

std::vector<std::pair<double, std::string>> cuts(const Document& document) {
  std::vector<std::pair<double, std::string>> all;
  for (const auto& [t, camera] : document.cuts())
    all.emplace_back(t == earliest_time ? -std::numeric_limits<double>::infinity() : frame_of(t, document),
                     document.name(camera));
  return all;
}

py::list sections_of(const Document& d) {
  py::list all;
  for (const Section& one : d.sections())
    all.append(py::dict(py::arg("name") = one.name, py::arg("begin") = frame_of(one.begin, d),
                        py::arg("end") = frame_of(one.end, d), py::arg("speed") = one.speed));
  return all;
}

py::list steps_of(const Document& d) {
  py::list all;
  for (const Pause& one : d.pauses())
    all.append(
        py::dict(py::arg("frame") = frame_of(one.time, d), py::arg("text") = one.text, py::arg("note") = one.note));
  return all;
}

std::vector<std::pair<double, std::string>> descriptions(const Document& document) {
  std::vector<std::pair<double, std::string>> all;
  for (const Description& one : document.descriptions()) all.emplace_back(frame_of(one.time, document), one.text);
  return all;
}

py::dict kinds_of(const Document& d) {
  py::dict all;
  for (const KindView& kind : own_kinds(d)) {
    py::dict instances;
    for (const InstanceView& one : kind.instances) {
      py::list own;
      for (const Target& t : one.own) own.append(d.name(t));
      instances[py::str(d.name(one.root))] = own;
    }
    all[py::str(kind.name)] = py::dict(py::arg("model") = d.name(kind.model), py::arg("hidden") = kind.hidden,
                                       py::arg("instances") = instances);
  }
  return all;
}

std::string_view kind_named(const Film& film, const std::string& name) {
  return in_document(film, [&](const Document& d) {
    const auto found = objects(d, name);
    if (found.size() == 1) return betwixt::name_of(kind(d, found.front()));
    raise(unknown_name("object", name), name);
  });
}

std::vector<double> breaks(const Film& film, py::handle after, py::handle until) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& d = program.document();
  std::vector<double> all;
  for (const Time t : program.discontinuities(time_of(after, d), time_of(until, d))) all.push_back(frame_of(t, d));
  return all;
}

}  // namespace

namespace {

// Returns a value for a `let` as a script would write it: 2.5, Ada, (1 2 3).
std::string as_written(const py::handle& value) {
  if (!py::isinstance<py::tuple>(value) && !py::isinstance<py::list>(value)) return py::str(value);
  std::string all;
  for (const py::handle& one : py::reinterpret_borrow<py::sequence>(value)) {
    const std::string text = as_written(one);
    all += (all.empty() ? "" : " ") + (py::isinstance<py::str>(one) ? write_text(text) : text);
  }
  return "(" + all + ")";
}

LoadOptions options_of(bool read_anywhere, bool tex, const std::map<std::string, py::object>& lets,
                       const std::optional<std::string>& language) {
  LoadOptions options{.read_anywhere = read_anywhere, .tex = tex};
  for (const auto& [name, value] : lets) options.lets.push_back({name, as_written(value)});
  options.language = language;
  return options;
}

}  // namespace

py::class_<Film> bind_film(py::module_& m) {
  py::class_<Film> film(m, "Film",  // inspect.signature of a class reads this, not __init__.
                        "Film(text, name='', *, read_anywhere=False, tex=False, lets={}, language=None)\n--\n\n"
                        "The film of a script. You can read and change it from any thread.");
  film.def(py::init([](std::string text, const std::string& name, bool read_anywhere, bool tex,
                       const std::map<std::string, py::object>& lets, const std::optional<std::string>& language) {
             const LoadOptions options = options_of(read_anywhere, tex, lets, language);
             auto film = unlocked([&] { return std::make_unique<Film>(std::move(text), name, options); });
             if (const Diagnostics all = film->diagnostics(); has_errors(all)) raise(all);
             warn(film->diagnostics());
             return film;
           }),
           py::arg("text"), py::arg("name") = "", py::kw_only(), py::arg("read_anywhere") = false,
           py::arg("tex") = false, py::arg("lets") = std::map<std::string, py::object>(),
           py::arg("language") = py::none(),
           says("Makes a film of the text of a script. `name` is the name of its file. `lets` has other values for the "
                "script's lets; `language` is a catalogue (.po) of its texts."))
      .def_property_readonly("name", &Film::name, "The name of the script file; empty if it has none.")
      .def_property_readonly(
          "text", [](const Film& f) { return unlocked([&] { return f.text(); }); }, "The script, as it is now.")
      .def_property_readonly("rate", of_document([](const Document& d) { return d.rate().per_second(); }),
                             "Frames a second.")
      .def_property_readonly("range", of_document([](const Document& d) {
                               const auto [first, last] = d.range();
                               return std::pair(frame_of(first, d), frame_of(last, d));
                             }),
                             "The first frame and the last.")
      .def_property_readonly("size", of_document([](const Document& d) { return d.size(); }),
                             "Width and height of its pictures in pixels; None if the script has no size.")
      .def_property_readonly("objects", of_document([](const Document& d) { return d.names(); }),
                             "The names of all objects, in the order of their creation.")
      .def_property_readonly("notes", of_document(notes),
                             "The notes of the script: frame and text, in the order of time.")
      .def_property_readonly("cuts", of_document(cuts),
                             "The cuts: frame and name of the new camera. The first camera begins at minus infinity.")
      .def_property_readonly(
          "sections", of_document(sections_of),
          "The sections of the script: a dict of the \"name\", the frames \"begin\" and \"end\", and "
          "the \"speed\" of each.")
      .def_property_readonly("steps", of_document(steps_of),
                             "Where a speaker waits: a dict of the \"frame\", the \"text\" and the \"note\" of each.")
      .def_property_readonly("descriptions", of_document(descriptions),
                             "What is to be seen, for people who cannot see it: frame and text, in the order of time.")
      .def_property_readonly(
          "kinds", of_document(kinds_of),
          "The kinds that the script defines: the name of each with a dict of its \"model\", whether "
          "it is \"hidden\", and its \"instances\". These are names of objects, each with a list of "
          "what no longer follows the model.")
      .def("kind", kind_named, py::arg("name"), says("Returns the kind of an object, such as \"sphere\"."))
      .def(
          "time",
          [](const Film& f, py::handle t) {
            return in_document(f, [&](const Document& d) { return frame_of(time_of(t, d), d); });
          },
          py::arg("time"), says("Returns the frame number of a time."))
      .def(
          "seconds",
          [](const Film& f, py::handle t) {
            return in_document(f, [&](const Document& d) { return time_of(t, d).seconds(); });
          },
          py::arg("time"), says("Returns a time in seconds since the beginning, which is frame 1."))
      .def("breaks", breaks, py::arg("after"), py::arg("until"),
           says("Returns the frames after `after` and up to `until` at which something may jump."))
      .def("eval", eval, py::arg("target"), py::arg("time"),
           says("Returns the value of a target at a time, or an array with a row for each of many times. A time is a "
                "frame "
                "number, a text such as \"24f\" or \"2.5s\", or a timedelta."))
      .def("values", values, py::arg("time"), py::arg("pattern") = "",
           says("Returns the values that a pattern names, by name; without a pattern, all values of all objects."))
      .def(
          "say", [](Film& f, const std::string& lines) { return told(unlocked([&] { return f.say(lines); })); },
          py::arg("lines"),
          says("Carries out lines of the language, all of them or none, and returns the answer of a shell."))
      .def(
          "set_track", &set_track, py::arg("target"), py::arg("times"), py::arg("values"), py::arg("twerper") = "",
          says("Replaces all events of a track: one for each time, in order. `values` has a number for each time, or a "
               "row of two or three: metres, radians, or sRGB from 0 to 1."))
      .def("track_numbers", &numbers_of_track, py::arg("target"),
           says("Returns the events of a track as two arrays: their frames, and their values as set_track takes them."))
      .def(
          "undo", [](Film& f) { return told(unlocked([&] { return f.enter("undo"); })); },
          says("Undoes the last step."))
      .def(
          "redo", [](Film& f) { return told(unlocked([&] { return f.enter("redo"); })); },
          says("Redoes the last step that was undone."))
      .def(
          "write",
          [](const Film& f, const std::filesystem::path& path) {
            const auto text = py::bytes(unlocked([&] { return f.text(); }));
            py::module_::import("pathlib").attr("Path")(path).attr("write_bytes")(text);
          },
          py::arg("path"), says("Writes the script, `text`, to a file."))
      .def(
          "player",
          [](const py::object& self, const py::object& first, const py::object& last, const py::object& size,
             const std::string& style, int most) {
            return py::module_::import("betwixt._player")
                .attr("Player")(self, first, last, py::arg("size") = size, py::arg("style") = style,
                                py::arg("most") = most);
          },
          py::arg("first") = py::none(), py::arg("last") = py::none(), py::kw_only(),
          py::arg("size") = py::make_tuple(480, 270), py::arg("style") = "shaded", py::arg("most") = 60,
          says(
              "Returns a player for notebooks: at most `most` pictures from the first frame to the last, with a button "
              "and a slider."))
      .def(
          "_repr_html_", [](const py::object& self) { return self.attr("player")().attr("_repr_html_")(); },
          says("Returns the player as HTML, for notebooks."))
      .def(
          "__repr__",
          [](const Film& f) {
            return py::str("<Film {!r} of {} objects>").format(f.name(), f.document().names().size());
          },
          says("Returns the name of the film and the number of its objects."));
  m.def(
      "diff",
      [](const Film& old, const Film& now) {
        return unlocked([&] {
          std::vector<std::string> words;
          for (const FilmChange& c : compare(old.document(), now.document())) words.push_back(c.words);
          return words;
        });
      },
      py::arg("old"), py::arg("now"),
      says("Returns what has changed from one film to another, in words, as `betwixt diff` prints it."));
  return film;
}

}  // namespace betwixt::python
