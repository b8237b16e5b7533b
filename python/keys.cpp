// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/keys.h"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "betwixt/language.h"
#include "errors.h"
#include "film.h"
#include "keys.h"
#include "says.h"
#include "times.h"
#include "values.h"

namespace betwixt::python {
namespace {

struct ChannelOf {
  Document document;
  std::shared_ptr<const Channel> channel;
};
struct PieceOf {
  ChannelOf of;
  const KeyPiece* piece;
  const KeyPiece* operator->() const { return piece; }
};
struct KeysOf {
  Document document;
  ObjectKeys keys;
  ChannelOf channel(const Channel& c) const { return {document, std::make_shared<const Channel>(c)}; }
};

py::array_t<double> numbers(const PieceOf& p, const std::array<double, 4>& all) {
  return py::array_t<double>(static_cast<py::ssize_t>(p.of.channel->width), all.data());
}

KeyOptions options_of(const std::string& style, double metres, double radians, bool arcs) {
  KeyOptions made;
  made.metres = metres, made.radians = radians, made.arcs = arcs;
  if (style == "linear")
    made.style = KeyStyle::linear;
  else if (style == "baked")
    made.style = KeyStyle::baked;
  else if (style != "cubic")
    raise(fail(ErrorCode::name, "no style of keys is called '" + style + "'", "cubic, linear or baked"), style);
  if (!(metres >= 1e-9 && radians >= 1e-9)) raise(fail(ErrorCode::range, "a tolerance is at least a billionth"));
  return made;
}

std::pair<Time, Time> segment_of(py::handle first, py::handle last, const Document& document) {
  auto [from, until] = document.range();
  if (!first.is_none()) from = time_of(first, document);
  if (!last.is_none()) until = time_of(last, document);
  if (until < from) raise(fail(ErrorCode::range, "the segment ends before it begins"));
  return {from, until};
}

std::vector<KeysOf> motion(const Film& film, py::handle first, py::handle last, const std::string& style, double metres,
                           double radians, bool arcs) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  KeyOptions options = options_of(style, metres, radians, arcs);
  options.go_on = [](double) {  // so that Ctrl-C works
    const py::gil_scoped_acquire held;
    return PyErr_CheckSignals() == 0;
  };
  const auto [from, until] = segment_of(first, last, document);
  std::vector<KeysOf> made;
  for (ObjectKeys& k : unlocked([&, from = from, until = until] { return motion_keys(program, from, until, options); }))
    made.push_back({document, std::move(k)});
  if (PyErr_Occurred()) throw py::error_already_set();
  return made;
}

ChannelOf keys(const Film& film, const std::string& name, py::handle first, py::handle last, const std::string& style,
               double tolerance) {
  const Program program = unlocked([&] { return film.program(); });
  const Document& document = program.document();
  const Target target = one_target(name, document);
  const KeyOptions options = options_of(style, tolerance, tolerance, false);
  const auto [from, until] = segment_of(first, last, document);
  auto made = std::make_shared<const Channel>(
      unlocked([&, from = from, until = until] { return value_keys(program, target, from, until, options); }));
  if (made->pieces.empty()) raise(fail(ErrorCode::type, "'" + name + "' is not made of numbers"), name);
  return {document, std::move(made)};
}

std::string_view word_of(KeyPiece::Shape shape) {
  static constexpr std::string_view words[] = {"held", "straight", "cubic", "leap"};
  return words[static_cast<std::size_t>(shape)];
}

}  // namespace

