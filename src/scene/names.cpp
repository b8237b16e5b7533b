// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/names.h"

#include <fmt/format.h>

namespace betwixt {

namespace {
constexpr std::string_view asked_names[] = {"world", "by", "every", "count", "touching", "in-view"};
}
std::optional<FunctionId> find_asked(Kind kind, std::string_view name) {
  for (FunctionId i = 0; i < std::size(asked_names); ++i)
    if (asked_names[i] == name && (i == 0 || (i < 4 ? kind == Kind::environment : drawn(kind))))
      return static_cast<FunctionId>(0xffff - i);
  return std::nullopt;
}

std::string object_name(const Scene& s, ObjectId id) {
  const Object* o = find_object(s, id);
  return o ? o->name : "none";
}

std::string target_name(const Scene& s, const Target& t) {
  std::string name = object_name(s, t.object) + ".";
  if (only_asked(t.function)) {
    name += asked_names[0xffff - t.function];
    return t.component < 0 ? name : name.append(".").append(component_name(Type::vector, t.component));
  }
  const FunctionSpec& spec = spec_of(s, t.function);
  name += spec.name;
  if (t.component >= 0) name.append(".").append(component_name(spec.type, t.component));
  return t.velocity ? name + ".velocity" : name;
}

std::string format_time(Time t, Rate rate) {
  const double n = rate.frame_number(t);
  if (n == std::round(n) && rate.frame(n) == t) return fmt::format("{}f", n == 0 ? 0.0 : n);
  return fmt::format("{}s", t.flicks == 0 ? 0.0 : t.seconds());
}

std::string Document::name(ObjectId id) const { return object_name(*scene_, id); }
std::string Document::name(const Target& t) const { return target_name(*scene_, t); }

}  // namespace betwixt
