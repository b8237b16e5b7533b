// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "frames.h"

#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "betwixt/geometry.h"
#include "betwixt/object.h"
#include "betwixt/pose.h"
#include "errors.h"
#include "pictures.h"
#include "says.h"
#include "times.h"
#include "values.h"

namespace betwixt::python {
namespace {

// A frame, with the document that has the names of its objects.
struct Made {
  Frame frame;
  Document document;
  ObjectId camera;
};

// A part of a frame. It keeps the whole frame alive.
template <class Part>
struct Of {
  std::shared_ptr<const Made> made;
  const Part* part;
  const Part* operator->() const { return part; }
};
using ItemOf = Of<Item>;
using LightOf = Of<Light>;
using CameraOf = Of<Camera>;

template <class Part>
std::vector<Of<Part>> parts_of(const std::shared_ptr<const Made>& made, const std::vector<Part>& all) {
  std::vector<Of<Part>> out;
  for (const Part& p : all) out.push_back({made, &p});
  return out;
}

std::shared_ptr<const Made> make(const Film& film, py::handle when) {
  const Program program = unlocked([&] { return film.program(); });
  const Time t = time_of(when, program.document());
  auto made = unlocked([&] {
    return std::make_shared<const Made>(Made{program.frame(t), program.document(), camera(program, t)});
  });
  for (const std::string& p : made->frame.problems) warn(p);
  return made;
}

py::object array_or_none(const std::optional<Vec3>& v) { return v ? py::object(array_of(*v)) : py::none(); }

py::object picture_or_none(const std::shared_ptr<const Picture>& p) {
  return p ? py::cast(Pixels{p}) : py::object(py::none());
}

std::string_view word_of(Material m) {
  static constexpr std::string_view words[] = {"plastic", "matte", "metal", "glow"};
  return words[static_cast<std::size_t>(m)];
}

bool equal(const std::shared_ptr<const Shape>& a, const std::shared_ptr<const Shape>& b) {
  return a == b || (a && b && *a == *b);
}
bool has_shape_of(const ItemOf& a, const ItemOf& b) {
  return equal(a->shape, b->shape) && equal(a->toward, b->toward) && (!a->toward || a->blend == b->blend);
}

// Triangles in object space.
struct Triangles {
  std::shared_ptr<const Mesh> mesh;
};

Triangles triangles_of(const Item& item, int around) {
  const Geometry g = geometry_of(item, around);
  if (g.local == Mat4{}) return {g.mesh};
  auto mesh = std::make_shared<Mesh>(*g.mesh);
  const auto back = inverse(g.local);
  for (auto& p : mesh->positions) {
    const Vec3 v = transform_point(g.local, {p[0], p[1], p[2]});
    p = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }
  for (auto& n : mesh->normals) {
    if (!back) break;
    const Vec3 old{n[0], n[1], n[2]};
    const Vec3 v = normalize(Vec3{dot(column(*back, 0), old), dot(column(*back, 1), old), dot(column(*back, 2), old)});
    n = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }
  return {std::move(mesh)};
}

template <std::size_t width>
py::array_t<float> rows(const Triangles& t, const std::vector<std::array<float, width>>& all) {
  return view(all.empty() ? nullptr : all.front().data(),
              {static_cast<py::ssize_t>(all.size()), static_cast<py::ssize_t>(width)},
              {static_cast<py::ssize_t>(width * sizeof(float)), sizeof(float)}, keep(t.mesh));
}

py::array_t<std::uint32_t> groups(const Triangles& t, const std::vector<std::uint32_t>& all, py::ssize_t of) {
  return view(all.data(), {static_cast<py::ssize_t>(all.size()) / of, of},
              {of * static_cast<py::ssize_t>(sizeof(std::uint32_t)), sizeof(std::uint32_t)}, keep(t.mesh));
}

template <class Part>
py::array_t<double> world_of(const Of<Part>& o) {
  return view(o->world.m.data(), {4, 4}, {sizeof(double), 4 * sizeof(double)}, keep(o.made));
}

void bind_meshes(py::module_& m) {
  py::class_<MeshPart>(m, "MeshPart", "A range of triangles with the same look.")
      .def_property_readonly(
          "first", [](const MeshPart& p) { return p.first / 3; }, "The index of its first triangle.")
      .def_property_readonly(
          "count", [](const MeshPart& p) { return p.count / 3; }, "How many triangles it has.")
      .def_property_readonly(
          "color", [](const MeshPart& p) { return py::array_t<float>(3, p.color.data()); }, "Its colour, linear light.")
      .def_property_readonly(
          "texture", [](const MeshPart& p) { return picture_or_none(p.texture); }, "Its picture, or None.")
      .def_readonly("tinted", &MeshPart::tinted, "Whether the object's own colour multiplies it.");
  py::class_<Triangles>(m, "Mesh", "Triangles in the space of their object.")
      .def_property_readonly(
          "positions", [](const Triangles& t) { return rows(t, t.mesh->positions); }, "The corners: x, y, z.")
      .def_property_readonly(
          "normals", [](const Triangles& t) { return rows(t, t.mesh->normals); }, "The normal of each corner.")
      .def_property_readonly(
          "uvs", [](const Triangles& t) { return rows(t, t.mesh->uvs); },
          "The texture coordinates of each corner; (0 0) is the top left. Empty without a picture.")
      .def_property_readonly(
          "triangles", [](const Triangles& t) { return groups(t, t.mesh->triangles, 3); },
          "The triangles, three corners each.")
      .def_property_readonly(
          "edges", [](const Triangles& t) { return groups(t, t.mesh->edges, 2); },
          "The edges for drawing lines, two corners each.")
      .def_property_readonly(
          "parts", [](const Triangles& t) { return t.mesh->parts; },
          "Ranges of triangles with the same look; empty if the mesh has one look.")
      .def_property_readonly(
          "closed", [](const Triangles& t) { return t.mesh->closed; }, "Whether it encloses a space.")
      .def(
          "__repr__",
          [](const Triangles& t) { return "<Mesh of " + std::to_string(t.mesh->triangles.size() / 3) + " triangles>"; },
          says("How many triangles it has."));
}

void bind_items(py::module_& m) {
  py::class_<ItemOf>(m, "Item", "The visible part of an object.")
      .def_property_readonly(
          "name", [](const ItemOf& i) { return name_of(i->id, i.made->document); }, "The name of its object.")
      .def_property_readonly(
          "body", [](const ItemOf& i) { return name_of(i->body, i.made->document); },
          "The name of the object with which it forms one body.")
      .def_property_readonly(
          "kind", [](const ItemOf& i) { return betwixt::name_of(i->shape->kind); }, "Its kind: \"sphere\".")
      .def_property_readonly("world", world_of<Item>, "The world matrix: [row, column].")
      .def_property_readonly(
          "color", [](const ItemOf& i) { return array_of(i->color); }, "Its colour, linear light.")
      .def_property_readonly(
          "transparency", [](const ItemOf& i) { return i->transparency; }, "0: it is solid; 1: it is not seen.")
      .def_property_readonly(
          "shininess", [](const ItemOf& i) { return i->shininess; }, "How sharp its highlights are.")
      .def_property_readonly(
          "material", [](const ItemOf& i) { return word_of(i->material); },
          "\"plastic\", \"matte\", \"metal\" or \"glow\".")
      .def_property_readonly(
          "casts", [](const ItemOf& i) { return i->casts; }, "Whether it casts shadows.")
      .def_property_readonly(
          "texture", [](const ItemOf& i) { return picture_or_none(i->texture); }, "Its picture, or None.")
      .def("has_shape_of", has_shape_of, py::arg("other"),
           says("Returns whether the other item has the same triangles."))
      .def(
          "mesh",
          [](const ItemOf& i, int around) {
            if (around < 6 || around > 1024) raise(fail(ErrorCode::range, "6 to 1024 faces go around a mesh"));
            return unlocked([&] { return triangles_of(*i.part, around); });
          },
          py::arg("around") = 48,
          says("Returns its triangles, in its own space. `around` is the number of faces around the widest circle."))
      .def(
          "__repr__", [](const ItemOf& i) { return "<Item " + i.made->document.name(i->id) + ">"; }, says("Its name."));
}

}  // namespace

void bind_frames(py::module_& m, py::class_<Film>& film) {
  bind_meshes(m);
  bind_items(m);
  py::class_<LightOf>(m, "Light", "A lamp, or a sun.")
      .def_property_readonly(
          "name", [](const LightOf& l) { return name_of(l->id, l.made->document); }, "Its name.")
      .def_property_readonly(
          "sun", [](const LightOf& l) { return l->sun; }, "True for a sun, False for a lamp.")
      .def_property_readonly(
          "position", [](const LightOf& l) { return array_of(l->position); }, "Where it is.")
      .def_property_readonly(
          "direction", [](const LightOf& l) { return array_of(l->direction); }, "The direction of its light.")
      .def_property_readonly(
          "color", [](const LightOf& l) { return array_of(l->color); }, "Linear light, intensity included.")
      .def_property_readonly(
          "range", [](const LightOf& l) { return l->range; }, "The distance at which the light ends, in metres.");
  py::class_<CameraOf>(m, "Camera", "The active camera.")
      .def_property_readonly(
          "name", [](const CameraOf& c) { return name_of(c.made->camera, c.made->document); },
          "Its name; empty if the film has no camera.")
      .def_property_readonly("world", world_of<Camera>, "The world matrix: [row, column].")
      .def_property_readonly(
          "orthographic", [](const CameraOf& c) { return c->orthographic; }, "Whether the projection is orthographic.")
      .def_property_readonly(
          "fov", [](const CameraOf& c) { return c->fov; }, "The horizontal angle of view, in radians.")
      .def_property_readonly(
          "height", [](const CameraOf& c) { return c->height; }, "If orthographic: the height of the view, in metres.")
      .def_property_readonly(
          "aspect", [](const CameraOf& c) { return c->aspect; }, "Width of the picture by height.")
      .def_property_readonly(
          "shutter", [](const CameraOf& c) { return c->shutter; }, "How long the shutter is open, in seconds.")
      .def_property_readonly(
          "aperture", [](const CameraOf& c) { return c->aperture; }, "The diameter of the lens opening, in metres.")
      .def_property_readonly(
          "focus", [](const CameraOf& c) { return c->focus; }, "The focus distance, in metres.")
      .def_property_readonly(
          "shift", [](const CameraOf& c) { return py::make_tuple(c->shift_x, c->shift_y); },
          "The lens shift, in units of half the picture.");
  py::class_<Made, std::shared_ptr<Made>>(m, "Frame", "Everything visible at one time.")
      .def_property_readonly(
          "time", [](const Made& f) { return frame_of(f.frame.time, f.document); }, "The time, as a frame number.")
      .def_property_readonly(
          "seconds", [](const Made& f) { return f.frame.time.seconds(); }, "The same in seconds since the beginning.")
      .def_property_readonly(
          "items",
          [](const std::shared_ptr<Made>& f) { return parts_of(std::shared_ptr<const Made>(f), f->frame.items); },
          "The visible things.")
      .def_property_readonly(
          "lights",
          [](const std::shared_ptr<Made>& f) { return parts_of(std::shared_ptr<const Made>(f), f->frame.lights); },
          "Lamps and suns.")
      .def_property_readonly(
          "camera",
          [](const std::shared_ptr<Made>& f) {
            return CameraOf{f, &f->frame.camera};
          },
          "The active camera.")
      .def_property_readonly(
          "background", [](const Made& f) { return array_or_none(f.frame.background); },
          "The colour behind everything, linear light; None without one.")
      .def_property_readonly(
          "ambient", [](const Made& f) { return array_or_none(f.frame.surroundings.ambient); },
          "The ambient light; None without one.")
      .def_property_readonly(
          "ground", [](const Made& f) { return array_or_none(f.frame.surroundings.ground); },
          "The colour of the endless ground; None without one.")
      .def_property_readonly(
          "exposure", [](const Made& f) { return f.frame.surroundings.exposure; },
          "The exposure in stops: light is multiplied by 2 to this power.")
      .def_property_readonly(
          "sky", [](const Made& f) { return f.frame.surroundings.sky; }, "Whether there is a sky.")
      .def_property_readonly(
          "flat", [](const Made& f) { return f.frame.surroundings.flat; },
          "Whether the film is flat, so that colours are exact.")
      .def_property_readonly(
          "clear", [](const Made& f) { return f.frame.surroundings.clear; }, "Whether the background is transparent.")
      .def_property_readonly(
          "notes", [](const Made& f) { return f.frame.notes; }, "The notes at this time.")
      .def_property_readonly(
          "problems", [](const Made& f) { return f.frame.problems; }, "The errors of Lua code in the script.")
      .def(
          "__repr__", [](const Made& f) { return "<Frame of " + std::to_string(f.frame.items.size()) + " things>"; },
          says("Returns the number of items."));
  film.def(
      "frame", [](const Film& f, py::handle when) { return std::const_pointer_cast<Made>(make(f, when)); },
      py::arg("time"), says("Returns everything visible at a time."));
}

}  // namespace betwixt::python
