// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "poses.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <vector>

#include "betwixt/film.h"
#include "betwixt/object.h"
#include "betwixt/pose.h"
#include "errors.h"
#include "says.h"
#include "times.h"
#include "values.h"

namespace betwixt::python {
namespace {

// The arrays are ordered by frame, then by object.
struct Poses {
  std::vector<std::string> names;
  std::vector<double> frames;
  std::vector<Mat4> world;
  std::vector<std::int32_t> parents;  // indices in `names`; -1 for no parent
};

std::shared_ptr<const Poses> poses_at(const Program& program, const std::vector<Time>& times) {
  const Document& document = program.document();
  const std::vector<ObjectId> all = objects(document);
  auto made = std::make_shared<Poses>();
  std::vector<std::int32_t> place;  // by ObjectId::index
  for (const ObjectId id : all) {
    place.resize(id.index + 1, -1);
    place[id.index] = static_cast<std::int32_t>(made->names.size());
    made->names.push_back(document.name(id));
  }
  made->world.reserve(times.size() * all.size()), made->parents.reserve(times.size() * all.size());
  for (const Time t : times) {
    made->frames.push_back(frame_of(t, document));
    const std::vector<Pose> at = betwixt::poses(program, t);
    for (const ObjectId id : all) {
      const Pose& p = at[id.index];
      made->world.push_back(p.world);
      made->parents.push_back(p.parent && p.parent.index < place.size() ? place[p.parent.index] : -1);
    }
  }
  return made;
}

// A larger array is taken for a mistake in the call: this many matrices take 16 GiB.
constexpr std::size_t most = std::size_t{1} << 27;

std::shared_ptr<const Poses> poses(const Film& film, py::handle first, py::handle last, double step) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  const auto [begin, end] = document.range();
  const Time from = first.is_none() ? begin : time_of(first, document);
  const Time until = last.is_none() ? end : time_of(last, document);
  if (until < from) raise(fail(ErrorCode::range, "the segment ends before it begins"));
  if (!(step >= 1e-6)) raise(fail(ErrorCode::range, "a step is a number of frames above 0"));
  const double count = (frame_of(until, document) - frame_of(from, document)) / step + 1e-9;
  if (!(count < static_cast<double>(most / std::max<std::size_t>(1, document.names().size()))))
    raise(fail(ErrorCode::range, "that is more than can be held at once", "say fewer frames, or a larger step"));
  std::vector<Time> times;
  for (int k = 0; k <= static_cast<int>(count); ++k)
    times.push_back(document.rate().frame(document.rate().frame_number(from) + k * step));
  return unlocked([&] { return poses_at(program, times); });
}

constexpr py::ssize_t number = sizeof(double), matrix = sizeof(Mat4);
py::ssize_t row(const Poses& p) { return std::ssize(p.names) * matrix; }

}  // namespace

void bind_poses(py::module_& m, py::class_<Film>& film) {
  using Held = std::shared_ptr<Poses>;
  py::class_<Poses, Held>(m, "Poses", "The world matrices of all objects at each frame.")
      .def_readonly("names", &Poses::names, "The names of the objects, in their order.")
      .def_property_readonly(
          "frames",
          [](const Held& p) {
            return view(p->frames.data(), {std::ssize(p->frames)}, {sizeof(double)}, keep<Poses>(p));
          },
          "The frames, one for each row.")
      .def_property_readonly(
          "world",
          [](const Held& p) {
            return view(p->world.empty() ? nullptr : p->world.front().m.data(),
                        {std::ssize(p->frames), std::ssize(p->names), 4, 4}, {row(*p), matrix, number, 4 * number},
                        keep<Poses>(p));
          },
          "The world matrices, by frame, object, row and column.")
      .def_property_readonly(
          "parents",
          [](const Held& p) {
            const py::ssize_t n = std::ssize(p->names), whole = sizeof(std::int32_t);
            return view(p->parents.data(), {std::ssize(p->frames), n}, {n * whole, whole}, keep<Poses>(p));
          },
          "The parents, by frame and object: indices in `names`, -1 without a parent.")
      .def(
          "__len__", [](const Held& p) { return p->frames.size(); }, says("How many frames there are."))
      .def(
          "__getitem__",
          [](const Held& p, const std::string& name) {
            const auto found = std::ranges::find(p->names, name);
            if (found == p->names.end()) throw py::key_error(name);
            const auto place = static_cast<std::size_t>(found - p->names.begin());
            return view(p->world.empty() ? nullptr : p->world[place].m.data(), {std::ssize(p->frames), 4, 4},
                        {row(*p), number, 4 * number}, keep<Poses>(p));
          },
          py::arg("name"), says("Returns the matrices of one object, by frame, row and column."))
      .def(
          "__repr__",
          [](const Held& p) {
            return "<Poses of " + std::to_string(p->names.size()) + " objects in " + std::to_string(p->frames.size()) +
                   " frames>";
          },
          says("How many objects and frames there are."));
  film.def(
      "poses",
      [](const Film& f, py::handle first, py::handle last, double step) {
        return std::const_pointer_cast<Poses>(poses(f, first, last, step));
      },
      py::arg("first") = py::none(), py::arg("last") = py::none(), py::arg("step") = 1,
      says("Returns the world matrices of all objects at each frame, by default over the film's range."));
}

}  // namespace betwixt::python