void bind_keys(py::module_& m, py::class_<Film>& film) {
  py::class_<PieceOf>(m, "KeyPiece", "A piece of time in which a value is held, linear or cubic.")
      .def_property_readonly(
          "shape", [](const PieceOf& p) { return word_of(p->shape); }, "\"held\", \"straight\", \"cubic\" or \"leap\".")
      .def_property_readonly(
          "first", [](const PieceOf& p) { return frame_of(p->from, p.of.document); }, "The frame at which it begins.")
      .def_property_readonly(
          "last", [](const PieceOf& p) { return frame_of(p->until, p.of.document); }, "The frame at which it ends.")
      .def_property_readonly(
          "begin", [](const PieceOf& p) { return numbers(p, p->begin); },
          "The value at its beginning: one number for each component.")
      .def_property_readonly(
          "end", [](const PieceOf& p) { return numbers(p, p->end); }, "The value at its end.")
      .def_property_readonly(
          "leaving", [](const PieceOf& p) { return numbers(p, p->leaving); },
          "If cubic: the tangent at `first`, per second.")
      .def_property_readonly(
          "arriving", [](const PieceOf& p) { return numbers(p, p->arriving); },
          "If cubic: the tangent at `last`, per second.")
      .def(
          "__repr__",
          [](const PieceOf& p) {
            return py::str("<KeyPiece {}, {} to {}>")
                .format(word_of(p->shape), format_time(p->from, p.of.document), format_time(p->until, p.of.document));
          },
          says("Its shape and its frames."));
  py::class_<ChannelOf>(m, "Channel", "A value over time: pieces that follow each other without gaps.")
      .def_property_readonly(
          "width", [](const ChannelOf& c) { return c.channel->width; }, "How many numbers it has.")
      .def_property_readonly(
          "constant", [](const ChannelOf& c) { return c.channel->constant(); }, "Whether the value never changes.")
      .def_property_readonly(
          "keys", [](const ChannelOf& c) { return c.channel->keys(); }, "The number of keys that a player needs.")
      .def_property_readonly(
          "pieces",
          [](const ChannelOf& c) {
            std::vector<PieceOf> all;
            for (const KeyPiece& p : c.channel->pieces) all.push_back({c, &p});
            return all;
          },
          "Its pieces, in the order of time.")
      .def(
          "at",
          [](const ChannelOf& c, py::handle when) {
            const auto v = value_at(*c.channel, time_of(when, c.document));
            return py::array_t<double>(static_cast<py::ssize_t>(c.channel->width), v.data());
          },
          py::arg("time"), says("Returns the value at a time, as a player interpolates it."));
  py::class_<KeysOf>(m, "ObjectKeys",
                     "The motion of an object: its parent's matrix times translation, rotation and scale.")
      .def_property_readonly(
          "name", [](const KeysOf& k) { return name_of(k.keys.id, k.document); }, "The name of the object.")
      .def_property_readonly(
          "parent",
          [](const KeysOf& k) -> py::object {
            if (!k.keys.parent) return py::none();
            return name_of(k.keys.parent, k.document);
          },
          "Its parent; None for no parent.")
      .def_property_readonly(
          "sheared", [](const KeysOf& k) { return k.keys.sheared; }, "Whether it needs `inner` too.")
      .def_property_readonly(
          "translation", [](const KeysOf& k) { return k.channel(k.keys.translation); }, "The translation, in metres.")
      .def_property_readonly(
          "rotation", [](const KeysOf& k) { return k.channel(k.keys.rotation); }, "The rotation: quaternions, x y z w.")
      .def_property_readonly(
          "scale", [](const KeysOf& k) { return k.channel(k.keys.scale); }, "The scale.")
      .def_property_readonly(
          "inner", [](const KeysOf& k) { return k.channel(k.keys.inner); },
          "A further rotation, applied before the scale, if the object is sheared.")
      .def(
          "__repr__", [](const KeysOf& k) { return "<ObjectKeys of " + k.document.name(k.keys.id) + ">"; },
          says("Its name."));
  film.def("motion", motion, py::arg("first") = py::none(), py::arg("last") = py::none(), py::kw_only(),
           py::arg("style") = "cubic", py::arg("metres") = 1e-4, py::arg("radians") = 1e-4, py::arg("arcs") = true,
           says("Returns the motion of all objects, as keys within a tolerance."));
  film.def("keys", keys, py::arg("target"), py::arg("first") = py::none(), py::arg("last") = py::none(), py::kw_only(),
           py::arg("style") = "cubic", py::arg("tolerance") = 1e-4,
           says("Returns one value over time, as keys; colours as linear light."));
}

}  // namespace betwixt::python
