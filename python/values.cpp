// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "values.h"

#include <algorithm>
#include <string>

#include "betwixt/object.h"
#include "betwixt/program.h"
#include "betwixt/track.h"

namespace betwixt::python {
namespace {

// Returns a value as a script writes it.
std::string words(const Attachment& a, const Document& document) {
  static constexpr const char* how[] = {"detach", "letgo", "hang on ", "attach to ", "couple to "};
  std::string said = how[static_cast<std::size_t>(a.kind)];
  if (a.kind >= AttachmentKind::hang) said += document.name(a.parent) + (a.keep_world ? " keep-world" : "");
  return said;
}

// Returns whether the values of a target have two components. They are stored as vectors of three.
bool is_pair(const Target& target, const Document& document) {
  if (target.query() || target.component >= 0) return false;
  for (const FunctionView& f : functions(document, target.object))
    if (f.id == target.function) return f.type == Type::pair;
  return false;
}

std::vector<double> numbers_of(const Value& v, bool pair) {
  std::vector<double> n = numbers(v);
  if (pair && n.size() == 3) n.pop_back();
  return n;
}

py::object one(const Value& v, bool pair, const Document& document) {
  if (const auto* n = std::get_if<double>(&v)) return py::float_(*n);
  if (const auto* b = std::get_if<bool>(&v)) return py::bool_(*b);
  if (const auto* id = std::get_if<ObjectId>(&v)) return *id ? py::object(name_of(*id, document)) : py::none();
  if (const auto* t = std::get_if<Text>(&v)) return py::str(**t);
  if (const auto* a = std::get_if<Attachment>(&v)) return py::str(words(*a, document));
  if (const auto* m = std::get_if<Moves>(&v)) return py::str(to_string(**m));
  if (const auto* m = std::get_if<Matrix>(&v)) return array_of(**m);
  if (const auto* p = std::get_if<Procedure>(&v)) return py::str(std::string(procedure(*p).source));
  if (const auto* names = std::get_if<Names>(&v)) {
    py::list all;
    for (const std::string& name : **names) all.append(name);
    return all;
  }
  if (const auto* points = std::get_if<Points>(&v)) {
    py::array_t<double> all({static_cast<py::ssize_t>((*points)->size()), py::ssize_t{3}});
    double* to = all.mutable_data();
    for (const Vec3 p : **points) *to++ = p.x, *to++ = p.y, *to++ = p.z;
    return all;
  }
  const std::vector<double> n = numbers_of(v, pair);
  return py::array_t<double>(static_cast<py::ssize_t>(n.size()), n.data());
}

}  // namespace

py::str name_of(ObjectId id, const Document& document) { return py::str(id ? document.name(id) : std::string()); }

py::array_t<double> array_of(Vec3 v) { return py::array_t<double>(3, &v.x); }

py::array_t<double> array_of(const Mat4& m) {
  py::array_t<double> made({4, 4});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) made.mutable_at(row, column) = m(row, column);
  return made;
}

py::object to_python(const Value& v, const Target& target, const Document& document) {
  return one(v, is_pair(target, document), document);
}

py::object to_python(const std::vector<Value>& all, const Target& target, const Document& document) {
  const bool pair = is_pair(target, document);
  const auto alike = [&](const Value& v) { return v.index() == all.front().index(); };
  const bool plain = !all.empty() && std::ranges::all_of(all, alike);
  if (plain && std::holds_alternative<bool>(all.front())) {
    py::array_t<bool> made(static_cast<py::ssize_t>(all.size()));
    std::ranges::transform(all, made.mutable_data(), [](const Value& v) { return std::get<bool>(v); });
    return made;
  }
  const std::size_t width = plain ? numbers_of(all.front(), pair).size() : 0;
  if (width == 0) {
    py::list made;
    for (const Value& v : all) made.append(one(v, pair, document));
    return made;
  }
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(all.size())};
  if (width == 16) shape.insert(shape.end(), {4, 4});
  if (width > 1 && width < 16) shape.push_back(static_cast<py::ssize_t>(width));
  py::array_t<double> made(shape);
  double* to = made.mutable_data();
  for (const Value& v : all) to = std::ranges::copy(numbers_of(v, pair), to).out;
  return made;
}

}  // namespace betwixt::python
