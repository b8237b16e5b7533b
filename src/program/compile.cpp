// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "program/code.h"

namespace betwixt {
namespace {

struct Compiler {
  Program::Compiled& code;
  const Scene& scene;

  // Room for a constant of a type in the array of numbers; colours become light.
  Binding place(FunctionId f, const Value& v, Type type) {
    Binding b;
    b.function = f;
    b.constant = v;
    if (!numeric(v)) return b;
    double n[4];
    const int count = to_numbers(v, n);
    if (std::holds_alternative<Color>(v))
      for (int i = 0; i < 3; ++i) n[i] = to_linear(n[i]);
    b.channels = static_cast<std::uint8_t>(type == Type::pair ? 2 : count);
    b.orientation = std::holds_alternative<Quat>(v);
    b.offset = static_cast<std::uint32_t>(code.rest.size());
    code.rest.insert(code.rest.end(), n, n + 4);  // always four: a rotation's curve may want them
    return b;
  }

  static bool has_values(const Track& t) {
    bool any = false;
    t.events.each([&](const Event& e) { any = any || !e.keep; });
    return any;
  }
  static bool all_numeric(const Track& t) {
    bool all = true;
    t.events.each([&](const Event& e) {
      all = all && (e.keep || numeric(e.value)) && (!e.detail || !e.detail->before || numeric(*e.detail->before));
    });
    return all;
  }

  Binding bind(const Slot& slot) {
    const FunctionSpec& spec = spec_of(scene, slot.function);
    Binding b = place(slot.function, slot.set.value_or(spec.rest), spec.type);
    b.first_curve = static_cast<std::uint32_t>(code.curves.size());
    const auto add = [&](const Track& track, Type type, std::uint32_t offset, bool component = false) {
      code.curves.push_back(
          {code.set.add(track, type, component), offset, spec.low > -1e300 || spec.high < 1e300, spec.low, spec.high});
      ++b.curves;
    };
    const auto point = [&] {
      b = place(slot.function, Vec3{}, spec.type);
      b.first_curve = static_cast<std::uint32_t>(code.curves.size());
    };
    for (std::size_t i = 0; i < slot.components.size(); ++i) {
      const Track& t = *slot.components[i];
      if (b.channels == 0 && has_values(t)) point();  // an aim at an object gives way to numbers
      // Components of colours blend as colours do, in light.
      const Type type = spec.type == Type::color ? Type::color : component_type(spec.type);
      if (has_values(t)) add(t, type, b.offset + static_cast<std::uint32_t>(i), true);
    }
    if (!has_values(*slot.track)) return b;
    if (!all_numeric(*slot.track) || (b.channels == 0 && spec.type != Type::aim)) {
      b.steps = static_cast<std::int32_t>(code.steps.size());
      b.channels = 0;
      code.steps.emplace_back(*slot.track, spec.type);
      return b;
    }
    if (b.channels == 0) point();
    // Events that are all points of the world are a vector's; the same twerpers suit them.
    add(*slot.track, spec.type == Type::aim ? Type::vector : spec.type, b.offset);
    b.channels = code.curves.back().curve.channels;
    b.orientation = code.curves.back().curve.orientation;
    return b;
  }

  void bindings() {
    for (FunctionId f = 0; f < static_cast<FunctionId>(built_in_functions().size() + scene.defined->size()); ++f) {
      const FunctionSpec& spec = spec_of(scene, f);
      code.defaults.push_back(place(f, spec.rest, spec.type));
    }
    code.first_binding.reserve(scene.objects.size() + 1);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      code.first_binding.push_back(static_cast<std::uint32_t>(code.bindings.size()));
      for (const Slot& slot : scene.objects[i].slots) code.bindings.push_back(bind(slot));
    }
    code.first_binding.push_back(static_cast<std::uint32_t>(code.bindings.size()));
  }

  bool shape_varies(std::uint32_t object) const {
    for (auto i = code.first_binding[object]; i < code.first_binding[object + 1]; ++i) {
      const Binding& b = code.bindings[i];
      const bool of_shape = b.function >= fn::radius && b.function <= fn::file;
      if (of_shape && b.varies()) return true;
    }
    return false;
  }

  void node(std::uint32_t object, std::int32_t parent) {
    const Object& o = scene.objects[object];
    Node n;
    n.object = object;
    n.parent = parent;
    n.kind = o.kind;
    const auto offset = [&](FunctionId f) { return code.find(object, f).offset; };
    n.position = offset(fn::position), n.rotation = offset(fn::rotation), n.scale = offset(fn::scale);
    n.pivot = offset(fn::pivot), n.attach = offset(fn::attach_position), n.display = offset(fn::display),
    n.color = offset(fn::color);
    n.orientation = code.find(object, fn::rotation).orientation;
    if (drawn(o.kind) && !shape_varies(object))
      n.shape = std::make_shared<const Shape>(code.shape(object, {}, code.rest.data()));
    code.node_of[object] = static_cast<std::uint32_t>(code.nodes.size());
    code.nodes.push_back(std::move(n));
  }

  // Parents before children; a chain of a hundred thousand is walked, not recursed.
  void nodes() {
    code.node_of.assign(scene.objects.size(), ObjectId::nothing);
    std::vector<std::uint32_t> chain;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
      if (scene.objects[i].removed) continue;
      for (ObjectId at{i}; at && code.node_of[at.index] == ObjectId::nothing; at = scene.objects[at.index].parent)
        chain.push_back(at.index);
      for (; !chain.empty(); chain.pop_back()) {
        const ObjectId parent = scene.objects[chain.back()].parent;
        node(chain.back(), parent ? static_cast<std::int32_t>(code.node_of[parent.index]) : -1);
      }
    }
  }
};

}  // namespace

const Binding& Program::Compiled::find(std::uint32_t object, FunctionId f) const {
  const auto first = bindings.begin() + first_binding[object], last = bindings.begin() + first_binding[object + 1];
  const auto at = std::lower_bound(first, last, f, [](const Binding& b, FunctionId id) { return b.function < id; });
  return at != last && at->function == f ? *at : defaults[f];
}

Program Program::compile(const Document& document) {
  auto code = std::make_shared<Compiled>(document);
  Compiler compiler{*code, document.scene()};
  compiler.bindings();
  compiler.nodes();
  Program p;
  p.code_ = std::move(code);
  return p;
}

const Document& Program::document() const { return code_->document; }

}  // namespace betwixt
