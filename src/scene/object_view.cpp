// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "betwixt/object.h"
#include "scene/document.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

const Object& object_or_nothing(const Document& d, ObjectId id) {
  static const Object nothing;
  const Object* o = find_object(d.scene(), id);
  return o ? *o : nothing;
}

bool any_events(const Strand& s) {
  return !s.track->events.empty() ||
         std::any_of(s.components.begin(), s.components.end(), [](const auto& c) { return !c->events.empty(); });
}

bool code(const Value& v) { return std::holds_alternative<Procedure>(v); }
bool varies(const Slot& slot) {
  return slot.layer || any_events(slot) || any_events(slot.velocity) || !slot.filters.empty() ||
         (slot.set && code(*slot.set));
}

}  // namespace

std::string_view name_of(Kind kind) { return row_of(kind).name; }

std::vector<ObjectId> objects(const Document& d) {
  std::vector<ObjectId> out;
  for (std::uint32_t i = 0; i < d.scene().objects.size(); ++i)
    if (!d.scene().objects[i].removed) out.push_back({i});
  return out;
}

std::vector<ObjectId> objects(const Document& d, std::string_view word) { return select(d.scene(), word); }
Kind kind(const Document& d, ObjectId id) { return object_or_nothing(d, id).kind; }
bool derived(const Document& d, ObjectId id) { return object_or_nothing(d, id).derived; }

std::vector<FunctionView> functions(const Document& d, ObjectId id) {
  std::vector<FunctionView> out;
  const Object* o = find_object(d.scene(), id);
  if (!o) return out;
  const auto count = built_in_functions().size() + d.scene().defined->size();
  for (FunctionId f = 0; f < count; ++f) {
    const FunctionSpec& spec = spec_of(d.scene(), f);
    if (!(spec.kinds & (1u << static_cast<unsigned>(o->kind)))) continue;
    FunctionView view{f,        spec.name, spec.type,  spec.unit, {},   spec.words,
                      spec.low, spec.high, &spec.rest, nullptr,   false};
    for (int i = 0; i < component_count(spec.type); ++i) view.components.push_back(component_name(spec.type, i));
    if (const Slot* slot = o->find(f); slot && slot->set) view.set = &*slot->set;
    view.animated = (!view.set && code(spec.rest)) ||
                    std::any_of(o->slots.begin(), o->slots.end(),
                                [&](const Slot& slot) { return slot.function == f && varies(slot); });
    out.push_back(std::move(view));
  }
  return out;
}

std::vector<AttachmentSpan> attachments(const Document& d, ObjectId id) {
  return attachments(object_or_nothing(d, id));
}

std::vector<LayerView> layers(const Document& d) {
  std::vector<LayerView> out;
  for (const ObjectId id : objects(d)) {
    const Object& o = d.scene().objects[id.index];
    if (o.kind != Kind::layer) continue;
    const Slot* mode = o.find(fn::mode);
    const Value& v = mode && mode->set ? *mode->set : spec_of(d.scene(), fn::mode).rest;
    out.push_back({id, *std::get<Text>(v), Target(id, fn::weight)});
  }
  return out;
}

Rate Document::ticks() const { return scene_->ticks; }
const Aliases& Document::aliases() const { return *scene_->aliases; }
const std::map<Time, ObjectId>& Document::cuts() const { return *scene_->cuts; }

}  // namespace betwixt
