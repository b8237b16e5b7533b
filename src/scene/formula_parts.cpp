// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/formula_parts.h"

#include <algorithm>

#include "scene/functions.h"
#include "scene/outline.h"

namespace betwixt {

FunctionId part_function() {
  static const FunctionId f = *find_built_in(Kind::text, "part");
  return f;
}

const std::string* shown_part(const Object& o) {
  if (o.kind != Kind::text) return nullptr;
  const Slot* const slot = o.find(part_function());
  const auto* const key = slot && slot->set ? std::get_if<Text>(&*slot->set) : nullptr;
  return key && !(*key)->empty() ? &**key : nullptr;
}

ObjectId formula_of_part(const Scene& s, const Object& o) {
  const Slot* const slot = o.find(fn::attachment);
  const auto* const to = slot && slot->set ? std::get_if<Attachment>(&*slot->set) : nullptr;
  const Object* const whole = to ? find_object(s, to->parent) : nullptr;
  return whole && has_letters(whole->kind) && !shown_part(*whole) ? to->parent : ObjectId{};
}

std::vector<ObjectId> parts_by_content(const Scene& s, std::string_view name) {
  std::vector<ObjectId> out;
  const auto slash = name.rfind('/');
  if (slash == name.npos) return out;
  const ObjectId whole = s.names.find(name.substr(0, slash));
  const Object* const o = whole ? find_object(s, whole) : nullptr;
  if (!o || o->kind != Kind::text || !o->leads) return out;
  const std::string_view content = name.substr(slash + 1);
  for (int n = 1;; ++n) {
    const ObjectId id = s.names.find(o->name + "/" + std::to_string(n));
    if (!id) return out;
    const std::string* const key = shown_part(s.objects[id.index]);
    if (!key) continue;
    std::string_view is = std::string_view(*key).substr(0, key->find('#'));
    if (is.starts_with('\\')) is.remove_prefix(1);
    if (is == content) out.push_back(id);
  }
}

const std::string* formula_above(const Scene& s, const std::string& name) {
  const Object& o = s.objects[s.names.find(name).index];
  const ObjectId whole = shown_part(o) ? formula_of_part(s, o) : ObjectId{};
  if (!whole) return nullptr;
  const std::string& above = s.objects[whole.index].name;
  const bool below = name.rfind('/') == above.size() && name.starts_with(above);
  const bool numbered = name.find_first_not_of("0123456789", name.rfind('/') + 1) == name.npos;
  return below && numbered ? &above : nullptr;
}

ObjectId find_named(const Scene& s, std::string_view name) {
  if (const ObjectId id = s.names.find(name)) return id;
  const auto parts = parts_by_content(s, name);
  return parts.empty() ? ObjectId{} : parts[0];
}

std::vector<std::string> parts_of_formula(const Outline& formula) {
  std::vector<std::string> out;
  for (const Letter& l : formula.letters)
    if (!l.part.empty() && std::find(out.begin(), out.end(), l.part) == out.end()) out.push_back(l.part);
  return out;
}

}  // namespace betwixt
